//! What stands between a surface and a light.

use super::ledger::{BlockedBy, ExplainedShadow};
use crate::context::ShadingContext;
use luxel_rays::Blocker;
use luxel_visibility::TriangleId;

/// The surface that a sample sees: its triangle, where on it, and the normal that is lit.
#[derive(Clone, Copy)]
pub(super) struct Receiver {
    pub(super) id: TriangleId,
    pub(super) barycentric: [f32; 3],
    pub(super) normal: [f32; 3],
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
        let shadows = scene.shadows?;
        let place = shadows.place(self.id, self.barycentric).filter(|_| n_dot_l > 0.0);
        let ray = place.and_then(|place| shadows.ray(light, &place, self.normal));
        let Some(shadow) = ray else {
            return Some(ExplainedShadow { terminator: 1.0, ray: None, blocked_by: Vec::new() });
        };
        let mut through = 1.0;
        let mut blocked_by: Vec<BlockedBy> = Vec::new();
        for Blocker { object, triangle, t, alpha } in shadows.rays.blockers(&shadow.ray) {
            let share = through * alpha;
            through *= 1.0 - alpha;
            if share <= 0.0 {
                break;
            }
            match blocked_by.iter_mut().find(|other| other.object == object) {
                Some(known) => known.share += share,
                None => {
                    let node = shadows.rays.objects()[object].node;
                    let name = scene.scene.nodes[node.index()].name.clone();
                    blocked_by.push(BlockedBy { object, name, triangle, distance: t, share });
                }
            }
        }
        Some(ExplainedShadow {
            terminator: shadow.terminator,
            ray: Some([shadow.ray.origin.to_array(), shadow.ray.direction.to_array()]),
            blocked_by,
        })
    }
}
