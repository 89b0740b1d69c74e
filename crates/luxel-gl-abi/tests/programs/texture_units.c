/* Several units at once: coordinates and matrices of each, crossbar, secondary colours after texturing (3.8.16, 3.9). */
#include "texture.h"

static unsigned char texels[3][16 * 16][4];

static void corner(float x, float y)
{
    glMultiTexCoord2f(GL_TEXTURE0, x, y);
    glMultiTexCoord2f(GL_TEXTURE1, 2 * y, x);
    glMultiTexCoord4f(GL_TEXTURE2, x * 0.5f, y * 0.5f, 0, 0.5f);
    glColor4f(1, 0.5f + 0.5f * x, 0.5f + 0.5f * y, 1 - 0.5f * x);
    glVertex2f(x, y);
}

static void cover(void)
{
    glBegin(GL_QUADS);
    corner(0, 0);
    corner(1, 0);
    corner(1, 1);
    corner(0, 1);
    glEnd();
}

static void draw(void)
{
    GLuint names[3];
    glClear(GL_COLOR_BUFFER_BIT);
    glGenTextures(3, names);
    say("names %u %u %u", names[0], names[1], names[2]);
    for (int unit = 0; unit < 3; unit++) {
        glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
        glBindTexture(GL_TEXTURE_2D, names[unit]);
        paint(texels[unit], 16, 16, (unsigned)unit);
        filter(GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
        glTexImage2D(GL_TEXTURE_2D, 0, unit == 1 ? GL_LUMINANCE : GL_RGBA, 16, 16, 0, unit == 2 ? GL_BGRA : GL_RGBA,
                     GL_UNSIGNED_BYTE, texels[unit]);
    }
    for (int cell = 0; cell < 8; cell++) {
        look_at_cell(cell);
        for (int unit = 0; unit < 3; unit++) {
            glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
            if (cell >> unit & 1)
                glEnable(GL_TEXTURE_2D);
            else
                glDisable(GL_TEXTURE_2D);
        }
        cover();
    }
    /* A matrix of each unit. */
    for (int cell = 8; cell < 16; cell++) {
        look_at_cell(cell);
        for (int unit = 0; unit < 3; unit++) {
            glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
            glMatrixMode(GL_TEXTURE);
            glLoadIdentity();
            glTranslatef(0.13f * (float)cell, 0.05f * (float)unit, 0);
            glRotatef(30.0f * (float)unit + 10.0f * (float)cell, 0, 0, 1);
        }
        glMatrixMode(GL_MODELVIEW);
        cover();
    }
    for (int unit = 0; unit < 3; unit++) {
        glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
        glMatrixMode(GL_TEXTURE);
        glLoadIdentity();
        glMatrixMode(GL_MODELVIEW);
    }
    /* The texture of any unit as a source. */
    for (int cell = 16; cell < 24; cell++) {
        look_at_cell(cell);
        for (int unit = 0; unit < 3; unit++) {
            glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
            glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
            glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
            glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE0 + (cell + unit) % 3);
            glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PREVIOUS);
            glTexEnvi(GL_TEXTURE_ENV, GL_SRC2_RGB, GL_TEXTURE0 + (cell / 3 + unit) % 3);
            glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND2_RGB, GL_SRC_COLOR);
        }
        cover();
    }
    /* Secondary colours are added to what textures make. */
    for (int unit = 0; unit < 3; unit++) {
        glActiveTexture((GLenum)(GL_TEXTURE0 + unit));
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
    }
    glEnable(GL_COLOR_SUM);
    glSecondaryColor3f(0.4f, 0, 0.3f);
    look_at_cell(24);
    cover();
    glShadeModel(GL_FLAT);
    look_at_cell(25);
    cover();
    glDisable(GL_COLOR_SUM);
    glShadeModel(GL_SMOOTH);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    const GLfloat white[] = {0.6f, 0.5f, 0.4f, 1};
    glMaterialfv(GL_FRONT, GL_SPECULAR, white);
    glMaterialf(GL_FRONT, GL_SHININESS, 20);
    look_at_cell(26);
    glNormal3f(0.1f, 0.2f, 1);
    cover();
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SINGLE_COLOR);
    look_at_cell(27);
    cover();
    glDisable(GL_LIGHTING);
    /* Fog, alpha test and blending come after textures. */
    const GLfloat fog[] = {0, 0, 1, 1};
    glFogfv(GL_FOG_COLOR, fog);
    glFogf(GL_FOG_DENSITY, 0.5f);
    glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
    glFogCoordf(1.5f);
    glEnable(GL_FOG);
    look_at_cell(28);
    cover();
    glDisable(GL_FOG);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.3f);
    look_at_cell(29);
    cover();
    glDisable(GL_ALPHA_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    look_at_cell(30);
    cover();
    cover();
    glDisable(GL_BLEND);
    /* Lines and points have coordinates, too. */
    look_at_cell(31);
    glLineWidth(5);
    glBegin(GL_LINES);
    corner(0.1f, 0.2f);
    corner(0.9f, 0.2f);
    corner(0.5f, 0.3f);
    corner(0.5f, 0.9f);
    glEnd();
    glPointSize(6);
    glBegin(GL_POINTS);
    corner(0.3f, 0.6f);
    corner(0.8f, 0.7f);
    glEnd();
}
