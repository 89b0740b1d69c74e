/* Every function of OSMesa, with good arguments and bad ones.
 *
 *     cc osmesa.c -o osmesa -lOSMesa -lpthread && ./osmesa [all]
 *
 * Prints each check that fails, and ends with 1 if one does. `all` adds what Mesa's library does otherwise: calls that
 * crash it, versions that it has, and a context that two threads want. */
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/gl.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

static int checks, failures;

#define CHECK(condition) check(condition, #condition, __LINE__)

static void check(int holds, const char *condition, int line)
{
    checks++;
    if (!holds) {
        failures++;
        printf("line %d: %s\n", line, condition);
    }
}

static unsigned char buffer[64 * 64 * 16], other[64 * 64 * 16];

static int value(GLint name)
{
    GLint found = -7;
    OSMesaGetIntegerv(name, &found);
    return found;
}

static int gl_value(GLenum name)
{
    GLint found = -7;
    glGetIntegerv(name, &found);
    return found;
}

static void leave(void)
{
    CHECK(OSMesaMakeCurrent(NULL, NULL, 0, 0, 0) == GL_TRUE);
    CHECK(OSMesaGetCurrentContext() == NULL);
}

static void clear(float red, float green, float blue, float alpha)
{
    glClearColor(red, green, blue, alpha);
    glClear(GL_COLOR_BUFFER_BIT);
}

static void formats_and_types(int all)
{
    static const struct {
        GLenum format, type;
        int bytes;
        unsigned char expected[16];
    } good[] = {
        {OSMESA_RGBA, GL_UNSIGNED_BYTE, 4, {255, 0, 51, 204}},
        {OSMESA_BGRA, GL_UNSIGNED_BYTE, 4, {51, 0, 255, 204}},
        {OSMESA_ARGB, GL_UNSIGNED_BYTE, 4, {204, 255, 0, 51}},
        {OSMESA_RGB, GL_UNSIGNED_BYTE, 3, {255, 0, 51}},
        {OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5, 2, {0x06, 0xf8}},
        {OSMESA_RGBA, GL_UNSIGNED_SHORT, 8, {0xff, 0xff, 0, 0, 0x33, 0x33, 0xcc, 0xcc}},
        {OSMESA_RGBA, GL_FLOAT, 16, {0, 0, 0x80, 0x3f, 0, 0, 0, 0}},
        /* Black in Mesa 22.3. */
        {OSMESA_RGB, GL_UNSIGNED_SHORT, 6, {0xff, 0xff, 0, 0, 0x33, 0x33}},
    };
    for (unsigned i = 0; i < sizeof good / sizeof *good - !all; i++) {
        OSMesaContext context = OSMesaCreateContextExt(good[i].format, 24, 8, 0, NULL);
        CHECK(context != NULL);
        memset(buffer, 77, sizeof buffer);
        CHECK(OSMesaMakeCurrent(context, buffer, good[i].type, 8, 8) == GL_TRUE);
        CHECK(value(OSMESA_FORMAT) == (GLint)good[i].format);
        CHECK(value(OSMESA_TYPE) == (GLint)good[i].type);
        clear(1, 0, 0.2f, 0.8f);
        glFinish();
        int compared = good[i].type == GL_FLOAT ? 8 : good[i].bytes;
        if (memcmp(buffer, good[i].expected, compared) != 0)
            printf("format %#x type %#x: %d %d %d %d\n", good[i].format, good[i].type, buffer[0], buffer[1], buffer[2], buffer[3]);
        CHECK(memcmp(buffer, good[i].expected, compared) == 0);
        CHECK(memcmp(buffer + 63 * good[i].bytes, good[i].expected, compared) == 0);
        CHECK(buffer[64 * good[i].bytes] == 77);
        leave();
        OSMesaDestroyContext(context);
    }
    static const GLenum no_buffer[][2] = {
        {OSMESA_BGR, GL_UNSIGNED_BYTE},      {OSMESA_COLOR_INDEX, GL_UNSIGNED_BYTE},
        {OSMESA_RGBA, GL_BYTE},              {OSMESA_RGBA, GL_UNSIGNED_INT},
        {OSMESA_RGBA, 0},                    {OSMESA_RGBA, GL_UNSIGNED_SHORT_5_6_5},
        {OSMESA_RGB_565, GL_UNSIGNED_BYTE},
    };
    for (unsigned i = 0; i < sizeof no_buffer / sizeof *no_buffer; i++) {
        OSMesaContext context = OSMesaCreateContext(no_buffer[i][0], NULL);
        CHECK(context != NULL);
        CHECK(OSMesaMakeCurrent(context, buffer, no_buffer[i][1], 8, 8) == GL_FALSE);
        CHECK(OSMesaGetCurrentContext() == NULL);
        OSMesaDestroyContext(context);
    }
    CHECK(OSMesaCreateContext(0, NULL) == NULL);
    CHECK(OSMesaCreateContext(GL_LUMINANCE, NULL) == NULL);
    CHECK(OSMesaCreateContextExt(OSMESA_RGBA, -1, 8, 0, NULL) == NULL);
}

static void bits(void)
{
    OSMesaContext plain = OSMesaCreateContext(OSMESA_RGBA, NULL);
    CHECK(OSMesaMakeCurrent(plain, buffer, GL_UNSIGNED_BYTE, 8, 8));
    CHECK(gl_value(GL_DEPTH_BITS) == 24 && gl_value(GL_STENCIL_BITS) == 8);
    CHECK(gl_value(GL_RED_BITS) == 8 && gl_value(GL_ALPHA_BITS) == 8);
    OSMesaDestroyContext(plain);
    CHECK(OSMesaGetCurrentContext() == NULL);
    OSMesaContext none = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, NULL);
    CHECK(OSMesaMakeCurrent(none, buffer, GL_UNSIGNED_BYTE, 8, 8));
    CHECK(gl_value(GL_DEPTH_BITS) == 0 && gl_value(GL_STENCIL_BITS) == 0);
    GLint width = -1, height = -1, bytes = -1;
    void *depths = &width;
    CHECK(OSMesaGetDepthBuffer(none, &width, &height, &bytes, &depths) == GL_FALSE);
    CHECK(width == 0 && height == 0 && bytes == 0 && depths == NULL);
    leave();
    OSMesaDestroyContext(none);
}

static void attributes(void)
{
    static const struct {
        int list[12], good;
    } lists[] = {
        {{0}, 1},
        {{OSMESA_FORMAT, OSMESA_BGRA, 0}, 1},
        {{OSMESA_DEPTH_BITS, 24, OSMESA_STENCIL_BITS, 8, OSMESA_ACCUM_BITS, 0, 0}, 1},
        {{OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, OSMESA_CONTEXT_MAJOR_VERSION, 1, OSMESA_CONTEXT_MINOR_VERSION, 5, 0}, 1},
        {{OSMESA_CONTEXT_MAJOR_VERSION, 9, 0}, 0},
        {{OSMESA_CONTEXT_MAJOR_VERSION, 0, 0}, 0},
        {{OSMESA_CONTEXT_MAJOR_VERSION, 1, OSMESA_CONTEXT_MINOR_VERSION, -1, 0}, 0},
        {{0x777, 1, 0}, 0},
        {{OSMESA_DEPTH_BITS, -1, 0}, 0},
        {{OSMESA_STENCIL_BITS, -1, 0}, 0},
        {{OSMESA_ACCUM_BITS, -1, 0}, 0},
        {{OSMESA_PROFILE, 99, 0}, 0},
    };
    for (unsigned i = 0; i < sizeof lists / sizeof *lists; i++) {
        OSMesaContext context = OSMesaCreateContextAttribs(lists[i].list, NULL);
        if ((context != NULL) != lists[i].good)
            printf("list %u\n", i);
        CHECK((context != NULL) == lists[i].good);
        if (context)
            OSMesaDestroyContext(context);
    }
    OSMesaContext context = OSMesaCreateContextAttribs(lists[2].list, NULL);
    CHECK(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 8, 8));
    CHECK(gl_value(GL_DEPTH_BITS) == 24 && gl_value(GL_STENCIL_BITS) == 8);
    leave();
    OSMesaDestroyContext(context);
}

static void buffers(void)
{
    OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, NULL);
    CHECK(OSMesaMakeCurrent(context, NULL, GL_UNSIGNED_BYTE, 8, 8) == GL_FALSE);
    CHECK(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 0, 8) == GL_FALSE);
    CHECK(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 8, -1) == GL_FALSE);
    CHECK(OSMesaMakeCurrent(NULL, buffer, GL_UNSIGNED_BYTE, 8, 8) == GL_FALSE);
    GLint width = -1, height = -1, format = -1;
    void *memory = &width;
    CHECK(OSMesaGetColorBuffer(context, &width, &height, &format, &memory) == GL_FALSE);
    CHECK(width == 0 && height == 0 && format == 0 && memory == NULL);

    memset(buffer, 77, sizeof buffer);
    CHECK(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 8, 6));
    CHECK(OSMesaGetCurrentContext() == context);
    CHECK(value(OSMESA_WIDTH) == 8 && value(OSMESA_HEIGHT) == 6);
    CHECK(value(OSMESA_MAX_WIDTH) == 16384 && value(OSMESA_MAX_HEIGHT) == 16384);
    CHECK(value(OSMESA_ROW_LENGTH) == 0 && value(OSMESA_Y_UP) == 1);
    CHECK(value(0x9999) == -7);
    CHECK(OSMesaGetColorBuffer(context, &width, &height, &format, &memory) == GL_TRUE);
    CHECK(width == 8 && height == 6 && format == OSMESA_RGBA && memory == buffer);
    GLint box[4];
    glGetIntegerv(GL_VIEWPORT, box);
    CHECK(box[0] == 0 && box[1] == 0 && box[2] == 8 && box[3] == 6);
    glGetIntegerv(GL_SCISSOR_BOX, box);
    CHECK(box[0] == 0 && box[1] == 0 && box[2] == 8 && box[3] == 6);

    /* It begins black, whatever lies in the caller's memory, which reading doesn't write. */
    unsigned char pixel[4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(pixel[0] == 0 && pixel[1] == 0 && pixel[2] == 0 && pixel[3] == 0);
    clear(1, 0.5f, 0.25f, 0);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(pixel[0] == 255 && pixel[1] == 128 && pixel[2] == 64 && pixel[3] == 0);
    CHECK(buffer[0] == 77);
    glFlush();
    CHECK(buffer[0] == 255 && buffer[1] == 128 && buffer[2] == 64 && buffer[3] == 0);
    CHECK(buffer[8 * 6 * 4] == 77);

    /* Leaving writes it too. */
    clear(0, 1, 0, 1);
    CHECK(buffer[0] == 255);
    leave();
    CHECK(buffer[0] == 0 && buffer[1] == 255);

    /* The picture stays with the context, and goes to the buffer of the time. The viewport was set once. */
    memset(other, 77, sizeof other);
    CHECK(OSMesaMakeCurrent(context, other, GL_UNSIGNED_BYTE, 8, 6));
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(pixel[0] == 0 && pixel[1] == 255);
    clear(0, 0, 1, 1);
    glFinish();
    CHECK(other[2] == 255 && buffer[2] == 0);
    CHECK(OSMesaMakeCurrent(context, other, GL_UNSIGNED_BYTE, 4, 16));
    glGetIntegerv(GL_VIEWPORT, box);
    CHECK(box[2] == 8 && box[3] == 6);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(pixel[0] == 0 && pixel[1] == 0 && pixel[2] == 0);
    CHECK(glGetError() == GL_NO_ERROR);

    /* A second context, with another buffer: the first is written when it is left. */
    OSMesaContext second = OSMesaCreateContext(OSMESA_RGBA, context);
    clear(1, 0, 0, 1);
    memset(buffer, 77, sizeof buffer);
    CHECK(OSMesaMakeCurrent(second, buffer, GL_UNSIGNED_BYTE, 8, 8));
    CHECK(OSMesaGetCurrentContext() == second);
    CHECK(other[0] == 255 && other[1] == 0 && buffer[0] == 77);
    OSMesaDestroyContext(second);
    OSMesaDestroyContext(context);
    CHECK(OSMesaGetCurrentContext() == NULL);
}

static void pixel_store(void)
{
    OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, NULL);
    CHECK(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 4, 4));
    glEnable(GL_SCISSOR_TEST);
    for (int up = 1; up >= 0; up--) {
        memset(buffer, 77, sizeof buffer);
        OSMesaPixelStore(OSMESA_Y_UP, 7 * up);
        CHECK(value(OSMESA_Y_UP) == up);
        glScissor(0, 0, 4, 4);
        clear(0, 0, 0, 1);
        glScissor(0, 0, 1, 1);
        clear(1, 1, 1, 1);
        glFinish();
        CHECK(buffer[0] == (up ? 255 : 0) && buffer[4 * 4 * 3] == (up ? 0 : 255));
    }
    OSMesaPixelStore(OSMESA_Y_UP, 1);
    OSMesaPixelStore(OSMESA_ROW_LENGTH, 10);
    CHECK(value(OSMESA_ROW_LENGTH) == 10);
    memset(buffer, 77, sizeof buffer);
    glScissor(0, 0, 4, 4);
    clear(1, 1, 1, 1);
    glFinish();
    CHECK(buffer[0] == 255 && buffer[15] == 255 && buffer[16] == 77 && buffer[39] == 77);
    CHECK(buffer[40] == 255 && buffer[40 * 3 + 15] == 255 && buffer[40 * 3 + 16] == 77);
    OSMesaPixelStore(0x4444, 3);
    CHECK(value(OSMESA_ROW_LENGTH) == 10 && glGetError() == GL_NO_ERROR);
    leave();
    OSMesaDestroyContext(context);
}

static void depths(void)
{
    OSMesaContext context = OSMesaCreateContext(OSMESA_RGBA, NULL);
    CHECK(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 8, 6));
    glClearDepth(0.5);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 5, 1, 1);
    glClearDepth(1);
    glClear(GL_DEPTH_BUFFER_BIT);
    GLint width = -1, height = -1, bytes = -1;
    void *memory = NULL;
    CHECK(OSMesaGetDepthBuffer(context, &width, &height, &bytes, &memory) == GL_TRUE);
    CHECK(width == 8 && height == 6 && bytes == 4 && memory != NULL);
    unsigned *depth = memory;
    CHECK((depth[0] & 0xffffff) == 0x800000 || (depth[0] & 0xffffff) == 0x7fffff);
    CHECK((depth[5 * 8] & 0xffffff) == 0xffffff);
    CHECK((depth[5 * 8 + 1] & 0xffffff) == (depth[0] & 0xffffff));
    leave();
    OSMesaDestroyContext(context);
}

static void addresses(void)
{
    CHECK(OSMesaGetProcAddress("glVertex3f") != NULL);
    CHECK(OSMesaGetProcAddress("glActiveTextureARB") != NULL);
    CHECK(OSMesaGetProcAddress("glUseProgram") != NULL);
    CHECK(OSMesaGetProcAddress("OSMesaMakeCurrent") != NULL);
    CHECK(OSMesaGetProcAddress("nothing") == NULL);
    CHECK(OSMesaGetProcAddress("") == NULL);
}

static void without_a_context(void)
{
    CHECK(OSMesaGetCurrentContext() == NULL);
    CHECK(glGetError() == GL_NO_ERROR);
    CHECK(glGetString(GL_VERSION) == NULL);
    glBegin(GL_TRIANGLES);
    glVertex3f(1, 2, 3);
    glEnd();
    CHECK(value(OSMESA_WIDTH) == 0);
    OSMesaDestroyContext(NULL);
}

static OSMesaContext wanted;

static void *take(void *result)
{
    static unsigned char own[8 * 8 * 4];
    *(int *)result = OSMesaMakeCurrent(wanted, own, GL_UNSIGNED_BYTE, 8, 8);
    /* The thread ends with the context, which leaves it. */
    return NULL;
}

static void threads(void)
{
    pthread_t thread;
    int taken = -1;
    wanted = OSMesaCreateContext(OSMESA_RGBA, NULL);
    CHECK(OSMesaMakeCurrent(wanted, buffer, GL_UNSIGNED_BYTE, 8, 8));
    pthread_create(&thread, NULL, take, &taken);
    pthread_join(thread, NULL);
    CHECK(taken == GL_FALSE);
    leave();
    pthread_create(&thread, NULL, take, &taken);
    pthread_join(thread, NULL);
    CHECK(taken == GL_TRUE);
    CHECK(OSMesaMakeCurrent(wanted, buffer, GL_UNSIGNED_BYTE, 8, 8));
    OSMesaDestroyContext(wanted);
}

/* Where Mesa crashes, or has more than OpenGL 1.5. */
static void beyond_mesa(void)
{
    static const int refused[][5] = {
        {OSMESA_PROFILE, OSMESA_CORE_PROFILE, 0},
        {OSMESA_CONTEXT_MAJOR_VERSION, 2, OSMESA_CONTEXT_MINOR_VERSION, 1, 0},
        {OSMESA_CONTEXT_MAJOR_VERSION, 1, OSMESA_CONTEXT_MINOR_VERSION, 6, 0},
        {OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 3, 0},
    };
    for (unsigned i = 0; i < sizeof refused / sizeof *refused; i++)
        CHECK(OSMesaCreateContextAttribs(refused[i], NULL) == NULL);
    OSMesaContext context = OSMesaCreateContextAttribs(NULL, NULL);
    CHECK(context != NULL);
    GLint width = -1, height = -1, bytes = -1;
    void *memory = &width;
    CHECK(OSMesaGetDepthBuffer(NULL, &width, &height, &bytes, &memory) == GL_FALSE && memory == NULL);
    CHECK(OSMesaGetDepthBuffer(context, &width, &height, &bytes, &memory) == GL_FALSE);
    CHECK(OSMesaGetColorBuffer(NULL, &width, &height, &bytes, &memory) == GL_FALSE);
    CHECK(OSMesaGetDepthBuffer(context, NULL, NULL, NULL, NULL) == GL_FALSE);
    OSMesaGetIntegerv(OSMESA_WIDTH, NULL);
    OSMesaGetIntegerv(OSMESA_FORMAT, &width);
    CHECK(width == 0);
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    OSMesaColorClamp(GL_TRUE);
    CHECK(OSMesaGetProcAddress("glNothing") == NULL && OSMesaGetProcAddress(NULL) == NULL);
    CHECK(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 16385, 1) == GL_FALSE);
    OSMesaPostprocess(context, "nothing", 1);
    OSMesaPostprocess(NULL, NULL, 0);

    /* Rows that would overlap are not written. */
    memset(buffer, 77, sizeof buffer);
    CHECK(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 8, 8));
    OSMesaPixelStore(OSMESA_ROW_LENGTH, 2);
    clear(1, 1, 1, 1);
    glFinish();
    CHECK(buffer[0] == 77);
    OSMesaPixelStore(OSMESA_ROW_LENGTH, -1);
    glFinish();
    CHECK(buffer[0] == 255);

    /* Null pointers where values are due set an error, and nothing else. */
    CHECK(glGetError() == GL_NO_ERROR);
    glVertex3fv(NULL);
    CHECK(glGetError() == GL_INVALID_VALUE);
    glLoadMatrixd(NULL);
    CHECK(glGetError() == GL_INVALID_VALUE);
    glGetIntegerv(GL_VIEWPORT, NULL);
    CHECK(glGetError() == GL_INVALID_VALUE);
    glReadPixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    CHECK(glGetError() == GL_INVALID_VALUE);
    glCallLists(3, GL_UNSIGNED_BYTE, NULL);
    CHECK(glGetError() == GL_INVALID_VALUE);

    /* Handles that were destroyed, or never were one. */
    OSMesaDestroyContext(context);
    CHECK(OSMesaMakeCurrent(context, buffer, GL_UNSIGNED_BYTE, 8, 8) == GL_FALSE);
    OSMesaDestroyContext(context);
    OSMesaDestroyContext((OSMesaContext)buffer);
    CHECK(OSMesaCreateContext(OSMESA_RGBA, (OSMesaContext)buffer) == NULL);
    threads();
}

int main(int count, char **arguments)
{
    setvbuf(stdout, NULL, _IOLBF, 0);
    int all = count > 1 && strcmp(arguments[1], "all") == 0;
    without_a_context();
    formats_and_types(all);
    bits();
    attributes();
    buffers();
    pixel_store();
    depths();
    addresses();
    if (all)
        beyond_mesa();
    without_a_context();
    printf("%d checks, %d failed\n", checks, failures);
    return failures != 0;
}
