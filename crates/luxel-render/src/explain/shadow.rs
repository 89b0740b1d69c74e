//! What stands between a surface and a light.

use super::ledger::{BlockedBy, ExplainedShadow};
use crate::context::ShadingContext;
use crate::shadow::Shadows;
use luxel_rays::{Blocker, SurfacePlace};
use luxel_visibility::TriangleId;

/// The surface that a sample sees: its triangle, where on it, the normal that is lit, and where the sample
/// is in the window, in pixels.
#[derive(Clone, Copy)]
pub(crate) struct Receiver {
    pub(super) id: TriangleId,
    pub(super) barycentric: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) position: [f64; 2],
}

impl Receiver {
    /// What keeps the light of this number away, of which `n_dot_l` is the cosine; `None` without
    /// shadows.
    pub(super) fn shadow(
        &self,
        scene: &ShadingContext<'_>,
        light: usize,
        n_dot_l: f32,
    ) -> Option<ExplainedShadow> {
        let shadows = scene.shadows.filter(|shadows| !shadows.sources.is_empty())?;
        let place = shadows.place(self.id, self.barycentric).filter(|_| n_dot_l > 0.0);
        let Some(place) = place else { return Some(ExplainedShadow::NO_RAY) };
        Some(shadow_at(scene, shadows, light, &place, (self.normal, self.position)))
    }

    /// The openness; `None` without ambient occlusion.
    pub(super) fn openness(&self, scene: &ShadingContext<'_>) -> Option<f32> {
        let shadows = scene.shadows?;
        let rule = shadows.openness?;
        let open = |place| shadows.openness(rule, &place, self.normal, self.position);
        Some(shadows.place(self.id, self.barycentric).map_or(1.0, open))
    }
}

/// What keeps the light of this number away from a place with a shading normal, of a sample in the window.
pub(super) fn shadow_at(
    scene: &ShadingContext<'_>,
    shadows: &Shadows<'_>,
    light: usize,
    place: &SurfacePlace,
    (normal, position): ([f32; 3], [f64; 2]),
) -> ExplainedShadow {
    let Some((rays, terminator)) = shadows.rays_to(light, place, normal, position) else {
        return ExplainedShadow::NO_RAY;
    };
    let part = 1.0 / rays.len() as f32;
    let mut blocked_by: Vec<BlockedBy> = Vec::new();
    for ray in rays.iter().flatten() {
        let mut through = 1.0;
        for Blocker { object, triangle, t, alpha } in shadows.rays.blockers(ray) {
            let share = through * alpha * part;
            through *= 1.0 - alpha;
            if share <= 0.0 {
                break;
            }
            match blocked_by.iter_mut().find(|other| other.object == object) {
                Some(known) => {
                    known.share += share;
                    if t < known.distance {
                        (known.distance, known.triangle) = (t, triangle);
                    }
                }
                None => {
                    let node = shadows.rays.objects()[object].node;
                    let name = scene.scene.nodes[node.index()].name.clone();
                    blocked_by.push(BlockedBy { object, name, triangle, distance: t, share });
                }
            }
        }
    }
    blocked_by.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    let first = rays.iter().flatten().next();
    ExplainedShadow {
        terminator,
        ray: first.map(|ray| [ray.origin.to_array(), ray.direction.to_array()]),
        blocked_by,
    }
}
