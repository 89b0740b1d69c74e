/* All ten kinds of primitives, smooth and flat, as areas, lines and points, culled and turned (2.6, 3.3 to 3.5). */
#include "program.h"

/* Corners of a ladder's rungs, in the order of strips; of quads in theirs; else around a circle. All faces are convex. */
static void corner(GLenum mode, int i, float *p)
{
    static const int around[4] = {0, 1, 3, 2};
    if (mode == GL_POLYGON || mode == GL_LINE_LOOP || mode == GL_TRIANGLE_FAN) {
        p[0] = 0.51f + 0.43f * cosf(0.51f * i);
        p[1] = 0.49f + 0.44f * sinf(0.51f * i);
        return;
    }
    if (mode == GL_QUADS)
        i = i / 4 * 4 + around[i % 4];
    p[0] = (i % 2 ? 0.83f : 0.13f) + 0.021f * (i / 2);
    p[1] = 0.07f + 0.163f * (i / 2) + 0.031f * (i % 2);
}

static void primitive(GLenum mode, int count, int edges)
{
    glBegin(mode);
    for (int i = 0; i < count; i++) {
        float p[2];
        corner(mode, i, p);
        glColor3f(0.3f + 0.7f * (i % 3 == 0), 0.3f + 0.7f * (i % 3 == 1), 0.2f + i * 0.06f);
        if (edges)
            glEdgeFlag(i % 2);
        glVertex2fv(p);
    }
    glEnd();
    glEdgeFlag(GL_TRUE);
}

static void draw(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, 1, 0, 1, -1, 1);
    const int size = WIDTH / 10;
    for (int row = 0; row < 10; row++)
        for (int mode = 0; mode < 10; mode++) {
            glViewport(mode * size, row * size, size, size);
            glPushAttrib(GL_ALL_ATTRIB_BITS);
            int count = 12, edges = 0;
            if (row & 1)
                glShadeModel(GL_FLAT);
            switch (row / 2) {
            case 1: glPolygonMode(GL_FRONT_AND_BACK, GL_LINE); break;
            case 2: glPolygonMode(GL_FRONT, GL_POINT); glPointSize(3); break;
            case 3: glEnable(GL_CULL_FACE); glFrontFace(row & 1 ? GL_CW : GL_CCW); count = 11; break;
                        case 4:
                /* Edges of strips and fans are all edges of the outline (2.6.2), which Mesa doesn't know. */
                glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
                edges = mode == GL_TRIANGLES || mode == GL_QUADS || mode == GL_POLYGON;
                break;
            }
            primitive(mode, count, edges);
            glPopAttrib();
        }
    /* Too few vertices draw nothing. */
    glColor3f(1, 1, 1);
    for (int mode = GL_LINES; mode <= GL_POLYGON; mode++) {
        glBegin(mode);
        glVertex2f(0, 0);
        if (mode >= GL_TRIANGLES)
            glVertex2f(1, 1);
        if (mode == GL_QUADS || mode == GL_QUAD_STRIP)
            glVertex2f(1, 0);
        glEnd();
    }
}
