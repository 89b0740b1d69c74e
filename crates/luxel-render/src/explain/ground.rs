//! What is seen where no surface is: the background, and what the ground lays over it.

use super::ledger::{ExplainedGround, Seen};
use super::shadow::shadow_at;
use super::written::Written;
use crate::backdrop::Backdrop;
use crate::context::ShadingContext;
use crate::interpolate::Batch;
use crate::shade::ThreadCache;
use crate::shadow::Receiver;
use luxel_math::LANES;
use luxel_scene::SceneLight;
use luxel_visibility::TriangleId;

/// What the first sample of a batch sees, which sees no surface.
pub(super) fn background(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    eye: [f64; 3],
    lights: &[&SceneLight],
    kept: &mut ThreadCache,
) -> Seen {
    let Some(backdrop) = scene.backdrop else {
        let [r, g, b, alpha] = scene.background;
        return Seen::Background { color: [r, g, b], alpha, ground: None };
    };
    let position = batch.position(0);
    let mut colors = [[0.0; LANES]; 4];
    backdrop.put(0.0_f32, 1, &|_| position, &mut kept.occlusion, &mut colors);
    let [r, g, b, alpha] = colors.map(|channel| channel[0]);
    let ground = ground(scene, backdrop, position, (eye, lights), kept);
    Seen::Background { color: [r, g, b], alpha, ground: ground.map(Box::new) }
}

fn ground(
    scene: &ShadingContext<'_>,
    backdrop: &Backdrop<'_>,
    position: [f64; 2],
    (eye, lights): ([f64; 3], &[&SceneLight]),
    kept: &mut ThreadCache,
) -> Option<ExplainedGround> {
    let ground = backdrop.ground.as_ref()?;
    let mut written = Written::default();
    let found = &mut kept.occlusion;
    let seen = ground.seen(0.0_f32, 1, &|_| position, found, &mut written);
    if seen.lanes == 0 {
        return None;
    }
    let place = seen.place();
    let behind = backdrop.behind_ground(position);
    let mut explained = written.explained_lights(scene, eye, lights, None);
    let normal = seen.point.normal.lane(0);
    let receiver = Receiver {
        id: TriangleId::NONE,
        barycentric: [0.0; 3],
        normal,
        smooth: normal,
        position,
        is_between: false,
    };
    for (number, light) in explained.iter_mut().enumerate() {
        if light.terms.n_dot_l > 0.0 {
            light.shadow = Some(shadow_at(scene, &ground.shadows, number, &place, &receiver));
        }
    }
    Some(ExplainedGround {
        position: place.position.to_array(),
        behind,
        openness: kept.occlusion.openness(),
        ambient_light: scene.ambient,
        scene_ambient: written.ledger.scene_ambient,
        lights: explained,
        light: seen.light.lane(0),
        unoccluded: seen.unoccluded.lane(0),
        fog: seen.fog,
        darkness: seen.darkness,
        alpha: ground.alpha(seen.darkness, behind[3]),
    })
}
