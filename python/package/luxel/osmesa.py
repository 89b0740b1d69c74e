"""OpenGL without a driver, for PyOpenGL, MuJoCo and other users of OSMesa.

    import luxel.osmesa      # before PyOpenGL or MuJoCo

loads `libOSMesa.so.8` and `libGLU.so.1` of the package luxel-gl, with their names for the whole process: who asks the system for
these libraries afterwards gets them. Unless they are set, PYOPENGL_PLATFORM and MUJOCO_GL become `osmesa`. Where one of
them is `egl`, libglvnd's libEGL finds luxel, too, as the one vendor and for the default display.

    python -m luxel.osmesa SCRIPT [ARGUMENT ...]
    python -m luxel.osmesa -m MODULE [ARGUMENT ...]

does so before it runs a script or a module.
"""

from __future__ import annotations

import ctypes
import importlib
import importlib.util
import os
import runpy
import sys
from typing import Any

from . import _gl

__all__ = ["library"]


def _load(name: str) -> ctypes.CDLL:
    path = _gl.folder() / name
    if not path.exists():
        raise ImportError(f"{path} is missing: luxel-gl is for Linux, as a wheel")
    return ctypes.CDLL(str(path), mode=ctypes.RTLD_GLOBAL)


library = _load("libOSMesa.so.8")
"""The loaded library."""

# It asks the process for OpenGL's functions, and finds those of the library above.
_glu = _load("libGLU.so.1")

for _variable in ("PYOPENGL_PLATFORM", "MUJOCO_GL"):
    os.environ.setdefault(_variable, "osmesa")
if "egl" in (os.environ["PYOPENGL_PLATFORM"], os.environ["MUJOCO_GL"]):
    # The file names the library as it is known in this process.
    os.environ.setdefault("__EGL_VENDOR_LIBRARY_FILENAMES", str(_gl.folder() / "50_luxel.json"))
    os.environ.setdefault("LUXEL_EGL_DEFAULT", "1")


def _lend_to_pyopengl() -> None:
    """PyOpenGL asks for `libOSMesa.so` first, which is Mesa's where its development package is installed."""
    if os.environ["PYOPENGL_PLATFORM"] != "osmesa" or importlib.util.find_spec("OpenGL") is None:
        return
    module: Any = importlib.import_module("OpenGL.platform")
    if "OSMesa" not in vars(type(module.PLATFORM)):
        raise ImportError("PyOpenGL has chosen another platform already: import luxel.osmesa before it")
    for of in (module, module.PLATFORM):
        of.GL = of.OSMesa = library
        of.GLU = _glu


_lend_to_pyopengl()


def _main() -> None:
    arguments = sys.argv[1:]
    if arguments[:1] == ["-m"] and len(arguments) > 1:
        sys.argv = arguments[1:]
        runpy.run_module(arguments[1], run_name="__main__", alter_sys=True)
    elif arguments and not arguments[0].startswith("-"):
        sys.argv = arguments
        sys.path[0] = os.path.dirname(os.path.abspath(arguments[0]))
        runpy.run_path(arguments[0], run_name="__main__")
    else:
        sys.exit("usage: python -m luxel.osmesa SCRIPT [ARGUMENT ...], or -m MODULE [ARGUMENT ...]")


if __name__ == "__main__":
    _main()
