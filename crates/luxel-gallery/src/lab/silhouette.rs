//! A smooth ball with a polygon for an outline.

use crate::GalleryError;
use crate::chapter::{Chapter, Pair, steps};
use crate::compare::{Error, error};
use crate::shot::{Shot, Studio, ready};
use luxel::scene::demos::lab;

/// Faces around the reference ball: its silhouette is off by 0.004 pixels.
const REFERENCE: u32 = 384;

pub(crate) fn chapter(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("silhouette", "The polygonal silhouette");
    chapter.text(
        "Phong shading makes a ball of few polygons look round, because it interpolates the \
         normals and shades every pixel inside as if the surface were curved. The silhouette \
         doesn't benefit: it follows the polygons and stays a polygon. No work per pixel helps; \
         the mesh needs more polygons where the surface turns away.",
    );
    let [problem, cure] = ["lab-silhouette", "lab-silhouette-cured"].map(Shot::of);
    let reference = studio.shoot_scene(&problem, &ready(lab::ball("ball", REFERENCE, 20.0)))?;
    let [before, after] = [studio.shoot(&problem)?, studio.shoot(&cure)?];
    let figures = vec![
        chapter.drawn(
            &problem,
            &before,
            "silhouette-problem.png",
            "A glossy brown ball, smoothly shaded, its outline visibly made of straight pieces.",
            &format!("The problem: {} faces round.", lab::COARSE),
        )?,
        chapter.drawn(
            &cure,
            &after,
            "silhouette-cure.png",
            "The same ball with a round outline.",
            &format!("The cure: {} faces round.", lab::FINE),
        )?,
    ];
    chapter.figures(figures);
    let counts = vec![true; reference.pixels.len()];
    let pictures = [&before, &after];
    let [problem_error, cure_error] =
        chapter.error_pictures("silhouette", pictures, &reference, &counts)?;
    chapter.pair(Pair {
        name: "silhouette",
        measure: format!("all pixels, against a ball of {REFERENCE} faces round"),
        problem: problem_error,
        cure: cure_error,
        because: Some(
            "at the outline one or two of a pixel's 16 samples more or less meet the ball, and on dark \
             ground the first ones change it most",
        ),
    });
    let mut rows = Vec::new();
    for columns in [12, 24, 48, 96, 192] {
        let scene = ready(lab::ball("ball", columns, 20.0));
        let Error { largest, mean } =
            error(&studio.shoot_scene(&problem, &scene)?, &reference, &counts);
        let triangles = scene.triangle_count().to_string();
        rows.push(vec![columns.to_string(), triangles, steps(largest), steps(mean)]);
    }
    chapter.table(
        "Twice as many faces round take the outline four times as near to the circle: the sagitta \
         of an arc falls with the square of its length. The largest error falls more slowly at \
         first, as a pixel can't be more wrong than wholly.",
        &["faces round", "triangles", "largest error", "mean error"],
        rows,
    );
    chapter.checked(studio, &problem);
    Ok(chapter)
}
