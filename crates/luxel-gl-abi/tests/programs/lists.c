/* Display lists (5.4): what is compiled and what isn't, nesting, names by all types, attributes and materials in lists. */
#include "program.h"

static void triangle(float x, float y)
{
    glBegin(GL_TRIANGLES);
    glVertex2f(x, y);
    glVertex2f(x + 0.18f, y);
    glVertex2f(x + 0.09f, y + 0.18f);
    glEnd();
}

static void say_state(const char *what)
{
    GLfloat color[4];
    GLint mode, width, list, list_mode;
    glGetFloatv(GL_CURRENT_COLOR, color);
    glGetIntegerv(GL_MATRIX_MODE, &mode);
    glGetIntegerv(GL_LINE_WIDTH, &width);
    glGetIntegerv(GL_LIST_INDEX, &list);
    glGetIntegerv(GL_LIST_MODE, &list_mode);
    say("%s: %.2f %.2f %.2f %.2f, %#x, %d, cull %d, list %d %#x", what, color[0], color[1], color[2], color[3], mode, width,
        glIsEnabled(GL_CULL_FACE), list, list_mode);
}

static void draw(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1, 1, 1);

    /* State is set when a list is called, not when it is compiled. */
    glNewList(5, GL_COMPILE);
    say_state("compiling");
    glColor3f(1, 0, 0);
    glEnable(GL_CULL_FACE);
    glLineWidth(4);
    say_state("still compiling");
    glEndList();
    say_state("compiled");
    glCallList(5);
    say_state("called");
    glDisable(GL_CULL_FACE);
    glNewList(6, GL_COMPILE_AND_EXECUTE);
    glColor3f(0, 1, 0);
    say_state("compiling and executing");
    glEndList();

    /* A list replaces one of its name at its end only. */
    glNewList(6, GL_COMPILE);
    glColor3f(0, 0, 1);
    glCallList(6);
    glEndList();
    say("lists: %d %d %d", glIsList(5), glIsList(6), glIsList(7));
    glCallList(6);
    say_state("calls itself");
    say_error("calls itself");

    /* What is never compiled. */
    glNewList(7, GL_COMPILE);
    GLuint made = glGenLists(3);
    glPixelStorei(GL_PACK_ALIGNMENT, 2);
    GLint value;
    glGetIntegerv(GL_PACK_ALIGNMENT, &value);
    say("while compiling: %d, alignment %d, %d", made > 0, value, glIsEnabled(GL_CULL_FACE));
    glDeleteLists(made, 3);
    glFlush();
    glRenderMode(GL_RENDER);
    glEndList();
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glCallList(7);
    glGetIntegerv(GL_PACK_ALIGNMENT, &value);
    say("after: alignment %d", value);

    /* Errors in lists come when they are called. */
    glNewList(8, GL_COMPILE);
    glCullFace(0x1234);
    glBegin(99);
    glEnd();
    say_error("compiled");
    glEndList();
    glCallList(8);
    say_error("called");
    glGetError();

    /* Letters of a font, by names of all types. */
    for (int i = 0; i < 10; i++) {
        glNewList(100 + i, GL_COMPILE);
        glColor3f(0.1f * i, 1 - 0.1f * i, i % 2);
        triangle(0, 0);
        glTranslatef(0.2f, 0, 0);
        glEndList();
    }
    static const struct {
        GLenum type;
        int size;
        unsigned char bytes[24];
    } names[] = {
        {GL_BYTE, 1, {0, 1, 2, 255}},
        {GL_UNSIGNED_BYTE, 1, {3, 4, 5, 6}},
        {GL_SHORT, 2, {1, 0, 2, 0, 3, 0, 4, 0}},
        {GL_UNSIGNED_SHORT, 2, {5, 0, 6, 0, 7, 0, 8, 0}},
        {GL_INT, 4, {0, 0, 0, 0, 2, 0, 0, 0, 4, 0, 0, 0, 6, 0, 0, 0}},
        {GL_UNSIGNED_INT, 4, {1, 0, 0, 0, 3, 0, 0, 0, 5, 0, 0, 0, 7, 0, 0, 0}},
        {GL_2_BYTES, 2, {0, 9, 0, 8, 0, 7, 0, 6}},
        {GL_3_BYTES, 3, {0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4}},
        {GL_4_BYTES, 4, {0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 0, 9, 0, 0, 0, 1}},
    };
    for (unsigned i = 0; i < sizeof names / sizeof *names; i++) {
        glPushMatrix();
        glTranslatef(-0.95f, -0.95f + 0.2f * i, 0);
        glListBase(names[i].type == GL_BYTE ? 101 : 100);
        glCallLists(4, names[i].type, names[i].bytes);
        glPopMatrix();
    }
    static const float floats[] = {1, 2.7f, 3, 9};
    glPushMatrix();
    glTranslatef(-0.95f, 0.8f, 0);
    glListBase(100);
    glCallLists(4, GL_FLOAT, floats);
    glPopMatrix();
    say_error("all types");

    /* Lists within lists, and parts of primitives. */
    glNewList(200, GL_COMPILE);
    /* Mesa gives a vertex in a list the colour of the time when it was compiled, unless there is one in the list. */
    glColor3f(0, 1, 1);
    glVertex2f(0.1f, 0.1f);
    glColor3f(1, 1, 0);
    glVertex2f(0.5f, 0.2f);
    glEndList();
    glNewList(201, GL_COMPILE);
    glBegin(GL_POLYGON);
    glCallList(200);
    glVertex2f(0.4f, 0.6f);
    glEnd();
    glEndList();
    glCallList(201);
    glLineWidth(1);
    glBegin(GL_LINES);
    glCallList(200);
    glEnd();
    say_state("after lists of vertices");

    /* Deep: the 64th call within a call is ignored. */
    for (int i = 300; i < 400; i++) {
        glNewList(i, GL_COMPILE);
        glTranslatef(0.01f, 0, 0);
        glCallList(i + 1);
        glEndList();
    }
    glLoadIdentity();
    glCallList(300);
    GLfloat matrix[16];
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
    say("deep: %.2f", matrix[12]);
    glLoadIdentity();

    /* Materials and lights in a list. */
    glNewList(500, GL_COMPILE);
    glPushAttrib(GL_LIGHTING_BIT);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glBegin(GL_QUADS);
    glNormal3f(0, 0, 1);
    for (int i = 0; i < 4; i++) {
        /* The same along both diagonals. */
        const float part = i < 2 ? 0.3f * i : 1.5f - 0.3f * i, color[] = {part, 0.9f - part, 0.5f, 1};
        glMaterialfv(GL_FRONT, GL_DIFFUSE, color);
        glVertex2f(0.2f + 0.6f * (i == 1 || i == 2), -0.8f + 0.6f * (i > 1));
    }
    glEnd();
    glPopAttrib();
    glEndList();
    glCallList(500);
    glDeleteLists(5, 300);
    say("deleted: %d %d %d", glIsList(5), glIsList(304), glIsList(305));
    glCallList(100);
    say_error("lists");
}
