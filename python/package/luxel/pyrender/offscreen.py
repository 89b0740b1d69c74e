"""Pictures of scenes."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _once
from ._lens import native_camera
from ._model import Model, is_solid, state_of
from .constants import RenderFlags
from .formats import is_list
from .light import DirectionalLight, Light, PointLight, SpotLight
from .node import Node
from .primitive import Primitive
from .scene import Scene

# Models that are kept ready, the one used last at the end.
_KEPT = 4
# Pictures of up to so many pixels are drawn by one thread.
_SMALL = 256 * 256
_SHADOWS: tuple[tuple[type[Light], int], ...] = (
    (DirectionalLight, RenderFlags.SHADOWS_DIRECTIONAL),
    (PointLight, RenderFlags.SHADOWS_POINT),
    (SpotLight, RenderFlags.SHADOWS_SPOT),
)


class OffscreenRenderer:
    """Draws scenes into arrays.

    `threads` is not pyrender's: 0 stands for one a core; by default, small pictures take one thread, large ones all.
    """

    def __init__(
        self, viewport_width: int, viewport_height: int, point_size: float = 1.0, *, threads: int | None = None
    ) -> None:
        self.viewport_width = viewport_width
        self.viewport_height = viewport_height
        self.point_size = point_size
        self.threads = threads
        self._models: dict[Any, Model] = {}

    @property
    def viewport_width(self) -> int:
        return self._width

    @viewport_width.setter
    def viewport_width(self, value: int) -> None:
        self._width = int(value)

    @property
    def viewport_height(self) -> int:
        return self._height

    @viewport_height.setter
    def viewport_height(self, value: int) -> None:
        self._height = int(value)

    @property
    def point_size(self) -> float:
        """The side of points, in pixels."""
        return self._point_size

    @point_size.setter
    def point_size(self, value: float) -> None:
        self._point_size = float(value)

    def delete(self) -> None:
        """Lets go of the models that are kept ready. The renderer can be used again."""
        self._models.clear()

    # What comes back depends on the flags, which the types don't tell.
    def render(self, scene: Scene, flags: int = RenderFlags.NONE, seg_node_map: Mapping[Node, Any] | None = None) -> Any:
        """Draws the scene from its main camera: (picture, depths), or depths alone with DEPTH_ONLY.

        The picture is (h, w, 3) or, with RGBA, (h, w, 4) uint8; depths are (h, w) float32, distances along the viewing
        axis, 0 where nothing is. With SEG, the picture holds the colours of `seg_node_map`, and nodes that it lacks aren't
        drawn.
        """
        main = scene.main_camera_node
        camera = None if main is None else main.camera
        if main is None or camera is None:
            raise ValueError("a scene without a camera can't be drawn: add one")
        by_node = flags & RenderFlags.SEG != 0
        lit = not (by_node or flags & (RenderFlags.DEPTH_ONLY | RenderFlags.FLAT))
        colors: Mapping[Node, Any] = (seg_node_map or {}) if by_node else {}
        if flags & (RenderFlags.VERTEX_NORMALS | RenderFlags.FACE_NORMALS):
            _once.warn("luxel.pyrender draws no arrows for normals: VERTEX_NORMALS and FACE_NORMALS are passed over")

        primitives: dict[Primitive, int] = {}
        which: list[int] = []
        poses: list[NDArray[Any]] = []
        palette: list[tuple[int, int, int]] = []
        lights: list[str] = []
        shadows = False
        eye: NDArray[Any] = np.eye(4)
        for node, pose in scene.poses():
            if node is main:
                eye = pose
            light = node.light
            if lit and light is not None:
                lights.append(light.description(pose))
                shadows |= any(isinstance(light, kind) and flags & flag for kind, flag in _SHADOWS)
            mesh = node.mesh
            if mesh is None or not mesh.is_visible:
                continue
            is_left_out = by_node and node not in colors
            for primitive in mesh.primitives:
                # Those that aren't drawn are part of the model, which serves the next pictures, too.
                at = primitives.setdefault(primitive, len(primitives))
                if is_left_out:
                    continue
                placed = [pose] if primitive.poses is None else [pose @ one for one in primitive.poses]
                which.extend([at] * len(placed))
                poses.extend(placed)
                if by_node:
                    palette.extend([_bytes_of(colors[node])] * len(placed))

        model, is_wired = self._model(primitives, flags)
        model.place(which, np.array(poses, np.float64).reshape(-1, 4, 4))
        native, factor, offset = native_camera(camera, eye, self._width, self._height)
        settings: dict[str, Any] = {
            "point_size": self._point_size,
            "environment": "none",
            "lights": lights,
            "wireframe": is_wired,
            "shadows": shadows,
            **_surroundings(scene, flags),
        }
        depth_only = flags & RenderFlags.DEPTH_ONLY != 0
        if depth_only or by_node:
            settings["cull"] = "back"
        elif flags & RenderFlags.SKIP_CULL_FACES:
            settings["cull"] = "none"
        channels = 0 if depth_only else 4 if flags & RenderFlags.RGBA else 3
        size = self._width, self._height
        picture, depth = model.stage.draw(
            size, native, channels, palette if by_node and not depth_only else None, **settings
        )
        if (factor, offset) != (1.0, 0.0):
            depth = np.where(depth > 0, depth * np.float32(factor) + np.float32(offset), np.float32(0))
        return depth if depth_only else (picture, depth)

    def _model(self, primitives: dict[Primitive, int], flags: int) -> tuple[Model, bool]:
        """The model of primitives, and whether it is drawn as wires."""
        wires = [is_solid(primitive) and _is_wired(primitive, flags) for primitive in primitives]
        solid = [wired for primitive, wired in zip(primitives, wires, strict=True) if is_solid(primitive)]
        all_wired = bool(solid) and all(solid)
        if all_wired:
            wires = [False] * len(wires)
        threads = self.threads
        if threads is None:
            threads = 1 if self._width * self._height <= _SMALL else 0
        flat = flags & RenderFlags.FLAT != 0 and not flags & RenderFlags.SEG
        key = threads, flat, tuple(wires), tuple(map(state_of, primitives))
        model = self._models.pop(key, None)
        if model is None:
            model = Model(list(primitives), wires, flat, threads)
            while len(self._models) >= _KEPT:
                del self._models[next(iter(self._models))]
        self._models[key] = model
        return model, all_wired


def _is_wired(primitive: Primitive, flags: int) -> bool:
    """Whether edges alone are drawn. Neither depths nor masks have wires in pyrender."""
    if flags & (RenderFlags.DEPTH_ONLY | RenderFlags.SEG | RenderFlags.ALL_SOLID):
        return False
    if flags & RenderFlags.ALL_WIREFRAME:
        return True
    return primitive.material.wireframe != bool(flags & RenderFlags.FLIP_WIREFRAME)


def _bytes_of(color: Any) -> tuple[int, int, int]:
    """The bytes of a colour in the map: one number, or three."""
    if is_list(color):
        red, green, blue = (min(max(int(channel), 0), 255) for channel in list(color)[:3])
        return red, green, blue
    grey = min(max(int(color), 0), 255)
    return grey, grey, grey


def _surroundings(scene: Scene, flags: int) -> dict[str, str]:
    """Background and ambient light."""
    red, green, blue, alpha = (min(max(channel, 0.0), 1.0) for channel in scene.bg_color.tolist())
    if not flags & RenderFlags.RGBA:
        alpha = 1.0
    if flags & RenderFlags.FLAT:
        # Base colours are shown as they are, and so is the background.
        return {"background": f"{red!r},{green!r},{blue!r},{alpha!r}", "encoding": "none", "ambient": "0,0,0"}
    digits = "".join(f"{round(channel * 255):02x}" for channel in (red, green, blue, alpha))
    ambient = ",".join(map(repr, scene.ambient_light.tolist()))
    return {"background": f"#{digits}", "ambient": ambient}
