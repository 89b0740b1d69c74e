"""pyrender's projections as luxel's cameras."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from luxel import Camera as NativeCamera

from .camera import Camera

# The nearest near plane: pyrender allows one in the eye, where no depth is left.
_NEAREST = 1e-6


def native_camera(
    camera: Camera, pose: NDArray[np.float64], width: int, height: int
) -> tuple[NativeCamera, float, float]:
    """The camera, and how distances along its axis become pyrender's: times a factor, plus an offset."""
    matrix = camera.get_projection_matrix(width=width, height=height)
    rows: list[list[float]] = matrix.tolist()
    scale = 1.0
    try:
        return _placed(camera, rows, pose, width, height, scale)
    except ValueError:
        # A node's scale is part of the pose. If it is the same along all axes, distances alone change.
        scales = np.linalg.norm(pose[:3, :3], axis=0)
        scale = float(scales.mean())
        if not (scale > 0.0 and np.allclose(scales, scale, rtol=1e-4) and abs(scale - 1.0) > 1e-6):
            raise
        pose = pose.copy()
        pose[:3, :3] /= scale
        return _placed(camera, rows, pose, width, height, scale)


def _placed(
    camera: Camera, rows: list[list[float]], pose: NDArray[Any], width: int, height: int, scale: float
) -> tuple[NativeCamera, float, float]:
    (xx, _, xz, x1), (_, yy, yz, y1), (_, _, zz, z1), last = rows
    if last == [0.0, 0.0, -1.0, 0.0]:
        fx, fy = xx * width / 2.0, yy * height / 2.0
        middle = (1.0 - xz) * width / 2.0, (1.0 + yz) * height / 2.0
        far = np.inf if camera.zfar is None else camera.zfar * scale
        near = max(camera.znear * scale, _NEAREST)
        intrinsics = (fx, fy, *middle)
        return NativeCamera.from_pose(pose, intrinsics=intrinsics, near=near, far=far), 1.0 / scale, 0.0
    if last != [0.0, 0.0, 0.0, 1.0] or zz == 0.0:
        raise ValueError("luxel draws perspectives and parallel rays: the projection's last row is neither's")
    if abs(xx * width - yy * height) > 1e-6 * abs(yy * height):
        raise ValueError("luxel's parallel rays have square pixels: the projection scales x and y differently")
    near, far = sorted(((1.0 + z1) / zz * scale, (z1 - 1.0) / zz * scale))
    # The eye steps back until all that is seen lies before it, and aside for a picture off its axis.
    back = max(0.0, 1e-3 * (far - near) - near)
    step = np.array([-x1 / xx * scale, -y1 / yy * scale, back])
    moved = np.array(pose, np.float64)
    moved[:3, 3] += moved[:3, :3] @ step
    native = NativeCamera.from_pose(moved, height=2.0 / yy * scale, near=near + back, far=far + back)
    return native, 1.0 / scale, -back / scale
