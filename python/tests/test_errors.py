"""Bad input raises an exception that says what and where, and never ends the interpreter."""

import os
import random
import signal
import threading
import time

import luxel
import luxel.pyrender as pyrender
import numpy as np
import pytest
from luxel._luxel import Stage, build_scene

TRIANGLE = np.eye(3)


def raises(kind, match):
    return pytest.raises(kind, match=match)


def test_a_broken_file_names_its_place(tmp_path):
    path = tmp_path / "broken.obj"
    path.write_text("v 0 0 0\nv 1 0 0\nf 1 2 9\n")
    with raises(luxel.LoadError, r"broken\.obj:3") as caught:
        luxel.load(path)
    error = caught.value
    assert (error.file, error.place) == (str(path), "3") and "9" in error.reason
    with raises(luxel.LoadError, "pass `format`"):
        luxel.load(b"nothing that anyone knows")
    with raises(FileNotFoundError, "absent"):
        luxel.load("absent.glb")
    with raises(luxel.LoadError, "limit is 1000"):
        luxel.load(b"solid a\nendsolid a\n" * 100, format="stl", max_memory=1000)


@pytest.mark.parametrize(
    "call,kind,match",
    [
        (lambda s: s.view((0, 4)), ValueError, "size"),
        (lambda s: s.view((4, 99999)), ValueError, "size"),
        (lambda s: s.view("4x4"), ValueError, "size"),
        (lambda s: s.view((4, 4), sampels=1), TypeError, "did you mean `samples`"),
        (lambda s: s.render((4, 4), samples=3), ValueError, "1, 2, 4, 8 or 16"),
        (lambda s: s.render((4, 4), layers=["zz"]), ValueError, "not a layer"),
        (lambda s: s.render((4, 4), layers=["light:none"]), luxel.Error, "no directional"),
        (lambda s: s.view((4, 4), lights=["sun"]), ValueError, "not a kind of light"),
        (lambda s: s.view((4, 4), background="tomat"), ValueError, "not a colour"),
        (lambda s: s.view((4, 4), shading="pong"), ValueError, "phong"),
        (lambda s: s.view((4, 4), ao=-1), ValueError, "ao"),
        (lambda s: s.view((4, 4), ao=float("nan")), ValueError, "ao"),
        (lambda s: s.view((4, 4), camera="eye"), ValueError, "no camera"),
        (lambda s: s.view((4, 4), camera=3), TypeError, "camera"),
        (lambda s: s.view((4, 4), camera=np.zeros((4, 4))), ValueError, "rotation"),
        (lambda s: s.view((4, 4), threads=-1), ValueError, "threads"),
        (lambda s: s.render((4, 4), threads=1025), ValueError, "threads"),
        (lambda s: s.rays([[0, 0, 0]], [[0, 0, 1]], threads=2**63), ValueError, "threads"),
        (lambda s: s.view((4, 4), simd="mmx"), ValueError, "simd"),
        (lambda s: s.view((4, 4)).pick(4, 0), ValueError, "outside"),
        (lambda s: s.view((4, 4)).explain(-1, 0), ValueError, "outside"),
        (lambda s: s.view((4, 4)).pick(float("nan"), 0.0), ValueError, "finite"),
        (lambda s: s.rays([[0, 0, 0]], [[0, 0, 0]]), ValueError, "no length"),
        (lambda s: s.rays([[0, 0, 0]], [[0, 0, 1]] * 2), ValueError, "2 rows for 1"),
        (lambda s: s.rays([[0, 0, np.inf]], [[0, 0, 1]]), ValueError, "finite"),
        (lambda s: luxel.Camera.look_at((0, 0, 0), (0, 0, 0)), ValueError, "same point"),
        (lambda s: luxel.Camera.fit(fov_y=0), ValueError, "fov_y"),
        (lambda s: luxel.Camera.fit(fov_y=40, height=3), TypeError, "exclude"),
        (lambda s: luxel.Camera.from_pose(np.eye(3)), ValueError, "pose"),
        (lambda s: luxel.Camera.from_pose(np.eye(4), "maya"), ValueError, "convention"),
        (lambda s: luxel.Camera.fit(near=2, far=1), ValueError, "far"),
    ],
)
def test_a_bad_argument_is_named(call, kind, match):
    with raises(kind, match):
        call(luxel.load("demo:teapot"))


@pytest.mark.parametrize(
    "arguments,match",
    [
        ({"faces": [[0, 1, 3]]}, "row 0 names vertex 3"),
        ({"faces": [[0, 1, -1]]}, "vertex -1"),
        ({"faces": [[0, 1]]}, "faces"),
        ({"faces": np.zeros((1, 3))}, "whole numbers"),
        ({"vertices": np.zeros((3, 2))}, r"shape \(n, 3\)"),
        ({"vertices": np.full((3, 3), np.nan)}, "row 0"),
        ({"vertices": np.full((3, 3), 1e300)}, "too far"),
        ({"vertices": [["a", "b", "c"]]}, "vertices"),
        ({"normals": np.zeros((2, 3))}, "2 rows for 3"),
        ({"colors": np.full((3, 3), 2.0)}, "between 0 and 1"),
        ({"colors": np.zeros((3, 5))}, "colors"),
        ({"uv": np.zeros((3, 3))}, "uv"),
        ({"texture": np.zeros((2, 2, 3), np.uint8)}, "needs `uv`"),
        ({"uv": np.zeros((3, 2)), "texture": np.zeros((2, 2))}, "texture"),
        ({"up": (0, 0, 0)}, "up"),
    ],
)
def test_a_bad_array_is_named(arguments, match):
    with raises(ValueError, match):
        luxel.Scene.from_arrays(**({"vertices": TRIANGLE, "faces": [[0, 1, 2]]} | arguments))


def test_random_arguments_never_end_the_interpreter():
    numbers = random.Random(7)
    scene = luxel.load("demo:plane")
    view = scene.view((8, 8), samples=1)
    odd = [None, -1, 0, 3, 2**40, 1.5, float("nan"), float("inf"), "", "x", "1,2,3", b"ply\n", b"\0" * 50, (), (4, 4),
           [[0, 0, 0]], [[1, 2, 3]], np.zeros((0, 3)), np.zeros((3, 3), np.int64), np.full((2, 3), np.inf), np.eye(4),
           object(), True, ["z"], ["directional:dir=1,1,1"], np.zeros((2, 2), complex), {"a": 1}]  # fmt: skip
    calls = [
        lambda: luxel.load(pick()),
        lambda: luxel.load(pick(), format=pick()),
        lambda: luxel.Scene.from_arrays(pick(), pick()),
        lambda: luxel.Scene.from_arrays(TRIANGLE, [[0, 1, 2]], colors=pick(), normals=pick(), uv=pick(), up=pick()),
        lambda: scene.view((4, 4), pick(), samples=pick(), lights=pick(), ao=pick(), fog=pick(), exposure=pick()),
        lambda: scene.view((4, 4), background=pick(), environment=pick(), tone=pick(), shading=pick()),
        lambda: scene.render(pick(), pick(), pick()),
        lambda: scene.rays(pick(), pick(), numbers.choice(["closest", "any", "all", "x"])),
        lambda: view.pick(pick(), pick()),
        lambda: view.pick_many(pick()),
        lambda: view.rect(pick(), pick(), pick(), pick()),
        lambda: view.explain(pick(), pick()),
        lambda: luxel.Camera.look_at(pick(), pick(), pick(), fov_y=pick(), near=pick(), far=pick()),
        lambda: luxel.Camera.from_pose(pick(), pick(), intrinsics=pick(), height=pick()),
        lambda: luxel.Scene.from_trimesh(pick(), up=pick()),
        lambda: build_scene(
            [{"vertices": TRIANGLE, "faces": [[0, 1, 2]]} | {numbers.choice(keys): pick()}], [{}], [], [("a", None, pick(), 0)]
        ),
        lambda: build_scene([], [{numbers.choice(keys): pick(), "metallic": pick()}], pick(), [("a", pick(), None, pick())]),
        lambda: stage.place([0, 0], np.array([pick(), pick()])),
        lambda: stage.place(pick(), np.zeros((1, 4, 4))),
        lambda: stage.draw(pick(), luxel.Camera.fit(near=0.1, far=9), pick(), pick()),
        lambda: stage.draw((4, 4), luxel.Camera.fit(), 3, None, pick(), lights=pick()),
        lambda: renderer.render(pyrender.Scene([numbers.choice(nodes), eye()], bg_color=pick())),
        lambda: nodes.append(pyrender.Node(mesh=pyrender.Mesh([primitive()]), matrix=pick())),
    ]  # fmt: skip

    def pick():
        return numbers.choice(odd)

    keys = ["vertices", "faces", "normals", "colors", "face_colors", "uv", "mode", "material", "base_color", "roughness",
            "emissive", "alpha_mode", "alpha_cutoff", "normal_texture", "double_sided", "unlit", "place", "name"]  # fmt: skip
    stage = Stage(build_scene([{"vertices": TRIANGLE, "faces": [[0, 1, 2]]}], [{}], [], [("a", None, None, 0)]), 1)
    renderer = pyrender.OffscreenRenderer(4, 4)
    nodes = [pyrender.Node()]

    def eye():
        return pyrender.Node(camera=pyrender.PerspectiveCamera(1.0, zfar=numbers.choice([None, 3.0])), translation=[0, 0, 2])

    def primitive():
        return pyrender.Primitive(numbers.choice([pick(), TRIANGLE]), normals=pick(), indices=pick(), color_0=pick(),
                                  texcoord_0=pick(), poses=pick(), mode=pick())  # fmt: skip

    done = 0
    for _ in range(int(os.environ.get("LUXEL_RANDOM_CALLS", "20000"))):
        try:
            numbers.choice(calls)()
            done += 1
        except (luxel.Error, ValueError, TypeError, OSError, OverflowError, IndexError, AttributeError):
            pass
    assert done > 100


@pytest.fixture
def ctrl_c():
    """Python handles Ctrl-C, which a shell's background jobs ignore."""
    if threading.current_thread() is not threading.main_thread():
        pytest.skip("signals need the main thread")
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.usefixtures("ctrl_c")
@pytest.mark.parametrize("layers", [None, ["z", "openness"]])
def test_ctrl_c_ends_a_picture_in_the_middle(layers):
    scene = luxel.load("demo:teapot")
    scene.render((64, 64), ao=True)
    timer = threading.Timer(0.5, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    start = time.perf_counter()
    # Uninterrupted, it takes minutes.
    with pytest.raises(KeyboardInterrupt):
        scene.render((6000, 6000), layers=layers, samples=16 if layers is None else 1, ao=64, ao_rays=256)
    assert time.perf_counter() - start < 10
    assert scene.render((64, 64), ao=True).rgba.any()


@pytest.mark.usefixtures("ctrl_c")
@pytest.mark.parametrize(("mode", "count"), [("closest", 2_000_000), ("any", 2_000_000), ("all", 600_000)])
def test_ctrl_c_ends_many_rays_in_the_middle(mode, count):
    scene = luxel.load("demo:blob")
    directions = np.random.default_rng(5).normal(size=(count, 3))
    origins = np.zeros_like(directions)

    def duration(part):
        start = time.perf_counter()
        scene.rays(origins[:part], directions[:part], mode, threads=1)
        return time.perf_counter() - start

    duration(1)
    whole = 10 * duration(count // 10)
    threading.Timer(0.1, lambda: signal.raise_signal(signal.SIGINT)).start()
    start = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        duration(count)
    assert time.perf_counter() - start < whole / 2


@pytest.mark.usefixtures("ctrl_c")
def test_ctrl_c_ends_long_work():
    scene = luxel.load("demo:teapot")
    timer = threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    start = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(10_000):
            scene.render((1280, 720), samples=16, ao=True)
    assert time.perf_counter() - start < 30
