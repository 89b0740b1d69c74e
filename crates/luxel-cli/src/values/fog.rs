//! `near=Z:far=Z:front=S:back=S:color=R,G,B`: depth cueing on the command line.

use super::number::finite;
use super::vector::color;

/// Depth cueing: I' = s I + (1 - s) color, s going from `front` at `near` to `back` at `far`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FogSpec {
    /// z_f: the distance along the viewing axis where s begins to change.
    pub(crate) near: f64,
    /// z_b: where s stops changing.
    pub(crate) far: f64,
    /// s_f: the share of the surface's own light at `near` and before.
    pub(crate) front: f32,
    /// s_b: its share at `far` and beyond.
    pub(crate) back: f32,
    /// I_dc: what the surfaces fade to.
    pub(crate) color: [f32; 3],
}

/// Depth cueing. `near` and `far` are needed; `front` is 1, `back` 0, the colour black by default.
pub(crate) fn fog(text: &str) -> Result<FogSpec, String> {
    let mut near = None;
    let mut far = None;
    let mut front = None;
    let mut back = None;
    let mut tint = None;
    for field in text.split(':') {
        let (key, value) = field
            .split_once('=')
            .ok_or_else(|| format!("`{field}` lacks a value: use near=Z:far=Z:color=R,G,B"))?;
        let at_key = |message| format!("{key}: {message}");
        let once = match key {
            "near" => near.replace(finite(value).map_err(at_key)?).is_none(),
            "far" => far.replace(finite(value).map_err(at_key)?).is_none(),
            "front" => front.replace(share(value).map_err(at_key)?).is_none(),
            "back" => back.replace(share(value).map_err(at_key)?).is_none(),
            "color" => tint.replace(color(value).map_err(at_key)?).is_none(),
            _ => return Err(format!("`{key}` is unknown: use near, far, front, back, color")),
        };
        if !once {
            return Err(format!("`{key}` is given twice"));
        }
    }
    let near = near.ok_or_else(|| "it needs near=Z".to_owned())?;
    let far = far.ok_or_else(|| "it needs far=Z".to_owned())?;
    // In single precision, as the pixels have it.
    if near as f32 >= far as f32 {
        return Err("near must lie before far".to_owned());
    }
    Ok(FogSpec {
        near,
        far,
        front: front.unwrap_or(1.0),
        back: back.unwrap_or(0.0),
        color: tint.unwrap_or_default(),
    })
}

fn share(text: &str) -> Result<f32, String> {
    let share = finite(text)?;
    if (0.0..=1.0).contains(&share) { Ok(share as f32) } else { Err("use 0 to 1".to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_part_is_read() {
        let all = fog("near=1:far=5:front=.9:back=.1:color=.5,.6,.7").unwrap();
        assert_eq!((all.near, all.far, all.front, all.back), (1.0, 5.0, 0.9, 0.1));
        assert_eq!(all.color, [0.5, 0.6, 0.7]);
    }

    #[test]
    fn what_is_left_out_fades_to_black() {
        let least = fog("far=5:near=-1").unwrap();
        assert_eq!((least.front, least.back, least.color), (1.0, 0.0, [0.0; 3]));
    }

    #[test]
    fn wrong_fogs_are_refused() {
        for text in [
            "",
            "near=1",
            "far=1",
            "near=1:far=1",
            "near=2:far=1",
            "near=1:far=nan",
            "near=1:far=2:front=2",
            "near=1:far=2:back=-1",
            "near=1:far=2:color=1,1",
            "near=1:near=1:far=2",
            "near=1:far=2:density=3",
            "near:far",
        ] {
            assert!(fog(text).is_err(), "{text}");
        }
    }
}
