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
    "Stage",
    "build_scene",
    "unpack",
    "rasterize_clip",
    "run_program",
    "draw_task",
    "task_id",
    "merkle_root",
    "Worker",
]

def build_scene(
    meshes: Sequence[dict[str, Any]],
    materials: Sequence[dict[str, Any]],
    textures: Sequence[tuple[NDArray[np.uint8], bool, tuple[int, int, int, int]]],
    nodes: Sequence[tuple[str, int | None, Any, int | None]],
    up: Any = None,
    warnings: Sequence[str] = (),
) -> Scene:
    """A scene of meshes, materials, textures and nodes, which name one another by their places."""

@final
class Stage:
    """Meshes whose places change from picture to picture."""

    def __new__(cls, scene: Scene, threads: int) -> Stage: ...
    def place(self, meshes: Sequence[int], poses: NDArray[np.float64]) -> None:
        """Shows meshes, by their places in the scene, at poses (n, 4, 4), and nothing else."""

    def draw(
        self,
        size: tuple[int, int],
        camera: Camera,
        channels: int,
        palette: Sequence[tuple[int, int, int]] | None = None,
        point_size: float = 1.0,
        **settings: Any,
    ) -> tuple[NDArray[np.uint8] | None, NDArray[np.float32]]:
        """A picture of so many channels and depths, 0 where nothing is; of a palette, objects in their colours."""

def unpack(bytes: bytes, warnings: list[str]) -> Scene: ...
def rasterize_clip(vertices: ArrayLike, faces: ArrayLike, size: tuple[int, int], threads: int) -> NDArray[np.float32]: ...
def run_program(program: Sequence[str], words: Sequence[str]) -> int: ...
def draw_task(line: str, folder: str | PathLike[str]) -> Any: ...
def task_id(line: str) -> str: ...
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
