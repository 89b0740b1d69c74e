/* Lines, boxes and cubes of texels (3.8.1, 3.8.6); generated coordinates (2.10.4). */
#include "texture.h"

static unsigned char texels[16 * 16 * 16][4];

/* A dome whose normals and places vary. */
static void dome(void)
{
    for (int j = 0; j < 8; j++) {
        glBegin(GL_QUAD_STRIP);
        for (int i = 0; i <= 16; i++)
            for (int k = 1; k >= 0; k--) {
                double a = i * 6.283185307 / 16, b = (j + k) * 1.45 / 8;
                float x = (float)(sin(b) * cos(a)), y = (float)(sin(b) * sin(a)), z = (float)cos(b);
                glNormal3f(x, y, z);
                glTexCoord3f(x, y, z);
                glVertex3f(x * 0.9f, y * 0.9f, z * 0.9f);
            }
        glEnd();
    }
}

static void look_at_dome(int cell)
{
    glViewport(cell % 4 * 64, cell / 4 * 64, 64, 64);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 10);
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslatef(0.1f, -0.05f, -2.6f);
    glRotatef(20, 1, 0.3f, 0);
}

static void generate(GLint mode, int count)
{
    static const GLfloat planes[4][4] = {{0.8f, 0.1f, 0, 0.2f}, {0, 0.9f, 0.2f, 0.1f}, {0.1f, 0, 0.7f, 0.3f}, {0, 0, 0, 1}};
    for (int axis = 0; axis < 4; axis++) {
        GLenum coordinate = (GLenum)(GL_S + axis), capability = (GLenum)(GL_TEXTURE_GEN_S + axis);
        if (axis < count) {
            glTexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode);
            glTexGenfv(coordinate, GL_OBJECT_PLANE, planes[axis]);
            glTexGenfv(coordinate, GL_EYE_PLANE, planes[axis]);
            glEnable(capability);
        } else
            glDisable(capability);
    }
}

static void draw(void)
{
    GLuint names[4];
    int cell = 0;
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glGenTextures(4, names);
    glBindTexture(GL_TEXTURE_1D, names[0]);
    filter(GL_TEXTURE_1D, GL_LINEAR, GL_LINEAR);
    paint(texels, 16, 1, 0);
    glTexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glBindTexture(GL_TEXTURE_2D, names[1]);
    filter(GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
    for (int y = 0; y < 16; y++)
        for (int x = 0; x < 16; x++) {
            texels[y * 16 + x][0] = (unsigned char)(16 * x);
            texels[y * 16 + x][1] = (unsigned char)(16 * y);
            texels[y * 16 + x][2] = (unsigned char)(128 + 40 * ((x / 4 + y / 4) & 1));
            texels[y * 16 + x][3] = 255;
        }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
    glBindTexture(GL_TEXTURE_CUBE_MAP, names[2]);
    filter(GL_TEXTURE_CUBE_MAP, GL_LINEAR, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    for (int face = 0; face < 6; face++) {
        for (int y = 0; y < 8; y++)
            for (int x = 0; x < 8; x++) {
                unsigned char *texel = texels[y * 8 + x];
                texel[0] = (unsigned char)(face & 1 ? 255 - 20 * x : 20 * x);
                texel[1] = (unsigned char)(face & 2 ? 255 - 20 * y : 20 * y);
                texel[2] = (unsigned char)(50 * face);
                texel[3] = 255;
            }
        glTexImage2D((GLenum)(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     texels);
    }
    glBindTexture(GL_TEXTURE_3D, names[3]);
    filter(GL_TEXTURE_3D, GL_LINEAR, GL_LINEAR);
    for (int z = 0; z < 4; z++)
        for (int y = 0; y < 8; y++)
            for (int x = 0; x < 16; x++) {
                unsigned char *texel = texels[(z * 8 + y) * 16 + x];
                texel[0] = (unsigned char)(16 * x);
                texel[1] = (unsigned char)(32 * y);
                texel[2] = (unsigned char)(64 * z);
                texel[3] = 255;
            }
    glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 16, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_MIRRORED_REPEAT);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_TEXTURE_1D);
    look_at_dome(cell++);
    dome();
    glEnable(GL_TEXTURE_2D);
    for (int mode = 0; mode < 3; mode++) {
        static const GLint modes[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP};
        look_at_dome(cell++);
        generate(modes[mode], 2);
        dome();
    }
    generate(GL_OBJECT_LINEAR, 0);
    glEnable(GL_TEXTURE_3D);
    look_at_dome(cell++);
    dome();
    look_at_dome(cell++);
    generate(GL_EYE_LINEAR, 3);
    dome();
    generate(GL_OBJECT_LINEAR, 0);
    glEnable(GL_TEXTURE_CUBE_MAP);
    look_at_dome(cell++);
    dome();
    for (int mode = 0; mode < 2; mode++) {
        look_at_dome(cell++);
        generate(mode ? GL_REFLECTION_MAP : GL_NORMAL_MAP, 3);
        dome();
    }
    glDisable(GL_TEXTURE_CUBE_MAP);
    glDisable(GL_TEXTURE_3D);
    /* Projected: q varies. */
    generate(GL_OBJECT_LINEAR, 0);
    glMatrixMode(GL_TEXTURE);
    glFrustum(-1, 1, -1, 1, 1, 10);
    glTranslatef(0, 0, -1.5f);
    glMatrixMode(GL_MODELVIEW);
    look_at_dome(cell++);
    dome();
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    /* A box of normals that aren't of unit length. */
    glEnable(GL_NORMALIZE);
    look_at_dome(cell++);
    glScalef(0.5f, 1.1f, 0.8f);
    generate(GL_SPHERE_MAP, 2);
    dome();
    generate(GL_OBJECT_LINEAR, 0);
    /* A part of an image replaced, from the middle of an array. */
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 16);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 2);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 5, 6, 7, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, texels);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
    look_at_dome(cell++);
    dome();
    /* What is in the framebuffer, as a texture. */
    glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 64, 64, 0);
    look_at_dome(cell++);
    dome();
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 8, 16, 70, 70, 40, 30);
    look_at_dome(cell++);
    dome();
}
