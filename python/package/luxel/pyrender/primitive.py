"""Triangles, lines or points with one material."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .box import Boxed
from .constants import GLTF, BufFlags
from .formats import color_rows
from .material import Material, MetallicRoughnessMaterial


def _floats(value: Any) -> NDArray[np.float32]:
    return np.ascontiguousarray(value, dtype=np.float32)


class Primitive(Boxed):
    """Vertices with their attributes, a row each, how `indices` connect them (`mode`, of `GLTF`), and a material.

    `poses` (n, 4, 4) shows it n times. Joints, weights and targets are kept, but as in pyrender without effect.
    """

    def __init__(
        self,
        positions: Any,
        normals: Any = None,
        tangents: Any = None,
        texcoord_0: Any = None,
        texcoord_1: Any = None,
        color_0: Any = None,
        joints_0: Any = None,
        weights_0: Any = None,
        indices: Any = None,
        material: Material | None = None,
        mode: int | None = None,
        targets: Any = None,
        poses: Any = None,
    ) -> None:
        self.version = 0
        self.mode = GLTF.TRIANGLES if mode is None else mode
        self.positions = positions
        self.normals = normals
        self.tangents = tangents
        self.texcoord_0 = texcoord_0
        self.texcoord_1 = texcoord_1
        self.color_0 = color_0
        self.joints_0 = joints_0
        self.weights_0 = weights_0
        self.indices = indices
        self.material = material
        self.targets = targets
        self.poses = poses

    @property
    def positions(self) -> NDArray[np.float32]:
        """(n, 3)"""
        return self._positions

    @positions.setter
    def positions(self, value: Any) -> None:
        self._positions = _floats(value)
        self._box: NDArray[np.float64] | None = None
        self.version += 1

    def _rows(self, value: Any, what: str, width: int) -> NDArray[np.float32] | None:
        """A row for each vertex."""
        self.version += 1
        if value is None:
            return None
        rows = _floats(value)
        if rows.shape != (len(self._positions), width):
            expected = (len(self._positions), width)
            raise ValueError(f"{what}: expected shape {expected}, not {rows.shape}")
        return rows

    @property
    def normals(self) -> NDArray[np.float32] | None:
        """(n, 3): unit normals; computed where they are missing."""
        return self._normals

    @normals.setter
    def normals(self, value: Any) -> None:
        self._normals = self._rows(value, "normals", 3)

    @property
    def tangents(self) -> NDArray[np.float32] | None:
        """(n, 4): kept; luxel finds tangents itself."""
        return self._tangents

    @tangents.setter
    def tangents(self, value: Any) -> None:
        self._tangents = self._rows(value, "tangents", 4)

    @property
    def texcoord_0(self) -> NDArray[np.float32] | None:
        """(n, 2): (0, 0) at the texture's lower left."""
        return self._texcoord_0

    @texcoord_0.setter
    def texcoord_0(self, value: Any) -> None:
        if value is not None:
            value = np.asanyarray(value)
            if value.ndim == 2 and value.shape[1] > 2:
                value = value[:, :2]
        self._texcoord_0 = self._rows(value, "texcoord_0", 2)

    @property
    def texcoord_1(self) -> NDArray[np.float32] | None:
        """(n, 2): kept, but as in pyrender without effect."""
        return self._texcoord_1

    @texcoord_1.setter
    def texcoord_1(self, value: Any) -> None:
        self._texcoord_1 = self._rows(value, "texcoord_1", 2)

    @property
    def color_0(self) -> NDArray[np.float32] | None:
        """(n, 4): linear, with alpha."""
        return self._color_0

    @color_0.setter
    def color_0(self, value: Any) -> None:
        self._color_0 = None if value is None else color_rows(value, len(self._positions))
        self._is_transparent: bool | None = None
        self.version += 1

    @property
    def indices(self) -> NDArray[Any] | None:
        """(m, 3) of triangles; of other modes, as many as they take."""
        return self._indices

    @indices.setter
    def indices(self, value: Any) -> None:
        if value is not None:
            value = np.asanyarray(value)
            if not np.issubdtype(value.dtype, np.integer):
                value = value.astype(np.int64)
        self._indices: NDArray[Any] | None = value
        self.version += 1

    @property
    def material(self) -> Material:
        return self._material

    @material.setter
    def material(self, value: Any) -> None:
        if value is None:
            value = MetallicRoughnessMaterial()
        if not isinstance(value, Material):
            raise TypeError(f"a material is a Material, not {type(value)}")
        self._material = value

    @property
    def mode(self) -> int:
        return self._mode

    @mode.setter
    def mode(self, value: int) -> None:
        mode = int(value)
        if not GLTF.POINTS <= mode <= GLTF.TRIANGLE_FAN:
            raise ValueError(f"{mode} is no mode of primitives: use 0 to 6")
        self._mode = mode
        self.version += 1

    @property
    def poses(self) -> NDArray[np.float32] | None:
        """(n, 4, 4): where it is shown, in its node."""
        return self._poses

    @poses.setter
    def poses(self, value: Any) -> None:
        if value is not None:
            value = _floats(value)
            if value.ndim == 2:
                value = value[np.newaxis]
            if value.ndim != 3 or value.shape[1:] != (4, 4):
                raise ValueError(f"poses: expected shape (n, 4, 4), not {value.shape}")
        self._poses: NDArray[np.float32] | None = value
        self._box = None

    @property
    def bounds(self) -> NDArray[np.float64]:
        if self._box is None:
            vertices = self._positions.reshape(-1, 3)
            if len(vertices) == 0:
                vertices = np.zeros((1, 3), np.float32)
            box = np.array([vertices.min(axis=0), vertices.max(axis=0)], np.float64)
            if self._poses is not None:
                # As in pyrender, by the places of instances alone.
                places = self._poses[:, :3, 3]
                box += np.array([places.min(axis=0), places.max(axis=0)])
            self._box = box
        return self._box

    @property
    def buf_flags(self) -> int:
        """The attributes that there are, by `BufFlags`."""
        attributes = (
            (self._normals, BufFlags.NORMAL),
            (self._tangents, BufFlags.TANGENT),
            (self._texcoord_0, BufFlags.TEXCOORD_0),
            (self._texcoord_1, BufFlags.TEXCOORD_1),
            (self._color_0, BufFlags.COLOR_0),
            (self.joints_0, BufFlags.JOINTS_0),
            (self.weights_0, BufFlags.WEIGHTS_0),
        )
        return sum(flag for values, flag in attributes if values is not None)

    @property
    def has_transparent_colors(self) -> bool:
        """Whether a vertex has an alpha below 1."""
        if self._is_transparent is None:
            colors = self._color_0
            self._is_transparent = colors is not None and bool((colors[:, 3] != 1.0).any())
        return self._is_transparent

    @property
    def is_transparent(self) -> bool:
        return self._material.is_transparent or self.has_transparent_colors

    def delete(self) -> None:
        """Nothing is held outside of this object."""
