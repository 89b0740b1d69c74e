"""Lists of tasks: `luxel batch` from Python, also into stores that fsspec knows.

    manifest = luxel.batch.run("tasks.jsonl", "out")
    manifest = luxel.batch.run("tasks.jsonl", "s3://bucket/out", workers=8)

docs/batch.md says what a task is. A folder is drawn by the program's own workers; into a store, each worker's outputs are
put as they come, whole or not at all, and what is known of each task beside them, so that a run that was ended goes on
where it was.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from queue import Empty, Queue
from typing import Any, TypedDict

from . import _tasks
from ._drawer import PROGRAM, Drawer, Outputs, is_url
from ._luxel import Error, draw_task, merkle_root
from ._progress import bar

__all__ = ["Drawn", "Output", "draw", "root", "run", "verify"]


class Output(TypedDict):
    """An output of a task."""

    view: int
    """The number of the view, from 0."""
    name: str | None
    layer: str
    path: str
    """Where a folder of outputs has it."""
    sha256: str
    data: bytes


class Drawn(TypedDict):
    """A task that has been drawn."""

    key: str
    """The name by content of its outputs."""
    outputs: list[Output]
    warnings: list[str]


def draw(task: str | dict[str, Any], folder: str | os.PathLike[str] = ".") -> Drawn:
    """Draws a task in this process: a dict, or a line of a list. Models are relative to `folder`. The model is kept for
    the next task of the same thread.

    Raises `luxel.Error` with what a manifest says of a task that failed."""
    line = task if isinstance(task, str) else json.dumps(task)
    drawn: Drawn = draw_task(line, folder)
    return drawn


def root(digests: Sequence[str]) -> str:
    """The root of the Merkle tree over SHA-256 digests, as manifests have it: sorted, hashed as RFC 6962 says."""
    return merkle_root(list(digests))


def run(
    tasks: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    workers: int | None = None,
    time_limit: float = 300,
    tries: int = 3,
    max_memory: str = "2G",
    progress: bool | Callable[[int], object] = False,
) -> dict[str, Any]:
    """Draws a list, a file of JSON lines, into a folder or an fsspec URL, and returns its manifest. What is whole there is
    not drawn again; tasks that fail are in its `failed`.

    `workers` is one a core by default; a task may take `time_limit` seconds, and is tried `tries` times if it ends its
    worker. `progress`: True shows a bar; a function is called with the number of tasks done.

    Raises `luxel.Error` or `OSError` if the list can't be read or nothing can be written."""
    tasks, out = os.fspath(tasks), os.fspath(out)
    flags = [f"--time-limit={time_limit}", f"--tries={tries}", f"--max-memory={max_memory}"]
    if is_url(out) or is_url(tasks):
        return _into_store(tasks, out, workers or os.cpu_count() or 1, flags, progress)
    words = ["batch", tasks, "-o", out, "--progress=json", *flags]
    if workers is not None:
        words.append(f"--workers={workers}")
    with subprocess.Popen([*PROGRAM, *words], stderr=subprocess.PIPE, encoding="utf-8") as process:
        assert process.stderr is not None
        said = _follow(process.stderr, progress)
        status = process.wait()
    manifest = pathlib.Path(out, "manifest.json")
    # A task that failed is in the manifest; a run that didn't end has none.
    if status > 1 or (status == 1 and not any("tasks failed" in line for line in said)):
        raise Error("".join(said).strip().removeprefix("luxel: error: "))
    document: dict[str, Any] = json.loads(manifest.read_bytes())
    return document


def _follow(lines: Iterator[str], progress: bool | Callable[[int], object]) -> list[str]:
    """Shows progress, and returns what else is said."""
    said: list[str] = []
    step: Callable[[int], object] | None = progress if callable(progress) else None
    for line in lines:
        try:
            event = json.loads(line)
        except ValueError:
            said.append(line)
            continue
        if event["event"] == "begun":
            if progress is True:
                step = bar(event["tasks"], "tasks")
            if step:
                step(event["whole"])
        elif step:
            step(event["finished"])
    return said


def _into_store(
    tasks: str, out: str, workers: int, flags: list[str], progress: bool | Callable[[int], object]
) -> dict[str, Any]:
    outputs = Outputs(out)
    listed = list(_tasks.read(tasks))
    answers = _tasks.whole(listed, _tasks.folder_of(tasks), outputs)
    wanted = [task for task in listed if task.error is None and task.entry not in answers]
    step: Callable[[int], object] | None = None
    if callable(progress):
        step = progress
    elif progress:
        step = bar(len(listed), "tasks")
    failures: list[BaseException] = []
    queue: Queue[_tasks.Task] = Queue()
    for task in wanted:
        queue.put(task)
    lock = threading.Lock()
    done = len(listed) - len(wanted)
    if step:
        step(done)

    def work() -> None:
        nonlocal done
        drawer = Drawer(_tasks.folder_of(tasks), out, flags)
        try:
            while not failures:
                task = queue.get_nowait()
                answer = _tasks.with_place(drawer.draw(task.line), tasks, task.number)
                if "error" not in answer:
                    outputs.put(task.entry, json.dumps(answer).encode("utf-8"))
                with lock:
                    answers[task.entry] = answer
                    done += 1
                    if step:
                        step(done)
        except Empty:
            pass
        except BaseException as error:
            failures.append(error)
        finally:
            drawer.close()

    threads = [threading.Thread(target=work, daemon=True) for _ in range(min(workers, len(wanted)))]
    try:
        for thread in threads:
            thread.start()
        for thread in threads:
            while thread.is_alive():
                thread.join(0.1)
    except KeyboardInterrupt as error:
        # What is at work is finished first.
        failures.append(error)
        for thread in threads:
            thread.join()
    if failures:
        raise failures[0]
    manifest = _tasks.manifest_of(listed, answers)
    outputs.put("manifest.json", _tasks.manifest_text(manifest))
    outputs.remove_parts()
    return manifest


def verify(tasks: str | os.PathLike[str], out: str | os.PathLike[str], sample: int = 10, seed: int = 0) -> list[str]:
    """Compares a folder of outputs with its manifest, and a random sample of tasks with what they are drawn again: the
    differences, one a line; none if all is as it should be.

    Raises `luxel.Error` if there is no manifest."""
    words = ["batch", "verify", os.fspath(tasks), os.fspath(out), f"--sample={sample}", f"--seed={seed}"]
    done = subprocess.run([*PROGRAM, *words, "--json"], capture_output=True, encoding="utf-8", check=False)
    if not done.stdout:
        raise Error(done.stderr.strip().removeprefix("luxel: error: "))
    return [f"{found['place']}: {found['what']}" for found in json.loads(done.stdout)["differences"]]


def _main() -> None:
    parser = argparse.ArgumentParser(prog="python -m luxel.batch", description=run.__doc__)
    parser.add_argument("tasks", help="a file of JSON lines, or an fsspec URL")
    parser.add_argument("-o", "--output", required=True, help="a folder, or an fsspec URL")
    parser.add_argument("--workers", type=int)
    given = parser.parse_args()
    manifest = run(given.tasks, given.output, workers=given.workers, progress=True)
    print(manifest["root"])
    sys.exit(bool(manifest["failed"]))


if __name__ == "__main__":
    _main()
