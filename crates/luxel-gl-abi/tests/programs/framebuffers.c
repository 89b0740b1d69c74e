/* Framebuffer objects and renderbuffers: completeness, drawing, depths, blits, shadow maps, copies, queries, errors. */
#include "program.h"

static void triangle(float z)
{
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0.2f, 0.1f);
    glVertex3f(-0.9f, -0.9f, z);
    glColor3f(0.1f, 1, 0.2f);
    glVertex3f(0.9f, -0.8f, -z);
    glColor3f(0.2f, 0.1f, 1);
    glVertex3f(-0.2f, 0.9f, z);
    glEnd();
}

static void quad(float x, float y, float side)
{
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; i++) {
        float s = i == 1 || i == 2, t = i > 1;
        glTexCoord2f(s, t);
        glVertex2f(x + side * s, y + side * t);
    }
    glEnd();
}

static GLuint texture_of(GLenum inside, GLenum format, GLenum type, int size)
{
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, inside, size, size, 0, format, type, NULL);
    return name;
}

static void say_status(const char *what)
{
    GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    say("%s: %s", what,
        status == GL_FRAMEBUFFER_COMPLETE                        ? "complete"
        : status == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT         ? "incomplete attachment"
        : status == GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT ? "missing attachment"
                                                                 : "otherwise");
    say_error(what);
}

static void say_pixel(const char *what, int x, int y)
{
    unsigned char pixel[4] = {7, 7, 7, 7};
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    say("%s: %d %d %d %d", what, (pixel[0] + 2) / 4, (pixel[1] + 2) / 4, (pixel[2] + 2) / 4, pixel[3]);
}

static void draw(void)
{
    GLuint framebuffers[3], renderbuffers[3];
    GLint value;
    glClearColor(0.2f, 0.2f, 0.3f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glGenFramebuffers(3, framebuffers);
    glGenRenderbuffers(3, renderbuffers);
    say("before binding: %d %d", glIsFramebuffer(framebuffers[0]), glIsRenderbuffer(renderbuffers[0]));
    say_status("the window");
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
    say_status("nothing attached");

    /* Colours to a texture, depths to a renderbuffer. */
    GLuint color = texture_of(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 64);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    say_status("colours");
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, renderbuffers[0]);
    say_status("an empty renderbuffer");
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 64, 64);
    say_status("with storage");
    static const GLenum of_renderbuffers[] = {GL_RENDERBUFFER_WIDTH, GL_RENDERBUFFER_HEIGHT, GL_RENDERBUFFER_DEPTH_SIZE,
        GL_RENDERBUFFER_RED_SIZE, GL_RENDERBUFFER_STENCIL_SIZE, GL_RENDERBUFFER_SAMPLES};
    for (int i = 0; i < 6; i++) {
        glGetRenderbufferParameteriv(GL_RENDERBUFFER, of_renderbuffers[i], &value);
        say("renderbuffer %#x: %d", of_renderbuffers[i], value);
    }
    glViewport(0, 0, 64, 64);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0.9f, 0.8f, 0.1f, 0.5f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    triangle(0.5f);
    triangle(-0.5f);
    say_pixel("within", 30, 20);
    say_pixel("outside", 2, 60);
    static const GLenum of_attachments[] = {GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME,
        GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL};
    for (int i = 0; i < 3; i++) {
        glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, of_attachments[i], &value);
        say("attachment %d: %d", i, i == 1 ? value == (GLint)color : value);
    }
    glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &value);
    say("no stencil: %d", value);

    /* The texture in the window. */
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_DEPTH_TEST);
    glViewport(0, 0, WIDTH, HEIGHT);
    glColor3f(1, 1, 1);
    glEnable(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, color);
    quad(-0.9f, 0.1f, 0.5f);
    glDisable(GL_TEXTURE_2D);

    /* Blits: whole, a part enlarged, upside down, from and to the window. */
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[0]);
    glBlitFramebuffer(0, 0, 64, 64, 100, 150, 164, 214, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBlitFramebuffer(16, 16, 48, 48, 170, 150, 250, 230, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBlitFramebuffer(0, 0, 64, 64, 64, 140, 4, 80, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    say_error("blits");

    /* A shadow map: depths alone, compared when it is looked up. */
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[1]);
    GLuint depths = texture_of(GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 64);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depths, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    say_status("depths alone");
    glViewport(0, 0, 64, 64);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    triangle(0.3f);
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, WIDTH, HEIGHT);
    glEnable(GL_TEXTURE_2D);
    glColor3f(0.9f, 0.7f, 0.4f);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; i++) {
        float s = i == 1 || i == 2, t = i > 1;
        glTexCoord3f(s, t, 0.7f);
        glVertex2f(-0.4f + 0.6f * s, -0.8f + 0.6f * t);
    }
    glEnd();
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    quad(0.3f, -0.8f, 0.6f);
    glDisable(GL_TEXTURE_2D);
    glDeleteTextures(1, &depths);

    /* Renderbuffers of colours and of packed depths and stencils, read back. */
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[2]);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA, 32, 32);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffers[1]);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers[2]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, 32, 32);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, renderbuffers[2]);
    say_status("renderbuffers");
    glViewport(0, 0, 32, 32);
    glClearStencil(3);
    glClearDepth(0.25);
    glClearColor(0, 0.5f, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glClearDepth(1);
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
    triangle(0.2f);
    glDisable(GL_STENCIL_TEST);
    GLubyte stencil[2];
    GLfloat depth;
    glReadPixels(15, 10, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    glReadPixels(1, 30, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil + 1);
    glReadPixels(1, 30, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    say("stencils %d %d, depth %.4f", stencil[0], stencil[1], depth);
    say_pixel("colours", 15, 10);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, 32, 32, 200, 10, 232, 42, GL_COLOR_BUFFER_BIT, GL_NEAREST);

    /* Mipmaps of what has been drawn; copies into a texture. */
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, WIDTH, HEIGHT);
    glBindTexture(GL_TEXTURE_2D, color);
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    glEnable(GL_TEXTURE_2D);
    glColor3f(1, 1, 1);
    quad(-0.95f, -0.35f, 0.125f);
    glDisable(GL_TEXTURE_2D);

    /* Errors. */
    glBindFramebuffer(0x1234, 0);
    say_error("bad target");
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    say_error("to the window");
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
    glFramebufferTexture2D(GL_FRAMEBUFFER, 0x1234, GL_TEXTURE_2D, color, 0);
    say_error("bad attachment");
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, -1);
    say_error("bad level");
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, 0x1234, renderbuffers[0]);
    say_error("bad renderbuffer target");
    glRenderbufferStorage(GL_RENDERBUFFER, 0x1234, 4, 4);
    say_error("bad format");
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA, -1, 4);
    say_error("bad size");
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, 0);
    say_status("detached");
    glClear(GL_COLOR_BUFFER_BIT);
    say("incomplete: %d", glGetError() == GL_INVALID_FRAMEBUFFER_OPERATION);
    glDeleteFramebuffers(3, framebuffers);
    glDeleteRenderbuffers(3, renderbuffers);
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &value);
    say("bound %d, %d %d", value, glIsFramebuffer(framebuffers[0]), glIsRenderbuffer(renderbuffers[0]));
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &value);
    say("largest %d", value >= 4096);
}
