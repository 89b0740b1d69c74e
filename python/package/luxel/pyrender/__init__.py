"""Scenes as pyrender has them, drawn off screen by luxel: `import luxel.pyrender as pyrender`.

The names, arguments and poses are those of pyrender 0.1.45. No OpenGL, display or driver is needed, and no other package than
NumPy; trimesh is used where its objects are passed in.
"""

from .camera import Camera, IntrinsicsCamera, OrthographicCamera, PerspectiveCamera
from .constants import GLTF, RenderFlags, TextAlign
from .light import DirectionalLight, Light, PointLight, SpotLight
from .material import Material, MetallicRoughnessMaterial, SpecularGlossinessMaterial
from .mesh import Mesh
from .node import Node
from .offscreen import OffscreenRenderer
from .primitive import Primitive
from .sampler import Sampler
from .scene import Scene
from .texture import Texture
from .version import __version__
from .viewer import Viewer

__all__ = [
    "GLTF",
    "Camera",
    "DirectionalLight",
    "IntrinsicsCamera",
    "Light",
    "Material",
    "Mesh",
    "MetallicRoughnessMaterial",
    "Node",
    "OffscreenRenderer",
    "OrthographicCamera",
    "PerspectiveCamera",
    "PointLight",
    "Primitive",
    "RenderFlags",
    "Sampler",
    "Scene",
    "SpecularGlossinessMaterial",
    "SpotLight",
    "TextAlign",
    "Texture",
    "Viewer",
    "__version__",
]
