"""Memory over many pictures of changing scenes: what is resident after 5 % and after all of them.

    memory.py PICTURES
"""

import sys

import luxel
import numpy as np

pictures = int(sys.argv[1])


def resident():
    with open("/proc/self/statm", encoding="ascii") as statm:
        return int(statm.read().split()[1]) * 4096


generator = np.random.default_rng(1)
empty, early = 0, 0
for number in range(pictures):
    if number % 50 == 0:
        vertices = generator.normal(size=(600, 3))
        scene = luxel.Scene.from_arrays(vertices, generator.integers(0, 600, (200, 3)))
    frame = scene.render((64, 64), luxel.Camera.fit(number % 360), ["z"], samples=1, threads=1)
    empty += not frame.rgba.any()
    if number == pictures // 20:
        early = resident()
print(f"{early / 1e6:.1f} MB, {resident() / 1e6:.1f} MB at the end: {resident() / early:.3f}; {empty} empty pictures")
