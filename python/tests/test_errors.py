"""Bad input raises an exception that says what and where, and never ends the interpreter."""

import signal
import threading
import time

import luxel
import numpy as np
import pytest

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
        (lambda s: s.render((4, 4), samples=3), luxel.Error, "1, 2, 4, 8 or 16"),
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


@pytest.mark.skipif(threading.current_thread() is not threading.main_thread(), reason="signals need the main thread")
def test_ctrl_c_ends_long_work():
    scene = luxel.load("demo:teapot")
    timer = threading.Timer(0.3, lambda: signal.raise_signal(signal.SIGINT))
    timer.start()
    start = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(10_000):
            scene.render((1280, 720), samples=16, ao=True)
    assert time.perf_counter() - start < 30
