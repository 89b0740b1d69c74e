//! The ground under a model, in words.

use super::light::{in_the_way, why_not};
use crate::words::{color, number};
use luxel_render::{ExplainedGround, ExplainedLight};

/// What the ground shows at a place: facts with their labels.
pub(crate) fn ground_facts(ground: &ExplainedGround) -> Vec<(String, String)> {
    let [x, y, z] = ground.position.map(|side| number(side as f32));
    let fog = if ground.fog < 1.0 { format!("{} x ", number(ground.fog)) } else { String::new() };
    let mut facts = vec![
        ("ground".to_owned(), format!("under the model, at ({x}, {y}, {z})")),
        (
            "darkness".to_owned(),
            format!(
                "{} = {fog}(1 - Y(I) / Y(I_0)), with I = {} and, without the model, I_0 = {}",
                number(ground.darkness),
                color(ground.light),
                color(ground.unoccluded),
            ),
        ),
        ("openness".to_owned(), format!("{}, of ambient light", number(ground.openness))),
    ];
    facts.extend(ground.lights.iter().map(light));
    let [r, g, b, alpha] = ground.behind;
    let behind = if alpha > 0.0 {
        format!("the background, {}, alpha {}", color([r, g, b]), number(alpha))
    } else {
        "nothing: the background is transparent".to_owned()
    };
    facts.push(("behind it".to_owned(), behind));
    facts
}

/// A light on the ground: how much of it arrives, and why no more.
fn light(light: &ExplainedLight) -> (String, String) {
    let terms = &light.terms;
    let mut text = format!("N.L = {}", number(terms.n_dot_l));
    if let Some(visibility) = terms.visibility.filter(|_| terms.n_dot_l > 0.0) {
        text += &format!(", V = {}", number(visibility));
    }
    if let Some(blocked) = in_the_way(light) {
        text += &format!("; {blocked}");
    } else if terms.n_dot_l <= 0.0
        && let Some(why) = light.unlit()
    {
        text += &format!("; {}", why_not(why));
    }
    (light.name.clone(), text)
}
