"""trimesh's meshes, clouds of points and scenes as luxel's. trimesh itself is not imported: whoever has its objects has it."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._luxel import Scene, build_scene

# Repeating, smooth, with smaller pictures: what glTF means by default.
_SAMPLER = (10497, 10497, 9729, 9987)
# trimesh's grey for materials without a colour.
_NO_COLOR = [102, 102, 102, 255]


def scene(source: Any, smooth: bool | None = None, up: Any = None) -> Scene:
    """The scene of an object of trimesh."""
    parts = _Parts(smooth)
    if hasattr(source, "geometry") and hasattr(source, "graph"):
        parts.add_scene(source)
    else:
        name = getattr(source, "metadata", {}).get("name") or "mesh"
        if not parts.add(source, str(name)):
            raise TypeError(f"source: expected a trimesh.Trimesh, PointCloud or Scene, not {type(source)}")
        parts.nodes.append((str(name), None, None, 0))
    return build_scene(parts.meshes, parts.materials, parts.textures, parts.nodes, up, parts.warnings)


class _Parts:
    """What a scene is built of."""

    def __init__(self, smooth: bool | None) -> None:
        self.smooth = smooth
        self.meshes: list[dict[str, Any]] = []
        self.materials: list[dict[str, Any]] = []
        self.textures: list[tuple[NDArray[np.uint8], bool, tuple[int, int, int, int]]] = []
        self.nodes: list[tuple[str, int | None, Any, int | None]] = []
        self.warnings: list[str] = []
        # By the objects' ids, which live as long as the source.
        self._material_places: dict[int, int] = {}
        self._texture_places: dict[tuple[int, bool], int] = {}

    def add_scene(self, source: Any) -> None:
        """The geometries of a scene, once each, and the nodes that show them, at their places in the world."""
        places: dict[Any, int] = {}
        for key, geometry in source.geometry.items():
            if self.add(geometry, str(key)):
                places[key] = len(self.meshes) - 1
            else:
                self.warnings.append(f"{key}: left out: luxel draws meshes and clouds of points, not {type(geometry).__name__}")
        for name in source.graph.nodes_geometry:
            pose, key = source.graph[name]
            if key in places:
                self.nodes.append((str(name), None, pose, places[key]))

    def add(self, geometry: Any, name: str) -> bool:
        """A mesh or a cloud of points; whether it is one."""
        mesh: dict[str, Any] = {"place": f"{name}: "}
        if hasattr(geometry, "faces") and hasattr(geometry, "visual"):
            self._triangles(geometry, mesh)
        elif hasattr(geometry, "vertices") and hasattr(geometry, "colors") and not hasattr(geometry, "entities"):
            mesh.update(mode="points", vertices=geometry.vertices)
            colors = geometry.colors
            if colors is not None and len(colors) == len(geometry.vertices):
                mesh["colors"] = colors
            mesh["material"] = self._plain("colors" in mesh)
        else:
            return False
        self.meshes.append(mesh)
        return True

    def _triangles(self, geometry: Any, mesh: dict[str, Any]) -> None:
        mesh.update(vertices=geometry.vertices, faces=geometry.faces)
        if self.smooth:
            mesh["normals"] = geometry.vertex_normals
        visual: Any = geometry.visual
        kind = visual.kind if visual.defined else None
        if kind == "vertex":
            mesh["colors"] = visual.vertex_colors
        elif kind == "face":
            mesh["face_colors"] = visual.face_colors
        if kind == "texture":
            uv = visual.uv
            if uv is not None and len(uv) == len(geometry.vertices):
                mesh["uv"] = uv
            mesh["material"] = self._material(visual.material, "uv" in mesh)
        else:
            mesh["material"] = self._plain(kind is not None)
        if self.smooth is False:
            _flatten(mesh)

    def _plain(self, is_colored: bool) -> int:
        """The material of meshes without one."""
        material: dict[str, Any] = {"name": "default", "double_sided": True}
        if is_colored:
            material["base_color"] = [1.0, 1.0, 1.0, 1.0]
        self.materials.append(material)
        return len(self.materials) - 1

    def _texture(self, image: Any, is_color: bool) -> int | None:
        if image is None:
            return None
        place = self._texture_places.setdefault((id(image), is_color), len(self.textures))
        if place == len(self.textures):
            has_alpha = getattr(image, "mode", "") in ("RGBA", "LA", "PA") or "transparency" in getattr(image, "info", {})
            texels = np.asarray(image.convert("RGBA" if has_alpha else "RGB"))
            self.textures.append((texels, is_color, _SAMPLER))
        return place

    def _material(self, source: Any, has_uv: bool) -> int:
        known = self._material_places.get(id(source))
        if known is not None:
            return known
        material: dict[str, Any] = {"name": str(getattr(source, "name", None) or "material")}
        is_physical = hasattr(source, "baseColorFactor")
        if is_physical:
            material.update(_physical(source))
            images = {
                "base_color_texture": source.baseColorTexture,
                "metallic_roughness_texture": source.metallicRoughnessTexture,
                "normal_texture": source.normalTexture,
                "occlusion_texture": source.occlusionTexture,
                "emissive_texture": source.emissiveTexture,
            }
        else:
            image = getattr(source, "image", None)
            images = {"base_color_texture": image}
            color = [int(channel) for channel in getattr(source, "diffuse", _NO_COLOR)]
            is_default = color == _NO_COLOR and image is not None
            material["base_color"] = [1.0] * 4 if is_default else [channel / 255.0 for channel in color]
            material["double_sided"] = True
            if material["base_color"][3] < 1.0:
                material["alpha_mode"] = "BLEND"
        for key, image in images.items():
            if has_uv:
                material[key] = self._texture(image, key in ("base_color_texture", "emissive_texture"))
        self.materials.append(material)
        self._material_places[id(source)] = len(self.materials) - 1
        return len(self.materials) - 1


def _physical(source: Any) -> dict[str, Any]:
    """The numbers of a PBRMaterial; what it leaves open is as in glTF."""
    factor = source.baseColorFactor
    color = [1.0] * 4 if factor is None else [int(channel) / 255.0 for channel in factor]
    emissive = source.emissiveFactor
    metallic, roughness = source.metallicFactor, source.roughnessFactor
    return {
        "base_color": color,
        "metallic": 1.0 if metallic is None else float(metallic),
        "roughness": 1.0 if roughness is None else float(roughness),
        "emissive": [0.0] * 3 if emissive is None else [float(channel) for channel in emissive],
        "alpha_mode": source.alphaMode or "OPAQUE",
        "alpha_cutoff": 0.5 if source.alphaCutoff is None else float(source.alphaCutoff),
        "double_sided": bool(source.doubleSided),
    }


def _flatten(mesh: dict[str, Any]) -> None:
    """Gives each face vertices of its own, with the normal of its plane."""
    faces: NDArray[Any] = np.asarray(mesh["faces"])
    corners = faces.reshape(-1)
    if corners.size and not 0 <= corners.min() <= corners.max() < len(mesh["vertices"]):
        # luxel says which.
        return
    for name in ("vertices", "colors", "uv"):
        if mesh.get(name) is not None:
            mesh[name] = np.asarray(mesh[name])[corners]
    mesh["faces"] = np.arange(len(corners)).reshape(-1, 3)
    a, b, c = (mesh["vertices"][first::3] for first in range(3))
    mesh["normals"] = np.repeat(np.cross(b - a, c - a), 3, axis=0)
