/* What the programs on textures have in common: cells of a grid, and pictures to put on them. */
#ifndef TEXTURE_H
#define TEXTURE_H

#include "program.h"

enum { CELL = 32, CELLS = WIDTH / CELL };

/* Looks at a cell of the grid, from 0 on; x and y go from 0 to 1. */
__attribute__((unused)) static void look_at_cell(int number)
{
    glViewport(number % CELLS * CELL, number / CELLS * CELL, CELL, CELL);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glOrtho(0, 1, 0, 1, -1, 1);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
}

/* A square over the cell with coordinates from `low` to `high`, and a colour a corner. */
__attribute__((unused)) static void square(float low, float high)
{
    glBegin(GL_QUADS);
    glColor4f(1, 0.9f, 0.8f, 0.9f);
    glTexCoord2f(low, low);
    glVertex2f(0, 0);
    glColor4f(0.5f, 1, 0.5f, 0.7f);
    glTexCoord2f(high, low);
    glVertex2f(1, 0);
    glColor4f(0.3f, 0.4f, 1, 0.5f);
    glTexCoord2f(high, high);
    glVertex2f(1, 1);
    glColor4f(1, 1, 1, 1);
    glTexCoord2f(low, high);
    glVertex2f(0, 1);
    glEnd();
}

/* Texels that differ all: smooth in places, hard in others, with alpha. */
__attribute__((unused)) static void paint(unsigned char (*texels)[4], int width, int height, unsigned seed)
{
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            unsigned char *texel = texels[y * width + x];
            texel[0] = (unsigned char)(255 * x / (width > 1 ? width - 1 : 1));
            texel[1] = (unsigned char)(255 * y / (height > 1 ? height - 1 : 1));
            texel[2] = (unsigned char)((x ^ y) & 1 ? 40 : 220);
            texel[3] = (unsigned char)(60 + (x * 37 + y * 71 + seed * 13) % 196);
        }
}

__attribute__((unused)) static void filter(GLenum target, GLenum minify, GLenum magnify)
{
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, (GLint)minify);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, (GLint)magnify);
}

#endif
