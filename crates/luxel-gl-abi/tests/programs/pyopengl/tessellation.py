"""A star and a frame, cut into triangles by GLU's tessellator, with all winding rules (GLU 1.3, chapter 5)."""

import math

from OpenGL.GL import *  # noqa: F403
from OpenGL.GLU import *  # noqa: F403

import _program

RULES = [
    GLU_TESS_WINDING_ODD,
    GLU_TESS_WINDING_NONZERO,
    GLU_TESS_WINDING_POSITIVE,
    GLU_TESS_WINDING_NEGATIVE,
    GLU_TESS_WINDING_ABS_GEQ_TWO,
]


def contours():
    yield [(0.9 * math.sin(4 * math.pi * i / 5), 0.9 * math.cos(4 * math.pi * i / 5), 0) for i in range(5)]
    yield [(-0.5, -0.6, 0), (0.7, -0.5, 0), (0.6, 0.5, 0), (-0.6, 0.4, 0)]
    yield [(-0.3, -0.3, 0), (-0.3, 0.2, 0), (0.3, 0.3, 0), (0.3, -0.3, 0)]


def draw():
    glClear(GL_COLOR_BUFFER_BIT)
    tess = gluNewTess()
    gluTessCallback(tess, GLU_TESS_BEGIN, glBegin)
    gluTessCallback(tess, GLU_TESS_END, glEnd)
    gluTessCallback(tess, GLU_TESS_VERTEX, glVertex3dv)
    gluTessCallback(tess, GLU_TESS_COMBINE, lambda place, data, weights: tuple(place))
    for number, rule in enumerate(RULES):
        for boundary in (GL_FALSE, GL_TRUE):
            glPushMatrix()
            glTranslatef(-0.66 + 0.66 * (number % 3), 0.5 - number // 3, 0)
            glScalef(0.3, 0.3 if number != 4 else -0.3, 1)
            glColor3f(*((1, 1, 1) if boundary else (0.3, 0.5, 0.2 * number)))
            gluTessProperty(tess, GLU_TESS_WINDING_RULE, rule)
            gluTessProperty(tess, GLU_TESS_BOUNDARY_ONLY, boundary)
            gluTessBeginPolygon(tess, None)
            for contour in contours():
                gluTessBeginContour(tess)
                for vertex in contour:
                    gluTessVertex(tess, vertex, vertex)
                gluTessEndContour(tess)
            gluTessEndPolygon(tess)
            glPopMatrix()
    gluDeleteTess(tess)


_program.run(draw)
