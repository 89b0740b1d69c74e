/* Every variant of the commands for vertices and their attributes (2.7), with the values that they set (table 2.9). */
#include "program.h"

static void say_current(const char *what)
{
    GLfloat color[4], normal[3], texture[4], secondary[4], fog, index;
    GLboolean edge;
    glGetFloatv(GL_CURRENT_COLOR, color);
    glGetFloatv(GL_CURRENT_NORMAL, normal);
    glGetFloatv(GL_CURRENT_TEXTURE_COORDS, texture);
    glGetFloatv(GL_CURRENT_SECONDARY_COLOR, secondary);
    glGetFloatv(GL_CURRENT_FOG_COORD, &fog);
    glGetFloatv(GL_CURRENT_INDEX, &index);
    glGetBooleanv(GL_EDGE_FLAG, &edge);
    say("%s: %.5f %.5f %.5f %.5f | %.5f %.5f %.5f | %.3f %.3f %.3f %.3f | %.5f %.5f %.5f | %.3f %.3f %d", what, color[0], color[1],
        color[2], color[3], normal[0], normal[1], normal[2], texture[0], texture[1], texture[2], texture[3], secondary[0],
        secondary[1], secondary[2], fog, index, edge);
}

#define SET(call)           \
    do {                    \
        call;               \
        say_current(#call); \
    } while (0)
#define V(type, ...) (const type[]){__VA_ARGS__}

static void attributes(void)
{
    SET(glColor3b(127, -128, 51));
    SET(glColor3bv(V(GLbyte, 1, 2, -3)));
    SET(glColor3s(32767, -32768, 100));
    SET(glColor3sv(V(GLshort, 1, 20000, -3)));
    SET(glColor3i(2147483647, -2147483647, 1073741824));
    SET(glColor3iv(V(GLint, 1, 2, -3)));
    SET(glColor3ub(255, 0, 51));
    SET(glColor3ubv(V(GLubyte, 1, 2, 3)));
    SET(glColor3us(65535, 0, 13107));
    SET(glColor3usv(V(GLushort, 1, 2, 3)));
    SET(glColor3ui(4294967295u, 0, 858993459));
    SET(glColor3uiv(V(GLuint, 1, 2000000000, 3)));
    SET(glColor3f(2, -1, 0.25f));
    SET(glColor3fv(V(GLfloat, 0.1f, 0.2f, 0.3f)));
    SET(glColor3d(2, -1, 0.25));
    SET(glColor3dv(V(GLdouble, 0.1, 0.2, 0.3)));
    SET(glColor4b(127, -128, 51, 64));
    SET(glColor4bv(V(GLbyte, 1, 2, -3, 4)));
    SET(glColor4s(32767, -32768, 100, 5));
    SET(glColor4sv(V(GLshort, 1, 20000, -3, 4)));
    SET(glColor4i(2147483647, -2147483647, 1073741824, 1));
    SET(glColor4iv(V(GLint, 1, 2, -3, 1000000000)));
    SET(glColor4ub(255, 0, 51, 204));
    SET(glColor4ubv(V(GLubyte, 1, 2, 3, 4)));
    SET(glColor4us(65535, 0, 13107, 5));
    SET(glColor4usv(V(GLushort, 1, 2, 3, 40000)));
    SET(glColor4ui(4294967295u, 0, 858993459, 5));
    SET(glColor4uiv(V(GLuint, 1, 2000000000, 3, 4000000000u)));
    SET(glColor4f(2, -1, 0.25f, 0.5f));
    SET(glColor4fv(V(GLfloat, 0.1f, 0.2f, 0.3f, 0.4f)));
    SET(glColor4d(2, -1, 0.25, 0.5));
    SET(glColor4dv(V(GLdouble, 0.1, 0.2, 0.3, 0.4)));
    SET(glNormal3b(127, -128, 51));
    SET(glNormal3bv(V(GLbyte, 1, 2, -3)));
    SET(glNormal3s(32767, -32768, 100));
    SET(glNormal3sv(V(GLshort, 1, 20000, -3)));
    SET(glNormal3i(2147483647, -2147483647, 1073741824));
    SET(glNormal3iv(V(GLint, 1, 2, -3)));
    SET(glNormal3f(2, -1, 0.25f));
    SET(glNormal3fv(V(GLfloat, 0.1f, 0.2f, 0.3f)));
    SET(glNormal3d(2, -1, 0.25));
    SET(glNormal3dv(V(GLdouble, 0.1, 0.2, 0.3)));
    SET(glTexCoord1s(1));
    SET(glTexCoord1sv(V(GLshort, 2)));
    SET(glTexCoord1i(3));
    SET(glTexCoord1iv(V(GLint, 4)));
    SET(glTexCoord1f(5.5f));
    SET(glTexCoord1fv(V(GLfloat, 6.5f)));
    SET(glTexCoord1d(7.5));
    SET(glTexCoord1dv(V(GLdouble, 8.5)));
    SET(glTexCoord2s(1, 2));
    SET(glTexCoord2sv(V(GLshort, 2, 3)));
    SET(glTexCoord2i(3, 4));
    SET(glTexCoord2iv(V(GLint, 4, 5)));
    SET(glTexCoord2f(5.5f, 6));
    SET(glTexCoord2fv(V(GLfloat, 6.5f, 7)));
    SET(glTexCoord2d(7.5, 8));
    SET(glTexCoord2dv(V(GLdouble, 8.5, 9)));
    SET(glTexCoord3s(1, 2, 3));
    SET(glTexCoord3sv(V(GLshort, 2, 3, 4)));
    SET(glTexCoord3i(3, 4, 5));
    SET(glTexCoord3iv(V(GLint, 4, 5, 6)));
    SET(glTexCoord3f(5.5f, 6, 7));
    SET(glTexCoord3fv(V(GLfloat, 6.5f, 7, 8)));
    SET(glTexCoord3d(7.5, 8, 9));
    SET(glTexCoord3dv(V(GLdouble, 8.5, 9, 10)));
    SET(glTexCoord4s(1, 2, 3, 4));
    SET(glTexCoord4sv(V(GLshort, 2, 3, 4, 5)));
    SET(glTexCoord4i(3, 4, 5, 6));
    SET(glTexCoord4iv(V(GLint, 4, 5, 6, 7)));
    SET(glTexCoord4f(5.5f, 6, 7, 8));
    SET(glTexCoord4fv(V(GLfloat, 6.5f, 7, 8, 9)));
    SET(glTexCoord4d(7.5, 8, 9, 10));
    SET(glTexCoord4dv(V(GLdouble, 8.5, 9, 10, 11)));
    SET(glMultiTexCoord1f(GL_TEXTURE0, 1));
    SET(glMultiTexCoord2dv(GL_TEXTURE0, V(GLdouble, 3, 4)));
    SET(glMultiTexCoord3s(GL_TEXTURE0, 5, 6, 7));
    SET(glMultiTexCoord4iv(GL_TEXTURE0_ARB, V(GLint, 8, 9, 10, 11)));
    SET(glMultiTexCoord2fARB(GL_TEXTURE1, 8, 9));
    SET(glSecondaryColor3b(127, -128, 51));
    SET(glSecondaryColor3sv(V(GLshort, 1, 20000, -3)));
    SET(glSecondaryColor3i(2147483647, -2147483647, 1073741824));
    SET(glSecondaryColor3ubv(V(GLubyte, 1, 2, 3)));
    SET(glSecondaryColor3us(65535, 0, 13107));
    SET(glSecondaryColor3uiv(V(GLuint, 1, 2000000000, 3)));
    SET(glSecondaryColor3f(2, -1, 0.25f));
    SET(glSecondaryColor3dvEXT(V(GLdouble, 0.1, 0.2, 0.3)));
    SET(glFogCoordf(1.5f));
    SET(glFogCoordfv(V(GLfloat, 2.5f)));
    SET(glFogCoordd(-3.5));
    SET(glFogCoorddvEXT(V(GLdouble, 4.5)));
    SET(glIndexs(3));
    SET(glIndexsv(V(GLshort, -4)));
    SET(glIndexi(5));
    SET(glIndexiv(V(GLint, 6)));
    SET(glIndexub(7));
    SET(glIndexubv(V(GLubyte, 8)));
    SET(glIndexf(9.5f));
    SET(glIndexfv(V(GLfloat, 10.5f)));
    SET(glIndexd(11.5));
    SET(glIndexdv(V(GLdouble, 12.5)));
    SET(glEdgeFlag(GL_FALSE));
    SET(glEdgeFlagv(V(GLboolean, 1)));
}

/* A quad by each variant of glVertex: its four corners in units of 16 pixels. */
static void vertex(int variant, int x, int y)
{
    switch (variant) {
    case 0: glVertex2s(x, y); break;
    case 1: glVertex2sv(V(GLshort, x, y)); break;
    case 2: glVertex2i(x, y); break;
    case 3: glVertex2iv(V(GLint, x, y)); break;
    case 4: glVertex2f(x, y); break;
    case 5: glVertex2fv(V(GLfloat, x, y)); break;
    case 6: glVertex2d(x, y); break;
    case 7: glVertex2dv(V(GLdouble, x, y)); break;
    case 8: glVertex3s(x, y, 0); break;
    case 9: glVertex3sv(V(GLshort, x, y, 0)); break;
    case 10: glVertex3i(x, y, 0); break;
    case 11: glVertex3iv(V(GLint, x, y, 0)); break;
    case 12: glVertex3f(x, y, 0.5f); break;
    case 13: glVertex3fv(V(GLfloat, x, y, 0.5f)); break;
    case 14: glVertex3d(x, y, -0.5); break;
    case 15: glVertex3dv(V(GLdouble, x, y, -0.5)); break;
    case 16: glVertex4s(2 * x, 2 * y, 0, 2); break;
    case 17: glVertex4sv(V(GLshort, 2 * x, 2 * y, 0, 2)); break;
    case 18: glVertex4i(2 * x, 2 * y, 0, 2); break;
    case 19: glVertex4iv(V(GLint, 2 * x, 2 * y, 0, 2)); break;
    case 20: glVertex4f(x / 2.0f, y / 2.0f, 0, 0.5f); break;
    case 21: glVertex4fv(V(GLfloat, x / 2.0f, y / 2.0f, 0, 0.5f)); break;
    case 22: glVertex4d(x * 3.0, y * 3.0, 0, 3); break;
    case 23: glVertex4dv(V(GLdouble, x * 3.0, y * 3.0, 0, 3)); break;
    }
}

static void draw(void)
{
    attributes();
    glClear(GL_COLOR_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, 16, 0, 16, -1, 1);
    for (int variant = 0; variant < 24; variant++) {
        int x = variant % 6 * 2 + 1, y = variant / 6 * 2 + 1;
        glColor3ub(60 + 8 * variant, 250 - 8 * variant, variant % 2 * 200);
        glBegin(GL_QUADS);
        vertex(variant, x, y);
        vertex(variant, x + 1, y);
        glColor3ub(255, 255, 255);
        vertex(variant, x + 2, y + 1);
        vertex(variant, x, y + 2);
        glEnd();
    }
    glColor3f(0.9f, 0.5f, 0.1f);
    glRectf(1, 10, 2.5f, 11.25f);
    glRectfv(V(GLfloat, 3, 10), V(GLfloat, 4.5f, 11.25f));
    glRectd(5, 10, 6.5, 11.25);
    glRectdv(V(GLdouble, 7, 10), V(GLdouble, 8.5, 11.25));
    glRecti(9, 10, 10, 12);
    glRectiv(V(GLint, 11, 10), V(GLint, 12, 12));
    glRects(13, 10, 14, 12);
    glRectsv(V(GLshort, 15, 10), V(GLshort, 16, 12));
}
