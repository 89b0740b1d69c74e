//! Light that something keeps away: shadows, openness, and the edge of triangles in their own shadow.

use crate::GalleryError;
use crate::chapter::{Chapter, Pair, steps};
use crate::compare::{Error, error};
use crate::picture::Picture;
use crate::shot::{Shot, Studio, both, ready};
use luxel::scene::{Size, demos::lab};

/// Faces around the reference ball of the terminator.
const REFERENCE: u32 = 384;
/// The rays of the references of openness and of soft shadows.
const MANY_RAYS: u32 = 256;
/// The sun of the soft shadow, and the angle under which it is seen, in degrees.
const SUN: [f64; 3] = [0.55, -1.0, -0.35];
const ANGLE: f64 = 12.0;

pub(crate) fn chapter(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("shadow", "Shadow and openness");
    chapter.text(
        "The lighting equation is local: it knows the surface and the lights, and not what else is \
         there. One of these balls touches the board. Without shadows nothing tells which.",
    );
    contact(studio, &mut chapter)?;
    chapter.text(
        "A sun without an extent casts a shadow with a hard edge everywhere. A sun that is seen under \
         an angle casts one that is hard where the ball touches the board, and the softer the \
         farther away it is. Its rays go to places on the sun's disc, another set for every pixel.",
    );
    softness(studio, &mut chapter)?;
    chapter.text(
        "Shadows bring a problem of their own. Interpolated normals turn away from the light slowly, \
         triangles at once: along the terminator, a triangle that turns away shades itself, though its \
         normals still face the light, and the light ends in steps along the edges of the mesh. Rays that \
         leave there from the curved surface, for which the triangles stand, miss them (Hanika, \
         <cite>Hacking the Shadow Terminator</cite>, 2021).",
    );
    terminator(studio, &mut chapter)?;
    Ok(chapter)
}

/// Which ball stands on the board.
fn contact(studio: &Studio, chapter: &mut Chapter) -> Result<(), GalleryError> {
    let problem = Shot::of("lab-contact");
    let cure = problem.clone().occluded();
    let reference = studio.shoot(&Shot { rays: MANY_RAYS, ..cure.clone() })?;
    let [before, after] = [studio.shoot(&problem)?, studio.shoot(&cure)?];
    let figures = vec![
        chapter.drawn(
            &problem,
            &before,
            "contact-problem.png",
            "A red and a blue ball before a light board; neither can be said to stand on it.",
            "The problem: local light.",
        )?,
        chapter.drawn(
            &cure,
            &after,
            "contact-cure.png",
            "The same with shadows: that of the red ball begins under it, that of the blue one lies aside.",
            "The cure: shadows and openness.",
        )?,
    ];
    chapter.figures(figures);
    let counts = vec![true; reference.pixels.len()];
    let [problem, cure] =
        chapter.error_pictures("contact", [&before, &after], &reference, &counts)?;
    chapter.pair(Pair {
        name: "contact",
        measure: format!("all pixels, against openness of {MANY_RAYS} rays"),
        problem,
        cure,
        because: None,
    });
    Ok(())
}

/// Hard and soft shadows, and what more rays do.
fn softness(studio: &Studio, chapter: &mut Chapter) -> Result<(), GalleryError> {
    let hard = Shot { sun: Some(SUN), shadows: true, ..Shot::of("lab-contact") };
    let soft = Shot { angle: Some(ANGLE), ..hard.clone() };
    let figures = vec![
        {
            let picture = studio.shoot(&hard)?;
            let alt = "Both balls with black shadows of sharp outlines.";
            chapter.drawn(&hard, &picture, "shadow-hard.png", alt, "A sun without an extent.")?
        },
        {
            let picture = studio.shoot(&soft)?;
            let alt = "The same; the shadow of the floating ball fades towards its edge.";
            let caption = format!("A sun seen under {ANGLE} degrees.");
            chapter.drawn(&soft, &picture, "shadow-soft.png", alt, &caption)?
        },
    ];
    chapter.figures(figures);
    let small = soft.size(320, 240);
    let reference = studio.shoot(&Shot { light_rays: MANY_RAYS, ..small.clone() })?;
    let counts = vec![true; reference.pixels.len()];
    let mut rows = Vec::new();
    for light_rays in [1, 4, 16, 64] {
        let picture = studio.shoot(&Shot { light_rays, ..small.clone() })?;
        let Error { largest, mean } = error(&picture, &reference, &counts);
        rows.push(vec![light_rays.to_string(), steps(largest), steps(mean)]);
    }
    chapter.table(
        &format!(
            "Error by the rays to the sun, against {MANY_RAYS}: four times as many halve it, or better, \
             as their places are evenly spread."
        ),
        &["--light-rays", "largest error", "mean error"],
        rows,
    );
    Ok(())
}

/// The light's end on a coarse ball.
fn terminator(studio: &Studio, chapter: &mut Chapter) -> Result<(), GalleryError> {
    let cure = Shot { shadows: true, samples: 1, ..Shot::of("lab-terminator") };
    let fine = ready(lab::terminator("ball", REFERENCE));
    let reference = studio.shoot_scene(&cure, &fine)?;
    let stage = studio.stage(cure.scene())?;
    let inside = both(&stage.covered(&cure)?, &studio.covered(&cure, &fine)?);
    let [before, after] = [stage.shoot_without_terminator(&cure)?, stage.shoot(&cure)?];
    let figures = vec![
        chapter.picture(
            &before,
            "terminator-problem.png",
            "A ball lit from the left, its dark side beginning at straight edges of triangles.",
            "The problem: shadows as the triangles cast them (from the terms of the ledger).",
        )?,
        chapter.drawn(
            &cure,
            &after,
            "terminator-cure.png",
            "The same ball; the light fades evenly towards its dark side.",
            "The cure: rays from the curved surface.",
        )?,
    ];
    chapter.figures(figures);
    let rows = [
        ("as the triangles cast them", &before),
        ("rays from the curved surface", &after),
        ("the true ball", &reference),
    ];
    let rows = rows.map(|(name, picture)| {
        let off = error(picture, &reference, &inside);
        vec![name.to_owned(), steps(largest_jump(picture, &inside)), steps(off.mean)]
    });
    chapter.table(
        &format!(
            "The largest difference between neighbouring pixels, and the mean error against a ball of {REFERENCE} \
             faces round, in pixels wholly within the outlines of both."
        ),
        &["shadows", "largest jump", "mean error"],
        rows.into(),
    );
    Ok(())
}

/// The largest difference of a pixel to the one on its right or below it, in 8-bit steps.
fn largest_jump(picture: &Picture, counts: &[bool]) -> f64 {
    let Size { width, height } = picture.size;
    let mut largest = 0;
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        for (right, down) in [(x + 1, y), (x, y + 1)] {
            let counted = |x: u32, y: u32| counts[(y * width + x) as usize];
            if right >= width || down >= height || !counted(x, y) || !counted(right, down) {
                continue;
            }
            for (one, other) in picture.at(x, y).into_iter().zip(picture.at(right, down)) {
                largest = largest.max(one.abs_diff(other));
            }
        }
    }
    f64::from(largest)
}
