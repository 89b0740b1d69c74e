"""Names under a pixel, by gluPickMatrix and GL_SELECT, and primitives by GL_FEEDBACK (5.2, 5.3).

PyOpenGL's own wrappers of glSelectBuffer and glFeedbackBuffer lose their arrays with OSMesa.
"""

from OpenGL.GL import *  # noqa: F403
from OpenGL.GLU import *  # noqa: F403
from OpenGL.raw.GL.VERSION.GL_1_0 import glFeedbackBuffer, glRenderMode, glSelectBuffer

import _program


def scene():
    for column in range(4):
        glLoadName(column)
        glPushName(0)
        for row in range(4):
            glLoadName(10 + row)
            glColor3f(0.25 * column + 0.2, 0.2 * row + 0.2, 0.6)
            x, y = column - 2, row - 2
            glBegin(GL_TRIANGLES)
            glVertex3f(x + 0.1, y + 0.1, -0.1 * row)
            glVertex3f(x + 1.3, y + 0.1, 0.1 * column)
            glVertex3f(x + 0.5, y + 0.9, 0.3)
            glEnd()
        glPopName()


def project(pick=None):
    glMatrixMode(GL_PROJECTION)
    glLoadIdentity()
    if pick:
        gluPickMatrix(*pick, 4, 4, glGetIntegerv(GL_VIEWPORT))
    gluOrtho2D(-2.5, 2.5, -2.5, 2.5)
    glMatrixMode(GL_MODELVIEW)


def draw():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    project()
    scene()
    words = (GLuint * 256)()
    for x in range(8, 256, 24):
        for y in range(8, 256, 24):
            glSelectBuffer(len(words), words)
            glRenderMode(GL_SELECT)
            glInitNames()
            glPushName(99)
            project((x, y))
            scene()
            hits, at, said = glRenderMode(GL_RENDER), 0, []
            for _ in range(hits):
                count, near, far = words[at], words[at + 1] / 0xFFFFFFFF, words[at + 2] / 0xFFFFFFFF
                said.append((round(near, 4), round(far, 4), words[at + 3 : at + 3 + count]))
                at += 3 + count
            print(x, y, *said)
    project()
    values = (GLfloat * 1000)()
    glFeedbackBuffer(len(values), GL_3D, values)
    glRenderMode(GL_FEEDBACK)
    glPassThrough(7)
    scene()
    print(*(round(value, 3) for value in values[: glRenderMode(GL_RENDER)]))


_program.run(draw)
