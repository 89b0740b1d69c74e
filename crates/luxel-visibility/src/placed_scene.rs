//! A scene before a camera: where its objects become instances, for frames and for picks alike.

use crate::cluster::{Clusters, Instance, TooManyTriangles};
use crate::frame::Frame;
use crate::query::{InstanceSpace, Strokes, ViewSpace, strokes};
use crate::types::{Coverage, CullFaces, PartUse, Region, Samples, ViewFromLocal};
use glam::DMat4;
use luxel_math::Level;
use luxel_scene::{
    AlphaMode, Camera, CoplanarRanks, Mesh, Object, Scene, SceneMaterial, Size, bodies,
};
use luxel_view::Cull;
use std::ops::Range;
use std::sync::Arc;

/// How surfaces cover what lies behind them, by the alpha mode of their materials.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CoveragePolicy {
    /// Of opaque materials.
    pub opaque: Coverage,
    /// Of materials whose alpha cuts holes.
    pub masked: Coverage,
    /// Of materials that are blended by their alpha.
    pub blended: Coverage,
}

impl CoveragePolicy {
    /// As pictures show them.
    pub const DRAWN: Self =
        Self { opaque: Coverage::Opaque, masked: Coverage::Cutout, blended: Coverage::Blended };
    /// The nearest surface occludes all others, unless it is wholly transparent.
    pub const NEAREST: Self = Self { blended: Coverage::Cutout, ..Self::DRAWN };
    /// Blended surfaces occlude what lies behind them, too.
    pub const SOLID: Self = Self { blended: Coverage::Opaque, ..Self::DRAWN };
    /// Every surface is a layer, as if all were of glass.
    pub const LAYERS: Self =
        Self { opaque: Coverage::Blended, masked: Coverage::Blended, blended: Coverage::Blended };
}

/// Which faces of a scene are drawn, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceRules {
    /// The faces that are left out.
    pub cull: Cull,
    /// What surfaces do to what lies behind them.
    pub coverage: CoveragePolicy,
    /// Surfaces are holes between their edges, and edges are seen from both sides.
    pub wireframe: bool,
    /// The side of points, in pixels.
    pub point_size: f32,
}

impl SurfaceRules {
    fn part_use(&self, material: &SceneMaterial, mirrored: bool) -> PartUse {
        let Self { cull, coverage, wireframe, .. } = *self;
        let of_mode = match material.alpha_mode {
            AlphaMode::Opaque if wireframe => Coverage::Cutout,
            AlphaMode::Opaque => coverage.opaque,
            AlphaMode::Mask { .. } => coverage.masked,
            AlphaMode::Blend => coverage.blended,
        };
        let faces = if wireframe && cull == Cull::Auto {
            CullFaces::None
        } else {
            CullFaces::of(cull, material.sides, mirrored)
        };
        PartUse { cull: faces, coverage: of_mode }
    }
}

/// An object's triangles, or its points and lines, or the triangles of objects that share a mesh, before
/// the camera.
#[derive(Clone, Debug)]
pub struct PlacedInstance {
    objects: Range<u32>,
    /// The place in [`PlacedScene::strokes`] of the points and lines that it is; `None` for triangles.
    pub strokes: Option<u32>,
    /// How each part of the mesh is drawn.
    pub parts: Arc<[PartUse]>,
    /// The place of its [space](PlacedScene::space) among all.
    space: u32,
}

impl PlacedInstance {
    /// The objects, by their places in [`Scene::objects`].
    #[must_use]
    pub fn objects(&self) -> Range<usize> {
        self.objects.start as usize..self.objects.end as usize
    }

    /// The first object, whose mesh and place are those of all.
    #[must_use]
    pub fn first_object(&self) -> usize {
        self.objects.start as usize
    }
}

fn view_from_mesh(camera: &Camera, object: &Object) -> DMat4 {
    camera.view_from_world * object.world_from_mesh.matrix()
}

/// A scene before a camera: an instance for each object, or for all that share a mesh as its sections,
/// then one for the points and lines of each object that has some.
pub struct PlacedScene<'s> {
    scene: &'s Scene,
    objects: &'s [Object],
    camera: Camera,
    size: Size,
    ranks: &'s CoplanarRanks,
    strokes: Vec<Strokes>,
    instances: Vec<PlacedInstance>,
    /// Instances that follow one another share one, if they are in the same place: of files with many small objects
    /// without transforms, all do.
    spaces: Vec<InstanceSpace>,
}

impl<'s> PlacedScene<'s> {
    /// Places the objects of a scene, which are [`Scene::objects`], before a camera with a window of this
    /// size in pixels. `ranks` are those of the objects.
    #[must_use]
    pub fn new(
        scene: &'s Scene,
        (objects, ranks): (&'s [Object], &'s CoplanarRanks),
        camera: &Camera,
        size: Size,
        rules: &SurfaceRules,
    ) -> Self {
        let strokes = strokes(scene, objects, camera, size, rules.point_size);
        let view = Arc::new(ViewSpace::new(camera));
        let mut instances: Vec<PlacedInstance> =
            Vec::with_capacity(bodies(objects).count() + strokes.len());
        // A list that grows leaves the memory of its shorter lengths behind.
        let mut spaces: Vec<InstanceSpace> = Vec::with_capacity(instances.capacity());
        let mut push =
            |objects: Range<usize>, strokes, parts: Arc<[PartUse]>, space: InstanceSpace| {
                let before = spaces.last();
                if before != Some(&space) {
                    let space = match before {
                        Some(before) => space.sharing(before),
                        None => space,
                    };
                    spaces.push(space);
                }
                let same = instances.last().filter(|before| before.parts == parts);
                let parts = same.map_or(parts, |before| Arc::clone(&before.parts));
                instances.push(PlacedInstance {
                    objects: objects.start as u32..objects.end as u32,
                    strokes,
                    parts,
                    space: spaces.len() as u32 - 1,
                });
            };
        for body in bodies(objects) {
            let object = &objects[body.start];
            let mesh = &scene.meshes[object.mesh.index()];
            let world_from_mesh = &object.world_from_mesh;
            let mirrored = world_from_mesh.matrix().determinant() < 0.0;
            let part_use = |material: usize| rules.part_use(&scene.materials[material], mirrored);
            let view_from_local = ViewFromLocal::new(&view_from_mesh(camera, object), mesh.origin);
            let space = InstanceSpace::new(world_from_mesh, view_from_local, &view);
            let parts = mesh.parts.iter().map(|part| part_use(part.material.index())).collect();
            push(body, None, parts, space);
        }
        for (number, strokes) in (0..).zip(&strokes) {
            let mesh = &strokes.mesh;
            let part = PartUse { coverage: rules.coverage.opaque, ..PartUse::default() };
            let view_from_local = ViewFromLocal::new(&DMat4::IDENTITY, mesh.origin);
            let world_from_mesh = &objects[strokes.object].world_from_mesh;
            let space = InstanceSpace::new(world_from_mesh, view_from_local, &view);
            let parts = mesh.parts.iter().map(|_| part).collect();
            push(strokes.object..strokes.object + 1, Some(number), parts, space);
        }
        spaces.shrink_to_fit();
        Self { scene, objects, camera: *camera, size, ranks, strokes, instances, spaces }
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &'s Scene {
        self.scene
    }

    /// The scene's objects.
    #[must_use]
    pub fn objects(&self) -> &'s [Object] {
        self.objects
    }

    /// The camera.
    #[must_use]
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The window's size in pixels.
    #[must_use]
    pub fn size(&self) -> Size {
        self.size
    }

    /// The instances: objects in their order, then points and lines.
    #[must_use]
    pub fn instances(&self) -> &[PlacedInstance] {
        &self.instances
    }

    /// The spaces of an instance's positions and normals.
    #[inline]
    #[must_use]
    pub fn space(&self, instance: usize) -> &InstanceSpace {
        &self.spaces[self.instances[instance].space as usize]
    }

    /// Whether an instance repeats the one before it where nothing shows through: it is hidden wherever it
    /// is, as of equally near triangles the first one wins.
    ///
    /// So thousands of nodes that show one mesh in one place, a file of some kilobytes, cost one of them.
    #[must_use]
    pub fn is_repeated(&self, instance: usize) -> bool {
        let Some(before) = instance.checked_sub(1).map(|before| &self.instances[before]) else {
            return false;
        };
        let own = &self.instances[instance];
        let [first, first_before] =
            [own, before].map(|instance| &self.objects[instance.first_object()]);
        own.strokes.is_none()
            && before.strokes.is_none()
            && first.repeats(first_before)
            && own.parts.iter().all(|part| part.coverage == Coverage::Opaque)
    }

    /// Points and lines as triangles in view space, of the objects that have some.
    #[must_use]
    pub fn strokes(&self) -> &[Strokes] {
        &self.strokes
    }

    /// From an instance's own space to the camera's.
    #[must_use]
    pub fn view_from_mesh(&self, instance: &PlacedInstance) -> DMat4 {
        match instance.strokes {
            Some(_) => DMat4::IDENTITY,
            None => view_from_mesh(&self.camera, &self.objects[instance.first_object()]),
        }
    }

    /// The mesh of an instance.
    #[must_use]
    pub fn mesh(&self, instance: &PlacedInstance) -> &Mesh {
        match instance.strokes {
            Some(number) => &self.strokes[number as usize].mesh,
            None => &self.scene.meshes[self.objects[instance.first_object()].mesh.index()],
        }
    }

    /// The triangles of an instance that lie in the plane of an earlier object's, by their places in its mesh,
    /// and their ranks.
    #[must_use]
    pub fn ranks(&self, instance: &PlacedInstance) -> &'s [(u32, u8)] {
        match instance.strokes {
            Some(_) => &[],
            None => self.ranks.of_body(instance.first_object()),
        }
    }

    /// The object of a triangle, which is given by its instance and its place in the instance's mesh, and the triangle's
    /// number in it; `None` for points and lines.
    ///
    /// # Panics
    /// If there is no such instance.
    #[must_use]
    pub fn object_of(&self, instance: usize, triangle: u32) -> (usize, Option<u32>) {
        let instance = &self.instances[instance];
        let first = instance.first_object();
        if instance.strokes.is_some() {
            return (first, None);
        }
        let (section, triangle) = self.mesh(instance).section_of(triangle);
        let before = |object: &Object| object.section < section;
        let within = self.objects[instance.objects()].partition_point(before);
        (first + within, Some(triangle))
    }

    /// Culls and bins the instances for a part of the window, `clusters` those of the scene's meshes: see
    /// [`Frame::of_part`].
    ///
    /// # Errors
    /// [`TooManyTriangles`] beyond some billions.
    ///
    /// # Panics
    /// If a side of the window is 0 or more than [`MAX_SIDE`](crate::MAX_SIDE) pixels.
    pub fn frame<'a>(
        &'a self,
        clusters: &'a [Clusters],
        part: Region,
        samples: Samples,
        level: Level,
    ) -> Result<Frame<'a>, TooManyTriangles> {
        let instances = self.instances.iter().enumerate().map(|(number, instance)| Instance {
            mesh: self.mesh(instance),
            clusters: match instance.strokes {
                Some(number) => &self.strokes[number as usize].clusters,
                None => &clusters[self.objects[instance.first_object()].mesh.index()],
            },
            view_from_local: &self.space(number).view_from_local,
            parts: Arc::clone(&instance.parts),
            ranks: self.ranks(instance),
            is_repeated: self.is_repeated(number),
        });
        let (instances, projection) = (instances.collect(), &self.camera.projection);
        luxel_parallel::install(None, || {
            Frame::of_part(instances, projection, self.size, part, samples, level)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use luxel_scene::{Lens, MeshId, Node, Projection, demos};

    #[test]
    fn instances_in_one_place_share_their_space_after_one_elsewhere() {
        let mut scene = demos::demo("plane").unwrap();
        let node = Node::root("plane", Some(MeshId(0)));
        let moved = DMat4::from_translation(DVec3::X);
        scene.nodes = vec![node.clone(), node.clone().at(None, moved), node.at(None, moved)];
        let objects = scene.objects();
        let ranks = CoplanarRanks::of(&scene, &objects);
        let view_from_world = Camera::look_at(DVec3::new(2.0, 3.0, 4.0), DVec3::ZERO, DVec3::Y);
        let lens = Lens::Perspective { fov_y_radians: 0.7 };
        let projection = Projection { lens, near: 0.1, far: 100.0 };
        let camera = Camera { view_from_world, projection };
        let size = Size { width: 64, height: 48 };
        let rules = SurfaceRules {
            cull: Cull::Auto,
            coverage: CoveragePolicy::DRAWN,
            wireframe: false,
            point_size: 1.0,
        };
        let placed = PlacedScene::new(&scene, (&objects, &ranks), &camera, size, &rules);
        assert!(!std::ptr::eq(placed.space(0), placed.space(1)));
        assert!(std::ptr::eq(placed.space(1), placed.space(2)));
    }
}
