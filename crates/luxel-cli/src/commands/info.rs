//! `luxel info`: the contents of a file.

use crate::camera;
use crate::console::{Console, printable};
use crate::failure::Failure;
use crate::model;
use crate::options::{ExecutionOptions, FrameOptions, InputOptions};
use crate::output;
use clap::Args;
use luxel::scene::{Bounds, Camera, Mesh, Object, Scene};
use std::fmt::Write;

mod json;

/// Summarize a file
///
/// Objects, triangles, bounds, materials, lights and cameras, and the camera that `render` would
/// use with the same flags.
#[derive(Args, Debug)]
pub(crate) struct InfoCommand {
    #[command(flatten)]
    input: InputOptions,

    /// Print a JSON document
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    frame: FrameOptions,
    #[command(flatten)]
    execution: ExecutionOptions,
}

/// Counts for text and JSON.
struct Survey<'a> {
    scene: &'a Scene,
    objects: Vec<(Object, Bounds)>,
    bounds: Bounds,
    vertices: u64,
    points: u64,
    lines: u64,
}

impl InfoCommand {
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        let model = model::load(&self.input, &self.execution, console)?;
        let camera = camera::choose(&self.frame, &model.scene)?;
        let survey = Survey::of(&model.scene);
        if self.json {
            output::print_json(&survey.to_json(&model, &camera, &self.frame))
        } else {
            output::print(&survey.to_text(&self.input.name(), model.format, &camera))
        }
    }
}

impl<'a> Survey<'a> {
    fn of(scene: &'a Scene) -> Self {
        let of_object = |object: Object| {
            let bounds = scene.bounds_of_object(&object);
            (object, bounds)
        };
        let objects: Vec<_> = scene.objects().into_iter().map(of_object).collect();
        let bounds = objects.iter().fold(Bounds::EMPTY, |union, (_, bounds)| union.union(bounds));
        let sum = |count: fn(&Mesh, u32) -> usize| -> u64 {
            let mesh = |object: &Object| &scene.meshes[object.mesh.index()];
            objects.iter().map(|(object, _)| count(mesh(object), object.section) as u64).sum()
        };
        let vertices = sum(|mesh, section| mesh.range_of(section).positions.len());
        let points = sum(|mesh, _| mesh.points.iter().map(|points| points.indices.len()).sum());
        let lines = sum(|mesh, _| mesh.lines.iter().map(|lines| lines.segments.len()).sum());
        Self { scene, objects, bounds, vertices, points, lines }
    }

    fn triangles(&self, object: &Object) -> usize {
        self.scene.meshes[object.mesh.index()].range_of(object.section).triangles.len()
    }

    fn to_text(&self, name: &str, format: &str, camera: &Camera) -> String {
        let mut text = String::new();
        // Writing to a string can't fail.
        let _ = self.write_text(&mut text, name, format, camera);
        text
    }

    fn write_text(
        &self,
        text: &mut String,
        name: &str,
        format: &str,
        camera: &Camera,
    ) -> std::fmt::Result {
        let scene = self.scene;
        writeln!(text, "{}  ({format})", printable(name))?;
        writeln!(text, "triangles  {}", grouped(scene.triangle_count()))?;
        for (what, count) in [("points", self.points), ("lines", self.lines)] {
            if count > 0 {
                writeln!(text, "{what:10} {}", grouped(count))?;
            }
        }
        writeln!(text, "vertices   {}", grouped(self.vertices))?;
        if self.bounds.is_empty() {
            writeln!(text, "bounds     none: there is nothing to draw")?;
        } else {
            let Bounds { min, max } = self.bounds;
            let show = |[x, y, z]: [f64; 3]| format!("{} {} {}", short(x), short(y), short(z));
            let extent = show((max - min).to_array());
            let (min, max) = (show(min.to_array()), show(max.to_array()));
            writeln!(text, "bounds     {min}  to  {max}  (extent {extent})")?;
        }
        let eye = camera.eye().to_array().map(short).join(" ");
        writeln!(text, "eye        {eye}")?;
        if !self.objects.is_empty() {
            writeln!(text, "objects    {}", self.objects.len())?;
            let digits = grouped(scene.triangle_count()).len();
            for (object, _) in &self.objects {
                let triangles = grouped(self.triangles(object) as u64);
                let path = printable(&scene.path(object.node).join(" / "));
                writeln!(text, "  {triangles:>digits$}  {path}")?;
            }
        }
        if !scene.materials.is_empty() {
            writeln!(text, "materials  {}", scene.materials.len())?;
            for material in &scene.materials {
                let model = material.constants.reflection.name();
                writeln!(text, "  {}  ({model})", printable(&material.name))?;
            }
        }
        if !scene.lights.is_empty() {
            writeln!(text, "lights     {}", scene.lights.len())?;
            for light in &scene.lights {
                let kind = light.light.kind.name();
                writeln!(text, "  {}  ({kind})", printable(&light.name))?;
            }
        }
        if !scene.cameras.is_empty() {
            writeln!(text, "cameras    {}", scene.cameras.len())?;
            for camera in &scene.cameras {
                writeln!(text, "  {}", printable(&camera.name))?;
            }
        }
        Ok(())
    }
}

/// An integer with commas between thousands.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::with_capacity(digits.len() * 4 / 3);
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A number rounded to five digits.
fn short(number: f64) -> String {
    if number != 0.0 && !(1e-4..1e6).contains(&number.abs()) {
        return format!("{number:.4e}");
    }
    let whole_digits = if number.abs() < 1.0 { 1 } else { libm::log10(number.abs()) as usize + 1 };
    let text = format!("{number:.*}", 5_usize.saturating_sub(whole_digits));
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_separate_thousands() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(1_000), "1,000");
        assert_eq!(grouped(12_345_678), "12,345,678");
    }

    #[test]
    fn numbers_are_rounded_to_five_digits() {
        assert_eq!(short(0.0), "0");
        assert_eq!(short(-0.094_690_1), "-0.0947");
        assert_eq!(short(548.8), "548.8");
        assert_eq!(short(123_456.7), "123457");
        assert_eq!(short(1e-9), "1.0000e-9");
        assert_eq!(short(1.0), "1");
    }
}
