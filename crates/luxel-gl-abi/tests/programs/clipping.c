/* Clipping: through the eye, at all six planes and at planes of the user's, with colours that go on (2.12). */
#include "program.h"

static void fan(double z)
{
    glBegin(GL_TRIANGLE_FAN);
    glColor3f(1, 1, 1);
    glVertex3d(0, 0, z);
    for (int i = 0; i <= 7; i++) {
        glColor3f(i % 2, 0.14f * i, 1 - 0.14f * i);
        glVertex3d(3 * cos(0.9 * i), 3 * sin(0.9 * i), z + 2 * sin(2.0 * i));
    }
    glEnd();
}

static void draw(void)
{
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    for (int cell = 0; cell < 9; cell++) {
        glViewport(cell % 3 * 85, cell / 3 * 85, 85, 85);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        if (cell == 8)
            glOrtho(-2, 2, -2, 2, 3, 4);
        else
            glFrustum(-1, 1, -1, 1, 1, 5);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glRotated(7 * cell, 0, 1, 0.3);
        switch (cell) {
        case 0: fan(-3); break;
        case 1: fan(-1); break;
        case 2: fan(0); break;
        case 3: fan(-4.5); break;
        case 4:
            glClipPlane(GL_CLIP_PLANE0, (const double[]){1, 0, 0, 0.3});
            glEnable(GL_CLIP_PLANE0);
            fan(-3);
            break;
        case 5:
            for (int i = 0; i < 6; i++) {
                glClipPlane(GL_CLIP_PLANE0 + i, (const double[]){cos(1.1 * i), sin(1.1 * i), 0.1, 0.9 + 0.2 * i});
                glEnable(GL_CLIP_PLANE0 + i);
            }
            fan(-3);
            break;
        case 6:
            /* Edges of two triangles are drawn twice, in two colours: the last one stays. */
            glDisable(GL_DEPTH_TEST);
            glShadeModel(GL_FLAT);
            glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            fan(-2);
            glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
            break;
        case 7:
            glBegin(GL_LINES);
            for (int i = 0; i < 12; i++) {
                glColor3f(0.5f, i / 12.0f, 1);
                glVertex3d(cos(i), sin(i), -4);
                glVertex3d(4 * cos(i + 1), 4 * sin(i + 1), 1.3);
            }
            glEnd();
            break;
        case 8: fan(-3.5); break;
        }
        glEnable(GL_DEPTH_TEST);
        glShadeModel(GL_SMOOTH);
        for (int i = 0; i < 6; i++)
            glDisable(GL_CLIP_PLANE0 + i);
    }
    say_error("clipping");
}
