"""Rays for trimesh: a drop-in for its `RayMeshIntersector` over embreex.

    mesh = trimesh.load("model.stl")
    mesh.ray = luxel.trimesh.RayMeshIntersector(mesh)
    mesh.ray.intersects_location(origins, directions)

Rays are followed in 64-bit floats, so that coordinates need no scaling and rays no offsets; edges have no gaps.
"""

from __future__ import annotations

import importlib
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._luxel import Scene

__all__ = ["RayMeshIntersector"]

_SAME_PLACE = 1e-9
"""Two hits of a ray that are closer than this, in parts of the mesh's diagonal, are one: where it meets an edge that
triangles share."""


class RayMeshIntersector:
    """Rays through a mesh with `vertices` and `faces`, as `trimesh.Trimesh` has them.

    Rays have `ray_origins` (n, 3) and `ray_directions` (n, 3) of any length but 0. What changes in the mesh is seen by the
    next query."""

    def __init__(self, geometry: Any, scale_to_box: bool = True) -> None:
        """`scale_to_box` has no effect: 64-bit floats need no scaling."""
        self.mesh = geometry
        self._scale_to_box = scale_to_box
        self._known: tuple[object, Scene, float] | None = None

    def intersects_location(
        self, ray_origins: ArrayLike, ray_directions: ArrayLike, multiple_hits: bool = True
    ) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64]]:
        """Where rays meet the mesh: places (m, 3), and of each the ray and the triangle.

        `multiple_hits`: all places of a ray, nearest first; else only the first."""
        triangles, rays, places = self.intersects_id(ray_origins, ray_directions, multiple_hits, return_locations=True)
        return places, rays, triangles

    @overload
    def intersects_id(
        self,
        ray_origins: ArrayLike,
        ray_directions: ArrayLike,
        multiple_hits: bool = ...,
        max_hits: int = ...,
        return_locations: Literal[False] = ...,
    ) -> tuple[NDArray[np.int64], NDArray[np.int64]]: ...

    @overload
    def intersects_id(
        self,
        ray_origins: ArrayLike,
        ray_directions: ArrayLike,
        multiple_hits: bool = ...,
        max_hits: int = ...,
        *,
        return_locations: Literal[True],
    ) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float64]]: ...

    def intersects_id(
        self,
        ray_origins: ArrayLike,
        ray_directions: ArrayLike,
        multiple_hits: bool = True,
        max_hits: int = 100,
        return_locations: bool = False,
    ) -> Any:
        """The triangles that rays meet, and of each the ray; with `return_locations` the places (m, 3), too.

        At most `max_hits` of a ray, its nearest."""
        origins, directions = _rays(ray_origins, ray_directions)
        scene, size = self._scene()
        if multiple_hits:
            found = scene.rays(origins, directions, "all")
            rays, kept = found["ray"], _distinct(found["ray"], found["t"], size * _SAME_PLACE, max_hits)
        else:
            found = scene.rays(origins, directions)
            rays, kept = np.arange(len(origins)), found["triangle"] >= 0
        result = found["triangle"][kept], rays[kept]
        return (*result, found["position"][kept]) if return_locations else result

    def intersects_first(self, ray_origins: ArrayLike, ray_directions: ArrayLike) -> NDArray[np.int64]:
        """The triangle that each ray meets first, (n,); -1 for none."""
        origins, directions = _rays(ray_origins, ray_directions)
        first: NDArray[np.int64] = self._scene()[0].rays(origins, directions)["triangle"]
        return first

    def intersects_any(self, ray_origins: ArrayLike, ray_directions: ArrayLike) -> NDArray[np.bool_]:
        """Whether each ray meets the mesh, (n,)."""
        origins, directions = _rays(ray_origins, ray_directions)
        met: NDArray[np.bool_] = self._scene()[0].rays(origins, directions, "any")
        return met

    def contains_points(self, points: ArrayLike) -> NDArray[np.bool_]:
        """Whether each of `points` (n, 3) lies inside of the mesh, by trimesh's own test, which counts hits."""
        ray_util: Any = importlib.import_module("trimesh.ray.ray_util")
        inside: NDArray[np.bool_] = ray_util.contains_points(self, points)
        return inside

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_known": None}

    def __copy__(self) -> RayMeshIntersector:
        return RayMeshIntersector(self.mesh, self._scale_to_box)

    def __deepcopy__(self, memory: Any) -> RayMeshIntersector:
        # As trimesh's own: the mesh whose copy has this copy sets itself.
        return self.__copy__()

    def _scene(self) -> tuple[Scene, float]:
        """The mesh as luxel has it, made anew where it has changed, and its diagonal in float64's units of directions of
        length 1."""
        state = hash(self.mesh)
        if self._known is None or self._known[0] != state:
            scene = Scene.from_arrays(self.mesh.vertices, self.mesh.faces)
            size = float(np.linalg.norm(np.ptp(scene.bounds, axis=0))) if len(self.mesh.faces) else 0.0
            self._known = state, scene, size
        return self._known[1:]


def _rays(origins: ArrayLike, directions: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Rays whose directions have length 1, so that distances along them are those in the mesh's units.

    Raises `ValueError` if there isn't one direction for each origin."""
    origins = np.asanyarray(origins, dtype=np.float64).reshape(-1, 3)
    directions = np.asanyarray(directions, dtype=np.float64).reshape(-1, 3)
    if origins.shape != directions.shape:
        raise ValueError(f"{len(directions)} ray_directions for {len(origins)} ray_origins")
    lengths = np.linalg.norm(directions, axis=1, keepdims=True)
    return origins, directions / np.where(lengths > 0, lengths, 1)


def _distinct(rays: NDArray[np.int64], t: NDArray[np.float64], closest: float, most: int) -> NDArray[np.bool_]:
    """Which hits count: of those of a ray at one place the first, and of a ray the nearest `most`."""
    kept = np.ones(len(rays), dtype=bool)
    kept[1:] = (np.diff(rays) != 0) | (np.diff(t) > closest)
    # How many of its ray's come before each hit that counts.
    count = np.cumsum(kept)
    begins = np.searchsorted(rays, rays)
    kept &= count - count[begins] < most
    return kept
