/* Lines and points: directions, widths, stipples, sizes (3.3, 3.4). Ends lie off the pixels' diamonds. */
#include "program.h"

static void draw(void)
{
    const double pi = 3.141592653589793;
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, WIDTH, 0, HEIGHT, -1, 1);
    for (int i = 0; i < 37; i++) {
        double a = 2 * pi * i / 37;
        glBegin(GL_LINES);
        glColor3f(1, 0.2f, 0.1f);
        glVertex2d(64.3 + 8 * cos(a), 64.2 + 8 * sin(a));
        glColor3f(0.1f, 0.4f, 1);
        glVertex2d(64.3 + 58 * cos(a), 64.2 + 58 * sin(a));
        glEnd();
    }
    for (int i = 0; i < 12; i++) {
        double a = 2 * pi * i / 12 + 0.1;
        glLineWidth(i * 0.7 + 0.6);
        glColor3f(0.3f, 0.9f, 0.2f + 0.06f * i);
        glBegin(GL_LINES);
        glVertex2d(192.3 + 16 * cos(a), 64.2 + 16 * sin(a));
        glVertex2d(192.3 + 54 * cos(a), 64.2 + 54 * sin(a));
        glEnd();
    }
    glEnable(GL_LINE_STIPPLE);
    static const GLushort patterns[] = {0xaaaa, 0x00ff, 0x0f0f, 0xfffe, 0x8001, 0x1c47};
    /* Along the axes and between centres of pixels: Mesa counts by length, where the specification counts fragments. */
    for (int i = 0; i < 12; i++) {
        int x = 8 + i % 4 * 30, y = 140 + i / 4 * 38;
        glLineWidth(1 + i % 3);
        glLineStipple(1 + i / 4, patterns[i % 6]);
        glColor3f(1, 1, 0.3f);
        glBegin(i % 4 == 3 ? GL_LINES : i % 2 ? GL_LINE_STRIP : GL_LINE_LOOP);
        glVertex2d(x + 0.5, y + 0.5);
        glVertex2d(x + 24.5, y + 0.5);
        glVertex2d(x + 24.5, y + 30.5);
        glVertex2d(x + 0.5, y + 30.5);
        glEnd();
    }
    glDisable(GL_LINE_STIPPLE);
    for (int i = 0; i < 48; i++) {
        glPointSize(0.6 + i * 0.23);
        glColor3f(0.5f + i * 0.01f, 0.9f - i * 0.015f, 0.7f);
        glBegin(GL_POINTS);
        glVertex2d(140.3 + i % 8 * 14, 140.2 + i / 8 * 18);
        glEnd();
    }
}
