#!/usr/bin/env python3
"""A data set from a folder of models: 12 views of each, with depth, normals, objects and triangles.

    python dataset.py MODELS OUT                       # all cores of this machine
    python dataset.py MODELS OUT --ray                 # the cluster that Ray knows, or this machine
    python dataset.py MODELS s3://bucket/out --ray --tasks s3://bucket/tasks.jsonl

The list of tasks is written to OUT/tasks.jsonl, or where --tasks says. Run it again after an interruption: what is whole is not
drawn again.
"""

import argparse
import importlib
import json
import os
import pathlib
import sys

import luxel.batch

MODELS = {".glb", ".gltf", ".obj", ".ply", ".stl"}
LAYERS = ["rgba", "z", "normal", "object", "triangle"]


def tasks_of(models: pathlib.Path, views: int, size: str) -> list[str]:
    """A task for each model; its id is the path below the folder."""
    paths = sorted(path for path in models.rglob("*") if path.suffix.lower() in MODELS)
    lines = []
    for path in paths:
        task = {
            "id": path.relative_to(models).as_posix(),
            "model": str(path.absolute()),
            "orbit": {"count": views, "elevation": 20},
            "size": size,
            "layers": LAYERS,
        }
        lines.append(json.dumps(task))
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description="A data set from a folder of models.")
    parser.add_argument("models", type=pathlib.Path, help="a folder of models")
    parser.add_argument("out", help="a folder, or an fsspec URL")
    parser.add_argument("--tasks", help="where the list is written [default: OUT/tasks.jsonl]")
    parser.add_argument("--views", type=int, default=12)
    parser.add_argument("--size", default="224x224")
    parser.add_argument("--ray", action="store_true", help="draw on the cluster that Ray knows, or on this machine")
    parser.add_argument("--actors", type=int, help="how many actors or workers [default: one a core]")
    given = parser.parse_args()

    lines = tasks_of(given.models, given.views, given.size)
    tasks = given.tasks or f"{given.out.rstrip('/')}/tasks.jsonl"
    text = "".join(f"{line}\n" for line in lines)
    if "://" in tasks:
        fsspec = importlib.import_module("fsspec")
        with fsspec.open(tasks, "w") as file:
            file.write(text)
    else:
        os.makedirs(os.path.dirname(tasks) or ".", exist_ok=True)
        pathlib.Path(tasks).write_text(text)

    if given.ray:
        ray = importlib.import_module("luxel.ray")
        manifest = ray.run(tasks, given.out, actors=given.actors, progress=True)
    else:
        manifest = luxel.batch.run(tasks, given.out, workers=given.actors, progress=True)
    print(f"{len(lines)} models, {len(manifest['outputs'])} files, {len(manifest['failed'])} failed")
    print(manifest["root"])
    for task in manifest["failed"]:
        print(f"{task['id']}: {task['error']}", file=sys.stderr)
    sys.exit(bool(manifest["failed"]))


if __name__ == "__main__":
    main()
