"""The door to the C libraries of OpenGL, which are a package of their own."""

import importlib
from pathlib import Path
from typing import Any


def folder() -> Path:
    """Where the libraries are.

    Raises `ImportError` without luxel-gl.
    """
    try:
        libraries: Any = importlib.import_module("luxel_gl")
    except ImportError as error:
        raise ImportError(f'OpenGL needs luxel-gl: pip install "luxel[gl]" ({error})') from error
    return Path(libraries.FOLDER)


def osmesa_path() -> str:
    """The path of `libOSMesa.so.8`, for `LD_PRELOAD` or a loader of one's own.

    Raises `ImportError` without luxel-gl.
    """
    return str(folder() / "libOSMesa.so.8")
