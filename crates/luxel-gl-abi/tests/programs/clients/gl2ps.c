/* A lit sphere and a cone as SVG, by gl2ps, which sorts what GL_FEEDBACK returns (5.3).
 *
 *     cc gl2ps.c -o gl2ps -lOSMesa -lGLU -lgl2ps -lm && ./gl2ps PICTURE.svg */
#include <GL/osmesa.h>
#include <GL/gl.h>
#include <GL/glu.h>
#include <gl2ps.h>
#include <stdio.h>

static void scene(void)
{
    glClearColor(1, 1, 0.9f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    gluPerspective(40, 1, 1, 20);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    gluLookAt(2, 3, 5, 0, 0, 0, 0, 1, 0);
    GLUquadric *quadric = gluNewQuadric();
    glColor3f(0.8f, 0.4f, 0.2f);
    gluSphere(quadric, 1, 12, 8);
    glTranslatef(1.2f, 0, 0);
    glColor3f(0.2f, 0.5f, 0.8f);
    gluCylinder(quadric, 0.5, 0.2, 1.5, 10, 3);
    gluDeleteQuadric(quadric);
    glDisable(GL_LIGHTING);
    glColor3f(0, 0, 0);
    gl2psLineWidth(2);
    glBegin(GL_LINE_LOOP);
    for (int i = 0; i < 6; i++)
        glVertex3f(i % 2, i % 3 - 1, 0.2f * i);
    glEnd();
}

int main(int count, char **arguments)
{
    static unsigned char pixels[256 * 256 * 4];
    GLint viewport[4] = {0, 0, 256, 256};
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 8, 0, NULL);
    FILE *file = count == 2 ? fopen(arguments[1], "wb") : NULL;
    if (!file || !OSMesaMakeCurrent(context, pixels, GL_UNSIGNED_BYTE, 256, 256))
        return 1;
    int size = 0, state = GL2PS_OVERFLOW;
    while (state == GL2PS_OVERFLOW) {
        size += 1 << 20;
        gl2psBeginPage("shapes", "luxel", viewport, GL2PS_SVG, GL2PS_BSP_SORT,
            GL2PS_DRAW_BACKGROUND | GL2PS_NO_PS3_SHADING | GL2PS_OCCLUSION_CULL, GL_RGBA, 0, NULL, 0, 0, 0, size, file, arguments[1]);
        scene();
        state = gl2psEndPage();
    }
    fclose(file);
    return state != GL2PS_SUCCESS;
}
