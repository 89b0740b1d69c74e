"""Nodes: places in a scene, with what stands there."""

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .camera import Camera
from .light import Light
from .mesh import Mesh

_LAST_ROW = [0.0, 0.0, 0.0, 1.0]


class Node:
    """A mesh, a light or a camera in a place, which is a 4x4 `matrix` or translation, rotation (quaternion x, y, z, w) and
    scale; its children move with it."""

    def __init__(
        self,
        name: str | None = None,
        camera: Camera | None = None,
        children: "list[Node] | None" = None,
        skin: int | None = None,
        matrix: Any = None,
        mesh: Mesh | None = None,
        rotation: Any = None,
        scale: Any = None,
        translation: Any = None,
        weights: Any = None,
        light: Light | None = None,
    ) -> None:
        # Either the matrix or its parts may be out of date; they are made anew when they are asked for.
        self._matrix: NDArray[Any] | None = None
        self._parts: tuple[NDArray[Any], NDArray[Any], NDArray[Any]] | None = None
        if matrix is not None:
            self.matrix = matrix
        else:
            self._parts = np.zeros(3), np.array([0.0, 0.0, 0.0, 1.0]), np.ones(3)
            if translation is not None:
                self.translation = translation
            if rotation is not None:
                self.rotation = rotation
            if scale is not None:
                self.scale = scale
        self.name = name
        self.camera = camera
        self.children: list[Node] = [] if children is None else children
        self.skin = skin
        self.mesh = mesh
        self.weights = weights
        self.light = light

    @property
    def name(self) -> str | None:
        return self._name

    @name.setter
    def name(self, value: Any) -> None:
        self._name = None if value is None else str(value)

    @property
    def camera(self) -> Camera | None:
        return self._camera

    @camera.setter
    def camera(self, value: Any) -> None:
        if value is not None and not isinstance(value, Camera):
            raise TypeError(f"a node's camera is a Camera, not {type(value)}")
        self._camera = value

    @property
    def mesh(self) -> Mesh | None:
        return self._mesh

    @mesh.setter
    def mesh(self, value: Any) -> None:
        if value is not None and not isinstance(value, Mesh):
            raise TypeError(f"a node's mesh is a Mesh, not {type(value)}")
        self._mesh = value

    @property
    def light(self) -> Light | None:
        return self._light

    @light.setter
    def light(self, value: Any) -> None:
        if value is not None and not isinstance(value, Light):
            raise TypeError(f"a node's light is a Light, not {type(value)}")
        self._light = value

    def _split(self) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
        """Translation, rotation and scale."""
        if self._parts is None:
            matrix = self.pose()
            scale = np.linalg.norm(matrix[:3, :3], axis=0)
            turn = matrix[:3, :3] / np.where(scale > 0.0, scale, 1.0)
            self._parts = matrix[:3, 3].copy(), _quaternion(turn), scale
        return self._parts

    @property
    def translation(self) -> NDArray[Any]:
        """(3,)"""
        return self._split()[0]

    @translation.setter
    def translation(self, value: Any) -> None:
        _, rotation, scale = self._split()
        self._parts, self._matrix = (_shaped(value, "translation", 3), rotation, scale), None

    @property
    def rotation(self) -> NDArray[Any]:
        """(4,): a unit quaternion x, y, z, w."""
        return self._split()[1]

    @rotation.setter
    def rotation(self, value: Any) -> None:
        quaternion = _shaped(value, "rotation", 4)
        if abs(float(np.linalg.norm(quaternion)) - 1.0) > 1e-3:
            raise ValueError("rotation: expected a quaternion of length 1")
        translation, _, scale = self._split()
        self._parts, self._matrix = (translation, quaternion, scale), None

    @property
    def scale(self) -> NDArray[Any]:
        """(3,): along x, y and z."""
        return self._split()[2]

    @scale.setter
    def scale(self, value: Any) -> None:
        translation, rotation, _ = self._split()
        self._parts, self._matrix = (translation, rotation, _shaped(value, "scale", 3)), None

    @property
    def matrix(self) -> NDArray[Any]:
        """(4, 4): a copy of the pose in the parent."""
        return np.array(self.pose())

    @matrix.setter
    def matrix(self, value: Any) -> None:
        matrix: NDArray[Any] = np.asanyarray(value)
        if matrix.shape != (4, 4):
            raise ValueError(f"matrix: expected shape (4, 4), not {matrix.shape}")
        if matrix[3].tolist() != _LAST_ROW and not np.allclose(matrix[3], _LAST_ROW):
            raise ValueError("matrix: the last row must be 0, 0, 0, 1")
        self._matrix, self._parts = matrix, None

    def pose(self) -> NDArray[Any]:
        """(4, 4): the pose in the parent, not copied."""
        if self._matrix is None:
            translation, rotation, scale = self._split()
            matrix = np.eye(4)
            matrix[:3, :3] = _turn(rotation) * scale
            matrix[:3, 3] = translation
            self._matrix = matrix
        return self._matrix


def _shaped(value: Any, what: str, length: int) -> NDArray[Any]:
    vector: NDArray[Any] = np.asanyarray(value)
    if vector.shape != (length,):
        raise ValueError(f"{what}: expected {length} numbers, not shape {vector.shape}")
    return vector


def _turn(quaternion: Iterable[float]) -> NDArray[np.float64]:
    """The matrix of a rotation."""
    q = np.asarray(quaternion, np.float64)
    x, y, z, w = (q / np.linalg.norm(q)).tolist()
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def _quaternion(turn: NDArray[Any]) -> NDArray[np.float64]:
    """The quaternion of a rotation: the eigenvector of its greatest eigenvalue (Bar-Itzhack 2000), with w not below 0."""
    (a, b, c), (d, e, f), (g, h, i) = turn.tolist()
    lower = [
        [a - e - i, 0.0, 0.0, 0.0],
        [d + b, e - a - i, 0.0, 0.0],
        [g + c, h + f, i - a - e, 0.0],
        [h - f, c - g, d - b, a + e + i],
    ]
    _, vectors = np.linalg.eigh(np.array(lower) / 3.0)
    quaternion = vectors[:, -1]
    return np.asarray(-quaternion if quaternion[3] < 0.0 else quaternion)
