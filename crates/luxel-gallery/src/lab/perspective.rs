//! A texture that slides where a surface slants away.

use crate::GalleryError;
use crate::chapter::{Chapter, Pair, steps};
use crate::compare::{Error, error};
use crate::shot::{Shot, Studio, both, ready};
use luxel::render::Interpolation;
use luxel::scene::demos::lab;

/// Polygons along each side of the floor on which the way of interpolating makes no difference.
const REFERENCE: u32 = 160;

pub(crate) fn chapter(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("perspective", "Perspective distortion");
    chapter.text(
        "Half-way between two corners in the window isn't half-way between them in space: the far \
         half of a receding edge takes up less of the window than the near one. Interpolating \
         texture coordinates, colours or normals linearly in the window pretends that it is. The \
         texture slides, and along the diagonal, where the floor's two triangles meet, it breaks. \
         Interpolating u/w and 1/w instead, and dividing at each pixel, is right.",
    );
    let cure = Shot::of("lab-perspective");
    let problem = cure.clone().interpolation(Interpolation::Screen);
    // By the wrong way and from many polygons: nothing of the cure is in it.
    let once = |shot: &Shot| Shot { samples: 1, ..shot.clone() };
    let [problem_once, cure_once] = [&problem, &cure].map(once);
    let fine = ready(lab::floor("floor", REFERENCE));
    let reference = studio.shoot_scene(&problem_once, &fine)?;
    let [before, after] = [studio.shoot(&problem)?, studio.shoot(&cure)?];
    let figures = vec![
        chapter.drawn(
            &problem,
            &before,
            "perspective-problem.png",
            "A chequered floor whose fields bend at the diagonal and don't shrink with distance.",
            "The problem: linear in the window.",
        )?,
        chapter.drawn(
            &cure,
            &after,
            "perspective-cure.png",
            "The same floor, its fields straight and smaller the farther away they are.",
            "The cure: linear in space.",
        )?,
    ];
    chapter.figures(figures);
    let counts = both(&studio.covered(&cure, &cure.scene())?, &studio.covered(&cure, &fine)?);
    let [before, after] = [studio.shoot(&problem_once)?, studio.shoot(&cure_once)?];
    let pictures = [&before, &after];
    let [problem_error, cure_error] =
        chapter.error_pictures("perspective", pictures, &reference, &counts)?;
    chapter.pair(Pair {
        name: "perspective",
        measure: format!(
            "pixels wholly within the outlines of both, lit once, at their centre, against a floor of {REFERENCE} x {REFERENCE} polygons, \
             interpolated in the window"
        ),
        problem: problem_error,
        cure: cure_error,
        because: None,
    });
    let mut rows = Vec::new();
    for cells in [1, 2, 4, 8, 16, 32] {
        let scene = ready(lab::floor("floor", cells));
        let Error { largest, mean } =
            error(&studio.shoot_scene(&problem_once, &scene)?, &after, &counts);
        rows.push(vec![format!("{cells} x {cells}"), steps(largest), steps(mean)]);
    }
    chapter.table(
        "The other cure, that of renderers which couldn't afford a division at each pixel: smaller \
         polygons, still interpolated in the window, compared with the one polygon interpolated in \
         space.",
        &["polygons", "largest error", "mean error"],
        rows,
    );
    chapter.checked(studio, &problem);
    Ok(chapter)
}
