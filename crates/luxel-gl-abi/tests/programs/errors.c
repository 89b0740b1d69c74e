/* Errors and their order (2.5): bad arguments, calls between glBegin and glEnd, full and empty stacks. */
#include "program.h"

#define TRY(call)           \
    do {                    \
        call;               \
        say_error(#call);   \
    } while (0)

static void draw(void)
{
    GLfloat f[16] = {0};
    GLint n[16] = {0};
    GLuint names[8];
    unsigned char bytes[64];
    TRY(glEnable(0x1234));
    TRY(glEnable(GL_CLIP_PLANE0 + 8));
    TRY(glDisable(GL_LIGHT0 + 8));
    TRY(glIsEnabled(0x1234));
    TRY(glBegin(0x1234));
    TRY(glEnd());
    TRY(glMatrixMode(0x1234));
    TRY(glFrustum(0, 0, 0, 1, 1, 2));
    TRY(glFrustum(0, 1, 0, 1, 0, 2));
    TRY(glFrustum(0, 1, 0, 1, -1, 2));
    TRY(glFrustum(0, 1, 0, 1, 1, 1));
    TRY(glOrtho(0, 1, 2, 2, 0, 1));
    TRY(glOrtho(0, 1, 0, 1, 3, 3));
    TRY(glViewport(0, 0, -1, 4));
    TRY(glScissor(0, 0, 4, -1));
    TRY(glLightf(GL_LIGHT0 + 8, GL_SPOT_CUTOFF, 30));
    TRY(glLightf(GL_LIGHT0, 0x1234, 30));
    TRY(glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 100));
    TRY(glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, -1));
    TRY(glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, 129));
    TRY(glLightf(GL_LIGHT0, GL_SPOT_EXPONENT, -1));
    TRY(glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, -1));
    TRY(glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, -1));
    TRY(glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, -1));
    TRY(glMaterialf(GL_FRONT, GL_SHININESS, 129));
    TRY(glMaterialf(GL_FRONT, GL_SHININESS, -1));
    TRY(glMaterialf(0x1234, GL_SHININESS, 1));
    TRY(glMaterialfv(GL_FRONT, 0x1234, f));
    TRY(glColorMaterial(GL_FRONT, GL_SHININESS));
    TRY(glColorMaterial(0x1234, GL_DIFFUSE));
    TRY(glLightModeli(0x1234, 1));
    TRY(glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, 1));
    TRY(glShadeModel(0x1234));
    TRY(glFogf(0x1234, 1));
    TRY(glFogf(GL_FOG_DENSITY, -1));
    TRY(glFogi(GL_FOG_MODE, 0x1234));
    TRY(glGetLightfv(GL_LIGHT0, 0x1234, f));
    TRY(glGetLightfv(0x1234, GL_AMBIENT, f));
    TRY(glGetMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT, f));
    TRY(glGetMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, f));
    TRY(glGetIntegerv(0x1234, n));
    TRY(glGetString(0x1234));
    TRY(glCullFace(0x1234));
    TRY(glFrontFace(0x1234));
    TRY(glPolygonMode(GL_FRONT, 0x1234));
    TRY(glPolygonMode(0x1234, GL_FILL));
    TRY(glPointSize(0));
    TRY(glPointSize(-1));
    TRY(glLineWidth(0));
    TRY(glPointParameterf(GL_POINT_SIZE_MIN, -1));
    TRY(glPointParameterf(0x1234, 1));
    TRY(glAlphaFunc(0x1234, 0));
    TRY(glDepthFunc(0x1234));
    TRY(glStencilFunc(0x1234, 0, 0));
    TRY(glStencilOp(GL_KEEP, 0x1234, GL_KEEP));
    TRY(glBlendFunc(0x1234, GL_ONE));
    TRY(glBlendFunc(GL_ONE, 0x1234));
    TRY(glBlendEquation(0x1234));
    TRY(glLogicOp(0x1234));
    TRY(glClear(0x1));
    TRY(glClear(GL_COLOR_BUFFER_BIT | 0x8));
    TRY(glDrawBuffer(0x1234));
    TRY(glDrawBuffer(GL_AUX0));
    TRY(glReadBuffer(0x1234));
    TRY(glReadBuffer(GL_AUX0));
    TRY(glHint(0x1234, GL_NICEST));
    TRY(glHint(GL_FOG_HINT, 0x1234));
    TRY(glPixelStorei(GL_PACK_ALIGNMENT, 3));
    TRY(glPixelStorei(GL_PACK_ALIGNMENT, 0));
    TRY(glPixelStorei(GL_PACK_ROW_LENGTH, -1));
    TRY(glPixelStorei(GL_UNPACK_SKIP_PIXELS, -1));
    TRY(glPixelStorei(0x1234, 1));
    TRY(glReadPixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes));
    TRY(glReadPixels(0, 0, 1, 1, 0x1234, GL_UNSIGNED_BYTE, bytes));
    TRY(glReadPixels(0, 0, 1, 1, GL_RGBA, 0x1234, bytes));
    TRY(glReadPixels(0, 0, 1, 1, GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4, bytes));
    TRY(glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, bytes));
    TRY(glGenLists(-1));
    TRY(glGenLists(0));
    TRY(glDeleteLists(1, -1));
    TRY(glNewList(0, GL_COMPILE));
    TRY(glNewList(1, 0x1234));
    TRY(glEndList());
    TRY(glCallLists(-1, GL_UNSIGNED_BYTE, bytes));
    TRY(glCallLists(1, 0x1234, bytes));
    TRY(glCallList(4321));
    TRY(glNewList(1, GL_COMPILE));
    TRY(glNewList(2, GL_COMPILE));
    TRY(glDepthFunc(0x1234));
    TRY(glEndList());
    TRY(glCallList(1));
    TRY(glPopMatrix());
    TRY(glPopAttrib());
    TRY(glPopClientAttrib());
    TRY(glPopName());
    TRY(glLoadName(1));
    TRY(glPushName(1));
    TRY(glRenderMode(0x1234));
    TRY(glRenderMode(GL_SELECT));
    TRY(glRenderMode(GL_RENDER));
    TRY(glRenderMode(GL_FEEDBACK));
    glRenderMode(GL_RENDER);
    glGetError();
    TRY(glSelectBuffer(-1, names));
    TRY(glFeedbackBuffer(-1, GL_3D, f));
    TRY(glFeedbackBuffer(4, 0x1234, f));
    TRY(glSelectBuffer(8, names));
    TRY(glRenderMode(GL_SELECT));
    TRY(glSelectBuffer(8, names));
    TRY(glPopName());
    TRY(glLoadName(1));
    TRY(glPushName(2));
    TRY(glLoadName(3));
    TRY(glRenderMode(GL_RENDER));
    TRY(glClipPlane(GL_CLIP_PLANE0 + 8, (const GLdouble[]){0, 0, 0, 0}));
    TRY(glActiveTexture(GL_TEXTURE0 - 1));
    TRY(glPushAttrib(0));
    TRY(glPopAttrib());
    for (int i = 0; i < 20; i++)
        glPushAttrib(GL_ALL_ATTRIB_BITS);
    say_error("20 times glPushAttrib");
    for (int i = 0; i < 20; i++)
        glPopAttrib();
    say_error("20 times glPopAttrib");
    for (int i = 0; i < 40; i++)
        glPushMatrix();
    say_error("40 times glPushMatrix");
    glGetIntegerv(GL_MODELVIEW_STACK_DEPTH, n);
    say("depth %d", n[0]);
    for (int i = 0; i < 40; i++)
        glPopMatrix();
    say_error("40 times glPopMatrix");

    /* Only the first error is kept. */
    glEnable(0x1234);
    glPopMatrix();
    say_error("first");
    say_error("second");

    /* Between glBegin and glEnd. */
    glBegin(GL_TRIANGLES);
    glBegin(GL_TRIANGLES);
    glEnable(GL_BLEND);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glPushMatrix();
    glClear(GL_COLOR_BUFFER_BIT);
    glDepthFunc(GL_LESS);
    glFlush();
    glFinish();
    n[0] = -77;
    glGetIntegerv(GL_VIEWPORT, n);
    names[0] = glGenLists(1);
    names[1] = glIsEnabled(GL_BLEND);
    names[2] = glRenderMode(GL_SELECT);
    names[3] = glGetString(GL_VERSION) != NULL;
    glColor3f(1, 2, 3);
    glEdgeFlag(GL_TRUE);
    glMaterialf(GL_FRONT, GL_SHININESS, 3);
    glCallList(1);
    glEnd();
    say_error("between glBegin and glEnd");
    say("%d %u %u %d %u; %d", n[0], names[0], names[1], (int)names[2], names[3], glIsEnabled(GL_BLEND));
    static const char *const calls[] = {"glBegin", "glEnable", "glMatrixMode", "glClear", "glDepthFunc", "glFlush",
        "glViewport", "glNewList", "glGenLists", "glPushAttrib", "glLightf", "glGetFloatv", "glShadeModel", "glRotatef",
        "glClipPlane", "glRectf", "glRasterPos2f", "glReadPixels", "glGetError", "glHint", "glInitNames", "glPassThrough"};
    for (unsigned i = 0; i < sizeof calls / sizeof *calls; i++) {
        glBegin(GL_POINTS);
        switch (i) {
        case 0: glBegin(GL_POINTS); break;
        case 1: glEnable(GL_FOG); break;
        case 2: glMatrixMode(GL_MODELVIEW); break;
        case 3: glClear(0); break;
        case 4: glDepthFunc(GL_LESS); break;
        case 5: glFlush(); break;
        case 6: glViewport(0, 0, 1, 1); break;
        case 7: glNewList(7, GL_COMPILE); break;
        case 8: glGenLists(1); break;
        case 9: glPushAttrib(0); break;
        case 10: glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30); break;
        case 11: glGetFloatv(GL_FOG_START, f); break;
        case 12: glShadeModel(GL_FLAT); break;
        case 13: glRotatef(1, 1, 1, 1); break;
        case 14: glClipPlane(GL_CLIP_PLANE0, (const GLdouble[]){0, 0, 0, 0}); break;
        case 15: glRectf(0, 0, 1, 1); break;
        case 16: glRasterPos2f(0, 0); break;
        case 17: glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes); break;
        case 18: say("within: %#x", glGetError()); break;
        case 19: glHint(GL_FOG_HINT, GL_NICEST); break;
        case 20: glInitNames(); break;
        case 21: glPassThrough(1); break;
        }
        glEnd();
        say_error(calls[i]);
    }
}
