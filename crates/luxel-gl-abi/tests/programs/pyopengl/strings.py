"""The library loads, and its strings can be read: the version is 1.5 at least, extensions are words."""

from OpenGL.GL import GL_COLOR_BUFFER_BIT, GL_EXTENSIONS, GL_RENDERER, GL_VENDOR, GL_VERSION, glClear, glGetString

import _program


def draw():
    glClear(GL_COLOR_BUFFER_BIT)
    version = tuple(int(part) for part in glGetString(GL_VERSION).split()[0].split(b".")[:2])
    print("version", version >= (1, 5))
    print("words", all(glGetString(name) for name in (GL_VENDOR, GL_RENDERER)))
    names = glGetString(GL_EXTENSIONS).split()
    print("extensions", all(name.startswith(b"GL_") for name in names), b"GL_ARB_window_pos" in names)


_program.run(draw)
