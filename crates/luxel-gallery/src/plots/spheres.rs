//! Spheres under light from many sides.

use crate::GalleryError;
use crate::chapter::Chapter;
use crate::picture::Picture;
use crate::shot::{Rolled, Shot, Studio};
use luxel::lighting::Reflection;
use luxel::scene::Size;

/// Pixels of a sphere's picture.
const SIDE: u32 = 192;
/// Pixels between pictures.
const GAP: u32 = 8;
/// The ground between them.
const GROUND: [u8; 3] = [0x1c, 0x1f, 0x23];

/// A round ball of a reflection, lit from a direction, seen along the z axis.
fn ball(reflection: Reflection, sun: [f64; 3]) -> Shot {
    Shot {
        reflection: Some(reflection),
        sun: Some(sun),
        rolled: Some(Rolled { up: [0.0, 1.0], fov: 18.5 }),
        ..Shot::of("lab-silhouette-cured").size(SIDE, SIDE)
    }
}

/// To three places, as on the command line.
fn rounded(direction: [f64; 3]) -> [f64; 3] {
    direction.map(|part| (part * 1000.0).round() / 1000.0 + 0.0)
}

/// Pictures in rows.
fn sheet(rows: &[Vec<Picture>]) -> Picture {
    let columns = rows.first().map_or(0, Vec::len) as u32;
    let extent = |count: u32| count * SIDE + count.saturating_sub(1) * GAP;
    let size = Size { width: extent(columns), height: extent(rows.len() as u32) };
    let mut sheet = Picture::plain(size, GROUND);
    for (row, pictures) in (0..).zip(rows) {
        for (column, picture) in (0..).zip(pictures) {
            sheet.put(picture, column * (SIDE + GAP), row * (SIDE + GAP));
        }
    }
    sheet
}

/// A light grey.
const MOON: [f32; 3] = [0.75, 0.72, 0.66];
/// The angles between eye and light.
const PHASES: [f64; 6] = [0.0, 30.0, 60.0, 90.0, 120.0, 150.0];

pub(crate) fn phases(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("phases", "A Lambertian sphere from all sides");
    chapter.text(
        "The light of a matte surface doesn't depend on the position of the eye, so an image of \
         a matte sphere shows only the direction of the light: walking around it shows the \
         phases of the moon. (The moon itself isn't Lambertian: when full, it is as bright at \
         its edge as in its middle.)",
    );
    let mut pictures = Vec::new();
    let mut middle = None;
    let of = |sun| Shot { color: Some(MOON), ..ball(Reflection::Lambert, sun) };
    let scene = of([0.0, 0.0, -1.0]).scene();
    let stage = studio.stage(scene.clone())?;
    for degrees in PHASES {
        let (sin, cos) = libm::sincos(f64::to_radians(degrees));
        let shot = of(rounded([sin, 0.0, -cos]));
        pictures.push(stage.shoot(&shot)?);
        if degrees == 60.0 {
            middle = Some(shot.command("phase-60.png"));
        }
    }
    let names = PHASES.iter().map(|degrees| format!("{degrees}°")).collect();
    let alt = "Six pictures of a matte ball: lit wholly, then ever less from the left, to a thin \
               crescent.";
    let caption = "The angle between eye and light. The light has intensity 1 and there is no other; \
                   the command draws the third.";
    let mut figure = chapter.picture(&sheet(&[pictures]), "phases.png", alt, caption)?;
    figure.headings = Some([vec![String::new()], names]);
    figure.command = middle;
    chapter.figures(vec![figure]);
    Ok(chapter)
}

/// The exponents of the table.
const EXPONENTS: [f32; 5] = [2.0, 8.0, 32.0, 128.0, 512.0];
/// The light's directions: degrees to the left of the eye.
const SIDES: [f64; 6] = [0.0, 30.0, 60.0, 90.0, 120.0, 150.0];

pub(crate) fn table(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("shininess", "Shininess and the direction of the light");
    chapter.text(
        "Phong's highlight for exponents from 2 to 512 and for light from before the \
         ball to behind it. The exponent doesn't change how bright the middle of the highlight is, \
         only how wide it is: a model that kept the energy would make the narrow ones brighter. \
         To the right a low exponent betrays the model: where N.L ends, the highlight is cut \
         off.",
    );
    let mut rows = Vec::new();
    let mut example = None;
    for shininess in EXPONENTS {
        let mut row = Vec::new();
        let of = |sun| Shot { shininess: Some(shininess), ..ball(Reflection::Phong, sun) };
        let scene = of([0.0, 0.0, -1.0]).scene();
        let stage = studio.stage(scene.clone())?;
        for degrees in SIDES {
            let (sin, cos) = libm::sincos(f64::to_radians(degrees));
            let direction = rounded([sin * 0.94, -0.34, -cos * 0.94]);
            let shot = of(direction);
            row.push(stage.shoot(&shot)?);
            if shininess == 32.0 && degrees == 30.0 {
                example = Some(shot.command("shininess-32-30.png"));
            }
        }
        rows.push(row);
    }
    let exponents = EXPONENTS.iter().map(|n| format!("n = {n}")).collect();
    let sides = SIDES.iter().map(|degrees| format!("{degrees}°")).collect();
    let alt = "A table of thirty glossy balls: highlights become smaller from row to row, and move to \
               the left edge from column to column.";
    let caption = "How far the light stands to the left of the eye, always 20° above; the command draws \
                   n = 32 at 30°.";
    let mut figure = chapter.picture(&sheet(&rows), "shininess.png", alt, caption)?;
    figure.headings = Some([exponents, sides]);
    figure.command = example;
    chapter.figures(vec![figure]);
    Ok(chapter)
}
