"""Cameras, which look along -z of their nodes with y up."""

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .constants import DEFAULT_Z_FAR, DEFAULT_Z_NEAR


def _positive(value: Any, what: str) -> float:
    number = float(value)
    if number <= 0.0:
        raise ValueError(f"{what} must be above 0")
    return number


class Camera(ABC):
    """A projection with its clipping planes. Subclasses may bring a matrix of their own, as OpenGL has them."""

    # Whether the near plane may lie in the eye, and the far one be left out.
    _may_touch = True
    _may_be_endless = False

    def __init__(
        self, znear: float = DEFAULT_Z_NEAR, zfar: float | None = DEFAULT_Z_FAR, name: str | None = None
    ) -> None:
        self.name = name
        self.znear = znear
        self.zfar = zfar

    @property
    def name(self) -> str | None:
        return self._name

    @name.setter
    def name(self, value: Any) -> None:
        self._name = None if value is None else str(value)

    @property
    def znear(self) -> float:
        """The distance of the near plane."""
        return self._znear

    @znear.setter
    def znear(self, value: float) -> None:
        near = float(value)
        if near < 0 or (near == 0 and not self._may_touch):
            raise ValueError("znear must be above 0")
        self._znear = near

    @property
    def zfar(self) -> float | None:
        """The distance of the far plane."""
        return self._zfar

    @zfar.setter
    def zfar(self, value: float | None) -> None:
        if value is None and self._may_be_endless:
            self._zfar: float | None = None
            return
        far = _positive(value, "zfar")
        if far <= self._znear:
            raise ValueError("zfar must be beyond znear")
        self._zfar = far

    @abstractmethod
    def get_projection_matrix(self, width: Any = None, height: Any = None) -> NDArray[np.float64]:
        """OpenGL's projection matrix for a picture of this size."""

    def _perspective(self, columns: list[tuple[float, float]]) -> NDArray[np.float64]:
        """A perspective of scales and offsets of x and y."""
        near, far = self._znear, self._zfar
        matrix = np.zeros((4, 4))
        (matrix[0, 0], matrix[0, 2]), (matrix[1, 1], matrix[1, 2]) = columns
        matrix[3, 2] = -1.0
        if far is None:
            matrix[2, 2:] = -1.0, -2.0 * near
        else:
            matrix[2, 2:] = (far + near) / (near - far), 2.0 * far * near / (near - far)
        return matrix


class PerspectiveCamera(Camera):
    """A perspective of a vertical angle of view in radians, endless by default."""

    _may_be_endless = True

    def __init__(
        self,
        yfov: float,
        znear: float = DEFAULT_Z_NEAR,
        zfar: float | None = None,
        aspectRatio: float | None = None,
        name: str | None = None,
    ) -> None:
        super().__init__(znear=znear, zfar=zfar, name=name)
        self.yfov = yfov
        self.aspectRatio = aspectRatio

    @property
    def yfov(self) -> float:
        return self._yfov

    @yfov.setter
    def yfov(self, value: float) -> None:
        self._yfov = _positive(value, "yfov")

    @property
    def aspectRatio(self) -> float | None:
        """Width over height; None for the picture's."""
        return self._aspect

    @aspectRatio.setter
    def aspectRatio(self, value: float | None) -> None:
        self._aspect = None if value is None else _positive(value, "aspectRatio")

    def get_projection_matrix(self, width: Any = None, height: Any = None) -> NDArray[np.float64]:
        aspect = self._aspect
        if aspect is None:
            if width is None or height is None:
                raise ValueError("a camera without aspectRatio needs the size of the picture")
            aspect = float(width) / float(height)
        scale = 1.0 / float(np.tan(self._yfov / 2.0))
        return self._perspective([(scale / aspect, 0.0), (scale, 0.0)])


class OrthographicCamera(Camera):
    """Parallel rays: `ymag` is half the height of what is seen. The picture's size decides on the width."""

    _may_touch = False

    def __init__(
        self,
        xmag: float,
        ymag: float,
        znear: float = DEFAULT_Z_NEAR,
        zfar: float = DEFAULT_Z_FAR,
        name: str | None = None,
    ) -> None:
        super().__init__(znear=znear, zfar=zfar, name=name)
        self.xmag = xmag
        self.ymag = ymag

    @property
    def xmag(self) -> float:
        return self._xmag

    @xmag.setter
    def xmag(self, value: float) -> None:
        self._xmag = _positive(value, "xmag")

    @property
    def ymag(self) -> float:
        return self._ymag

    @ymag.setter
    def ymag(self, value: float) -> None:
        self._ymag = _positive(value, "ymag")

    def get_projection_matrix(self, width: Any = None, height: Any = None) -> NDArray[np.float64]:
        across = self._xmag
        if width is not None and height is not None:
            across = width / height * self._ymag
        near, far = self._znear, self._zfar or DEFAULT_Z_FAR
        matrix = np.diag([1.0 / across, 1.0 / self._ymag, 2.0 / (near - far), 1.0])
        matrix[2, 3] = (far + near) / (near - far)
        return matrix


class IntrinsicsCamera(Camera):
    """A calibrated camera: focal lengths and principal point in pixels, y downwards."""

    _may_be_endless = True

    def __init__(
        self,
        fx: float,
        fy: float,
        cx: float,
        cy: float,
        znear: float = DEFAULT_Z_NEAR,
        zfar: float = DEFAULT_Z_FAR,
        name: str | None = None,
    ) -> None:
        super().__init__(znear=znear, zfar=zfar, name=name)
        self.fx = float(fx)
        self.fy = float(fy)
        self.cx = float(cx)
        self.cy = float(cy)

    def get_projection_matrix(self, width: Any = None, height: Any = None) -> NDArray[np.float64]:
        if width is None or height is None:
            raise ValueError("a calibrated camera needs the size of the picture")
        across, down = 2.0 / float(width), 2.0 / float(height)
        return self._perspective(
            [(across * self.fx, 1.0 - across * self.cx), (down * self.fy, down * self.cy - 1.0)]
        )


__all__ = ["Camera", "IntrinsicsCamera", "OrthographicCamera", "PerspectiveCamera"]
