"""First hits of rays through a mesh: luxel beside embreex, in turns.

    rays.py MESH.ply COUNT ROUNDS

Prints a row for each kind of rays, for luxel on one thread and on all; embreex has one. Medians in milliseconds of luxel and of
embreex, and the ratio. `camera` rays start at one point and pass through a window's pixels, `random` ones come from all around
to points near the mesh. luxel returns distances, triangles, objects, barycentrics and places in f64, embreex triangle numbers.
"""

import sys
import time

import luxel
import numpy as np
import trimesh
from embreex import rtcore_scene
from embreex.mesh_construction import TriangleMesh

IN_A_ROW = 5

path, count, rounds = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
mesh = trimesh.load(path, process=False)
ours = luxel.load(path)
theirs = rtcore_scene.EmbreeScene()
TriangleMesh(theirs, np.ascontiguousarray(mesh.triangles, np.float32))

generator = np.random.default_rng(1)
side = int(count**0.5)
across, down = np.meshgrid(np.linspace(-0.4, 0.4, side), np.linspace(-0.4, 0.4, side))
window = np.stack([across.ravel(), down.ravel(), np.full(side * side, -1.0)], axis=1)
origins = generator.normal(size=(count, 3))
origins *= 3 / np.linalg.norm(origins, axis=1, keepdims=True)
kinds = {
    "camera": (np.tile([0, 0, 3.0], (side * side, 1)), window),
    "random": (origins, generator.normal(scale=0.5, size=(count, 3)) - origins),
}
for kind, (origins, directions) in kinds.items():
    single = origins.astype(np.float32), directions.astype(np.float32)
    for threads in (1, 0):
        times = [], []
        for _ in range(rounds):
            # A few calls in a row, as programs make them: a thread that has just been woken is slow.
            for _ in range(IN_A_ROW):
                start = time.perf_counter()
                found = ours.rays(origins, directions, threads=threads)
                times[0].append(time.perf_counter() - start)
            for _ in range(IN_A_ROW):
                start = time.perf_counter()
                reference = theirs.run(*single)
                times[1].append(time.perf_counter() - start)
        differ = np.mean(found["triangle"] != reference)
        a, b = (np.median(list_) * 1e3 for list_ in times)
        name = f"rays: {kind}, {'one thread' if threads else 'all threads'}"
        print(f"{name:36} {a:8.2f} {b:8.2f} {b / a:6.2f}   {differ:.2%} of {len(reference)} rays differ")
