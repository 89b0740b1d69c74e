"""What the scripts of this folder have in common: a context of OSMesa, a picture, and lines of text.

    PYOPENGL_PLATFORM=osmesa python3 quadrics.py PICTURE.pam
"""

import ctypes
import sys

from OpenGL import GL, osmesa

SIZE = 256


def run(draw):
    """Calls `draw` in a new context, and writes the picture as PAM."""
    context = osmesa.OSMesaCreateContextExt(osmesa.OSMESA_RGBA, 24, 8, 0, None)
    pixels = (ctypes.c_ubyte * (4 * SIZE * SIZE))()
    if not context or not osmesa.OSMesaMakeCurrent(context, pixels, GL.GL_UNSIGNED_BYTE, SIZE, SIZE):
        raise SystemExit("no context can be had")
    draw()
    GL.glFinish()
    print("error", GL.glGetError())
    rows = bytes(pixels)
    with open(sys.argv[1], "wb") as file:
        file.write(b"P7\nWIDTH %d\nHEIGHT %d\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n" % (SIZE, SIZE))
        for y in reversed(range(SIZE)):
            file.write(rows[4 * SIZE * y : 4 * SIZE * (y + 1)])
    osmesa.OSMesaDestroyContext(context)
