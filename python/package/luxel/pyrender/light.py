"""Lights as glTF has them: intensities in candela and lux, directions along -z of their nodes."""

from abc import ABC, abstractmethod
from math import pi
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .camera import Camera, OrthographicCamera, PerspectiveCamera
from .constants import SHADOW_TEX_SZ
from .formats import color_vector
from .texture import Texture

_FLOAT = 5126


class Light(ABC):
    """A light of a linear colour and an intensity."""

    def __init__(self, color: Any = None, intensity: float | None = None, name: str | None = None) -> None:
        self.name = name
        self.color = np.ones(3) if color is None else color
        self.intensity = 1.0 if intensity is None else intensity
        self.shadow_texture: Texture | None = None

    @property
    def name(self) -> str | None:
        return self._name

    @name.setter
    def name(self, value: Any) -> None:
        self._name = None if value is None else str(value)

    @property
    def color(self) -> NDArray[np.float32]:
        """(3,): linear red, green, blue."""
        return self._color

    @color.setter
    def color(self, value: Any) -> None:
        self._color = color_vector(value, 3)

    @property
    def intensity(self) -> float:
        """In candela, of directional lights in lux."""
        return self._intensity

    @intensity.setter
    def intensity(self, value: float) -> None:
        self._intensity = float(value)

    def _generate_shadow_texture(self, size: int | None = None) -> None:
        """A texture like the one that pyrender draws shadows into; luxel's come from rays and need none."""
        side = size or SHADOW_TEX_SZ
        self.shadow_texture = Texture(width=side, height=side, source_channels="D", data_format=_FLOAT)

    @abstractmethod
    def _get_shadow_camera(self, scene_scale: float) -> Camera:
        """The camera that sees what the light reaches."""

    @abstractmethod
    def description(self, pose: NDArray[np.float64]) -> str:
        """The light in the world, as luxel's `lights` take it.

        A white matt surface that faces a light of 1 reflects 1 in luxel, and 1 / pi in pyrender.
        """

    def _common(self) -> str:
        scale = self._intensity / pi
        red, green, blue = self._color.tolist()
        return f"diffuse={red * scale!r},{green * scale!r},{blue * scale!r}"


def _triple(vector: NDArray[np.float64]) -> str:
    x, y, z = vector.tolist()
    return f"{x!r},{y!r},{z!r}"


class DirectionalLight(Light):
    """Parallel light along -z of its node."""

    def _get_shadow_camera(self, scene_scale: float) -> Camera:
        near, far = 0.01 * scene_scale, 10 * scene_scale
        return OrthographicCamera(xmag=scene_scale, ymag=scene_scale, znear=near, zfar=far)

    def description(self, pose: NDArray[np.float64]) -> str:
        return f"directional:dir={_triple(-pose[:3, 2])}:{self._common()}"


class _Placed(Light):
    """A light in a place, whose light falls off by the square of the distance. `range` is kept, but as in pyrender without effect."""

    def __init__(
        self, color: Any = None, intensity: float | None = None, range: float | None = None, name: str | None = None
    ) -> None:
        super().__init__(color=color, intensity=intensity, name=name)
        self.range = range

    @property
    def range(self) -> float | None:
        return self._range

    @range.setter
    def range(self, value: float | None) -> None:
        if value is not None:
            value = float(value)
            if value <= 0:
                raise ValueError("a light's range is above 0")
        self._range = value


class PointLight(_Placed):
    """Light in all directions."""

    def _generate_shadow_texture(self, size: int | None = None) -> None:
        raise NotImplementedError("a point light has no single shadow texture")

    def _get_shadow_camera(self, scene_scale: float) -> Camera:
        raise NotImplementedError("a point light shines in all directions, which no camera sees")

    def description(self, pose: NDArray[np.float64]) -> str:
        return f"point:pos={_triple(pose[:3, 3])}:attenuation=0,0,1:{self._common()}"


class SpotLight(_Placed):
    """A cone along -z of its node: full within the inner angle, nothing beyond the outer one, in radians from its axis."""

    def __init__(
        self,
        color: Any = None,
        intensity: float | None = None,
        range: float | None = None,
        innerConeAngle: float = 0.0,
        outerConeAngle: float = pi / 4.0,
        name: str | None = None,
    ) -> None:
        super().__init__(color=color, intensity=intensity, range=range, name=name)
        self.outerConeAngle = outerConeAngle
        self.innerConeAngle = innerConeAngle

    @property
    def innerConeAngle(self) -> float:
        return self._inner

    @innerConeAngle.setter
    def innerConeAngle(self, value: float) -> None:
        if not 0.0 <= value <= self._outer:
            raise ValueError("the inner angle of a cone lies between 0 and the outer one")
        self._inner = float(value)

    @property
    def outerConeAngle(self) -> float:
        return self._outer

    @outerConeAngle.setter
    def outerConeAngle(self, value: float) -> None:
        if not 0.0 <= value <= pi / 2.0 + 1e-9:
            raise ValueError("the outer angle of a cone lies between 0 and pi / 2")
        self._outer = float(value)

    def _get_shadow_camera(self, scene_scale: float) -> Camera:
        near, far = 0.01 * scene_scale, 10 * scene_scale
        angle = min(2 * self._outer + pi / 16.0, pi)
        return PerspectiveCamera(yfov=angle, znear=near, zfar=far, aspectRatio=1.0)

    def description(self, pose: NDArray[np.float64]) -> str:
        outer = min(float(np.degrees(self._outer)), 90.0)
        inner = min(float(np.degrees(self._inner)), outer)
        cone = f"cutoff={outer!r}:inner={inner!r}"
        where = f"pos={_triple(pose[:3, 3])}:dir={_triple(-pose[:3, 2])}"
        return f"spot:{where}:{cone}:attenuation=0,0,1:{self._common()}"


__all__ = ["DirectionalLight", "Light", "PointLight", "SpotLight"]
