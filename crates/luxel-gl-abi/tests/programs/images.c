/* Images at the raster position (3.6.4, 4.3.3): glDrawPixels in formats and types, storage, zoom, depths, stencil values, by
 * tests, blending and textures; glCopyPixels; lists, feedback, gets and errors. */
#include "program.h"

static unsigned char bytes[16 * 16 * 4];
static float reals[16 * 16 * 4];

static void at(int x, int y)
{
    glWindowPos3f(x, y, 0.5f);
}

static void formats(void)
{
    static const GLenum names[] = {GL_RGBA, GL_RGB, GL_BGR, GL_BGRA, GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
    static const GLenum types[] = {GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT};
    static const GLenum packed[][2] = {
        {GL_RGB, GL_UNSIGNED_BYTE_3_3_2},        {GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV},
        {GL_RGB, GL_UNSIGNED_SHORT_5_6_5},       {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4},
        {GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV}, {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8},
        {GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV},  {GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV}};
    for (int format = 0; format < 10; format++)
        for (int type = 0; type < 7; type++) {
            at(2 + 10 * type, 2 + 10 * format);
            glDrawPixels(8, 8, names[format], types[type], types[type] == GL_FLOAT ? (void *)reals : (void *)bytes);
        }
    for (int number = 0; number < 8; number++) {
        at(80, 2 + 10 * number);
        glDrawPixels(8, 8, packed[number][0], packed[number][1], bytes);
    }
}

static void draw(void)
{
    for (int number = 0; number < 1024; number++) {
        bytes[number] = (unsigned char)(number * 37 + number / 16 * 11);
        reals[number] = (float)(number * 7 % 64) / 48 - 0.1f;
    }
    GLfloat zoom[2];
    glGetFloatv(GL_ZOOM_X, &zoom[0]);
    glGetFloatv(GL_ZOOM_Y, &zoom[1]);
    say("zoom: %g %g", zoom[0], zoom[1]);
    glClearColor(0.2f, 0.1f, 0.3f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    formats();
    say_error("formats");

    /* Storage. */
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 16);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 2);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
    at(96, 2);
    glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_UNPACK_SWAP_BYTES, 1);
    at(96, 12);
    glDrawPixels(8, 8, GL_RGB, GL_UNSIGNED_SHORT, bytes);
    glPixelStorei(GL_UNPACK_SWAP_BYTES, 0);

    /* Zoom, both ways, and beyond the window; no centre on an edge, where Mesa differs from axis to axis. */
    glPixelZoom(3, 2);
    at(96, 24);
    glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glPixelZoom(-2, -3);
    at(140, 70);
    glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glPixelZoom(0.6f, 1.6f);
    at(96, 74);
    glDrawPixels(16, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glPixelZoom(4, 4);
    at(230, 2);
    glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glRasterPos2f(-1, -1);
    glBitmap(0, 0, 0, 0, -10, 100, NULL);
    glDrawPixels(8, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glPixelZoom(1, 1);

    /* By fragment operations. */
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    at(150, 2);
    glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glDisable(GL_BLEND);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.503f);
    at(170, 2);
    glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glDisable(GL_ALPHA_TEST);
    glColorMask(1, 0, 1, 1);
    at(190, 2);
    glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glColorMask(1, 1, 1, 1);
    glEnable(GL_SCISSOR_TEST);
    glScissor(212, 4, 10, 9);
    at(210, 2);
    glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glDisable(GL_SCISSOR_TEST);

    /* Depths have the raster position's colour; then what they let through. */
    glEnable(GL_DEPTH_TEST);
    glColor4f(0.9f, 0.6f, 0.1f, 1);
    glPixelZoom(3, 3);
    at(150, 60);
    glDrawPixels(16, 16, GL_DEPTH_COMPONENT, GL_FLOAT, reals);
    glPixelZoom(1, 1);
    glColor4f(0.1f, 0.9f, 0.9f, 1);
    glRectf(0.1f, -0.6f, 0.6f, -0.1f);
    glDisable(GL_DEPTH_TEST);

    /* Stencil values; then where they are odd. */
    glStencilMask(0x7f);
    glPixelZoom(2, 3);
    at(202, 60);
    glDrawPixels(16, 16, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes);
    glStencilMask(0xff);
    glPixelZoom(1, 1);
    unsigned char stencil[8]; /* Each row begins at a multiple of four. */
    glReadPixels(210, 70, 2, 2, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    say("stencil: %d %d", stencil[0], stencil[1]);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_EQUAL, 1, 1);
    glColor4f(0.1f, 0.1f, 0.9f, 1);
    glRectf(0.5f, -0.6f, 1, -0.1f);
    glDisable(GL_STENCIL_TEST);
    say_error("images");

    /* Copies. */
    at(2, 120);
    glCopyPixels(2, 2, 88, 80, GL_COLOR);
    glPixelZoom(-1, 0.6f);
    at(250, 120);
    glCopyPixels(90, 2, 100, 80, GL_COLOR);
    glPixelZoom(1, 1);
    at(100, 170);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    glCopyPixels(150, 60, 48, 48, GL_DEPTH);
    glDepthFunc(GL_LESS);
    at(160, 170);
    glDisable(GL_DEPTH_TEST);
    glCopyPixels(202, 60, 32, 48, GL_STENCIL);
    glEnable(GL_STENCIL_TEST);
    glColor4f(1, 1, 1, 1);
    glRectf(-1, 0.3f, 1, 0.8f);
    glDisable(GL_STENCIL_TEST);
    say_error("copies");

    /* Lists keep pixels and storage, but not the zoom. */
    unsigned char own[4 * 4 * 4];
    memset(own, 200, sizeof own);
    glNewList(1, GL_COMPILE);
    glDrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, own);
    glPixelZoom(2, 2);
    glCopyPixels(2, 2, 8, 8, GL_COLOR);
    glEndList();
    memset(own, 0, sizeof own);
    at(10, 230);
    glPixelZoom(5, 3);
    glCallList(1);
    glGetFloatv(GL_ZOOM_X, &zoom[0]);
    say("zoom after a list: %g", zoom[0]);
    glPushAttrib(GL_PIXEL_MODE_BIT);
    glPixelZoom(9, 9);
    glPopAttrib();
    glGetFloatv(GL_ZOOM_Y, &zoom[1]);
    say("zoom after glPopAttrib: %g", zoom[1]);
    glPixelZoom(1, 1);

    float tokens[32] = {0};
    glFeedbackBuffer(32, GL_2D, tokens);
    glRenderMode(GL_FEEDBACK);
    at(3, 4);
    glDrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, own);
    glCopyPixels(0, 0, 4, 4, GL_DEPTH);
    say("feedback: %d", glRenderMode(GL_RENDER));
    say("%g %g %g, %g %g %g", tokens[0], tokens[1], tokens[2], tokens[3], tokens[4], tokens[5]);

    glDrawPixels(-1, 4, GL_RGBA, GL_UNSIGNED_BYTE, own);
    say_error("less than no column");
    glDrawPixels(4, 4, GL_TEXTURE_2D, GL_UNSIGNED_BYTE, own);
    say_error("no format");
    glDrawPixels(4, 4, GL_RGBA, GL_TEXTURE_2D, own);
    say_error("no type");
    glDrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, own);
    say_error("formats that don't match");
    glCopyPixels(0, 0, 4, 4, GL_RGBA);
    say_error("no buffer");
    glCopyPixels(0, 0, 4, -4, GL_COLOR);
    say_error("less than no row");
    glBegin(GL_POINTS);
    glPixelZoom(2, 2);
    glCopyPixels(0, 0, 4, 4, GL_COLOR);
    glEnd();
    say_error("within glBegin");
}
