//! Highlights that Gouraud shading smears.

use crate::GalleryError;
use crate::chapter::{Chapter, Pair, steps};
use crate::compare::error;
use crate::picture::Picture;
use crate::shot::{Shot, Studio, both, ready};
use luxel::render::ShadingMode;
use luxel::scene::{Scene, demos::lab};

/// Faces around the reference ball.
const REFERENCE: u32 = 256;
/// The exponents of the table.
const EXPONENTS: [f32; 4] = [5.0, 20.0, 60.0, 200.0];
/// The meshes of the table, by faces round.
const FACES: [u32; 4] = [12, 24, 48, 96];
/// The tolerance of the other cure.
const TOLERANCE: f32 = 1.0;

pub(crate) fn chapter(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("chalk", "Gouraud's highlights are chalk");
    chapter.text(
        "Gouraud shading computes light at corners and mixes it between them. Diffuse light changes \
         slowly and bears that. A highlight is as wide as its exponent lets it be: where it is \
         narrower than a polygon it either falls on a corner, and is smeared over all polygons \
         around it in the form of a star, or between corners, and is lost. The ball looks dull, as \
         if of chalk, and flickers when it turns.",
    );
    let cure = Shot::of("lab-highlight");
    let problem = cure.clone().mode(ShadingMode::Gouraud);
    let divided = cure.clone().mode(ShadingMode::Subdivided { tolerance: TOLERANCE });
    let (fine, reference) = truth(studio, &cure, lab::SHININESS)?;
    let scene = cure.scene();
    let covered_by_truth = studio.covered(&cure, &fine)?;
    let inside = both(&studio.covered(&cure, &scene)?, &covered_by_truth);
    let [before, after, pieces] =
        [studio.shoot(&problem)?, studio.shoot(&cure)?, studio.shoot(&divided)?];
    let figures = vec![
        chapter.drawn(
            &problem,
            &before,
            "chalk-problem.png",
            "A brown ball with a dim, angular smear of light.",
            "The problem: lit at the corners (Gouraud).",
        )?,
        chapter.drawn(
            &cure,
            &after,
            "chalk-cure.png",
            "The same ball with a small, round, bright highlight.",
            "The cure: lit at every pixel (Phong).",
        )?,
        chapter.drawn(
            &divided,
            &pieces,
            "chalk-subdivided.png",
            "The same ball, its highlight small, round and bright.",
            &format!(
                "Another cure: Gouraud on triangles divided until it is within {TOLERANCE} step of 255 of Phong."
            ),
        )?,
    ];
    chapter.figures(figures);
    let pictures = [&before, &after];
    let [problem_error, cure_error] =
        chapter.error_pictures("chalk", pictures, &reference, &inside)?;
    chapter.pair(Pair {
        name: "chalk",
        measure: format!(
            "pixels wholly within the outlines of both, against a ball of {REFERENCE} faces round"
        ),
        problem: problem_error,
        cure: cure_error,
        because: None,
    });
    chapter.pair(Pair {
        name: "chalk-subdivided",
        measure: "the same pixels and reference; the cure is Gouraud on divided triangles".into(),
        problem: problem_error,
        cure: error(&pieces, &reference, &inside),
        because: Some(
            "subdivision stops one step of 255 from Phong shading, and inherits Phong's error on \
             this mesh",
        ),
    });

    // The whole table: the narrower the highlight and the larger the polygons, the worse.
    let mut rows = Vec::new();
    let [problem, cure] = [problem, cure].map(|shot| Shot { samples: 4, ..shot });
    let mut truths = Vec::new();
    for shininess in EXPONENTS {
        truths.push(truth(studio, &cure, shininess)?.1);
    }
    for columns in FACES {
        let mut row = vec![columns.to_string()];
        let scene = ready(lab::ball("ball", columns, lab::SHININESS));
        let inside = both(&studio.covered(&cure, &scene)?, &covered_by_truth);
        for (shininess, reference) in EXPONENTS.into_iter().zip(&truths) {
            let scene = ready(lab::ball("ball", columns, shininess));
            let stage = studio.stage(scene.clone())?;
            let [gouraud, phong] = [&problem, &cure].map(|shot| stage.shoot(shot));
            let [gouraud, phong] =
                [gouraud?, phong?].map(|picture| error(&picture, reference, &inside));
            row.push(format!("{} / {}", steps(gouraud.largest), steps(phong.largest)));
        }
        rows.push(row);
    }
    let head: Vec<String> = ["faces round".to_owned()]
        .into_iter()
        .chain(EXPONENTS.map(|shininess| format!("n = {shininess}")))
        .collect();
    let head: Vec<&str> = head.iter().map(String::as_str).collect();
    chapter.table(
        "Largest error of Gouraud / of Phong on the same mesh, in 8-bit steps: the narrower the \
         highlight and the larger the polygons, the worse.",
        &head,
        rows,
    );
    chapter.checked(studio, &problem);
    Ok(chapter)
}

/// A ball so fine that its shading is the true ball's, with its picture.
fn truth(studio: &Studio, shot: &Shot, shininess: f32) -> Result<(Scene, Picture), GalleryError> {
    let fine = ready(lab::ball("ball", REFERENCE, shininess));
    let picture = studio.shoot_scene(shot, &fine)?;
    Ok((fine, picture))
}
