"""The meshes and materials of a scene as luxel has them, and when they are to be made anew."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from luxel._luxel import Stage, build_scene

from .constants import GLTF
from .material import Material
from .primitive import Primitive

_SOLID = (GLTF.TRIANGLES, GLTF.TRIANGLE_STRIP, GLTF.TRIANGLE_FAN)
_KEYS = {
    "normalTexture": "normal_texture",
    "occlusionTexture": "occlusion_texture",
    "emissiveTexture": "emissive_texture",
    "baseColorTexture": "base_color_texture",
    "diffuseTexture": "base_color_texture",
    "metallicRoughnessTexture": "metallic_roughness_texture",
}


def is_solid(primitive: Primitive) -> bool:
    """Whether it has faces."""
    return primitive.mode in _SOLID


def state_of(primitive: Primitive) -> tuple[Any, ...]:
    """What changes whenever the primitive or its material look otherwise."""
    material = primitive.material
    textures = tuple(
        (name, id(texture), texture.version, texture.sampler.codes) for name, _, texture in material.named_textures()
    )
    return (
        id(primitive),
        primitive.version,
        material.color[0].tobytes(),
        material.emissiveFactor.tobytes(),
        material.surface(),
        material.alphaMode,
        material.alphaCutoff,
        material.doubleSided,
        textures,
    )


class Model:
    """Primitives, ready to be drawn in any place. `wires` are drawn as lines; `flat` ones without light."""

    def __init__(self, primitives: Sequence[Primitive], wires: Sequence[bool], flat: bool, threads: int) -> None:
        # Their ids are in the key by which the model is found again: they must live as long.
        self.primitives = list(primitives)
        self._textures: list[tuple[NDArray[np.uint8], bool, tuple[int, int, int, int]]] = []
        self._places: dict[tuple[int, bool], int] = {}
        self._flat = flat
        materials = [self._material(primitive) for primitive in primitives]
        self._kept = [primitive.material.textures for primitive in primitives]
        meshes = [_mesh(primitive, number, wired) for number, (primitive, wired) in enumerate(zip(primitives, wires, strict=True))]
        scene = build_scene(meshes, materials, self._textures, [("", None, None, at) for at in range(len(meshes))])
        self.stage = Stage(scene, threads)
        self._placed: tuple[list[int], bytes] | None = None

    def place(self, which: list[int], poses: NDArray[np.float64]) -> None:
        """Shows primitives, by their places, at poses (n, 4, 4)."""
        key = which, poses.tobytes()
        if key != self._placed:
            self.stage.place(which, poses)
            self._placed = key

    def _texture(self, name: str, is_color: bool, material: Material) -> int | None:
        texture = getattr(material, name)
        texels = texture.texels()
        if texels is None:
            return None
        # Flat pictures show the bytes of textures as they are.
        is_srgb = is_color and not self._flat
        place = self._places.setdefault((id(texture), is_srgb), len(self._textures))
        if place == len(self._textures):
            self._textures.append((texels, is_srgb, texture.sampler.codes))
        return place

    def _material(self, primitive: Primitive) -> dict[str, Any]:
        material = primitive.material
        has_uv = primitive.texcoord_0 is not None
        metallic, roughness = material.surface()
        fields: dict[str, Any] = {
            "name": material.name or "",
            "base_color": material.color[0],
            "metallic": metallic,
            "roughness": roughness,
            "double_sided": material.doubleSided,
            "alpha_mode": material.alphaMode,
            "alpha_cutoff": material.alphaCutoff,
            "unlit": self._flat,
        }
        if material.alphaMode == "BLEND" and not primitive.is_transparent:
            # The same picture, in less time.
            fields["alpha_mode"] = "OPAQUE"
        if not self._flat:
            fields["emissive"] = material.emissiveFactor
        for name, is_color, _ in material.named_textures():
            if has_uv and name in _KEYS and (not self._flat or _KEYS[name] == "base_color_texture"):
                fields[_KEYS[name]] = self._texture(name, is_color, material)
        return fields


def _mesh(primitive: Primitive, number: int, wired: bool) -> dict[str, Any]:
    """The arrays of a primitive."""
    positions = primitive.positions
    indices = primitive.indices
    mode = primitive.mode
    flat: NDArray[Any] = np.arange(len(positions)) if indices is None else np.asarray(indices).reshape(-1)
    mesh: dict[str, Any] = {"place": f"primitive {number}: ", "vertices": positions, "material": number}
    if mode == GLTF.POINTS:
        mesh["mode"] = "points"
        mesh["colors"] = primitive.color_0
        if indices is not None:
            inside = flat[(flat >= 0) & (flat < len(positions))]
            mesh["vertices"] = positions[inside]
            mesh["colors"] = None if primitive.color_0 is None else primitive.color_0[inside]
        return mesh
    mesh["colors"] = primitive.color_0
    if is_solid(primitive):
        faces = _triangles(mode, flat)
        if not wired:
            mesh.update(mode="triangles", faces=faces, normals=primitive.normals, uv=primitive.texcoord_0)
            return mesh
        ends = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        mesh.update(mode="lines", faces=np.unique(ends, axis=0))
        return mesh
    mesh.update(mode="lines", faces=_segments(mode, flat))
    return mesh


def _triangles(mode: int, corners: NDArray[Any]) -> NDArray[Any]:
    """(n, 3): the corners of triangles, of strips and fans in the order that keeps their sides."""
    if mode == GLTF.TRIANGLES:
        return corners[: len(corners) // 3 * 3].reshape(-1, 3)
    a, b, c = corners[:-2], corners[1:-1], corners[2:]
    if mode == GLTF.TRIANGLE_FAN:
        return np.stack([b, c, np.broadcast_to(corners[:1], b.shape)], axis=1)
    is_odd = np.arange(len(a)) % 2 == 1
    return np.stack([a, np.where(is_odd, c, b), np.where(is_odd, b, c)], axis=1)


def _segments(mode: int, ends: NDArray[Any]) -> NDArray[Any]:
    """(n, 2): the ends of lines, of strips and loops one after the other."""
    if mode == GLTF.LINES:
        return ends[: len(ends) // 2 * 2].reshape(-1, 2)
    segments = np.stack([ends[:-1], ends[1:]], axis=1)
    if mode == GLTF.LINE_LOOP and len(ends) > 2:
        segments = np.concatenate([segments, [[ends[-1], ends[0]]]])
    return segments
