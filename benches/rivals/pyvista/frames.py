"""Frames of a mesh drawn by PyVista, without a display: what luxel is timed beside.

    LP_NUM_THREADS=2 python3 frames.py MESH.ply 640x480 none|back FRAMES SAMPLES [PICTURE.ppm]

Needs the package pyvista (and with it VTK). The scene is that of ../gl/frames.c with one light, as far as
VTK's own shader has it; the camera goes around the mesh and the light with it. Prints the median and
the least milliseconds until a frame is finished, and the median with what brings its pixels to memory,
which is not in the others. The picture is the first frame's.
"""

import math
import sys
import time

import pyvista
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray

path, size, cull, frames, samples, *picture = sys.argv[1:]
width, height = map(int, size.split("x"))
frames, samples = int(frames), int(samples)

plotter = pyvista.Plotter(off_screen=True, window_size=(width, height), lighting="none")
window = plotter.render_window
# One sample is none beside the pixel's own.
window.SetMultiSamples(samples if samples > 1 else 0)
plotter.background_color = "black"
plotter.add_mesh(
    pyvista.read(path),
    color=(0.8, 0.7, 0.6),
    ambient=0.1,
    diffuse=1,
    specular=0.4,
    specular_power=32,
    smooth_shading=True,
    culling="back" if cull == "back" else None,
    show_scalar_bar=False,
)
# Where a light that is the camera's stands, as seen from the camera: it looks from z = 1 at the middle.
plotter.add_light(pyvista.Light(position=(0.4, 0.6, 1), intensity=0.6, light_type="camera light"))
plotter.camera.view_angle = 45
pixels = vtkUnsignedCharArray()


def draw(frame):
    """Milliseconds until a frame is drawn, and until its pixels are in memory, too."""
    start = time.perf_counter()
    angle = 2 * math.pi * frame / frames
    plotter.camera_position = [(3 * math.sin(angle), 0, 3 * math.cos(angle)), (0, 0, 0), (0, 1, 0)]
    plotter.camera.clipping_range = (0.1, 10)
    window.Render()
    window.WaitForCompletion()
    drawn = time.perf_counter()
    window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
    return (drawn - start) * 1e3, (time.perf_counter() - start) * 1e3


for frame in range(1 + frames // 10):
    draw(frame)
if samples > 1 and window.GetMultiSamples() != samples:
    sys.exit(f"there are {window.GetMultiSamples()} samples at most")
times = [draw(frame) for frame in range(frames)]
drawn, read = (sorted(column) for column in zip(*times))
middle = frames // 2
renderer = [line.split(":")[1] for line in window.ReportCapabilities().splitlines() if "renderer string" in line]
print(f"{drawn[middle]:.3f} ms, least {drawn[0]:.3f}, read {read[middle]:.3f}, {window.GetMultiSamples()} samples,", *renderer)
if picture:
    draw(0)
    rgba = memoryview(pixels).tobytes()
    rows = [rgba[4 * width * y : 4 * width * (y + 1)] for y in range(height)]
    rgb = bytearray(width * height * 3)
    upright = b"".join(reversed(rows))
    for channel in range(3):
        rgb[channel::3] = upright[channel::4]
    with open(picture[0], "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (width, height) + rgb)
