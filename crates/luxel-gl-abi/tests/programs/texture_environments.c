/* Environments of all base formats (3.8.13), and the functions, sources, operands and scales of GL_COMBINE. */
#include "texture.h"

static unsigned char texels[8 * 8][4];

static void environment(GLenum pname, GLint value)
{
    glTexEnvi(GL_TEXTURE_ENV, pname, value);
}

static void draw(void)
{
    static const GLint formats[] = {GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA};
    static const GLint modes[] = {GL_MODULATE, GL_DECAL, GL_BLEND, GL_REPLACE, GL_ADD};
    static const GLint functions[] = {GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT,
                                      GL_DOT3_RGB, GL_DOT3_RGBA};
    const GLfloat constant[] = {0.9f, 0.2f, 0.6f, 0.4f};
    glClear(GL_COLOR_BUFFER_BIT);
    paint(texels, 8, 8, 1);
    filter(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
    for (int format = 0; format < 6; format++)
        for (int mode = 0; mode < 5; mode++) {
            /* Decal is defined for RGB and RGBA alone. */
            if (modes[mode] == GL_DECAL && format < 4)
                continue;
            look_at_cell(format * 5 + mode);
            glTexImage2D(GL_TEXTURE_2D, 0, formats[format], 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
            environment(GL_TEXTURE_ENV_MODE, modes[mode]);
            square(0, 1);
        }
    environment(GL_TEXTURE_ENV_MODE, GL_COMBINE);
    for (int function = 0; function < 8; function++) {
        look_at_cell(32 + function);
        environment(GL_COMBINE_RGB, functions[function]);
        environment(GL_COMBINE_ALPHA, functions[function < 6 ? function : 1]);
        square(0, 1);
    }
    for (int cell = 0; cell < 16; cell++) {
        static const GLint sources[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
        static const GLint operands[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
        look_at_cell(40 + cell);
        environment(GL_COMBINE_RGB, cell & 1 ? GL_INTERPOLATE : GL_MODULATE);
        environment(GL_COMBINE_ALPHA, cell & 1 ? GL_SUBTRACT : GL_ADD);
        for (int argument = 0; argument < 3; argument++) {
            environment((GLenum)(GL_SRC0_RGB + argument), sources[(cell + argument) % 4]);
            environment((GLenum)(GL_SRC0_ALPHA + argument), sources[(cell / 2 + argument) % 4]);
            environment((GLenum)(GL_OPERAND0_RGB + argument), operands[(cell / 4 + argument) % 4]);
            environment((GLenum)(GL_OPERAND0_ALPHA + argument), operands[2 + (cell + argument) % 2]);
        }
        glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, (float)(1 << cell % 3));
        glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, (float)(1 << cell / 2 % 3));
        square(0, 1);
    }
}
