"""`luxel.pyrender`: what pyrender's users rely on, beside answers by formula and by luxel's own layers."""

import subprocess
import sys

import luxel
import luxel.pyrender as pyrender
import numpy as np
import pytest

FLAGS = pyrender.RenderFlags
SQUARE = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32)
FACES = np.array([[0, 1, 2], [0, 2, 3]])
UP = np.tile([0.0, 0.0, 1.0], (4, 1))


def moved(x=0.0, y=0.0, z=0.0):
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    return pose


def matt(color, **fields):
    return pyrender.MetallicRoughnessMaterial(baseColorFactor=color, metallicFactor=0.0, roughnessFactor=1.0, **fields)


def square(color=(1.0, 1.0, 1.0, 1.0), **fields):
    material = matt(list(color), **fields)
    return pyrender.Mesh([pyrender.Primitive(SQUARE, normals=UP, indices=FACES, material=material)])


def seen(*meshes, camera=None, distance=4.0, **fields):
    """A scene of meshes in their places, before a camera on the z axis."""
    scene = pyrender.Scene(**fields)
    nodes = [scene.add(mesh, pose=pose) for mesh, pose in meshes]
    scene.add(camera or pyrender.PerspectiveCamera(yfov=np.pi / 3), pose=moved(z=distance))
    return scene, nodes


def rays(width, height, fx, fy, cx, cy):
    """Directions through the middles of pixels, in OpenGL's camera coordinates, 1 deep."""
    x, y = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    return np.stack([(x - cx) / fx, -(y - cy) / fy, -np.ones_like(x)], axis=-1)


def linear(byte):
    value = np.asarray(byte) / 255
    return np.where(value <= 0.04045, value / 12.92, ((value + 0.055) / 1.055) ** 2.4)


def test_importing_it_imports_nothing_but_numpy():
    code = (
        "import sys, luxel, luxel.pyrender;"
        "print([m for m in ('trimesh', 'networkx', 'PIL', 'OpenGL', 'scipy', 'six') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.strip() == "[]"


def test_pictures_have_the_wrong_shape_or_type():
    scene, _ = seen((square(), np.eye(4)))
    renderer = pyrender.OffscreenRenderer(40, 30)
    color, depth = renderer.render(scene)
    assert (color.shape, color.dtype, depth.shape, depth.dtype) == ((30, 40, 3), np.uint8, (30, 40), np.float32)
    assert color.flags.c_contiguous and depth.flags.c_contiguous
    rgba, _ = renderer.render(scene, FLAGS.RGBA)
    assert rgba.shape == (30, 40, 4)
    np.testing.assert_array_equal(rgba[..., :3], color)
    only = renderer.render(scene, FLAGS.DEPTH_ONLY)
    np.testing.assert_array_equal(only, depth)
    renderer.viewport_width = 20
    assert renderer.render(scene)[0].shape == (30, 20, 3)
    renderer.delete()
    assert renderer.render(scene)[1].shape == (30, 20)


def test_depths_differ_from_those_of_rays_through_a_tilted_plane():
    fx, fy, cx, cy = 150.0, 130.0, 60.0, 55.0
    tilt = np.eye(4)
    tilt[:3, :3] = [[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]]
    camera = pyrender.IntrinsicsCamera(fx, fy, cx, cy)
    scene, _ = seen((square(doubleSided=True), tilt), camera=camera)
    depth = pyrender.OffscreenRenderer(128, 96).render(scene)[1]
    ways = rays(128, 96, fx, fy, cx, cy)
    normal = tilt[:3, 2]
    distance = -(normal @ [0.0, 0.0, 4.0]) / (ways @ normal)
    place = ways * distance[..., None] + [0.0, 0.0, 4.0]
    inside = np.abs(place @ tilt[:3, :2]).max(axis=-1)
    np.testing.assert_allclose(depth[inside < 0.97], distance[inside < 0.97], rtol=1e-4)
    assert (depth[inside > 1.03] == 0).all() and (inside < 0.97).sum() > 1000


def test_depths_of_parallel_rays_or_scaled_cameras_are_not_metres():
    camera = pyrender.OrthographicCamera(xmag=1.0, ymag=1.5)
    scene, _ = seen((square(), moved(z=1.0)), camera=camera)
    depth = pyrender.OffscreenRenderer(60, 60).render(scene)[1]
    assert depth[30, 30] == pytest.approx(3.0, rel=1e-4)
    rows = np.flatnonzero(depth[:, 30])
    assert len(rows) == 40, "2 of 3 units are 40 of 60 pixels"
    # In a node that is twice as large, a camera's units are twice as long.
    scene, _ = seen((square(), np.eye(4)))
    (node,) = scene.camera_nodes
    scene.set_pose(node, moved(z=4.0) @ np.diag([2.0, 2.0, 2.0, 1.0]))
    depth = pyrender.OffscreenRenderer(60, 60).render(scene)[1]
    assert depth[30, 30] == pytest.approx(2.0, rel=1e-4)


@pytest.mark.parametrize("camera", [
    pyrender.PerspectiveCamera(yfov=np.pi / 3), pyrender.PerspectiveCamera(yfov=1.0, aspectRatio=2.0, zfar=9.0),
    pyrender.IntrinsicsCamera(70.0, 90.0, 30.0, 40.0), pyrender.OrthographicCamera(1.0, 2.0)])  # fmt: skip
def test_vertices_are_seen_elsewhere_than_the_projection_matrix_says(camera):
    width, height = 80, 60
    place = np.array([0.7, 0.4, 0.5])
    small = pyrender.Mesh([pyrender.Primitive(SQUARE * 0.08, normals=UP, indices=FACES)])
    scene, _ = seen((small, moved(*place)), camera=camera)
    depth = pyrender.OffscreenRenderer(width, height).render(scene)[1]
    clip = camera.get_projection_matrix(width, height) @ [*(place - [0, 0, 4.0]), 1.0]
    x, y = (clip[0] / clip[3] + 1) * width / 2, (1 - clip[1] / clip[3]) * height / 2
    rows, columns = np.nonzero(depth)
    assert abs(columns.mean() + 0.5 - x) < 0.6 and abs(rows.mean() + 0.5 - y) < 0.6
    assert depth[rows[0], columns[0]] == pytest.approx(3.5, rel=1e-4)


def test_clipping_planes_cut_elsewhere():
    def depths(near, far):
        camera = pyrender.PerspectiveCamera(yfov=np.pi / 3, znear=near, zfar=far)
        scene, _ = seen((square(), np.eye(4)), camera=camera)
        return pyrender.OffscreenRenderer(16, 16).render(scene)[1][8, 8]

    assert depths(0.05, 3.9) == 0 and depths(4.1, 9.0) == 0
    assert depths(0.05, None) == depths(3.9, 4.1) == pytest.approx(4.0, rel=1e-5)


def test_a_lit_plane_has_another_colour_than_the_formula():
    albedo = np.array([0.5, 0.25, 0.1])
    scene, _ = seen((square([*albedo, 1.0]), np.eye(4)), ambient_light=[0.1, 0.2, 0.3])
    pose = np.eye(4)
    pose[:3, :3] = [[1, 0, 0], [0, 0.6, -0.8], [0, 0.8, 0.6]]
    scene.add(pyrender.DirectionalLight(color=[1.0, 0.5, 0.25], intensity=3.0), pose=pose)
    scene.add(pyrender.PointLight(intensity=6.0), pose=moved(z=2.0))
    color = pyrender.OffscreenRenderer(33, 33).render(scene)[0][16, 16]
    # Seen along the normal: the diffuse terms of glTF, (1 - F) albedo / pi, and a little shine of a rough dielectric.
    expected = albedo * [0.1, 0.2, 0.3]
    for strength, ways, cosine in [(np.array([3.0, 1.5, 0.75]), [0.0, -0.8, 0.6], 0.6), (6.0 / 4.0, [0, 0, 1], 1.0)]:
        half = np.array(ways) + [0, 0, 1]
        half = half / np.linalg.norm(half)
        fresnel = 0.04 + 0.96 * (1 - half[2]) ** 5
        # D = 1 / pi and V = 1 / (2 (N.L + N.V)) of the roughest facets.
        shine = fresnel / np.pi / (2 * (cosine + 1)) * cosine
        expected = expected + strength * ((1 - fresnel) * albedo / np.pi * cosine + shine)
    np.testing.assert_allclose(linear(color), expected, atol=0.012)


def test_a_spot_is_as_bright_outside_of_its_cone_as_inside():
    scene, _ = seen((square(), np.eye(4)))
    light = pyrender.SpotLight(intensity=12.0, innerConeAngle=0.1, outerConeAngle=0.3)
    node = scene.add(light, pose=moved(z=2.0))
    renderer = pyrender.OffscreenRenderer(65, 65)
    color = renderer.render(scene)[0]
    column = color[32, :, 0]
    assert column[32] > 150 and column[32 - 12] == 0 and 0 < column[32 - 5] < column[32]
    scene.set_pose(node, moved(x=0.7, z=2.0))
    assert renderer.render(scene)[0][32, 32].tolist() == [0, 0, 0]


def test_the_background_is_not_the_one_that_was_set():
    color = [10, 200, 128, 77]
    scene, _ = seen(bg_color=color)
    renderer = pyrender.OffscreenRenderer(4, 4)
    assert renderer.render(scene)[0][0, 0].tolist() == color[:3]
    assert renderer.render(scene, FLAGS.RGBA)[0][0, 0].tolist() == color
    assert renderer.render(scene, FLAGS.FLAT)[0][0, 0].tolist() == color[:3]
    assert renderer.render(scene)[1].max() == 0
    scene.bg_color = [0.5, 0.5, 0.5]
    assert renderer.render(scene)[0][0, 0].tolist() == [128] * 3


def test_flat_pictures_are_not_base_colours_times_texels():
    texels = np.zeros((2, 2, 3), np.uint8)
    texels[0], texels[1] = [200, 100, 50], [0, 0, 255]
    uv = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    sampler = pyrender.Sampler(magFilter=pyrender.GLTF.NEAREST, minFilter=pyrender.GLTF.NEAREST)
    texture = pyrender.Texture(source=texels, source_channels="RGB", sampler=sampler)
    material = matt([0.5, 1.0, 1.0, 1.0], baseColorTexture=texture)
    mesh = pyrender.Mesh([pyrender.Primitive(SQUARE, normals=UP, indices=FACES, texcoord_0=uv, material=material)])
    scene, _ = seen((mesh, np.eye(4)))
    scene.add(pyrender.DirectionalLight(intensity=3.0), pose=moved(z=4.0))
    color = pyrender.OffscreenRenderer(32, 32).render(scene, FLAGS.FLAT)[0]
    assert color[12, 16].tolist() == [100, 100, 50], "the first row is the upper one"
    assert color[20, 16].tolist() == [0, 0, 255]


def test_masks_differ_from_the_object_layer():
    places = [moved(-0.6), moved(0.5, 0.3, 0.4), moved(0.2, -0.9, -0.5)]
    scene, nodes = seen(*[(square(), place) for place in places])
    colors = {node: (20 * number + 20, number, 255 - number) for number, node in enumerate(nodes)}
    image, depth = pyrender.OffscreenRenderer(120, 90).render(scene, FLAGS.SEG, colors)
    vertices = np.concatenate([SQUARE + place[:3, 3] for place in places])
    faces = np.concatenate([FACES + 4 * number for number in range(3)])
    own = luxel.Scene.from_arrays(vertices, faces)
    fov = np.degrees(np.pi / 3)
    camera = luxel.Camera.from_pose(moved(z=4.0), fov_y=fov)
    frame = own.render((120, 90), camera, layers=["triangle", "z"], samples=1)
    table = np.array([*colors.values(), (0, 0, 0)], np.uint8)
    expected = table[np.where(frame.triangle == 0xFFFFFFFF, 3, frame.triangle // 2)]
    assert (image != expected).any(axis=-1).mean() < 0.005
    both = (depth > 0) & np.isfinite(frame.z)
    np.testing.assert_allclose(depth[both], frame.z[both], rtol=1e-4)


def test_nodes_outside_of_the_map_hide_others_or_are_seen():
    scene, (front, back) = seen((square(), moved(z=1.0)), (square(), np.eye(4)))
    renderer = pyrender.OffscreenRenderer(40, 40)
    both = renderer.render(scene, FLAGS.SEG, {front: (255, 0, 0), back: 7})[0]
    assert both[20, 20].tolist() == [255, 0, 0]
    alone, depth = renderer.render(scene, FLAGS.SEG, {back: 7})
    assert alone[20, 20].tolist() == [7, 7, 7] and depth[20, 20] == pytest.approx(4.0, rel=1e-4)
    assert renderer.render(scene, FLAGS.SEG)[0].max() == 0
    again = renderer.render(scene, FLAGS.SEG, {front: (255, 0, 0), back: 7})[0]
    np.testing.assert_array_equal(again, both)
    np.testing.assert_array_equal(renderer.render(scene)[1] > 0, both.any(axis=-1))


def test_back_faces_are_seen_where_they_should_not_be():
    turned = np.diag([-1.0, 1.0, -1.0, 1.0])
    renderer = pyrender.OffscreenRenderer(16, 16)
    for is_double, expected in [(False, 0), (True, 4)]:
        scene, (node,) = seen((square(doubleSided=is_double), turned))
        assert renderer.render(scene)[1][8, 8] == pytest.approx(expected)
        assert renderer.render(scene, FLAGS.SKIP_CULL_FACES)[1][8, 8] == pytest.approx(4)
        # As in pyrender, depths alone and masks have no double sides.
        assert renderer.render(scene, FLAGS.DEPTH_ONLY)[8, 8] == 0
        assert renderer.render(scene, FLAGS.SEG, {node: 9})[0].max() == 0


def test_a_change_between_pictures_is_not_seen():
    scene, (node,) = seen((square([1.0, 0.0, 0.0, 1.0]), np.eye(4)), ambient_light=[1.0, 1.0, 1.0])
    renderer = pyrender.OffscreenRenderer(64, 64)

    def middle():
        color, depth = renderer.render(scene)
        return color[32, 32].tolist(), round(float(depth[32, 32]), 3)

    assert middle() == ([255, 0, 0], 4.0)
    node.mesh.primitives[0].material.baseColorFactor = [0.0, 1.0, 0.0, 1.0]
    assert middle() == ([0, 255, 0], 4.0)
    node.mesh.primitives[0].material.baseColorFactor[2] = 1.0
    assert middle() == ([0, 255, 255], 4.0), "an entry of the array"
    scene.set_pose(node, moved(z=1.0))
    assert middle()[1] == 3.0
    node.translation = [0.0, 0.0, 2.0]
    assert middle()[1] == 2.0
    near = scene.add(square([0.0, 0.0, 1.0, 1.0]), pose=moved(z=2.5))
    assert middle() == ([0, 0, 255], 1.5)
    near.mesh.is_visible = False
    assert middle() == ([0, 255, 255], 2.0)
    near.mesh.is_visible = True
    scene.remove_node(near)
    assert middle() == ([0, 255, 255], 2.0)
    scene.ambient_light = [0.0, 0.0, 0.0]
    assert middle() == ([0, 0, 0], 2.0)
    lamp = scene.add(pyrender.DirectionalLight(intensity=np.pi), pose=moved(z=9.0))
    lit, _ = middle()
    assert lit[1] > 200
    lamp.light.intensity = 1.0
    assert middle()[0][1] < lit[1]
    node.mesh.primitives[0].positions = SQUARE + [9.0, 0.0, 0.0]
    assert middle() == ([255, 255, 255], 0.0)
    node.mesh.primitives[0].positions = SQUARE
    (eye,) = scene.camera_nodes
    scene.set_pose(eye, moved(z=5.0))
    assert middle()[1] == 3.0
    eye.camera.zfar = 2.5
    assert middle()[1] == 0.0


def test_instances_are_not_seen_in_their_poses():
    poses = np.array([moved(-1.5), moved(1.5)])
    primitive = pyrender.Primitive(SQUARE * 0.5, normals=UP, indices=FACES, poses=poses)
    mesh = pyrender.Mesh([primitive])
    scene, (node,) = seen((mesh, moved(y=0.5)))
    renderer = pyrender.OffscreenRenderer(81, 61)
    depth = renderer.render(scene)[1]
    alone = pyrender.Mesh([pyrender.Primitive(SQUARE * 0.5, normals=UP, indices=FACES)])
    expected = renderer.render(seen((alone, moved(-1.5, 0.5)), (alone, moved(1.5, 0.5)))[0])[1]
    np.testing.assert_array_equal(depth, expected)
    assert depth[30, 40] == 0 and (depth > 0).any()
    mask = renderer.render(scene, FLAGS.SEG, {node: 1})[0]
    np.testing.assert_array_equal(mask[..., 0] > 0, depth > 0)
    primitive.poses = poses[:1]
    assert (renderer.render(scene)[1][:, 41:] == 0).all()


def test_children_do_not_move_with_their_parents():
    scene, (parent,) = seen((square(), np.eye(4)))
    child = scene.add(square(), pose=moved(z=1.0), parent_node=parent)
    scene.set_pose(parent, moved(z=0.5))
    assert pyrender.OffscreenRenderer(9, 9).render(scene)[1][4, 4] == pytest.approx(2.5, rel=1e-4)
    np.testing.assert_allclose(scene.get_pose(child), moved(z=1.5))
    np.testing.assert_allclose(scene.bounds, [[-1, -1, 0.5], [1, 1, 1.5]])


def test_points_are_larger_or_smaller_than_their_size():
    for size in (1, 3, 9):
        cloud = pyrender.Mesh.from_points([[0.0, 0.0, 0.0]], colors=[[255, 0, 0]])
        scene, _ = seen((cloud, np.eye(4)), ambient_light=[1.0, 1.0, 1.0])
        color, depth = pyrender.OffscreenRenderer(31, 31, point_size=size).render(scene)
        assert abs(int((depth > 0).sum()) - size * size) <= 2 * size
        assert color[15, 15].tolist() == [255, 0, 0]


@pytest.mark.parametrize("mode", ["TRIANGLE_STRIP", "TRIANGLE_FAN", "LINE_LOOP", "LINES", "LINE_STRIP"])
def test_modes_of_primitives_are_not_those_of_gltf(mode):
    order = {"TRIANGLE_STRIP": [0, 1, 3, 2], "TRIANGLE_FAN": [0, 1, 2, 3]}.get(mode, [0, 1, 2, 3])
    code = getattr(pyrender.GLTF, mode)
    primitive = pyrender.Primitive(SQUARE[order], mode=code)
    scene, _ = seen((pyrender.Mesh([primitive]), np.eye(4)))
    depth = pyrender.OffscreenRenderer(64, 64).render(scene)[1]
    solid = pyrender.OffscreenRenderer(64, 64).render(seen((square(), np.eye(4)))[0])[1]
    if mode.startswith("TRIANGLE"):
        np.testing.assert_array_equal(depth > 0, solid > 0)
    else:
        sides = [(depth[row, column] > 0).any() for row, column in [
            (slice(44, 50), 32), (slice(14, 20), 32), (32, slice(44, 50)), (32, slice(14, 20))]]  # fmt: skip
        assert sides == {"LINE_LOOP": [True] * 4, "LINES": [True, True, False, False],
                         "LINE_STRIP": [True, True, True, False]}[mode]  # fmt: skip


def test_wires_are_solid_or_solids_wires():
    pair = (square(), moved(-1.2)), (square(wireframe=True), moved(1.2))
    scene, _ = seen(*pair, bg_color=[0, 0, 0, 0])
    renderer = pyrender.OffscreenRenderer(120, 60)

    def counts(flags):
        is_seen = renderer.render(scene, flags | FLAGS.RGBA)[0][..., 3] > 0
        return int(is_seen[:, :60].sum()), int(is_seen[:, 60:].sum())

    solid, wires = counts(FLAGS.NONE)
    assert wires < 0.5 * solid
    full, both = counts(FLAGS.ALL_SOLID)
    assert full == solid and abs(both - solid) < 0.1 * solid
    assert max(counts(FLAGS.ALL_WIREFRAME)) < 0.5 * solid
    flipped, unflipped = counts(FLAGS.FLIP_WIREFRAME)
    assert flipped < 0.5 * solid and abs(unflipped - solid) < 0.1 * solid


def test_shadows_fall_without_being_asked_for_or_not_at_all():
    small = pyrender.Mesh([pyrender.Primitive(SQUARE * 0.2, normals=UP, indices=FACES)])
    scene, _ = seen((square(), np.eye(4)), (small, moved(0.5, 0, 1)))
    pose = np.eye(4)
    pose[:3, :3] = [[0.8, 0.0, 0.6], [0.0, 1.0, 0.0], [-0.6, 0.0, 0.8]]
    scene.add(pyrender.DirectionalLight(intensity=3.0), pose=pose)
    renderer = pyrender.OffscreenRenderer(64, 64)
    bright = renderer.render(scene)[0][32, 32 - 3, 0]
    dark = renderer.render(scene, FLAGS.SHADOWS_DIRECTIONAL)[0][32, 32 - 3, 0]
    assert bright > 150 and dark < 10
    assert renderer.render(scene, FLAGS.SHADOWS_SPOT)[0][32, 32 - 3, 0] == bright


def test_a_camera_with_a_matrix_of_its_own_is_not_understood():
    class Weak(pyrender.Camera):
        def get_projection_matrix(self, width=None, height=None):
            matrix = np.diag([0.5, 0.5, -1.0, 1.0])
            matrix[0, 3], matrix[1, 3] = 0.25, -0.5
            return matrix

    scene, _ = seen((square(), moved(z=-0.5)), camera=Weak(), distance=0.0)
    depth = pyrender.OffscreenRenderer(80, 80).render(scene)[1]
    rows, columns = np.nonzero(depth)
    assert (columns.min(), columns.max(), rows.min(), rows.max()) == (30, 69, 40, 79)
    assert depth[60, 50] == pytest.approx(0.5, abs=1e-3)


def test_bad_input_is_not_refused_with_its_place():
    with pytest.raises(ValueError, match="camera"):
        pyrender.OffscreenRenderer(8, 8).render(pyrender.Scene())
    wrong = pyrender.Mesh([pyrender.Primitive(SQUARE, indices=[[0, 1, 2], [0, 1, 9]])])
    scene, _ = seen((wrong, np.eye(4)))
    with pytest.raises(ValueError, match=r"primitive 0: faces: row 1 names vertex 9; there are 4"):
        pyrender.OffscreenRenderer(8, 8).render(scene)
    broken = SQUARE.copy()
    broken[2, 1] = np.nan
    scene, _ = seen((pyrender.Mesh([pyrender.Primitive(broken, indices=FACES)]), np.eye(4)))
    with pytest.raises(ValueError, match=r"primitive 0: vertices: row 2"):
        pyrender.OffscreenRenderer(8, 8).render(scene)
    with pytest.raises(NotImplementedError, match="OffscreenRenderer"):
        pyrender.Viewer(pyrender.Scene(), use_raymond_lighting=True)
    with pytest.warns(UserWarning, match="VERTEX_NORMALS"):
        pyrender.OffscreenRenderer(8, 8).render(seen()[0], FLAGS.VERTEX_NORMALS)


def test_quaternions_and_matrices_of_nodes_disagree():
    random = np.random.default_rng(5)
    for _ in range(50):
        quaternion = random.normal(size=4)
        quaternion /= np.linalg.norm(quaternion)
        scale = random.uniform(0.2, 3.0, 3)
        node = pyrender.Node(rotation=quaternion, scale=scale, translation=[1, 2, 3])
        again = pyrender.Node(matrix=node.matrix)
        np.testing.assert_allclose(again.scale, scale)
        np.testing.assert_allclose(again.rotation * np.sign(again.rotation @ quaternion), quaternion, atol=1e-9)
        np.testing.assert_allclose(again.translation, [1, 2, 3])
        axis, angle = quaternion[:3] / np.linalg.norm(quaternion[:3]), 2 * np.arccos(quaternion[3])
        cross = np.cross(np.eye(3), axis)
        turn = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
        np.testing.assert_allclose(node.matrix[:3, :3], turn * scale, atol=1e-9)
