"""The tasks of `luxel batch` over a cluster, by Ray Data.

    python -m luxel.ray tasks.jsonl -o s3://bucket/out

The same list gives the same outputs and the same root as `luxel batch` on one machine, however many actors there are and
whatever happens to them: outputs are named by content, so that a task that is drawn twice stores the same objects. docs/cluster.md
has sizes and costs. Needs `pip install "luxel[ray]"`.
"""

import argparse
import importlib
import json
import os
import sys
from collections.abc import Sequence
from typing import Any

from . import _tasks
from ._drawer import Drawer, Outputs, is_url

__all__ = ["Drawers", "run"]

_TASKS_A_BLOCK = 32
"""What Ray Data retries at a time when an actor is lost."""


class Drawers:
    """An actor of Ray Data that draws the tasks of batches: it keeps a worker process, which keeps the library and
    the model of the task before."""

    def __init__(self, tasks: str, out: str, flags: Sequence[str]) -> None:
        self.tasks = tasks
        self.drawer = Drawer(_tasks.folder_of(tasks), out, flags)

    def __call__(self, batch: dict[str, Any]) -> dict[str, Any]:
        answers: list[str] = []
        for line, number, entry in zip(batch["line"], batch["number"], batch["entry"], strict=True):
            answer = _tasks.with_place(self.drawer.draw(str(line)), self.tasks, int(number))
            if "error" not in answer:
                self.drawer.outputs.put(str(entry), json.dumps(answer).encode("utf-8"))
            answers.append(json.dumps(answer))
        return {"entry": batch["entry"], "answer": answers}


def run(
    tasks: str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    actors: int | None = None,
    time_limit: float = 300,
    tries: int = 3,
    max_memory: str = "2G",
    progress: bool = False,
) -> dict[str, Any]:
    """Draws a list of tasks on the cluster that Ray knows, or on this machine, and returns its manifest, which is stored
    beside the outputs.

    `tasks` is a file of JSON lines, `out` a folder that all nodes share or an fsspec URL; models lie where all nodes find
    them. `actors` is one a core by default. Lost actors and nodes are replaced and their tasks drawn again; what
    is whole already is not. Tasks that fail are in the manifest's `failed`.

    Raises `OSError` if the list can't be read or nothing can be written, and Ray's own exceptions."""
    ray: Any = importlib.import_module("ray")
    data: Any = importlib.import_module("ray.data")
    tasks, out = os.fspath(tasks), os.fspath(out)
    # Actors work elsewhere.
    tasks = tasks if is_url(tasks) else os.path.abspath(tasks)
    out = out if is_url(out) else os.path.abspath(out)
    outputs = Outputs(out)
    listed = list(_tasks.read(tasks))
    answers = _tasks.whole(listed, _tasks.folder_of(tasks), outputs)
    wanted = [task for task in listed if task.error is None and task.entry not in answers]
    if wanted:
        if not ray.is_initialized():
            ray.init(log_to_driver=False)
        context = data.DataContext.get_current()
        context.enable_progress_bars = progress
        count = min(actors or int(ray.cluster_resources().get("CPU", 1)), len(wanted))
        blocks = max(count, -(-len(wanted) // _TASKS_A_BLOCK))
        rows = [{"line": task.line, "number": task.number, "entry": task.entry} for task in wanted]
        flags = [f"--time-limit={time_limit}", f"--tries={tries}", f"--max-memory={max_memory}"]
        # Ray Data starts lost actors again and retries their batches, without a limit.
        drawn = data.from_items(rows, override_num_blocks=blocks).map_batches(
            Drawers,
            fn_constructor_args=(tasks, out, flags),
            batch_size=_TASKS_A_BLOCK,
            compute=data.ActorPoolStrategy(size=count),
            num_cpus=1,
        )
        for row in drawn.iter_rows():
            answer = json.loads(row["answer"])
            # Inputs and times stay in the log.
            answers[row["entry"]] = {key: answer[key] for key in ("error", "outputs") if key in answer}
    manifest = _tasks.manifest_of(listed, answers)
    outputs.put("manifest.json", _tasks.manifest_text(manifest))
    outputs.remove_parts()
    return manifest


def _main() -> None:
    parser = argparse.ArgumentParser(prog="python -m luxel.ray", description="Draws a list of tasks by Ray Data.")
    parser.add_argument("tasks", help="a file of JSON lines, or an fsspec URL")
    parser.add_argument("-o", "--output", required=True, help="a folder that all nodes share, or an fsspec URL")
    parser.add_argument("--actors", type=int, help="how many actors [default: one a core of the cluster]")
    parser.add_argument("--address", help="the cluster's address [default: this machine]")
    given = parser.parse_args()
    if given.address:
        importlib.import_module("ray").init(address=given.address, log_to_driver=False)
    manifest = run(given.tasks, given.output, actors=given.actors, progress=True)
    print(manifest["root"])
    sys.exit(bool(manifest["failed"]))


if __name__ == "__main__":
    _main()
