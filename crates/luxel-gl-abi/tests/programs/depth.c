/* Depth (4.1.5, 2.11.1, 3.5.5): functions, ranges, masks, offsets, and what is read back. */
#include "program.h"

static void square(float x, float y, float side, float z0, float z1)
{
    glBegin(GL_QUADS);
    glVertex3f(x, y, z0);
    glVertex3f(x + side, y, z1);
    glVertex3f(x + side, y + side, z1);
    glVertex3f(x, y + side, z0);
    glEnd();
}

static void draw(void)
{
    glClearColor(0, 0, 0.2f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, 8, 0, 8, 1, -1);
    glEnable(GL_DEPTH_TEST);
    for (int i = 0; i < 8; i++) {
        glDepthFunc(GL_ALWAYS);
        glColor3f(0.4f, 0.4f, 0.4f);
        square(i, 0, 0.9f, 0, 0);
        glDepthFunc(GL_NEVER + i);
        glColor3f(1, 0.2f, 0.1f);
        square(i, 0, 0.45f, -0.5f, 0.5f);
        glColor3f(0.2f, 1, 0.1f);
        square(i + 0.45f, 0.45f, 0.45f, 0, 0);
    }
    glDepthFunc(GL_LESS);
    static const double ranges[][2] = {{0, 1}, {1, 0}, {0.25, 0.75}, {0.5, 0.5}, {-1, 2}, {0, 0.1}, {0.9, 1}, {0.3, 0.2}};
    for (int i = 0; i < 8; i++) {
        glDepthRange(ranges[i][0], ranges[i][1]);
        glColor3f(0.5f, 0.1f * i, 1);
        square(i, 1, 0.9f, -0.8f, 0.8f);
    }
    glDepthRange(0, 1);
    for (int i = 0; i < 8; i++) {
        glDepthMask(i % 2);
        glColor3f(1, 1, 0.1f * i);
        square(i, 2, 0.9f, -0.5f, -0.5f);
        glDepthMask(1);
        glColor3f(0.3f, 0.1f * i, 0.5f);
        square(i, 2, 0.6f, 0, 0);
    }
    static const float offsets[][2] = {{0, 0}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}, {2, 8}, {-1, -3}, {0, 100}};
    for (int i = 0; i < 8; i++) {
        glColor3f(0.8f, 0.8f, 0.8f);
        square(i, 3, 0.9f, -0.3f, 0.4f);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(offsets[i][0], offsets[i][1]);
        glColor3f(0.9f, 0.3f, 0.05f * i);
        square(i, 3, 0.9f, -0.3f, 0.4f);
        glDisable(GL_POLYGON_OFFSET_FILL);
    }
    /* Clears through the scissor, and with the mask off. */
    glEnable(GL_SCISSOR_TEST);
    for (int i = 0; i < 8; i++) {
        glScissor(i * 32 + 3, 4 * 32 + 3, 20 + i, 24);
        glClearDepth(i / 7.0);
        glDepthMask(i != 3);
        glClear(GL_DEPTH_BUFFER_BIT);
        glDepthMask(1);
    }
    glDisable(GL_SCISSOR_TEST);
    for (int i = 0; i < 8; i++) {
        glColor3f(0.3f, 0.9f, 0.9f - 0.1f * i);
        square(i, 4, 1, -1, 1);
    }
    /* A depth test without depths from the test writes none. */
    glDisable(GL_DEPTH_TEST);
    glColor3f(1, 0.5f, 0.5f);
    square(1, 5, 2, -1, 1);
    glEnable(GL_DEPTH_TEST);
    glColor3f(0.5f, 1, 0.5f);
    square(2, 5.5f, 2, 0.5f, 0.9f);
    for (int y = 8; y < 200; y += 16) {
        float depths[16];
        char line[256] = "";
        for (int x = 0; x < 16; x++)
            glReadPixels(x * 16 + 7, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depths + x);
        for (int x = 0; x < 16; x++)
            sprintf(line + strlen(line), " %.4f", floor(depths[x] * 1e4 + 0.51) / 1e4);
        say("%d:%s", y, line);
    }
    unsigned words[4];
    unsigned short shorts[4];
    glReadPixels(100, 20, 4, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, words);
    glReadPixels(100, 20, 4, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, shorts);
    say("integers %u %u", words[0] >> 16, shorts[0]);
    say_error("depth");
}
