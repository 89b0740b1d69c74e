/* Depth textures: their modes, and comparisons (3.8.14); depths copied from the framebuffer. */
#include "texture.h"

static float depths[32 * 32];

static void cover(float s, float t, float r_left, float r_right)
{
    glBegin(GL_QUADS);
    glColor4f(1, 0.8f, 0.6f, 0.7f);
    glTexCoord3f(0, 0, r_left);
    glVertex2f(0, 0);
    glTexCoord3f(s, 0, r_right);
    glVertex2f(1, 0);
    glTexCoord3f(s, t, r_right);
    glVertex2f(1, 1);
    glTexCoord3f(0, t, r_left);
    glVertex2f(0, 1);
    glEnd();
}

static void draw(void)
{
    static const GLint modes[] = {GL_LUMINANCE, GL_INTENSITY, GL_ALPHA};
    static const GLint formats[] = {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32};
    int cell = 0;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int y = 0; y < 32; y++)
        for (int x = 0; x < 32; x++)
            depths[y * 32 + x] = (float)(y * 32 + x) / 1023;
    glEnable(GL_TEXTURE_2D);
    filter(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
    for (int mode = 0; mode < 3; mode++)
        for (int format = 0; format < 3; format++) {
            look_at_cell(cell++);
            glTexImage2D(GL_TEXTURE_2D, 0, formats[format], 32, 32, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths);
            glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, modes[mode]);
            cover(1, 1, 0, 0);
        }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    for (int func = 0; func < 8; func++)
        for (int mode = 0; mode < 3; mode++) {
            look_at_cell(cell++);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_NEVER + func);
            glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, modes[mode]);
            cover(1, 1, 0.1234f, 0.8765f);
        }
    /* A shadow from the depths of a picture of two triangles. */
    glDisable(GL_TEXTURE_2D);
    glEnable(GL_DEPTH_TEST);
    look_at_cell(40);
    glBegin(GL_TRIANGLES);
    glColor3f(0.5f, 0.5f, 0.2f);
    glVertex3f(0.1f, 0.1f, 0.5f);
    glVertex3f(0.9f, 0.2f, -0.5f);
    glVertex3f(0.5f, 0.9f, 0);
    glVertex3f(0, 0.8f, 0.9f);
    glVertex3f(0.3f, 0.4f, 0.9f);
    glVertex3f(0.7f, 0.9f, 0.9f);
    glEnd();
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 160, 32, 32, 0);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_LUMINANCE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    look_at_cell(41);
    cover(1, 1, 0.4f, 0.6f);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    look_at_cell(42);
    cover(1, 1, 0, 0);
    /* Comparisons are filtered, not depths. */
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
    filter(GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
    look_at_cell(43);
    cover(0.3f, 0.3f, 0.5f, 0.9f);
    GLfloat back[32 * 32];
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, back);
    say("depth %.4f %.4f", back[0], back[16 * 32 + 16]);
}
