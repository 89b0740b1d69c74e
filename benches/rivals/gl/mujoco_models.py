#!/usr/bin/env python3
"""Draws models of MuJoCo on Mesa's libOSMesa and on luxel's: how long they take, and how far they differ.

    benches/rivals/gl/mujoco_models.py LIBRARIES MODEL.xml...

LIBRARIES is the folder with luxel's libraries that packaging/gl makes. Needs Mesa's libOSMesa.so.8 and the packages mujoco
3.17.0 and PyOpenGL. Pictures have 640x480 pixels, after 50 steps, with one sample a pixel and with four: medians of five
turns in milliseconds; pixels whose colours differ by more than 2 of 255, and by more than 8; pixels whose depths differ
by more than a thousandth; and pixels that show another object.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

SAMPLES = (0, 4)


def draw(model_file: str, folder: pathlib.Path) -> None:
    """Draws a model by the library that is loaded, and writes what it sees."""
    import time

    import mujoco
    import numpy as np

    model = mujoco.MjModel.from_xml_path(model_file)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data, 50)
    model.vis.global_.offwidth, model.vis.global_.offheight = 640, 480
    for samples in SAMPLES:
        model.vis.quality.offsamples = samples
        with mujoco.Renderer(model, 480, 640) as renderer:
            renderer.update_scene(data)
            picture = renderer.render()
            times = []
            for _ in range(5):
                start = time.perf_counter()
                picture = renderer.render()
                times.append(time.perf_counter() - start)
            renderer.enable_depth_rendering()
            depth = renderer.render()
            renderer.disable_depth_rendering()
            renderer.enable_segmentation_rendering()
            objects = renderer.render()
        median = sorted(times)[2]
        np.savez(folder / f"{samples}.npz", picture=picture, depth=depth, objects=objects, median=median)


def drawn(model_file: str, libraries: str | None) -> list[dict]:
    """What a library draws, for each number of samples: luxel's of that folder, or Mesa's."""
    import numpy as np

    environment = dict(os.environ, MUJOCO_GL="osmesa", PYOPENGL_PLATFORM="osmesa")
    if libraries is not None:
        environment["LD_LIBRARY_PATH"] = libraries
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, __file__, "--draw", model_file, folder], env=environment, check=True)
        return [dict(np.load(pathlib.Path(folder) / f"{samples}.npz")) for samples in SAMPLES]


def main() -> None:
    import numpy as np

    libraries, *models = sys.argv[1:]
    print("model              samples    Mesa   luxel  ratio   >2     >8   depths  objects")
    for model_file in models:
        both = zip(SAMPLES, drawn(model_file, None), drawn(model_file, libraries), strict=True)
        for samples, mesa, luxel in both:
            times = [float(of["median"]) * 1e3 for of in (mesa, luxel)]
            colors = np.abs(mesa["picture"].astype(int) - luxel["picture"]).max(axis=2)
            depths = np.abs(mesa["depth"] - luxel["depth"]) > 1e-3 * mesa["depth"]
            objects = (mesa["objects"] != luxel["objects"]).any(axis=2)
            counts = [(colors > 2).sum(), (colors > 8).sum(), depths.sum(), objects.sum()]
            name = pathlib.Path(model_file).stem
            numbers = f"{times[0]:7.0f} {times[1]:7.0f} {times[1] / times[0]:6.2f}"
            print(f"{name:20}{samples or 1:6} {numbers} {counts[0]:6} {counts[1]:6} {counts[2]:6} {counts[3]:6}")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--draw"]:
        draw(sys.argv[2], pathlib.Path(sys.argv[3]))
    else:
        main()
