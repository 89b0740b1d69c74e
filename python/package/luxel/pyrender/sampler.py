"""How textures are read between texels and beyond their edges."""

from .constants import GLTF


class Sampler:
    """Filters and wrapping, by the codes of `GLTF`; None stands for the smooth ones."""

    def __init__(
        self,
        name: str | None = None,
        magFilter: int | None = None,
        minFilter: int | None = None,
        wrapS: int = GLTF.REPEAT,
        wrapT: int = GLTF.REPEAT,
    ) -> None:
        self.name = None if name is None else str(name)
        self.magFilter = magFilter
        self.minFilter = minFilter
        self.wrapS = wrapS
        self.wrapT = wrapT

    @property
    def codes(self) -> tuple[int, int, int, int]:
        """Wrapping of u and v, filters of larger and smaller pictures."""
        larger = self.magFilter or GLTF.LINEAR
        return self.wrapS, self.wrapT, larger, self.minFilter or GLTF.LINEAR_MIPMAP_LINEAR
