/* What is read back, in every format and type, with the ways to store it (4.3.2). */
#include "program.h"

static void draw(void)
{
    static const GLenum formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_RGBA, GL_BGR, GL_BGRA, GL_LUMINANCE,
        GL_LUMINANCE_ALPHA};
    static const struct {
        GLenum type;
        int bytes;
    } types[] = {{GL_UNSIGNED_BYTE, 1}, {GL_BYTE, 1}, {GL_UNSIGNED_SHORT, 2}, {GL_SHORT, 2}, {GL_UNSIGNED_INT, 4}, {GL_INT, 4},
        {GL_FLOAT, 4}, {GL_UNSIGNED_BYTE_3_3_2, 0}, {GL_UNSIGNED_BYTE_2_3_3_REV, 0}, {GL_UNSIGNED_SHORT_5_6_5, 0},
        {GL_UNSIGNED_SHORT_5_6_5_REV, 0}, {GL_UNSIGNED_SHORT_4_4_4_4, 0}, {GL_UNSIGNED_SHORT_4_4_4_4_REV, 0},
        {GL_UNSIGNED_SHORT_5_5_5_1, 0}, {GL_UNSIGNED_SHORT_1_5_5_5_REV, 0}, {GL_UNSIGNED_INT_8_8_8_8, 0},
        {GL_UNSIGNED_INT_8_8_8_8_REV, 0}, {GL_UNSIGNED_INT_10_10_10_2, 0}, {GL_UNSIGNED_INT_2_10_10_10_REV, 0}};
    glEnable(GL_SCISSOR_TEST);
    for (int i = 0; i < 16; i++) {
        glScissor(i % 4, i / 4, 1, 1);
        glClearColor(i / 15.0f, (i * 7 % 16) / 15.0f, (i * 3 % 16) / 15.0f, (15 - i) / 15.0f);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    glDisable(GL_SCISSOR_TEST);
    for (unsigned f = 0; f < sizeof formats / sizeof *formats; f++)
        for (unsigned t = 0; t < sizeof types / sizeof *types; t++) {
            unsigned char bytes[512];
            char line[2048] = "";
            memset(bytes, 0x77, sizeof bytes);
            glReadPixels(0, 0, 3, 2, formats[f], types[t].type, bytes);
            GLenum error = glGetError();
            /* Sums and floats may differ in the last bit. */
            if (types[t].type == GL_FLOAT)
                for (int i = 0; i < 24; i++)
                    sprintf(line + strlen(line), " %.3f", ((float *)bytes)[i] > 1e9 ? -1 : ((float *)bytes)[i]);
            else if (types[t].type == GL_UNSIGNED_INT || types[t].type == GL_INT)
                for (int i = 0; i < 24; i++)
                    sprintf(line + strlen(line), " %x", (((unsigned *)bytes)[i] + 0x8000) >> 16);
            else if (types[t].type == GL_UNSIGNED_INT_10_10_10_2 || types[t].type == GL_UNSIGNED_INT_2_10_10_10_REV)
                for (int i = 0; i < 6; i++)
                    /* Eight bits become ten in more ways than one. */
                    sprintf(line + strlen(line), " %x",
                        ((unsigned *)bytes)[i] & (types[t].type == GL_UNSIGNED_INT_10_10_10_2 ? 0xff3fcff3 : 0xffcff3fc));
            else
                for (int i = 0; i < 52; i++)
                    sprintf(line + strlen(line), " %02x", bytes[i]);
            say("%#x %#x: error %#x%s", formats[f], types[t].type, error, line);
        }
    static const struct {
        int alignment, row_length, skip_rows, skip_pixels, swap;
    } stores[] = {{1, 0, 0, 0, 0}, {2, 0, 0, 0, 0}, {4, 0, 0, 0, 0}, {8, 0, 0, 0, 0}, {1, 5, 0, 0, 0}, {4, 6, 1, 2, 0}, {8, 7, 2, 1, 1},
        {2, 3, 0, 3, 1}};
    for (unsigned s = 0; s < sizeof stores / sizeof *stores; s++)
        for (int type = 0; type < 2; type++) {
            unsigned char bytes[256];
            char line[1024] = "";
            memset(bytes, 0x77, sizeof bytes);
            glPixelStorei(GL_PACK_ALIGNMENT, stores[s].alignment);
            glPixelStorei(GL_PACK_ROW_LENGTH, stores[s].row_length);
            glPixelStorei(GL_PACK_SKIP_ROWS, stores[s].skip_rows);
            glPixelStorei(GL_PACK_SKIP_PIXELS, stores[s].skip_pixels);
            glPixelStorei(GL_PACK_SWAP_BYTES, stores[s].swap);
            glReadPixels(1, 1, 3, 3, GL_RGB, type ? GL_UNSIGNED_SHORT : GL_UNSIGNED_BYTE, bytes);
            for (int i = 0; i < 160; i++)
                sprintf(line + strlen(line), " %02x", bytes[i]);
            say("store %u %d:%s", s, type, line);
        }
    for (int i = 0; i < 5; i++)
        glPixelStorei((const GLenum[]){GL_PACK_ALIGNMENT, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS,
                          GL_PACK_SWAP_BYTES}[i],
            i ? 0 : 4);
    /* Beyond the window nothing is written; all else is where it belongs. */
    unsigned char around[6 * 6 * 4];
    memset(around, 0x77, sizeof around);
    glReadPixels(-2, -2, 6, 6, GL_RGBA, GL_UNSIGNED_BYTE, around);
    say("below: %02x, inside: %02x %02x %02x", around[0], around[4 * (6 * 2 + 2) + 1], around[4 * (6 * 3 + 3)], around[4 * (6 * 5 + 5)]);
    glReadPixels(300, 0, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, around);
    say_error("outside");
}
