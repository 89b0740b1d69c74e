"""Random arguments to every public function and method: exceptions that the documentation names, never a crash and never
a panic.

    LUXEL_RANDOM_CALLS=100000 python -m pytest python/tests/test_fuzz.py -s

The calls follow from LUXEL_RANDOM_SEED; the last one is in the file that LUXEL_RANDOM_LOG names, also after a crash.
"""

import inspect
import os
import random
import types
from collections import Counter
from collections.abc import Callable
from typing import Any

import luxel
import luxel.batch
import numpy as np

try:
    import trimesh
except ImportError:
    trimesh = None

DOCUMENTED = (luxel.Error, ValueError, TypeError, OSError, OverflowError, KeyError, AttributeError, BufferError)
"""What bad arguments may raise."""

TRIANGLE = np.eye(3)
OBJ = b"mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\nusemtl a\nf 1/1/1 2/1/1 3/1/1\nf 1 3 4\n"
STL = b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n"
PLY = (
    b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    b"element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
)
GLTF = (
    b'{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":'
    b'{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,'
    b'"byteLength":36}],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,'
    b'AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}'
)
TOML = b'model = "demo:plane"\nsize = "8x8"\nbackground = "white"\n[[light]]\nkind = "directional"\ndir = [0, 0, -1]\n'
FILES = {"obj": OBJ, "stl": STL, "ply": PLY, "gltf": GLTF, "toml": TOML}

SETTINGS: dict[str, list[Any]] = {
    "samples": [1, 2, 4],
    "lights": [["directional:dir=1,1,1"], ["point:pos=1,2,3", "ambient:color=0.2,0.2,0.2"], []],
    "ambient": ["0.1,0.1,0.1", 0.2],
    "light_scale": [2.0],
    "background": ["white", "#102030", "transparent"],
    "environment": ["sky", "#406080"],
    "environment_rotation": [30],
    "environment_background": [True],
    "fog": ["linear:start=1:end=9", "exp:density=0.1"],
    "shadows": [True, False],
    "light_rays": [1, 4],
    "ao": [True, 0.5],
    "ao_rays": [1, 4],
    "ground": [True],
    "wireframe": [True],
    "edges": [True],
    "exposure": [1.0, "auto"],
    "tone": ["aces", "reinhard"],
    "encoding": ["srgb", "linear"],
    "cull": ["back", "none"],
    "shading": ["flat", "gouraud", "phong"],
    "tolerance": [0.5],
    "interpolation": ["perspective", "linear"],
    "clamp": [True],
    "normal_length": [0.1],
    "threads": [0, 1, 2],
    "simd": ["auto", "scalar", "sse2"],
}
LAYERS = ["z", "depth", "normal", "position", "object", "triangle", "barycentric", "uv", "ambient", "diffuse", "specular",
          "emission", "environment", "fog", "n_dot_l", "openness", "light:0", "rgba"]  # fmt: skip


class Reader:
    """A file object that gives what it likes."""

    def __init__(self, given: Any) -> None:
        self.given = given

    def read(self) -> Any:
        if isinstance(self.given, Exception):
            raise self.given
        return self.given


class Fuzz:
    """Makes calls from random numbers."""

    def __init__(self, seed: int) -> None:
        self.numbers = random.Random(seed)
        self.scenes = [luxel.load("demo:plane"), luxel.load("demo:cornell"), luxel.load(OBJ, format="obj")]
        self.views = [self.scenes[0].view((8, 8), samples=1), self.scenes[1].view((16, 12), shadows=True, light_rays=1)]
        self.frames = [self.views[0].render(LAYERS[:12])]
        self.ledgers = [self.views[0].explain(4, 4)]
        self.calls: list[tuple[str, Callable[..., Any]]] = []
        for name in luxel.__all__:
            item = getattr(luxel, name)
            if inspect.isclass(item):
                if not issubclass(item, Exception):
                    self.add_class(name, item)
            elif callable(item):
                self.calls.append((name, item))
        self.calls += [("batch.draw", luxel.batch.draw), ("batch.root", luxel.batch.root)]

    def add_class(self, name: str, item: type) -> None:
        for method in dir(item):
            is_special = method in ("__getitem__", "__getattr__", "_repr_png_", "_repr_html_", "__call__")
            # A class without a constructor has nothing to call; `show` opens a widget.
            if (is_special or not (method.startswith("_") or method == "show")) and callable(getattr(item, method)):
                self.calls.append((f"{name}.{method}", getattr(item, method)))

    def one(self, *choices: Any) -> Any:
        return self.numbers.choice(choices)

    def number(self) -> Any:
        return self.one(
            0, 1, -1, 3, 7.5, -0.0, 1e-320, 1e30, 1e300, -1e300, float("nan"), float("inf"), float("-inf"), 2**31, 2**32,
            2**63, 2**64, -(2**63), 10**400, True, np.float32(2), np.int8(-3), np.uint64(2**63), np.float16("nan"), 1j,
            self.numbers.uniform(-9, 9), self.numbers.randrange(-9, 9),
        )  # fmt: skip

    def array(self) -> Any:
        rows = self.one(0, 1, 2, 3, 4, 4, 4, 5, 100)
        shape = self.one((rows, 3), (rows, 3), (rows, 2), (rows, 4), (rows,), (rows, 3, 3), (0,), (), (3, rows), (4, 4))
        kind = self.one(
            np.float64, np.float64, np.float32, np.float16, np.int64, np.int32, np.uint8, np.uint64, np.int8, bool,
            complex, np.longdouble, object, "U3", "datetime64[s]",
        )  # fmt: skip
        numbers = np.random.default_rng(self.numbers.randrange(2**32))
        values = numbers.uniform(-2, 3, shape)
        if values.size and self.one(True, False, False):
            values.flat[numbers.integers(values.size)] = self.one(np.nan, np.inf, -np.inf, 1e300, 1e38, -1e38, 2**31, 1e-320)
        with np.errstate(all="ignore"):
            values = values.astype("i8").astype(kind) if kind == "datetime64[s]" else values.astype(kind)
        change = self.one("", "", "", "transposed", "reversed", "strided", "readonly", "fortran", "swapped", "list", "view")
        if change == "transposed":
            values = values.T
        elif change == "reversed" and values.ndim:
            values = values[::-1]
        elif change == "strided" and values.ndim:
            values = values[::2]
        elif change == "readonly":
            values.flags.writeable = False
        elif change == "fortran":
            values = np.asfortranarray(values)
        elif change == "swapped":
            values = values.astype(values.dtype.newbyteorder())
        elif change == "list":
            return values.tolist()
        elif change == "view" and values.dtype == np.float32 and values.size:
            # Not aligned.
            values = np.frombuffer(b"\0" + values.tobytes(), np.uint8)[1:].view(np.float32).reshape(values.shape)
        return values

    def text(self) -> str:
        return self.one(
            "", "x", "1,2,3", "nan", "\0", "\N{SNOWMAN}" * 50, "a" * 5000, "demo:plane", "demo:none", "-1", "1e999", "0x0",
            "99999x99999", "directional:dir=0,0,0", "point:pos=nan,0,0", "light:9", "opencv", "all", "any", "{}", "[", "8x8",
            "light:" + "9" * 30, "\ud800", "rgba", "z", *LAYERS, *SETTINGS,
        )  # fmt: skip

    def bytes(self) -> bytes:
        data = bytearray(self.one(*FILES.values()))
        for _ in range(self.one(0, 1, 1, 2, 5)):
            place = self.numbers.randrange(len(data) or 1)
            what = self.one("flip", "cut", "copy", "number")
            if what == "flip" and data:
                data[place] = self.numbers.randrange(256)
            elif what == "cut":
                del data[place : place + self.numbers.randrange(20)]
            elif what == "copy":
                data[place:place] = data[place : place + self.numbers.randrange(40)]
            else:
                data[place:place] = self.one(b"-1", b"999999999999", b"1e39", b"nan", b"\0", b"4294967295", b'"', b"[")
        return bytes(data)

    def odd(self) -> Any:
        return self.one(
            None, self.number(), self.number(), self.text(), self.text(), self.array(), self.array(), self.bytes(), object(),
            (), [], {}, {"a": 1}, [[0, 0, 0]], [None], (4,), (4, 4, 4), (0, 4), (-1, 4), (1.5, 4), (99999, 4), ("4", "4"),
            (2**40, 2**40), [self.text()], iter([1, 2]), range(3), lambda *_: int("x"), Reader(self.bytes()), np.eye(4), np.eye(3),
            bytearray(b"ply"), memoryview(b"ply"), self.one(*self.scenes), self.one(*self.views), luxel.Camera.fit(), luxel.Camera,
        )  # fmt: skip

    def mesh(self) -> Any:
        """An object of trimesh, or one that looks like it, with something wrong at times."""
        is_sound = trimesh is not None and self.one(True, True, False)
        mesh = trimesh.creation.box() if is_sound else types.SimpleNamespace(vertices=TRIANGLE, faces=[[0, 1, 2]])
        for name in ("vertices", "faces", "visual", "metadata", "vertex_normals"):
            if self.numbers.random() < 0.1:
                try:
                    setattr(mesh, name, self.odd())
                except Exception:  # noqa: BLE001, S112
                    # trimesh refuses it.
                    continue
        return mesh

    def camera(self) -> Any:
        return self.one(
            None, luxel.Camera.fit(self.numbers.uniform(0, 360)), luxel.Camera.look_at((3, 2, 5), (0, 0, 0), fov_y=30),
            luxel.Camera.fit(height=3), np.eye(4), luxel.Camera.fit(intrinsics=(9, 9, 4, 4)),
            luxel.Camera.look_at((1e6, 0, 0), (0, 0, 0), near=0.1, far=1e9),
        )  # fmt: skip

    def fitting(self, owner: str, name: str) -> Any:
        """An argument as it should be, mostly."""
        kinds: dict[str, Callable[[], Any]] = {
            "size": lambda: self.one((8, 8), (16, 4), (1, 1), [5, 3], (33, 7)),
            "camera": self.camera,
            "cameras": lambda: [self.camera() for _ in range(self.numbers.randrange(3))],
            "layers": lambda: self.numbers.sample(LAYERS, self.numbers.randrange(4)),
            "vertices": lambda: self.one(TRIANGLE, np.random.default_rng(3).random((4, 3)), self.array()),
            "faces": lambda: self.one([[0, 1, 2]], np.zeros((2, 3), int), self.array()),
            "normals": lambda: self.one(TRIANGLE, None),
            "colors": lambda: self.one(TRIANGLE, np.zeros((3, 4), np.uint8), None),
            "uv": lambda: self.one(TRIANGLE[:, :2], None),
            "texture": lambda: self.one(np.zeros((2, 2, 3), np.uint8), np.zeros((3, 1, 4), np.uint8)[::-1], None),
            "origins": lambda: np.random.default_rng(1).random((4, 3)),
            "directions": lambda: np.random.default_rng(2).random((4, 3)),
            "mode": lambda: self.one("closest", "any", "all"),
            "xy": lambda: self.one(np.random.default_rng(2).random((4, 2)) * 8, np.zeros((0, 2)), [[0.5, 7.9]]),
            "source": lambda: self.mesh() if owner == "Scene" else self.one("demo:plane", self.bytes(), Reader(self.bytes())),
            "vertices_clip": lambda: np.random.default_rng(3).uniform(-1, 1, (5, 4)),
            "format": lambda: self.one(None, *FILES),
            "max_memory": lambda: self.one(None, 10**6, 10**9),
            "task": lambda: {"id": "a", "model": "demo:plane", "size": "8x8"} | self.one({}, {self.text(): self.odd()}),
            "folder": lambda: ".",
            "digests": lambda: ["0" * 64] * self.numbers.randrange(4),
            "pose": lambda: np.eye(4),
            "convention": lambda: self.one("opengl", "opencv"),
            "intrinsics": lambda: self.one(None, (9, 9, 4, 4), np.eye(3)),
            "progress": lambda: self.one(None, False, len),
            "eye": lambda: (3, 2, 5),
            "target": lambda: (0, 0, 0),
            "up": lambda: self.one(None, (0, 0, 1)),
            "name": lambda: self.one(*LAYERS),
            "key": lambda: self.one(*LAYERS),
        }
        if name in kinds:
            return kinds[name]()
        if owner == "Camera":
            return self.one(None, None, 10, 20.5)
        return self.one(0, 1, 3, 2.5, 7.99)

    def value(self, owner: str, name: str) -> Any:
        return self.odd() if self.numbers.random() < 0.15 else self.fitting(owner, name)

    def arguments(self, name: str, function: Callable[..., Any]) -> tuple[list[Any], dict[str, Any]]:
        """Arguments by the function's signature, some of them wrong, missing or too many."""
        owner = name.split(".")[0]
        try:
            parameters = list(inspect.signature(function).parameters.values())
        except ValueError:
            parameters = []
        given: list[Any] = []
        named: dict[str, Any] = {}
        for parameter in parameters:
            if parameter.name == "self":
                owners: dict[str, Any] = {"Scene": self.scenes, "View": self.views, "Frame": self.frames, "Ledger": self.ledgers}
                given.append(self.odd() if self.numbers.random() < 0.01 else self.one(*owners.get(owner, [None])))
            elif parameter.kind == parameter.VAR_KEYWORD:
                for setting in self.numbers.sample(list(SETTINGS), self.one(0, 1, 2, 5)):
                    is_odd = self.numbers.random() < 0.3
                    named[setting] = self.odd() if is_odd else self.one(*SETTINGS[setting])
            elif parameter.default is parameter.empty or self.numbers.random() < 0.4:
                if parameter.kind == parameter.KEYWORD_ONLY:
                    named[parameter.name] = self.value(owner, parameter.name)
                elif not named:
                    given.append(self.value(owner, parameter.name))
            elif parameter.kind != parameter.KEYWORD_ONLY:
                # What follows goes by name.
                break
        if self.numbers.random() < 0.02:
            given.append(self.odd())
        if self.numbers.random() < 0.02:
            named[self.one("sise", "", "\0", "threads")] = self.odd()
        return given, named

    def use(self, result: Any) -> None:
        """Calls what a result has, and keeps some results for later calls."""
        for name in dir(result) if type(result).__module__.startswith("luxel") else ():
            if not name.startswith("_"):
                try:
                    item = getattr(result, name)
                    if name.startswith("to_"):
                        item()
                except DOCUMENTED:
                    continue
        kept: dict[type, list[Any]] = {luxel.Scene: self.scenes, luxel.View: self.views, luxel.Frame: self.frames}
        if type(result) in kept:
            known = kept[type(result)]
            # Small pictures and scenes keep the calls quick.
            if not isinstance(result, luxel.Scene) or result.triangle_count < 5000:
                known.append(result)
                if len(known) > 8:
                    known.pop(self.numbers.randrange(2, len(known)))


def written(values: list[Any]) -> str:
    """Values as they print; objects of trimesh with something wrong don't."""
    words = []
    for value in values:
        try:
            words.append(repr(value))
        except Exception:  # noqa: BLE001
            words.append(f"a {type(value)}")
    return ", ".join(words)


def test_a_random_argument_ends_the_interpreter_or_raises_what_no_one_documents(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    calls = int(os.environ.get("LUXEL_RANDOM_CALLS", "4000"))
    log = os.environ.get("LUXEL_RANDOM_LOG")
    fuzz = Fuzz(int(os.environ.get("LUXEL_RANDOM_SEED", "1")))
    done: Counter[str] = Counter()
    raised: Counter[str] = Counter()
    for number in range(calls):
        name, function = fuzz.one(*fuzz.calls)
        given, named = fuzz.arguments(name, function)
        what = f"call {number}: {name}({written([*given, named])})"
        if log:
            with open(log, "w", errors="replace") as file:
                file.write(what)
        try:
            fuzz.use(function(*given, **named))
            done[name] += 1
        except DOCUMENTED as error:
            raised[type(error).__name__] += 1
        except BaseException as error:
            # A panic is no Exception.
            raise AssertionError(f"{type(error).__name__}: {error}: {what}") from error
    print(f"{calls} calls, {sum(done.values())} without an exception; {dict(raised)}")
    few = [name for name, _ in fuzz.calls if done[name] == 0 and (trimesh or name != "Scene.from_trimesh")]
    assert calls < 4000 or not few, f"no call came through: {few}"
