//! What keeps light away: the trees of the scene for its rays, and the ground that it stands on.

use super::Renderer;
use crate::frame::RenderError;
use crate::shadow::{DiscSequence, Floor, LightSource, OpennessRule, Shadows};
use luxel_lighting::PlacedLight;
use luxel_rays::{MeshTrees, Quality, SceneRays};
use luxel_scene::{Bounds, DVec3};
use luxel_view::{AmbientOcclusion, View};
use luxel_visibility::{Frame, PlacedScene};
use std::sync::Arc;

/// The trees serve many rays.
const QUALITY: Quality = Quality::Thorough;

impl Renderer {
    /// The bounds of what is drawn.
    pub(super) fn bounds(&self) -> Bounds {
        *self.bounds.get_or_compute(|| self.scene.bounds_of(&self.objects))
    }

    /// What is up in a view, of unit length.
    pub(super) fn up(&self, view: &View) -> DVec3 {
        view.up.unwrap_or(self.scene.up).normalize_or(DVec3::Y)
    }

    /// The plane under all that is drawn.
    pub(super) fn floor(&self, view: &View) -> Floor {
        let up = self.up(view);
        let lowest = || self.scene.lowest_of(&self.objects, up);
        let level = match view.up {
            None => *self.lowest.get_or_compute(lowest),
            Some(_) => lowest(),
        };
        Floor { up, level }
    }

    /// Builds the trees that rays of shadows, openness and the ground go through now, rather than for the
    /// first view that needs them. [`Renderer::into_prepared`] keeps them.
    ///
    /// # Errors
    /// [`RenderError::TooManyForRays`] if a mesh has too many triangles, [`RenderError::TreesTooLarge`] if
    /// the trees exceed the memory limit.
    pub fn build_trees(&self) -> Result<(), RenderError> {
        self.install(|| self.rays()).map(|_| ())
    }

    /// The trees of what is drawn.
    pub(super) fn rays(&self) -> Result<&SceneRays, RenderError> {
        let build = || {
            self.check_memory()?;
            let (scene, objects) = (Arc::clone(&self.scene), Arc::clone(&self.objects));
            let kept = self.kept_trees.lock().ok().and_then(|mut kept| kept.take());
            let rays = match kept {
                Some(trees) => SceneRays::with_trees(trees, scene, objects, self.level),
                None => SceneRays::of_objects(scene, objects, QUALITY, self.level),
            };
            Ok(Box::new(rays?))
        };
        let rays = self.rays.get_or_compute(build).as_ref();
        rays.map(AsRef::as_ref).map_err(Clone::clone)
    }

    /// Fails before trees are built that exceed the memory limit.
    fn check_memory(&self) -> Result<(), RenderError> {
        let limit = self.max_memory;
        let needed = SceneRays::bytes_needed(&self.scene, &self.objects, QUALITY);
        if needed <= limit {
            return Ok(());
        }
        let triangles = self.scene.meshes.iter().map(|mesh| mesh.triangles.len() as u64).sum();
        Err(RenderError::TreesTooLarge { triangles, needed, limit })
    }

    /// Takes the trees of the meshes out, as far as they are built.
    pub(super) fn take_trees(&mut self) -> Option<MeshTrees> {
        let built = self.rays.take().and_then(Result::ok).map(|rays| rays.into_trees());
        built.or_else(|| self.kept_trees.get_mut().ok().and_then(Option::take))
    }

    /// What keeps light away from surfaces: lights, if they cast shadows, and openness.
    pub(super) fn shadows<'f>(
        &'f self,
        view: &View,
        frame: &'f Frame<'f>,
        (placed, lights): (&'f PlacedScene<'f>, &'f [PlacedLight]),
        (casts_shadows, openness): (bool, Option<AmbientOcclusion>),
        floor: Option<Floor>,
    ) -> Result<Shadows<'f>, RenderError> {
        let rays = self.rays()?;
        let camera = placed.camera();
        let eye = camera.eye();
        Ok(Shadows {
            rays,
            frame,
            placed,
            lights,
            sources: lights
                .iter()
                .filter(|_| casts_shadows)
                .map(|light| LightSource::new(light, eye))
                .collect(),
            light_rays: view.light_rays.max(1),
            openness: openness.map(|occlusion| OpennessRule {
                radius: occlusion.radius.unwrap_or_else(|| self.scene.bounds().radius() * 0.25),
                rays: occlusion.rays.max(1),
            }),
            floor,
            disc: DiscSequence::new(),
            eye,
            towards_eye: camera.projection.is_orthographic().then(|| -camera.direction()),
        })
    }
}
