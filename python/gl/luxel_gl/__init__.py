"""OpenGL 1.5 and GLU as C libraries; `luxel.osmesa` loads them."""

from pathlib import Path

FOLDER = Path(__file__).parent
"""Where `libOSMesa.so.8` and `libGLU.so.1` are."""
