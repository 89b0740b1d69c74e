/* Tests and operations on fragments: alpha, stencil, blending, logic, masks, scissor, stipple, fog (3.5.2, 3.10, 4.1). */
#include "program.h"

/* A square whose colours are the same along whichever diagonal it is cut. */
static void square(float x, float y, float side)
{
    glBegin(GL_QUADS);
    glColor4f(0.9f, 0.1f, 0.2f, 0.1f);
    glVertex2f(x, y);
    glColor4f(0.3f, 0.5f, 0.3f, 0.4f);
    glVertex2f(x + side, y);
    glColor4f(0.1f, 0.8f, 1, 1);
    glVertex2f(x + side, y + side);
    glColor4f(0.7f, 0.4f, 0.9f, 0.7f);
    glVertex2f(x, y + side);
    glEnd();
}

static void draw(void)
{
    static const GLenum factors[] = {GL_ZERO, GL_ONE, GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_DST_COLOR, GL_ONE_MINUS_DST_COLOR,
        GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_CONSTANT_COLOR, GL_ONE_MINUS_CONSTANT_COLOR,
        GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA, GL_SRC_ALPHA_SATURATE};
    static const GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
    glClearColor(0.3f, 0.4f, 0.2f, 0.6f);
    glClear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    glMatrixMode(GL_PROJECTION);
    glOrtho(0, 16, 0, 16, -1, 1);
    glBlendColor(0.2f, 0.5f, 0.7f, 0.3f);
    glEnable(GL_BLEND);
    for (int i = 0; i < 15; i++) {
        glBlendFunc(factors[i], GL_ONE);
        square(i, 0, 0.9f);
        if (factors[i] != GL_SRC_ALPHA_SATURATE) {
            glBlendFunc(GL_ONE, factors[i]);
            square(i, 1, 0.9f);
        }
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, factors[i], GL_ZERO);
        square(i, 2, 0.9f);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glBlendEquation(equations[i % 5]);
        square(i, 3, 0.9f);
        square(i + 0.3f, 3.3f, 0.6f);
        glBlendEquation(GL_FUNC_ADD);
    }
    glDisable(GL_BLEND);
    glEnable(GL_COLOR_LOGIC_OP);
    for (int i = 0; i < 16; i++) {
        glLogicOp(GL_CLEAR + i);
        square(i, 4, 0.9f);
    }
    glDisable(GL_COLOR_LOGIC_OP);
    for (int i = 0; i < 16; i++) {
        glColorMask(i & 1, i & 2, i & 4, i & 8);
        square(i, 5, 0.9f);
    }
    glColorMask(1, 1, 1, 1);
    glEnable(GL_ALPHA_TEST);
    for (int i = 0; i < 8; i++) {
        glAlphaFunc(GL_NEVER + i, 0.4f);
        square(2 * i, 6, 0.9f);
    }
    glDisable(GL_ALPHA_TEST);
    glEnable(GL_STENCIL_TEST);
    static const GLenum operations[] = {GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
    for (int i = 0; i < 16; i++) {
        glStencilMask(i < 8 ? 255 : 0x3c);
        glStencilFunc(GL_ALWAYS, 5, 255);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        square(i, 7, 0.9f);
        glStencilOp(GL_KEEP, GL_KEEP, operations[i % 8]);
        glStencilFunc(GL_ALWAYS, 0xa3, 255);
        for (int k = 0; k < 7; k++)
            square(i + 0.3f, 7.3f, 0.4f);
        glStencilFunc(GL_NEVER + i % 8, i < 8 ? 5 : 0x21, i < 8 ? 255 : 0x0f);
        glStencilOp(GL_INVERT, GL_KEEP, GL_KEEP);
        square(i, 8, 0.9f);
    }
    for (int y = 0; y < 2; y++)
        for (int x = 0; x < 16; x++) {
            GLubyte stencil[2];
            glReadPixels(x * 16 + 2, (7 + y) * 16 + 2, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
            glReadPixels(x * 16 + 8, (7 + y) * 16 + 8, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil + 1);
            say("stencil %d %d: %d %d", x, y, stencil[0], stencil[1]);
        }
    glDisable(GL_STENCIL_TEST);
    glEnable(GL_SCISSOR_TEST);
    for (int i = 0; i < 16; i++) {
        glScissor(i * 16 + i / 2, 9 * 16 + 2, 10, 16 - i);
        square(i, 9, 0.9f);
    }
    glDisable(GL_SCISSOR_TEST);
    GLubyte mask[128];
    for (int i = 0; i < 128; i++)
        mask[i] = i * 37 + i / 4;
    glPolygonStipple(mask);
    glEnable(GL_POLYGON_STIPPLE);
    for (int i = 0; i < 16; i++)
        square(i, 10, 0.95f);
    glDisable(GL_POLYGON_STIPPLE);
    glEnable(GL_FOG);
    static const float fog[] = {0.8f, 0.2f, 0.9f, 1};
    glFogfv(GL_FOG_COLOR, fog);
    for (int i = 0; i < 16; i++) {
        static const GLint modes[] = {GL_LINEAR, GL_EXP, GL_EXP2};
        glFogi(GL_FOG_MODE, modes[i % 3]);
        glFogf(GL_FOG_DENSITY, 0.2f + 0.1f * i);
        glFogf(GL_FOG_START, 0.08f * i);
        glFogf(GL_FOG_END, 1.5f);
        glFogi(GL_FOG_COORD_SRC, i & 1 ? GL_FOG_COORD : GL_FRAGMENT_DEPTH);
        glBegin(GL_QUADS);
        glColor3f(0.2f, 1, 0.4f);
        glFogCoordf(0);
        glVertex3f(i, 11, 0);
        glFogCoordf(1.5f);
        glVertex3f(i + 0.9f, 11, -0.9f);
        glFogCoordf(3);
        glVertex3f(i + 0.9f, 11.9f, -0.5f);
        glFogCoordf(0.5f);
        glVertex3f(i, 11.9f, 0.5f);
        glEnd();
    }
    glDisable(GL_FOG);
    /* The colour sum without lighting. */
    glEnable(GL_COLOR_SUM);
    glSecondaryColor3f(0.3f, 0, 0.2f);
    square(0, 12, 2);
    glDisable(GL_COLOR_SUM);
    square(3, 12, 2);
    say_error("fragments");
}
