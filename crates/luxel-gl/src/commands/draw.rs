//! From a stream of vertices to the log, hit records or the feedback buffer; raster positions (OpenGL 1.5, section 2.12).

use super::fragments::unit;
use crate::Context;
use crate::context::{compile, outside_begin};
use crate::enums as gl;
use crate::fragment::TextureStages;
use crate::limits::TEXTURE_UNITS;
use crate::modes::{FEEDBACK_PARTS, FeedbackVisitor, HitVisitor, UsedVisitor};
use crate::objects::list::Command;
use crate::primitive::Primitives;
use crate::raster::{
    Batch, Buffers, DeferredDraw, DrawSetup, DrawState, PIECES_RUN, Pieces, Pipeline,
};
use crate::state::current::RasterPosition;
use crate::vertex::{
    Materials, Needs, Pass, Processed, Stream, VertexProcessor, VertexSource, Vertices,
    WindowScale, codes,
};
use std::borrow::Cow;
use std::sync::Arc;

/// Primitives that become feedback before it is appended to the buffer.
const FEEDBACK_WAVE: usize = FEEDBACK_PARTS * PIECES_RUN;

impl Context {
    /// Draws what waits.
    #[cold]
    pub(crate) fn draw_waiting(&mut self) {
        let mut stream = std::mem::take(&mut self.stream);
        self.draw_stream(&stream);
        stream.set_drawn();
        self.stream = stream;
    }

    /// Draws what a stream has.
    pub(crate) fn draw_stream(&mut self, stream: &Stream) {
        let source = VertexSource::Run(stream.mode, Cow::Borrowed(&stream.vertices));
        self.draw(source, &stream.materials, stream.is_listed);
    }

    /// Draws vertices of one material.
    pub(crate) fn draw_vertices(&mut self, source: VertexSource<'_>) {
        let materials = Materials::new(self.state.materials);
        self.draw(source, &materials, self.nesting > 0);
    }

    /// Draws vertices; whether they come from a display list.
    fn draw(&mut self, source: VertexSource<'_>, materials: &Materials, is_listed: bool) {
        let primitives = Primitives::new(&source, &self.state.current, materials);
        if primitives.vertices.is_empty() {
            return;
        }
        match self.render_mode {
            gl::SELECT => self.find_hits(&primitives, is_listed),
            gl::FEEDBACK => self.feed_back(&primitives, is_listed),
            _ => {
                let Some(setup) = self.draw_setup(is_listed) else { return };
                if DrawSetup::defers(&primitives) {
                    let (current, materials) = (self.state.current.clone(), materials.clone());
                    let source = source.into_owned();
                    self.log.defer(DeferredDraw { setup, source, current, materials });
                } else {
                    let (batch, runs) = setup.make(&primitives, self.log.spare(), self.level);
                    self.log.draw(batch, runs);
                }
                self.limit_log();
            }
        }
    }

    /// Records hits (`GL_SELECT`).
    fn find_hits(&mut self, primitives: &Primitives<'_>, is_listed: bool) {
        let state = self.draw_state(is_listed);
        let processor = self.processor(Needs::default());
        let mut processed = self.log.spare().vertices(processor.lists());
        processor.process(primitives.of(), Pass::Both, self.level, &mut processed);
        let window = self.state.window_transform();
        let mut visitor = HitVisitor::new(&state, &processed, window, &mut self.selection);
        primitives.assemble(&mut visitor);
        visitor.finish();
        self.log.spare().put_vertices(processed);
    }

    /// Appends to the feedback buffer (`GL_FEEDBACK`).
    fn feed_back(&mut self, primitives: &Primitives<'_>, is_listed: bool) {
        let state = self.draw_state(is_listed);
        let [colors, textures] = self.feedback.parts_of_vertices();
        let needs = Needs { window: true, eye: false, colors, textures: u32::from(textures) };
        let processor = self.processor(needs);
        let window = self.state.window_transform();
        let parts = primitives.parts();
        let mut processed = self.log.spare().vertices(processor.lists());
        let used = primitives.notes_used(&processor);
        let of = primitives.of();
        processor.process(of, Pass::first(used.as_ref()), self.level, &mut processed);
        if let Some(used) = &used {
            luxel_parallel::tasks(parts.div_ceil(PIECES_RUN), &|run| {
                let run = run * PIECES_RUN..parts.min((run + 1) * PIECES_RUN);
                let mut visitor = UsedVisitor { state: &state, vertices: &processed, used };
                primitives.assemble_parts(run, &mut visitor);
            });
            processor.process(of, Pass::Shades(used), self.level, &mut processed);
        }
        // In waves, so that parts take no more memory than the buffer has room for, and a little.
        for start in (0..parts).step_by(FEEDBACK_WAVE) {
            if self.feedback.is_full() {
                break;
            }
            let (feedback, length) = (&self.feedback, FEEDBACK_WAVE.min(parts - start));
            let runs = luxel_parallel::map(length, PIECES_RUN, &|run| {
                let mut visitor = FeedbackVisitor::new(&state, &processed, window, feedback.part());
                primitives.assemble_parts(start + run.start..start + run.end, &mut visitor);
                Some(visitor.finish())
            });
            self.feedback.append(runs.into_iter().flatten());
        }
        self.log.spare().put_vertices(processed);
    }

    /// All state of a draw (`GL_RENDER`); `None` where nothing can be drawn.
    fn draw_setup(&mut self, is_listed: bool) -> Option<DrawSetup> {
        let (pipeline, viewport) = self.begin_draw()?;
        let state = self.draw_state(is_listed);
        let textures = pipeline.textures.as_ref().map_or(0, TextureStages::units);
        let needs = Needs { window: true, eye: state.needs_eye(), colors: true, textures };
        let (processor, samples) = (self.processor(needs), self.queries.counter());
        Some(DrawSetup { processor, state, pipeline, viewport, samples })
    }

    fn draw_state(&self, is_listed: bool) -> DrawState {
        DrawState::new(&self.state, self.window_scale(), is_listed)
    }

    fn processor(&self, needs: Needs) -> VertexProcessor {
        VertexProcessor::new(&self.state, &self.matrices, self.window_scale(), needs)
    }

    /// The pipeline of a draw, and the viewport; `None` where nothing can be drawn.
    pub(super) fn begin_draw(&mut self) -> Option<(Arc<Pipeline>, [i32; 4])> {
        if self.is_incomplete() {
            return None;
        }
        let region = self.scissored_region();
        let [left, bottom, right, top] = region;
        if left >= right || bottom >= top {
            return None;
        }
        let [depth, stencil] = self.has_depth_and_stencil();
        let textures = self.texture_stages();
        let (color, samples) = (self.color_format(), self.framebuffer.samples() > 1);
        let buffers = Buffers { color, depth, stencil, samples };
        let pipeline = Pipeline::new(&self.state, buffers, region, self.color_bits(), textures);
        let area = self.state.viewport.area;
        let viewport = [area.x, area.y, area.x + area.width, area.y + area.height];
        Some((self.log.pipeline(pipeline), viewport))
    }

    /// From clip coordinates to the window, with depths as the framebuffer that is drawn to keeps them.
    pub(super) fn window_scale(&self) -> WindowScale {
        WindowScale::new(&self.state.window_transform(), self.framebuffer.depth_kind())
    }

    /// Puts a batch into the log, and carries that out if it is full.
    pub(super) fn finish_draw(&mut self, mut batch: Batch, runs: Vec<Pieces>) {
        batch.samples = self.queries.counter();
        self.log.draw(batch, runs);
        self.limit_log();
    }

    /// Carries the log out if it is full.
    pub(super) fn limit_log(&mut self) {
        if self.log.is_full() {
            self.carry_out();
        }
    }

    /// `glRasterPos`: x, y, z, w, through transform and lighting. Outside of the clip volume it is invalid; in
    /// selection mode a valid one is a hit.
    pub fn raster_pos(&mut self, position: [f32; 4]) {
        compile!(self, Command::RasterPos(position));
        outside_begin!(self);
        let mut vertices = Vertices::default();
        vertices.restart(&self.state.current);
        vertices.push(position);
        let textures = (1 << TEXTURE_UNITS) - 1;
        let needs = Needs { window: true, eye: true, colors: true, textures };
        let mut vertex = Processed::default();
        self.processor(needs).process(
            (&vertices.view(&self.state.current), &Materials::new(self.state.materials)),
            Pass::Both,
            self.level,
            &mut vertex,
        );
        let unheld = codes::OUTSIDE | codes::NOT_FINITE | codes::NOT_HELD;
        if vertex.codes[0] & unheld != 0 {
            self.state.current.raster.valid = false;
            return;
        }
        let [x, y, z] = self.state.window_transform().place(vertex.clip[0].map(f64::from));
        let current = &self.state.current;
        let tex_coords = [0, 1, 2, 3, 4, 5, 6, 7].map(|unit: usize| vertex.tex_coords[unit][0]);
        let from_coordinates =
            self.state.enables.has(gl::FOG) && self.state.fog.source == gl::FOG_COORD;
        let distance = if from_coordinates { current.fog_coord } else { vertex.eye[0][2].abs() };
        let [r, g, b, _] = vertex.secondary(0, 0);
        self.state.current.raster = RasterPosition {
            window: [x as f32, y as f32, z as f32, vertex.clip[0][3]],
            valid: true,
            distance,
            color: vertex.color(0, 0),
            secondary: [r, g, b, 1.0],
            tex_coords,
            index: current.index,
        };
        if self.render_mode == gl::SELECT {
            self.selection.hit([z; 2]);
        }
    }

    /// `glWindowPos`: x and y in the window, z from 0 to 1 by the range of depths; always valid.
    pub fn window_pos(&mut self, [x, y, z]: [f32; 3]) {
        compile!(self, Command::WindowPos([x, y, z]));
        outside_begin!(self);
        let depth = self.state.window_transform().depth(f64::from(unit(z)));
        let current = &self.state.current;
        let [r, g, b] = current.secondary.map(unit);
        self.state.current.raster = RasterPosition {
            window: [x, y, depth as f32, 1.0],
            valid: true,
            distance: if self.state.fog.source == gl::FOG_COORD { current.fog_coord } else { 0.0 },
            color: current.color.map(unit),
            secondary: [r, g, b, 1.0],
            tex_coords: current.tex_coords,
            index: current.index,
        };
        if self.render_mode == gl::SELECT {
            self.selection.hit([depth; 2]);
        }
    }
}
