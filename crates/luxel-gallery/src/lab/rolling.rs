//! A quad that changes its colours as it rolls.

use crate::GalleryError;
use crate::chapter::{Chapter, Pair, steps};
use crate::compare::{Error, error};
use crate::picture::{DENSITY, Picture, animation};
use crate::shot::{Shot, Studio, ready};
use luxel::lighting::{PictureEncoding, encode_srgb};
use luxel::render::Interpolation;
use luxel::scene::{DVec2, Scene, Size, demos::lab};

/// Pictures of a quarter turn.
const PICTURES: u32 = 24;
/// Places within the quad at which colours are compared, along each side.
const PLACES: i32 = 31;
/// Polygons along each side of the reference quad.
const REFERENCE: u32 = 96;
/// Pixels of a side of an animated picture.
const SIDE: u32 = 352;

pub(crate) fn chapter(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("rolling", "Dependence on orientation");
    chapter.text(
        "Scan-line interpolation goes along the edges of a polygon to both ends of a row of pixels, \
         and then along the row. For a polygon of more than three corners it matters which edges a \
         row meets: turn the polygon, and other corners are mixed. The same place of the quad has \
         another colour in every picture, and an object that rolls seems to shimmer.",
    );
    let scan = |demo| Shot::of(demo).interpolation(Interpolation::Scanline);
    let (problem, steady, cut) =
        (scan("lab-rolling"), Shot::of("lab-rolling"), scan("lab-rolling-cured"));
    // An upright quad is bilinear under scan-line interpolation, like so many small quads.
    let bilinear = ready(lab::quad("quad", REFERENCE));

    let mut changes = Vec::new();
    for (shot, file, alt, caption) in [
        (
            &problem,
            "rolling-problem.png",
            "Animation: a square with two bright and two dark corners rolls; a bright band within \
             it swings about as it turns.",
            "The problem: by scan lines.",
        ),
        (
            &steady,
            "rolling-triangles.png",
            "Animation: the same square rolls, its colours fixed to it; a crease runs along one \
             diagonal.",
            "Cured of the change: linear in space over two triangles.",
        ),
        (
            &cut,
            "rolling-cure.png",
            "Animation: the same square rolls, its colours smooth and fixed to it.",
            "Cured of both: by scan lines, over 16 x 16 quads.",
        ),
    ] {
        let (pictures, change) = roll(studio, shot)?;
        changes.push((file, alt, caption, animation(&pictures)?, change));
    }
    chapter.text(format!(
        "{PICTURES} pictures of a quarter turn. At {PLACES} x {PLACES} places of the quad the colour \
         is looked up in each picture and compared with that of the picture before. The places leave \
         out the outer tenth, where pixels are mixed with the background."
    ));
    let mut figures = Vec::new();
    for (file, alt, caption, bytes, change) in &changes {
        let size = Size { width: SIDE / DENSITY, height: SIDE / DENSITY };
        let caption = format!(
            "{caption} Change of colours from picture to picture: largest {}, mean {}.",
            steps(change.largest),
            steps(change.mean)
        );
        figures.push(chapter.file(file, bytes.clone(), size, alt, &caption));
    }
    chapter.figures(figures);
    let [(.., scan_change), (.., steady_change), (.., cut_change)] = &changes[..] else {
        return Ok(chapter);
    };
    chapter.pair(Pair {
        name: "rolling",
        measure:
            "change of the colours at these places from picture to picture, instead of an error; the \
             cure is interpolation in space"
                .into(),
        problem: *scan_change,
        cure: *steady_change,
        because: None,
    });
    chapter.text(
        "Two triangles are steady, but they don't interpolate all four corners: each uses \
         three. Cutting the quad into small ones before rendering cures both, with either \
         interpolation. Compared with the bilinear mixture of the four corners, at a roll of 45 \
         degrees:",
    );
    let tilted = |shot: &Shot| shot.clone().up([-1.0, 1.0]);
    let reference = studio.shoot_scene(&tilted(&steady), &bilinear)?;
    let counts = studio.covered(&tilted(&steady), &bilinear)?;
    let shots = [&problem, &steady, &cut].map(tilted);
    let pictures = [studio.shoot(&shots[0])?, studio.shoot(&shots[1])?, studio.shoot(&shots[2])?];
    let stills = [
        ("rolling-45-problem.png", "By scan lines.", "a dark band lies across it"),
        ("rolling-45-triangles.png", "Two triangles in space.", "a crease runs along a diagonal"),
        ("rolling-45-cure.png", "By scan lines, over 16 x 16 quads.", "its colours are smooth"),
    ];
    let mut figures = Vec::new();
    for ((shot, picture), (file, caption, alt)) in shots.iter().zip(&pictures).zip(stills) {
        let alt = format!("The square standing on a corner; {alt}.");
        figures.push(chapter.drawn(shot, picture, file, &alt, caption)?);
    }
    chapter.figures(figures);
    let errors = pictures.each_ref().map(|picture| error(picture, &reference, &counts));
    chapter.pair(Pair {
        name: "rolling-45",
        measure: format!(
            "pixels wholly within, against a bilinear quad of {REFERENCE} x {REFERENCE} cells; the cure is \
             16 x 16 quads"
        ),
        problem: errors[0],
        cure: errors[2],
        because: None,
    });
    let row = |name: &str, change: &Error, error: &Error| {
        let numbers = [change.largest, change.mean, error.largest, error.mean];
        [name.to_owned()].into_iter().chain(numbers.map(steps)).collect()
    };
    chapter.table(
        "Change from picture to picture, and error at 45 degrees, in 8-bit steps.",
        &["", "largest change", "mean change", "largest error", "mean error"],
        vec![
            row("one quad by scan lines", scan_change, &errors[0]),
            row("two triangles in space", steady_change, &errors[1]),
            row("16 x 16 quads by scan lines", cut_change, &errors[2]),
        ],
    );
    Ok(chapter)
}

/// The pictures of a quarter turn, and how much the colours within change from one to the next.
fn roll(studio: &Studio, shot: &Shot) -> Result<(Vec<Picture>, Error), GalleryError> {
    let scene: Scene = shot.scene();
    let stage = studio.stage(scene.clone())?;
    let mut pictures = Vec::new();
    let mut colors: Vec<Vec<[f64; 3]>> = Vec::new();
    for number in 0..PICTURES {
        let angle = f64::from(number) / f64::from(PICTURES) * std::f64::consts::FRAC_PI_2;
        let (sin, cos) = libm::sincos(angle);
        let shot = shot.clone().size(SIDE, SIDE).up([-sin, cos]);
        let view = shot.view(&scene);
        // Before rounding, so that rounding doesn't count as change.
        let light = stage.renderer.linear(&view)?.pixels;
        let byte = |value: f32| PictureEncoding::Srgb.byte(value);
        let pixels = light.iter().map(|&[r, g, b, _]| [r, g, b].map(byte)).collect();
        let picture = Picture { size: shot.size, pixels };
        let window_of = |place: DVec2| {
            let in_view = view.camera.view_from_world.transform_point3(place.extend(0.0));
            let clip = view.camera.projection.clip_from_view(shot.size);
            let at = clip.project_point3(in_view).truncate() * DVec2::new(0.5, -0.5) + 0.5;
            at * f64::from(SIDE)
        };
        // A margin keeps the outline out.
        let along = |step: i32| f64::from(2 * step - PLACES + 1) / f64::from(PLACES) * 0.9;
        let places = (0..PLACES).flat_map(|y| (0..PLACES).map(move |x| [x, y]));
        let places = places.map(|[x, y]| DVec2::new(along(x), along(y)));
        colors.push(places.map(|place| between_pixels(&light, window_of(place))).collect());
        pictures.push(picture);
    }
    let changes = colors.windows(2).flat_map(|pair| {
        pair[0].iter().zip(&pair[1]).map(|(before, after)| {
            let by = |channel: usize| (before[channel] - after[channel]).abs();
            by(0).max(by(1)).max(by(2))
        })
    });
    Ok((pictures, Error::of(changes)))
}

/// The colour at a place of the window, in 8-bit steps that aren't rounded, from the four pixels
/// whose centres are around it.
fn between_pixels(light: &[[f32; 4]], at: DVec2) -> [f64; 3] {
    let corner = (at - 0.5).floor();
    let part = at - 0.5 - corner;
    let mut sum = [0.0; 3];
    for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let weight = (if dx == 1 { part.x } else { 1.0 - part.x })
            * (if dy == 1 { part.y } else { 1.0 - part.y });
        let [x, y] = [corner.x as i32 + dx, corner.y as i32 + dy]
            .map(|at| at.clamp(0, SIDE as i32 - 1) as usize);
        let pixel = light[y * SIDE as usize + x];
        for (sum, value) in sum.iter_mut().zip(pixel) {
            *sum += weight * 255.0 * encode_srgb(f64::from(value).clamp(0.0, 1.0));
        }
    }
    sum
}
