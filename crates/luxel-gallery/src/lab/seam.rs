//! Corners that only one side of an edge knows.

use crate::GalleryError;
use crate::chapter::{Chapter, Pair};
use crate::shot::{Shot, Studio, ready};
use luxel::render::{Layer, LayerValues, Renderer, ShadingMode};
use luxel::scene::demos::lab::{self, Seam};
use std::sync::Arc;

/// Cells of the reference sheet.
const REFERENCE: u32 = 112;

pub(crate) fn chapter(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("shared-vertices", "Vertices that aren't shared");
    let forgotten = lab::CELLS - 1;
    chapter.text(format!(
        "Along the seam in the middle of this sheet the right half has {forgotten} corners that the polygon \
         on the left doesn't know: T-junctions. The left polygon mixes the colours of the seam's two \
         ends, the right ones have a colour of their own at each corner. Both are right at the ends \
         and disagree between: the seam shows. Here it is straight; where it bends, holes open too."
    ));
    let [problem, cure] = ["lab-t-junction", "lab-t-junction-cured"]
        .map(|demo| Shot::of(demo).mode(ShadingMode::Gouraud));
    let fine = ready(lab::seam("sheet", Seam::Shared, REFERENCE));
    let reference = studio.shoot_scene(&cure, &fine)?;
    let [before, after] = [studio.shoot(&problem)?, studio.shoot(&cure)?];
    let figures = vec![
        chapter.drawn(
            &problem,
            &before,
            "shared-vertices-problem.png",
            "A wavy sheet with a hard vertical line in its middle, bright on its left and dark on its right.",
            "The problem: the left polygon passes the corners on the seam.",
        )?,
        chapter.drawn(
            &cure,
            &after,
            "shared-vertices-cure.png",
            "The same sheet, smooth from left to right.",
            "The cure: both sides share all corners.",
        )?,
    ];
    chapter.figures(figures);
    let counts = beside_seam(studio, &cure)?;
    let pictures = [&before, &after];
    let [problem_error, cure_error] =
        chapter.error_pictures("shared-vertices", pictures, &reference, &counts)?;
    chapter.pair(Pair {
        name: "shared-vertices",
        measure: format!(
            "pixels between the seam and the next corners on its left, against a sheet of {REFERENCE} cells \
             on either side"
        ),
        problem: problem_error,
        cure: cure_error,
        because: None,
    });
    chapter.checked(studio, &problem);
    Ok(chapter)
}

/// Where the polygons are that may or may not know the corners on the seam.
fn beside_seam(studio: &Studio, shot: &Shot) -> Result<Vec<bool>, GalleryError> {
    let scene = Arc::new(shot.scene());
    let renderer = Renderer::new(Arc::clone(&scene), &studio.execution)?;
    let layers = renderer.layers(&shot.view(&scene), &[Layer::Uv])?;
    let Some(LayerValues::F32(uv)) = layers.first() else { return Ok(Vec::new()) };
    let covered = studio.covered(shot, &scene)?;
    // u is 1/2 at the seam.
    let strip = 0.5 - 0.5 / lab::CELLS as f32..=0.5;
    Ok(uv
        .chunks_exact(2)
        .zip(covered)
        .map(|(uv, covered)| covered && strip.contains(&uv[0]))
        .collect())
}
