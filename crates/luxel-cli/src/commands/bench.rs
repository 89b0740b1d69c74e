//! `luxel bench`: timings of frames and picks.

use super::pick::check_memory;
use crate::camera;
use crate::console::Console;
use crate::failure::Failure;
use crate::model;
use crate::options::{InputOptions, ViewOptions};
use crate::output;
use crate::surface;
use crate::view;
use clap::Args;
use luxel::math::SimdLevel;
use luxel::pick::{PhysicalPosition, PickError, PickView, Picker, Quality};
use luxel::render::{Layer, Picture, RenderError, Renderer, View};
use luxel::scene::{Camera, Scene, Size};
use serde_json::{Value, json};
use std::fmt::Write;
use std::hint::black_box;
use std::num::NonZeroU32;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Time frames of an orbiting camera
///
/// Each frame is rendered from scratch to 8-bit pixels in memory, from another side than the one
/// before. Then positions in the image are picked, with the tree built. For example: luxel bench
/// model.ply --size 1920x1080 --samples 1 --frames 100
#[derive(Args, Debug)]
pub(crate) struct BenchCommand {
    #[command(flatten)]
    input: InputOptions,

    /// Number of timed frames; a tenth as many warm up first
    #[arg(long, value_name = "N", default_value = "60")]
    frames: NonZeroU32,

    /// Keep the camera still; luxel still renders every frame in full
    #[arg(long)]
    still: bool,

    /// Also time frames with this layer; may be repeated
    #[arg(long = "layer", value_name = "NAME")]
    layers: Vec<Layer>,

    /// Print a JSON document
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    view: ViewOptions,
}

/// The measurements, in milliseconds.
struct Timings {
    frames: Vec<f64>,
    stages: [(&'static str, Vec<f64>); 3],
}

impl BenchCommand {
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        let mut model = model::load(&self.input, &self.view.execution, console)?;
        surface::apply_material(&self.view.material, &mut model.scene);
        surface::apply_normals(&self.view.shading, &mut model.scene);
        let scene = &Arc::new(model.scene);
        let renderer = Renderer::new(Arc::clone(scene), &view::execution(&self.view.execution))?;

        let sides = if self.still { 1 } else { self.frames.get() };
        let cameras = camera::turntable(&self.view.frame, scene, sides)?;
        let mut views = cameras
            .into_iter()
            .map(|camera| view::view(&self.view, None, camera, scene))
            .collect::<Result<Vec<_>, _>>()?;
        if let Some(said) = view::expose(&mut views[0], &self.view, scene) {
            console.notice(&said);
            let exposure = views[0].exposure;
            views.iter_mut().for_each(|view| view.exposure = exposure);
        }

        let timings = renderer.install(|| self.time_frames(&renderer, &views))?;

        let picks = self.picks(scene, views[0].camera)?;
        let simd = SimdLevel::name_of(renderer.level());
        let Size { width, height } = self.view.frame.size;
        if self.json {
            let mut report = timings.to_json();
            report["pick_us"] = json!(picks.median);
            report["threads"] = json!(renderer.threads());
            report["simd"] = json!(simd);
            report["triangles"] = json!(scene.triangle_count());
            report["size"] = json!([width, height]);
            report["samples"] = json!(self.view.frame.samples);
            report["layers"] = self.layers.iter().map(Layer::name).collect();
            return output::print_json(&report);
        }
        let mut text = format!(
            "{}: {} triangles, {width}x{height}, samples {}, threads {}, {simd}\n",
            self.input.name(),
            scene.triangle_count(),
            self.view.frame.samples,
            renderer.threads(),
        );
        text.push_str(&timings.to_text());
        // Writing to a string can't fail.
        let _ = writeln!(text, "pick        {:9.3} us median, one at a time", picks.median);
        output::print(&text)
    }

    /// Renders the views in turn.
    fn time_frames(&self, renderer: &Renderer, views: &[View]) -> Result<Timings, RenderError> {
        let (mut picture, mut values) = (Picture::default(), Vec::new());
        let mut timings = Timings::new();
        let warm_up = self.frames.get().div_ceil(10);
        for number in 0..warm_up + self.frames.get() {
            let view = &views[number as usize % views.len()];
            let start = Instant::now();
            if self.layers.is_empty() {
                renderer.rgba8_into(view, &mut picture)?;
            } else {
                renderer.rgba8_with_layers(view, &self.layers, &mut picture, &mut values)?;
            }
            let elapsed = start.elapsed();
            if number >= warm_up {
                timings.add(elapsed, &picture.stages);
            }
        }
        Ok(timings)
    }

    /// Microseconds of a pick that hits, with the complete answer.
    fn picks(&self, scene: &Arc<Scene>, camera: Camera) -> Result<Spread, Failure> {
        let failed = |error: PickError| Failure::work(error.to_string(), "");
        check_memory(scene, Quality::Thorough, self.view.execution.max_memory)?;
        let picker = Picker::with(Arc::clone(scene), Quality::Thorough, self.view.execution.simd)
            .map_err(failed)?;
        let size = self.view.frame.size;
        let view =
            PickView::new(&picker, camera, size, self.view.frame.cull.into()).map_err(failed)?;
        let mut times = [Vec::new(), Vec::new()];
        for number in 0..PICKS {
            // Prime steps spread the positions, far from one another.
            let place = PhysicalPosition::centre_of(
                number.wrapping_mul(7919) % size.width,
                number.wrapping_mul(104_729) % size.height,
            );
            let start = Instant::now();
            let hit = black_box(view.at(place));
            times[usize::from(hit.is_some())].push(start.elapsed().as_secs_f64() * 1e6);
        }
        let [missed, hit] = times;
        Ok(Spread::of(if hit.is_empty() { &missed } else { &hit }))
    }
}

/// Number of positions to pick.
const PICKS: u32 = 4000;

impl Timings {
    fn new() -> Self {
        let stage = |name| (name, Vec::new());
        let stages = [stage("bin"), stage("visibility"), stage("shade")];
        Self { frames: Vec::new(), stages }
    }

    fn add(&mut self, frame: Duration, stages: &luxel::render::Stages) {
        self.frames.push(milliseconds(frame));
        let times = [stages.bin, stages.visibility, stages.shade];
        for ((_, list), time) in self.stages.iter_mut().zip(times) {
            list.push(milliseconds(time));
        }
    }

    /// Stages other than `bin` are summed over threads.
    fn to_json(&self) -> Value {
        let frames = Spread::of(&self.frames);
        let stages: Value = self
            .stages
            .iter()
            .map(|(name, times)| ((*name).to_owned(), json!(Spread::of(times).median)))
            .collect::<serde_json::Map<_, _>>()
            .into();
        json!({
            "frame_ms": { "min": frames.least, "median": frames.median, "p95": frames.p95 },
            "stages_ms": stages,
            "frames": self.frames.len(),
        })
    }

    fn to_text(&self) -> String {
        let frames = Spread::of(&self.frames);
        let mut text = format!(
            "frame       {:9.3} ms median of {} ({:.3} least, {:.3} 95th percentile)\n",
            frames.median,
            self.frames.len(),
            frames.least,
            frames.p95,
        );
        for (name, times) in &self.stages {
            let note = if *name == "bin" { "" } else { ", summed over threads" };
            // Writing to a string can't fail.
            let _ = writeln!(text, "{name:<11} {:9.3} ms median{note}", Spread::of(times).median);
        }
        text
    }
}

/// The distribution of times.
struct Spread {
    least: f64,
    median: f64,
    p95: f64,
}

impl Spread {
    fn of(times: &[f64]) -> Self {
        let mut sorted = times.to_vec();
        sorted.sort_by(f64::total_cmp);
        let at = |part: f64| {
            let place = (sorted.len().saturating_sub(1) as f64 * part).round() as usize;
            sorted.get(place).copied().unwrap_or_default()
        };
        Self { least: at(0.0), median: at(0.5), p95: at(0.95) }
    }
}

/// Milliseconds to the microsecond.
fn milliseconds(duration: Duration) -> f64 {
    (duration.as_secs_f64() * 1e6).round() / 1e3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_the_middle_and_the_95th_percentile_near_the_end() {
        let spread = Spread::of(&(0..=100).rev().map(f64::from).collect::<Vec<_>>());
        assert_eq!((spread.least, spread.median, spread.p95), (0.0, 50.0, 95.0));
    }
}
