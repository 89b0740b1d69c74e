"""Scenes: trees of nodes."""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .box import Boxed
from .camera import Camera
from .formats import color_vector
from .light import DirectionalLight, Light, PointLight, SpotLight
from .mesh import Mesh
from .node import Node

Thing = Mesh | Light | Camera


class Scene(Boxed):
    """A tree of nodes before a background (`bg_color`, white), with an ambient light (`ambient_light`, none)."""

    def __init__(
        self,
        nodes: Iterable[Node] | None = None,
        bg_color: Any = None,
        ambient_light: Any = None,
        name: str | None = None,
    ) -> None:
        self.bg_color = bg_color
        self.ambient_light = ambient_light
        self.name = name
        # The parent of each node, in the order in which they came.
        self._parents: dict[Node, Node | None] = {}
        self._main_camera_node: Node | None = None
        parents: dict[Node, Node | None] = {node: None for node in nodes or ()}
        for node in list(parents):
            for child in node.children:
                if parents.get(child) is not None:
                    raise ValueError("a node has one parent at most")
                parents[child] = node
        for node, parent in parents.items():
            if parent is None:
                self.add_node(node)

    @property
    def name(self) -> str | None:
        return self._name

    @name.setter
    def name(self, value: Any) -> None:
        self._name = None if value is None else str(value)

    @property
    def bg_color(self) -> NDArray[np.float32]:
        """(4,): what the picture holds where nothing is, as it is, with alpha."""
        return self._bg_color

    @bg_color.setter
    def bg_color(self, value: Any) -> None:
        self._bg_color = np.ones(4, np.float32) if value is None else color_vector(value, 4)

    @property
    def ambient_light(self) -> NDArray[np.float32]:
        """(3,): linear; multiplies base colours."""
        return self._ambient_light

    @ambient_light.setter
    def ambient_light(self, value: Any) -> None:
        self._ambient_light = np.zeros(3, np.float32) if value is None else color_vector(value, 3)

    @property
    def nodes(self) -> set[Node]:
        return set(self._parents)

    def _where(self, is_one: Callable[[Node], bool]) -> set[Node]:
        return {node for node in self._parents if is_one(node)}

    @property
    def mesh_nodes(self) -> set[Node]:
        return self._where(lambda node: node.mesh is not None)

    @property
    def meshes(self) -> set[Mesh]:
        return {node.mesh for node in self._parents if node.mesh is not None}

    @property
    def light_nodes(self) -> set[Node]:
        return self._where(lambda node: node.light is not None)

    @property
    def lights(self) -> set[Light]:
        return {node.light for node in self._parents if node.light is not None}

    @property
    def point_light_nodes(self) -> set[Node]:
        return self._where(lambda node: isinstance(node.light, PointLight))

    @property
    def point_lights(self) -> set[PointLight]:
        return {light for light in self.lights if isinstance(light, PointLight)}

    @property
    def spot_light_nodes(self) -> set[Node]:
        return self._where(lambda node: isinstance(node.light, SpotLight))

    @property
    def spot_lights(self) -> set[SpotLight]:
        return {light for light in self.lights if isinstance(light, SpotLight)}

    @property
    def directional_light_nodes(self) -> set[Node]:
        return self._where(lambda node: isinstance(node.light, DirectionalLight))

    @property
    def directional_lights(self) -> set[DirectionalLight]:
        return {light for light in self.lights if isinstance(light, DirectionalLight)}

    @property
    def camera_nodes(self) -> set[Node]:
        return self._where(lambda node: node.camera is not None)

    @property
    def cameras(self) -> set[Camera]:
        return {node.camera for node in self._parents if node.camera is not None}

    @property
    def main_camera_node(self) -> Node | None:
        """The node of the camera that pictures are seen from: the first one, unless it is set."""
        return self._main_camera_node

    @main_camera_node.setter
    def main_camera_node(self, value: Node | None) -> None:
        if value is None or value not in self._parents:
            raise ValueError("the main camera's node must be in the scene")
        self._main_camera_node = value

    @property
    def bounds(self) -> NDArray[np.float64]:
        corners: list[NDArray[np.float64]] = []
        for node, pose in self.poses():
            if node.mesh is not None and node.mesh.primitives:
                low, high = node.mesh.bounds
                choices = np.array(np.meshgrid(*zip(low, high, strict=True))).reshape(3, 8)
                corners.append((pose[:3, :3] @ choices).T + pose[:3, 3])
        if not corners:
            return np.zeros((2, 3))
        every = np.concatenate(corners)
        return np.array([every.min(axis=0), every.max(axis=0)])

    def add(
        self,
        obj: Any,
        name: str | None = None,
        pose: Any = None,
        parent_node: Node | None = None,
        parent_name: str | None = None,
    ) -> Node:
        """Puts a mesh, a light or a camera into a new node, under a parent that is given or named."""
        if isinstance(obj, Mesh):
            node = Node(name=name, matrix=pose, mesh=obj)
        elif isinstance(obj, Light):
            node = Node(name=name, matrix=pose, light=obj)
        elif isinstance(obj, Camera):
            node = Node(name=name, matrix=pose, camera=obj)
        else:
            raise TypeError(f"a scene holds meshes, lights and cameras, not {type(obj)}")
        if parent_node is None and parent_name is not None:
            named = self.get_nodes(name=parent_name)
            if len(named) != 1:
                raise ValueError(f"there are {len(named)} nodes named `{parent_name}`, not one")
            (parent_node,) = named
        self.add_node(node, parent_node=parent_node)
        return node

    def get_nodes(
        self, node: Node | None = None, name: str | None = None, obj: Thing | None = None, obj_name: str | None = None
    ) -> set[Node]:
        """The nodes to which all that is given applies: being this one, a name, an object, an object's name."""
        if node is not None:
            return {node} if node in self._parents else set()

        def fits(node: Node) -> bool:
            things = [thing for thing in (node.mesh, node.camera, node.light) if thing is not None]
            return (
                (name is None or node.name == name)
                and (obj is None or any(thing is obj for thing in things))
                and (obj_name is None or any(thing.name == obj_name for thing in things))
            )

        return self._where(fits)

    def add_node(self, node: Node, parent_node: Node | None = None) -> None:
        """Adds a node with its children."""
        if node in self._parents:
            raise ValueError("the node is in the scene already")
        if parent_node is not None:
            if parent_node not in self._parents:
                raise ValueError("the parent isn't in the scene")
            if node not in parent_node.children:
                parent_node.children.append(node)
        self._parents[node] = parent_node
        if node.camera is not None and self._main_camera_node is None:
            self._main_camera_node = node
        for child in node.children:
            self.add_node(child, node)

    def has_node(self, node: Node) -> bool:
        return node in self._parents

    def remove_node(self, node: Node) -> None:
        """Takes a node with its children out."""
        parent = self._parents[node]
        self._take_out(node)
        if parent is not None and node in parent.children:
            parent.children.remove(node)

    def _take_out(self, node: Node) -> None:
        self._parents.pop(node, None)
        for child in node.children:
            self._take_out(child)
        if node is self._main_camera_node:
            left = (node for node in self._parents if node.camera is not None)
            self._main_camera_node = next(left, None)

    def clear(self) -> None:
        """Takes all nodes out."""
        self._parents = {}
        self._main_camera_node = None

    def get_pose(self, node: Node) -> NDArray[np.float64]:
        """(4, 4): the node's pose in the world."""
        if node not in self._parents:
            raise ValueError("the node isn't in the scene")
        pose: NDArray[np.float64] = np.array(node.pose(), np.float64)
        parent = self._parents[node]
        while parent is not None:
            pose = parent.pose() @ pose
            parent = self._parents[parent]
        return pose

    def set_pose(self, node: Node, pose: Any) -> None:
        """Moves a node: (4, 4), its pose in its parent."""
        if node not in self._parents:
            raise ValueError("the node isn't in the scene")
        node.matrix = pose

    def poses(self) -> list[tuple[Node, NDArray[Any]]]:
        """All nodes with their poses in the world, parents first."""
        found: dict[Node, NDArray[Any]] = {}
        for node, parent in self._parents.items():
            # A parent is added before its children.
            found[node] = node.pose() if parent is None else found[parent] @ node.pose()
        return list(found.items())

    @staticmethod
    def from_trimesh_scene(trimesh_scene: Any, bg_color: Any = None, ambient_light: Any = None) -> "Scene":
        """A scene of a trimesh.Scene: its meshes and clouds of points, those that are shown several times once."""
        scene = Scene(bg_color=bg_color, ambient_light=ambient_light)
        meshes: dict[str, Mesh] = {}
        for key, geometry in trimesh_scene.geometry.items():
            if hasattr(geometry, "faces"):
                meshes[key] = Mesh.from_trimesh(geometry)
            elif hasattr(geometry, "colors") and not hasattr(geometry, "entities"):
                colors = geometry.colors if len(geometry.colors) == len(geometry.vertices) else None
                meshes[key] = Mesh.from_points(geometry.vertices, colors=colors)
        for name in trimesh_scene.graph.nodes_geometry:
            pose, key = trimesh_scene.graph[name]
            if key in meshes:
                scene.add(meshes[key], name=str(name), pose=pose)
        return scene
