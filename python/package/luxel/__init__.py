"""3D pictures, masks, picks and explained pixels on the CPU, the same bytes on every machine."""

from ._gl import osmesa_path
from ._luxel import (
    Camera,
    Error,
    Frame,
    Hit,
    Ledger,
    LoadError,
    Scene,
    View,
    __version__,
    demos,
    load,
)
from ._rasterize import rasterize

__all__ = [
    "Camera",
    "Error",
    "Frame",
    "Hit",
    "Ledger",
    "LoadError",
    "Scene",
    "View",
    "__version__",
    "demos",
    "load",
    "osmesa_path",
    "rasterize",
]
