/* Attribute stacks (6.1.12 to 6.1.14): which state each bit keeps. */
#include "program.h"

static const struct {
    GLenum pname;
    const char *name;
    int count;
} states[] = {{GL_CURRENT_COLOR, "color", 4}, {GL_CURRENT_NORMAL, "normal", 3}, {GL_CURRENT_TEXTURE_COORDS, "texture", 4},
    {GL_EDGE_FLAG, "edge", 1}, {GL_POINT_SIZE, "point", 1}, {GL_POINT_SMOOTH, "point smooth", 1}, {GL_LINE_WIDTH, "line", 1},
    {GL_LINE_STIPPLE, "line stipple", 1}, {GL_CULL_FACE, "cull", 1}, {GL_CULL_FACE_MODE, "cull mode", 1},
    {GL_POLYGON_MODE, "polygon", 2}, {GL_POLYGON_OFFSET_FACTOR, "offset", 1}, {GL_POLYGON_STIPPLE, "stipple", 1},
    {GL_LIGHTING, "lighting", 1}, {GL_LIGHT_MODEL_TWO_SIDE, "two sides", 1}, {GL_SHADE_MODEL, "shade", 1},
    {GL_COLOR_MATERIAL, "color material", 1}, {GL_FOG, "fog", 1}, {GL_FOG_DENSITY, "density", 1}, {GL_DEPTH_TEST, "depth", 1},
    {GL_DEPTH_FUNC, "depth func", 1}, {GL_DEPTH_WRITEMASK, "depth mask", 1}, {GL_ACCUM_CLEAR_VALUE, "accum", 4},
    {GL_STENCIL_TEST, "stencil", 1}, {GL_STENCIL_REF, "stencil ref", 1}, {GL_STENCIL_WRITEMASK, "stencil mask", 1},
    {GL_VIEWPORT, "viewport", 4}, {GL_DEPTH_RANGE, "range", 2}, {GL_MATRIX_MODE, "matrix mode", 1}, {GL_NORMALIZE, "normalize", 1},
    {GL_CLIP_PLANE1, "plane", 1}, {GL_BLEND, "blend", 1}, {GL_BLEND_SRC, "blend source", 1}, {GL_ALPHA_TEST, "alpha", 1},
    {GL_COLOR_CLEAR_VALUE, "clear", 4}, {GL_COLOR_WRITEMASK, "color mask", 4}, {GL_DITHER, "dither", 1},
    {GL_LOGIC_OP_MODE, "logic", 1}, {GL_FOG_HINT, "fog hint", 1}, {GL_LIST_BASE, "list base", 1}, {GL_SCISSOR_TEST, "scissor", 1},
    {GL_SCISSOR_BOX, "box", 4}, {GL_AUTO_NORMAL, "auto normal", 1}, {GL_TEXTURE_2D, "texture 2D", 1},
    {GL_TEXTURE_GEN_S, "generate s", 1}, {GL_ACTIVE_TEXTURE, "unit", 1}, {GL_PACK_ALIGNMENT, "pack", 1},
    {GL_UNPACK_ROW_LENGTH, "unpack", 1}, {GL_MULTISAMPLE, "multisample", 1}};

enum { STATES = sizeof states / sizeof *states };

static void read_states(GLfloat (*values)[4])
{
    memset(values, 0, STATES * sizeof *values);
    for (int i = 0; i < STATES; i++)
        glGetFloatv(states[i].pname, values[i]);
}

static void set_all(void)
{
    static const GLenum caps[] = {GL_POINT_SMOOTH, GL_LINE_STIPPLE, GL_CULL_FACE, GL_POLYGON_STIPPLE, GL_LIGHTING, GL_LIGHT2,
        GL_COLOR_MATERIAL, GL_FOG, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_NORMALIZE, GL_CLIP_PLANE1, GL_BLEND, GL_ALPHA_TEST,
        GL_SCISSOR_TEST, GL_AUTO_NORMAL, GL_TEXTURE_2D, GL_TEXTURE_GEN_S};
    for (unsigned i = 0; i < sizeof caps / sizeof *caps; i++)
        glEnable(caps[i]);
    glDisable(GL_DITHER);
    glDisable(GL_MULTISAMPLE);
    glColor4f(0.1f, 0.2f, 0.3f, 0.4f);
    glNormal3f(1, 2, 3);
    glTexCoord2f(5, 6);
    glEdgeFlag(GL_FALSE);
    glPointSize(3);
    glLineWidth(2);
    glCullFace(GL_FRONT);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glPolygonOffset(2, 3);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    glShadeModel(GL_FLAT);
    glFogf(GL_FOG_DENSITY, 0.5f);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    glClearAccum(0.1f, 0.2f, 0.3f, 0.4f);
    glStencilFunc(GL_LESS, 3, 255);
    glStencilMask(15);
    glViewport(1, 2, 30, 40);
    glDepthRange(0.2, 0.8);
    glMatrixMode(GL_TEXTURE);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE);
    glClearColor(0.5f, 0.25f, 0.125f, 1);
    glColorMask(1, 0, 1, 0);
    glLogicOp(GL_XOR);
    glHint(GL_FOG_HINT, GL_NICEST);
    glListBase(7);
    glScissor(1, 2, 3, 4);
    glActiveTexture(GL_TEXTURE1);
    glPixelStorei(GL_PACK_ALIGNMENT, 8);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 5);
}

static void draw(void)
{
    static const struct {
        GLbitfield bit;
        const char *name;
    } bits[] = {{GL_CURRENT_BIT, "current"}, {GL_POINT_BIT, "point"}, {GL_LINE_BIT, "line"}, {GL_POLYGON_BIT, "polygon"},
        {GL_POLYGON_STIPPLE_BIT, "polygon stipple"}, {GL_PIXEL_MODE_BIT, "pixel mode"}, {GL_LIGHTING_BIT, "lighting"},
        {GL_FOG_BIT, "fog"}, {GL_DEPTH_BUFFER_BIT, "depth"}, {GL_ACCUM_BUFFER_BIT, "accum"}, {GL_STENCIL_BUFFER_BIT, "stencil"},
        {GL_VIEWPORT_BIT, "viewport"}, {GL_TRANSFORM_BIT, "transform"}, {GL_ENABLE_BIT, "enable"}, {GL_COLOR_BUFFER_BIT, "color"},
        {GL_HINT_BIT, "hint"}, {GL_EVAL_BIT, "eval"}, {GL_LIST_BIT, "list"}, {GL_TEXTURE_BIT, "texture"}, {GL_SCISSOR_BIT, "scissor"},
        {GL_MULTISAMPLE_BIT, "multisample"}, {GL_ALL_ATTRIB_BITS, "all"}, {0, "none"}};
    static GLfloat before[STATES][4], after[STATES][4];
    static unsigned char own[WIDTH * HEIGHT * 4];
    OSMesaContext context = OSMesaGetCurrentContext();
    for (unsigned i = 0; i < sizeof bits / sizeof *bits; i++) {
        /* A new context each time, as Mesa loses changes between nested pushes. */
        OSMesaContext fresh = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
        char line[2048] = "";
        OSMesaMakeCurrent(fresh, own, GL_UNSIGNED_BYTE, WIDTH, HEIGHT);
        read_states(before);
        glPushAttrib(bits[i].bit);
        set_all();
        glPopAttrib();
        read_states(after);
        for (int s = 0; s < STATES; s++)
            if (memcmp(before[s], after[s], sizeof *before) == 0)
                sprintf(line + strlen(line), " %s;", states[s].name);
        say("%s keeps%s", bits[i].name, line);
        say_error(bits[i].name);
        OSMesaDestroyContext(fresh);
    }
    for (int i = 0; i < 3; i++) {
        static const GLbitfield client[] = {GL_CLIENT_PIXEL_STORE_BIT, GL_CLIENT_VERTEX_ARRAY_BIT, GL_CLIENT_ALL_ATTRIB_BITS};
        OSMesaContext fresh = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
        GLint alignment, length;
        OSMesaMakeCurrent(fresh, own, GL_UNSIGNED_BYTE, WIDTH, HEIGHT);
        glPushClientAttrib(client[i]);
        set_all();
        glPopClientAttrib();
        glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
        glGetIntegerv(GL_UNPACK_ROW_LENGTH, &length);
        say("client %d: %d %d", i, alignment, length);
        say_error("client");
        OSMesaDestroyContext(fresh);
    }
    OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, WIDTH, HEIGHT);
    GLint depth;
    glGetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
    say("depth %d", depth);
    /* Lights come back, too; Mesa loses materials, and GL_ENABLE_BIT's lights. */
    glPushAttrib(GL_LIGHTING_BIT);
    glLightfv(GL_LIGHT1, GL_POSITION, (const float[]){1, 2, 3, 1});
    glPopAttrib();
    GLfloat values[4];
    glGetLightfv(GL_LIGHT1, GL_POSITION, values);
    say("position %g %g %g %g", values[0], values[1], values[2], values[3]);
    glClear(GL_COLOR_BUFFER_BIT);
}
