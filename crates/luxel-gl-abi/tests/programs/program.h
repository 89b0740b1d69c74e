/* What the programs of this folder have in common: a context of OSMesa, a picture, and lines of text.
 *
 *     cc gears.c -o gears -lOSMesa -lm && ./gears gears.pam >gears.txt
 *
 * A program defines `draw`. Its picture is written as PAM (RGBA), what it `say`s goes to the standard output, and last
 * an error that OpenGL has recorded. Both are compared between libraries: state exactly, colours within 2 of 255. */
#ifndef PROGRAM_H
#define PROGRAM_H

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Of a component of the accumulation buffer; programs that need one have 16. */
#ifndef ACCUM_BITS
#define ACCUM_BITS 0
#endif

enum { WIDTH = 256, HEIGHT = 256 };

static unsigned char pixels[HEIGHT][WIDTH][4];

/* Draws the picture into a new context. */
static void draw(void);

/* Prints a line that is the same on every correct library. */
__attribute__((format(printf, 1, 2), unused)) static void say(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vprintf(format, arguments);
    va_end(arguments);
    putchar('\n');
}

/* Prints the name of an error, with what it comes from. */
__attribute__((unused)) static void say_error(const char *what)
{
    GLenum error = glGetError();
    say("%s: %s", what,
        error == GL_NO_ERROR            ? "no error"
        : error == GL_INVALID_ENUM      ? "invalid enum"
        : error == GL_INVALID_VALUE     ? "invalid value"
        : error == GL_INVALID_OPERATION ? "invalid operation"
        : error == GL_STACK_OVERFLOW    ? "stack overflow"
        : error == GL_STACK_UNDERFLOW   ? "stack underflow"
        : error == GL_OUT_OF_MEMORY     ? "out of memory"
                                        : "unknown error");
}

static void die(const char *what)
{
    fprintf(stderr, "%s\n", what);
    exit(1);
}

int main(int count, char **arguments)
{
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (count != 2)
        die("usage: PROGRAM PICTURE.pam");
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, ACCUM_BITS, NULL);
    if (!context || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, WIDTH, HEIGHT))
        die("no context can be had");
    draw();
    glFinish();
    say_error("at the end");
    FILE *file = fopen(arguments[1], "wb");
    if (!file)
        die("the picture can't be written");
    fprintf(file, "P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n", WIDTH, HEIGHT);
    for (int y = HEIGHT - 1; y >= 0; y--)
        fwrite(pixels[y], 4, WIDTH, file);
    if (fclose(file))
        die("the picture can't be written");
    OSMesaMakeCurrent(NULL, NULL, 0, 0, 0);
    OSMesaDestroyContext(context);
    return 0;
}

#endif
