/* Three toothed wheels that mesh: display lists, one light at infinity, flat sides and smooth bores (2.14, 5.4). */
#include "program.h"

/* A vertex at an angle in radians, a radius and a height. */
static void at(double angle, double radius, double z)
{
    glVertex3d(radius * cos(angle), radius * sin(angle), z);
}

/* One wheel: a ring of teeth between two faces, with a bore. Each tooth takes four steps: up, along, down, along. */
static void wheel(double bore, double root, double tip, double thick, int teeth)
{
    const double step = 6.283185307179586 / (4 * teeth), top = thick / 2;
    glShadeModel(GL_FLAT);
    for (int side = 1; side >= -1; side -= 2) {
        glNormal3d(0, 0, side);
        glBegin(GL_QUAD_STRIP);
        for (int i = 0; i <= 4 * teeth; i++) {
            double angle = side * i * step;
            at(angle, bore, side * top);
            at(angle, root, side * top);
        }
        glEnd();
        glBegin(GL_QUADS);
        for (int i = 0; i < teeth; i++) {
            double first = side * 4 * i * step;
            at(first, root, side * top);
            at(first + side * step, tip, side * top);
            at(first + side * 2 * step, tip, side * top);
            at(first + side * 3 * step, root, side * top);
        }
        glEnd();
    }
    glBegin(GL_QUADS);
    for (int i = 0; i < 4 * teeth; i++) {
        double from = i * step, to = (i + 1) * step;
        double r0 = i % 4 == 1 || i % 4 == 2 ? tip : root, r1 = i % 4 == 0 || i % 4 == 1 ? tip : root;
        double dx = r1 * cos(to) - r0 * cos(from), dy = r1 * sin(to) - r0 * sin(from), length = hypot(dx, dy);
        glNormal3d(dy / length, -dx / length, 0);
        at(from, r0, -top);
        at(to, r1, -top);
        at(to, r1, top);
        at(from, r0, top);
    }
    glEnd();
    glShadeModel(GL_SMOOTH);
    glBegin(GL_QUAD_STRIP);
    for (int i = 0; i <= 4 * teeth; i++) {
        glNormal3d(-cos(i * step), -sin(i * step), 0);
        at(i * step, bore, -top);
        at(i * step, bore, top);
    }
    glEnd();
}

static void draw(void)
{
    static const struct {
        float color[4];
        double bore, root, tip, thick, x, y, turn;
        int teeth;
    } wheels[3] = {
        {{0.75f, 0.15f, 0.1f, 1}, 1.0, 3.3, 4.1, 1.0, -3.0, -2.0, 20, 20},
        {{0.1f, 0.65f, 0.2f, 1}, 0.5, 1.4, 2.1, 2.0, 3.0, -2.0, -49, 10},
        {{0.2f, 0.25f, 0.9f, 1}, 1.2, 1.4, 2.1, 0.6, -3.0, 4.2, -65, 10},
    };
    const float light[4] = {4, 5, 10, 0};
    glClearColor(0.05f, 0.05f, 0.1f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_CULL_FACE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_DEPTH_TEST);
    glLightfv(GL_LIGHT0, GL_POSITION, light);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 5, 60);
    glMatrixMode(GL_MODELVIEW);
    glTranslated(0, 0, -40);
    GLuint lists = glGenLists(3);
    for (int i = 0; i < 3; i++) {
        glNewList(lists + i, GL_COMPILE);
        glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, wheels[i].color);
        wheel(wheels[i].bore, wheels[i].root, wheels[i].tip, wheels[i].thick, wheels[i].teeth);
        glEndList();
    }
    glRotated(20, 1, 0, 0);
    glRotated(30, 0, 1, 0);
    for (int i = 0; i < 3; i++) {
        glPushMatrix();
        glTranslated(wheels[i].x, wheels[i].y, 0);
        glRotated(wheels[i].turn, 0, 0, 1);
        glCallList(lists + i);
        glPopMatrix();
    }
    say("lists %d %d", glIsList(lists) == GL_TRUE, glIsList(lists + 3) == GL_TRUE);
}
