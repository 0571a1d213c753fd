/* Draws triangles off-screen with Mesa, which referees between the reference renderer and the hardware's model.
 *
 * stdin:  width height textured depth count, then for each triangle a line "log2Width log2Height wrapS wrapT less equal
 *         greater write" and three vertices "x y z q s t id": pixels from the top left, depth 0..1, q = 1/w, texture
 *         coordinates in repeats; wrap 0 repeat, 1 clamp, 2 mirror
 * stdout: width * height pixels RGBA, 8 bits each, rows from the bottom: the number of the triangle that shows, red its
 *         highest byte, or with `textured` the texel: red s, green t, blue 255
 *
 * Without `depth` the last triangle shows. */
#include <GL/gl.h>
#include <GL/osmesa.h>
#include <stdio.h>
#include <stdlib.h>

static void texture(int log2_width, int log2_height, int wrap_s, int wrap_t) {
  static const GLint wraps[3] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
  static GLuint made[8][8];
  GLuint *name = &made[log2_width][log2_height];
  if (*name) {
    glBindTexture(GL_TEXTURE_2D, *name);
  } else {
    static unsigned char texels[128 * 128][4];
    int width = 1 << log2_width, height = 1 << log2_height;
    for (int i = 0; i < width * height; i++) {
      texels[i][0] = i % width;
      texels[i][1] = i / width;
      texels[i][2] = texels[i][3] = 255;
    }
    glGenTextures(1, name);
    glBindTexture(GL_TEXTURE_2D, *name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wraps[wrap_s]);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wraps[wrap_t]);
}

int main(void) {
  static const GLenum functions[8] = {GL_NEVER, GL_LESS, GL_EQUAL, GL_LEQUAL, GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
  int width, height, textured, depth, count;
  if (scanf("%d %d %d %d %d", &width, &height, &textured, &depth, &count) != 5) return 1;
  unsigned char *pixels = calloc((size_t)width * height, 4);
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
  if (!pixels || !context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, width, height)) return 2;
  glViewport(0, 0, width, height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DITHER);
  if (depth) glEnable(GL_DEPTH_TEST);
  if (textured) glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  for (int i = 0; i < count; i++) {
    int w, h, wrap_s, wrap_t, less, equal, greater, write;
    if (scanf("%d %d %d %d %d %d %d %d", &w, &h, &wrap_s, &wrap_t, &less, &equal, &greater, &write) != 8) return 1;
    glDepthFunc(functions[less + 2 * equal + 4 * greater]);
    glDepthMask(write);
    if (textured) texture(w, h, wrap_s, wrap_t);
    glBegin(GL_TRIANGLES);
    for (int corner = 0; corner < 3; corner++) {
      double x, y, z, q, s, t;
      unsigned id;
      if (scanf("%lf %lf %lf %lf %lf %lf %u", &x, &y, &z, &q, &s, &t, &id) != 7) return 1;
      glTexCoord2d(s, t);
      glColor4ub(id >> 16, id >> 8 & 255, id & 255, 255);
      glVertex4d((2 * x / width - 1) / q, (1 - 2 * y / height) / q, (2 * z - 1) / q, 1 / q);
    }
    glEnd();
  }
  glFinish();
  fprintf(stderr, "%s\n", (const char *)glGetString(GL_RENDERER));
  return fwrite(pixels, 4, (size_t)width * height, stdout) == (size_t)width * height ? 0 : 3;
}
