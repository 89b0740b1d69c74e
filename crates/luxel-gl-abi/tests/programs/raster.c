/* The current raster position (2.13), by transformed and by window coordinates. */
#include "program.h"

static void say_raster(const char *what)
{
    GLfloat position[4], color[4], texture[4];
    GLboolean valid;
    glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
    glGetFloatv(GL_CURRENT_RASTER_COLOR, color);
    glGetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, texture);
    glGetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    if (!valid)
        say("%s: not valid", what);
    else
        say("%s: %.3f %.3f %.4f %.3f | %.3f %.3f %.3f %.3f | %.2f %.2f %.2f %.2f", what, position[0], position[1], position[2],
            position[3], color[0], color[1], color[2], color[3], texture[0], texture[1], texture[2], texture[3]);
}

#define SET(call)          \
    do {                   \
        call;              \
        say_raster(#call); \
    } while (0)

static void draw(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    say_raster("at first");
    glColor4f(0.2f, 0.4f, 0.6f, 0.8f);
    glTexCoord4f(1, 2, 3, 4);
    SET(glRasterPos2f(0.25f, -0.5f));
    SET(glRasterPos3d(0.25, -0.5, 0.5));
    SET(glRasterPos4i(1, 1, 1, 2));
    SET(glRasterPos2s(1, 1));
    SET(glRasterPos2f(1.1f, 0));
    SET(glRasterPos3f(0, 0, 1.1f));
    SET(glRasterPos4f(0, 0, 0, -1));
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(0.1f, 0.2f, -3);
    glViewport(10, 20, 100, 200);
    glDepthRange(0.25, 0.75);
    SET(glRasterPos3f(0.5f, 0.5f, 0.5f));
    SET(glRasterPos4f(1, 1, 1, 2));
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glNormal3f(0, 0, 1);
    SET(glRasterPos2i(0, 0));
    glDisable(GL_LIGHTING);
    glClipPlane(GL_CLIP_PLANE0, (const double[]){1, 0, 0, 0});
    glEnable(GL_CLIP_PLANE0);
    SET(glRasterPos2f(-0.3f, 0));
    SET(glRasterPos2f(0.3f, 0));
    glDisable(GL_CLIP_PLANE0);
    SET(glWindowPos2i(3, 4));
    SET(glWindowPos3f(3.5f, 400.25f, 0.5f));
    SET(glWindowPos3d(-30, 4, 7));
    SET(glWindowPos3sv((const GLshort[]){1, 2, -1}));
    SET(glWindowPos2dv((const GLdouble[]){1.25, 2.5}));
    say_error("raster positions");
}
