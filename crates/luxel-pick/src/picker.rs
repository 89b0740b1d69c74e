//! A scene prepared for picking.

use luxel_bvh::{Quality, TooManyForTree};
use luxel_math::{Level, SimdLevel, UnavailableSimdLevel};
use luxel_parallel::Memo;
use luxel_rays::{BodyTree, RaysError, SceneRays, WorldHit, WorldRay};
use luxel_scene::{CoplanarRanks, Mesh, Object, Scene};
use std::sync::Arc;

/// Why a scene can't be prepared.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PickError {
    /// The scene isn't sound, or a mesh has too many triangles.
    #[error(transparent)]
    Rays(#[from] RaysError),
    /// The machine lacks the instruction set.
    #[error("{0}")]
    Simd(String),
}

impl From<TooManyForTree> for PickError {
    fn from(error: TooManyForTree) -> Self {
        Self::Rays(error.into())
    }
}

impl From<UnavailableSimdLevel> for PickError {
    fn from(error: UnavailableSimdLevel) -> Self {
        Self::Simd(error.to_string())
    }
}

/// A scene prepared for queries: world-space rays, and, through a [`PickView`](crate::PickView), what a
/// camera sees. It shares the scene and its trees: a program can keep both.
pub struct Picker {
    rays: Arc<SceneRays>,
    /// Those of the objects.
    ranks: Memo<CoplanarRanks>,
}

impl Picker {
    /// Builds the trees on all threads of the current pool, for the best instruction set of the machine.
    ///
    /// # Errors
    /// [`PickError`] if the scene isn't [sound](Scene::check) or a mesh has too many triangles.
    pub fn new(scene: impl Into<Arc<Scene>>) -> Result<Self, PickError> {
        Self::with(scene, Quality::Thorough, SimdLevel::Auto)
    }

    /// Builds the trees with a given quality and instruction set.
    ///
    /// # Errors
    /// [`PickError`] if the scene isn't [sound](Scene::check), a mesh has too many triangles, or the machine lacks the
    /// instructions.
    pub fn with(
        scene: impl Into<Arc<Scene>>,
        quality: Quality,
        simd: SimdLevel,
    ) -> Result<Self, PickError> {
        let rays = SceneRays::with(scene.into(), quality, simd.resolve()?)?;
        Ok(Self::of(Arc::new(rays)))
    }

    /// An upper bound of the memory that [`Picker::with`] takes beside the scene, in bytes, for programs
    /// with a limit.
    #[must_use]
    pub fn bytes_needed(scene: &Scene, quality: Quality) -> u64 {
        SceneRays::bytes_needed(scene, &scene.objects(), quality)
    }

    /// Shares trees that are there already, as a renderer's for shadows.
    #[must_use]
    pub fn of(rays: Arc<SceneRays>) -> Self {
        Self { rays, ranks: Memo::new() }
    }

    /// Its trees.
    #[must_use]
    pub fn rays(&self) -> &Arc<SceneRays> {
        &self.rays
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Arc<Scene> {
        self.rays.scene()
    }

    /// The objects; hits give their indices.
    #[must_use]
    pub fn objects(&self) -> &[Object] {
        self.rays.objects()
    }

    /// The memory of the trees, in bytes, without the scene.
    #[must_use]
    pub fn memory(&self) -> usize {
        self.rays.memory()
    }

    /// [`SceneRays::closest`].
    #[must_use]
    pub fn closest(&self, ray: &WorldRay) -> Option<WorldHit> {
        self.rays.closest(ray)
    }

    /// [`SceneRays::any`].
    #[must_use]
    pub fn any(&self, ray: &WorldRay) -> bool {
        self.rays.any(ray)
    }

    /// [`SceneRays::all`].
    #[must_use]
    pub fn all(&self, ray: &WorldRay) -> Vec<WorldHit> {
        self.rays.all(ray)
    }

    /// [`SceneRays::closest_of_each`].
    #[must_use]
    pub fn closest_of_each(&self, rays: &[WorldRay]) -> Vec<Option<WorldHit>> {
        self.rays.closest_of_each(rays)
    }

    /// [`SceneRays::any_of_each`].
    #[must_use]
    pub fn any_of_each(&self, rays: &[WorldRay]) -> Vec<bool> {
        self.rays.any_of_each(rays)
    }

    /// The ranks of surfaces in one plane, found by the first view.
    pub(crate) fn ranks(&self) -> &CoplanarRanks {
        self.ranks.get_or_compute(|| CoplanarRanks::of(self.scene(), self.objects()))
    }

    pub(crate) fn level(&self) -> Level {
        self.rays.level()
    }

    /// The mesh of an object's body.
    pub(crate) fn mesh(&self, object: usize) -> &Mesh {
        self.rays.mesh(self.rays.body_of(object))
    }

    /// The tree of an object's body.
    pub(crate) fn tree(&self, object: usize) -> BodyTree<'_> {
        self.rays.tree(self.rays.body_of(object))
    }
}
