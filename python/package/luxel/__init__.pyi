"""3D pictures, masks, picks and explained pixels on the CPU, the same bytes on every machine."""

from collections.abc import Callable, Iterable, Sequence
from os import PathLike
from typing import Any, Literal, Protocol, TypedDict, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._gl import osmesa_path as osmesa_path
from ._rasterize import rasterize as rasterize

__version__: str

__all__ = [
    "Camera",
    "Error",
    "Frame",
    "Hit",
    "Ledger",
    "LoadError",
    "Scene",
    "View",
    "__version__",
    "demos",
    "load",
    "osmesa_path",
    "rasterize",
]

_Convention = Literal["opengl", "opencv"]

class Error(Exception):
    """What luxel can't do; the base of its exceptions."""

class LoadError(Error):
    """A model that can't be read."""

    file: str | None
    """Its path; None for bytes."""
    place: str
    """Where in the file: a line, a line and a column, a byte, a JSON pointer; empty for the whole file."""
    reason: str
    """The cause, without the place."""

class _Readable(Protocol):
    def read(self) -> bytes: ...

class _TrimeshGeometry(Protocol):
    """A trimesh.Trimesh or PointCloud."""

    @property
    def vertices(self) -> Any: ...

class _TrimeshScene(Protocol):
    """A trimesh.Scene."""

    @property
    def geometry(self) -> Any: ...
    @property
    def graph(self) -> Any: ...

@final
class Camera:
    """A camera: where it is, its lens and its clipping planes.

    The lens is one of `fov_y` (degrees from bottom to top; 45 by default), `height` (parallel rays: world units
    from bottom to top) and `intrinsics`: fx, fy, cx, cy in pixels, or a 3x3 matrix. `near` and `far` are
    distances along the viewing axis; without them, they are fitted to the scene.
    """

    @staticmethod
    def fit(
        azimuth: float = 30.0,
        elevation: float = 20.0,
        *,
        fov_y: float | None = None,
        height: float | None = None,
        intrinsics: ArrayLike | None = None,
        near: float | None = None,
        far: float | None = None,
    ) -> Camera:
        """A camera that sees the whole model from a direction, in degrees: from the front towards the right, and
        upwards."""

    @staticmethod
    def look_at(
        eye: ArrayLike,
        target: ArrayLike,
        up: ArrayLike | None = None,
        *,
        fov_y: float | None = None,
        height: float | None = None,
        intrinsics: ArrayLike | None = None,
        near: float | None = None,
        far: float | None = None,
    ) -> Camera:
        """A camera at `eye` that looks to `target`; `up` is the scene's by default."""

    @staticmethod
    def from_pose(
        pose: ArrayLike,
        convention: _Convention = "opengl",
        *,
        fov_y: float | None = None,
        height: float | None = None,
        intrinsics: ArrayLike | None = None,
        near: float | None = None,
        far: float | None = None,
    ) -> Camera:
        """A camera by its 4x4 pose, from camera to world coordinates, a rotation and a translation. Its axes point
        right, up and back (`opengl`, as in pyrender and trimesh) or right, down and ahead (`opencv`)."""

class _RegionHit(TypedDict, total=False):
    """An object in a rectangle, as `luxel pick --rect --json` lists it."""

    index: int
    object: str
    path: list[str]
    names: list[str]
    z_min: float
    z_max: float
    triangles: int
    points_and_lines: int
    pixels: int

class _Place(TypedDict):
    """Where a defect is."""

    index: int
    object: str
    path: list[str]
    triangle: int | None
    position: list[float]
    """In world space."""

class _Finding(TypedDict):
    """The defects of a kind in a scene."""

    kind: str
    about: str
    count: int
    severity: float | None
    """The largest difference in a picture, in steps of 255."""
    pixels: float | None
    """How far a silhouette or an attribute is off at most."""
    places: list[_Place]
    """The first sixteen."""
    cure: str

class _Hits(TypedDict):
    """What is visible at n points; -1 and nan where nothing is, and -1 for the triangle of points and lines."""

    object: NDArray[np.int64]
    triangle: NDArray[np.int64]
    barycentric: NDArray[np.float64]
    position: NDArray[np.float64]
    normal: NDArray[np.float64]
    distance: NDArray[np.float64]
    z: NDArray[np.float64]
    depth: NDArray[np.float64]

@final
class Hit:
    """A surface at a point of the picture."""

    object: int
    """Its place in `Scene.objects`."""
    name: str
    element: Literal["triangle", "point", "line"]
    index: int
    """The element's number in the object."""
    triangle: int | None
    """The same of triangles."""
    material: str
    barycentric: list[float]
    """The weights of the triangle's corners."""
    position: list[float]
    """In world space."""
    normal: list[float]
    """The unit shading normal in world space, on the side of the eye."""
    geometric_normal: list[float]
    """The unit normal of the triangle's plane, on the side of the eye."""
    uv: list[float] | None
    color: list[float] | None
    """The interpolated linear vertex colour, with alpha."""
    distance: float
    """From the eye."""
    z: float
    """Along the viewing axis."""
    depth: float
    """Window depth, 0 near to 1 far."""

@final
class Ledger:
    """Every term of a pixel's light, which add up to its bytes. It prints as `luxel explain` does."""

    rgba: tuple[int, int, int, int]
    """Red, green, blue, alpha: those of the picture."""
    pixel: tuple[int, int]
    """Column and row."""

    def to_dict(self) -> dict[str, Any]:
        """The document of `luxel explain --json`."""

    def to_json(self) -> str:
        """The same as text."""

    def to_latex(self) -> str:
        """A fragment for a document with amsmath."""

    def to_html(self) -> str:
        """A page with drawings of the pixel's neighbourhood and vectors."""

    def _repr_html_(self) -> str: ...

@final
class Frame:
    """A drawn view. Arrays are C-contiguous, rows from the top; layers that weren't asked for are missing.

    Layers by their names on the command line, as attributes or in brackets: `frame.z`, `frame["light:key"]`.
    """

    rgba: NDArray[np.uint8]
    """(h, w, 4): sRGB with straight alpha."""
    depth: NDArray[np.float32]
    """(h, w): window depth, 0 near, 1 far and where nothing is."""
    z: NDArray[np.float32]
    """(h, w): distance along the viewing axis in world units; infinite where nothing is."""
    normal: NDArray[np.float32]
    """(h, w, 3): unit shading normals in world space; 0 where nothing is."""
    position: NDArray[np.float32]
    """(h, w, 3): places in world space; 0 where nothing is."""
    object: NDArray[np.uint32]
    """(h, w): places in `Scene.objects`; 4294967295 where nothing is."""
    triangle: NDArray[np.uint32]
    """(h, w): numbers in the object; 4294967295 where nothing is."""
    barycentric: NDArray[np.float32]
    """(h, w, 3): weights of the corners; 0 where nothing is."""
    uv: NDArray[np.float32]
    """(h, w, 2): texture coordinates, (0, 0) at the upper left; 0 where there are none."""
    ambient: NDArray[np.float32]
    """(h, w, 3): terms of the light, linear; with the next five, they add up to the colour before clamping."""
    diffuse: NDArray[np.float32]
    specular: NDArray[np.float32]
    emission: NDArray[np.float32]
    environment: NDArray[np.float32]
    fog: NDArray[np.float32]
    n_dot_l: NDArray[np.float32]
    """(h, w): N.L of the first light."""
    openness: NDArray[np.float32]
    """(h, w): 1 without `ao`."""
    names: list[str]
    """What it holds."""

    def __getitem__(self, name: str, /) -> NDArray[Any]: ...
    def to_png(self) -> bytes:
        """The picture as the bytes of a PNG file, those of `luxel render`."""

    def _repr_png_(self) -> bytes: ...

@final
class View:
    """A scene seen by a camera, with lights, shading and size."""

    size: tuple[int, int]
    """(width, height)."""

    def render(self, layers: Sequence[str] | None = None) -> Frame:
        """Draws the view, and layers of these names."""

    def pick(self, x: float, y: float) -> Hit | None:
        """What is visible at a point, in pixels from the upper left corner; ints mean the pixel's centre. None where
        nothing is."""

    def pick_through(self, x: float, y: float) -> list[Hit]:
        """All surfaces at a point, nearest first."""

    def pick_many(self, xy: ArrayLike) -> _Hits:
        """What is visible at many points, (n, 2), where a pixel's centre is at .5."""

    def show(self) -> Any:
        """The view as a `luxel_notebook.Widget`, as `Scene.show`."""

    def _packed(self) -> tuple[bytes, bytes]: ...
    def _repr_png_(self) -> bytes: ...
    def rect(
        self, x: float, y: float, w: float, h: float, *, visible: bool = False, enclosed: bool = False
    ) -> list[_RegionHit]:
        """The objects in a rectangle, by its upper left corner and size in pixels. `visible`: only those that are seen
        there, with `pixels`; `enclosed`: only those that lie inside entirely."""

    def explain(self, x: float, y: float) -> Ledger:
        """Why a pixel has its colour: ints mean the pixel with all its samples, floats one sample at that point."""

@final
class Scene:
    """Meshes, materials, lights and cameras, ready to be drawn. It never changes, and threads may share it.

    Settings are the flags of the command line: `samples` (1, 2, 4, 8 or 16; 4), `lights` (a list of texts as --light
    takes), `ambient`, `light_scale`, `background`, `environment` (also an .hdr or .exr file),
    `environment_rotation`, `environment_background`, `fog`, `shadows`, `light_rays`, `ao` (True or a radius),
    `ao_rays`, `ground`, `exposure` (stops or "auto"), `tone`, `encoding`, `cull`, `shading`, `tolerance`,
    `interpolation`, `clamp`, `normal_length`, `wireframe`, `edges`, `threads` (0: one a core) and `simd`.
    """

    objects: list[str]
    """Names, by whose places layers and hits number objects."""
    cameras: list[str]
    warnings: list[str]
    """What the reader left out or replaced."""
    bounds: NDArray[np.float64]
    """(2, 3): the least and the greatest corner of the box in world space."""
    triangle_count: int

    @staticmethod
    def from_arrays(
        vertices: ArrayLike,
        faces: ArrayLike,
        *,
        normals: ArrayLike | None = None,
        colors: ArrayLike | None = None,
        uv: ArrayLike | None = None,
        texture: NDArray[np.uint8] | None = None,
        up: ArrayLike | None = None,
    ) -> Scene:
        """A scene of one mesh: `vertices` (n, 3), `faces` (m, 3) of whole numbers; a row a vertex: `normals` (n, 3),
        `colors` (n, 3) or (n, 4), sRGB bytes or linear floats, `uv` (n, 2), (0, 0) at the texture's lower left.
        `texture` (h, w, 3) or (h, w, 4) has rows from the top; `up` is +Y by default."""

    @staticmethod
    def from_trimesh(
        source: _TrimeshGeometry | _TrimeshScene, *, smooth: bool | None = None, up: ArrayLike | None = None
    ) -> Scene:
        """A scene of a trimesh.Trimesh, PointCloud or Scene: what is shown several times is held once, nodes are objects
        by their names. Colours of vertices and faces, textures and materials come along. `smooth`: True takes the
        mesh's vertex normals, False makes faces flat; None smooths edges up to 40 degrees."""

    def view(self, size: tuple[int, int], camera: Camera | str | ArrayLike | None = None, **settings: Any) -> View:
        """A view. Without a camera, the file's first one, else one that sees the whole model; a string names a
        camera of the file, a 4x4 array is a pose (OpenGL)."""

    def render(
        self,
        size: tuple[int, int],
        camera: Camera | str | ArrayLike | None = None,
        layers: Sequence[str] | None = None,
        **settings: Any,
    ) -> Frame:
        """`view(...)` and `render(layers)` in one call."""

    def render_views(
        self,
        cameras: Iterable[Camera | str | ArrayLike],
        size: tuple[int, int],
        layers: Sequence[str] | None = None,
        *,
        progress: bool | Callable[[int], object] | None = None,
        **settings: Any,
    ) -> list[Frame]:
        """The scene from several cameras. `progress`: True shows a bar on a terminal or in a notebook; a function is
        called with the number of frames done."""

    def check(
        self, size: tuple[int, int] | None = None, camera: Camera | str | ArrayLike | None = None, **settings: Any
    ) -> list[_Finding]:
        """The mesh defects that spoil shading, as `luxel check --json` lists them: winding, degenerate faces, gaps,
        normals and more. Empty for a sound mesh. The view, 1280x720 by default, decides on silhouettes."""

    def show(
        self, size: tuple[int, int] | None = None, camera: Camera | str | ArrayLike | None = None, **settings: Any
    ) -> Any:
        """A view, 640x480 by default, as a widget for notebooks: a `luxel_notebook.Widget`, which turns under the hand
        and explains its pixels. Needs `pip install "luxel[notebook]"`."""

    def _repr_png_(self) -> bytes | None: ...
    def __reduce__(self) -> tuple[Any, tuple[bytes, list[str]]]: ...

    def rays(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        mode: Literal["closest", "any", "all"] = "closest",
        *,
        threads: int = 0,
    ) -> Any:
        """Rays from `origins` (n, 3) along `directions` (n, 3), of any length but 0.

        `closest`: a dict of `t` (in lengths of the direction; infinite where nothing is hit), `object`, `triangle` (-1),
        `barycentric` (n, 3) and `position` (n, 3) (nan). `any`: an array of bool. `all`: the dict for all hits,
        by ray and then nearest first, with `ray`, the number of the ray."""

def load(
    source: str | PathLike[str] | bytes | _Readable | _TrimeshGeometry | _TrimeshScene,
    *,
    format: Literal["glb", "gltf", "obj", "stl", "ply", "toml"] | None = None,
    max_memory: int | None = None,
) -> Scene:
    """Reads a model: a path, the bytes of a file, or an object with `read`. `demo:NAME` is a built-in scene; an object of
    trimesh is taken as by `Scene.from_trimesh`.

    Raises `LoadError` with the place in the file, or `OSError`."""

def demos() -> list[str]:
    """The names of the built-in scenes."""
