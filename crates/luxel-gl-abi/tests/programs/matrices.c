/* Matrices and their stacks (2.11), by their values. */
#include "program.h"

/* Without the sign of zeros. */
static double rounded(double value)
{
    return floor(value * 1e3 + 0.5) / 1e3 + 0.0;
}

static void say_matrix(const char *what, GLenum name)
{
    GLdouble m[16];
    glGetDoublev(name, m);
    say("%s:", what);
    for (int row = 0; row < 4; row++)
        say("  %.3f %.3f %.3f %.3f", rounded(m[row]), rounded(m[4 + row]), rounded(m[8 + row]), rounded(m[12 + row]));
}

static void draw(void)
{
    static const GLdouble m[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
    static const GLfloat g[16] = {0.5f, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1, 0, 3, 4, 5, 1};
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(m);
    say_matrix("load", GL_MODELVIEW_MATRIX);
    glMultMatrixf(g);
    say_matrix("times", GL_MODELVIEW_MATRIX);
    glLoadTransposeMatrixd(m);
    glMultTransposeMatrixf(g);
    say_matrix("transposed", GL_MODELVIEW_MATRIX);
    say_matrix("transposed query", GL_TRANSPOSE_MODELVIEW_MATRIX);
    glLoadIdentity();
    glTranslated(1, 2, 3);
    glRotated(90, 0, 0, 1);
    glScaled(2, 3, 4);
    say_matrix("translate, rotate, scale", GL_MODELVIEW_MATRIX);
    static const float axes[][4] = {{30, 1, 0, 0}, {45, 0, 1, 0}, {-60, 0, 0, 1}, {77, 1, 2, 3}, {400, -1, 1, 0}, {180, 0, 0, -5},
        {33, 0, 0, 0}, {90, 1e-20f, 0, 0}};
    for (unsigned i = 0; i < sizeof axes / sizeof *axes; i++) {
        glLoadIdentity();
        glRotatef(axes[i][0], axes[i][1], axes[i][2], axes[i][3]);
        say_matrix("rotate", GL_MODELVIEW_MATRIX);
    }
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-1, 3, -2, 2, 1, 100);
    say_matrix("frustum", GL_PROJECTION_MATRIX);
    glLoadIdentity();
    glOrtho(-1, 3, -2, 2, -5, 100);
    say_matrix("ortho", GL_PROJECTION_MATRIX);
    for (int i = 0; i < 3; i++) {
        static const GLenum modes[] = {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE};
        static const GLenum depths[] = {GL_MODELVIEW_STACK_DEPTH, GL_PROJECTION_STACK_DEPTH, GL_TEXTURE_STACK_DEPTH};
        static const GLenum queries[] = {GL_MODELVIEW_MATRIX, GL_PROJECTION_MATRIX, GL_TEXTURE_MATRIX};
        GLint depth;
        glMatrixMode(modes[i]);
        glLoadIdentity();
        for (int level = 0; level < 9; level++) {
            glPushMatrix();
            glTranslatef(1, 0, 0);
        }
        glGetIntegerv(depths[i], &depth);
        say("depth %d", depth);
        glPopMatrix();
        glPopMatrix();
        say_matrix("popped", queries[i]);
        for (int level = 0; level < 9; level++)
            glPopMatrix();
        glGetIntegerv(depths[i], &depth);
        say("depth %d", depth);
        say_error("popped twice too often");
    }
    for (int i = 0; i < 6; i++) {
        GLdouble equation[4];
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glRotatef(60.0f * i, 1, 1, 0);
        glTranslatef(1, 2, 3);
        glScalef(1, 2, 0.5f);
        glClipPlane(GL_CLIP_PLANE0 + i, (const GLdouble[]){1, 2, 3, 4});
        glGetClipPlane(GL_CLIP_PLANE0 + i, equation);
        say("plane %.3f %.3f %.3f %.3f", rounded(equation[0]), rounded(equation[1]), rounded(equation[2]), rounded(equation[3]));
    }
}
