/* Occlusion queries (4.1.7): what passes the depth test, by primitives, tests and lists; names and errors. */
#include "program.h"

static GLuint result(GLuint name)
{
    GLuint passed = 12345;
    glGetQueryObjectuiv(name, GL_QUERY_RESULT, &passed);
    return passed;
}

static void square(float left, float bottom, float side, float z)
{
    glBegin(GL_QUADS);
    glVertex3f(left, bottom, z);
    glVertex3f(left + side, bottom, z);
    glVertex3f(left + side, bottom + side, z);
    glVertex3f(left, bottom + side, z);
    glEnd();
}

static GLuint query;

#define COUNT(what, draws)                      \
    do {                                        \
        glBeginQuery(GL_SAMPLES_PASSED, query); \
        draws;                                  \
        glEndQuery(GL_SAMPLES_PASSED);          \
        say("%s: %u", what, result(query));     \
    } while (0)

static void draw(void)
{
    GLint value = -1;
    GLuint names[3];
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glOrtho(0, WIDTH, 0, HEIGHT, -1, 1);
    glGenQueries(3, names);
    query = names[0];
    say("is a query before it is begun: %d", glIsQuery(query));
    glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &value);
    say("current: %d", value);
    glEnable(GL_DEPTH_TEST);
    glColor3f(1, 0.5f, 0);
    COUNT("a square", square(10, 10, 100, 0));
    say("is a query: %d", glIsQuery(query));
    glColor3f(0, 0.5f, 1);
    COUNT("behind it", square(50, 50, 100, -0.5f));
    COUNT("hidden", square(20, 20, 50, -0.5f));
    COUNT("beyond the window", square(200, 200, 100, 0));
    glDepthFunc(GL_NEVER);
    COUNT("never", square(10, 10, 100, 0.5f));
    glDepthFunc(GL_LESS);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 20, 30);
    COUNT("scissored", square(10, 10, 100, 0.5f));
    glDisable(GL_SCISSOR_TEST);
    glEnable(GL_ALPHA_TEST);
    glAlphaFunc(GL_GREATER, 0.5f);
    glColor4f(1, 1, 1, 0.25f);
    COUNT("by alpha", square(10, 10, 100, 0.9f));
    glDisable(GL_ALPHA_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    COUNT("blended", square(10, 150, 30, 0.9f));
    glDisable(GL_BLEND);
    glEnable(GL_STENCIL_TEST);
    glStencilFunc(GL_NEVER, 0, 1);
    COUNT("by stencil", square(10, 10, 100, 0.9f));
    glDisable(GL_STENCIL_TEST);
    glPointSize(4);
    COUNT("points", glBegin(GL_POINTS); glVertex2i(200, 20); glVertex2i(220, 20); glEnd());
    COUNT("a line", glBegin(GL_LINES); glVertex2f(150.5f, 20.5f); glVertex2f(180.5f, 20.5f); glEnd());
    COUNT("two squares", square(200, 100, 10, 0.5f); glClear(GL_COLOR_BUFFER_BIT); square(220, 100, 10, 0.5f));
    glNewList(1, GL_COMPILE);
    glBeginQuery(GL_SAMPLES_PASSED, names[1]);
    square(120, 200, 16, 0.5f);
    glEndQuery(GL_SAMPLES_PASSED);
    glEndList();
    glCallList(1);
    say("in a list: %u", result(names[1]));
    glGetQueryObjectiv(names[1], GL_QUERY_RESULT_AVAILABLE, &value);
    say("available: %d", value);
    say_error("queries");

    glBeginQuery(GL_SAMPLES_PASSED, 0);
    say_error("name 0");
    glBeginQuery(GL_TEXTURE_2D, names[0]);
    say_error("no target");
    glEndQuery(GL_SAMPLES_PASSED);
    say_error("none counts");
    result(names[2]);
    say_error("never begun");
    glBeginQuery(GL_SAMPLES_PASSED, names[0]);
    glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &value);
    say("the current one: %d", value == (GLint)names[0]);
    glBeginQuery(GL_SAMPLES_PASSED, names[1]);
    say_error("another one counts");
    result(names[0]);
    say_error("it counts");
    glBegin(GL_POINTS);
    glEndQuery(GL_SAMPLES_PASSED);
    glEnd();
    say_error("within glBegin");
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectiv(names[0], GL_TEXTURE_2D, &value);
    say_error("no such value");
    glGetQueryiv(GL_SAMPLES_PASSED, GL_TEXTURE_2D, &value);
    say_error("no such value of a target");
    glDeleteQueries(3, names);
    say("is a query after all: %d", glIsQuery(names[0]));
    glGenQueries(-1, names);
    say_error("less than none");
}
