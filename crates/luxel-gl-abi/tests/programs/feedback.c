/* Feedback (5.3): all types, all primitives, pass-through, overflow. Clipped polygons are left out: libraries cut them
 * into other ones. */
#include "program.h"

static GLfloat values[2048];

static void end(const char *what)
{
    GLint count = glRenderMode(GL_RENDER);
    say("%s: %d values", what, count);
    /* Mesa marks no line as one that resets the stipple. */
    for (int i = 0; i < count; i++)
        if (values[i] == GL_LINE_RESET_TOKEN)
            values[i] = GL_LINE_TOKEN;
    for (int i = 0; i < count; i += 8) {
        char line[256] = "";
        for (int j = i; j < i + 8 && j < count; j++)
            sprintf(line + strlen(line), " %.3f", floor(values[j] * 1e3 + 0.51) / 1e3 + 0.0);
        say(" %s", line);
    }
    say_error(what);
}

static void shapes(void)
{
    /* Mesa cuts what has more corners into triangles. */
    for (int mode = GL_POINTS; mode <= GL_TRIANGLE_FAN; mode++) {
        glPassThrough(mode);
        glBegin(mode);
        for (int i = 0; i < 4; i++) {
            glColor4f(0.25f * i, 0.5f, 1 - 0.25f * i, 0.5f);
            glTexCoord4f(i, 2 * i, 3, 1 + i);
            glVertex3f(0.8f * cosf(1.5f * i), 0.8f * sinf(1.5f * i), 0.2f * i);
        }
        glEnd();
    }
}

static void draw(void)
{
    static const GLenum types[] = {GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE, GL_4D_COLOR_TEXTURE};
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 10);
    glTranslatef(0, 0, -2);
    for (int i = 0; i < 5; i++) {
        char name[16];
        sprintf(name, "type %d", i);
        glFeedbackBuffer(2048, types[i], values);
        glRenderMode(GL_FEEDBACK);
        shapes();
        end(name);
    }
    /* Lines are cut at planes, and stippled ones are marked at their reset. */
    glFeedbackBuffer(2048, GL_3D_COLOR, values);
    glRenderMode(GL_FEEDBACK);
    glBegin(GL_LINES);
    glColor3f(1, 0, 0);
    glVertex3f(-9, 0, 0);
    glColor3f(0, 1, 0);
    glVertex3f(9, 0.5f, 0);
    glVertex3f(20, 0, 0);
    glVertex3f(20, 1, 0);
    glEnd();
    end("clipped lines");
    glRenderMode(GL_FEEDBACK);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glShadeModel(GL_FLAT);
    glEnable(GL_CULL_FACE);
    shapes();
    end("lit, flat, culled");
    glDisable(GL_LIGHTING);
    glDisable(GL_CULL_FACE);
    glRenderMode(GL_FEEDBACK);
    glPolygonMode(GL_FRONT, GL_LINE);
    glPolygonMode(GL_BACK, GL_POINT);
    glBegin(GL_TRIANGLES);
    glVertex3f(0, 0, 0);
    glVertex3f(0.5f, 0, 0);
    glVertex3f(0, 0.5f, 0);
    glVertex3f(0, 0, 0);
    glVertex3f(0, 0.5f, 0);
    glVertex3f(0.5f, 0, 0);
    glEnd();
    /* Each edge once, in whatever order. */
    say("lines and points of polygons: %d values", glRenderMode(GL_RENDER));
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glFeedbackBuffer(10, GL_2D, values);
    glRenderMode(GL_FEEDBACK);
    shapes();
    say("overflow: %d", glRenderMode(GL_RENDER));
    glPassThrough(3);
    say_error("elsewhere");
}
