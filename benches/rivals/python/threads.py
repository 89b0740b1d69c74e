"""Two threads that draw two scenes beside one thread that draws one: pictures a second, and the ratio.

    threads.py MESH.ply SIZE SECONDS
"""

import sys
import threading
import time

import luxel

path, size, seconds = sys.argv[1], int(sys.argv[2]), float(sys.argv[3])


def draw(scene, end, counts):
    camera = luxel.Camera.fit()
    count = 0
    while time.perf_counter() < end:
        scene.render((size, size), camera, samples=1, threads=1)
        count += 1
    counts.append(count)


def rate(threads):
    scenes = [luxel.load(path) for _ in range(threads)]
    for scene in scenes:
        scene.render((size, size), samples=1, threads=1)
    counts, end = [], time.perf_counter() + seconds
    workers = [threading.Thread(target=draw, args=(scene, end, counts)) for scene in scenes]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    return sum(counts) / seconds


one, two = rate(1), rate(2)
print(f"{one:.0f} {two:.0f} pictures a second: {two / one:.2f} times")
