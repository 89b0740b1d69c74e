//! Vertex normals that don't represent the surface between them.

use crate::GalleryError;
use crate::chapter::{Chapter, Pair};
use crate::shot::{Shot, Studio, ready};
use luxel::render::ShadingMode;
use luxel::scene::{NormalSource, demos::lab};

/// Polygons along each side of the reference panel.
const REFERENCE: u32 = 160;

pub(crate) fn missed_geometry(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("missed-geometry", "Unrepresentative normals: missed geometry");
    chapter.text(
        "A vertex normal is the average of the normals of the faces around it. On a sheet that is \
         folded up and down in turns every average points straight up: the folds cancel, every pixel \
         gets the same light, and the sheet is drawn flat. Only its outline gives it away. Either the \
         averages must not go across sharp edges, which is what luxel does when it computes normals, \
         or the slopes must be cut before they are averaged, so that only narrow stripes along the \
         folds are wrong.",
    );
    let problem = Shot::of("lab-corrugated");
    let cure = Shot { normals: NormalSource::Mean, ..problem.clone() };
    // By the polygons' own normals, without any at the vertices.
    let reference = studio.shoot(&problem.clone().mode(ShadingMode::Flat))?;
    let [before, after] = [studio.shoot(&problem)?, studio.shoot(&cure)?];
    let figures = vec![
        chapter.drawn(
            &problem,
            &before,
            "missed-geometry-problem.png",
            "A blue-grey sheet of one even colour, with a zigzag for an edge.",
            "The problem: the model's own normals, averaged over all faces around a corner.",
        )?,
        chapter.drawn(
            &cure,
            &after,
            "missed-geometry-cure.png",
            "The same sheet with bright and dark slopes in turns.",
            "The cure: averages don't go across edges of more than 40 degrees.",
        )?,
    ];
    chapter.figures(figures);
    let counts = vec![true; reference.pixels.len()];
    let pictures = [&before, &after];
    let [problem_error, cure_error] =
        chapter.error_pictures("missed-geometry", pictures, &reference, &counts)?;
    chapter.pair(Pair {
        name: "missed-geometry",
        measure: "all pixels, against the polygons' own normals".into(),
        problem: problem_error,
        cure: cure_error,
        because: None,
    });
    Ok(chapter)
}

pub(crate) fn missed_highlight(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter =
        Chapter::new("missed-highlight", "Unrepresentative normals: missed highlight");
    chapter.text(
        "A lamp is close to a glossy panel of one polygon. None of the four corners reflects it \
         to the eye, and Gouraud shading evaluates light nowhere else: the interpolation of \
         four dim corners is dim everywhere. Phong shading evaluates every pixel.",
    );
    let cure = Shot::of("lab-lamp");
    let problem = cure.clone().mode(ShadingMode::Gouraud);
    let reference = studio.shoot_scene(&problem, &ready(lab::panel("panel", REFERENCE)))?;
    let [before, after] = [studio.shoot(&problem)?, studio.shoot(&cure)?];
    let figures = vec![
        chapter.drawn(
            &problem,
            &before,
            "missed-highlight-problem.png",
            "A teal panel, dull, without any highlight.",
            "The problem: lit at four corners.",
        )?,
        chapter.drawn(
            &cure,
            &after,
            "missed-highlight-cure.png",
            "The same panel with a pool of light and a white highlight in it.",
            "The cure: lit at every pixel.",
        )?,
    ];
    chapter.figures(figures);
    let counts = vec![true; reference.pixels.len()];
    let pictures = [&before, &after];
    let [problem_error, cure_error] =
        chapter.error_pictures("missed-highlight", pictures, &reference, &counts)?;
    chapter.pair(Pair {
        name: "missed-highlight",
        measure: format!(
            "all pixels, against a panel of {REFERENCE} x {REFERENCE} polygons lit at their corners"
        ),
        problem: problem_error,
        cure: cure_error,
        because: None,
    });
    Ok(chapter)
}
