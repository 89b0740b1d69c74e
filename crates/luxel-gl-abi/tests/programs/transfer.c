/* Pixel transfer (3.6.3, 3.6.5): scales, biases and maps for what is drawn, read, copied and made a texture; state and errors. */
#include "program.h"

static unsigned char bytes[16 * 16 * 4];
static const float up[] = {0, 0.31f, 0.91f, 1}, down[] = {1, 0.61f, 0.21f, 0.11f, 0};
static int row = 2;

static void textured(void)
{
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glViewport(42, row, 16, 16);
    glBegin(GL_QUADS);
    glTexCoord2f(0, 0), glVertex2f(-1, -1);
    glTexCoord2f(1, 0), glVertex2f(1, -1);
    glTexCoord2f(1, 1), glVertex2f(1, 1);
    glTexCoord2f(0, 1), glVertex2f(-1, 1);
    glEnd();
    glDisable(GL_TEXTURE_2D);
    glViewport(0, 0, WIDTH, HEIGHT);
}

/* Everything that pixels go through, in a row of its own. */
static void everywhere(const char *what)
{
    unsigned char read[4][4];
    GLboolean mapped;
    glGetBooleanv(GL_MAP_COLOR, &mapped);
    /* Mesa draws through maps by a texture of its own, between their values; it reads by the tables. */
    if (!mapped) {
        glWindowPos2i(2, row);
        glDrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        glWindowPos2i(22, row);
        glCopyPixels(2, 2, 16, 16, GL_COLOR);
        textured();
        glWindowPos2i(82, row);
        glDrawPixels(16, 16, GL_LUMINANCE, GL_UNSIGNED_SHORT, bytes);
    }
    glReadPixels(4, 4, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, read);
    say("%s: %d %d %d %d, %d %d %d %d", what, read[0][0], read[0][1], read[0][2], read[0][3], read[3][0], read[3][1], read[3][2],
        read[3][3]);
    row += 20;
}

static void reset(void)
{
    static const GLenum scales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE, GL_DEPTH_SCALE};
    static const GLenum biases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS, GL_DEPTH_BIAS};
    for (int number = 0; number < 5; number++) {
        glPixelTransferf(scales[number], 1);
        glPixelTransferf(biases[number], 0);
    }
    glPixelTransferi(GL_MAP_COLOR, 0);
}

static void state(void)
{
    static const GLenum names[] = {
        GL_MAP_COLOR,        GL_MAP_STENCIL,      GL_INDEX_SHIFT,      GL_INDEX_OFFSET,     GL_RED_SCALE,        GL_GREEN_SCALE,
        GL_BLUE_SCALE,       GL_ALPHA_SCALE,      GL_DEPTH_SCALE,      GL_RED_BIAS,         GL_GREEN_BIAS,       GL_BLUE_BIAS,
        GL_ALPHA_BIAS,       GL_DEPTH_BIAS,       GL_PIXEL_MAP_I_TO_I_SIZE, GL_PIXEL_MAP_S_TO_S_SIZE, GL_PIXEL_MAP_I_TO_R_SIZE,
        GL_PIXEL_MAP_R_TO_R_SIZE, GL_PIXEL_MAP_A_TO_A_SIZE, GL_MAX_PIXEL_MAP_TABLE};
    for (unsigned number = 0; number < sizeof names / sizeof *names; number++) {
        GLfloat value = -1;
        glGetFloatv(names[number], &value);
        say("state %u: %g", number, value);
    }
}

static void draw(void)
{
    for (int number = 0; number < 1024; number++)
        bytes[number] = (unsigned char)(number * 37 + number / 16 * 11);
    glClearColor(0.2f, 0.1f, 0.3f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    state();
    everywhere("as it is");
    glPixelTransferf(GL_RED_SCALE, 0.5f);
    glPixelTransferf(GL_GREEN_SCALE, 2);
    glPixelTransferf(GL_BLUE_SCALE, -1);
    glPixelTransferf(GL_BLUE_BIAS, 1);
    glPixelTransferf(GL_ALPHA_BIAS, 0.25f);
    everywhere("scaled");
    state();
    reset();
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 4, up);
    glPixelMapfv(GL_PIXEL_MAP_G_TO_G, 5, down);
    glPixelMapusv(GL_PIXEL_MAP_B_TO_B, 3, (const GLushort[]){65535, 0, 30000});
    glPixelMapuiv(GL_PIXEL_MAP_A_TO_A, 2, (const GLuint[]){0xffffffffu, 0x40000000u});
    everywhere("maps that aren't on");
    glPixelTransferi(GL_MAP_COLOR, 1);
    everywhere("mapped");
    glPixelTransferf(GL_RED_SCALE, -1);
    glPixelTransferf(GL_RED_BIAS, 1);
    everywhere("scaled and mapped");
    state();
    glPushAttrib(GL_PIXEL_MODE_BIT);
    reset();
    everywhere("set back");
    glPopAttrib();
    everywhere("restored");
    reset();
    say_error("colours");

    /* Depths and stencil values. */
    float depths[16 * 16];
    for (int number = 0; number < 256; number++)
        depths[number] = (float)number / 255;
    glPixelTransferf(GL_DEPTH_SCALE, 0.5f);
    glPixelTransferf(GL_DEPTH_BIAS, 0.125f);
    glEnable(GL_DEPTH_TEST);
    glColor3f(1, 0.5f, 0);
    glWindowPos2i(150, 2);
    glDrawPixels(16, 16, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    glReadPixels(150, 3, 4, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
    say("depths: %.5f %.5f", depths[0], depths[3]);
    glDisable(GL_DEPTH_TEST);
    glWindowPos2i(150, 32);
    glDrawPixels(16, 16, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, bytes);
    glPixelTransferi(GL_INDEX_SHIFT, 1);
    glPixelTransferi(GL_INDEX_OFFSET, 3);
    unsigned char stencil[2];
    glReadPixels(151, 33, 2, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    say("stencil: %d %d", stencil[0], stencil[1]);
    glPixelTransferi(GL_INDEX_SHIFT, -2);
    glPixelTransferi(GL_MAP_STENCIL, 1);
    glPixelMapfv(GL_PIXEL_MAP_S_TO_S, 4, (const float[]){9, 4, 7, 100});
    glReadPixels(151, 33, 2, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
    say("stencil by a map: %d %d", stencil[0], stencil[1]);
    say_error("depths and stencil values");

    /* Tables, by their queries. */
    float reals[8] = {0};
    GLuint words[8] = {0};
    GLushort shorts[8] = {0};
    glGetPixelMapfv(GL_PIXEL_MAP_G_TO_G, reals);
    say("reals: %g %g %g %g %g", reals[0], reals[1], reals[2], reals[3], reals[4]);
    glGetPixelMapusv(GL_PIXEL_MAP_B_TO_B, shorts);
    say("shorts: %d %d %d", shorts[0], shorts[1], shorts[2]);
    glGetPixelMapuiv(GL_PIXEL_MAP_A_TO_A, words);
    say("words: %u", words[0]);
    glNewList(1, GL_COMPILE);
    glPixelMapfv(GL_PIXEL_MAP_I_TO_R, 2, up + 1);
    glPixelTransferi(GL_INDEX_OFFSET, 77);
    glEndList();
    glGetPixelMapfv(GL_PIXEL_MAP_I_TO_R, reals);
    say("before the list: %g", reals[0]);
    glCallList(1);
    glGetPixelMapfv(GL_PIXEL_MAP_I_TO_R, reals);
    say("after it: %g %g", reals[0], reals[1]);
    state();
    glPixelTransferf(GL_TEXTURE_2D, 1);
    say_error("no name");
    glPixelMapfv(GL_TEXTURE_2D, 2, up);
    say_error("no map");
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 0, up);
    say_error("nothing");
    glPixelMapfv(GL_PIXEL_MAP_R_TO_R, 257, up);
    say_error("too much");
    glPixelMapfv(GL_PIXEL_MAP_I_TO_A, 3, up);
    say_error("no power of two");
    glPixelMapfv(GL_PIXEL_MAP_A_TO_A, 3, up);
    say_error("colours need none");
    glGetPixelMapfv(GL_TEXTURE_2D, reals);
    say_error("no map to get");
}
