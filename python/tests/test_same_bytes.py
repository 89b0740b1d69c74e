"""Pictures, layers, picks and ledgers are those of the program."""

import io
import json
from concurrent.futures import ThreadPoolExecutor

import luxel
import numpy as np
import pytest

SIZE = (64, 48)
LAYERS = [
    "depth", "z", "normal", "position", "object", "triangle", "barycentric", "uv", "ambient", "diffuse",
    "specular", "emission", "environment", "fog", "n_dot_l", "openness",
]  # fmt: skip


@pytest.mark.parametrize("demo", luxel.demos())
def test_demos_have_the_program_s_bytes(run, demo):
    scene = luxel.load(f"demo:{demo}")
    for samples in [1, 2, 4, 8, 16]:
        flags = ["--size", "64x48", "--samples", str(samples)]
        assert scene.render(SIZE, samples=samples).to_png() == run("render", f"demo:{demo}", *flags, suffix=".png")


@pytest.mark.parametrize("demo", ["teapot", "welcome", "cornell", "spheres"])
def test_layers_have_the_program_s_values(run, demo):
    scene = luxel.load(f"demo:{demo}")
    for samples in [1, 4]:
        frame = scene.render(SIZE, layers=LAYERS, samples=samples)
        for layer in LAYERS:
            flags = ["--size", "64x48", "--samples", str(samples), "--layer", layer]
            file = run("render", f"demo:{demo}", *flags, suffix=".npy")
            expected = np.load(io.BytesIO(file))
            found = frame[layer]
            assert found.dtype == expected.dtype and found.shape == expected.shape, layer
            np.testing.assert_array_equal(found, expected, err_msg=layer)


SETTINGS = [
    ({"shadows": True, "ao": True, "ground": True, "background": "white"},
     ["--shadows", "--ao", "--ground", "--background", "white"]),
    ({"shading": "gouraud", "lights": ["directional:dir=-1,-2,-1", "point:pos=2,3,4:name=lamp"]},
     ["--shading", "gouraud", "--light", "directional:dir=-1,-2,-1", "--light", "point:pos=2,3,4:name=lamp"]),
    ({"exposure": 1.5, "tone": "agx", "ambient": [0.1, 0.2, 0.3], "cull": "back"},
     ["--exposure", "1.5", "--tone", "agx", "--ambient", "0.1,0.2,0.3", "--cull", "back"]),
    ({"environment": "studio", "environment_background": True, "exposure": "auto", "light_scale": 3},
     ["--environment", "studio", "--environment-background", "--exposure", "auto", "--light-scale", "3"]),
    ({"shading": "subdivided", "tolerance": 2, "encoding": "none", "ao": 0.5, "ao_rays": 3},
     ["--shading", "subdivided", "--tolerance", "2", "--encoding", "none", "--ao=0.5", "--ao-rays", "3"]),
]  # fmt: skip


@pytest.mark.parametrize("settings,flags", SETTINGS)
def test_settings_are_the_program_s_flags(run, settings, flags):
    frame = luxel.load("demo:welcome").render(SIZE, **settings)
    assert frame.to_png() == run("render", "demo:welcome", "--size", "64x48", *flags, suffix=".png")


CAMERAS = [
    (luxel.Camera.fit(120, -10), ["--azimuth", "120", "--elevation", "-10"]),
    (luxel.Camera.fit(height=5), ["--ortho", "5"]),
    (luxel.Camera.look_at((3, 2, 8), (0, 0.5, 0), fov_y=30), ["--eye", "3,2,8", "--target", "0,0.5,0", "--fov", "30"]),
    (luxel.Camera.look_at((3, 2, 8), (0, 0, 0), (1, 0, 0), near=6, far=9),
     ["--eye", "3,2,8", "--target", "0,0,0", "--up", "1,0,0", "--near", "6", "--far", "9"]),
    (luxel.Camera.look_at((3, 2, 8), (0, 0, 0), intrinsics=(70, 60, 30, 26)),
     ["--eye", "3,2,8", "--target", "0,0,0", "--intrinsics", "70,60,30,26"]),
]  # fmt: skip


@pytest.mark.parametrize("camera,flags", CAMERAS)
def test_cameras_are_the_program_s(run, camera, flags):
    frame = luxel.load("demo:teapot").render(SIZE, camera)
    assert frame.to_png() == run("render", "demo:teapot", "--size", "64x48", *flags, suffix=".png")


def test_a_ledger_is_the_program_s_document(run):
    ledger = luxel.load("demo:welcome").view(SIZE, shadows=True).explain(32, 24)
    document = json.loads(run("explain", "demo:welcome", "--size", "64x48", "--shadows", "--at", "32,24", "--json"))
    assert ledger.to_dict() == {key: value for key, value in document.items() if key != "model"}


def test_a_pixel_s_ledger_has_its_bytes():
    view = luxel.load("demo:cornell").view(SIZE, shadows=True, ao=True)
    rgba = view.render().rgba
    for x, y in [(10, 10), (32, 24), (40, 40), (63, 47)]:
        assert view.explain(x, y).rgba == tuple(rgba[y, x].tolist())


def test_picks_are_what_layers_show():
    view = luxel.load("demo:teapot").view(SIZE, samples=1)
    frame = view.render(["object", "triangle", "z"])
    centres = np.stack(np.meshgrid(np.arange(64) + 0.5, np.arange(48) + 0.5), -1).reshape(-1, 2)
    hits = view.pick_many(centres)
    none = 2**32 - 1
    for name in ["object", "triangle"]:
        shown = frame[name].astype(np.int64).ravel()
        np.testing.assert_array_equal(hits[name], np.where(shown == none, -1, shown))
    seen = hits["object"] >= 0
    np.testing.assert_allclose(hits["z"][seen], frame.z.ravel()[seen], rtol=1e-5)
    hit = view.pick(32, 24)
    assert (hit.object, hit.triangle) == (frame.object[24, 32], frame.triangle[24, 32])
    assert view.pick(0, 0) is None
    assert view.pick_through(32, 24)[0].triangle == hit.triangle


def test_rectangles_are_the_program_s(run):
    view = luxel.load("demo:teapot").view(SIZE)
    flags = ["--size", "64x48", "--rect", "20,20,20,10", "--json"]
    for names, more in [({}, []), ({"visible": True}, ["--visible"]), ({"enclosed": True}, ["--enclosed"])]:
        document = json.loads(run("pick", "demo:teapot", *flags, *more))
        assert view.rect(20, 20, 20, 10, **names) == document["hits"]


def test_files_bytes_and_file_objects_are_one_model(run, models):
    for name in ["bunny.ply", "Fox.glb", "featuretype.STL"]:
        path = models / name
        of_file = run("render", str(path), "--size", "64x48", suffix=".png")
        with path.open("rb") as file:
            for source in [path, str(path), path.read_bytes(), file]:
                assert luxel.load(source).render(SIZE).to_png() == of_file, name


def test_threads_at_once_draw_the_same_bytes():
    scenes = [luxel.load(f"demo:{name}") for name in ["teapot", "welcome"]]
    expected = [scene.render(SIZE, layers=["z"], threads=1) for scene in scenes]

    def draw(number):
        return scenes[number % 2].render(SIZE, layers=["z"], threads=number % 3)

    with ThreadPoolExecutor(4) as pool:
        for number, frame in enumerate(pool.map(draw, range(64))):
            for name in ["rgba", "z"]:
                np.testing.assert_array_equal(frame[name], expected[number % 2][name])


def test_instruction_sets_draw_the_same_bytes():
    scene = luxel.load("demo:teapot")
    pictures = {scene.render(SIZE, simd=simd).rgba.tobytes() for simd in ["auto", "scalar"]}
    assert len(pictures) == 1
