"""Numbers that users of pyrender write: flags of pictures, codes of glTF, limits."""

DEFAULT_Z_NEAR = 0.05
DEFAULT_Z_FAR = 100.0
DEFAULT_SCENE_SCALE = 2.0
SHADOW_TEX_SZ = 2048
# Of pyrender's shaders; luxel takes any number of lights.
MAX_N_LIGHTS = 4
TARGET_OPEN_GL_MAJOR = 4
TARGET_OPEN_GL_MINOR = 1
MIN_OPEN_GL_MAJOR = 3
MIN_OPEN_GL_MINOR = 3
FLOAT_SZ = 4
UINT_SZ = 4
TEXT_PADDING = 20


class RenderFlags:
    """How a picture is drawn: combine with `|`."""

    NONE = 0
    DEPTH_ONLY = 1
    """No picture, depths alone."""
    OFFSCREEN = 2
    """Always so."""
    FLIP_WIREFRAME = 4
    """Meshes of wires are solid, solid ones wires."""
    ALL_WIREFRAME = 8
    ALL_SOLID = 16
    SHADOWS_DIRECTIONAL = 32
    SHADOWS_POINT = 64
    SHADOWS_SPOT = 128
    SHADOWS_ALL = SHADOWS_DIRECTIONAL | SHADOWS_POINT | SHADOWS_SPOT
    VERTEX_NORMALS = 256
    """Not drawn: warns once."""
    FACE_NORMALS = 512
    """Not drawn: warns once."""
    SKIP_CULL_FACES = 1024
    """Draws the back of faces, too."""
    RGBA = 2048
    """A picture with alpha: 4 channels."""
    FLAT = 4096
    """Base colours without light."""
    SEG = 8192
    """The colours of `seg_node_map`."""


class TextAlign:
    """The place of captions, for viewers."""

    CENTER = 0
    CENTER_LEFT = 1
    CENTER_RIGHT = 2
    BOTTOM_LEFT = 3
    BOTTOM_RIGHT = 4
    BOTTOM_CENTER = 5
    TOP_LEFT = 6
    TOP_RIGHT = 7
    TOP_CENTER = 8


class GLTF:
    """Codes of glTF: filters, wrapping, modes of primitives."""

    NEAREST = 9728
    LINEAR = 9729
    NEAREST_MIPMAP_NEAREST = 9984
    LINEAR_MIPMAP_NEAREST = 9985
    NEAREST_MIPMAP_LINEAR = 9986
    LINEAR_MIPMAP_LINEAR = 9987
    CLAMP_TO_EDGE = 33071
    MIRRORED_REPEAT = 33648
    REPEAT = 10497
    POINTS = 0
    LINES = 1
    LINE_LOOP = 2
    LINE_STRIP = 3
    TRIANGLES = 4
    TRIANGLE_STRIP = 5
    TRIANGLE_FAN = 6


class BufFlags:
    """The attributes of a primitive."""

    POSITION = 0
    NORMAL = 1
    TANGENT = 2
    TEXCOORD_0 = 4
    TEXCOORD_1 = 8
    COLOR_0 = 16
    JOINTS_0 = 32
    WEIGHTS_0 = 64


class TexFlags:
    """The textures of a material."""

    NONE = 0
    NORMAL = 1
    OCCLUSION = 2
    EMISSIVE = 4
    BASE_COLOR = 8
    METALLIC_ROUGHNESS = 16
    DIFFUSE = 32
    SPECULAR_GLOSSINESS = 64


class ProgramFlags:
    """The kinds of pyrender's shaders; unused."""

    NONE = 0
    USE_MATERIAL = 1
    VERTEX_NORMALS = 2
    FACE_NORMALS = 4


__all__ = ["GLTF", "RenderFlags", "TextAlign"]
