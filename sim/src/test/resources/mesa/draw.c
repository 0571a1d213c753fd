/* Draws triangles off-screen with Mesa, for the cross-check of the reference renderer.
 *
 * stdin:  width height textured count, then 3 * count vertices "x y z q s t r g b a": pixels from the top left, depth
 *         0..1, q = 1/w, texture coordinates in repeats, colours 0..1
 * stdout: width * height pixels RGBA, 8 bits each, rows from the bottom
 *
 * The texture, 16 x 16, tells the texel by its colour: red 16 s, green 16 t. No depth test: the last triangle shows. */
#include <GL/gl.h>
#include <GL/osmesa.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void texture(void) {
  static unsigned char texels[16][16][4];
  for (int t = 0; t < 16; t++)
    for (int s = 0; s < 16; s++) {
      unsigned char color[4] = {16 * s, 16 * t, 255, 255};
      memcpy(texels[t][s], color, 4);
    }
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glEnable(GL_TEXTURE_2D);
}

int main(void) {
  int width, height, textured, count;
  if (scanf("%d %d %d %d", &width, &height, &textured, &count) != 4) return 1;
  unsigned char *pixels = calloc((size_t)width * height, 4);
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
  if (!pixels || !context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, width, height)) return 2;
  glViewport(0, 0, width, height);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_DITHER);
  if (textured) texture();
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 3 * count; i++) {
    double x, y, z, q, s, t, r, g, b, a;
    if (scanf("%lf %lf %lf %lf %lf %lf %lf %lf %lf %lf", &x, &y, &z, &q, &s, &t, &r, &g, &b, &a) != 10) return 1;
    glTexCoord2d(s, t);
    glColor4d(r, g, b, a);
    glVertex4d((2 * x / width - 1) / q, (1 - 2 * y / height) / q, (2 * z - 1) / q, 1 / q);
  }
  glEnd();
  glFinish();
  fprintf(stderr, "%s\n", (const char *)glGetString(GL_RENDERER));
  return fwrite(pixels, 4, (size_t)width * height, stdout) == (size_t)width * height ? 0 : 3;
}
