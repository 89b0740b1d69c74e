//! Interpolated normals that aren't brought to unit length.

use crate::GalleryError;
use crate::chapter::{Chapter, Pair};
use crate::shot::{Shot, Studio, both, ready};
use luxel::render::NormalLength;
use luxel::scene::demos::lab;

/// Faces around the reference ball.
const REFERENCE: u32 = 256;

pub(crate) fn chapter(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("unnormalised", "Vectors left unnormalised");
    // Two unit vectors at the angle between neighbouring corners, and their mean.
    let half_turn = std::f64::consts::PI / f64::from(lab::MIDDLING);
    let shortest = libm::cos(half_turn) * libm::cos(half_turn);
    let highest = 2.0 * shortest * shortest - 1.0;
    let lost = libm::pow(highest, f64::from(lab::SHININESS));
    chapter.text(format!(
        "The mean of two unit vectors is shorter than either. On this ball of {} faces round, the \
         normal in the middle of a face is {shortest:.3} long. N.L is too small by as much, which \
         hardly shows. But N comes into R = 2 N (N.L) - L twice, so that R.V, which should be 1 in \
         the middle of the highlight, is {highest:.2}, and the power n = {} makes {lost:.2} of it. The \
         highlight is left near corners only, as if by Gouraud, although every pixel was lit. One \
         square root cures it.",
        lab::MIDDLING,
        lab::SHININESS
    ));
    let cure = Shot::of("lab-highlight");
    let problem = cure.clone().normal_length(NormalLength::Interpolated);
    let fine = ready(lab::ball("ball", REFERENCE, lab::SHININESS));
    let reference = studio.shoot_scene(&cure, &fine)?;
    let inside = both(&studio.covered(&cure, &cure.scene())?, &studio.covered(&cure, &fine)?);
    let [before, after] = [studio.shoot(&problem)?, studio.shoot(&cure)?];
    let figures = vec![
        chapter.drawn(
            &problem,
            &before,
            "unnormalised-problem.png",
            "A brown ball on which a dim patch is left of the highlight.",
            "The problem: normals as interpolation leaves them.",
        )?,
        chapter.drawn(
            &cure,
            &after,
            "unnormalised-cure.png",
            "The same ball with one round highlight.",
            "The cure: normals of unit length.",
        )?,
    ];
    chapter.figures(figures);
    let pictures = [&before, &after];
    let [problem_error, cure_error] =
        chapter.error_pictures("unnormalised", pictures, &reference, &inside)?;
    chapter.pair(Pair {
        name: "unnormalised",
        measure: format!(
            "pixels wholly within the outlines of both, against a ball of {REFERENCE} faces round with \
             normals of unit length"
        ),
        problem: problem_error,
        cure: cure_error,
        because: Some(
            "near the silhouette, interpolated normals of a ball of few faces deviate from the true \
             ones, whatever their length",
        ),
    });
    Ok(chapter)
}
