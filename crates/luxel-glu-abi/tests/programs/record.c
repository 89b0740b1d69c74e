/* What a GLU library draws, as sorted lines of primitives: the functions of OpenGL that it calls are defined here.
 *
 *     cc -rdynamic record.c -o record -ldl -lm && ./record LIBRARY quadrics|matrices|images|strings | sort
 *
 * Two libraries draw the same if their lines are equal. Points, segments, triangles and quads count, whatever strips and
 * fans they come in; texture coordinates belong to the vertices, and normals to the vertices of filled smooth shapes and
 * to the last vertex of filled flat ones. Of points and lines GLU leaves normals open. */
#define GL_GLEXT_PROTOTYPES
#include <GL/glu.h>
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct vertex {
    double v[8];
};
static struct vertex current, run[100000];
static int count;
static GLenum mode;

/* Three decimals, without the sign of zeros; what lies between two is not decided by the last bit. */
static double rounded(double x)
{
    return floor(x * 1e3 + 0.51) / 1e3 + 0.0;
}

static enum { EACH, LAST, NO } normals_of;

static void write_primitive(const char *name, int n, const int *at)
{
    char text[4][256];
    int kept = 0, first = 0, last = 0;
    for (int i = 0; i < n; i++)
        last = at[i] > last ? at[i] : last;
    for (int i = 0; i < n; i++) {
        const double *v = run[at[i]].v;
        /* A corner that stands where the one before does is none. */
        if (n > 1) {
            const double *w = run[at[(i + n - 1) % n]].v;
            if (fabs(v[0] - w[0]) + fabs(v[1] - w[1]) + fabs(v[2] - w[2]) < 1e-6)
                continue;
        }
        const double *turned = run[normals_of == EACH ? at[i] : last].v;
        sprintf(text[kept++], "[%.3f %.3f %.3f | %.3f %.3f %.3f | %.3f %.3f]", rounded(v[0]), rounded(v[1]), rounded(v[2]),
            normals_of == NO ? 0 : rounded(turned[3]), normals_of == NO ? 0 : rounded(turned[4]),
            normals_of == NO ? 0 : rounded(turned[5]), rounded(v[6]), rounded(v[7]));
    }
    if (kept < (n > 2 ? 3 : n))
        return;
    /* Turned so that the least corner is the first; segments have no direction. */
    for (int i = 1; i < kept; i++)
        if (strcmp(text[i], text[first]) < 0)
            first = i;
    printf("%s", kept == 3 && n == 4 ? "triangle" : name);
    for (int i = 0; i < kept; i++)
        printf(" %s", text[(first + i) % kept]);
    printf("\n");
}

void glBegin(GLenum with)
{
    mode = with;
    count = 0;
}

void glEnd(void)
{
    for (int i = 0; i < count; i++) {
        int two[2] = {i, i + 1}, three[3] = {i, i + 1, i + 2}, four[4] = {i, i + 1, i + 2, i + 3};
        switch (mode) {
        case GL_POINTS: write_primitive("point", 1, two); break;
        case GL_LINES:
            if (i % 2 == 0 && i + 1 < count)
                write_primitive("segment", 2, two);
            break;
        case GL_LINE_LOOP:
            two[1] = (i + 1) % count;
            write_primitive("segment", 2, two);
            break;
        case GL_LINE_STRIP:
            if (i + 1 < count)
                write_primitive("segment", 2, two);
            break;
        case GL_TRIANGLES:
            if (i % 3 == 0 && i + 2 < count)
                write_primitive("triangle", 3, three);
            break;
        case GL_TRIANGLE_FAN:
            three[0] = 0;
            three[1] = i + 1;
            three[2] = i + 2;
            if (i + 2 < count)
                write_primitive("triangle", 3, three);
            break;
        case GL_TRIANGLE_STRIP:
            if (i % 2) {
                three[0] = i + 1;
                three[1] = i;
            }
            if (i + 2 < count)
                write_primitive("triangle", 3, three);
            break;
        case GL_QUADS:
            if (i % 4 == 0 && i + 3 < count)
                write_primitive("quad", 4, four);
            break;
        case GL_QUAD_STRIP:
            four[2] = i + 3;
            four[3] = i + 2;
            if (i % 2 == 0 && i + 3 < count)
                write_primitive("quad", 4, four);
            break;
        }
    }
}

static void put(double x, double y, double z)
{
    current.v[0] = x;
    current.v[1] = y;
    current.v[2] = z;
    if (count < (int)(sizeof run / sizeof *run))
        run[count++] = current;
}

void glVertex3f(float x, float y, float z) { put(x, y, z); }
void glVertex3d(double x, double y, double z) { put(x, y, z); }
void glVertex3dv(const double *v) { put(v[0], v[1], v[2]); }
void glVertex3fv(const float *v) { put(v[0], v[1], v[2]); }
void glVertex2f(float x, float y) { put(x, y, 0); }
void glVertex2d(double x, double y) { put(x, y, 0); }

/* SGI's cylinders that are seen from inside keep the z of their normals: its sign is left out. */
static int is_cylinder;

static void turn(double x, double y, double z)
{
    current.v[3] = x;
    current.v[4] = y;
    current.v[5] = is_cylinder ? fabs(z) : z;
}
void glNormal3f(float x, float y, float z) { turn(x, y, z); }
void glNormal3d(double x, double y, double z) { turn(x, y, z); }
void glNormal3fv(const float *v) { turn(v[0], v[1], v[2]); }

static void skin(double s, double t)
{
    current.v[6] = s;
    current.v[7] = t;
}
void glTexCoord2f(float s, float t) { skin(s, t); }
void glTexCoord2d(double s, double t) { skin(s, t); }

/* The product of all matrices since it was last printed. */
static double product[16];

static void multiply(const double *m)
{
    double made[16];
    for (int c = 0; c < 4; c++)
        for (int r = 0; r < 4; r++) {
            made[4 * c + r] = 0;
            for (int k = 0; k < 4; k++)
                made[4 * c + r] += product[4 * k + r] * m[4 * c + k];
        }
    memcpy(product, made, sizeof product);
}

static void identity(void)
{
    for (int i = 0; i < 16; i++)
        product[i] = i % 5 == 0;
}

void glMultMatrixd(const double *m) { multiply(m); }
void glMultMatrixf(const float *m)
{
    double made[16];
    for (int i = 0; i < 16; i++)
        made[i] = m[i];
    multiply(made);
}
void glTranslated(double x, double y, double z)
{
    multiply((const double[16]){1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1});
}
void glTranslatef(float x, float y, float z) { glTranslated(x, y, z); }
void glScalef(float x, float y, float z) { multiply((const double[16]){x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1}); }
void glOrtho(double l, double r, double b, double t, double n, double f)
{
    multiply((const double[16]){2 / (r - l), 0, 0, 0, 0, 2 / (t - b), 0, 0, 0, 0, -2 / (f - n), 0, -(r + l) / (r - l),
        -(t + b) / (t - b), -(f + n) / (f - n), 1});
}

static int pack_alignment = 4, unpack_alignment = 4, swap_bytes, unpack_row_length, unpack_skip_rows, unpack_skip_pixels;
static GLint largest = 64;

void glGetIntegerv(GLenum name, GLint *value)
{
    *value = name == GL_PACK_ALIGNMENT ? pack_alignment
        : name == GL_UNPACK_ALIGNMENT  ? unpack_alignment
        : name == GL_UNPACK_SWAP_BYTES ? swap_bytes
        : name == GL_UNPACK_ROW_LENGTH ? unpack_row_length
        : name == GL_UNPACK_SKIP_ROWS  ? unpack_skip_rows
        : name == GL_UNPACK_SKIP_PIXELS ? unpack_skip_pixels
        : name == GL_MAX_TEXTURE_SIZE  ? largest
                                       : 0;
}
void glGetBooleanv(GLenum name, GLboolean *value)
{
    GLint found;
    glGetIntegerv(name, &found);
    *value = found != 0;
}
void glGetFloatv(GLenum name, GLfloat *value)
{
    (void)name;
    *value = 0;
}
const GLubyte *glGetString(GLenum name) { return (const GLubyte *)(name == GL_VERSION ? "1.5 record" : ""); }
void glPixelStorei(GLenum name, GLint value)
{
    *(name == GL_PACK_ALIGNMENT        ? &pack_alignment
        : name == GL_UNPACK_ALIGNMENT  ? &unpack_alignment
        : name == GL_UNPACK_SWAP_BYTES ? &swap_bytes
        : name == GL_UNPACK_ROW_LENGTH ? &unpack_row_length
        : name == GL_UNPACK_SKIP_ROWS  ? &unpack_skip_rows
        : name == GL_UNPACK_SKIP_PIXELS ? &unpack_skip_pixels
                                       : &(int){0}) = value;
}
static int proxy_width;
void glGetTexLevelParameteriv(GLenum target, GLint level, GLenum name, GLint *value)
{
    (void)target, (void)level, (void)name;
    *value = proxy_width;
}
/* Textures of bytes only: SGI's library makes short ones of those of one dimension. */
static void texture(GLenum target, int level, int inside, int w, int h, int d, GLenum format, GLenum type, const void *data)
{
    proxy_width = w <= largest ? w : 0;
    if (!data)
        return;
    int n = format == GL_RGBA ? 4 : format == GL_RGB ? 3 : 1;
    int row = (w * n + unpack_alignment - 1) / unpack_alignment * unpack_alignment;
    printf("texture %#x level %d of %#x: %dx%dx%d %#x:", target, level, inside, w, h, d, format);
    for (int y = 0; y < h * d && target == GL_TEXTURE_2D; y++)
        for (int x = 0; x < w * n; x++) {
            int value = ((const unsigned char *)data)[y * row + x];
            if (type == GL_UNSIGNED_BYTE)
                printf(" %d", value);
        }
    printf("\n");
}
void glTexImage1D(GLenum target, GLint level, GLint inside, GLsizei w, GLint border, GLenum format, GLenum type, const void *data)
{
    (void)border;
    texture(target, level, inside, w, 1, 1, format, type, data);
}
void glTexImage2D(
    GLenum target, GLint level, GLint inside, GLsizei w, GLsizei h, GLint border, GLenum format, GLenum type, const void *data)
{
    (void)border;
    texture(target, level, inside, w, h, 1, format, type, data);
}
void glTexImage3D(GLenum target, GLint level, GLint inside, GLsizei w, GLsizei h, GLsizei d, GLint border, GLenum format,
    GLenum type, const void *data)
{
    (void)border;
    texture(target, level, inside, w, h, d, format, type, data);
}

static void *library;

/* FUNCTION(gluSphere) is the library's function of that name. */
#define FUNCTION(name) ((__typeof__(&name))find(#name))
static void *find(const char *name)
{
    void *found = dlsym(library, name);
    if (!found) {
        printf("%s is missing\n", name);
        exit(1);
    }
    return found;
}

static void shapes(const char *what, GLUquadric *q)
{
    printf("%s sphere\n", what);
    FUNCTION(gluSphere)(q, 2, 5, 4);
    printf("%s flattest sphere\n", what);
    FUNCTION(gluSphere)(q, 1.5, 3, 2);
    is_cylinder = 1;
    printf("%s cylinder\n", what);
    FUNCTION(gluCylinder)(q, 1, 1, 3, 5, 2);
    printf("%s frustum\n", what);
    FUNCTION(gluCylinder)(q, 2, 1, 3, 4, 3);
    printf("%s cone\n", what);
    FUNCTION(gluCylinder)(q, 2, 0, 3, 4, 3);
    printf("%s cone upside down\n", what);
    FUNCTION(gluCylinder)(q, 0, 2, 3, 4, 1);
    is_cylinder = 0;
    printf("%s disk\n", what);
    FUNCTION(gluDisk)(q, 0, 2, 6, 3);
    printf("%s ring\n", what);
    FUNCTION(gluDisk)(q, 1, 2, 6, 2);
    printf("%s part of a disk\n", what);
    FUNCTION(gluPartialDisk)(q, 0, 2, 4, 2, 30, 100);
    printf("%s part of a ring\n", what);
    FUNCTION(gluPartialDisk)(q, 1, 2, 4, 3, 300, -200);
    printf("%s whole\n", what);
    FUNCTION(gluPartialDisk)(q, 1, 2, 4, 1, 0, 400);
}

static void GLAPIENTRY failed(GLenum error) { printf("error %u\n", error); }

static void quadrics(void)
{
    static const GLenum normals[] = {GLU_NONE, GLU_FLAT, GLU_SMOOTH}, styles[] = {GLU_POINT, GLU_LINE, GLU_SILHOUETTE, GLU_FILL};
    GLUquadric *q = FUNCTION(gluNewQuadric)();
    FUNCTION(gluQuadricCallback)(q, GLU_ERROR, (_GLUfuncptr)failed);
    printf("as it begins\n");
    shapes("default", q);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            for (int inside = 0; inside < 2; inside++)
                for (int textured = 0; textured < 2; textured++) {
                    char what[64];
                    sprintf(what, "normals %d style %d inside %d textured %d:", i, j, inside, textured);
                    FUNCTION(gluQuadricNormals)(q, normals[i]);
                    FUNCTION(gluQuadricDrawStyle)(q, styles[j]);
                    FUNCTION(gluQuadricOrientation)(q, inside ? GLU_INSIDE : GLU_OUTSIDE);
                    FUNCTION(gluQuadricTexture)(q, textured);
                    memset(&current, 0, sizeof current);
                    normals_of = j != 3 ? NO : i == 1 ? LAST : EACH;
                    shapes(what, q);
                }
    normals_of = EACH;
    printf("bad values\n");
    FUNCTION(gluSphere)(q, -1, 5, 4);
    FUNCTION(gluSphere)(q, 1, 1, 4);
    FUNCTION(gluSphere)(q, 1, 5, 0);
    FUNCTION(gluCylinder)(q, -1, 1, 1, 5, 4);
    FUNCTION(gluCylinder)(q, 1, 1, -1, 5, 4);
    FUNCTION(gluCylinder)(q, 1, 1, 1, 1, 4);
    FUNCTION(gluDisk)(q, -1, 1, 5, 4);
    FUNCTION(gluDisk)(q, 2, 1, 5, 4);
    FUNCTION(gluDisk)(q, 1, 0, 5, 4);
    FUNCTION(gluPartialDisk)(q, 1, 2, 1, 1, 0, 90);
    FUNCTION(gluQuadricNormals)(q, 5);
    FUNCTION(gluQuadricDrawStyle)(q, 5);
    FUNCTION(gluQuadricOrientation)(q, 5);
    FUNCTION(gluQuadricCallback)(q, 5, NULL);
    FUNCTION(gluDeleteQuadric)(q);
}

static void say_matrix(const char *what)
{
    printf("%s:", what);
    for (int i = 0; i < 16; i++)
        printf(" %.3f", rounded(product[i]));
    printf("\n");
    identity();
}

static void matrices(void)
{
    identity();
    FUNCTION(gluPerspective)(45, 1.5, 0.1, 100);
    say_matrix("perspective");
    FUNCTION(gluPerspective)(0, 1.5, 0.1, 100);
    say_matrix("no angle");
    FUNCTION(gluPerspective)(45, 0, 0.1, 100);
    say_matrix("no width");
    FUNCTION(gluPerspective)(45, 1, 5, 5);
    say_matrix("no depth");
    FUNCTION(gluOrtho2D)(-1, 3, -2, 5);
    say_matrix("ortho");
    FUNCTION(gluLookAt)(1, 2, 3, -4, 5, 6, 0, 1, 0);
    say_matrix("look at");
    FUNCTION(gluLookAt)(0, 0, 5, 0, 0, 0, 1, 1, 1);
    say_matrix("look at");
    GLint viewport[4] = {10, 20, 640, 480};
    FUNCTION(gluPickMatrix)(100, 200, 5, 7, viewport);
    say_matrix("pick");
    FUNCTION(gluPickMatrix)(100, 200, 0, 7, viewport);
    say_matrix("no pick");
    GLdouble model[16] = {0.8, 0.6, 0, 0, -0.6, 0.8, 0, 0, 0, 0, 1, 0, 1, 2, -10, 1}, flat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0};
    GLdouble projection[16] = {1.8, 0, 0, 0, 0, 2.4, 0, 0, 0, 0, -1.02, -1, 0, 0, -0.202, 0}, x, y, z, w;
    for (int i = 0; i < 20; i++) {
        int good = FUNCTION(gluProject)(i % 3 - 1, i % 5 - 2, i % 7 - 3, model, projection, viewport, &x, &y, &z);
        printf("project %d: %d %.6f %.6f %.6f\n", i, good, x, y, z);
        good = FUNCTION(gluUnProject)(33 * i, 21 * i, 0.05 * i, model, projection, viewport, &x, &y, &z);
        printf("unproject %d: %d %.4f %.4f %.4f\n", i, good, x, y, z);
        good = FUNCTION(gluUnProject4)(33 * i, 21 * i, 0.05 * i, 1 + i, model, projection, viewport, -1, 2, &x, &y, &z, &w);
        printf("unproject4 %d: %d %.4f %.4f %.4f %.4f\n", i, good, x, y, z, w);
    }
    printf("no inverse: %d\n", FUNCTION(gluUnProject)(1, 2, 0.5, model, flat, viewport, &x, &y, &z));
    printf("in the eye: %d\n", FUNCTION(gluProject)(0, 0, 10, model, projection, viewport, &x, &y, &z));
}

static void strings(void)
{
    static const int errors[] = {0, 0x500, 0x501, 0x502, 0x503, 0x504, 0x505, 0x506, 100900, 100901, 100902, 100903, 100904};
    for (unsigned i = 0; i < sizeof errors / sizeof *errors; i++)
        printf("error %d: %s\n", errors[i], FUNCTION(gluErrorString)(errors[i]));
    for (int i = 100150; i < 100160; i++)
        printf("error %d: %d\n", i, FUNCTION(gluErrorString)(i) != NULL);
    for (int i = 100249; i < 100290; i++)
        printf("error %d: %d\n", i, FUNCTION(gluErrorString)(i) != NULL);
    printf("version %s; %d\n", FUNCTION(gluGetString)(GLU_VERSION), FUNCTION(gluGetString)(5) == NULL);
    static const char *const pairs[][2] = {
        {"GL_a", "GL_a"}, {"GL_a", "GL_ab GL_b"}, {"GL_b", "GL_a GL_b"}, {"GL_b", "GL_a GL_b GL_c"}, {"GL", "GL_a"}, {"x", ""}};
    for (int i = 0; i < 6; i++)
        printf("extension %d: %d\n", i,
            FUNCTION(gluCheckExtension)((const GLubyte *)pairs[i][0], (const GLubyte *)pairs[i][1]));
}

static void images(void)
{
    static unsigned char in[64 * 64 * 4], out[64 * 64 * 4];
    for (unsigned i = 0; i < sizeof in; i++)
        in[i] = i * 7 + i / 64 * 3;
    static const int sizes[][4] = {{4, 4, 2, 2}, {8, 8, 3, 5}, {3, 3, 6, 6}, {5, 7, 2, 3}, {16, 4, 4, 16}, {7, 1, 3, 1}, {4, 4, 4, 4}};
    static const GLenum formats[] = {GL_RGBA, GL_RGB, GL_LUMINANCE};
    for (int f = 0; f < 3; f++)
        for (unsigned s = 0; s < sizeof sizes / sizeof *sizes; s++) {
            memset(out, 0, sizeof out);
            int good = FUNCTION(gluScaleImage)(
                formats[f], sizes[s][0], sizes[s][1], GL_UNSIGNED_BYTE, in, sizes[s][2], sizes[s][3], GL_UNSIGNED_BYTE, out);
            printf("scale %d %u: %d", f, s, good);
            /* Beyond the edge of what it magnifies, SGI's library goes on at the other one. */
            int n = f == 0 ? 4 : f == 1 ? 3 : 1, w = sizes[s][2], h = sizes[s][3], row = (w * n + 3) / 4 * 4;
            int left = w > sizes[s][0] ? (w / sizes[s][0] + 1) / 2 : 0, top = h > sizes[s][1] ? (h / sizes[s][1] + 1) / 2 : 0;
            for (int y = top; y < h - top; y++)
                for (int x = left * n; x < (w - left) * n; x++)
                    printf(" %d", out[y * row + x]);
            printf("\n");
        }
    float values[16];
    FUNCTION(gluScaleImage)(GL_RGBA, 4, 4, GL_UNSIGNED_BYTE, in, 2, 2, GL_FLOAT, values);
    for (int i = 0; i < 16; i++)
        printf("float %d: %.3f\n", i, values[i]);
    unsigned short shorts[16];
    FUNCTION(gluScaleImage)(GL_RGB, 4, 4, GL_UNSIGNED_BYTE, in, 4, 4, GL_UNSIGNED_SHORT_5_6_5, shorts);
    for (int i = 0; i < 16; i++)
        printf("5_6_5 %d: %d %d %d\n", i, shorts[i] >> 11, shorts[i] >> 5 & 63, shorts[i] & 31);
    printf("%d\n", FUNCTION(gluScaleImage)(GL_RGBA, -1, 4, GL_UNSIGNED_BYTE, in, 2, 2, GL_FLOAT, values));
    printf("%d\n", FUNCTION(gluScaleImage)(0x1234, 4, 4, GL_UNSIGNED_BYTE, in, 2, 2, GL_FLOAT, values));
    printf("%d\n", FUNCTION(gluScaleImage)(GL_RGBA, 4, 4, 0x1234, in, 2, 2, GL_FLOAT, values));
    printf("%d\n", FUNCTION(gluScaleImage)(GL_RGBA, 4, 4, GL_UNSIGNED_SHORT_5_6_5, in, 2, 2, GL_FLOAT, values));
    FUNCTION(gluBuild2DMipmaps)(GL_TEXTURE_2D, GL_RGBA, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, in);
    FUNCTION(gluBuild2DMipmaps)(GL_TEXTURE_2D, 3, 16, 4, GL_RGB, GL_UNSIGNED_BYTE, in);
    FUNCTION(gluBuild2DMipmaps)(GL_TEXTURE_2D, GL_LUMINANCE, 5, 11, GL_LUMINANCE, GL_UNSIGNED_BYTE, in);
    FUNCTION(gluBuild1DMipmaps)(GL_TEXTURE_1D, GL_RGBA, 16, GL_RGBA, GL_UNSIGNED_BYTE, in);
    FUNCTION(gluBuild1DMipmaps)(GL_TEXTURE_1D, GL_RGBA, 11, GL_RGBA, GL_UNSIGNED_BYTE, in);
    printf("%d\n", FUNCTION(gluBuild2DMipmaps)(GL_TEXTURE_2D, GL_RGBA, 0, 8, GL_RGBA, GL_UNSIGNED_BYTE, in));
    printf("%d\n", FUNCTION(gluBuild2DMipmaps)(GL_TEXTURE_2D, GL_RGBA, 8, 8, 0x1234, GL_UNSIGNED_BYTE, in));
    printf("%d\n",
        FUNCTION(gluBuild2DMipmapLevels)(GL_TEXTURE_2D, GL_RGBA, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, 1, 2, 3, in));
    printf("%d\n",
        FUNCTION(gluBuild2DMipmapLevels)(GL_TEXTURE_2D, GL_RGBA, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, 2, 1, 3, in));
}

int main(int count_of, char **arguments)
{
    if (count_of != 3 || !(library = dlopen(arguments[1], RTLD_NOW))) {
        fprintf(stderr, "usage: record LIBRARY quadrics|matrices|images|strings\n%s\n", count_of == 3 ? dlerror() : "");
        return 1;
    }
    switch (arguments[2][0]) {
    case 'q': quadrics(); break;
    case 'm': matrices(); break;
    case 'i': images(); break;
    case 's': strings(); break;
    }
    return 0;
}
