/* Selection (5.2): names, depths, overflow, and which primitives hit. */
#include "program.h"

static GLuint buffer[512];

static void begin(int size)
{
    memset(buffer, 0, sizeof buffer);
    glSelectBuffer(size, buffer);
    glRenderMode(GL_SELECT);
    glInitNames();
}

/* Depths to four decimals: their last bits are the library's. */
static void end(const char *what, int size)
{
    GLint hits = glRenderMode(GL_RENDER);
    int at = 0;
    say("%s: %d hits", what, hits);
    for (int hit = 0; (hits < 0 || hit < hits) && at + 3 <= size && hit < 40; hit++) {
        int count = buffer[at];
        char line[256] = "";
        if (at + 3 + count > size)
            break;
        sprintf(line, "  %.4f to %.4f:", buffer[at + 1] / 4294967295.0, buffer[at + 2] / 4294967295.0);
        for (int i = 0; i < count && i < 20; i++)
            sprintf(line + strlen(line), " %u", buffer[at + 3 + i]);
        say("%s", line);
        at += 3 + count;
        if (hits < 0 && !buffer[at])
            break;
    }
    say_error(what);
}

static void quad(float x, float y, float z, float side)
{
    glBegin(GL_QUADS);
    glVertex3f(x, y, z);
    glVertex3f(x + side, y, z);
    glVertex3f(x + side, y + side, z);
    glVertex3f(x, y + side, z);
    glEnd();
}

static void draw(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    say("without a buffer: %d", glRenderMode(GL_SELECT));
    say_error("without a buffer");
    glRenderMode(GL_RENDER);

    begin(512);
    quad(0, 0, 0, 0.5f);
    end("no names", 512);

    begin(512);
    glPushName(1);
    quad(0, 0, 0.5f, 0.5f);
    glLoadName(2);
    quad(5, 0, 0, 0.5f);
    glLoadName(3);
    quad(0, 0, -0.5f, 0.5f);
    quad(0, 0, 0.25f, 0.5f);
    glPushName(4);
    glPushName(5);
    quad(0, 0, -2, 0.5f);
    quad(0.9f, 0.9f, 0.9f, 5);
    glPopName();
    quad(0, 0, 0, 0.5f);
    glPopName();
    glPopName();
    quad(0, 0, 0.75f, 0.5f);
    end("names", 512);

    /* Hits are noted at changes of names only, and in order. */
    begin(512);
    glPushName(7);
    quad(0, 0, 0.5f, 0.5f);
    glLoadName(7);
    quad(0, 0, -0.5f, 0.5f);
    glInitNames();
    quad(0, 0, 0.1f, 0.5f);
    end("changes", 512);

    /* Each kind of primitive. */
    begin(512);
    glPushName(0);
    for (int mode = GL_POINTS; mode <= GL_POLYGON; mode++) {
        glLoadName(mode);
        glBegin(mode);
        for (int i = 0; i < 8; i++)
            glVertex3f(0.8f * cosf(i), 0.8f * sinf(i), 0.1f * mode - 0.5f);
        glEnd();
        glLoadName(100 + mode);
        glBegin(mode);
        for (int i = 0; i < 8; i++)
            glVertex3f(3 + cosf(i), sinf(i), 0);
        glEnd();
    }
    end("kinds", 512);

    /* Culled faces, clipped ones, planes of the user, raster positions. */
    begin(512);
    glPushName(1);
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CW);
    quad(0, 0, 0, 0.5f);
    glFrontFace(GL_CCW);
    glLoadName(2);
    quad(0, 0, 0, 0.5f);
    glDisable(GL_CULL_FACE);
    glLoadName(3);
    glClipPlane(GL_CLIP_PLANE0, (const double[]){1, 0, 0, 0});
    glEnable(GL_CLIP_PLANE0);
    quad(-0.9f, 0, 0, 0.5f);
    glLoadName(4);
    quad(-0.25f, 0, 0, 0.5f);
    glDisable(GL_CLIP_PLANE0);
    glLoadName(5);
    glRasterPos3f(0, 0, 0.5f);
    glLoadName(6);
    glRasterPos3f(0, 0, 1.5f);
    glLoadName(7);
    glBegin(GL_TRIANGLES);
    glVertex3f(-3, -3, 0.9f);
    glVertex3f(3, -3, -2);
    glVertex3f(0, 3, 0.5f);
    glEnd();
    glLoadName(8);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    quad(-0.5f, 0, 0, 3);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    end("what is there", 512);

    /* Overflow: -1, with whole records in the buffer. */
    begin(9);
    glPushName(1);
    for (int i = 0; i < 5; i++) {
        glLoadName(i);
        quad(0, 0, 0.2f * i, 0.5f);
    }
    GLint hits = glRenderMode(GL_RENDER);
    say("overflow: %d, first %u %u", hits, buffer[0], buffer[3]);

    /* The name stack at its limits. */
    begin(512);
    for (int i = 0; i < 64; i++)
        glPushName(i);
    say_error("64 names");
    glPushName(64);
    say_error("65 names");
    GLint depth;
    glGetIntegerv(GL_NAME_STACK_DEPTH, &depth);
    say("depth %d", depth);
    for (int i = 0; i < 64; i++)
        glPopName();
    say_error("popped");
    glPopName();
    say_error("popped once more");
    glRenderMode(GL_RENDER);
    glLoadName(5);
    glPushName(6);
    say_error("names elsewhere are ignored");

    /* Nothing has been drawn. */
    unsigned char pixel[4];
    glReadPixels(128, 128, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    say("pixel %d %d %d %d", pixel[0], pixel[1], pixel[2], pixel[3]);
}
