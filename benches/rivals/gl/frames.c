/* Frames of a mesh drawn by OpenGL, without a display: what luxel is timed beside.
 *
 *     cc -O2 frames.c -o frames -lEGL -lOpenGL -lm
 *     LP_NUM_THREADS=2 ./frames MESH.bin 640x480 none|back FRAMES LIGHTS phong|gouraud [PICTURE.ppm]
 *
 * The mesh as benches/rivals/src/main.rs says. The scene is the one of `luxel bench` in ../frames: eye
 * 3 away, turned about y from frame to frame, 45 degrees high; one directional light and up to four
 * attenuated points, one sample a pixel, 8-bit colours. phong is Blinn-Phong for each pixel, by a shader;
 * gouraud the same equation at vertices, by OpenGL's own lights (normals have to be of unit length).
 * Prints the median and the least milliseconds from clearing to glFinish; nothing is read back, but
 * for the picture, which is the first frame's and drawn once more when all is timed. */
#include <EGL/egl.h>
#include <EGL/eglext.h>
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
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
    "layout(location = 0) in vec3 place; layout(location = 1) in vec3 normal;\n"
    "uniform vec2 turn; uniform float aspect; out vec3 at; out vec3 n;\n"
    "vec3 turned(vec3 v) { return vec3(turn.x * v.x + turn.y * v.z, v.y, turn.x * v.z - turn.y * v.x); }\n"
    "void main() {\n"
    "    at = turned(place) - vec3(0.0, 0.0, 3.0); n = turned(normal);\n"
    "    float f = 2.414213562;\n"
    "    gl_Position = vec4(f / aspect * at.x, f * at.y, (-10.1 * at.z - 2.0) / 9.9, -at.z);\n"
    "}\n";

static const char *FRAGMENT =
    "in vec3 at; in vec3 n; out vec4 color;\n"
    "void main() {\n"
    "    vec3 N = normalize(n), V = normalize(-at);\n"
    "    if (!gl_FrontFacing) N = -N;\n"
    "    vec3 base = vec3(0.8, 0.7, 0.6), sum = 0.1 * base;\n"
    "    vec3 L = normalize(vec3(0.4, 0.6, 1.0)), H = normalize(L + V);\n"
    "    float l = max(dot(N, L), 0.0);\n"
    "    sum += 0.6 * (base * l + (l > 0.0 ? 0.4 * pow(max(dot(N, H), 0.0), 32.0) : 0.0));\n"
    "    for (int i = 0; i < POINTS; i++) {\n"
    "        vec3 from = vec3((i & 1) != 0 ? 1.5 : -1.5, (i & 2) != 0 ? 1.2 : -1.2, -1.5) - at;\n"
    "        float d = length(from), f = 0.3 / (1.0 + 0.1 * d + 0.05 * d * d);\n"
    "        L = from / d; H = normalize(L + V); l = max(dot(N, L), 0.0);\n"
    "        sum += f * (base * l + (l > 0.0 ? 0.4 * pow(max(dot(N, H), 0.0), 32.0) : 0.0));\n"
    "    }\n"
    "    color = vec4(sum, 1.0);\n"
    "}\n";

/* For so many lights that are points, so that the compiler knows how many. */
static GLuint compiled(GLenum kind, const char *text, int points)
{
    GLuint shader = glCreateShader(kind);
    GLint good = 0;
    char head[100];
    snprintf(head, sizeof head, "#version 330 core\n#define POINTS %d\n", points);
    glShaderSource(shader, 2, (const char *[]){head, text}, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        char log[1000];
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        die(log);
    }
    return shader;
}

/* Gives the place of the uniform that turns the mesh. */
static GLint shader_scene(float aspect, int lights)
{
    GLuint program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, VERTEX, lights - 1));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, FRAGMENT, lights - 1));
    glLinkProgram(program);
    glUseProgram(program);
    glUniform1f(glGetUniformLocation(program, "aspect"), aspect);
    return glGetUniformLocation(program, "turn");
}

/* The light of FRAGMENT at vertices, from lights that stay with the eye. */
static void fixed_scene(float aspect, int lights, int both_sides)
{
    const float none[] = {0, 0, 0, 1}, ambient[] = {0.1f, 0.1f, 0.1f, 1}, base[] = {0.8f, 0.7f, 0.6f, 1};
    const float highlight[] = {0.4f, 0.4f, 0.4f, 1}, strong[] = {0.6f, 0.6f, 0.6f, 1}, weak[] = {0.3f, 0.3f, 0.3f, 1};
    float high = 0.1f / 2.414213562f;
    glMatrixMode(GL_PROJECTION);
    glFrustum(-high * aspect, high * aspect, -high, high, 0.1, 10);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_LIGHTING);
    glShadeModel(GL_SMOOTH);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
    glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, both_sides);
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, base);
    glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, highlight);
    glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 32);
    for (int i = 0; i < lights; i++) {
        int point = i - 1;
        float from[] = {point & 1 ? 1.5f : -1.5f, point & 2 ? 1.2f : -1.2f, -1.5f, 1};
        GLenum light = GL_LIGHT0 + (GLenum)i;
        glLightfv(light, GL_POSITION, i ? from : (const float[]){0.4f, 0.6f, 1, 0});
        glLightfv(light, GL_AMBIENT, none);
        glLightfv(light, GL_DIFFUSE, i ? weak : strong);
        glLightfv(light, GL_SPECULAR, i ? weak : strong);
        if (i) glLightf(light, GL_LINEAR_ATTENUATION, 0.1f);
        if (i) glLightf(light, GL_QUADRATIC_ATTENUATION, 0.05f);
        glEnable(light);
    }
}

/* Writes what is drawn as a PPM. */
static void keep(const char *path, int width, int height)
{
    size_t row = (size_t)width * 3;
    unsigned char *pixels = malloc(row * height);
    FILE *file = fopen(path, "wb");
    if (!pixels || !file) die("no picture");
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels);
    fprintf(file, "P6\n%d %d\n255\n", width, height);
    for (int y = height - 1; y >= 0; y--) fwrite(pixels + y * row, 1, row, file);
    if (fclose(file)) die("no picture");
    free(pixels);
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
    if (argc < 7 || sscanf(argv[2], "%dx%d", &width, &height) != 2)
        die("frames MESH.bin WxH none|back FRAMES LIGHTS phong|gouraud [PICTURE.ppm]");
    int cull = !strcmp(argv[3], "back"), fixed = !strcmp(argv[6], "gouraud");
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
    EGLint profile = fixed ? EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT : EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT;
    EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                       EGL_CONTEXT_OPENGL_PROFILE_MASK, profile, EGL_NONE};
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
    GLint turn = 0;
    if (fixed) {
        glVertexPointer(3, GL_FLOAT, 0, NULL);
        glNormalPointer(GL_FLOAT, 0, (void *)(vertices * 12));
        glEnableClientState(GL_VERTEX_ARRAY);
        glEnableClientState(GL_NORMAL_ARRAY);
        fixed_scene((float)width / height, lights, !cull);
    } else {
        for (GLuint i = 0; i < 2; i++) {
            glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, (void *)(i * vertices * 12));
            glEnableVertexAttribArray(i);
        }
        turn = shader_scene((float)width / height, lights);
    }
    glEnable(GL_DEPTH_TEST);
    if (cull) glEnable(GL_CULL_FACE);
    glClearColor(0, 0, 0, 0);

    double *times = malloc(sizeof(double) * frames);
    for (int frame = -1 - frames / 10; frame <= frames; frame++) {
        double angle = 6.283185307 * frame / frames, start = now();
        if (fixed) {
            glLoadIdentity();
            glTranslatef(0, 0, -3);
            glRotated(angle * 57.29577951, 0, 1, 0);
        } else {
            glUniform2f(turn, (float)cos(angle), (float)sin(angle));
        }
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glDrawElements(GL_TRIANGLES, (GLsizei)(triangles * 3), GL_UNSIGNED_INT, NULL);
        glFinish();
        if (frame >= 0 && frame < frames) times[frame] = now() - start;
    }
    if (argc > 7) keep(argv[7], width, height);
    if (glGetError() != GL_NO_ERROR) die("OpenGL failed");
    qsort(times, frames, sizeof(double), by_size);
    printf("%.3f ms, least %.3f, %s\n", times[frames / 2], times[0], (const char *)glGetString(GL_RENDERER));
    return 0;
}
