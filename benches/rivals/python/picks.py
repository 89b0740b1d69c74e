"""Ten thousand picks in one call, all over a window of 1280x720 pixels, beside embreex's first hits of the rays through
the same places, which return triangle numbers only: medians in milliseconds, and the ratio.

    picks.py MESH.ply ROUNDS
"""

import math
import sys
import time

import luxel
import numpy as np
import trimesh
from embreex import rtcore_scene
from embreex.mesh_construction import TriangleMesh

path, rounds = sys.argv[1], int(sys.argv[2])
size = 1280, 720
places = np.random.default_rng(3).uniform((0, 0), size, (10_000, 2))
mesh = trimesh.load(path, process=False)
theirs = rtcore_scene.EmbreeScene()
TriangleMesh(theirs, np.ascontiguousarray(mesh.triangles, np.float32))
scene = luxel.load(path)
pose = np.eye(4)
pose[2, 3] = 3
camera = luxel.Camera.from_pose(pose, fov_y=45, near=0.1, far=10)

half = math.tan(math.radians(45) / 2)
across = (2 * places[:, 0] / size[0] - 1) * half * size[0] / size[1]
down = (1 - 2 * places[:, 1] / size[1]) * half
directions = np.stack([across, down, np.full(len(places), -1.0)], axis=1).astype(np.float32)
origins = np.tile(np.float32([0, 0, 3]), (len(places), 1))

for threads in (1, 0):
    view = scene.view(size, camera, samples=1, threads=threads)
    found = view.pick_many(places)
    times = [], []
    for _ in range(rounds):
        start = time.perf_counter()
        found = view.pick_many(places)
        middle = time.perf_counter()
        reference = theirs.run(origins, directions)
        times[0].append(middle - start)
        times[1].append(time.perf_counter() - middle)
    differ = np.mean(found["triangle"] != reference)
    a, b = (np.median(list_) * 1e3 for list_ in times)
    name = f"10 000 picks, {'one thread' if threads else 'all threads'}"
    print(f"{name:36} {a:8.2f} {b:8.2f} {b / a:6.2f}   {differ:.2%} of {len(places)} differ")
