#!/usr/bin/env python3
"""Pictures a second: `luxel batch`, the same list over Ray, a luxel process a picture and an f3d process a picture, in turns.

    python benches/rivals/ray/speed.py LUXEL FOLDER [--tasks 6000] [--rounds 3]

LUXEL is the program, for processes; `luxel batch` is the package's, as Ray's actors are. FOLDER, which must be empty or
absent, gets models, lists and outputs. Needs luxel, ray[data] and, for its row, f3d (pip install f3d; it draws by EGL). All
have two workers. Pictures are RGBA of 224x224 as PNG, 1 sample, of closed meshes of 1 020 triangles, 12 views of each;
processes a picture draw fewer of the same. Ray's start is left out: a small list is drawn first; the second figure leaves the
start of actors out, too, and counts from the first stored task to the last.
"""

import argparse
import json
import math
import pathlib
import shutil
import statistics
import subprocess
import sys
import time

MODELS = 50
VIEWS = 12
HERE = pathlib.Path(__file__).parent


def write_model(path: pathlib.Path, number: int) -> None:
    """A bumpy closed mesh of 1 020 triangles."""
    rows, columns = 18, 30
    lines, faces = [], []
    for row in range(1, rows):
        for column in range(columns):
            theta, phi = math.pi * row / rows, 2 * math.pi * column / columns
            radius = 1 + 0.05 * math.sin(3 * phi + number) * math.sin(4 * theta)
            x, y, z = math.sin(theta) * math.sin(phi), math.cos(theta), math.sin(theta) * math.cos(phi)
            lines.append(f"{x * radius:.5f} {y * radius:.5f} {z * radius:.5f}")
    lines += ["0 1 0", "0 -1 0"]
    top, bottom, last = len(lines) - 2, len(lines) - 1, (rows - 2) * columns
    for column in range(columns):
        following = (column + 1) % columns
        faces += [(top, column, following), (bottom, last + following, last + column)]
        for row in range(rows - 2):
            a, b = row * columns + column, row * columns + following
            faces += [(a, a + columns, b + columns), (a, b + columns, b)]
    header = f"ply\nformat ascii 1.0\nelement vertex {len(lines)}\nproperty float x\nproperty float y\nproperty float z\n"
    header += f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    path.write_text(header + "\n".join(lines) + "\n" + "\n".join(f"3 {a} {b} {c}" for a, b, c in faces) + "\n")


def write_list(path: pathlib.Path, count: int, first: int = 0) -> None:
    with open(path, "w") as file:
        for number in range(first, first + count):
            model = f"models/{number * MODELS // (first + count):02}.ply"
            # No two tasks are the same.
            orbit = {"count": VIEWS, "azimuth": round(number * 0.013, 3), "elevation": 20}
            task = {"id": f"{number}", "model": model, "orbit": orbit, "size": "224x224", "samples": 1}
            file.write(json.dumps(task) + "\n")


def batch(folder: pathlib.Path, tasks: str) -> float:
    out = folder / "batch"
    shutil.rmtree(out, ignore_errors=True)
    began = time.perf_counter()
    command = [sys.executable, "-m", "luxel", "batch", str(folder / tasks), "-o", str(out), "--workers=2", "-q"]
    subprocess.run(command, check=True)
    return time.perf_counter() - began


def over_ray(folder: pathlib.Path, tasks: str) -> tuple[float, float]:
    import luxel.ray

    out = folder / "ray"
    shutil.rmtree(out, ignore_errors=True)
    began = time.perf_counter()
    luxel.ray.run(folder / tasks, out, actors=2)
    took = time.perf_counter() - began
    stored = [path.stat().st_mtime for path in (out / "log").rglob("*.json")]
    return took, max(stored) - min(stored)


def processes(lines: list[list[str]]) -> float:
    """Two at a time."""
    began = time.perf_counter()
    running: list[subprocess.Popen] = []
    for line in lines:
        if len(running) == 2:
            assert running.pop(0).wait() == 0, line
        running.append(subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
    for process in running:
        assert process.wait() == 0
    return time.perf_counter() - began


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("luxel")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--tasks", type=int, default=6000)
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args()
    import ray

    folder = given.folder.absolute()
    (folder / "models").mkdir(parents=True)
    for number in range(MODELS):
        write_model(folder / "models" / f"{number:02}.ply", number)
    write_list(folder / "tasks.jsonl", given.tasks)
    write_list(folder / "few.jsonl", 8, first=10**6)
    ray.init(num_cpus=2, log_to_driver=False, include_dashboard=False)
    over_ray(folder, "few.jsonl")
    model = [str(folder / "models" / f"{number:02}.ply") for number in range(MODELS)]
    one = [[given.luxel, "render", model[n % MODELS], "-o", str(folder / "one.png"), "--size=224x224", "--samples=1",
            f"--azimuth={n}", "--threads=1", "-q"] for n in range(400)]  # fmt: skip
    f3d = [[sys.executable, str(HERE.parent / "f3d" / "picture.py"), model[n], str(folder / f"f3d{n % 2}.png"), "224x224"]
           for n in range(20)]  # fmt: skip
    has_f3d = subprocess.run(f3d[0], capture_output=True, check=False).returncode == 0
    rates: dict[str, list[float]] = {}
    pictures = given.tasks * VIEWS
    for _ in range(given.rounds):
        turn = {"luxel batch": pictures / batch(folder, "tasks.jsonl")}
        whole, inner = over_ray(folder, "tasks.jsonl")
        turn |= {"Ray": pictures / whole, "Ray, without the start of actors": pictures / inner}
        turn["a luxel process a picture"] = len(one) / processes(one)
        if has_f3d:
            turn["an f3d process a picture"] = len(f3d) / processes(f3d)
        for name, rate in turn.items():
            rates.setdefault(name, []).append(rate)
        print("  ".join(f"{name} {rate:.1f}" for name, rate in turn.items()), flush=True)
    first = rates["luxel batch"]
    for name, found in rates.items():
        ratio = statistics.median(a / b for a, b in zip(found, first, strict=True))
        print(f"{name:34} {statistics.median(found):8.1f} pictures a second, {ratio:.4f} of luxel batch")


if __name__ == "__main__":
    main()
