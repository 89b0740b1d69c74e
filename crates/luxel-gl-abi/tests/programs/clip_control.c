/* The clip volume's coordinates (ARB_clip_control) and depths as floats (ARB_depth_buffer_float): planes, faces, fog, points
 * and lines upside down, clipping, reversed depths, feedback, selection, state, errors. */
#include "program.h"

enum { SIDE = 64 };

static PFNGLCLIPCONTROLPROC clip_control;

static void fan(float turn, float near, float far)
{
    glBegin(GL_TRIANGLE_FAN);
    glColor3f(1, 1, 1);
    glVertex3f(0.1f, 0.05f, near);
    for (int i = 0; i <= 7; i++) {
        float a = turn + i * 0.897597901f;
        glColor3f(0.5f + 0.5f * cosf(a), 0.5f + 0.5f * sinf(a), 0.3f);
        glVertex3f(0.9f * cosf(a), 0.8f * sinf(a), i % 2 ? far : near);
    }
    glEnd();
}

/* Draws into a place of the window. */
static void at(int column, int row)
{
    glViewport(column * SIDE, row * SIDE, SIDE, SIDE);
    glScissor(column * SIDE, row * SIDE, SIDE, SIDE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

static void all_kinds(void)
{
    fan(0.2f, 0.2f, 0.7f);
    glPointSize(5);
    glLineWidth(3);
    glColor3f(1, 1, 0);
    glBegin(GL_LINE_STRIP);
    glVertex3f(-0.9f, -0.8f, 0.1f);
    glVertex3f(0.8f, -0.55f, 0.9f);
    glVertex3f(0.5f, 0.9f, 0.3f);
    glEnd();
    glBegin(GL_POINTS);
    glVertex3f(-0.6f, 0.6f, 0.1f);
    glVertex3f(0.6f, -0.2f, 0.05f);
    glEnd();
    glRasterPos3f(-0.9f, 0.3f, 0.1f);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    static const GLubyte arrow[8] = {0x18, 0x3c, 0x7e, 0xff, 0x18, 0x18, 0x18, 0x18};
    glBitmap(8, 8, 0, 0, 0, 0, arrow);
}

static void say_state(void)
{
    GLint origin, depth;
    glGetIntegerv(GL_CLIP_ORIGIN, &origin);
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &depth);
    say("origin %#x, depths %#x", origin, depth);
}

static void say_depths(const char *what)
{
    GLfloat depths[2];
    glReadPixels(20, 33, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depths[0]);
    glReadPixels(40, 11, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depths[1]);
    say("%s: depths %.4f %.4f", what, depths[0], depths[1]);
}

static void floats(void)
{
    GLuint framebuffer, renderbuffers[2];
    GLint value;
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(2, renderbuffers);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, SIDE, SIDE);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffers[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH32F_STENCIL8, SIDE, SIDE);
    say_error("storage of floats");
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &value);
    say("bits of a depth: %d", value);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, renderbuffers[1]);
    say("complete: %d", glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    glDisable(GL_SCISSOR_TEST);
    glViewport(0, 0, SIDE, SIDE);

    /* The far plane is at 0: planes that are a part of 10^-8 apart. */
    glClearDepth(0);
    glClearStencil(9);
    glDepthFunc(GL_GREATER);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glColor3f(1, 0.5f, 0);
    glBegin(GL_QUADS);
    glVertex3f(-0.8f, -0.8f, 1e-8f);
    glVertex3f(0.8f, -0.8f, 3e-8f);
    glVertex3f(0.8f, 0.8f, 3e-8f);
    glVertex3f(-0.8f, 0.8f, 1e-8f);
    glEnd();
    glColor3f(0, 0.5f, 1);
    glBegin(GL_TRIANGLES);
    glVertex3f(-0.7f, -0.9f, 2.01e-8f);
    glVertex3f(0.7f, -0.9f, 2.01e-8f);
    glVertex3f(0, 0.95f, 2.01e-8f);
    glEnd();
    struct { GLfloat depth; GLuint stencil; } both;
    glReadPixels(10, 32, 1, 1, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, &both);
    say_error("both");
    say("depth 1e8 times %.4f, stencil %u", 1e8 * both.depth, both.stencil & 255);

    /* An offset of last places. */
    GLfloat plain, moved;
    glDepthFunc(GL_ALWAYS);
    glPolygonOffset(0, 16);
    for (int on = 0; on < 2; on++) {
        (on ? glEnable : glDisable)(GL_POLYGON_OFFSET_FILL);
        glBegin(GL_QUADS);
        glVertex3f(0.8f, 0.8f, 0.25f);
        glVertex3f(1, 0.8f, 0.25f);
        glVertex3f(1, 1, 0.25f);
        glVertex3f(0.8f, 1, 0.25f);
        glEnd();
        glReadPixels(60, 60, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, on ? &moved : &plain);
    }
    glDisable(GL_POLYGON_OFFSET_FILL);
    say("moved by %.1f places", (moved - plain) * 33554432.0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, SIDE, SIDE, 2 * SIDE, 2 * SIDE, 3 * SIDE, 3 * SIDE, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBlitFramebuffer(0, 0, SIDE, SIDE, 0, 0, SIDE, SIDE, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    say_error("floats to steps");
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(2, renderbuffers);

    /* Textures, which are read and compared. */
    GLuint texture;
    GLfloat texel = 0.3f;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &texel);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE, &value);
    texel = 0;
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &texel);
    say("texel %.9f of %d bits", texel, value);
    glDeleteTextures(1, &texture);
    say_error("texture");
}

static void draw(void)
{
    static const GLenum origins[] = {GL_LOWER_LEFT, GL_UPPER_LEFT};
    static const GLenum depths[] = {GL_NEGATIVE_ONE_TO_ONE, GL_ZERO_TO_ONE};
    clip_control = (PFNGLCLIPCONTROLPROC)OSMesaGetProcAddress("glClipControl");
    if (!clip_control)
        die("there is no glClipControl");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);
    glClearColor(0.2f, 0.2f, 0.3f, 1);
    say_state();
    for (int i = 0; i < 4; i++) {
        clip_control(origins[i & 1], depths[i >> 1]);
        say_state();
        at(i, 0);
        all_kinds();
        if (i == 0)
            say_depths("as always");
        /* Culled, and cut by all planes. */
        at(i, 1);
        glEnable(GL_CULL_FACE);
        fan(0.5f, -1.5f, 1.8f);
        glDisable(GL_CULL_FACE);
        at(i, 2);
        glScalef(1.6f, 1.4f, 1);
        glEnable(GL_CULL_FACE);
        glCullFace(GL_FRONT);
        glFrontFace(GL_CW);
        fan(0.9f, 0.4f, -0.9f);
        glFrontFace(GL_CCW);
        glCullFace(GL_BACK);
        glDisable(GL_CULL_FACE);
        glLoadIdentity();
    }
    clip_control(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    at(0, 0);
    fan(0.2f, 0.2f, 0.7f);
    say_depths("from 0 to 1");
    glDepthRange(1, 0.5);
    at(0, 0);
    glClearDepth(0);
    glDepthFunc(GL_GEQUAL);
    glClear(GL_DEPTH_BUFFER_BIT);
    fan(0.2f, 0.2f, 0.7f);
    say_depths("within 1 to 0.5");
    glDepthRange(0, 1);
    glDepthFunc(GL_LESS);
    glClearDepth(1);

    GLfloat fed[32];
    clip_control(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glViewport(0, 0, 100, 50);
    glFeedbackBuffer(32, GL_3D, fed);
    glRenderMode(GL_FEEDBACK);
    glBegin(GL_LINES);
    glVertex3f(0.5f, 0.5f, -0.5f);
    glVertex3f(-0.5f, 0.25f, 0.5f);
    glEnd();
    int count = glRenderMode(GL_RENDER);
    /* The first word is the token: a line that resets its stipple, which Mesa leaves out. */
    for (int i = 1; i < count; i++)
        say("fed back: %.3f", fed[i]);
    GLuint hits[16];
    glSelectBuffer(16, hits);
    glRenderMode(GL_SELECT);
    glBegin(GL_LINES);
    glVertex3f(0.5f, 0.5f, 0.25f);
    glVertex3f(-0.5f, 0.25f, 0.5f);
    glEnd();
    count = glRenderMode(GL_RENDER);
    say("%d hit: depths %.4f to %.4f", count, hits[1] / 4294967295.0, hits[2] / 4294967295.0);

    clip_control(GL_LOWER_LEFT, 0);
    say_error("no depths");
    clip_control(0, GL_ZERO_TO_ONE);
    say_error("no origin");
    glPushAttrib(GL_TRANSFORM_BIT);
    glNewList(1, GL_COMPILE);
    clip_control(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glEndList();
    say_state();
    glCallList(1);
    say_state();
    glPopAttrib();
    say_state();
    glBegin(GL_POINTS);
    clip_control(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glEnd();
    say_error("within glBegin");
    clip_control(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    floats();
}
