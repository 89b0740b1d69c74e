"""Triangles in clip coordinates, against the definition and against views."""

import luxel
import numpy as np
import pytest

FACES = np.array([[0, 1, 2], [0, 2, 3]], np.int32)
SQUARE = np.array([[-1, -1, 0, 1], [1, -1, 0, 1], [1, 1, 0, 1], [-1, 1, 0, 1]], np.float32)


def test_barycentrics_weight_the_corners_of_the_triangle_that_is_named():
    perspective = SQUARE * [[1], [3], [3], [1]]
    rast = luxel.rasterize(perspective, FACES, (64, 48))
    assert rast.shape == (48, 64, 4) and rast.dtype == np.float32
    u, v, depth, number = np.moveaxis(rast, -1, 0)
    assert set(np.unique(number)) == {1, 2} and not depth.any()
    weights = np.stack([u, v, 1 - u - v], -1)
    corners = perspective[FACES[number.astype(int) - 1]]
    x, y, _, w = np.moveaxis((weights[..., None] * corners).sum(-2), -1, 0)
    columns, rows = np.meshgrid((np.arange(64) + 0.5) / 32 - 1, (np.arange(48) + 0.5) / 24 - 1)
    # Rows begin at the bottom.
    np.testing.assert_allclose(x / w, columns, atol=1e-6)
    np.testing.assert_allclose(y / w, rows, atol=1e-6)


def test_a_projected_mesh_shows_the_triangles_that_its_view_shows():
    random = np.random.default_rng(7)
    vertices = random.normal(size=(60, 3)).astype(np.float32)
    faces = random.permuted(np.tile(np.arange(60), (3, 1)), axis=1)[:, :40].T
    frame = luxel.Scene.from_arrays(vertices, faces).render(
        (96, 96), luxel.Camera.look_at((0, 0, 6), (0, 0, 0), fov_y=50, near=1, far=20), ["triangle", "depth"], samples=1
    )
    focal = 1 / np.tan(np.radians(25))
    projection = np.array([[focal, 0, 0, 0], [0, focal, 0, 0], [0, 0, -21 / 19, -40 / 19], [0, 0, -1, 0]])
    clip = np.c_[vertices - [0, 0, 6], np.ones(60)] @ projection.T
    rast = luxel.rasterize(clip.astype(np.float32), faces, (96, 96))[::-1]
    expected = np.where(frame.triangle == 2**32 - 1, 0, frame.triangle.astype(np.int64) + 1)
    # Vertices are rounded elsewhere: some pixels of edges see another triangle.
    assert (rast[..., 3] == expected).mean() > 0.995
    same = (rast[..., 3] == expected) & (expected > 0)
    np.testing.assert_allclose(rast[..., 2][same], frame.depth[same] * 2 - 1, atol=1e-4)


def test_nearer_triangles_hide_others_and_what_is_outside_is_not_seen():
    ahead = SQUARE + [0, 0, 0.5, 0]
    vertices = np.concatenate([ahead, SQUARE * [0.5, 0.5, 1, 1], SQUARE + [0, 0, -1.5, 0]])
    rast = luxel.rasterize(vertices, np.concatenate([FACES, FACES + 4, FACES + 8]), (8, 8))
    assert set(np.unique(rast[2:6, 2:6, 3])) == {3, 4}
    assert set(np.unique(rast[0, :, 3])) <= {1, 2}
    assert not luxel.rasterize(vertices, FACES + 8, (8, 8)).any()


def test_a_batch_is_drawn_one_by_one():
    batch = np.stack([SQUARE, SQUARE * [0.5, 0.5, 1, 1]])
    rast = luxel.rasterize(batch, FACES, (16, 8))
    assert rast.shape == (2, 8, 16, 4)
    for each, vertices in zip(rast, batch, strict=True):
        np.testing.assert_array_equal(each, luxel.rasterize(vertices, FACES, (16, 8), threads=1))
    assert luxel.rasterize(batch[:0], FACES, (16, 8)).shape == (0, 8, 16, 4)


def test_tensors_give_tensors():
    torch = pytest.importorskip("torch")
    rast = luxel.rasterize(torch.from_numpy(SQUARE).requires_grad_(), torch.from_numpy(FACES), (8, 8))
    assert isinstance(rast, torch.Tensor)
    np.testing.assert_array_equal(rast.numpy(), luxel.rasterize(SQUARE, FACES, (8, 8)))


@pytest.mark.parametrize(
    ("vertices", "faces", "size", "said"),
    [
        (SQUARE[:, :3], FACES, (8, 8), r"vertices_clip: .*\(n, 4\)"),
        (SQUARE * [1, np.nan, 1, 1], FACES, (8, 8), "vertices_clip: row 0"),
        (SQUARE.astype(np.float64) * [1e300, 1, 1, 1], FACES, (8, 8), "vertices_clip: row 0"),
        (SQUARE, FACES + 2, (8, 8), "faces: row 0 names vertex 4"),
        (SQUARE, FACES * 1.0, (8, 8), "faces: expected whole numbers"),
        (SQUARE, FACES, (0, 8), "size: "),
        (SQUARE, FACES, (8, 16385), "size: "),
    ],
)
def test_a_wrong_argument_is_named(vertices, faces, size, said):
    with pytest.raises(ValueError, match=said):
        luxel.rasterize(vertices, faces, size)
