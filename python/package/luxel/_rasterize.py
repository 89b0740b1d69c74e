"""Rasterization of projected triangles, as differentiable renderers have it."""

import importlib
import sys
from typing import Any

import numpy as np

from ._luxel import rasterize_clip


def rasterize(vertices_clip: Any, faces: Any, size: tuple[int, int], *, threads: int = 0) -> Any:
    """The triangle that each pixel's centre sees, for vertices that are projected already.

    `vertices_clip` (n, 4) or (b, n, 4): clip coordinates x, y, z, w as OpenGL has them, seen within -w..w; `faces` (m, 3):
    whole numbers; `size`: (width, height), up to 16384. `threads` as for views.

    Returns float32 (h, w, 4) or (b, h, w, 4), packed as nvdiffrast's `rasterize` does: the perspective-correct barycentrics
    u and v of the triangle's first and second corner (the third's is 1 - u - v), z/w, and the triangle's number
    plus 1; all 0 where nothing is seen. Rows begin at the bottom, y = -1, as nvdiffrast's do: `[::-1]` has the first row
    at the top. Both sides of triangles are seen; of equally near ones the first.

    NumPy arrays give NumPy arrays; torch tensors on the CPU give tensors, by DLPack, without gradients.

    Raises `ValueError` for arrays of another shape, numbers that are not finite, and indices out of range."""
    is_torch = _is_torch(vertices_clip)
    vertices = _array(vertices_clip)
    indices = _array(faces)
    batch = vertices.ndim == 3
    pictures = [rasterize_clip(each, indices, size, threads) for each in (vertices if batch else [vertices])]
    if batch:
        result = np.stack(pictures) if pictures else np.zeros((0, size[1], size[0], 4), np.float32)
    else:
        result = pictures[0]
    return importlib.import_module("torch").from_dlpack(result) if is_torch else result


def _is_torch(value: Any) -> bool:
    torch = sys.modules.get("torch")
    return torch is not None and isinstance(value, torch.Tensor)


def _array(value: Any) -> Any:
    """An array that shares a tensor's memory; anything else as NumPy takes it."""
    return np.from_dlpack(value.detach()) if _is_torch(value) else np.asanyarray(value)
