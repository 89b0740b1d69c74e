"""Pictures of models by luxel, plain and with shadows, beside f3d's: a sheet of all, and each in full.

    python3 beside.py LUXEL MODELS OUT

LUXEL is the program, MODELS a folder, OUT a new one. Needs the packages f3d and pillow. Both look through the camera
that luxel chooses; light and material are each program's own. f3d has ambient occlusion, tone mapping and several
samples a pixel, by its lights and by its built-in picture of an environment.
"""

import json
import math
import pathlib
import subprocess
import sys

import f3d
from PIL import Image, ImageDraw

SIZE = (640, 480)
SMALL = (168, 126)
ENDS = {".glb", ".gltf", ".obj", ".ply", ".stl"}
ROUND = "--shadows --ao --ground --background white --exposure auto".split()


def luxel(program, model, out, flags):
    line = [program, "render", model, "-o", out, "--size", f"{SIZE[0]}x{SIZE[1]}", "--json", *flags]
    done = subprocess.run([str(word) for word in line], check=True, capture_output=True, text=True)
    sys.stderr.write(done.stderr)
    return json.loads(done.stdout)["camera"]


def peer(model, out, camera, ambient):
    engine = f3d.Engine.create_egl()
    options = engine.options
    options["render.background.color"] = [1, 1, 1]
    options["render.effect.ambient_occlusion"] = True
    options["render.effect.tone_mapping"] = True
    options["render.effect.antialiasing.mode"] = "ssaa"
    options["render.hdri.ambient"] = ambient
    options["scene.up_direction"] = "+Z" if model.suffix.lower() == ".stl" else "+Y"
    window = engine.window
    window.size = SIZE
    engine.scene.add(str(model))
    view = camera["view_from_world"]
    right, up, back = ([view[axis + 4 * column] for column in range(3)] for axis in range(3))
    moved = view[12:15]
    eye = [-sum(m * row[axis] for m, row in zip(moved, (right, up, back))) for axis in range(3)]
    window.camera.position = eye
    # The way to what is looked at scales steps of the camera only.
    far = math.hypot(*moved)
    window.camera.focal_point = [place - far * along for place, along in zip(eye, back)]
    window.camera.view_up = up
    window.camera.view_angle = 2 * math.degrees(math.atan(1 / camera["clip_from_view"][5]))
    window.render_to_image().save(out)


def main():
    program, models, out = (pathlib.Path(text).resolve() for text in sys.argv[1:])
    out.mkdir()
    f3d.Engine.autoload_plugins()
    rows = []
    for model in sorted(models.rglob("*"), key=lambda path: path.name.lower()):
        if model.suffix.lower() not in ENDS:
            continue
        files = [out / f"{model.stem}-{name}.png" for name in ("luxel", "luxel-round", "f3d", "f3d-hdri")]
        camera = luxel(program, model, files[0], [])
        luxel(program, model, files[1], ROUND)
        peer(model, files[2], camera, False)
        peer(model, files[3], camera, True)
        rows.append((model.name, files))
    title = 14
    across = 2
    height = title + SMALL[1]
    sheet = Image.new("RGB", (across * 4 * SMALL[0] + 12, -(-len(rows) // across) * height), "white")
    draw = ImageDraw.Draw(sheet)
    for number, (name, files) in enumerate(rows):
        x, y = number % across * (4 * SMALL[0] + 12), number // across * height
        draw.text((x + 4, y + 1), f"{name}: luxel, luxel with flags, f3d by its lights, f3d by its environment", fill="black")
        for column, file in enumerate(files):
            picture = Image.open(file).convert("RGBA")
            # Nothing is behind a model unless a flag says so.
            white = Image.new("RGBA", picture.size, "white")
            small = Image.alpha_composite(white, picture).convert("RGB").resize(SMALL, Image.LANCZOS)
            sheet.paste(small, (x + column * SMALL[0], y + title))
    sheet.save(out / "sheet.jpg", quality=82)


main()
