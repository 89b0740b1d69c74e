//! Mach bands: the perception of steps and kinks.

use crate::GalleryError;
use crate::chapter::{Chapter, Pair, steps};
use crate::compare::{Error, error};
use crate::shot::{Shot, Studio, both, ready};
use crate::svg::{Anchor, Axes, Ink, Svg};
use luxel::render::{Renderer, ShadingMode};
use luxel::scene::{Scene, demos::lab};
use std::collections::BTreeMap;

/// Faces around the reference column.
const REFERENCE: u32 = 360;

/// The intensity along a row.
struct Row {
    /// Pixels of the row, with the light that they send.
    values: Vec<[f64; 2]>,
}

impl Row {
    /// How much the intensity changes from each pixel to the next.
    fn slopes(&self) -> Vec<[f64; 2]> {
        let slope = |pair: &[[f64; 2]]| [pair[0][0] + 0.5, pair[1][1] - pair[0][1]];
        self.values.windows(2).map(slope).collect()
    }

    /// How much more the slope changes from pixel to pixel than along the true column: what the
    /// eye sees as a band.
    fn kinks(&self, truth: &Self) -> Error {
        let changes = |row: &Self| -> Vec<(i32, f64)> {
            let slopes = row.slopes();
            let change = |pair: &[[f64; 2]]| (pair[1][0].round() as i32, pair[1][1] - pair[0][1]);
            slopes.windows(2).map(change).collect()
        };
        let of_truth: BTreeMap<i32, f64> = changes(truth).into_iter().collect();
        let more = changes(self).into_iter().filter_map(|(x, change)| {
            of_truth.get(&x).map(|of_truth| (change - of_truth).abs() * 255.0)
        });
        Error::of(more)
    }

    /// The places between which something lies that is cut off by so much at both sides, in parts
    /// of the row's width.
    fn without(&self, part: f64) -> [f64; 2] {
        let from = self.values.first().map_or(0.0, |value| value[0]);
        let to = self.values.last().map_or(0.0, |value| value[0]);
        [from + (to - from) * part, to - (to - from) * part]
    }

    fn middle_half(&self) -> [f64; 2] {
        self.without(0.25)
    }

    /// All but a margin: at the outline even the true column has kinks.
    fn off_outline(&self) -> [f64; 2] {
        self.without(0.05)
    }

    fn within(&self, [from, to]: [f64; 2]) -> Self {
        let is_within = |value: &&[f64; 2]| (from..=to).contains(&value[0]);
        Self { values: self.values.iter().filter(is_within).copied().collect() }
    }
}

/// The light along the middle row, one sample a pixel, where the scene is.
fn middle_row(studio: &Studio, shot: &Shot, scene: &Scene) -> Result<Row, GalleryError> {
    let view = shot.view(scene).with_samples(1).with_background([0.0; 4]);
    let picture = Renderer::new(scene.clone(), &studio.execution)?.linear(&view)?;
    let width = picture.size.width as usize;
    let row = picture.pixels.chunks_exact(width).nth(picture.size.height as usize / 2);
    let pixels = row.unwrap_or_default().iter().enumerate().filter(|(_, pixel)| pixel[3] > 0.0);
    let values = pixels.map(|(x, pixel)| [x as f64 + 0.5, f64::from(pixel[1])]).collect();
    Ok(Row { values })
}

pub(crate) fn chapter(studio: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("mach-bands", "Mach bands");
    chapter.text(
        "The eye amplifies contrast. Next to a step of intensity it sees a dark band on the \
         dark side and a bright one on the bright side (Mach 1865), and at a kink, where the \
         slope of the intensity changes abruptly, it sees a band along the kink. A faceted \
         column has steps. Gouraud shading replaces the steps by a kink at every edge: the \
         bands stay, and show the mesh. Phong shading keeps the slope nearly continuous.",
    );
    let cure = Shot::of("lab-mach");
    let [flat, gouraud] =
        [ShadingMode::Flat, ShadingMode::Gouraud].map(|mode| cure.clone().mode(mode));
    let [steps_picture, before, after] =
        [studio.shoot(&flat)?, studio.shoot(&gouraud)?, studio.shoot(&cure)?];
    let figures = vec![
        chapter.drawn(
            &flat,
            &steps_picture,
            "mach-bands-flat.png",
            "A grey column of upright stripes, each of one brightness.",
            "Flat: steps.",
        )?,
        chapter.drawn(
            &gouraud,
            &before,
            "mach-bands-problem.png",
            "The same column, smooth but for bright and dark lines along its edges.",
            "The problem, Gouraud: kinks.",
        )?,
        chapter.drawn(
            &cure,
            &after,
            "mach-bands-cure.png",
            "The same column, smooth.",
            "The cure, Phong.",
        )?,
    ];
    chapter.figures(figures);

    let scene = cure.scene();
    let fine = ready(lab::column("column", REFERENCE));
    let rows = [
        ("flat", middle_row(studio, &flat, &scene)?),
        ("Gouraud", middle_row(studio, &gouraud, &scene)?),
        ("Phong", middle_row(studio, &cure, &scene)?),
        ("true column", middle_row(studio, &cure, &fine)?),
    ];
    let mut figures = Vec::new();
    for (row, file) in rows.iter().zip(["flat", "gouraud", "phong"]) {
        let svg = plot(row, &rows[3].1);
        let size = svg.size;
        let title = format!("Intensity and slope across the column, {}", row.0);
        let alt = match file {
            "flat" => "Plot across the column: intensity in steps, slope zero with spikes.",
            "gouraud" => "Plot across the column: intensity in straight pieces, slope in steps.",
            _ => {
                "Plot across the column: intensity a smooth arc, slope nearly that of the true one."
            }
        };
        let name = format!("mach-bands-{file}.svg");
        let caption = format!("{}: intensity and its slope along the middle row.", row.0);
        figures.push(chapter.file(&name, svg.finish(&title), size, alt, &caption));
    }
    chapter.figures(figures);
    chapter.text(
        "Coloured: what is drawn; thin and grey: the true column. The slope is the change from one \
         pixel to the next. Where it jumps, the eye sees a band.",
    );

    let reference = studio.shoot_scene(&cure, &fine)?;
    let whole = both(&studio.covered(&cure, &scene)?, &studio.covered(&cure, &fine)?);
    let truth = &rows[3].1;
    let [from, to] = truth.middle_half();
    let width = cure.size.width as usize;
    let is_middle = |at: usize| (from..=to).contains(&((at % width) as f64 + 0.5));
    let middle: Vec<_> =
        whole.iter().enumerate().map(|(at, &counts)| counts && is_middle(at)).collect();
    let pictures = [&steps_picture, &before, &after];
    let errors =
        [&middle, &whole].map(|counts| pictures.map(|picture| error(picture, &reference, counts)));
    let kinks = [truth.middle_half(), truth.off_outline()].map(|range| {
        [0, 1, 2].map(|at: usize| rows[at].1.within(range).kinks(&truth.within(range)))
    });
    chapter.pair(Pair {
        name: "mach-bands",
        measure: format!(
            "pixels of the middle half of the column and wholly within it, against a column of \
             {REFERENCE} faces"
        ),
        problem: errors[0][1],
        cure: errors[0][2],
        because: Some(
            "rounding both pictures to 8 bits makes an error of up to one step by itself",
        ),
    });
    chapter.pair(Pair {
        name: "mach-bands-kinks",
        measure:
            "kinks there, instead of errors: change of the slope from pixel to pixel along the middle \
             row, less that of the true column, in 1/255 of white"
                .into(),
        problem: kinks[0][1],
        cure: kinks[0][2],
        because: None,
    });
    let row = |at: usize, name: &str| {
        let numbers = [errors[0][at], kinks[0][at], errors[1][at], kinks[1][at]];
        let cells = numbers.map(|error| steps(error.largest));
        [name.to_owned()].into_iter().chain(cells).collect()
    };
    chapter.table(
        "Largest error and largest kink, in the middle half of the column and in all of it; kinks \
         without 5 % of its width at both sides, as the true column has one at its outline.",
        &["", "error, middle", "kink, middle", "error, whole", "kink, whole"],
        vec![row(0, "flat"), row(1, "Gouraud"), row(2, "Phong")],
    );
    let [near, far] = [30.0_f64, 60.0].map(|degrees| libm::cos(degrees.to_radians()));
    chapter.text(format!(
        "Over the whole column, Phong shading is hardly better than Gouraud's. The face that is turned away by 60 degrees is \
         {:.2} times as wide in the window as its neighbour at 30 degrees, so that the normal turns \
         {:.1} times as fast on it: the slope keeps a kink, and only more faces help.",
        far / near,
        near / far
    ));
    Ok(chapter)
}

/// Intensity above, slope below.
fn plot((name, row): &(&str, Row), truth: &Row) -> Svg {
    let mut svg = Svg::new(320, 330);
    let x = [
        truth.values.first().map_or(0.0, |value| value[0]),
        truth.values.last().map_or(1.0, |value| value[0]),
    ];
    let intensity = Axes { frame: [44.0, 34.0, 304.0, 170.0], x, y: [0.0, 0.8] };
    intensity.draw(&mut svg, &[], &[(0.0, "0"), (0.4, "0.4"), (0.8, "0.8")], ["", "intensity"]);
    intensity.curve(&mut svg, Ink::Quiet, 1.0, &truth.values);
    intensity.curve(&mut svg, Ink::Blue, 2.0, &row.values);
    svg.text(Ink::Blue, Anchor::End, [304.0, 22.0], name);
    let slope = Axes { frame: [44.0, 214.0, 304.0, 292.0], x, y: [-0.01, 0.01] };
    let ticks = [(-0.01, "-0.01"), (0.0, "0"), (0.01, "0.01")];
    slope.draw(&mut svg, &[], &ticks, ["across the column, pixels", "slope"]);
    slope.curve(&mut svg, Ink::Quiet, 1.0, &truth.slopes());
    slope.curve(&mut svg, Ink::Amber, 1.5, &row.slopes());
    svg
}
