"""Colours and images in the forms in which pyrender takes them."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

_CHANNELS = {"R": 1, "RG": 2, "GB": 2, "RGB": 3, "RGBA": 4}


def is_list(value: Any) -> bool:
    """Whether it is a list, a tuple or an array."""
    return isinstance(value, (list, tuple, np.ndarray))


def color_vector(value: Any, length: int) -> NDArray[np.float32]:
    """A colour of `length` channels, missing ones 1: a number for all, or a list or array; whole numbers are bytes.

    A single int counts in 255ths, too.
    """
    if isinstance(value, int):
        value = value / 255.0
    if isinstance(value, float):
        value = [value] * length
    if not is_list(value):
        raise ValueError("a color is a number, a list or an array")
    color: NDArray[Any] = np.asarray(value).squeeze()
    if color.ndim != 1:
        raise ValueError("a color has one dimension")
    if np.issubdtype(color.dtype, np.integer):
        color = color / 255.0
    full = np.ones(length, np.float32)
    count = min(length, len(color))
    full[:count] = color[:count]
    return full


def color_rows(value: Any, count: int) -> NDArray[np.float32]:
    """Colours of `count` vertices with alpha, (count, 4): one for all, or a row each; whole numbers are bytes."""
    colors: NDArray[Any] = np.asanyarray(value)
    full = 255.0 if np.issubdtype(colors.dtype, np.integer) else 1.0
    rows = np.ones((count, 4), np.float32)
    width = min(4, colors.shape[-1])
    rows[:, :width] = colors[..., :width]
    rows[:, :width] /= full
    return rows


def texture_source(source: Any, channels: str = "RGB") -> NDArray[np.uint8]:
    """Bytes of an image, (h, w, c), or (h, w) for one channel: an array of bytes or of floats up to 1, or a PIL image."""
    if channels not in _CHANNELS:
        raise ValueError(f"`{channels}` are no channels of a texture: use {', '.join(_CHANNELS)}")
    if hasattr(source, "convert") and hasattr(source, "mode"):
        if channels in ("RGB", "RGBA") and source.mode not in ("L", "RGB", "RGBA"):
            source = source.convert(channels)
        source = np.asarray(source)
    if not hasattr(source, "dtype"):
        raise TypeError(f"a texture is an array or a PIL image, not {type(source)}")
    texels: NDArray[Any] = source
    is_bits = texels.dtype == np.bool_
    if np.issubdtype(texels.dtype, np.floating):
        texels = texels * 255.0
    elif not (np.issubdtype(texels.dtype, np.integer) or is_bits):
        raise TypeError(f"a texture holds numbers, not {texels.dtype}")
    texels = texels.astype(np.uint8) * (255 if is_bits else 1)
    if texels.ndim == 2:
        texels = texels[:, :, np.newaxis]
    found = texels.shape[2]
    if channels == "R":
        return texels[:, :, 0]
    if channels in ("RGB", "RGBA") and found == 2:
        raise ValueError(f"a texture of 2 channels has no {channels}")
    if channels == "GB" and found > 2:
        return texels[:, :, 1:3]
    wanted = _CHANNELS[channels]
    if found == 1:
        texels = np.repeat(texels, min(wanted, 3), axis=2)
    if texels.shape[2] < wanted:
        opaque = np.full((*texels.shape[:2], 1), 255, np.uint8)
        texels = np.concatenate([texels, opaque], axis=2)
    return texels[:, :, :wanted]
