/* Evaluators (5.1): curves and surfaces of all kinds of values, meshes in all modes, normals of surfaces, queries. */
#include "texture.h"

static const GLfloat patch[4][4][3] = {
    {{0.05f, 0.05f, 0}, {0.3f, 0, 0.3f}, {0.7f, 0.1f, 0.1f}, {0.95f, 0.05f, 0}},
    {{0.1f, 0.3f, 0.2f}, {0.35f, 0.3f, 0.9f}, {0.6f, 0.4f, 0.7f}, {0.9f, 0.3f, 0}},
    {{0, 0.7f, 0.1f}, {0.3f, 0.6f, 0.6f}, {0.7f, 0.7f, 0.8f}, {1, 0.6f, 0.2f}},
    {{0.05f, 0.95f, 0}, {0.4f, 1, 0.4f}, {0.6f, 0.9f, 0}, {0.95f, 0.95f, 0.3f}},
};
static const GLfloat colors[2][2][4] = {{{1, 0.2f, 0, 1}, {0, 1, 0.3f, 1}}, {{0.2f, 0, 1, 1}, {1, 1, 0.5f, 0.5f}}};
static const GLfloat coordinates[2][2][2] = {{{0, 0}, {2, 0}}, {{0, 2}, {2, 2}}};
static unsigned char texels[8 * 8][4];

static void look(int cell)
{
    glViewport(cell % 4 * 64, cell / 4 * 64, 64, 64);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, 1, 0, 1, -2, 2);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

static void draw(void)
{
    GLdouble values[64];
    GLint integers[4];
    int cell = 0;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    /* Curves. */
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4, patch[0][0]);
    glEnable(GL_MAP1_VERTEX_3);
    look(cell++);
    glMapGrid1f(20, 0, 1);
    glEvalMesh1(GL_LINE, 0, 20);
    glMap1f(GL_MAP1_COLOR_4, 0, 1, 4, 4, colors[0][0]);
    glEnable(GL_MAP1_COLOR_4);
    glTranslatef(0, 0.3f, 0);
    glEvalMesh1(GL_LINE, 2, 17);
    glPointSize(3);
    glTranslatef(0, 0.3f, 0);
    glEvalMesh1(GL_POINT, 0, 20);
    glTranslatef(0, 0.2f, 0);
    glBegin(GL_LINE_STRIP);
    glEvalCoord1f(0);
    glColor3f(1, 1, 1);
    glEvalCoord1d(0.3);
    glEvalPoint1(10);
    glVertex3f(0.7f, 0.1f, 0);
    glEvalCoord1f(1);
    glEnd();
    GLfloat current[4];
    glGetFloatv(GL_CURRENT_COLOR, current);
    say("current colour %g %g %g %g", current[0], current[1], current[2], current[3]);
    glDisable(GL_MAP1_COLOR_4);
    /* Surfaces. */
    glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 4, 0, 1, 12, 4, patch[0][0]);
    glEnable(GL_MAP2_VERTEX_3);
    glMapGrid2f(12, 0, 1, 9, 0, 1);
    static const GLenum modes[] = {GL_POINT, GL_LINE, GL_FILL};
    for (int mode = 0; mode < 3; mode++) {
        look(cell++);
        glColor3f(0.3f, 0.8f, 0.4f);
        glEvalMesh2(modes[mode], 0, 12, 0, 9);
    }
    glMap2f(GL_MAP2_COLOR_4, 0, 1, 4, 2, 0, 1, 8, 2, colors[0][0]);
    glEnable(GL_MAP2_COLOR_4);
    /* So fine that it doesn't matter which way quadrilaterals are parted. */
    glMapGrid2f(48, 0, 1, 48, 0, 1);
    look(cell++);
    glEvalMesh2(GL_FILL, 0, 48, 0, 48);
    glDisable(GL_MAP2_COLOR_4);
    /* Normals of the surface, and others. Mesa takes no notice of a domain that runs backwards. */
    const GLfloat place[] = {0.3f, 0.4f, 1, 0};
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glLightfv(GL_LIGHT0, GL_POSITION, place);
    glEnable(GL_AUTO_NORMAL);
    look(cell++);
    glEvalMesh2(GL_FILL, 0, 48, 0, 48);
    glMap2f(GL_MAP2_VERTEX_3, -1, 1, 3, 4, 3, 7, 12, 4, patch[0][0]);
    glMapGrid2d(48, -1, 1, 48, 3, 7);
    look(cell++);
    glEvalMesh2(GL_FILL, 0, 48, 0, 48);
    look(cell++);
    glEvalMesh2(GL_FILL, 10, 35, 6, 32);
    glDisable(GL_AUTO_NORMAL);
    static const GLfloat normals[2][2][3] = {{{0.5f, 0, 1}, {-0.5f, 0, 1}}, {{0, 0.6f, 1}, {0, -0.6f, 0.8f}}};
    glMap2f(GL_MAP2_VERTEX_3, 1, -1, 3, 4, 3, 7, 12, 4, patch[0][0]);
    glMapGrid2d(48, 1, -1, 48, 3, 7);
    glMap2f(GL_MAP2_NORMAL, 1, -1, 3, 2, 3, 7, 6, 2, normals[0][0]);
    glEnable(GL_MAP2_NORMAL);
    glEnable(GL_NORMALIZE);
    look(cell++);
    glEvalMesh2(GL_FILL, 0, 48, 0, 48);
    glDisable(GL_LIGHTING);
    /* Coordinates of textures. */
    paint(texels, 8, 8, 0);
    filter(GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glEnable(GL_TEXTURE_2D);
    glMap2f(GL_MAP2_TEXTURE_COORD_2, 1, -1, 2, 2, 3, 7, 4, 2, coordinates[0][0]);
    glEnable(GL_MAP2_TEXTURE_COORD_2);
    glColor3f(1, 1, 1);
    look(cell++);
    glEvalMesh2(GL_FILL, 0, 48, 0, 48);
    glDisable(GL_TEXTURE_2D);
    /* In a list; strips of single values. */
    glNewList(1, GL_COMPILE);
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= 10; i++) {
        glEvalPoint2(i, 2);
        glEvalPoint2(i, 5);
    }
    glEnd();
    glEndList();
    look(cell++);
    glColor3f(0.9f, 0.6f, 0.1f);
    glCallList(1);
    /* Rational curves. */
    static const GLdouble arc[3][4] = {{0.1, 0.1, 0, 1}, {0.9 * 0.70710678, 0.1 * 0.70710678, 0, 0.70710678}, {0.9, 0.9, 0, 1}};
    glMap1d(GL_MAP1_VERTEX_4, 0, 1, 4, 3, arc[0]);
    glEnable(GL_MAP1_VERTEX_4);
    glLineWidth(2);
    look(cell++);
    glEvalMesh1(GL_LINE, 0, 20);
    /* Queries and errors. */
    glGetMapdv(GL_MAP2_VERTEX_3, GL_DOMAIN, values);
    say("domain %g %g %g %g", values[0], values[1], values[2], values[3]);
    glGetMapiv(GL_MAP2_VERTEX_3, GL_ORDER, integers);
    say("order %d %d", integers[0], integers[1]);
    glGetMapdv(GL_MAP2_VERTEX_3, GL_COEFF, values);
    say("points %g %g %g ... %g", values[0], values[1], values[5], values[47]);
    glGetMapdv(GL_MAP1_NORMAL, GL_COEFF, values);
    say("normal %g %g %g", values[0], values[1], values[2]);
    glGetMapiv(GL_MAP1_COLOR_4, GL_ORDER, integers);
    say("order %d", integers[0]);
    glGetIntegerv(GL_MAP2_GRID_SEGMENTS, integers);
    say("segments %d %d", integers[0], integers[1]);
    glGetDoublev(GL_MAP2_GRID_DOMAIN, values);
    say("domain %g %g %g %g", values[0], values[1], values[2], values[3]);
    glMap1f(GL_MAP1_VERTEX_3, 0, 0, 3, 4, patch[0][0]);
    say_error("no domain");
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 2, 4, patch[0][0]);
    say_error("stride");
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 0, patch[0][0]);
    say_error("order 0");
    glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 31, patch[0][0]);
    say_error("order 31");
    glMap1f(GL_MAP2_VERTEX_3, 0, 1, 3, 4, patch[0][0]);
    say_error("a map of two dimensions");
    glMapGrid1f(0, 0, 1);
    say_error("no steps");
    glEvalMesh1(GL_FILL, 0, 3);
    say_error("mode");
    glGetMapdv(GL_RGBA, GL_COEFF, values);
    say_error("no map");
    glGetMapdv(GL_MAP1_INDEX, GL_RGBA, values);
    say_error("no query");
}
