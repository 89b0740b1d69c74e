#!/usr/bin/env python3
"""The proof run: a list of tasks over Ray, whose actors and worker processes are killed at random, and its root beside that
of one process.

    python benches/rivals/ray/kills.py FOLDER [--tasks 100000] [--kills 20] [--actors 2] [--seed 1]

Needs Linux, luxel and ray[data]. FOLDER, which must be empty or absent, gets models, list and outputs. First
`luxel batch --workers 1` draws the list, then luxel.ray does: whenever a share of the tasks chosen at random is done, an
actor or its worker process, by turns, gets SIGKILL. At the end, every file is hashed and compared with the manifest, the root
is computed by hashlib, and both manifests are compared.
"""

import argparse
import hashlib
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import threading
import time

MODELS = 50


def write_models(folder: pathlib.Path, numbers: random.Random) -> None:
    """Bumpy closed bodies of 12 to 2,048 triangles."""
    for number in range(MODELS):
        rows, columns = 3 + number * 30 // MODELS, 3 + number * 32 // MODELS
        corners, faces = [], []
        for row in range(rows + 1):
            for column in range(columns):
                radius = 1 + 0.1 * numbers.random()
                theta, phi = row / rows * 180, column / columns * 360
                corners.append(point(radius, theta, phi))
        for row in range(rows):
            for column in range(columns):
                a, b = row * columns + column, row * columns + (column + 1) % columns
                faces += [(a, b, b + columns), (a, b + columns, a + columns)]
        text = [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in corners]
        text += [f"f {a + 1} {c + 1} {b + 1}" for a, b, c in faces]
        (folder / f"{number:02}.obj").write_text("\n".join(text) + "\n")


def point(radius: float, theta: float, phi: float) -> tuple[float, float, float]:
    from math import cos, radians, sin

    theta, phi = radians(theta), radians(phi)
    return radius * sin(theta) * sin(phi), radius * cos(theta), radius * sin(theta) * cos(phi)


def write_list(path: pathlib.Path, count: int, numbers: random.Random) -> None:
    with open(path, "w") as file:
        for number in range(count):
            view = {"azimuth": round(numbers.uniform(0, 360), 3), "elevation": round(numbers.uniform(-60, 60), 3)}
            model = f"models/{number * MODELS // count:02}.obj"
            layers = ["rgba", "z"] if number % 10 == 0 else ["rgba"]
            task = {"id": f"{number:06}", "model": model, "views": [view], "size": "64x64", "layers": layers}
            file.write(json.dumps(task) + "\n")


def processes() -> dict[int, tuple[int, bytes]]:
    """Parent and words of each process."""
    found = {}
    for place in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            parent = int((place / "stat").read_text().rsplit(") ", 1)[1].split()[1])
            found[int(place.name)] = (parent, (place / "cmdline").read_bytes())
        except (OSError, IndexError, ValueError):
            continue
    return found


def victims(words: bytes) -> list[int]:
    """Descendants of this process whose command line has these words."""
    known = processes()
    descendants = {os.getpid()}
    while True:
        more = {process for process, (parent, _) in known.items() if parent in descendants} | descendants
        if more == descendants:
            return [process for process in descendants - {os.getpid()} if words in known[process][1]]
        descendants = more


def kill(out: pathlib.Path, marks: list[int], numbers: random.Random, ended: threading.Event, began: float) -> None:
    """Kills a process whenever as many tasks are done as the next mark says."""
    kinds = [("actor", b"ray::MapWorker"), ("worker process", b"batch\0worker")]
    number = 0
    while number < len(marks) and not ended.wait(0.2):
        done = sum(len(os.listdir(folder)) for folder in (out / "log").glob("*"))
        if done < marks[number]:
            continue
        name, words = kinds[number % 2]
        ours = victims(words)
        if not ours:
            continue
        process = numbers.choice(ours)
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            continue
        number += 1
        print(f"{time.monotonic() - began:7.1f} s  {done:7} tasks done  kill -9 of {name} {number}", flush=True)


def root(digests: list[str]) -> str:
    def node(leaves: list[bytes]) -> bytes:
        if len(leaves) <= 1:
            return hashlib.sha256(b"\0" + leaves[0] if leaves else b"").digest()
        split = 1 << (len(leaves) - 1).bit_length() - 1
        return hashlib.sha256(b"\1" + node(leaves[:split]) + node(leaves[split:])).digest()

    return node(sorted(map(bytes.fromhex, digests))).hex()


def check(out: pathlib.Path, manifest: dict) -> None:
    """Every output whole, and nothing else there."""
    listed = {output["path"]: output["sha256"] for output in manifest["outputs"]}
    for path, digest in listed.items():
        assert hashlib.sha256((out / path).read_bytes()).hexdigest() == digest, path
    assert root([output["sha256"] for output in manifest["outputs"]]) == manifest["root"]
    for folder, _, names in os.walk(out):
        for name in names:
            path = os.path.relpath(os.path.join(folder, name), out)
            assert path in listed or path == "manifest.json" or path.startswith("log"), f"{path} is not listed"


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--tasks", type=int, default=100_000)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--actors", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    import luxel.ray
    import ray

    numbers = random.Random(given.seed)
    folder = given.folder.absolute()
    (folder / "models").mkdir(parents=True)
    write_models(folder / "models", numbers)
    tasks = folder / "tasks.jsonl"
    write_list(tasks, given.tasks, numbers)
    began = time.monotonic()
    program = [sys.executable, "-m", "luxel", "batch", str(tasks), "-o", str(folder / "one"), "--workers=1", "-q"]
    subprocess.run(program, check=True)
    took = time.monotonic() - began
    expected = json.loads((folder / "one" / "manifest.json").read_bytes())
    print(f"luxel batch, one process: {given.tasks} tasks, {took:.0f} s, root {expected['root']}", flush=True)

    ray.init(num_cpus=given.actors, log_to_driver=False, include_dashboard=False)
    marks = sorted(numbers.sample(range(given.tasks // 100, given.tasks * 95 // 100), given.kills))
    ended = threading.Event()
    began = time.monotonic()
    killer = threading.Thread(target=kill, args=(folder / "ray", marks, numbers, ended, began))
    killer.start()
    try:
        manifest = luxel.ray.run(tasks, folder / "ray", actors=given.actors)
    finally:
        ended.set()
        killer.join()
    took = time.monotonic() - began
    print(f"Ray, {given.actors} actors: {given.tasks} tasks, {took:.0f} s, root {manifest['root']}", flush=True)
    check(folder / "one", expected)
    check(folder / "ray", manifest)
    assert manifest == expected, "the manifests differ"
    whole, failed = len(manifest["outputs"]), len(manifest["failed"])
    print(f"{whole} outputs, all whole; {failed} failed; both manifests are the same")


if __name__ == "__main__":
    main()
