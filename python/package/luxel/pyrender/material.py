"""Materials as glTF has them."""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .constants import TexFlags
from .formats import color_vector
from .texture import Texture

_ALPHA_MODES = ("OPAQUE", "MASK", "BLEND")


def texture_of(value: Any, channels: str) -> Texture | None:
    """A texture as it is, or one of an image."""
    if value is None or isinstance(value, Texture):
        return value
    return Texture(source=value, source_channels=channels)


def _fraction(value: float | None, what: str) -> float:
    number = 1.0 if value is None else float(value)
    if not 0.0 <= number <= 1.0:
        raise ValueError(f"{what} lies between 0 and 1")
    return number


def _switch(value: Any, what: str) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"{what} is True or False")
    return value


class Material(ABC):
    """What all materials have: normal, occlusion and emission, alpha, sides."""

    # The attributes that hold textures, and whether these are colours in sRGB.
    _texture_names: tuple[tuple[str, bool], ...] = (("normalTexture", False), ("occlusionTexture", False), ("emissiveTexture", True))

    def __init__(
        self,
        name: str | None = None,
        normalTexture: Any = None,
        occlusionTexture: Any = None,
        emissiveTexture: Any = None,
        emissiveFactor: Any = None,
        alphaMode: str | None = None,
        alphaCutoff: float | None = None,
        doubleSided: bool = False,
        smooth: bool = True,
        wireframe: bool = False,
    ) -> None:
        self.name = None if name is None else str(name)
        self.normalTexture = normalTexture
        self.occlusionTexture = occlusionTexture
        self.emissiveTexture = emissiveTexture
        self.emissiveFactor = emissiveFactor
        self.alphaMode = alphaMode or "OPAQUE"
        self.alphaCutoff = 0.5 if alphaCutoff is None else alphaCutoff
        self.doubleSided = doubleSided
        self.smooth = smooth
        self.wireframe = wireframe

    @property
    def normalTexture(self) -> Texture | None:
        """Normals in tangent space: red right, green up, blue out."""
        return self._normal_texture

    @normalTexture.setter
    def normalTexture(self, value: Any) -> None:
        self._normal_texture = texture_of(value, "RGB")

    @property
    def occlusionTexture(self) -> Texture | None:
        """Openness in red."""
        return self._occlusion_texture

    @occlusionTexture.setter
    def occlusionTexture(self, value: Any) -> None:
        self._occlusion_texture = texture_of(value, "R")

    @property
    def emissiveTexture(self) -> Texture | None:
        """Emitted light, which emissiveFactor multiplies."""
        return self._emissive_texture

    @emissiveTexture.setter
    def emissiveTexture(self, value: Any) -> None:
        self._emissive_texture = texture_of(value, "RGB")

    @property
    def emissiveFactor(self) -> NDArray[np.float32]:
        """(3,): linear; black by default."""
        return self._emissive_factor

    @emissiveFactor.setter
    def emissiveFactor(self, value: Any) -> None:
        self._emissive_factor = np.zeros(3, np.float32) if value is None else color_vector(value, 3)

    @property
    def alphaMode(self) -> str:
        """OPAQUE, MASK or BLEND."""
        return self._alpha_mode

    @alphaMode.setter
    def alphaMode(self, value: str) -> None:
        if value not in _ALPHA_MODES:
            raise ValueError(f"`{value}` is no alpha mode: use {', '.join(_ALPHA_MODES)}")
        self._alpha_mode = value

    @property
    def alphaCutoff(self) -> float:
        """In mode MASK, alphas below it are holes."""
        return self._alpha_cutoff

    @alphaCutoff.setter
    def alphaCutoff(self, value: float) -> None:
        self._alpha_cutoff = _fraction(value, "alphaCutoff")

    @property
    def doubleSided(self) -> bool:
        """Whether faces are seen from behind."""
        return self._double_sided

    @doubleSided.setter
    def doubleSided(self, value: bool) -> None:
        self._double_sided = _switch(value, "doubleSided")

    @property
    def smooth(self) -> bool:
        return self._smooth

    @smooth.setter
    def smooth(self, value: bool) -> None:
        self._smooth = _switch(value, "smooth")

    @property
    def wireframe(self) -> bool:
        """Whether edges alone are drawn."""
        return self._wireframe

    @wireframe.setter
    def wireframe(self, value: bool) -> None:
        self._wireframe = _switch(value, "wireframe")

    @property
    def color(self) -> tuple[NDArray[np.float32], Texture | None]:
        """Base colour with alpha, and the texture that it multiplies."""
        return np.ones(4, np.float32), None

    @property
    def is_transparent(self) -> bool:
        """Whether something is seen through it."""
        if self._alpha_mode == "OPAQUE":
            return False
        cutoff = 1.0 if self._alpha_mode == "BLEND" else self._alpha_cutoff
        factor, texture = self.color
        return float(factor[3]) < cutoff or (texture is not None and texture.is_transparent(cutoff))

    def named_textures(self) -> Iterator[tuple[str, bool, Texture]]:
        """Its textures by the names of their attributes; whether they are colours in sRGB."""
        for name, is_color in self._texture_names:
            texture = getattr(self, name)
            if texture is not None:
                yield name, is_color, texture

    @property
    def textures(self) -> set[Texture]:
        return {texture for _, _, texture in self.named_textures()}

    @property
    def tex_flags(self) -> int:
        """The textures that there are, by `TexFlags`."""
        codes = {
            "normalTexture": TexFlags.NORMAL,
            "occlusionTexture": TexFlags.OCCLUSION,
            "emissiveTexture": TexFlags.EMISSIVE,
            "baseColorTexture": TexFlags.BASE_COLOR,
            "metallicRoughnessTexture": TexFlags.METALLIC_ROUGHNESS,
            "diffuseTexture": TexFlags.DIFFUSE,
            "specularGlossinessTexture": TexFlags.SPECULAR_GLOSSINESS,
        }
        return sum(codes[name] for name, _, _ in self.named_textures())

    @abstractmethod
    def surface(self) -> tuple[float, float]:
        """Metalness and roughness."""


class MetallicRoughnessMaterial(Material):
    """A base colour, from dielectric to metal, from mirror to matt."""

    _texture_names = (
        *Material._texture_names,
        ("baseColorTexture", True),
        ("metallicRoughnessTexture", False),
    )

    def __init__(
        self,
        name: str | None = None,
        normalTexture: Any = None,
        occlusionTexture: Any = None,
        emissiveTexture: Any = None,
        emissiveFactor: Any = None,
        alphaMode: str | None = None,
        alphaCutoff: float | None = None,
        doubleSided: bool = False,
        smooth: bool = True,
        wireframe: bool = False,
        baseColorFactor: Any = None,
        baseColorTexture: Any = None,
        metallicFactor: float | None = 1.0,
        roughnessFactor: float | None = 1.0,
        metallicRoughnessTexture: Any = None,
    ) -> None:
        super().__init__(
            name=name,
            normalTexture=normalTexture,
            occlusionTexture=occlusionTexture,
            emissiveTexture=emissiveTexture,
            emissiveFactor=emissiveFactor,
            alphaMode=alphaMode,
            alphaCutoff=alphaCutoff,
            doubleSided=doubleSided,
            smooth=smooth,
            wireframe=wireframe,
        )
        self.baseColorFactor = baseColorFactor
        self.baseColorTexture = baseColorTexture
        self.metallicFactor = metallicFactor
        self.roughnessFactor = roughnessFactor
        self.metallicRoughnessTexture = metallicRoughnessTexture

    @property
    def baseColorFactor(self) -> NDArray[np.float32]:
        """(4,): linear, with alpha."""
        return self._base_color_factor

    @baseColorFactor.setter
    def baseColorFactor(self, value: Any) -> None:
        self._base_color_factor = np.ones(4, np.float32) if value is None else color_vector(value, 4)

    @property
    def baseColorTexture(self) -> Texture | None:
        """sRGB, with alpha."""
        return self._base_color_texture

    @baseColorTexture.setter
    def baseColorTexture(self, value: Any) -> None:
        self._base_color_texture = texture_of(value, "RGBA")

    @property
    def metallicFactor(self) -> float:
        return self._metallic_factor

    @metallicFactor.setter
    def metallicFactor(self, value: float | None) -> None:
        self._metallic_factor = _fraction(value, "metallicFactor")

    @property
    def roughnessFactor(self) -> float:
        return self._roughness_factor

    @roughnessFactor.setter
    def roughnessFactor(self, value: float | None) -> None:
        self._roughness_factor = _fraction(value, "roughnessFactor")

    @property
    def metallicRoughnessTexture(self) -> Texture | None:
        """Roughness in green, metalness in blue."""
        return self._metallic_roughness_texture

    @metallicRoughnessTexture.setter
    def metallicRoughnessTexture(self, value: Any) -> None:
        self._metallic_roughness_texture = texture_of(value, "GB")

    @property
    def color(self) -> tuple[NDArray[np.float32], Texture | None]:
        return self._base_color_factor, self._base_color_texture

    def surface(self) -> tuple[float, float]:
        return self._metallic_factor, self._roughness_factor


class SpecularGlossinessMaterial(Material):
    """The older model of glTF. It is drawn by its diffuse colour and glossiness; pyrender draws it black."""

    _texture_names = (
        *Material._texture_names,
        ("diffuseTexture", True),
        ("specularGlossinessTexture", True),
    )

    def __init__(
        self,
        name: str | None = None,
        normalTexture: Any = None,
        occlusionTexture: Any = None,
        emissiveTexture: Any = None,
        emissiveFactor: Any = None,
        alphaMode: str | None = None,
        alphaCutoff: float | None = None,
        doubleSided: bool = False,
        smooth: bool = True,
        wireframe: bool = False,
        diffuseFactor: Any = None,
        diffuseTexture: Any = None,
        specularFactor: Any = None,
        glossinessFactor: float = 1.0,
        specularGlossinessTexture: Any = None,
    ) -> None:
        super().__init__(
            name=name,
            normalTexture=normalTexture,
            occlusionTexture=occlusionTexture,
            emissiveTexture=emissiveTexture,
            emissiveFactor=emissiveFactor,
            alphaMode=alphaMode,
            alphaCutoff=alphaCutoff,
            doubleSided=doubleSided,
            smooth=smooth,
            wireframe=wireframe,
        )
        self.diffuseFactor = diffuseFactor
        self.diffuseTexture = diffuseTexture
        self.specularFactor = specularFactor
        self.glossinessFactor = glossinessFactor
        self.specularGlossinessTexture = specularGlossinessTexture

    @property
    def diffuseFactor(self) -> NDArray[np.float32]:
        """(4,): linear, with alpha."""
        return self._diffuse_factor

    @diffuseFactor.setter
    def diffuseFactor(self, value: Any) -> None:
        self._diffuse_factor = np.ones(4, np.float32) if value is None else color_vector(value, 4)

    @property
    def diffuseTexture(self) -> Texture | None:
        """sRGB, with alpha."""
        return self._diffuse_texture

    @diffuseTexture.setter
    def diffuseTexture(self, value: Any) -> None:
        self._diffuse_texture = texture_of(value, "RGBA")

    @property
    def specularFactor(self) -> NDArray[np.float32]:
        """(3,): linear; without effect."""
        return self._specular_factor

    @specularFactor.setter
    def specularFactor(self, value: Any) -> None:
        self._specular_factor = np.ones(3, np.float32) if value is None else color_vector(value, 3)

    @property
    def glossinessFactor(self) -> float:
        return self._glossiness_factor

    @glossinessFactor.setter
    def glossinessFactor(self, value: float) -> None:
        self._glossiness_factor = _fraction(value, "glossinessFactor")

    @property
    def specularGlossinessTexture(self) -> Texture | None:
        """Without effect."""
        return self._specular_glossiness_texture

    @specularGlossinessTexture.setter
    def specularGlossinessTexture(self, value: Any) -> None:
        self._specular_glossiness_texture = texture_of(value, "RGBA")

    @property
    def color(self) -> tuple[NDArray[np.float32], Texture | None]:
        return self._diffuse_factor, self._diffuse_texture

    def surface(self) -> tuple[float, float]:
        return 0.0, 1.0 - self._glossiness_factor


__all__ = ["Material", "MetallicRoughnessMaterial", "SpecularGlossinessMaterial"]
