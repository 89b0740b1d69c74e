"""What draws the tasks of a list and stores their outputs, for `luxel.batch` and `luxel.ray`."""

import importlib
import json
import os
import pathlib
import shutil
import sys
import tempfile
import weakref
from collections.abc import Sequence
from typing import Any

from ._luxel import Worker

PROGRAM = [sys.executable, "-m", "luxel"]
"""What starts luxel as a process of its own."""

PARTS = ".parts"
"""The folder of unfinished files in a folder of outputs."""

_ATOMIC = ("memory", "s3", "s3a", "gs", "gcs", "az", "abfs", "abfss")
"""Stores in which an object appears whole or not at all."""


def is_url(place: str) -> bool:
    """Whether a place is fsspec's, rather than a path."""
    return "://" in place


class Outputs:
    """A folder of outputs, by its path or by an fsspec URL."""

    def __init__(self, place: str) -> None:
        self.files: Any = None
        self.root: str = os.path.abspath(place)
        if is_url(place):
            core: Any = importlib.import_module("fsspec.core")
            self.files, self.root = core.url_to_fs(place)

    @property
    def is_local(self) -> bool:
        """Whether workers write there themselves."""
        return self.files is None or "file" in _protocols(self.files)

    def path(self, name: str) -> str:
        return f"{self.root.rstrip('/')}/{name}"

    def remove_parts(self) -> None:
        """Removes what workers that were killed have left unfinished."""
        if self.is_local:
            shutil.rmtree(self.path(PARTS), ignore_errors=True)

    def put(self, name: str, data: bytes) -> None:
        """Stores an object whole."""
        target = self.path(name)
        if self.is_local:
            parts = self.path(PARTS)
            for folder in (os.path.dirname(target), parts):
                os.makedirs(folder, exist_ok=True)
            descriptor, part = tempfile.mkstemp(dir=parts)
            with os.fdopen(descriptor, "wb") as file:
                file.write(data)
            os.chmod(part, 0o644)
            os.replace(part, target)
            return
        self.files.makedirs(target.rsplit("/", 1)[0], exist_ok=True)
        if set(_protocols(self.files)) & set(_ATOMIC):
            self.files.pipe_file(target, data)
        else:
            self.files.pipe_file(f"{target}.part", data)
            self.files.mv(f"{target}.part", target)

    def get(self, name: str) -> bytes:
        """An object.

        Raises `FileNotFoundError`."""
        if self.is_local:
            return pathlib.Path(self.path(name)).read_bytes()
        data: bytes = self.files.cat_file(self.path(name))
        return data

    def sizes(self) -> dict[str, int]:
        """The names of all objects, and their lengths in bytes."""
        if self.is_local:
            found: dict[str, int] = {}
            pending = [""]
            while pending:
                folder = pending.pop()
                try:
                    with os.scandir(self.path(folder)) as entries:
                        for entry in entries:
                            if entry.is_dir():
                                pending.append(f"{folder}{entry.name}/")
                            else:
                                found[folder + entry.name] = entry.stat().st_size
                except FileNotFoundError:
                    continue
            return found
        # What others have stored meanwhile counts.
        self.files.invalidate_cache()
        if not self.files.exists(self.root):
            return {}
        start = len(self.root.rstrip("/")) + 1
        return {name[start:]: entry["size"] for name, entry in self.files.find(self.root, detail=True).items()}


def _protocols(files: Any) -> Sequence[str]:
    return (files.protocol,) if isinstance(files.protocol, str) else files.protocol


def _remove(folder: str | None) -> None:
    if folder is not None:
        shutil.rmtree(folder, ignore_errors=True)


class Drawer:
    """Draws tasks in a worker process and stores what it gives."""

    def __init__(self, folder: str, out: str, flags: Sequence[str] = ()) -> None:
        self.outputs = Outputs(out)
        # Renaming doesn't cross file systems, so unfinished files lie beside the outputs.
        self.root: str = self.outputs.root if self.outputs.is_local else tempfile.mkdtemp(prefix="luxel-")
        parts = f"{self.root}/{PARTS}"
        os.makedirs(parts, exist_ok=True)
        # Actors end without a call.
        self.close = weakref.finalize(self, _remove, None if self.outputs.is_local else self.root)
        self.worker = Worker(PROGRAM, folder, self.root, parts, list(flags))

    def draw(self, line: str) -> dict[str, Any]:
        """The answer to a task, with all its outputs stored."""
        answer: dict[str, Any] = json.loads(self.worker.draw(line))
        if not self.outputs.is_local:
            for output in answer.get("outputs", []):
                path = pathlib.Path(self.root, output["path"])
                self.outputs.put(output["path"], path.read_bytes())
                path.unlink()
        return answer
