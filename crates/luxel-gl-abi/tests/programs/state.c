/* The initial state, as all four types of queries give it (6.1, 6.2): what depends on the implementation is left out. */
#include "program.h"

#define NAMED(name) {name, #name}

static const struct {
    GLenum pname;
    const char *name;
} names[] = {
    NAMED(GL_ACCUM_CLEAR_VALUE), NAMED(GL_ACTIVE_TEXTURE), NAMED(GL_ALPHA_TEST), NAMED(GL_ALPHA_TEST_FUNC),
    NAMED(GL_ALPHA_TEST_REF), NAMED(GL_ATTRIB_STACK_DEPTH), NAMED(GL_AUTO_NORMAL), NAMED(GL_BLEND), NAMED(GL_BLEND_COLOR),
    NAMED(GL_BLEND_DST), NAMED(GL_BLEND_DST_ALPHA), NAMED(GL_BLEND_DST_RGB), NAMED(GL_BLEND_EQUATION), NAMED(GL_BLEND_SRC),
    NAMED(GL_BLEND_SRC_ALPHA), NAMED(GL_BLEND_SRC_RGB), NAMED(GL_CLIENT_ACTIVE_TEXTURE), NAMED(GL_CLIENT_ATTRIB_STACK_DEPTH),
    NAMED(GL_CLIP_PLANE0), NAMED(GL_CLIP_PLANE5), NAMED(GL_COLOR_CLEAR_VALUE), NAMED(GL_COLOR_LOGIC_OP),
    NAMED(GL_COLOR_MATERIAL), NAMED(GL_COLOR_MATERIAL_FACE), NAMED(GL_COLOR_MATERIAL_PARAMETER), NAMED(GL_COLOR_SUM),
    NAMED(GL_COLOR_WRITEMASK), NAMED(GL_CULL_FACE), NAMED(GL_CULL_FACE_MODE), NAMED(GL_CURRENT_COLOR),
    NAMED(GL_CURRENT_FOG_COORD), NAMED(GL_CURRENT_INDEX), NAMED(GL_CURRENT_NORMAL), NAMED(GL_CURRENT_RASTER_COLOR),
    NAMED(GL_CURRENT_RASTER_DISTANCE), NAMED(GL_CURRENT_RASTER_POSITION), NAMED(GL_CURRENT_RASTER_POSITION_VALID),
    NAMED(GL_CURRENT_RASTER_TEXTURE_COORDS), NAMED(GL_CURRENT_SECONDARY_COLOR), NAMED(GL_CURRENT_TEXTURE_COORDS),
    NAMED(GL_DEPTH_CLEAR_VALUE), NAMED(GL_DEPTH_FUNC), NAMED(GL_DEPTH_RANGE), NAMED(GL_DEPTH_TEST), NAMED(GL_DEPTH_WRITEMASK),
    NAMED(GL_DITHER), NAMED(GL_EDGE_FLAG), NAMED(GL_FEEDBACK_BUFFER_SIZE), NAMED(GL_FEEDBACK_BUFFER_TYPE), NAMED(GL_FOG),
    NAMED(GL_FOG_COLOR), NAMED(GL_FOG_COORD_SRC), NAMED(GL_FOG_DENSITY), NAMED(GL_FOG_END), NAMED(GL_FOG_HINT),
    NAMED(GL_FOG_INDEX), NAMED(GL_FOG_MODE), NAMED(GL_FOG_START), NAMED(GL_FRONT_FACE), NAMED(GL_INDEX_CLEAR_VALUE),
    NAMED(GL_LIGHT0), NAMED(GL_LIGHT7), NAMED(GL_LIGHTING), NAMED(GL_LIGHT_MODEL_AMBIENT),
    NAMED(GL_LIGHT_MODEL_COLOR_CONTROL), NAMED(GL_LIGHT_MODEL_LOCAL_VIEWER), NAMED(GL_LIGHT_MODEL_TWO_SIDE),
    NAMED(GL_LINE_SMOOTH), NAMED(GL_LINE_SMOOTH_HINT), NAMED(GL_LINE_STIPPLE), NAMED(GL_LINE_STIPPLE_PATTERN),
    NAMED(GL_LINE_STIPPLE_REPEAT), NAMED(GL_LINE_WIDTH), NAMED(GL_LIST_BASE), NAMED(GL_LIST_INDEX), NAMED(GL_LIST_MODE),
    NAMED(GL_LOGIC_OP_MODE), NAMED(GL_MATRIX_MODE), NAMED(GL_MODELVIEW_MATRIX), NAMED(GL_MODELVIEW_STACK_DEPTH),
    NAMED(GL_NAME_STACK_DEPTH), NAMED(GL_NORMALIZE), NAMED(GL_PACK_ALIGNMENT), NAMED(GL_PACK_LSB_FIRST),
    NAMED(GL_PACK_ROW_LENGTH), NAMED(GL_PACK_SKIP_PIXELS), NAMED(GL_PACK_SKIP_ROWS), NAMED(GL_PACK_SWAP_BYTES),
    NAMED(GL_PERSPECTIVE_CORRECTION_HINT), NAMED(GL_POINT_DISTANCE_ATTENUATION), NAMED(GL_POINT_FADE_THRESHOLD_SIZE),
    NAMED(GL_POINT_SIZE), NAMED(GL_POINT_SIZE_MIN), NAMED(GL_POINT_SMOOTH), NAMED(GL_POINT_SMOOTH_HINT), NAMED(GL_POLYGON_MODE),
    NAMED(GL_POLYGON_OFFSET_FACTOR), NAMED(GL_POLYGON_OFFSET_FILL), NAMED(GL_POLYGON_OFFSET_LINE),
    NAMED(GL_POLYGON_OFFSET_POINT), NAMED(GL_POLYGON_OFFSET_UNITS), NAMED(GL_POLYGON_SMOOTH), NAMED(GL_POLYGON_SMOOTH_HINT),
    NAMED(GL_POLYGON_STIPPLE), NAMED(GL_PROJECTION_MATRIX), NAMED(GL_PROJECTION_STACK_DEPTH), NAMED(GL_RENDER_MODE),
    NAMED(GL_RESCALE_NORMAL), NAMED(GL_SCISSOR_BOX), NAMED(GL_SCISSOR_TEST), NAMED(GL_SELECTION_BUFFER_SIZE),
    NAMED(GL_SHADE_MODEL), NAMED(GL_STENCIL_CLEAR_VALUE), NAMED(GL_STENCIL_FAIL), NAMED(GL_STENCIL_FUNC),
    NAMED(GL_STENCIL_PASS_DEPTH_FAIL), NAMED(GL_STENCIL_PASS_DEPTH_PASS), NAMED(GL_STENCIL_REF), NAMED(GL_STENCIL_TEST),
    NAMED(GL_TEXTURE_1D), NAMED(GL_TEXTURE_2D), NAMED(GL_TEXTURE_3D), NAMED(GL_TEXTURE_CUBE_MAP), NAMED(GL_TEXTURE_GEN_Q),
    NAMED(GL_TEXTURE_GEN_S), NAMED(GL_TEXTURE_MATRIX), NAMED(GL_TEXTURE_STACK_DEPTH), NAMED(GL_TRANSPOSE_MODELVIEW_MATRIX),
    NAMED(GL_UNPACK_ALIGNMENT), NAMED(GL_UNPACK_LSB_FIRST), NAMED(GL_UNPACK_ROW_LENGTH), NAMED(GL_UNPACK_SKIP_IMAGES),
    NAMED(GL_UNPACK_SWAP_BYTES), NAMED(GL_VIEWPORT), NAMED(GL_DOUBLEBUFFER), NAMED(GL_STEREO), NAMED(GL_RGBA_MODE),
    NAMED(GL_INDEX_MODE), NAMED(GL_MAX_LIGHTS), NAMED(GL_MAX_MODELVIEW_STACK_DEPTH), NAMED(GL_MAX_NAME_STACK_DEPTH),
    NAMED(GL_MAX_LIST_NESTING), NAMED(GL_MAX_ATTRIB_STACK_DEPTH), NAMED(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH),
    NAMED(GL_MAX_CLIP_PLANES), NAMED(GL_MAX_PROJECTION_STACK_DEPTH), NAMED(GL_MAX_TEXTURE_STACK_DEPTH),
    NAMED(GL_MAX_VIEWPORT_DIMS), NAMED(GL_SUBPIXEL_BITS), NAMED(GL_RED_BITS), NAMED(GL_ALPHA_BITS), NAMED(GL_DEPTH_BITS),
    NAMED(GL_STENCIL_BITS),
};

static void say_state(void)
{
    for (unsigned i = 0; i < sizeof names / sizeof *names; i++) {
        /* What isn't written stays at -77. */
        GLint integers[17];
        GLfloat floats[17];
        GLdouble doubles[17];
        GLboolean booleans[17];
        char line[1024] = "";
        for (int at = 0; at < 17; at++) {
            integers[at] = -77;
            doubles[at] = floats[at] = -77;
            booleans[at] = 77;
        }
        glGetIntegerv(names[i].pname, integers);
        glGetFloatv(names[i].pname, floats);
        glGetDoublev(names[i].pname, doubles);
        glGetBooleanv(names[i].pname, booleans);
        /* Mesa takes the values of matrices for colours (6.1.2). */
        if (strstr(names[i].name, "_MATRIX"))
            for (int at = 0; at < 16; at++)
                integers[at] = 0;
        for (int at = 0; at < 17 && (integers[at] != -77 || doubles[at] != -77 || booleans[at] != 77); at++)
            sprintf(line + strlen(line), " %d/%.4g/%.4g/%d", integers[at], floats[at], doubles[at], booleans[at]);
        say("%s%s", names[i].name, line);
        say_error(names[i].name);
    }
}

static void say_parameters(void)
{
    static const GLenum of_light[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION, GL_SPOT_EXPONENT,
        GL_SPOT_CUTOFF, GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION, GL_QUADRATIC_ATTENUATION};
    static const GLenum of_material[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES};
    for (int light = 0; light < 2; light++)
        for (unsigned i = 0; i < sizeof of_light / sizeof *of_light; i++) {
            GLfloat f[5] = {-77, -77, -77, -77, -77};
            GLint n[5] = {-77, -77, -77, -77, -77};
            glGetLightfv(GL_LIGHT0 + light, of_light[i], f);
            glGetLightiv(GL_LIGHT0 + light, of_light[i], n);
            /* Mesa truncates numbers that are not colours, against 6.1.2. */
            if (of_light[i] >= GL_POSITION)
                memset(n, 0, sizeof n);
            say("light %d %#x: %.4g %.4g %.4g %.4g %g; %d %d %d %d %d", light, of_light[i], f[0], f[1], f[2], f[3], f[4], n[0], n[1], n[2],
                n[3], n[4]);
        }
    for (int back = 0; back < 2; back++)
        for (unsigned i = 0; i < sizeof of_material / sizeof *of_material; i++) {
            GLfloat f[5] = {-77, -77, -77, -77, -77};
            GLint n[5] = {-77, -77, -77, -77, -77};
            glGetMaterialfv(back ? GL_BACK : GL_FRONT, of_material[i], f);
            glGetMaterialiv(back ? GL_BACK : GL_FRONT, of_material[i], n);
            say("material %d %#x: %g %g %g %g %g; %d %d %d %d %d", back, of_material[i], f[0], f[1], f[2], f[3], f[4], n[0], n[1],
                n[2], n[3], n[4]);
        }
    for (int plane = 0; plane < 6; plane++) {
        GLdouble equation[4] = {-77, -77, -77, -77};
        glGetClipPlane(GL_CLIP_PLANE0 + plane, equation);
        say("plane %d: %.4g %.4g %.4g %.4g", plane, equation[0], equation[1], equation[2], equation[3]);
    }
    GLubyte stipple[128];
    memset(stipple, 77, sizeof stipple);
    glGetPolygonStipple(stipple);
    int sum = 0;
    for (int i = 0; i < 128; i++)
        sum += stipple[i];
    say("stipple: %d", sum);
}

static void draw(void)
{
    say_state();
    say_parameters();
    /* The same once more, with other values. */
    glColor4us(65535, 32768, 0, 16384);
    glNormal3b(127, -128, 0);
    glTexCoord3s(1, -2, 3);
    glSecondaryColor3ub(255, 51, 0);
    glFogCoordd(2.5);
    glIndexi(7);
    glEdgeFlag(GL_FALSE);
    glClearColor(2, -1, 0.25f, 0.5f);
    glClearDepth(0.3);
    glClearStencil(-1);
    glClearAccum(2, -2, 0.5f, 0.25f);
    glColorMask(GL_TRUE, GL_FALSE, 7, GL_FALSE);
    glDepthRange(0.75, -3);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    glAlphaFunc(GL_GREATER, 0.3f);
    glBlendColor(2, -1, 0.5f, 0.25f);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE, GL_DST_COLOR, GL_ZERO);
    glBlendEquation(GL_FUNC_SUBTRACT);
    glStencilFunc(GL_NOTEQUAL, 300, 0x55);
    glStencilOp(GL_INCR, GL_DECR, GL_INVERT);
    glLogicOp(GL_XOR);
    glCullFace(GL_FRONT_AND_BACK);
    glFrontFace(GL_CW);
    glPolygonMode(GL_FRONT, GL_LINE);
    glPolygonMode(GL_BACK, GL_POINT);
    glPolygonOffset(1.5f, -2);
    glLineWidth(3);
    glLineStipple(300, 0xabcd);
    glPointSize(4);
    glPointParameterf(GL_POINT_SIZE_MIN, 2);
    glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, (const GLfloat[]){1, 2, 3});
    glShadeModel(GL_FLAT);
    glFogi(GL_FOG_MODE, GL_LINEAR);
    glFogf(GL_FOG_DENSITY, 2);
    glFogiv(GL_FOG_COLOR, (const GLint[]){2147483647, 0, -2147483647, 1073741824});
    glFogi(GL_FOG_START, 3);
    glFogf(GL_FOG_END, -4);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 3);
    glLightModelf(GL_LIGHT_MODEL_LOCAL_VIEWER, 0.5f);
    glLightModeliv(GL_LIGHT_MODEL_AMBIENT, (const GLint[]){2147483647, 0, 1073741824, 0});
    glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    glColorMaterial(GL_FRONT, GL_SPECULAR);
    glMatrixMode(GL_MODELVIEW);
    glTranslatef(1, 2, 3);
    glRotated(30, 1, 1, 0);
    glLightfv(GL_LIGHT0, GL_POSITION, (const GLfloat[]){1, 2, 3, 1});
    glLightfv(GL_LIGHT0, GL_SPOT_DIRECTION, (const GLfloat[]){1, 0, 0});
    glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 30);
    glLighti(GL_LIGHT0, GL_SPOT_EXPONENT, 5);
    glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.5f);
    glLightiv(GL_LIGHT0, GL_SPECULAR, (const GLint[]){2147483647, 0, -2147483647, 1073741824});
    glLightiv(GL_LIGHT1, GL_POSITION, (const GLint[]){1, 2, 3, 0});
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, (const GLfloat[]){1, -1, 0.5f, 0.25f});
    glMateriali(GL_FRONT, GL_SHININESS, 64);
    glMaterialiv(GL_BACK, GL_EMISSION, (const GLint[]){2147483647, 0, -2147483647, 1073741824});
    glMaterialfv(GL_FRONT, GL_COLOR_INDEXES, (const GLfloat[]){3, 4, 5});
    glClipPlane(GL_CLIP_PLANE1, (const GLdouble[]){1, 2, 3, 4});
    glPixelStoref(GL_PACK_ALIGNMENT, 2);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 9);
    glPixelStorei(GL_UNPACK_SWAP_BYTES, 5);
    glHint(GL_FOG_HINT, GL_NICEST);
    glListBase(5);
    glScissor(1, 2, 3, 4);
    glViewport(-5, 6, 100, 200);
    glActiveTexture(GL_TEXTURE1);
    glMultiTexCoord4d(GL_TEXTURE1, 1, 2, 3, 4);
    glMatrixMode(GL_TEXTURE);
    glScaled(2, 3, 4);
    glPushMatrix();
    static const GLenum caps[] = {GL_ALPHA_TEST, GL_BLEND, GL_CLIP_PLANE1, GL_COLOR_MATERIAL, GL_CULL_FACE, GL_FOG, GL_LIGHT3,
        GL_LINE_STIPPLE, GL_NORMALIZE, GL_POLYGON_OFFSET_LINE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_TEXTURE_2D};
    for (unsigned i = 0; i < sizeof caps / sizeof *caps; i++)
        glEnable(caps[i]);
    say_error("all set");
    say_state();
    say_parameters();
    /* So that the clear of the comparison is whole. */
    glDisable(GL_SCISSOR_TEST);
    glColorMask(1, 1, 1, 1);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}
