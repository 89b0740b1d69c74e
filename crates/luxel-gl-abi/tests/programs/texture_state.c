/* Errors, queries and images of textures (3.8, 6.1.3, 6.1.4). */
#include "texture.h"

static unsigned char texels[64][4], back[4096];

static void say_integer(const char *what, GLint value)
{
    say("%s %d", what, value);
}

static void say_image(GLenum format, GLenum type, size_t bytes)
{
    unsigned sum = 0;
    memset(back, 0, sizeof back);
    glGetTexImage(GL_TEXTURE_2D, 0, format, type, back);
    for (size_t at = 0; at < bytes; at++)
        sum = sum * 31 + back[at];
    say("image %x %x: %u", format, type, sum);
    say_error("image");
}

static void say_level(GLenum target, GLint level)
{
    static const GLenum names[] = {GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH, GL_TEXTURE_BORDER,
                                   GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_COMPRESSED};
    for (int at = 0; at < 6; at++) {
        GLint value = -7;
        glGetTexLevelParameteriv(target, level, names[at], &value);
        say("level %d %x: %d", level, names[at], value);
    }
    say_error("level");
}

static void draw(void)
{
    static const GLenum parameters[] = {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R, GL_TEXTURE_MIN_FILTER,
                                        GL_TEXTURE_MAG_FILTER, GL_TEXTURE_MIN_LOD, GL_TEXTURE_MAX_LOD,
                                        GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL, GL_DEPTH_TEXTURE_MODE,
                                        GL_TEXTURE_COMPARE_MODE, GL_TEXTURE_COMPARE_FUNC, GL_GENERATE_MIPMAP,
                                        GL_TEXTURE_RESIDENT};
    static const GLenum environment[] = {GL_TEXTURE_ENV_MODE, GL_COMBINE_RGB, GL_COMBINE_ALPHA, GL_SRC0_RGB, GL_SRC1_RGB,
                                         GL_SRC2_RGB, GL_SRC0_ALPHA, GL_SRC1_ALPHA, GL_SRC2_ALPHA, GL_OPERAND0_RGB,
                                         GL_OPERAND1_RGB, GL_OPERAND2_RGB, GL_OPERAND0_ALPHA, GL_OPERAND1_ALPHA,
                                         GL_OPERAND2_ALPHA, GL_RGB_SCALE, GL_ALPHA_SCALE};
    GLuint names[3] = {0, 0, 0};
    GLint value;
    GLfloat four[4];
    glClear(GL_COLOR_BUFFER_BIT);
    paint(texels, 8, 8, 5);
    for (size_t at = 0; at < sizeof parameters / sizeof *parameters; at++) {
        glGetTexParameteriv(GL_TEXTURE_2D, parameters[at], &value);
        say("parameter %x: %d", parameters[at], value);
    }
    for (size_t at = 0; at < sizeof environment / sizeof *environment; at++) {
        glGetTexEnviv(GL_TEXTURE_ENV, environment[at], &value);
        say("environment %x: %d", environment[at], value);
    }
    for (int axis = 0; axis < 4; axis++) {
        glGetTexGeniv((GLenum)(GL_S + axis), GL_TEXTURE_GEN_MODE, &value);
        glGetTexGenfv((GLenum)(GL_S + axis), GL_EYE_PLANE, four);
        say("generation %d: %x %g %g %g %g", axis, value, four[0], four[1], four[2], four[3]);
    }
    glGenTextures(3, names);
    say("is texture: %d", glIsTexture(names[0]));
    glBindTexture(GL_TEXTURE_2D, names[0]);
    say("is texture: %d", glIsTexture(names[0]));
    glBindTexture(GL_TEXTURE_1D, names[0]);
    say_error("another target");
    glBindTexture(GL_RGBA, names[0]);
    say_error("no target");
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &value);
    say("bound: %d", value == (GLint)names[0]);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB5_A1, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    say_level(GL_TEXTURE_2D, 0);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 3, GL_TEXTURE_WIDTH, &value);
    say_integer("a level without image", value);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 99, GL_TEXTURE_WIDTH, &value);
    say_error("level 99");
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WRAP_S, &value);
    say_error("a parameter that is none of a level");
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8, 64, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    say_level(GL_PROXY_TEXTURE_2D, 0);
    glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8, 1 << 20, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &value);
    say_integer("a proxy that is too large", value);
    say_error("proxy");
    static const struct {
        const char *what;
        GLenum target;
        GLint level, internal;
        GLsizei width, height;
        GLint border;
        GLenum format, type;
    } images[] = {
        {"target", GL_TEXTURE_3D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE},
        {"negative level", GL_TEXTURE_2D, -1, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE},
        {"level", GL_TEXTURE_2D, 30, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE},
        {"internal format", GL_TEXTURE_2D, 0, 5, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE},
        {"negative width", GL_TEXTURE_2D, 0, GL_RGBA, -1, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE},
        {"width", GL_TEXTURE_2D, 0, GL_RGBA, 1 << 20, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE},
        {"border", GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 2, GL_RGBA, GL_UNSIGNED_BYTE},
        {"format", GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA8, GL_UNSIGNED_BYTE},
        {"type", GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_RGBA},
        {"packed type", GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGB, GL_UNSIGNED_INT_8_8_8_8},
        {"depth of colours", GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE},
        {"colours of depth", GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE},
        {"a cube's face that isn't square", GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 8, 4, 0, GL_RGBA,
         GL_UNSIGNED_BYTE},
    };
    for (size_t at = 0; at < sizeof images / sizeof *images; at++) {
        glTexImage2D(images[at].target, images[at].level, images[at].internal, images[at].width, images[at].height,
                     images[at].border, images[at].format, images[at].type, texels);
        say_error(images[at].what);
    }
    glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 0, 5, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    say_error("beyond the image");
    glTexSubImage2D(GL_TEXTURE_2D, 0, -1, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    say_error("before the image");
    glTexSubImage2D(GL_TEXTURE_2D, 2, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    say_error("a level that isn't there");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_LINEAR);
    say_error("wrap");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    say_error("magnify");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, -1);
    say_error("base level");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, -1);
    say_error("max level");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1);
    say_error("one value for four");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_RGBA);
    say_error("comparison");
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_INTERPOLATE);
    say_error("mode");
    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGB);
    say_error("alpha's function");
    glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_COLOR);
    say_error("alpha's operand");
    glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3);
    say_error("scale");
    glTexGeni(GL_R, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    say_error("sphere map of r");
    glTexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
    say_error("reflection map of q");
    glGenTextures(-1, names);
    say_error("negative count");
    glCopyTexImage2D(GL_TEXTURE_2D, 0, 3, 0, 0, 8, 8, 0);
    say_error("copy with a number of components");
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 7, 0, 0, 0, 2, 2);
    say_error("copy beyond the image");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    say_image(GL_RGBA, GL_UNSIGNED_BYTE, 256);
    say_image(GL_BGRA, GL_UNSIGNED_BYTE, 256);
    say_image(GL_RGB, GL_UNSIGNED_SHORT, 384);
    say_image(GL_ALPHA, GL_UNSIGNED_BYTE, 64);
    say_image(GL_RED, GL_UNSIGNED_SHORT, 128);
    say_image(GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 128);
    say_image(GL_DEPTH_COMPONENT, GL_FLOAT, 0);
    say_image(GL_RGBA8, GL_FLOAT, 0);
    static const GLint formats[] = {GL_ALPHA8, GL_LUMINANCE8, GL_LUMINANCE8_ALPHA8, GL_INTENSITY8, GL_RGB8};
    for (int at = 0; at < 5; at++) {
        glTexImage2D(GL_TEXTURE_2D, 0, formats[at], 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
        say_image(GL_RGBA, GL_UNSIGNED_BYTE, 256);
    }
    /* Parameters of bound textures, bindings and environments are pushed and popped. */
    glPushAttrib(GL_TEXTURE_BIT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_ADD);
    glEnable(GL_TEXTURE_2D);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, names[1]);
    glPopAttrib();
    glGetIntegerv(GL_ACTIVE_TEXTURE, &value);
    say("active %x", value);
    glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &value);
    say("wrap %x", value);
    glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &value);
    say("mode %x, enabled %d", value, glIsEnabled(GL_TEXTURE_2D));
    glActiveTexture(GL_TEXTURE1);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &value);
    say("bound %d", value);
    glActiveTexture(GL_TEXTURE0);
    /* In a list the pixels are those of the moment when it was compiled. */
    glNewList(1, GL_COMPILE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 2, 2, 4, 4, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels);
    glEndList();
    memset(texels, 0, sizeof texels);
    glCallList(1);
    say_image(GL_RGBA, GL_UNSIGNED_BYTE, 256);
    glDeleteTextures(3, names);
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &value);
    say("bound after deletion %d, is texture %d", value, glIsTexture(names[0]));
    glGetIntegerv(GL_MAX_TEXTURE_UNITS, &value);
    say("units %d", value);
}
