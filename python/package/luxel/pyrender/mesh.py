"""Meshes: primitives that are placed together."""

import copy
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .box import Boxed
from .constants import GLTF
from .formats import is_list
from .material import Material, MetallicRoughnessMaterial
from .primitive import Primitive


class Mesh(Boxed):
    """A list of primitives with a name. `weights` of morph targets are kept, but as in pyrender without effect."""

    def __init__(
        self, primitives: Sequence[Primitive], name: str | None = None, weights: Any = None, is_visible: bool = True
    ) -> None:
        self.primitives = primitives
        self.name = name
        self.weights = weights
        self.is_visible = is_visible

    @property
    def name(self) -> str | None:
        return self._name

    @name.setter
    def name(self, value: Any) -> None:
        self._name = None if value is None else str(value)

    @property
    def bounds(self) -> NDArray[np.float64]:
        if not self.primitives:
            return np.array([[np.inf] * 3, [-np.inf] * 3])
        boxes = np.array([primitive.bounds for primitive in self.primitives])
        return np.array([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])

    @property
    def is_transparent(self) -> bool:
        return any(primitive.is_transparent for primitive in self.primitives)

    @staticmethod
    def from_points(
        points: Any, colors: Any = None, normals: Any = None, is_visible: bool = True, poses: Any = None
    ) -> "Mesh":
        """A cloud of points (n, 3), with colours (n, 3) or (n, 4), bytes or floats."""
        cloud = Primitive(positions=points, normals=normals, color_0=colors, mode=GLTF.POINTS, poses=poses)
        return Mesh([cloud], is_visible=is_visible)

    @staticmethod
    def from_trimesh(
        mesh: Any,
        material: Material | None = None,
        is_visible: bool = True,
        poses: Any = None,
        wireframe: bool = False,
        smooth: bool = True,
    ) -> "Mesh":
        """A mesh of a trimesh.Trimesh, of a list of them or of a trimesh.Scene, a primitive each. `material` replaces theirs; without
        `smooth`, faces are flat, and may have a colour each."""
        meshes: list[Any] = list(mesh) if is_list(mesh) or hasattr(mesh, "isdisjoint") else [mesh]
        if hasattr(mesh, "geometry") and hasattr(mesh, "graph"):
            # What trimesh.load gives for many files: a trimesh.Scene.
            meshes = [each for each in mesh.dump() if hasattr(each, "faces")]
        primitives: list[Primitive] = []
        for each in meshes:
            if not (hasattr(each, "vertices") and hasattr(each, "faces") and hasattr(each, "visual")):
                raise TypeError(f"expected a trimesh.Trimesh or a list of them, not {type(each)}")
            primitives.append(_primitive(each, material, poses, wireframe, smooth))
        return Mesh(primitives, is_visible=is_visible)


def _primitive(mesh: Any, material: Material | None, poses: Any, wireframe: bool, smooth: bool) -> Primitive:
    faces: NDArray[Any] = np.asarray(mesh.faces)

    def corners(values: Any) -> Any:
        """A row for each vertex: of smooth meshes as they are, of flat ones a vertex for each corner."""
        return values if smooth else np.asarray(values)[faces].reshape(-1, np.asarray(values).shape[1])

    colors, uv, own = _looks(mesh, smooth, material is None)
    used = copy.copy(material) if material is not None else own
    used.wireframe = bool(wireframe)
    return Primitive(
        positions=corners(mesh.vertices),
        normals=mesh.vertex_normals if smooth else np.repeat(mesh.face_normals, 3, axis=0),
        texcoord_0=None if uv is None else corners(uv),
        color_0=colors,
        indices=faces if smooth else None,
        material=used,
        mode=GLTF.TRIANGLES,
        poses=poses,
    )


def _plain(color: float) -> MetallicRoughnessMaterial:
    factor = [color, color, color, 1.0]
    return MetallicRoughnessMaterial(
        alphaMode="BLEND", baseColorFactor=factor, metallicFactor=0.2, roughnessFactor=0.8
    )


def _looks(mesh: Any, smooth: bool, with_own: bool) -> tuple[Any, Any, Material]:
    """Colours of vertices, or of the corners of flat faces; texture coordinates; the material of its own."""
    visual = mesh.visual
    if not visual.defined:
        return None, None, _plain(0.3)
    if visual.kind == "texture":
        uv = visual.uv if visual.uv is not None and len(visual.uv) else None
        return None, uv, _material(visual.material) if with_own else _plain(0.3)
    if not with_own:
        return None, None, _plain(0.3)
    if visual.kind == "vertex":
        colors: NDArray[Any] = np.asarray(visual.vertex_colors)
        return (colors if smooth else colors[np.asarray(mesh.faces)].reshape(-1, 4)), None, _plain(1.0)
    if smooth:
        raise ValueError("a smooth mesh has no colours of faces: use smooth=False")
    return np.repeat(np.asarray(visual.face_colors), 3, axis=0), None, _plain(1.0)


def _material(material: Any) -> Material:
    """The material of trimesh's PBRMaterial or SimpleMaterial."""
    if isinstance(material, Material):
        return copy.copy(material)
    if hasattr(material, "baseColorFactor"):
        return MetallicRoughnessMaterial(
            normalTexture=material.normalTexture,
            occlusionTexture=material.occlusionTexture,
            emissiveTexture=material.emissiveTexture,
            emissiveFactor=material.emissiveFactor,
            alphaMode="BLEND",
            alphaCutoff=material.alphaCutoff,
            doubleSided=bool(material.doubleSided),
            baseColorFactor=material.baseColorFactor,
            baseColorTexture=material.baseColorTexture,
            metallicFactor=material.metallicFactor,
            roughnessFactor=material.roughnessFactor,
            metallicRoughnessTexture=material.metallicRoughnessTexture,
        )
    if hasattr(material, "diffuse"):
        written: dict[str, Any] = getattr(material, "kwargs", None) or {}
        shine: Any = written.get("Ns", written.get("ns", 1.0))
        exponent = float(np.asarray(shine, np.float64).reshape(-1)[0])
        return MetallicRoughnessMaterial(
            alphaMode="BLEND",
            roughnessFactor=float((2.0 / (exponent + 2.0)) ** 0.25),
            baseColorFactor=material.diffuse,
            baseColorTexture=material.image,
        )
    return _plain(0.3)
