"""Pictures a second, in one process, of one program.

    frames.py luxel|pyrender|pyvista MESH.ply SIZE rgba|depth|layers SAMPLES PICTURES THREADS [PICTURE.png]

`rgba` is colour alone, `depth` colour and depth, `layers` colour, depth, normals, objects and triangles (luxel
alone). THREADS are luxel's, 0 for all. The camera goes around the mesh; scene and context exist beforehand. Prints
the medians of the milliseconds of a picture: by the wall's clock, and of all processors.
"""

import math
import os
import sys
import time

import numpy as np

who, path, size, what, samples, pictures, threads, *picture = sys.argv[1:]
size, samples, pictures, threads = int(size), int(samples), int(pictures), int(threads)


def pose(frame):
    """A camera at distance 3 that looks at the origin."""
    angle = 2 * math.pi * frame / pictures
    sine, cosine = math.sin(angle), math.cos(angle)
    return np.array([[cosine, 0, sine, 3 * sine], [0, 1, 0, 0], [-sine, 0, cosine, 3 * cosine], [0, 0, 0, 1.0]])


def luxel_drawer():
    import luxel

    scene = luxel.load(path)
    layers = {"rgba": None, "depth": ["z"], "layers": ["z", "normal", "object", "triangle"]}[what]

    def draw(pose):
        camera = luxel.Camera.from_pose(pose, fov_y=45, near=0.1, far=10)
        lights = ["directional:dir=-.4,-.6,-1:in=camera"]
        frame = scene.render((size, size), camera, layers, samples=samples, threads=threads, lights=lights)
        return frame.rgba, frame.z if layers else None

    return draw


def pyrender_drawer():
    os.environ.setdefault("PYOPENGL_PLATFORM", "osmesa")
    np.infty = np.inf  # What pyrender needs and NumPy 2 lacks.
    import pyrender
    import trimesh

    scene = pyrender.Scene(bg_color=[0, 0, 0, 0], ambient_light=[0.1] * 3)
    scene.add(pyrender.Mesh.from_trimesh(trimesh.load(path, process=False), smooth=True))
    camera = scene.add(pyrender.PerspectiveCamera(math.radians(45), znear=0.1, zfar=10))
    light = scene.add(pyrender.DirectionalLight(intensity=3))
    renderer = pyrender.OffscreenRenderer(size, size)

    def draw(pose):
        scene.set_pose(camera, pose)
        scene.set_pose(light, pose)
        return renderer.render(scene)

    return draw


def pyvista_drawer():
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, window_size=(size, size), lighting="none")
    plotter.render_window.SetMultiSamples(samples if samples > 1 else 0)
    plotter.add_mesh(pyvista.read(path), color=(0.8, 0.7, 0.6), smooth_shading=True, specular=0.4)
    plotter.add_light(pyvista.Light(position=(0.4, 0.6, 1), light_type="camera light"))
    plotter.camera.view_angle = 45
    plotter.show(auto_close=False)

    def draw(pose):
        plotter.camera_position = [tuple(pose[:3, 3]), (0, 0, 0), (0, 1, 0)]
        plotter.camera.clipping_range = (0.1, 10)
        plotter.render()
        color = plotter.screenshot(None, return_img=True)
        return color, plotter.get_image_depth() if what != "rgba" else None

    return draw


draw = {"luxel": luxel_drawer, "pyrender": pyrender_drawer, "pyvista": pyvista_drawer}[who]()
for frame in range(3):
    draw(pose(frame))
if picture:
    from PIL import Image

    Image.fromarray(np.ascontiguousarray(draw(pose(0))[0])).save(picture[0])
wall, processor = [], []
for frame in range(pictures):
    clocks = time.perf_counter(), time.process_time()
    color, depth = draw(pose(frame))
    wall.append(time.perf_counter() - clocks[0])
    processor.append(time.process_time() - clocks[1])
if not color.any():
    sys.exit("the picture is empty")
print(f"{np.median(wall) * 1e3:.3f} {np.median(processor) * 1e3:.3f}")
