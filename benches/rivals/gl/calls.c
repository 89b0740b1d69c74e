/* How long OpenGL's fixed-function commands take on the libOSMesa that the loader finds.
 *
 *     cc -O2 calls.c -o calls -lOSMesa -lm && ./calls [ROUNDS [PROGRAM]]
 *
 * Prints a line for each program, or for one of that name: its name and the median of its milliseconds. 1280x720 pixels;
 * the mesh has 99,904 triangles, one light with a local viewer, back faces culled. `speed.py` runs it in turns with another
 * library. */
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { WIDTH = 1280, HEIGHT = 720, ACROSS = 223, UP = 224, TRIANGLES = 2 * ACROSS * UP };

static float positions[(ACROSS + 1) * (UP + 1)][3], normals[(ACROSS + 1) * (UP + 1)][3];
static GLuint indices[3 * TRIANGLES], words[16 << 20], mesh_list, buffers[3], texture;
static float values[16 << 20];

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1e3 + time.tv_nsec / 1e6;
}

/* A bumpy sphere. */
static void make_mesh(void)
{
    for (int j = 0; j <= UP; j++)
        for (int i = 0; i <= ACROSS; i++) {
            double a = 6.283185307 * i / ACROSS, b = 3.141592653 * j / UP, r = 1 + 0.05 * sin(9 * a) * sin(7 * b);
            float *p = positions[j * (ACROSS + 1) + i], *n = normals[j * (ACROSS + 1) + i];
            n[0] = sin(b) * cos(a);
            n[1] = cos(b);
            n[2] = -sin(b) * sin(a);
            for (int k = 0; k < 3; k++)
                p[k] = r * n[k];
        }
    GLuint *at = indices;
    for (int j = 0; j < UP; j++)
        for (int i = 0; i < ACROSS; i++) {
            GLuint a = j * (ACROSS + 1) + i, b = a + ACROSS + 1;
            GLuint two[6] = {a, b, a + 1, a + 1, b, b + 1};
            memcpy(at, two, sizeof two);
            at += 6;
        }
}

static void immediate(void)
{
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3 * TRIANGLES; i++) {
        glNormal3fv(normals[indices[i]]);
        glVertex3fv(positions[indices[i]]);
    }
    glEnd();
}

static void list(void) { glCallList(mesh_list); }

static void make_list(void)
{
    glNewList(mesh_list + 1, GL_COMPILE);
    immediate();
    glEndList();
}

static void buffer(void)
{
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_NORMAL_ARRAY);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glVertexPointer(3, GL_FLOAT, 0, NULL);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
    glNormalPointer(GL_FLOAT, 0, NULL);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
    glDrawElements(GL_TRIANGLES, 3 * TRIANGLES, GL_UNSIGNED_INT, NULL);
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_NORMAL_ARRAY);
}

/* A window of 5x5 pixels in the middle. */
static void begin_select(void)
{
    glSelectBuffer(sizeof words / sizeof *words, words);
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(0);
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    GLdouble projection[16];
    glGetDoublev(GL_PROJECTION_MATRIX, projection);
    glLoadIdentity();
    glScaled(WIDTH / 5.0, HEIGHT / 5.0, 1);
    glMultMatrixd(projection);
    glMatrixMode(GL_MODELVIEW);
}

static void end_select(void)
{
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glMatrixMode(GL_MODELVIEW);
    glRenderMode(GL_RENDER);
}

static void select_one(void)
{
    begin_select();
    immediate();
    end_select();
}

static void select_buffer(void)
{
    begin_select();
    buffer();
    end_select();
}

static void select_each(void)
{
    begin_select();
    for (int i = 0; i < TRIANGLES; i++) {
        glLoadName(i);
        glBegin(GL_TRIANGLES);
        for (int k = 0; k < 3; k++)
            glVertex3fv(positions[indices[3 * i + k]]);
        glEnd();
    }
    end_select();
}

static void feedback(void)
{
    glFeedbackBuffer(sizeof values / sizeof *values, GL_3D_COLOR, values);
    glRenderMode(GL_FEEDBACK);
    immediate();
    glRenderMode(GL_RENDER);
}

/* 2,000 quads, each with its matrix. */
static void quads(void)
{
    for (int i = 0; i < 2000; i++) {
        glPushMatrix();
        glTranslatef((i % 50) * 0.04f - 1, (i / 50) * 0.05f - 1, 0);
        glRotatef(i, 0, 0, 1);
        glBegin(GL_QUADS);
        glNormal3f(0, 0, 1);
        glVertex2f(-0.02f, -0.02f);
        glVertex2f(0.02f, -0.02f);
        glVertex2f(0.02f, 0.02f);
        glVertex2f(-0.02f, 0.02f);
        glEnd();
        glPopMatrix();
    }
}

static void lines(void)
{
    glDisable(GL_LIGHTING);
    glBegin(GL_LINES);
    for (int i = 0; i < 150000; i++) {
        const GLuint *triangle = indices + 3 * (i % TRIANGLES);
        glVertex3fv(positions[triangle[i / TRIANGLES]]);
        glVertex3fv(positions[triangle[1 + i / TRIANGLES]]);
    }
    glEnd();
    glEnable(GL_LIGHTING);
}

static void layers(int textured)
{
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glDisable(GL_LIGHTING);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    if (textured)
        glEnable(GL_TEXTURE_2D);
    else {
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glLoadIdentity();
    for (int i = 0; i < 10; i++) {
        glColor4f(0.1f * i, 0.5f, 0.8f, textured ? 1 : 0.3f);
        glBegin(GL_QUADS);
        glTexCoord2f(0, 0);
        glVertex2f(-1, -1);
        glTexCoord2f(3, 0.1f * i);
        glVertex2f(1, -1);
        glTexCoord2f(3, 3);
        glVertex2f(1, 1);
        glTexCoord2f(0, 3);
        glVertex2f(-1, 1);
        glEnd();
    }
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glPopAttrib();
}

static void bilinear(void) { layers(1); }
static void blended(void) { layers(0); }

static void nothing(void) {}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The commands alone, per call: in nanoseconds. */
static void time_calls(void)
{
    enum { CALLS = 3000000 };
    double start = now();
    for (int i = 0; i < CALLS; i++)
        glColor3f(0.1f, 0.2f, 0.3f);
    printf("glColor3f_ns %.2f\n", (now() - start) * 1e6 / CALLS);
    double inside = 0;
    for (int part = 0; part < 100; part++) {
        glBegin(GL_POINTS);
        start = now();
        for (int i = 0; i < CALLS / 100; i++)
            glVertex3f(2, 2, 2);
        inside += now() - start;
        glEnd();
    }
    printf("glVertex3f_ns %.2f\n", inside * 1e6 / CALLS);
}

int main(int count, char **arguments)
{
    static const struct {
        const char *name;
        void (*run)(void);
    } programs[] = {{"empty", nothing}, {"immediate", immediate}, {"list", list}, {"making_the_list", make_list}, {"buffers", buffer},
        {"select_5x5_immediate", select_one}, {"select_5x5_buffers", select_buffer}, {"select_name_each", select_each},
        {"feedback", feedback}, {"quads_with_matrices", quads}, {"lines", lines}, {"bilinear_layers", bilinear}, {"blended_layers", blended}};
    int rounds = count > 1 ? atoi(arguments[1]) : 7;
    double times[64];
    if (rounds < 1 || rounds > 64)
        return 1;
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    void *pixels = malloc(WIDTH * HEIGHT * 4);
    if (!pixels || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, WIDTH, HEIGHT))
        return 1;
    make_mesh();
    glMatrixMode(GL_PROJECTION);
    glFrustum(-0.08 * WIDTH / HEIGHT, 0.08 * WIDTH / HEIGHT, -0.08, 0.08, 0.2, 20);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0, 0, -3);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    glMaterialfv(GL_FRONT, GL_SPECULAR, (const float[]){0.5f, 0.5f, 0.5f, 1});
    glMaterialf(GL_FRONT, GL_SHININESS, 20);
    mesh_list = glGenLists(2);
    glNewList(mesh_list, GL_COMPILE);
    immediate();
    glEndList();
    glGenBuffers(3, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, sizeof positions, positions, GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ARRAY_BUFFER, sizeof normals, normals, GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STATIC_DRAW);
    static unsigned char image[256][256][4];
    for (int i = 0; i < 256 * 256 * 4; i++)
        ((unsigned char *)image)[i] = i * 2654435761u >> 24;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 256, 256, 0, GL_RGBA, GL_UNSIGNED_BYTE, image);
    const char *only = count > 2 ? arguments[2] : NULL;
    if (!only)
        time_calls();
    for (unsigned i = 0; i < sizeof programs / sizeof *programs; i++) {
        if (only && strcmp(only, programs[i].name))
            continue;
        /* One round to warm up. */
        for (int round = -1; round < rounds; round++) {
            double start = now();
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            programs[i].run();
            glFinish();
            if (round >= 0)
                times[round] = now() - start;
        }
        qsort(times, rounds, sizeof *times, compare);
        printf("%s %.3f\n", programs[i].name, times[rounds / 2]);
    }
    if (glGetError())
        printf("an error has been recorded\n");
    return 0;
}
