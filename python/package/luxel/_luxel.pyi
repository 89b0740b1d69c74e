"""The native module: what `luxel` shows of it, and what its own modules use."""

from collections.abc import Sequence
from os import PathLike
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import Camera as Camera
from . import Error as Error
from . import Frame as Frame
from . import Hit as Hit
from . import Ledger as Ledger
from . import LoadError as LoadError
from . import Scene as Scene
from . import View as View
from . import __version__ as __version__
from . import demos as demos
from . import load as load

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
    "unpack",
    "rasterize_clip",
    "run_program",
    "draw_task",
    "merkle_root",
    "Worker",
]

def unpack(bytes: bytes, warnings: list[str]) -> Scene: ...
def rasterize_clip(vertices: ArrayLike, faces: ArrayLike, size: tuple[int, int], threads: int) -> NDArray[np.float32]: ...
def run_program(program: Sequence[str], words: Sequence[str]) -> int: ...
def draw_task(line: str, folder: str | PathLike[str]) -> Any: ...
def merkle_root(digests: Sequence[str]) -> str: ...
@final
class Worker:
    def __new__(
        cls,
        program: Sequence[str],
        folder: str | PathLike[str],
        root: str | PathLike[str],
        parts: str | PathLike[str],
        flags: Sequence[str],
    ) -> Worker: ...
    def draw(self, line: str) -> str: ...
