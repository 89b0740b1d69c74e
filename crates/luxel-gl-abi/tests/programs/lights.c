/* Lights and materials (2.14): each cell of the picture has a sphere under other settings. */
#include "program.h"

enum { CELLS = 4 };

static void cell(int number)
{
    int size = WIDTH / CELLS;
    glViewport(number % CELLS * size, number / CELLS * size, size, size);
}

/* A sphere of quads, by its longitudes and latitudes; `open` leaves a gap through which its inside is seen. */
static void sphere(double radius, int open)
{
    const int across = 24, up = 16;
    const double pi = 3.141592653589793;
    for (int j = 0; j < up; j++) {
        glBegin(GL_QUAD_STRIP);
        for (int i = 0; i <= across - (open ? 8 : 0); i++)
            for (int k = 1; k >= 0; k--) {
                double a = 2 * pi * i / across, b = pi * (j + k) / up - pi / 2;
                double x = cos(b) * sin(a), y = sin(b), z = cos(b) * cos(a);
                glNormal3d(x, y, z);
                glVertex3d(radius * x, radius * y, radius * z);
            }
        glEnd();
    }
}

static void light(int number, float x, float y, float z, float w, float r, float g, float b)
{
    const float position[] = {x, y, z, w}, color[] = {r, g, b, 1};
    glEnable(GL_LIGHT0 + number);
    glLightfv(GL_LIGHT0 + number, GL_POSITION, position);
    glLightfv(GL_LIGHT0 + number, GL_DIFFUSE, color);
    glLightfv(GL_LIGHT0 + number, GL_SPECULAR, color);
}

static void draw(void)
{
    glClearColor(0.2f, 0.2f, 0.2f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    for (int number = 0; number < CELLS * CELLS; number++) {
        const float grey[] = {0.6f, 0.5f, 0.4f, 0.5f}, shine[] = {0.8f, 0.8f, 0.8f, 1};
        double radius = 1;
        int open = 0;
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        cell(number);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glFrustum(-0.5, 0.5, -0.5, 0.5, 1.5, 20);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glTranslatef(0, 0, -4);
        glEnable(GL_LIGHTING);
        glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, grey);
        glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, shine);
        glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
        switch (number) {
        case 0: light(0, 1, 1, 2, 0, 1, 1, 1); break;
        case 1: light(0, 2, 1, 2, 1, 1, 0.8f, 0.6f); break;
        case 2:
            light(0, 0, 0, 3, 1, 1, 1, 1);
            glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 12);
            break;
        case 3:
            light(0, 0, 0, 3, 1, 1, 1, 1);
            glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 25);
            glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 40);
            glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (const float[]){0.1f, 0.15f, -1});
            break;
        case 4:
            light(0, 1.5f, 1.5f, 1.5f, 1, 2, 2, 2);
            glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.5f);
            glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.3f);
            glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.4f);
            break;
        case 5:
            light(0, 1, 2, 2, 0, 1, 1, 1);
            open = 1;
            glRotatef(150, 0, 1, 0);
            glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
            glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, (const float[]){0.1f, 0.5f, 0.9f, 1});
            glMaterialf(GL_BACK, GL_SHININESS, 5);
            break;
        case 6:
            light(0, 0, 1, 1, 0, 1, 1, 1);
            glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
            glMaterialf(GL_FRONT, GL_SHININESS, 128);
            break;
        case 7:
            light(0, 1, 1, 2, 0, 1.5f, 1.5f, 1.5f);
            glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
            break;
        case 8:
            light(0, 1, 1, 2, 0, 1, 1, 1);
            glColorMaterial(GL_FRONT_AND_BACK, GL_DIFFUSE);
            glEnable(GL_COLOR_MATERIAL);
            glColor3f(0.9f, 0.2f, 0.3f);
            break;
        case 9:
            light(0, 1, 1, 2, 0, 1, 1, 1);
            glMaterialfv(GL_FRONT, GL_EMISSION, (const float[]){0.3f, 0, 0.4f, 1});
            break;
        case 10:
            light(0, 1, 1, 2, 0, 1, 1, 1);
            glScalef(0.5f, 0.5f, 0.5f);
            radius = 2;
            break;
        case 11:
            light(0, 1, 1, 2, 0, 1, 1, 1);
            glScalef(0.5f, 0.5f, 0.5f);
            glEnable(GL_RESCALE_NORMAL);
            radius = 2;
            break;
        case 12:
            light(0, 1, 1, 2, 0, 1, 1, 1);
            glScalef(1, 0.4f, 0.8f);
            glEnable(GL_NORMALIZE);
            break;
        case 13:
            light(0, 1, 1, 2, 0, 1, 1, 1);
            glShadeModel(GL_FLAT);
            break;
        case 14:
            for (int i = 0; i < 8; i++)
                light(i, 3 * sinf(i), 3 * cosf(i), 1 + 0.2f * i, i % 2, 0.1f * i, 0.3f, 0.5f - 0.05f * i);
            glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (const float[]){0.1f, 0.3f, 0.1f, 1});
            glLightfv(GL_LIGHT3, GL_AMBIENT, (const float[]){0.2f, 0, 0, 1});
            break;
        case 15:
            /* A cone of light from infinity. */
            light(0, 0, 0, 1, 0, 1, 1, 1);
            light(1, 1, 0, 1, 0, 1, 0.5f, 0);
            glLightf(GL_LIGHT1, GL_SPOT_CUTOFF, 30);
            glLightfv(GL_LIGHT1, GL_SPOT_DIRECTION, (const float[]){-1, 0, -1.2f});
            glMaterialf(GL_FRONT, GL_SHININESS, 0);
            break;
        }
        sphere(radius, open);
        glPopAttrib();
    }
}
