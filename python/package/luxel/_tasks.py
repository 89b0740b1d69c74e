"""Lists of tasks, what is known of each, and the manifest of all."""

import functools
import hashlib
import importlib
import io
import json
import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

from ._drawer import Outputs, is_url
from ._luxel import Error, __version__, merkle_root, task_id

LOG = "log"
"""The folder of what is known of tasks: an object each."""


_LONGEST = 64 << 20
"""The longest line in bytes."""


class Task(NamedTuple):
    """A line of a list."""

    number: int
    """The line's number, from 1."""
    id: str | None
    line: str
    error: str | None
    """What is wrong with the line."""
    entry: str
    """Where what is known of it is stored."""


def folder_of(tasks: str) -> str:
    """The folder that models are relative to."""
    return "." if is_url(tasks) else os.path.dirname(tasks) or "."


def read(tasks: str) -> Iterator[Task]:
    """The tasks of a list, a path or an fsspec URL."""
    name = os.path.basename(tasks)
    ids: set[str] = set()
    for number, data in enumerate(_lines(tasks), 1):
        data = data.removeprefix(b"\xef\xbb\xbf") if number == 1 else data
        data = data if len(data) > _LONGEST else data.strip(b" \t\n\f\r")
        if not data:
            continue
        line, identity, error = "", None, None
        try:
            line = _text(data)
            identity = task_id(line)
            if identity in ids:
                error = f"the id `{identity}` is there twice: give each task its own"
        except (Error, ValueError) as failure:
            error = str(failure)
        if identity is not None:
            ids.add(identity)
        digest = hashlib.sha256(f"{__version__}\n{line}".encode()).hexdigest()
        place = error and f"{name}:{number}: {error}"
        yield Task(number, identity, line, place, f"{LOG}/{digest[:2]}/{digest}.json")


def _text(data: bytes) -> str:
    if len(data) > _LONGEST:
        raise ValueError(f"longer than {_LONGEST} bytes")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise ValueError(f"not UTF-8 from byte {error.start}") from error


def _lines(tasks: str) -> Iterator[bytes]:
    if is_url(tasks):
        fsspec: Any = importlib.import_module("fsspec")
        with fsspec.open(tasks, "rb") as file:
            yield from io.BufferedReader(file)
    else:
        with open(tasks, "rb") as file:
            yield from file


def with_place(answer: dict[str, Any], tasks: str, number: int) -> dict[str, Any]:
    """The answer of a worker, whose error in the list has its place."""
    if answer.pop("is_in_list", False):
        answer["error"] = f"{os.path.basename(tasks)}:{number}: {answer['error']}"
    return answer


def whole(tasks: list[Task], folder: str, out: Outputs) -> dict[str, dict[str, Any]]:
    """The answers of the tasks that earlier runs have drawn, by the places of entries: without those whose outputs are
    missing or of another length, and those that were made of files that have changed since. Files that
    only other machines have are trusted."""
    sizes = out.sizes()
    known = [task.entry for task in tasks if task.error is None and task.entry in sizes]

    @functools.cache
    def now(path: str) -> tuple[int, int] | None:
        try:
            status = os.stat(os.path.join(folder, path))
        except OSError:
            return None
        return status.st_size, status.st_mtime_ns

    def is_whole(answer: dict[str, Any]) -> bool:
        are_there = all(sizes.get(output["path"]) == output["bytes"] for output in answer["outputs"])
        return are_there and all(
            now(given["path"]) in (None, (given["bytes"], given["mtime"])) for given in answer["inputs"]
        )

    def answer(entry: str) -> tuple[str, dict[str, Any] | None]:
        try:
            found: dict[str, Any] = json.loads(out.get(entry))
            return entry, {"outputs": found["outputs"]} if is_whole(found) else None
        except (OSError, ValueError, KeyError, TypeError):
            return entry, None

    with ThreadPoolExecutor(1 if out.is_local else 32) as threads:
        return {entry: found for entry, found in threads.map(answer, known) if found is not None}


def manifest_of(tasks: list[Task], answers: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """The manifest of a list: `answers` by the places of entries."""
    outputs: list[dict[str, Any]] = []
    failed: list[dict[str, Any]] = []
    for task in tasks:
        if task.error is not None:
            failed.append({"id": task.id, "error": task.error})
            continue
        answer = answers[task.entry]
        if "error" in answer:
            failed.append({"id": task.id, "error": answer["error"]})
            continue
        for output in answer["outputs"]:
            listed = {"task": task.id, **{key: output[key] for key in ("view", "name", "layer") if key in output}}
            outputs.append({**listed, "path": output["path"], "sha256": output["sha256"]})
    root = merkle_root([output["sha256"] for output in outputs])
    return {"version": 1, "root": root, "outputs": outputs, "failed": failed}


def manifest_text(manifest: dict[str, Any]) -> bytes:
    """A manifest, an entry a line."""
    parts = [f'{{"version":{manifest["version"]},"root":"{manifest["root"]}"']
    for key in ("outputs", "failed"):
        entries = (json.dumps(entry, ensure_ascii=False, separators=(",", ":")) for entry in manifest[key])
        parts.append(f'"{key}":[{"".join(f"{chr(10)}{entry}," for entry in entries).rstrip(",")}]')
    return (",".join(parts) + "}\n").encode("utf-8")
