/* Draws a scene off-screen with Mesa, from the world: OpenGL's own matrices, light, clipping, culling, textures and depth.
 *
 * stdin:  width height background(RRGGBB as a number) cull depthTest
 *         ortho heightOrFov near far
 *         at (3, as seen from the eye) up (3)
 *         turn (degrees about +y) middle (3, as seen from the eye)
 *         lit light (3, unit length, towards it)
 *         count of textures, for each "width height hasAlpha wrap" (wrap 0 repeat, 1 clamp to edge,
 *         2 mirrored repeat) and its texels 0xAARRGGBB as numbers, rows from the bottom
 *         count of triangles in the order of drawing, for each "id texture(-1 none) replace blend alphaTest(-1 none)" and
 *         three vertices "x y z nx ny nz s t r g b a", positions as seen from the eye
 * stdout: five drawings of width * height pixels RGBA, 8 bits each, rows from the bottom: the picture; of the opaque
 *         triangles the number that shows (red its highest byte), and the texel (red s, green t, blue 255 where there is
 *         one); the same two of all triangles, of which the last drawn shows */
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum drawing { PICTURE, OPAQUE_IDS, OPAQUE_TEXELS, TOP_IDS, TOP_TEXELS, DRAWINGS };

struct triangle {
  unsigned id;
  int texture, replace, blend;
  double alpha_test, vertices[3][12];
};

struct image {
  int has_alpha;
  GLuint colours, numbers;
};

static double number(void) {
  double value;
  if (scanf("%lf", &value) != 1) exit(1);
  return value;
}

static void numbers(double *into, int count) {
  for (int i = 0; i < count; i++) into[i] = number();
}

static GLuint texture(int width, int height, GLint format, const unsigned char *texels, GLint wrap) {
  GLuint name;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  return name;
}

static struct image image(void) {
  static const GLint wraps[3] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT};
  int width = number(), height = number(), has_alpha = number();
  GLint wrap = wraps[(int)number()];
  unsigned char *colours = malloc(4 * (size_t)width * height), *coordinates = malloc(4 * (size_t)width * height);
  if (!colours || !coordinates) exit(2);
  for (int i = 0; i < width * height; i++) {
    unsigned argb = number(), alpha = has_alpha ? argb >> 24 : 255;
    unsigned char colour[4] = {argb >> 16, argb >> 8, argb, alpha};
    unsigned char place[4] = {i % width, i / width, 255, alpha};
    for (int k = 0; k < 4; k++) {
      colours[4 * i + k] = colour[k];
      coordinates[4 * i + k] = place[k];
    }
  }
  struct image made = {has_alpha, texture(width, height, has_alpha ? GL_RGBA8 : GL_RGB8, colours, wrap),
                       texture(width, height, GL_RGBA8, coordinates, wrap)};
  free(colours);
  free(coordinates);
  return made;
}

/* The fragment's colour from `source`, its alpha as in the picture: the vertex's, the texel's, or their product. */
static void numbered(GLint source, const struct triangle *t, const struct image *images) {
  int has_alpha = t->texture >= 0 && images[t->texture].has_alpha;
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB, source);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB, GL_SRC_COLOR);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, has_alpha && !t->replace ? GL_MODULATE : GL_REPLACE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA, has_alpha ? GL_TEXTURE : GL_PRIMARY_COLOR);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_ALPHA);
  glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE1_ALPHA, GL_PRIMARY_COLOR);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_ALPHA, GL_SRC_ALPHA);
}

static void enabled(GLenum what, int on) { on ? glEnable(what) : glDisable(what); }

static void draw(const struct triangle *t, const struct image *images, enum drawing kind, int lit) {
  int ids = kind == OPAQUE_IDS || kind == TOP_IDS;
  enabled(GL_LIGHTING, lit && kind == PICTURE);
  enabled(GL_BLEND, t->blend && kind == PICTURE);
  glDepthMask(!t->blend);
  enabled(GL_ALPHA_TEST, t->alpha_test >= 0);
  if (t->alpha_test >= 0) glAlphaFunc(GL_GEQUAL, t->alpha_test);
  enabled(GL_TEXTURE_2D, t->texture >= 0);
  if (t->texture >= 0) {
    glBindTexture(GL_TEXTURE_2D, kind == PICTURE ? images[t->texture].colours : images[t->texture].numbers);
    if (kind == PICTURE) glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, t->replace ? GL_REPLACE : GL_MODULATE);
    else numbered(ids ? GL_PRIMARY_COLOR : GL_TEXTURE, t, images);
  }
  glBegin(GL_TRIANGLES);
  for (int corner = 0; corner < 3; corner++) {
    const double *v = t->vertices[corner];
    if (kind == PICTURE) glColor4dv(v + 8);
    else if (ids) glColor4d((t->id >> 16) / 255.0, (t->id >> 8 & 255) / 255.0, (t->id & 255) / 255.0, v[11]);
    else glColor4d(0, 0, 0, v[11]);
    glNormal3dv(v + 3);
    glTexCoord2dv(v + 6);
    glVertex3dv(v);
  }
  glEnd();
}

/* gluPerspective of the OpenGL Utility Library 1.3, 4.2, or glOrtho. */
static void project(int ortho, double extent, double near, double far, double aspect) {
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  double top = ortho ? extent / 2 : near * tan(extent * acos(-1) / 360);
  if (ortho) glOrtho(-top * aspect, top * aspect, -top, top, near, far);
  else glFrustum(-top * aspect, top * aspect, -top, top, near, far);
}

static void cross(const double *a, const double *b, double *into) {
  for (int k = 0; k < 3; k++) into[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

static void unit(double *v) {
  double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (int k = 0; k < 3; k++) v[k] /= length;
}

/* gluLookAt of the same, 4.1, the eye at the origin. */
static void look(double *at, const double *up) {
  double side[3], above[3];
  unit(at);
  cross(at, up, side);
  unit(side);
  cross(side, at, above);
  double columns[16] = {side[0], above[0], -at[0], 0, side[1], above[1], -at[1], 0, side[2], above[2], -at[2], 0, 0, 0, 0, 1};
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixd(columns);
}

/* A light of 0.8 from far away and 0.2 from everywhere, on materials of the vertices' colours. */
static void shine(const double *towards) {
  const GLfloat place[4] = {towards[0], towards[1], towards[2], 0};
  const GLfloat black[4] = {0, 0, 0, 1}, diffuse[4] = {0.8f, 0.8f, 0.8f, 1}, ambient[4] = {0.2f, 0.2f, 0.2f, 1};
  glEnable(GL_LIGHT0);
  glLightfv(GL_LIGHT0, GL_POSITION, place);
  glLightfv(GL_LIGHT0, GL_AMBIENT, black);
  glLightfv(GL_LIGHT0, GL_DIFFUSE, diffuse);
  glLightfv(GL_LIGHT0, GL_SPECULAR, black);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
  glEnable(GL_COLOR_MATERIAL);
}

int main(void) {
  int width = number(), height = number();
  unsigned background = number();
  int cull = number(), depth = number(), ortho = number();
  double volume[3], at[3], up[3], turn, middle[3], light[3];
  numbers(volume, 3);
  numbers(at, 3);
  numbers(up, 3);
  turn = number();
  numbers(middle, 3);
  int lit = number();
  numbers(light, 3);

  unsigned char *pixels = calloc((size_t)width * height, 4);
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
  if (!pixels || !context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, width, height)) return 2;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  int image_count = number();
  struct image *images = malloc(sizeof *images * (image_count + 1));
  for (int i = 0; i < image_count; i++) images[i] = image();
  int count = number();
  struct triangle *triangles = malloc(sizeof *triangles * (count + 1));
  if (!images || !triangles) return 2;
  for (int i = 0; i < count; i++) {
    struct triangle *t = triangles + i;
    t->id = number();
    t->texture = number();
    t->replace = number();
    t->blend = number();
    t->alpha_test = number();
    for (int corner = 0; corner < 3; corner++) numbers(t->vertices[corner], 12);
  }

  glViewport(0, 0, width, height);
  glDisable(GL_DITHER);
  enabled(GL_CULL_FACE, cull);
  glFrontFace(GL_CCW);
  glCullFace(GL_BACK);
  enabled(GL_DEPTH_TEST, depth);
  glDepthFunc(GL_LESS);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  project(ortho, volume[0], volume[1], volume[2], (double)width / height);
  look(at, up);
  if (lit) shine(light);
  glTranslated(middle[0], middle[1], middle[2]);
  glRotated(turn, 0, 1, 0);
  glTranslated(-middle[0], -middle[1], -middle[2]);

  for (int kind = 0; kind < DRAWINGS; kind++) {
    if (kind == PICTURE) glClearColor((background >> 16) / 255.0, (background >> 8 & 255) / 255.0, (background & 255) / 255.0, 1);
    else glClearColor(0, 0, 0, 1);
    glDepthMask(1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    int opaque_only = kind == OPAQUE_IDS || kind == OPAQUE_TEXELS;
    for (int i = 0; i < count; i++)
      if (!(opaque_only && triangles[i].blend)) draw(triangles + i, images, kind, lit);
    glFinish();
    if (fwrite(pixels, 4, (size_t)width * height, stdout) != (size_t)width * height) return 3;
  }
  fprintf(stderr, "%s\n", (const char *)glGetString(GL_RENDERER));
  return 0;
}
