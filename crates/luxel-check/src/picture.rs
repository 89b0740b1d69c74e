//! A picture of findings: marks that are seen on bright and on dark ground, and a legend.

use crate::canvas::Canvas;
use crate::finding::Kind;
use crate::lettering::{ADVANCE, ASCENT, HEIGHT, text_lines};
use crate::report::{Report, Spot};
use crate::sight::Sight;
use luxel_render::{Layer, LayerValues, Picture, RenderError, Renderer, View};
use luxel_scene::{Scene, Size};
use std::collections::HashSet;

/// Around marks, and behind the legend.
const DARK: [u8; 3] = [0x15, 0x17, 0x1a];
/// The legend's text.
const TEXT: [u8; 3] = [0xe8, 0xe6, 0xe1];
/// How much of the picture the legend's ground hides.
const GROUND: f32 = 0.92;

/// Sizes in pixels of a picture whose shorter side is 480; they grow with it.
const LINE: f64 = 2.5;
const POINT: f64 = 7.0;
/// The dark rim on each side of a mark.
const RIM: f64 = 1.75;
/// The unit of letters, and the width of their strokes.
const UNIT: f64 = 0.8;
const STROKE: f64 = 1.3;
/// From one line of the legend to the next.
const ROW: f64 = 18.0;
/// Around the legend's text, and around the legend.
const MARGIN: f64 = 9.0;
/// A sample of a mark.
const SWATCH: f64 = 12.0;

/// How large marks and letters are in a picture.
fn scale(size: Size) -> f64 {
    (f64::from(size.width.min(size.height)) / 480.0).max(0.75)
}

/// What is marked of a kind.
struct Marks {
    kind: Kind,
    count: u64,
    shape: Spot,
    /// What is seen, in pixels.
    lines: Vec<[[f64; 2]; 2]>,
}

impl Marks {
    fn width(&self, scale: f64) -> f64 {
        scale * if matches!(self.shape, Spot::Vertex(..)) { POINT } else { LINE }
    }
}

impl Report {
    /// A picture of a scene with findings marked: `marked` draws what [`Report::marked_only`] made
    /// of the scene and the kinds. Edges and vertices have dark rims, and a legend lists the kinds with
    /// their counts in the corner where it hides least, if there is room.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub fn picture(
        &self,
        scene: &Scene,
        only: &[Kind],
        marked: &Renderer,
        view: &View,
    ) -> Result<Picture<[u8; 4]>, RenderError> {
        let scene = &*scene.separated();
        let mut picture = marked.rgba8(view)?;
        let layers = marked.layers(view, &[Layer::Z, Layer::Object])?;
        let [LayerValues::F32(distances), LayerValues::U32(objects)] = &*layers else {
            return Ok(picture);
        };
        let sight = Sight::new(view.camera, view.size, distances);
        let kinds = self.marks(scene, only, &sight);
        // Marks are the first objects. Where marked triangles lie close together, rims between them
        // would hide them.
        let marks = (marked.scene().nodes.len() - scene.nodes.len()) as u32;
        let scale = scale(view.size);
        let mut canvas = Canvas::new(view.size, &mut picture.pixels);
        for kind in &kinds {
            for line in &kind.lines {
                canvas.line(*line, kind.width(scale) + 2.0 * RIM * scale);
            }
        }
        canvas.ink(DARK, 1.0, |pixel| objects[pixel] >= marks);
        // The first kind comes last, on top.
        for kind in kinds.iter().rev() {
            for line in &kind.lines {
                canvas.line(*line, kind.width(scale));
            }
            canvas.ink(kind.kind.rgb8(), 1.0, |_| true);
        }
        legend(&mut canvas, view.size, &kinds);
        Ok(picture)
    }

    /// The kinds that are drawn, with what is seen of them.
    fn marks(&self, scene: &Scene, only: &[Kind], sight: &Sight) -> Vec<Marks> {
        let objects = scene.objects();
        let mut kinds: Vec<Marks> = Vec::new();
        for (kind, object, spot) in &self.spots {
            if !only.contains(kind) {
                continue;
            }
            if kinds.last().is_none_or(|last| last.kind != *kind) {
                let of_kind = self.findings.iter().find(|finding| finding.kind == *kind);
                let count = of_kind.map_or(0, |finding| finding.count);
                kinds.push(Marks { kind: *kind, count, shape: *spot, lines: Vec::new() });
            }
            let Some(marks) = kinds.last_mut() else { continue };
            let object = &objects[*object as usize];
            let mesh = &scene.meshes[object.mesh.index()];
            let place =
                |index: u32| object.world_from_mesh.matrix().transform_point3(mesh.position(index));
            let mut line = |from: u32, to: u32| {
                sight.seen([place(from), place(to)], &mut marks.lines);
            };
            match *spot {
                Spot::Triangle(triangle) => {
                    let [a, b, c] = mesh.triangles[triangle as usize];
                    line(a, b);
                    line(b, c);
                    line(c, a);
                }
                Spot::Edge(half_edge) => {
                    let corners = mesh.triangles[(half_edge / 3) as usize];
                    let k = (half_edge % 3) as usize;
                    line(corners[k], corners[(k + 1) % 3]);
                }
                Spot::Vertex(position, _) => line(position, position),
            }
        }
        for marks in &mut kinds {
            // Of lines in the same place, the first covers what all do.
            let mut known = HashSet::new();
            marks.lines.retain(|line| known.insert(line.map(|end| end.map(f64::to_bits))));
        }
        kinds
    }
}

/// Lists the kinds in a corner, if there is room.
fn legend(canvas: &mut Canvas<'_>, size: Size, kinds: &[Marks]) {
    let scale = scale(size);
    let [unit, row, margin, swatch] = [UNIT, ROW, MARGIN, SWATCH].map(|side| side * scale);
    let digits = kinds.iter().map(|kind| kind.count.to_string().len()).max().unwrap_or(0);
    let names = kinds.iter().map(|kind| kind.kind.name().len()).max().unwrap_or(0);
    let letters = (digits + 1 + names) as f64;
    let [width, height] =
        [3.0 * margin + swatch + letters * ADVANCE * unit, 2.0 * margin + row * kinds.len() as f64];
    let [right, bottom] = [size.width, size.height].map(f64::from);
    if kinds.is_empty() || width + 2.0 * margin > right || height + 2.0 * margin > bottom {
        return;
    }
    let (lefts, tops) = ([margin, right - margin - width], [bottom - margin - height, margin]);
    let corners = lefts.into_iter().flat_map(|left| tops.map(|top| [left, top]));
    let hidden = |[left, top]: &[f64; 2]| canvas.shown([*left, *top, left + width, top + height]);
    let Some([left, top]) = corners.min_by_key(hidden) else { return };
    canvas.rectangle([left, top, left + width, top + height]);
    canvas.ink(DARK, GROUND, |_| true);
    for (number, kind) in kinds.iter().enumerate() {
        let middle = top + margin + row * (number as f64 + 0.5);
        let start = left + margin;
        match kind.shape {
            Spot::Triangle(_) => {
                let half = swatch * 0.5;
                canvas.rectangle([start, middle - half, start + swatch, middle + half]);
            }
            Spot::Edge(_) => {
                canvas.line([[start, middle], [start + swatch, middle]], kind.width(scale));
            }
            Spot::Vertex(..) => {
                let at = [start + swatch * 0.5, middle];
                canvas.line([at, at], kind.width(scale));
            }
        }
        canvas.ink(kind.kind.rgb8(), 1.0, |_| true);
    }
    for (number, kind) in kinds.iter().enumerate() {
        let baseline = top + margin + row * (number as f64 + 0.5) + unit * (ASCENT - 0.5 * HEIGHT);
        let text = format!("{:>digits$} {}", kind.count, kind.kind.name());
        for line in text_lines(&text, [left + 2.0 * margin + swatch, baseline], unit) {
            canvas.line(line, STROKE * scale);
        }
    }
    canvas.ink(TEXT, 1.0, |_| true);
}
