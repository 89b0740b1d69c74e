//! What stands between a surface and a light.

use super::ledger::{BlockedBy, ExplainedShadow};
use crate::context::ShadingContext;
use crate::shadow::{Receiver, Shadows};
use luxel_rays::{Blocker, SurfacePlace};

/// What keeps the light of this number from a receiver, if V is asked for; `None` without shadows.
pub(super) fn shadow_of(
    scene: &ShadingContext<'_>,
    receiver: &Receiver,
    light: usize,
    is_asked: bool,
) -> Option<ExplainedShadow> {
    let shadows = scene.shadows.filter(|shadows| !shadows.sources.is_empty())?;
    let place = shadows.place(receiver.id, receiver.barycentric).filter(|_| is_asked);
    let Some(place) = place else { return Some(ExplainedShadow::NO_RAY) };
    Some(shadow_at(scene, shadows, light, &place, receiver))
}

/// The openness of a receiver; `None` without ambient occlusion.
pub(super) fn openness_of(scene: &ShadingContext<'_>, receiver: &Receiver) -> Option<f32> {
    let shadows = scene.shadows?;
    let rule = shadows.openness?;
    let open = |place| shadows.openness(rule, &place, receiver.normal, receiver.position);
    Some(shadows.place(receiver.id, receiver.barycentric).map_or(1.0, open))
}

/// What keeps the light of this number away from a receiver's place.
pub(super) fn shadow_at(
    scene: &ShadingContext<'_>,
    shadows: &Shadows<'_>,
    light: usize,
    place: &SurfacePlace,
    receiver: &Receiver,
) -> ExplainedShadow {
    let Some((rays, terminator)) = shadows.rays_to(light, place, receiver) else {
        return ExplainedShadow::NO_RAY;
    };
    let part = 1.0 / rays.len() as f32;
    let mut blocked_by: Vec<BlockedBy> = Vec::new();
    // Without a factor of the terminator, no ray is traced.
    let traced = if terminator > 0.0 { &rays[..] } else { &[] };
    for ray in traced {
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
                    let name = scene.scene.nodes[node.index()].name.to_string();
                    blocked_by.push(BlockedBy { object, name, triangle, distance: t, share });
                }
            }
        }
    }
    blocked_by.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    let ray = traced.first();
    ExplainedShadow {
        terminator,
        raised: ray.map_or(0.0, |ray| (ray.origin - place.origin()).length()),
        ray: ray.map(|ray| [ray.origin.to_array(), ray.direction.to_array()]),
        blocked_by,
    }
}
