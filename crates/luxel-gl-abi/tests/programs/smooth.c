/* Smooth points and lines: sizes, directions, colours, depths, blending, state. Their edges are everywhere, and libraries may
 * find covered parts in ways of their own: so the picture has few of them, and sums are said. */
#include "program.h"

/* How bright a part of the window is. */
static double sum_of(int x, int y, int width, int height)
{
    static GLubyte part[HEIGHT * WIDTH];
    double sum = 0;
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(x, y, width, height, GL_RED, GL_UNSIGNED_BYTE, part);
    for (int i = 0; i < width * height; i++)
        sum += part[i] / 255.0;
    return sum;
}

/* Says whether a figure is about as large as it should be. */
static void say_area(const char *what, double found, double expected)
{
    say("%s: %s", what, fabs(found - expected) < 0.12 * expected + 0.5 ? "as large as it is" : "too large or too small");
}

static void line(float x, float y, float to_x, float to_y)
{
    glBegin(GL_LINES);
    glVertex2f(x, y);
    glVertex2f(to_x, to_y);
    glEnd();
}

static void draw(void)
{
    GLfloat range[2];
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, WIDTH, 0, HEIGHT, -1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glGetFloatv(GL_SMOOTH_POINT_SIZE_RANGE, range);
    say("points from %.0f: %d", range[0], range[1] >= 63);
    glGetFloatv(GL_SMOOTH_LINE_WIDTH_RANGE, range);
    say("lines from %.0f: %d", range[0], range[1] >= 7);
    say("smooth: %d %d", glIsEnabled(GL_POINT_SMOOTH), glIsEnabled(GL_LINE_SMOOTH));
    glEnable(GL_POINT_SMOOTH);
    glEnable(GL_LINE_SMOOTH);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);

    glLineWidth(4);
    line(10, 20, 50, 20);
    say_area("across", sum_of(0, 10, 64, 20), 160);
    line(80, 10, 80, 50);
    say_area("up", sum_of(70, 0, 20, 60), 160);
    line(100, 10, 140, 40);
    say_area("aslant", sum_of(90, 0, 60, 50), 200);
    glLineWidth(1);
    line(150, 10, 200, 30.5f);
    say_area("thin", sum_of(145, 0, 60, 50), 54);

    glPointSize(20);
    glBegin(GL_POINTS);
    glVertex2f(30, 90);
    glEnd();
    say_area("a disc", sum_of(10, 70, 40, 40), 314);
    glPointSize(7.5f);
    glBegin(GL_POINTS);
    glVertex2f(80.3f, 90.6f);
    glEnd();
    say_area("a small disc", sum_of(60, 70, 40, 40), 44.2);

    /* Within figures colours are exact. */
    glDisable(GL_BLEND);
    glLineWidth(9);
    glBegin(GL_LINES);
    glColor3f(1, 0, 0);
    glVertex2f(20, 150);
    glColor3f(0, 0, 1);
    glVertex2f(120, 150);
    glEnd();
    GLubyte pixel[4];
    glReadPixels(70, 150, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    say("in the middle: %d", abs(pixel[0] - 126) <= 2 && abs(pixel[2] - 129) <= 2 && pixel[3] == 255);

    /* A line that lies behind is hidden. */
    glEnable(GL_DEPTH_TEST);
    glColor3f(0, 1, 0);
    glRectf(150, 130, 200, 170);
    glColor3f(1, 1, 1);
    glBegin(GL_LINES);
    glVertex3f(140, 150, -0.5f);
    glVertex3f(210, 150, -0.5f);
    glEnd();
    glReadPixels(175, 150, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    say("hidden: %d", pixel[0] == 0 && pixel[1] == 255);
    glReadPixels(205, 150, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    say("seen: %d", pixel[0] == 255);
    glClear(GL_COLOR_BUFFER_BIT);
    glRectf(10, 10, 100, 100);
}
