"""Images on surfaces."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .formats import texture_source
from .sampler import Sampler

# OpenGL's codes, which are kept but not used.
_TEXTURE_2D = 3553
_UNSIGNED_BYTE = 5121


class Texture:
    """An image and its sampler.

    `source` is an array of bytes or floats, (h, w) or (h, w, c), or a PIL image; `source_channels` the ones that are taken
    of it: R, RG, GB, RGB or RGBA, the last by default.
    """

    def __init__(
        self,
        name: str | None = None,
        sampler: Sampler | None = None,
        source: Any = None,
        source_channels: str | None = None,
        width: int | None = None,
        height: int | None = None,
        tex_type: int = _TEXTURE_2D,
        data_format: int = _UNSIGNED_BYTE,
    ) -> None:
        self.name = None if name is None else str(name)
        self.source_channels = source_channels
        self.sampler = sampler if sampler is not None else Sampler()
        self.version = 0
        self.source = source
        self.width = width
        self.height = height
        self.tex_type = tex_type
        self.data_format = data_format

    @property
    def source(self) -> NDArray[np.uint8] | None:
        """The bytes of the image."""
        return self._source

    @source.setter
    def source(self, value: Any) -> None:
        self._source = None if value is None else texture_source(value, self.source_channels or "RGBA")
        self.version += 1

    def is_transparent(self, cutoff: float = 1.0) -> bool:
        """Whether an alpha lies below the cutoff."""
        source = self._source
        if source is None or source.ndim < 3 or source.shape[2] < 4:
            return False
        return bool((source[:, :, 3] < cutoff * 255.0).any())

    def delete(self) -> None:
        """Nothing is held outside of this object."""

    def texels(self) -> NDArray[np.uint8] | None:
        """The bytes, each channel where glTF has it: (h, w, 3) or (h, w, 4)."""
        source = self._source
        if source is None:
            return None
        if source.ndim == 3 and source.shape[2] >= 3:
            return source
        first = 1 if self.source_channels == "GB" else 0
        planes = source[:, :, np.newaxis] if source.ndim == 2 else source
        texels = np.full((*planes.shape[:2], 3), 255, np.uint8)
        texels[:, :, first : first + planes.shape[2]] = planes
        return texels
