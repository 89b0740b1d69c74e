/* Several samples a pixel: storage, completeness, edges, depths, blending, alpha as coverage, resolving, errors. */
#include "program.h"

enum { SIDE = 64 };

static void star(float angle, float z)
{
    glPushMatrix();
    glRotatef(angle, 0, 0, 1);
    glBegin(GL_TRIANGLE_FAN);
    glVertex3f(0, 0, z);
    for (int i = 0; i <= 10; i++) {
        float a = i * 0.6283185f, r = i % 2 ? 0.35f : 0.9f;
        glVertex3f(r * cosf(a), r * sinf(a), -z);
    }
    glEnd();
    glPopMatrix();
}

static void say_status(const char *what)
{
    GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    say("%s: %s", what,
        status == GL_FRAMEBUFFER_COMPLETE                 ? "complete"
        : status == GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE ? "incomplete samples"
                                                          : "otherwise");
    say_error(what);
}

/* Puts the picture of several samples into a place of the window. */
static void resolve(GLuint from, int column, int row)
{
    int x = column * SIDE, y = row * SIDE;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, SIDE, SIDE, x, y, x + SIDE, y + SIDE, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, from);
}

static void clear(void) { glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT); }

static void draw(void)
{
    GLuint framebuffers[2], renderbuffers[3];
    GLint value;
    glClearColor(0.2f, 0.2f, 0.3f, 1);
    clear();
    glGetIntegerv(GL_MAX_SAMPLES, &value);
    say("samples at most: %d", value);
    glGetIntegerv(GL_SAMPLES, &value);
    say("samples of the window: %d", value);
    glGenFramebuffers(2, framebuffers);
    glGenRenderbuffers(3, renderbuffers);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers[0]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, SIDE, SIDE);
    say_error("storage");
    glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &value);
    say("samples of the renderbuffer: %d", value);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[0]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffers[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, SIDE, SIDE);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, renderbuffers[1]);
    say_status("one sample and several");
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_DEPTH24_STENCIL8, SIDE, SIDE);
    say_status("several");
    glGetIntegerv(GL_SAMPLE_BUFFERS, &value);
    say("sample buffers: %d", value);
    glGetIntegerv(GL_SAMPLES, &value);
    say("samples: %d", value);
    glViewport(0, 0, SIDE, SIDE);

    /* Two stars through one another. */
    glEnable(GL_DEPTH_TEST);
    clear();
    glColor3f(1, 0.6f, 0.1f);
    star(10, 0.5f);
    glColor3f(0.1f, 0.5f, 1);
    star(30, -0.3f);
    resolve(framebuffers[0], 0, 0);

    /* Without GL_MULTISAMPLE all samples are alike. */
    glDisable(GL_MULTISAMPLE);
    clear();
    star(10, 0.5f);
    resolve(framebuffers[0], 1, 0);
    glEnable(GL_MULTISAMPLE);

    /* Blended. */
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_DEPTH_TEST);
    clear();
    for (int i = 0; i < 5; i++) {
        glColor4f(0.2f * i, 1 - 0.2f * i, 0.4f, 0.4f);
        star(9 * i, 0);
    }
    resolve(framebuffers[0], 2, 0);
    glDisable(GL_BLEND);

    /* Where the stencil has one star, the other isn't drawn. */
    glEnable(GL_STENCIL_TEST);
    clear();
    glStencilFunc(GL_ALWAYS, 1, 255);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    glColorMask(0, 0, 0, 0);
    star(20, 0);
    glColorMask(1, 1, 1, 1);
    glStencilFunc(GL_NOTEQUAL, 1, 255);
    glColor3f(0.9f, 0.9f, 0.2f);
    star(0, 0);
    glDisable(GL_STENCIL_TEST);
    resolve(framebuffers[0], 3, 0);

    /* A part of the samples, and the other part. */
    glEnable(GL_SAMPLE_COVERAGE);
    clear();
    glSampleCoverage(0.5f, GL_FALSE);
    glColor3f(1, 1, 1);
    glRectf(-0.9f, -0.9f, 0.1f, 0.1f);
    glSampleCoverage(0.5f, GL_TRUE);
    glColor3f(0, 1, 0);
    glRectf(-0.9f, -0.9f, 0.1f, 0.1f);
    glSampleCoverage(1, GL_TRUE);
    glRectf(0.2f, 0.2f, 0.9f, 0.9f);
    glSampleCoverage(0.25f, GL_FALSE);
    GLfloat part;
    glGetFloatv(GL_SAMPLE_COVERAGE_VALUE, &part);
    glGetIntegerv(GL_SAMPLE_COVERAGE_INVERT, &value);
    say("coverage: %.2f %d", part, value);
    glDisable(GL_SAMPLE_COVERAGE);
    resolve(framebuffers[0], 0, 1);

    /* Alpha as coverage: all and nothing. */
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    clear();
    glColor4f(1, 0.2f, 0.6f, 1);
    star(15, 0);
    glColor4f(1, 1, 1, 0);
    glRectf(-1, -1, 1, 1);
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    resolve(framebuffers[0], 1, 1);

    /* Texture, fog and specular light. */
    static const unsigned char checks[2][2][4] = {{{255, 80, 80, 255}, {80, 255, 80, 255}}, {{80, 80, 255, 255}, {255, 255, 80, 255}}};
    GLuint texture;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, checks);
    glEnable(GL_TEXTURE_2D);
    clear();
    glColor3f(1, 1, 1);
    glBegin(GL_QUADS);
    for (int i = 0; i < 4; i++) {
        float s = i == 1 || i == 2, t = i > 1;
        glTexCoord2f(s, t);
        glVertex2f(1.5f * s - 0.8f + 0.2f * t, 1.5f * t - 0.7f);
    }
    glEnd();
    glDisable(GL_TEXTURE_2D);
    resolve(framebuffers[0], 2, 1);

    /* What several samples refuse. */
    unsigned char pixel[4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    say_error("reading several samples");
    glBindTexture(GL_TEXTURE_2D, texture);
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 2, 2, 0);
    say_error("copying several samples to a texture");
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, SIDE, SIDE, 0, 0, SIDE / 2, SIDE, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    say_error("resolving and scaling");

    /* Samples are copied as they are between framebuffers of as many. */
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers[2]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, SIDE, SIDE);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers[1]);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffers[2]);
    glClear(GL_COLOR_BUFFER_BIT);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[0]);
    glBlitFramebuffer(0, 0, SIDE, SIDE, 0, 0, SIDE, SIDE, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    say_error("copying samples");
    resolve(framebuffers[1], 3, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    say_error("samples");
}
