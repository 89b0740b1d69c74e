"""Rays behind trimesh's interface, against analytic answers and trimesh's own."""

import copy
import pickle

import numpy as np
import pytest

trimesh = pytest.importorskip("trimesh")
import luxel.trimesh  # noqa: E402

RayMeshIntersector = luxel.trimesh.RayMeshIntersector


@pytest.fixture
def box():
    mesh = trimesh.creation.box()
    mesh.ray = RayMeshIntersector(mesh)
    return mesh


def test_rays_through_a_box_meet_it_twice_nearest_first(box):
    origins = [[0.1, 0.2, 5], [0.1, 0.2, -5], [9, 9, 9]]
    places, rays, triangles = box.ray.intersects_location(origins, [[0, 0, -2], [0, 0, 1], [0, 0, 1]])
    np.testing.assert_array_equal(rays, [0, 0, 1, 1])
    np.testing.assert_allclose(places, [[0.1, 0.2, z] for z in (0.5, -0.5, -0.5, 0.5)], atol=1e-12)
    np.testing.assert_allclose(box.face_normals[triangles][:, 2], [1, -1, -1, 1])


def test_places_on_edges_and_corners_count_once(box):
    vectors = np.concatenate([box.vertices, [[1, 0, 1], [0, 0, 1], [-1, 1, 0]]])
    _, rays, _ = box.ray.intersects_location(np.zeros_like(vectors), vectors)
    np.testing.assert_array_equal(np.bincount(rays), np.ones(len(vectors)))


def test_first_hits_leave_the_others_out(box):
    origins = [[0.1, 0.2, 5], [9, 9, 9]]
    triangles, rays = box.ray.intersects_id(origins, [[0, 0, -1]] * 2, multiple_hits=False)
    first = box.ray.intersects_first(origins, [[0, 0, -1]] * 2)
    assert (list(rays), list(first)) == ([0], [triangles[0], -1])
    assert box.ray.intersects_any(origins, [[0, 0, -1]] * 2).tolist() == [True, False]
    triangles, rays = box.ray.intersects_id(origins, [[0, 0, -1]] * 2, max_hits=1)
    assert (list(rays), list(triangles)) == ([0], [first[0]])


def test_rays_that_meet_nothing_give_empty_arrays(box):
    places, rays, triangles = box.ray.intersects_location([[9, 9, 9]], [[0, 0, 1]])
    assert (places.shape, rays.shape, triangles.shape) == ((0, 3), (0,), (0,))


@pytest.mark.parametrize("scale", [1e-4, 1, 1e4, 1e8])
def test_a_ray_that_begins_on_the_surface_meets_both_sides(scale):
    mesh = trimesh.creation.box().subdivide().subdivide()
    mesh.apply_scale(scale)
    triangles, _ = RayMeshIntersector(mesh).intersects_id([[0, 0, scale / 2]], [[0, 0, -1]])
    assert len(triangles) == 2


def test_points_are_inside_as_trimesh_s_own_rays_say():
    mesh = trimesh.creation.icosphere(subdivisions=3)
    points = np.random.default_rng(5).uniform(-1.2, 1.2, (500, 3))
    inside = RayMeshIntersector(mesh).contains_points(points)
    radius = np.linalg.norm(points, axis=1)
    clear = np.abs(radius - 1) > 0.02
    np.testing.assert_array_equal(inside[clear], radius[clear] < 1)


def test_a_changed_mesh_is_seen_by_the_next_query(box):
    assert box.ray.intersects_any([[0, 0, 5]], [[0, 0, -1]]).all()
    box.apply_translation([3, 0, 0])
    assert not box.ray.intersects_any([[0, 0, 5]], [[0, 0, -1]]).any()


def test_intersectors_are_copied_and_pickled_with_their_mesh(box):
    for other in [copy.copy(box.ray), copy.deepcopy(box.ray), pickle.loads(pickle.dumps(box.ray))]:
        assert other.intersects_any([[0, 0, 5]], [[0, 0, -1]]).all()


def test_rays_without_a_partner_are_refused(box):
    with pytest.raises(ValueError, match="1 ray_directions for 2 ray_origins"):
        box.ray.intersects_any([[0, 0, 5], [0, 0, 6]], [[0, 0, -1]])
