"""Lists of tasks, what is known of each, and the manifest of all."""

import hashlib
import importlib
import io
import json
import os
from collections.abc import Iterator
from typing import Any, NamedTuple, cast

from ._drawer import Outputs, is_url
from ._luxel import __version__, merkle_root

LOG = "log"
"""The folder of what is known of tasks: an object each."""


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
        if not data.strip():
            continue
        line = ""
        identity: str | None = None
        error: str | None = None
        try:
            line = data.decode("utf-8").strip()
            task: Any = json.loads(line)
            given = cast("dict[str, Any]", task)["id"] if isinstance(task, dict) else None
            identity = given if isinstance(given, str) else None
            if identity is None:
                error = "a task is a JSON object with a string `id`"
            elif identity in ids:
                error = f"the id `{identity}` is there twice: give each task its own"
        except ValueError as failure:
            error = f"not JSON: {failure}"
        except KeyError:
            error = "`id` is missing: give each task its own"
        if identity is not None:
            ids.add(identity)
        digest = hashlib.sha256(f"{__version__}\n{line}".encode()).hexdigest()
        place = error and f"{name}:{number}: {error}"
        yield Task(number, identity, line, place, f"{LOG}/{digest[:2]}/{digest}.json")


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


def manifest_of(tasks: list[Task], answers: dict[str, dict[str, Any]], out: Outputs) -> dict[str, Any]:
    """The manifest of a list: `answers` by the places of entries; the others are read from the log."""
    outputs: list[dict[str, Any]] = []
    failed: list[dict[str, Any]] = []
    for task in tasks:
        if task.error is not None:
            failed.append({"id": task.id, "error": task.error})
            continue
        answer = answers.get(task.entry)
        if answer is None:
            answer = json.loads(out.get(task.entry))
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
