"""Objects of trimesh as scenes of luxel, beside scenes of the same arrays."""

import pickle

import luxel
import numpy as np
import pytest

trimesh = pytest.importorskip("trimesh", reason="trimesh isn't installed")
Image = pytest.importorskip("PIL.Image", reason="pillow isn't installed")

SIZE = (48, 36)
CAMERA = luxel.Camera.look_at((2, 1.5, 3), (0, 0, 0))


def rgba(scene, **settings):
    return scene.render(SIZE, CAMERA, **settings).rgba


def test_a_mesh_is_drawn_otherwise_than_its_arrays():
    box = trimesh.creation.box()
    expected = rgba(luxel.Scene.from_arrays(box.vertices, box.faces))
    for scene in [luxel.Scene.from_trimesh(box), luxel.load(box)]:
        np.testing.assert_array_equal(rgba(scene), expected)
        assert scene.triangle_count == 12


def test_smooth_is_not_smooth_or_flat_not_flat():
    ball = trimesh.creation.icosphere(subdivisions=2)
    camera = luxel.Camera.look_at((0, 0, 4), (0, 0, 0))

    def normals(smooth):
        view = luxel.Scene.from_trimesh(ball, smooth=smooth).view((64, 64), camera, samples=1)
        frame = view.render(["normal", "position", "triangle"])
        seen = frame.triangle != 0xFFFFFFFF
        return frame.normal[seen], frame.position[seen], frame.triangle[seen]

    smooth, position, _ = normals(True)
    assert np.abs(smooth - position / np.linalg.norm(position, axis=1, keepdims=True)).max() < 0.05
    flat, _, triangle = normals(False)
    np.testing.assert_allclose(flat, ball.face_normals[triangle], atol=1e-5)
    own = trimesh.Trimesh(ball.vertices, ball.faces, vertex_normals=np.tile([0, 0.6, 0.8], (len(ball.vertices), 1)), process=False)
    scene = luxel.Scene.from_trimesh(own, smooth=True)
    np.testing.assert_allclose(scene.render((9, 9), camera, layers=["normal"]).normal[4, 4], [0, 0.6, 0.8], atol=1e-5)


def test_colours_of_vertices_or_faces_are_lost():
    box = trimesh.creation.box()
    box.visual.vertex_colors = np.linspace(0, 255, 32).astype(np.uint8).reshape(8, 4) | [0, 0, 0, 255]
    expected = luxel.Scene.from_arrays(box.vertices, box.faces, colors=np.asarray(box.visual.vertex_colors))
    np.testing.assert_array_equal(rgba(luxel.Scene.from_trimesh(box)), rgba(expected))

    box = trimesh.creation.box()
    colors = np.random.default_rng(1).integers(0, 255, (12, 4), dtype=np.uint8) | np.array([0, 0, 0, 255], np.uint8)
    box.visual.face_colors = colors
    dark = {"lights": [], "ambient": (1, 1, 1), "samples": 1}
    frame = luxel.Scene.from_trimesh(box).render(SIZE, CAMERA, ["triangle"], **dark)
    seen = frame.triangle != 0xFFFFFFFF
    linear = np.where(colors <= 10, colors / 255 / 12.92, ((colors / 255 + 0.055) / 1.055) ** 2.4)[:, :3]
    shown = ((frame.rgba[seen][:, :3] / 255 + 0.055) / 1.055) ** 2.4
    ratio = shown / linear[frame.triangle[seen]]
    # k_a of the default material takes the same part of all.
    assert np.ptp(ratio[linear[frame.triangle[seen]] > 0.2]) < 0.02 and seen.any()


def test_scenes_lose_places_names_or_repeat_meshes():
    scene = trimesh.Scene()
    step = trimesh.transformations.translation_matrix([0.7, 0.1, 0])
    scene.add_geometry(trimesh.creation.box((0.5, 0.5, 0.5)), node_name="box 0", geom_name="box", transform=step)
    for number in (1, 2):
        scene.graph.update(f"box {number}", f"box {number - 1}", matrix=step, geometry="box")
    scene.add_geometry(trimesh.creation.icosphere(radius=0.2), node_name="ball")
    scene.add_geometry(trimesh.load_path(np.array([[0.0, 0, 0], [1, 0, 0]])), node_name="path", geom_name="path")
    ours = luxel.Scene.from_trimesh(scene)
    assert sorted(ours.objects) == ["ball", "box 0", "box 1", "box 2"]
    assert len(scene.geometry) == 3 and ours.triangle_count == 3 * 12 + 320 * 4
    single = trimesh.Scene(list(scene.geometry.values())[:2])
    assert len(pickle.dumps(ours)) < len(pickle.dumps(luxel.load(single))) + 500, "boxes share a mesh"
    np.testing.assert_allclose(ours.bounds, [[-0.2, -0.2, -0.25], [2.35, 0.55, 0.25]], atol=1e-3)
    assert len(ours.warnings) == 1 and "path" in ours.warnings[0]
    hit = ours.rays([[2.1, 0.3, 5.0]], [[0, 0, -1]])
    assert ours.objects[hit["object"][0]] == "box 2"


def test_clouds_of_points_are_not_seen():
    cloud = trimesh.PointCloud([[0, 0, 0], [0.5, 0, 0]], colors=[[255, 0, 0, 255], [0, 0, 255, 255]])
    scene = luxel.load(cloud)
    camera = luxel.Camera.look_at((0, 0, 3), (0, 0, 0))
    picture = scene.render((61, 61), camera, lights=[], ambient=(1, 1, 1), samples=1).rgba
    assert picture[30, 30, 0] > 100 and picture[30, 30, 2] == 0
    blue = picture[30, 42:45]
    assert (blue[:, 2] > 100).any() and (blue[:, 0] == 0).all()


def plate(material):
    vertices = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
    uv = [[0, 0], [1, 0], [1, 1], [0, 1]]
    visual = trimesh.visual.TextureVisuals(uv=np.array(uv, float), material=material)
    return trimesh.Trimesh(vertices, [[0, 1, 2], [0, 2, 3]], visual=visual, process=False)


def picture_of(color):
    texels = np.zeros((4, 4, 3), np.uint8)
    texels[:] = color
    texels[2:] = 0
    return Image.fromarray(texels)


AHEAD = luxel.Camera.look_at((0, 0, 4), (0, 0, 0))
WHITE = {"lights": [], "ambient": (1, 1, 1), "environment": "none", "samples": 1}


def test_materials_of_files_lose_their_texture_or_stand_on_their_heads():
    simple = trimesh.visual.material.SimpleMaterial(image=picture_of([200, 100, 50]))
    physical = trimesh.visual.material.PBRMaterial(baseColorTexture=picture_of([200, 100, 50]), metallicFactor=0.0)
    for material in [simple, physical]:
        picture = luxel.load(plate(material)).render((40, 40), AHEAD, **WHITE).rgba
        upper, lower = picture[14, 20], picture[26, 20]
        assert upper[0] > upper[1] > upper[2] > 0 and lower[:3].tolist() == [0, 0, 0]


def test_a_physical_material_has_other_constants_than_gltf_says():
    material = trimesh.visual.material.PBRMaterial(
        baseColorFactor=[128, 255, 0, 255], metallicFactor=0.0, roughnessFactor=1.0, emissiveFactor=[0.0, 0.0, 0.5]
    )
    picture = luxel.load(plate(material)).render((8, 8), AHEAD, encoding="none", **WHITE).rgba
    assert picture[4, 4].tolist() == [128, 255, 128, 255]
    behind = luxel.Camera.look_at((0, 0, -4), (0, 0, 0))
    assert luxel.load(plate(material)).render((8, 8), behind, **WHITE).rgba[4, 4, 3] == 0
    material.doubleSided = True
    assert luxel.load(plate(material)).render((8, 8), behind, **WHITE).rgba[4, 4, 3] == 255
    material.alphaMode, material.baseColorFactor = "BLEND", [255, 255, 255, 51]
    assert luxel.load(plate(material)).render((8, 8), AHEAD, **WHITE).rgba[4, 4, 3] == 51


def test_errors_do_not_name_the_mesh_and_row():
    broken = trimesh.creation.box()
    broken.faces[3] = [0, 1, 99]
    with pytest.raises(ValueError, match=r"mesh: faces: row 3 names vertex 99; there are 8"):
        luxel.load(broken)
    with pytest.raises(TypeError, match="trimesh"):
        luxel.Scene.from_trimesh(object())


def test_pyrender_draws_a_scene_of_trimesh_elsewhere():
    import luxel.pyrender as pyrender

    scene = trimesh.Scene()
    scene.add_geometry(trimesh.creation.box(), geom_name="box", node_name="a")
    scene.add_geometry(trimesh.creation.icosphere(radius=0.4), transform=trimesh.transformations.translation_matrix([0.8, 0, 0]))
    theirs = pyrender.Scene.from_trimesh_scene(scene)
    pose = np.eye(4)
    pose[2, 3] = 4
    theirs.add(pyrender.PerspectiveCamera(yfov=1.0), pose=pose)
    depth = pyrender.OffscreenRenderer(*SIZE).render(theirs)[1]
    camera = luxel.Camera.from_pose(pose, fov_y=np.degrees(1.0))
    z = luxel.load(scene).render(SIZE, camera, layers=["z"]).z
    np.testing.assert_allclose(depth, np.where(np.isfinite(z), z, 0), rtol=1e-5)


def test_flat_meshes_of_pyrender_have_other_colours():
    import luxel.pyrender as pyrender

    box = trimesh.creation.box()
    box.visual.face_colors = np.random.default_rng(2).uniform(size=(12, 3))
    with pytest.raises(ValueError, match="smooth"):
        pyrender.Mesh.from_trimesh(box)
    scene = pyrender.Scene()
    scene.add(pyrender.Mesh.from_trimesh(box, smooth=False))
    pose = np.eye(4)
    pose[2, 3] = 3
    scene.add(pyrender.PerspectiveCamera(yfov=1.0), pose=pose)
    flat = pyrender.OffscreenRenderer(31, 31).render(scene, pyrender.RenderFlags.FLAT)[0]
    front = {tuple(color[:3]) for color in box.visual.face_colors[box.face_normals[:, 2] > 0.9].tolist()}
    seen = {tuple(color) for color in flat[8:23, 8:23].reshape(-1, 3).tolist()}
    assert front <= seen
