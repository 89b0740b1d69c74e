"""Arrays in: scenes of vertices and faces; arrays out: shapes, types and memory."""

import luxel
import numpy as np
import pytest

SQUARE = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32)
FACES = np.array([[0, 1, 2], [0, 2, 3]])
AHEAD = luxel.Camera.look_at((0, 0, 5), (0, 0, 0))
DARK = {"lights": ["ambient:color=1,1,1"], "samples": 1}


def test_frames_hold_contiguous_arrays_without_copies():
    frame = luxel.load("demo:teapot").render((30, 20), layers=["z", "normal", "object", "uv", "light:key"])
    shapes = {"rgba": ((20, 30, 4), "u1"), "z": ((20, 30), "f4"), "normal": ((20, 30, 3), "f4"),
              "object": ((20, 30), "u4"), "uv": ((20, 30, 2), "f4"), "light:key": ((20, 30, 3), "f4")}  # fmt: skip
    assert frame.names == list(shapes)
    for name, (shape, dtype) in shapes.items():
        array = frame[name]
        assert (array.shape, array.dtype) == (shape, np.dtype(dtype))
        assert array.flags.c_contiguous and array.flags.writeable
        assert np.shares_memory(array, frame[name])
    assert frame.z[10, 15] < np.inf and frame.z[0, 0] == np.inf


@pytest.mark.parametrize("dtype", [np.float16, np.float32, np.float64, np.int32])
@pytest.mark.parametrize("index", [np.uint8, np.int32, np.uint32, np.int64])
def test_arrays_of_any_type_make_the_same_scene(dtype, index):
    expected = luxel.Scene.from_arrays(SQUARE, FACES).render((16, 16), AHEAD).rgba
    found = luxel.Scene.from_arrays(SQUARE.astype(dtype), FACES.astype(index)).render((16, 16), AHEAD).rgba
    np.testing.assert_array_equal(found, expected)
    turned = luxel.Scene.from_arrays(np.asfortranarray(SQUARE), FACES[::1].tolist())
    np.testing.assert_array_equal(turned.render((16, 16), AHEAD).rgba, expected)


def test_vertices_far_away_keep_their_digits():
    far = SQUARE.astype(np.float64) + 1e7
    camera = luxel.Camera.look_at((1e7, 1e7, 1e7 + 5), (1e7, 1e7, 1e7))
    found = luxel.Scene.from_arrays(far, FACES).render((32, 32), camera, layers=["z"]).z
    near = luxel.Scene.from_arrays(SQUARE, FACES).render((32, 32), AHEAD, layers=["z"]).z
    np.testing.assert_array_equal(found, near)


def test_colours_of_bytes_are_srgb_and_of_floats_linear():
    color = np.array([188, 100, 20], np.uint8)
    linear = np.where(color <= 10, color / 255 / 12.92, ((color / 255 + 0.055) / 1.055) ** 2.4)
    for colors in [np.tile(color, (4, 1)), np.tile(linear, (4, 1))]:
        scene = luxel.Scene.from_arrays(SQUARE, FACES, colors=colors)
        rgba = scene.render((8, 8), AHEAD, **DARK).rgba[4, 4]
        # k_a of the default material takes part of the light: the ratio of channels stays.
        shown = ((rgba[:3] / 255 + 0.055) / 1.055) ** 2.4
        np.testing.assert_allclose(shown / shown[0], linear / linear[0], rtol=0.05)


def test_a_texture_lies_with_its_first_row_at_v_1():
    texture = np.zeros((2, 2, 3), np.uint8)
    texture[0] = [255, 0, 0]
    texture[1] = [0, 0, 255]
    uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    scene = luxel.Scene.from_arrays(SQUARE, FACES, uv=uv, texture=texture)
    rgba = scene.render((16, 16), AHEAD, **DARK).rgba
    red, blue = rgba[..., 0].astype(int), rgba[..., 2].astype(int)
    assert red[6, 8] > blue[6, 8] + 100, "the upper half is the first row"
    assert blue[9, 8] > red[9, 8] + 100


def test_normals_are_used():
    up = luxel.Scene.from_arrays(SQUARE, FACES, normals=np.tile([0, 3, 4], (4, 1)))
    normal = up.render((8, 8), AHEAD, layers=["normal"]).normal[4, 4]
    np.testing.assert_allclose(normal, [0, 0.6, 0.8], atol=1e-6)


def test_poses_of_opengl_and_opencv_are_one_camera():
    pose = np.eye(4)
    pose[2, 3] = 5
    cv = pose @ np.diag([1, -1, -1, 1])
    scene = luxel.load("demo:teapot")
    expected = scene.render((32, 32), luxel.Camera.look_at((0, 0, 5), (0, 0, 0), (0, 1, 0))).rgba
    for camera in [pose, luxel.Camera.from_pose(pose), luxel.Camera.from_pose(cv, "opencv")]:
        np.testing.assert_array_equal(scene.render((32, 32), camera).rgba, expected)


def test_intrinsics_project_as_opencv_does():
    fx, fy, cx, cy = 40.0, 44.0, 21.0, 12.0
    matrix = [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]
    scene = luxel.Scene.from_arrays(SQUARE * 0.01 + [0.3, 0.2, 3], FACES)
    camera = luxel.Camera.from_pose(np.eye(4), "opencv", intrinsics=matrix)
    hits = scene.view((48, 32), camera).pick_many([[fx * 0.1 + cx, fy * 0.2 / 3 + cy], [1, 1]])
    assert hits["object"].tolist() == [0, -1]
    np.testing.assert_allclose(hits["position"][0], [0.3, 0.2, 3], atol=3 / 40 / 256)


def test_rays_meet_what_they_should():
    scene = luxel.Scene.from_arrays(np.concatenate([SQUARE, SQUARE - [0, 0, 2]]), np.concatenate([FACES, FACES + 4]))
    origins = [[0.5, 0.25, 3], [5, 5, 3]]
    ways = [[0, 0, -2], [0, 0, -1]]
    hits = scene.rays(origins, ways)
    assert hits["t"].tolist() == [1.5, np.inf] and hits["object"].tolist() == [0, -1]
    np.testing.assert_allclose(hits["position"][0], [0.5, 0.25, 0])
    assert scene.rays(origins, ways, "any").tolist() == [True, False]
    every = scene.rays(origins, ways, "all")
    assert every["ray"].tolist() == [0, 0] and every["t"].tolist() == [1.5, 2.5]


def test_views_of_several_cameras_are_single_ones():
    scene = luxel.load("demo:teapot")
    cameras = [luxel.Camera.fit(azimuth) for azimuth in range(0, 360, 90)]
    frames = scene.render_views(cameras, (24, 24), layers=["z"], samples=1)
    for frame, camera in zip(frames, cameras, strict=True):
        alone = scene.render((24, 24), camera, layers=["z"], samples=1)
        np.testing.assert_array_equal(frame.rgba, alone.rgba)
        np.testing.assert_array_equal(frame.z, alone.z)


def test_views_drawn_together_are_those_drawn_alone_in_order():
    scene = luxel.load("demo:teapot")
    cameras = [luxel.Camera.fit(azimuth) for azimuth in range(0, 360, 30)]
    counts = []
    frames = scene.render_views(cameras, (40, 30), layers=["z", "z", "object"], progress=counts.append, samples=1)
    assert counts == list(range(1, 13))
    for camera, frame in zip(cameras, frames, strict=True):
        alone = scene.render((40, 30), camera, ["z", "object"], samples=1)
        assert all(np.array_equal(frame[layer], alone[layer]) for layer in ["rgba", "z", "object"])
    assert scene.render_views([], (40, 30)) == []


def test_an_error_of_the_progress_function_ends_the_views():
    scene = luxel.load("demo:teapot")

    def full(done):
        if done == 2:
            raise KeyError("no room")

    with pytest.raises(KeyError, match="no room"):
        scene.render_views([luxel.Camera.fit()] * 1000, (400, 300), progress=full, ao=64)
    with pytest.raises(ValueError, match="layers"):
        scene.render_views([luxel.Camera.fit()], (4, 4), layers=["colour"])
