"""The native module: what `luxel` shows of it, and what its own modules use."""

from collections.abc import Sequence
from os import PathLike
from typing import Any, final

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
    "run_program",
    "draw_task",
    "task_id",
    "merkle_root",
    "Worker",
]

def unpack(bytes: bytes, warnings: list[str]) -> Scene: ...
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
