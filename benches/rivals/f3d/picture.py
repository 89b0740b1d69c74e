"""A picture of a model by f3d, without a display: a whole process that luxel's is timed beside.

    python3 picture.py MODEL OUT.png 640x480

Needs the package f3d. The eye is where ../processes has luxel's; light and material are f3d's own. Only the
formats that are built into it are made ready.
"""

import sys

import f3d

model, out, size = sys.argv[1:]
f3d.Engine.load_plugin("native", [])
engine = f3d.Engine.create_egl()
engine.options["render.background.color"] = [0, 0, 0]
window = engine.window
window.size = tuple(map(int, size.split("x")))
engine.scene.add(model)
window.camera.position = (0, 0, 3)
window.camera.focal_point = (0, 0, 0)
window.camera.view_up = (0, 1, 0)
window.camera.view_angle = 45
window.render_to_image().save(out)
