//! Triangles that are seen, made ready for shading: looked up and transformed once, not for every
//! block.

use luxel_math::LANES;
use luxel_scene::{Mesh, Scene};
use luxel_visibility::{Forms, Frame, InstanceSpace, TriangleId, TriangleOf};

/// What meshes carry beside positions and normals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Attributes {
    pub(crate) tangents: bool,
    pub(crate) uvs: [bool; 2],
    pub(crate) colors: bool,
}

impl Attributes {
    /// What any mesh of a scene carries.
    pub(crate) fn of(scene: &Scene) -> Self {
        let any = |has: fn(&Mesh) -> bool| scene.meshes.iter().any(has);
        Self {
            tangents: any(|mesh| !mesh.tangents.is_empty()),
            uvs: [any(|mesh| !mesh.uvs[0].is_empty()), any(|mesh| !mesh.uvs[1].is_empty())],
            colors: any(|mesh| !mesh.colors.is_empty()),
        }
    }
}

/// What interpolation mixes: a corner of a triangle, or any place between corners.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Corner {
    /// About the eye, along the world's axes.
    pub(crate) position: [f32; 3],
    /// Of unit length, in world space, turned to the side that is seen.
    pub(crate) normal: [f32; 3],
    /// Of unit length, in world space, with the bitangent's sign.
    pub(crate) tangent: [f32; 4],
    pub(crate) uv: [[f32; 2]; 2],
    /// White where the mesh has none.
    pub(crate) color: [f32; 4],
}

/// A triangle with everything that interpolation wants.
#[derive(Clone)]
pub(crate) struct SeenTriangle {
    id: TriangleId,
    pub(crate) of: TriangleOf,
    pub(crate) forms: Forms,
    /// The number of its material.
    pub(crate) material: u32,
    pub(crate) has: Attributes,
    pub(crate) corners: [Corner; 3],
}

/// The triangles that a thread has seen last, by the low bits of their ids.
pub(crate) struct SeenTriangles {
    entries: Vec<Option<SeenTriangle>>,
}

/// Entries of the cache: 128 KiB, a part of a core's second-level cache.
const ENTRIES: usize = 256;

impl SeenTriangles {
    pub(crate) fn new() -> Self {
        Self { entries: vec![None; ENTRIES] }
    }

    /// The triangle of an id; `None` for [`TriangleId::NONE`].
    pub(crate) fn get(
        &mut self,
        frame: &Frame<'_>,
        spaces: &[InstanceSpace],
        id: TriangleId,
    ) -> Option<&SeenTriangle> {
        let entry = &mut self.entries[id.0 as usize % ENTRIES];
        if entry.as_ref().is_none_or(|seen| seen.id != id) {
            let of = frame.triangle(id)?;
            *entry = Some(SeenTriangle::new(frame, &spaces[of.instance], id, of));
        }
        entry.as_ref()
    }
}

impl SeenTriangle {
    fn new(frame: &Frame<'_>, space: &InstanceSpace, id: TriangleId, of: TriangleOf) -> Self {
        let mesh = frame.instances()[of.instance].mesh;
        let attributes =
            mesh.attribute_corners()[of.triangle as usize].map(|corner| corner as usize);
        let corners_in_view = frame.corners_in_view(of);
        let places = corners_in_view.map(|corner| space.world_from_view * corner);
        let normals = space.facing_normals(mesh, attributes, places);
        Self {
            id,
            of,
            forms: frame.forms_of(corners_in_view),
            material: mesh.parts[of.part].material.0,
            has: Attributes {
                tangents: !mesh.tangents.is_empty(),
                uvs: [0, 1].map(|set| !mesh.uvs[set].is_empty()),
                colors: !mesh.colors.is_empty(),
            },
            corners: std::array::from_fn(|place| {
                let at = attributes[place];
                let uv = |set: usize| mesh.uvs[set].get(at).copied().unwrap_or_default();
                Corner {
                    position: places[place].as_vec3().to_array(),
                    normal: normals[place],
                    tangent: space.tangent(mesh, at),
                    uv: [uv(0), uv(1)],
                    color: mesh.colors.get(at).copied().unwrap_or([1.0; 4]),
                }
            }),
        }
    }
}

/// The distinct triangles that the lanes see, each with its lanes; those that see nothing left out.
#[inline(always)]
pub(crate) fn distinct(ids: &[u32; LANES]) -> impl Iterator<Item = (TriangleId, u32)> + '_ {
    let mut left: u32 = 0;
    for (lane, &id) in ids.iter().enumerate() {
        left |= u32::from(id != TriangleId::NONE.0) << lane;
    }
    std::iter::from_fn(move || {
        if left == 0 {
            return None;
        }
        let id = ids[left.trailing_zeros() as usize & (LANES - 1)];
        let mut lanes = 0;
        for (lane, &other) in ids.iter().enumerate() {
            lanes |= u32::from(other == id) << lane;
        }
        left &= !lanes;
        Some((TriangleId(id), lanes))
    })
}
