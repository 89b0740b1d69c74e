"""OpenGL by the package luxel-gl, through PyOpenGL, as its users run it."""

import ctypes.util
import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import luxel
import pytest

needs_gl = pytest.mark.skipif(
    any(importlib.util.find_spec(name) is None for name in ("luxel_gl", "OpenGL")),
    reason="luxel-gl and PyOpenGL are needed",
)

DRAW = """
import ctypes, sys
from OpenGL import GL, GLU, osmesa

context = osmesa.OSMesaCreateContextExt(osmesa.OSMESA_RGBA, 24, 8, 0, None)
pixels = (ctypes.c_ubyte * (64 * 48 * 4))()
assert osmesa.OSMesaMakeCurrent(context, pixels, GL.GL_UNSIGNED_BYTE, 64, 48)
GL.glMatrixMode(GL.GL_PROJECTION)
GLU.gluPerspective(40, 64 / 48, 1, 10)
GL.glTranslatef(0, 0, -3)
GL.glColor3ub(200, 100, 50)
GLU.gluSphere(GLU.gluNewQuadric(), 0.5, 32, 24)
GL.glFinish()
middle = 4 * (24 * 64 + 32)
print(GL.glGetString(GL.GL_VENDOR).decode(), *pixels[middle:middle + 4], *pixels[:4], *sys.argv[1:])
"""
SEEN = "luxel 200 100 50 255 0 0 0 0"


def run(*arguments: str, folder: Path, **variables: str) -> str:
    environment = {name: value for name, value in os.environ.items() if name not in ("PYOPENGL_PLATFORM", "MUJOCO_GL")}
    done = subprocess.run(
        [sys.executable, *arguments],
        cwd=folder,
        env={**environment, **variables},
        check=False,
        capture_output=True,
        text=True,
    )
    return (done.stdout + done.stderr.strip().rsplit("\n", 1)[-1]).strip()


@needs_gl
def test_a_script_draws_on_luxels_library(tmp_path: Path) -> None:
    (tmp_path / "draw.py").write_text(DRAW)
    assert run("-m", "luxel.osmesa", "draw.py", "a", "-b", folder=tmp_path) == f"{SEEN} a -b"
    assert run("-m", "luxel.osmesa", "-m", "draw", "c", folder=tmp_path) == f"{SEEN} c"


@needs_gl
def test_an_import_before_pyopengl_is_enough(tmp_path: Path) -> None:
    assert run("-c", "import luxel.osmesa" + DRAW, folder=tmp_path) == SEEN


@needs_gl
def test_an_import_after_another_platform_says_so(tmp_path: Path) -> None:
    other = "import OpenGL.platform, os; os.environ['PYOPENGL_PLATFORM'] = 'osmesa'; import luxel.osmesa"
    said = run("-c", other, folder=tmp_path, PYOPENGL_PLATFORM="linux")
    assert said.endswith("import luxel.osmesa before it")


EGL = """
import ctypes
from OpenGL import EGL, GL

display = EGL.eglGetDisplay(EGL.EGL_DEFAULT_DISPLAY)
assert EGL.eglInitialize(display, None, None)
EGL.eglBindAPI(EGL.EGL_OPENGL_API)
wanted = [EGL.EGL_RENDERABLE_TYPE, EGL.EGL_OPENGL_BIT, EGL.EGL_SURFACE_TYPE, EGL.EGL_PBUFFER_BIT, EGL.EGL_NONE]
wanted = (ctypes.c_int * len(wanted))(*wanted)
found, count = (EGL.EGLConfig * 1)(), ctypes.c_int()
assert EGL.eglChooseConfig(display, wanted, found, 1, count) and count.value == 1
size = (ctypes.c_int * 5)(EGL.EGL_WIDTH, 8, EGL.EGL_HEIGHT, 8, EGL.EGL_NONE)
pbuffer = EGL.eglCreatePbufferSurface(display, found[0], size)
context = EGL.eglCreateContext(display, found[0], EGL.EGL_NO_CONTEXT, None)
assert EGL.eglMakeCurrent(display, pbuffer, pbuffer, context)
GL.glClearColor(0.2, 0.4, 0.6, 1)
GL.glClear(GL.GL_COLOR_BUFFER_BIT)
print(GL.glGetString(GL.GL_VENDOR).decode(), *bytes(GL.glReadPixels(7, 7, 1, 1, GL.GL_RGBA, GL.GL_UNSIGNED_BYTE)))
"""


@needs_gl
@pytest.mark.skipif(ctypes.util.find_library("EGL") is None, reason="libglvnd's libEGL is needed")
def test_egl_draws_on_luxels_library(tmp_path: Path) -> None:
    assert run("-c", "import luxel.osmesa" + EGL, folder=tmp_path, PYOPENGL_PLATFORM="egl") == "luxel 51 102 153 255"


@needs_gl
def test_the_path_is_of_a_library() -> None:
    path = Path(luxel.osmesa_path())
    assert path.name == "libOSMesa.so.8"
    assert path.read_bytes()[:4] == b"\x7fELF"


def test_without_the_package_the_error_names_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "luxel_gl", None)
    with pytest.raises(ImportError, match=r"luxel\[gl\]"):
        luxel.osmesa_path()
