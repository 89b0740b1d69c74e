/* Frames of a mesh drawn by OpenGL, without a display: what luxel is timed beside.
 *
 *     cc -O2 frames.c -o frames -lEGL -lOpenGL -lm
 *     LP_NUM_THREADS=2 ./frames MESH.bin 640x480 none|back FRAMES LIGHTS
 *
 * The mesh as benches/rivals/src/main.rs says. The scene is the one of `luxel bench` in ../frames: eye
 * 3 away, turned about y from frame to frame, 45 degrees high; Blinn-Phong for each pixel, one
 * directional light and up to four attenuated points, one sample a pixel, 8-bit colours. Prints the
 * median and the least milliseconds from clearing to glFinish; nothing is read back. */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static void die(const char *what)
{
    fprintf(stderr, "%s\n", what);
    exit(1);
}

static const char *VERTEX =
    "#version 330 core\n"
    "layout(location = 0) in vec3 place; layout(location = 1) in vec3 normal;\n"
    "uniform vec2 turn; uniform float aspect; out vec3 at; out vec3 n;\n"
    "vec3 turned(vec3 v) { return vec3(turn.x * v.x + turn.y * v.z, v.y, turn.x * v.z - turn.y * v.x); }\n"
    "void main() {\n"
    "    at = turned(place) - vec3(0.0, 0.0, 3.0); n = turned(normal);\n"
    "    float f = 2.414213562;\n"
    "    gl_Position = vec4(f / aspect * at.x, f * at.y, (-10.1 * at.z - 2.0) / 9.9, -at.z);\n"
    "}\n";

static const char *FRAGMENT =
    "#version 330 core\n"
    "in vec3 at; in vec3 n; uniform int points; out vec4 color;\n"
    "void main() {\n"
    "    vec3 N = normalize(n), V = normalize(-at);\n"
    "    if (dot(N, V) < 0.0) N = -N;\n"
    "    vec3 base = vec3(0.8, 0.7, 0.6), sum = 0.1 * base;\n"
    "    vec3 L = normalize(vec3(0.4, 0.6, 1.0)), H = normalize(L + V);\n"
    "    float l = max(dot(N, L), 0.0);\n"
    "    sum += 0.6 * (base * l + (l > 0.0 ? 0.4 * pow(max(dot(N, H), 0.0), 32.0) : 0.0));\n"
    "    for (int i = 0; i < points; i++) {\n"
    "        vec3 from = vec3((i & 1) != 0 ? 1.5 : -1.5, (i & 2) != 0 ? 1.2 : -1.2, -1.5) - at;\n"
    "        float d = length(from), f = 0.3 / (1.0 + 0.1 * d + 0.05 * d * d);\n"
    "        L = from / d; H = normalize(L + V); l = max(dot(N, L), 0.0);\n"
    "        sum += f * (base * l + (l > 0.0 ? 0.4 * pow(max(dot(N, H), 0.0), 32.0) : 0.0));\n"
    "    }\n"
    "    color = vec4(sum, 1.0);\n"
    "}\n";

static GLuint compiled(GLenum kind, const char *text)
{
    GLuint shader = glCreateShader(kind);
    GLint good = 0;
    glShaderSource(shader, 1, &text, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        char log[1000];
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        die(log);
    }
    return shader;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1e3 + time.tv_nsec * 1e-6;
}

int main(int argc, char **argv)
{
    int width, height;
    if (argc < 6 || sscanf(argv[2], "%dx%d", &width, &height) != 2)
        die("frames MESH.bin WxH none|back FRAMES LIGHTS");
    int frames = atoi(argv[4]), lights = atoi(argv[5]);
    if (frames < 1 || frames > 10000 || lights < 1 || lights > 5) die("1 to 10000 frames, 1 to 5 lights");

    FILE *file = fopen(argv[1], "rb");
    uint32_t head[3];
    if (!file || fread(head, 4, 3, file) != 3 || memcmp(head, "CHM1", 4)) die("no CHM1 mesh");
    size_t vertices = head[1], triangles = head[2];
    float *points = malloc(vertices * 24);
    uint32_t *corners = malloc(triangles * 12);
    if (!points || !corners || fread(points, 24, vertices, file) != vertices ||
        fread(corners, 12, triangles, file) != triangles)
        die("too short");
    fclose(file);

    PFNEGLGETPLATFORMDISPLAYEXTPROC display_of =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    if (!display_of) die("no EGL platforms");
    EGLDisplay display = display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
    if (!eglInitialize(display, NULL, NULL) || !eglBindAPI(EGL_OPENGL_API)) die("no EGL");
    EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) die("no OpenGL 3.3");

    GLuint buffers[2], target, array, data[2];
    glGenFramebuffers(1, &target);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glGenRenderbuffers(2, buffers);
    GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
    GLenum places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int i = 0; i < 2; i++) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
        glRenderbufferStorage(GL_RENDERBUFFER, formats[i], width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, buffers[i]);
    }
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) die("no framebuffer");
    glViewport(0, 0, width, height);

    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(2, data);
    glBindBuffer(GL_ARRAY_BUFFER, data[0]);
    glBufferData(GL_ARRAY_BUFFER, vertices * 24, points, GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, data[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, triangles * 12, corners, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 2; i++) {
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, (void *)(i * vertices * 12));
        glEnableVertexAttribArray(i);
    }

    GLuint program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, VERTEX));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, FRAGMENT));
    glLinkProgram(program);
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "aspect"), (float)width / height);
    glUniform1i(glGetUniformLocation(program, "points"), lights - 1);
    GLint turn = glGetUniformLocation(program, "turn");
    glEnable(GL_DEPTH_TEST);
    if (!strcmp(argv[3], "back")) glEnable(GL_CULL_FACE);
    glClearColor(0, 0, 0, 0);

    double *times = malloc(sizeof(double) * frames);
    for (int frame = -1 - frames / 10; frame < frames; frame++) {
        double angle = 6.283185307 * frame / frames, start = now();
        glUniform2f(turn, (float)cos(angle), (float)sin(angle));
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glDrawElements(GL_TRIANGLES, (GLsizei)(triangles * 3), GL_UNSIGNED_INT, NULL);
        glFinish();
        if (frame >= 0) times[frame] = now() - start;
    }
    if (glGetError() != GL_NO_ERROR) die("OpenGL failed");
    qsort(times, frames, sizeof(double), by_size);
    printf("%.3f ms, least %.3f, %s\n", times[frames / 2], times[0], (const char *)glGetString(GL_RENDERER));
    return 0;
}
