//! What is seen where no surface is: the background, and what the ground lays over it.

use super::Written;
use super::ledger::{ExplainedGround, Seen};
use super::shadow::shadow_at;
use crate::backdrop::Backdrop;
use crate::context::ShadingContext;
use crate::interpolate::Batch;
use luxel_scene::SceneLight;

/// What the first sample of a batch sees, which sees no surface.
pub(super) fn background(
    scene: &ShadingContext<'_>,
    batch: &Batch,
    eye: [f64; 3],
    lights: &[&SceneLight],
) -> Seen {
    let Some(backdrop) = scene.backdrop else {
        let [r, g, b, alpha] = scene.background;
        return Seen::Background { color: [r, g, b], alpha, ground: None };
    };
    let position = batch.position(0);
    let [r, g, b, alpha] = backdrop.color(position);
    let ground = ground(scene, backdrop, position, (eye, lights));
    Seen::Background { color: [r, g, b], alpha, ground: ground.map(Box::new) }
}

fn ground(
    scene: &ShadingContext<'_>,
    backdrop: &Backdrop<'_>,
    position: [f64; 2],
    (eye, lights): ([f64; 3], &[&SceneLight]),
) -> Option<ExplainedGround> {
    let ground = backdrop.ground.as_ref()?;
    let mut written = Written::default();
    let sample = ground.explained(position, &mut written)?;
    let mut explained = written.explained_lights(scene, eye, lights, None);
    for (number, light) in explained.iter_mut().enumerate() {
        if light.terms.n_dot_l > 0.0 {
            let normal = sample.point.normal.lane(0);
            let at = (normal, position);
            light.shadow = Some(shadow_at(scene, &ground.shadows, number, &sample.place, at));
        }
    }
    Some(ExplainedGround {
        position: sample.place.position.to_array(),
        behind: backdrop.behind_ground(position),
        openness: sample.openness(),
        ambient_light: scene.ambient,
        scene_ambient: written.ledger.scene_ambient,
        lights: explained,
        light: sample.light.lane(0),
        unoccluded: sample.unoccluded.lane(0),
        fog: sample.fog,
        darkness: sample.darkness,
    })
}
