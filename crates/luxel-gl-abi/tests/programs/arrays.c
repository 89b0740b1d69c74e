/* Vertex arrays (2.8) and buffer objects (2.9): all types, strides, kinds of drawing; client memory and buffers. */
#include "program.h"

enum { CELLS = 12 };

static void cell(int number)
{
    int size = WIDTH / CELLS;
    glViewport(number % CELLS * size, number / CELLS * size, size, size);
}

/* Two triangles in units of the type; `w` apart. */
static const int corners[6][2] = {{-1, -1}, {1, -1}, {-1, 1}, {1, -1}, {1, 1}, {-1, 1}};
static const GLubyte colors[6][4] = {{255, 0, 51, 255}, {0, 255, 102, 204}, {102, 51, 255, 153}, {0, 255, 102, 255}, {153, 153, 0, 255},
    {102, 51, 255, 255}};

static int number;

static void draw_six(void)
{
    cell(number++);
    glDrawArrays(GL_TRIANGLES, 0, 6);
}

static void types(void)
{
    static const GLenum vertex_types[] = {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE};
    static const GLenum color_types[] = {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT,
        GL_DOUBLE};
    static unsigned char memory[4096];
    glEnableClientState(GL_VERTEX_ARRAY);
    for (int t = 0; t < 4; t++)
        for (int size = 2; size <= 4; size++)
            for (int gap = 0; gap < 2; gap++) {
                int bytes = t == 0 ? 2 : t == 3 ? 8 : 4, stride = size * bytes + gap * 5;
                for (int i = 0; i < 6; i++)
                    for (int c = 0; c < size; c++) {
                        int value = c < 2 ? corners[i][c] : c == 2 ? 0 : 2;
                        unsigned char *at = memory + i * stride + c * bytes;
                        short s = value;
                        float f = value * 0.9f;
                        double d = value * 0.9;
                        memcpy(at, t == 0 ? (void *)&s : t == 1 ? (void *)&value : t == 2 ? (void *)&f : (void *)&d, bytes);
                    }
                glColor3f(0.2f + 0.2f * t, 0.3f * (size - 1), 0.5f * gap + 0.3f);
                glVertexPointer(size, vertex_types[t], gap ? stride : 0, memory);
                draw_six();
            }
    static const short positions[6][2] = {{-1, -1}, {1, -1}, {-1, 1}, {1, -1}, {1, 1}, {-1, 1}};
    glVertexPointer(2, GL_SHORT, 0, positions);
    glEnableClientState(GL_COLOR_ARRAY);
    for (int t = 0; t < 8; t++)
        for (int size = 3; size <= 4; size++) {
            static const int sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
            for (int i = 0; i < 6; i++)
                for (int c = 0; c < size; c++) {
                    double part = colors[i][c] / 255.0;
                    unsigned char *at = memory + (i * size + c) * sizes[t];
                    GLbyte b = part * 127;
                    GLubyte ub = part * 255;
                    GLshort s = part * 32767;
                    GLushort us = part * 65535;
                    GLint n = part * 2147483647;
                    GLuint un = part * 4294967295.0;
                    float f = part;
                    void *values[] = {&b, &ub, &s, &us, &n, &un, &f, &part};
                    memcpy(at, values[t], sizes[t]);
                }
            glColorPointer(size, color_types[t], 0, memory);
            draw_six();
        }
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
}

static void kinds(void)
{
    static const GLubyte bytes[] = {0, 1, 2, 3, 4, 5};
    static const GLushort shorts[] = {5, 4, 3, 2, 1, 0};
    static const GLuint words[] = {0, 1, 2, 2, 1, 4};
    cell(number++);
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, bytes);
    cell(number++);
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, shorts);
    cell(number++);
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, words);
    cell(number++);
    glDrawRangeElements(GL_TRIANGLES, 0, 5, 3, GL_UNSIGNED_SHORT, shorts);
    cell(number++);
    glMultiDrawArrays(GL_TRIANGLES, (const GLint[]){3, 0}, (const GLsizei[]){3, 0}, 2);
    cell(number++);
    glMultiDrawElements(GL_TRIANGLES, (const GLsizei[]){3, 3}, GL_UNSIGNED_BYTE, (const void *const[]){bytes, bytes + 3}, 2);
    cell(number++);
    glBegin(GL_TRIANGLE_STRIP);
    glArrayElement(0);
    glArrayElement(1);
    glArrayElement(2);
    glArrayElement(4);
    glEnd();
    cell(number++);
    glDrawArrays(GL_TRIANGLES, 3, 3);
    /* In a list the arrays are those of the time of compiling. */
    glNewList(1, GL_COMPILE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, bytes + 3);
    glEndList();
    static GLubyte others[6][4];
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, others);
    cell(number++);
    glCallList(1);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
    glDisableClientState(GL_COLOR_ARRAY);
    static const GLenum formats[] = {GL_V2F, GL_V3F, GL_C4UB_V2F, GL_C4UB_V3F, GL_C3F_V3F, GL_N3F_V3F, GL_C4F_N3F_V3F, GL_T2F_V3F,
        GL_T4F_V4F, GL_T2F_C4UB_V3F, GL_T2F_C3F_V3F, GL_T2F_N3F_V3F, GL_T2F_C4F_N3F_V3F, GL_T4F_C4F_N3F_V4F};
    static float memory[6 * 16];
    for (int f = 0; f < 14; f++) {
        /* Numbers of textures, colours, normals, positions; colours of four bytes are one float. */
        static const int parts[14][5] = {{0, 0, 0, 2}, {0, 0, 0, 3}, {0, 1, 0, 2, 1}, {0, 1, 0, 3, 1}, {0, 3, 0, 3}, {0, 0, 3, 3},
            {0, 4, 3, 3}, {2, 0, 0, 3}, {4, 0, 0, 4}, {2, 1, 0, 3, 1}, {2, 3, 0, 3}, {2, 0, 3, 3}, {2, 4, 3, 3}, {4, 4, 3, 4}};
        float *at = memory;
        for (int i = 0; i < 6; i++) {
            for (int c = 0; c < parts[f][0]; c++)
                *at++ = 0.5f * c;
            if (parts[f][4])
                memcpy(at++, colors[i], 4);
            else
                for (int c = 0; c < parts[f][1]; c++)
                    *at++ = colors[i][c] / 255.0f;
            for (int c = 0; c < parts[f][2]; c++)
                *at++ = c == 2;
            for (int c = 0; c < parts[f][3]; c++)
                *at++ = c < 2 ? 0.8f * corners[i][c] : c == 3;
        }
        glColor3f(0.6f, 0.05f * f, 0.9f);
        glInterleavedArrays(formats[f], 0, memory);
        say("format %d: %d %d %d %d", f, glIsEnabled(GL_VERTEX_ARRAY), glIsEnabled(GL_COLOR_ARRAY), glIsEnabled(GL_NORMAL_ARRAY),
            glIsEnabled(GL_TEXTURE_COORD_ARRAY));
        draw_six();
    }
    glDisableClientState(GL_NORMAL_ARRAY);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
    glDisableClientState(GL_VERTEX_ARRAY);
    say_error("kinds");
}

static void buffers(void)
{
    GLuint names[3];
    GLint value;
    void *pointer;
    float back[4] = {0};
    static const float positions[] = {-0.9f, -0.9f, 0.9f, -0.8f, -0.8f, 0.9f, 0.7f, 0.7f};
    static const GLushort indices[] = {0, 1, 2, 2, 1, 3};
    glGenBuffers(3, names);
    say("before binding: %d", glIsBuffer(names[0]));
    glBindBuffer(GL_ARRAY_BUFFER, names[0]);
    say("after: %d", glIsBuffer(names[0]));
    glBufferData(GL_ARRAY_BUFFER, sizeof positions, positions, GL_STATIC_DRAW);
    glVertexPointer(2, GL_FLOAT, 0, NULL);
    glEnableClientState(GL_VERTEX_ARRAY);
    glBindBuffer(GL_ARRAY_BUFFER, names[1]);
    glBufferData(GL_ARRAY_BUFFER, 32, NULL, GL_DYNAMIC_DRAW);
    glBufferSubData(GL_ARRAY_BUFFER, 8, 16, colors);
    glColorPointer(4, GL_UNSIGNED_BYTE, 0, (const void *)8);
    glEnableClientState(GL_COLOR_ARRAY);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[2]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices, GL_STREAM_READ);
    cell(number++);
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, NULL);
    cell(number++);
    glDrawRangeElements(GL_TRIANGLES, 1, 3, 3, GL_UNSIGNED_SHORT, (const void *)6);
    cell(number++);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);

    GLubyte *mapped = glMapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
    say("mapped %d: %d %d %d", mapped != NULL, mapped[8], mapped[9], mapped[0]);
    glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_MAPPED, &value);
    glGetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    say("state %d %d", value, pointer == mapped);
    for (int i = 8; i < 24; i++)
        mapped[i] = 255 - mapped[i];
    glBufferSubData(GL_ARRAY_BUFFER, 0, 4, colors);
    say_error("while mapped");
    say("again: %d", glMapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY) != NULL);
    say_error("again");
    say("unmapped %d", glUnmapBuffer(GL_ARRAY_BUFFER));
    say("unmapped %d", glUnmapBuffer(GL_ARRAY_BUFFER));
    say_error("twice");
    cell(number++);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    glGetBufferSubData(GL_ARRAY_BUFFER, 8, 4, back);
    say("back %d %d %d", ((GLubyte *)back)[0], ((GLubyte *)back)[1], ((GLubyte *)back)[2]);
    static const GLenum parameters[] = {GL_BUFFER_SIZE, GL_BUFFER_USAGE, GL_BUFFER_ACCESS, GL_BUFFER_MAPPED};
    for (int i = 0; i < 4; i++) {
        glGetBufferParameteriv(GL_ARRAY_BUFFER, parameters[i], &value);
        say("parameter %#x: %#x", parameters[i], value);
    }
    glGetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
    say("pointer %d", pointer != NULL);
    GLubyte *part = glMapBufferRange(GL_ARRAY_BUFFER, 8, 4, GL_MAP_READ_BIT);
    say("part %d", part ? part[1] : -1);
    glUnmapBuffer(GL_ARRAY_BUFFER);

    glGetPointerv(GL_COLOR_ARRAY_POINTER, &pointer);
    say("pointer %d", (int)(size_t)pointer);
    static const GLenum gets[] = {GL_VERTEX_ARRAY_SIZE, GL_VERTEX_ARRAY_TYPE, GL_VERTEX_ARRAY_STRIDE, GL_COLOR_ARRAY_SIZE,
        GL_COLOR_ARRAY_TYPE, GL_NORMAL_ARRAY_TYPE, GL_TEXTURE_COORD_ARRAY_SIZE, GL_EDGE_FLAG_ARRAY_STRIDE, GL_FOG_COORD_ARRAY_TYPE,
        GL_SECONDARY_COLOR_ARRAY_SIZE, GL_INDEX_ARRAY_TYPE};
    for (unsigned i = 0; i < sizeof gets / sizeof *gets; i++) {
        glGetIntegerv(gets[i], &value);
        say("%#x: %#x", gets[i], value);
    }
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &value);
    say("bound %d", value == (GLint)names[1]);
    glGetIntegerv(GL_VERTEX_ARRAY_BUFFER_BINDING, &value);
    say("bound %d", value == (GLint)names[0]);
    glDeleteBuffers(3, names);
    glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &value);
    say("deleted %d %d", value, glIsBuffer(names[0]));
    glDisableClientState(GL_VERTEX_ARRAY);
    glDisableClientState(GL_COLOR_ARRAY);
    say_error("buffers");
}

#define TRY(call)         \
    do {                  \
        call;             \
        say_error(#call); \
    } while (0)

static void errors(void)
{
    float f[16] = {0};
    GLuint name;
    TRY(glVertexPointer(1, GL_FLOAT, 0, f));
    TRY(glVertexPointer(5, GL_FLOAT, 0, f));
    TRY(glVertexPointer(2, GL_UNSIGNED_BYTE, 0, f));
    TRY(glVertexPointer(2, GL_FLOAT, -1, f));
    TRY(glColorPointer(2, GL_FLOAT, 0, f));
    TRY(glNormalPointer(GL_UNSIGNED_BYTE, 0, f));
    TRY(glTexCoordPointer(0, GL_FLOAT, 0, f));
    TRY(glEdgeFlagPointer(-1, f));
    TRY(glIndexPointer(GL_BYTE, 0, f));
    TRY(glFogCoordPointer(GL_SHORT, 0, f));
    TRY(glSecondaryColorPointer(5, GL_FLOAT, 0, f));
    TRY(glInterleavedArrays(0x1234, 0, f));
    TRY(glInterleavedArrays(GL_V2F, -1, f));
    TRY(glEnableClientState(0x1234));
    TRY(glDisableClientState(GL_FOG));
    TRY(glDrawArrays(0x1234, 0, 1));
    TRY(glDrawArrays(GL_POINTS, 0, -1));
    TRY(glDrawElements(GL_POINTS, -1, GL_UNSIGNED_INT, f));
    TRY(glDrawElements(GL_POINTS, 1, GL_FLOAT, f));
    TRY(glDrawElements(0x1234, 1, GL_UNSIGNED_INT, f));
    TRY(glDrawRangeElements(GL_POINTS, 5, 1, 1, GL_UNSIGNED_INT, f));
    TRY(glBindBuffer(0x1234, 0));
    TRY(glBufferData(GL_ARRAY_BUFFER, 4, f, GL_STATIC_DRAW));
    TRY(glGenBuffers(-1, &name));
    TRY(glDeleteBuffers(-1, &name));
    glGenBuffers(1, &name);
    glBindBuffer(GL_ARRAY_BUFFER, name);
    TRY(glBufferData(GL_ARRAY_BUFFER, -1, f, GL_STATIC_DRAW));
    TRY(glBufferData(GL_ARRAY_BUFFER, 4, f, 0x1234));
    TRY(glBufferData(0x1234, 4, f, GL_STATIC_DRAW));
    TRY(glBufferData(GL_ARRAY_BUFFER, 16, f, GL_STATIC_DRAW));
    TRY(glBufferSubData(GL_ARRAY_BUFFER, -1, 4, f));
    TRY(glBufferSubData(GL_ARRAY_BUFFER, 14, 4, f));
    TRY(glBufferSubData(GL_ARRAY_BUFFER, 0, -4, f));
    TRY(glGetBufferSubData(GL_ARRAY_BUFFER, 14, 4, f));
    TRY(glMapBuffer(GL_ARRAY_BUFFER, 0x1234));
    TRY(glGetBufferParameteriv(GL_ARRAY_BUFFER, 0x1234, (GLint *)f));
    void *pointer;
    TRY(glGetBufferPointerv(GL_ARRAY_BUFFER, 0x1234, &pointer));
    TRY(glMapBufferRange(GL_ARRAY_BUFFER, 8, 9, GL_MAP_READ_BIT));
    TRY(glMapBufferRange(GL_ARRAY_BUFFER, 8, 4, 0));
    glDeleteBuffers(1, &name);
}

static void draw(void)
{
    glClear(GL_COLOR_BUFFER_BIT);
    types();
    kinds();
    buffers();
    errors();
}
