/* Wrapping, filters, levels of detail, borders (3.8.7 to 3.8.9). */
#include "texture.h"

static unsigned char texels[64 * 64][4];

/* Levels of one colour each, so that the picture shows which one was taken. They differ by little: libraries may take the
 * logarithm of the level by tables, to two digits. */
static void levels(void)
{
    for (int level = 0; level < 7; level++) {
        int side = 64 >> level;
        for (int at = 0; at < side * side; at++) {
            texels[at][0] = (unsigned char)(20 + 32 * level);
            texels[at][1] = (unsigned char)(240 - 32 * level);
            texels[at][2] = (unsigned char)(level & 1 ? 120 : 90);
            texels[at][3] = 255;
        }
        glTexImage2D(GL_TEXTURE_2D, level, GL_RGBA, side, side, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    }
}

static void draw(void)
{
    static const GLint wraps[] = {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT};
    static const GLenum filters[] = {GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
                                     GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR};
    const GLfloat border[] = {1, 0, 1, 0.5f};
    GLuint names[2];
    int cell = 0;
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glGenTextures(2, names);
    glBindTexture(GL_TEXTURE_2D, names[0]);
    paint(texels, 4, 8, 0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
    for (int wrap = 0; wrap < 5; wrap++)
        for (int linear = 0; linear < 2; linear++) {
            look_at_cell(cell++);
            filter(GL_TEXTURE_2D, filters[linear], filters[linear]);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wraps[wrap]);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wraps[(wrap + linear) % 5]);
            square(-1.03f, 2.04f);
        }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    /* An odd size. */
    paint(texels, 5, 3, 0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 5, 3, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    look_at_cell(cell++);
    square(-0.52f, 1.51f);
    /* Each filter at several reductions. */
    glBindTexture(GL_TEXTURE_2D, names[1]);
    levels();
    for (int number = 0; number < 6; number++)
        for (int size = 0; size < 4; size++) {
            look_at_cell(cell++);
            filter(GL_TEXTURE_2D, filters[number], number & 1 ? GL_NEAREST : GL_LINEAR);
            square(0, 0.4f + 0.6f * (float)(size * size));
        }
    filter(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    for (int number = 0; number < 8; number++) {
        look_at_cell(cell++);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, number == 1 ? 2.3f : -1000);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, number == 2 ? 0.6f : 1000);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, number == 3 ? 2 : 0);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, number == 4 ? 1 : 1000);
        glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, number == 5 ? 1.3f : 0);
        glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, number == 6 ? -1.4f : number == 7 ? 0.7f : 0);
        square(0, 2.2f);
    }
    glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, 0);
    /* A floor in perspective, whose levels change from pixel to pixel; the picture is smooth. */
    for (int number = 0; number < 2; number++) {
        for (int y = 0; y < 64; y++)
            for (int x = 0; x < 64; x++)
                for (int channel = 0; channel < 4; channel++)
                    texels[y * 64 + x][channel] =
                        (unsigned char)(128 + (number ? 10 : 100) * sin(x * 0.19634954 * (channel + 1)) * cos(y * 0.19634954));
        glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, number);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
        filter(GL_TEXTURE_2D, number ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR, GL_LINEAR);
        glViewport(number * 128, 224, 128, 32);
        glMatrixMode(GL_PROJECTION);
        glLoadIdentity();
        glFrustum(-2, 2, -0.5, 0.5, 1, 100);
        glMatrixMode(GL_MODELVIEW);
        glLoadIdentity();
        glBegin(GL_QUADS);
        glTexCoord2f(0, 0);
        glVertex3f(-6, -1, -1);
        glTexCoord2f(3, 0);
        glVertex3f(6, -1, -1);
        glTexCoord2f(3, 3);
        glVertex3f(6, 0.4f, -13);
        glTexCoord2f(0, 3);
        glVertex3f(-6, 0.4f, -13);
        glEnd();
    }
    /* An incomplete texture is as if it were disabled. */
    glBindTexture(GL_TEXTURE_2D, names[0]);
    filter(GL_TEXTURE_2D, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR);
    look_at_cell(55);
    square(0, 1);
}
