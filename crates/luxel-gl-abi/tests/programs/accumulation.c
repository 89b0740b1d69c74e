/* The accumulation buffer (4.2.4): sums of turned pictures, scales, scissor box, masks, lists, errors. */
#define ACCUM_BITS 16
#include "program.h"

static void triangle(float angle)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glLoadIdentity();
    glRotatef(angle, 0, 0, 1);
    glBegin(GL_TRIANGLES);
    glColor4f(1, 0.2f, 0.1f, 1), glVertex2f(-0.8f, -0.6f);
    glColor4f(0.1f, 0.9f, 0.3f, 1), glVertex2f(0.8f, -0.5f);
    glColor4f(0.2f, 0.1f, 1, 1), glVertex2f(0.1f, 0.8f);
    glEnd();
}

static void say_pixel(const char *what, int x, int y)
{
    float color[4];
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_FLOAT, color);
    say("%s: %.2f %.2f %.2f %.2f", what, color[0], color[1], color[2], color[3]);
}

static void draw(void)
{
    float clear[4];
    glClearAccum(0.1f, 0.2f, 0.3f, 2);
    glGetFloatv(GL_ACCUM_CLEAR_VALUE, clear);
    say("cleared to: %g %g %g %g", clear[0], clear[1], clear[2], clear[3]);
    glClear(GL_ACCUM_BUFFER_BIT);
    glAccum(GL_RETURN, 1);
    say_pixel("cleared", 3, 3);
    for (int turn = 0; turn < 4; turn++) {
        triangle(5 * (float)turn);
        glAccum(turn ? GL_ACCUM : GL_LOAD, 0.25f);
    }
    glAccum(GL_RETURN, 1);
    say_pixel("a sum", 128, 120);
    glEnable(GL_SCISSOR_TEST);
    glScissor(10, 10, 100, 90);
    glAccum(GL_MULT, 0.5f);
    glAccum(GL_ADD, 0.125f);
    glAccum(GL_RETURN, 1.5f);
    say_pixel("scaled", 70, 70);
    glScissor(130, 100, 60, 60);
    glColorMask(1, 0, 0, 1);
    glAccum(GL_MULT, -1);
    glAccum(GL_RETURN, 1);
    glAccum(GL_RETURN, -0.5f);
    say_pixel("masked", 150, 120);
    glColorMask(1, 1, 1, 1);
    glDisable(GL_SCISSOR_TEST);
    glNewList(1, GL_COMPILE);
    glScissor(200, 200, 40, 40);
    glEnable(GL_SCISSOR_TEST);
    glAccum(GL_LOAD, 0);
    glAccum(GL_ADD, 0.6f);
    glAccum(GL_RETURN, 1);
    glDisable(GL_SCISSOR_TEST);
    glEndList();
    glCallList(1);
    say_pixel("by a list", 220, 220);
    say_error("sums");
    glAccum(GL_TEXTURE_2D, 1);
    say_error("no operation");
    glBegin(GL_POINTS);
    glAccum(GL_LOAD, 1);
    glEnd();
    say_error("within glBegin");
}
