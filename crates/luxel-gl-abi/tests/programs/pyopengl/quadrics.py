"""GLU's shapes under three lights: perspective, view, normals, a light with a cone, two sides (2.14)."""

from OpenGL.GL import *  # noqa: F403
from OpenGL.GLU import *  # noqa: F403

import _program


def draw():
    glClearColor(0.1, 0.1, 0.15, 1)
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    glEnable(GL_DEPTH_TEST)
    glEnable(GL_LIGHTING)
    glEnable(GL_NORMALIZE)
    glMatrixMode(GL_PROJECTION)
    gluPerspective(40, 1, 1, 50)
    glMatrixMode(GL_MODELVIEW)
    gluLookAt(3, 4, 9, 0, 0, 0, 0, 1, 0)
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE)
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE)
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, (0.1, 0.1, 0.1, 1))
    lights = [
        (GL_LIGHT0, (5, 8, 4, 0), (0.7, 0.7, 0.6, 1), 180),
        (GL_LIGHT1, (-6, 2, 3, 1), (0.2, 0.3, 0.8, 1), 180),
        (GL_LIGHT2, (0, 6, 0, 1), (0.9, 0.3, 0.2, 1), 25),
    ]
    for light, position, color, cutoff in lights:
        glEnable(light)
        glLightfv(light, GL_POSITION, position)
        glLightfv(light, GL_DIFFUSE, color)
        glLightfv(light, GL_SPECULAR, color)
        glLightf(light, GL_SPOT_CUTOFF, cutoff)
    glLightfv(GL_LIGHT2, GL_SPOT_DIRECTION, (0.1, -1, 0.1))
    glLightf(GL_LIGHT2, GL_SPOT_EXPONENT, 8)
    glLightf(GL_LIGHT1, GL_LINEAR_ATTENUATION, 0.05)
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (0.5, 0.5, 0.5, 1))
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40)
    quadric = gluNewQuadric()
    shapes = [
        ((-1.5, 0.6, 0), (0.8, 0.5, 0.2, 1), lambda: gluSphere(quadric, 1.2, 32, 24)),
        ((1.6, -1, 0), (0.3, 0.7, 0.4, 1), lambda: gluCylinder(quadric, 1, 0.4, 2.5, 24, 8)),
        ((0, -1.2, 2), (0.6, 0.6, 0.7, 1), lambda: gluDisk(quadric, 0.4, 1.2, 24, 6)),
        ((0.5, 1.8, -2), (0.7, 0.3, 0.6, 1), lambda: gluPartialDisk(quadric, 0.2, 1.4, 20, 4, 30, 250)),
    ]
    for number, (place, color, shape) in enumerate(shapes):
        glPushMatrix()
        glTranslatef(*place)
        glRotatef(-70 + 35 * number, 1, 0.2, 0)
        glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color)
        # One normal a facet: SGI's library leaves it to the shade model not to mix them.
        gluQuadricNormals(quadric, GLU_FLAT if number == 1 else GLU_SMOOTH)
        glShadeModel(GL_FLAT if number == 1 else GL_SMOOTH)
        shape()
        glPopMatrix()
    gluDeleteQuadric(quadric)
    viewport = glGetIntegerv(GL_VIEWPORT)
    model, projection = glGetDoublev(GL_MODELVIEW_MATRIX), glGetDoublev(GL_PROJECTION_MATRIX)
    window = gluProject(-1.5, 0.6, 0, model, projection, viewport)
    print("project", *(round(float(x), 3) for x in window))
    print("back", *(round(float(x), 3) + 0.0 for x in gluUnProject(*window, model, projection, viewport)))
    depth = glReadPixels(*(int(x) for x in window[:2]), 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT)
    print("nearer than the centre", bool(float(depth[0][0]) < window[2]))


_program.run(draw)
