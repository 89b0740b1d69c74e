/* EGL without a screen, under libglvnd: displays, configurations, pbuffers, contexts, and a picture.
 *
 *     cc egl.c -o egl -lEGL -lOpenGL && __EGL_VENDOR_LIBRARY_FILENAMES=50_luxel.json ./egl
 *
 * Prints each check that fails, and ends with 1 if one does. */
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
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

static void configurations(EGLDisplay display)
{
    static const EGLint good[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_RED_SIZE, 8,
        EGL_DEPTH_SIZE, 16, EGL_NONE};
    static const EGLint window[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    static const EGLint deep[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 32, EGL_NONE};
    static const EGLint unknown[] = {0x1234, 1, EGL_NONE};
    EGLConfig config = NULL;
    EGLint count = -1, value = -1;
    CHECK(eglGetConfigs(display, NULL, 0, &count) && count == 1);
    CHECK(eglChooseConfig(display, good, &config, 1, &count) && count == 1 && config != NULL);
    CHECK(eglChooseConfig(display, window, &config, 1, &count) && count == 0);
    CHECK(eglChooseConfig(display, deep, &config, 1, &count) && count == 0);
    CHECK(!eglChooseConfig(display, unknown, &config, 1, &count) && eglGetError() == EGL_BAD_ATTRIBUTE);
    CHECK(eglGetConfigAttrib(display, config, EGL_STENCIL_SIZE, &value) && value == 8);
    CHECK(!eglGetConfigAttrib(display, config, 0x1234, &value) && eglGetError() == EGL_BAD_ATTRIBUTE);
    CHECK(!eglGetConfigAttrib(display, (EGLConfig)&value, EGL_STENCIL_SIZE, &value) && eglGetError() == EGL_BAD_CONFIG);
}

static EGLConfig the_config(EGLDisplay display)
{
    EGLConfig config;
    EGLint count;
    eglGetConfigs(display, &config, 1, &count);
    return config;
}

static void surfaces(EGLDisplay display)
{
    EGLConfig config = the_config(display);
    EGLint value = -1;
    EGLSurface surface = eglCreatePbufferSurface(display, config, (const EGLint[]){EGL_WIDTH, 30, EGL_HEIGHT, 20, EGL_NONE});
    CHECK(surface != EGL_NO_SURFACE);
    CHECK(eglQuerySurface(display, surface, EGL_WIDTH, &value) && value == 30);
    CHECK(eglQuerySurface(display, surface, EGL_HEIGHT, &value) && value == 20);
    CHECK(!eglQuerySurface(display, surface, 0x1234, &value) && eglGetError() == EGL_BAD_ATTRIBUTE);
    CHECK(eglDestroySurface(display, surface));
    CHECK(!eglDestroySurface(display, surface) && eglGetError() == EGL_BAD_SURFACE);
    CHECK(eglCreatePbufferSurface(display, config, (const EGLint[]){EGL_WIDTH, -1, EGL_NONE}) == EGL_NO_SURFACE);
    CHECK(eglGetError() == EGL_BAD_PARAMETER);
    CHECK(eglCreatePbufferSurface(display, config, (const EGLint[]){EGL_WIDTH, 1 << 20, EGL_NONE}) == EGL_NO_SURFACE);
    CHECK(eglGetError() == EGL_BAD_ALLOC);
    CHECK(eglCreateWindowSurface(display, config, 0, NULL) == EGL_NO_SURFACE);
    CHECK(eglGetError() == EGL_BAD_NATIVE_WINDOW);
}

static void contexts(EGLDisplay display)
{
    EGLConfig config = the_config(display);
    EGLint value = -1;
    CHECK(eglBindAPI(EGL_OPENGL_API));
    CHECK(eglCreateContext(display, config, NULL, (const EGLint[]){EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE}) == EGL_NO_CONTEXT);
    CHECK(eglGetError() == EGL_BAD_MATCH);
    CHECK(eglCreateContext(display, config, NULL, (const EGLint[]){0x1234, 3, EGL_NONE}) == EGL_NO_CONTEXT);
    CHECK(eglGetError() == EGL_BAD_ATTRIBUTE);
    EGLContext context = eglCreateContext(display, config, NULL, (const EGLint[]){EGL_CONTEXT_MAJOR_VERSION, 1,
                                                                     EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE});
    CHECK(context != EGL_NO_CONTEXT);
    CHECK(eglQueryContext(display, context, EGL_CONTEXT_CLIENT_TYPE, &value) && value == EGL_OPENGL_API);
    EGLSurface surface = eglCreatePbufferSurface(display, config, (const EGLint[]){EGL_WIDTH, 30, EGL_HEIGHT, 20, EGL_NONE});
    CHECK(eglMakeCurrent(display, surface, surface, context));
    CHECK(eglGetCurrentContext() == context && eglGetCurrentSurface(EGL_DRAW) == surface);
    CHECK(strncmp((const char *)glGetString(GL_VERSION), "1.5", 3) == 0);
    GLint box[4];
    glGetIntegerv(GL_VIEWPORT, box);
    CHECK(box[2] == 30 && box[3] == 20);
    unsigned char pixel[4];
    glClearColor(0, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1, 0.5f, 0);
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, -1);
    glVertex2f(1, -1);
    glVertex2f(-1, 1);
    glEnd();
    CHECK(eglSwapBuffers(display, surface));
    glReadPixels(2, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(pixel[0] == 255 && pixel[1] == 128 && pixel[2] == 0);
    glReadPixels(28, 18, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(pixel[0] == 0 && pixel[2] == 255);
    CHECK(eglGetProcAddress("glActiveTexture") != NULL);
    /* Destroyed, but current: it lives on. */
    CHECK(eglDestroyContext(display, context));
    glReadPixels(2, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(pixel[0] == 255);
    CHECK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
    CHECK(!eglMakeCurrent(display, surface, surface, context));

    /* Without its surface, a context has no framebuffer of its own. */
    context = eglCreateContext(display, config, NULL, NULL);
    CHECK(eglMakeCurrent(display, surface, surface, context));
    CHECK(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    CHECK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context));
    CHECK(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_UNDEFINED);
    glClear(GL_COLOR_BUFFER_BIT);
    CHECK(glGetError() == GL_INVALID_FRAMEBUFFER_OPERATION);
    glReadPixels(2, 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(glGetError() == GL_INVALID_FRAMEBUFFER_OPERATION);
    CHECK(eglMakeCurrent(display, surface, surface, context));
    glClear(GL_COLOR_BUFFER_BIT);
    CHECK(glGetError() == GL_NO_ERROR);
    CHECK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT));
    CHECK(eglDestroyContext(display, context));
    CHECK(eglDestroySurface(display, surface));

    /* Without a configuration and a surface, and sharing lists. */
    EGLContext first = eglCreateContext(display, EGL_NO_CONFIG_KHR, NULL, NULL);
    EGLContext second = eglCreateContext(display, EGL_NO_CONFIG_KHR, first, NULL);
    CHECK(first != EGL_NO_CONTEXT && second != EGL_NO_CONTEXT);
    CHECK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, first));
    glNewList(7, GL_COMPILE);
    glEndList();
    CHECK(glIsList(7));
    CHECK(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, second));
    CHECK(glIsList(7));
    CHECK(eglReleaseThread());
    CHECK(eglDestroyContext(display, first) && eglDestroyContext(display, second));
}

int main(void)
{
    EGLint major = 0, minor = 0;
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    CHECK(display != EGL_NO_DISPLAY);
    CHECK(!eglGetConfigs(display, NULL, 0, &major) && eglGetError() == EGL_NOT_INITIALIZED);
    CHECK(eglInitialize(display, &major, &minor) && major == 1 && minor >= 4);
    CHECK(strcmp(eglQueryString(display, EGL_VENDOR), "luxel") == 0);
    CHECK(strstr(eglQueryString(display, EGL_CLIENT_APIS), "OpenGL") != NULL);
    CHECK(strstr(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context") != NULL);
    CHECK(eglQueryString(display, 0x1234) == NULL && eglGetError() == EGL_BAD_PARAMETER);
    configurations(display);
    surfaces(display);
    contexts(display);
    CHECK(eglTerminate(display));
    printf("%d checks, %d failed\n", checks, failures);
    return failures != 0;
}
