//! Display lists (OpenGL 1.5, section 5.4).

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::limits::{EXECUTED_COMMANDS, LIST_NESTING, LOG_BYTES};
use crate::objects::list::{Command, OpenList, list_offsets};

impl Context {
    /// `glNewList`: what follows goes into the list, and is executed as well for `GL_COMPILE_AND_EXECUTE`.
    pub fn new_list(&mut self, name: u32, mode: u32) {
        outside_begin!(self);
        demand!(self, name != 0, gl::INVALID_VALUE);
        let is_mode = matches!(mode, gl::COMPILE | gl::COMPILE_AND_EXECUTE);
        demand!(self, is_mode, gl::INVALID_ENUM);
        demand!(self, self.list.is_none(), gl::INVALID_OPERATION);
        let room = std::mem::take(&mut self.list_room);
        self.list = Some(OpenList::new(name, mode, room));
    }

    /// `glEndList`: the list takes the place of an earlier one of its name.
    pub fn end_list(&mut self) {
        outside_begin!(self);
        let Some(list) = self.list.take() else {
            self.error.set(gl::INVALID_OPERATION);
            return;
        };
        let name = list.name;
        let (list, room) = list.finish();
        if room.bytes() <= LOG_BYTES {
            self.list_room = room;
        }
        let put = list.and_then(|list| self.lists().put(name, list));
        if let Err(error) = put {
            self.error.set(error);
        }
    }

    /// `glCallList`. A name without list is passed over, and so are lists beyond the limit of nesting.
    pub fn call_list(&mut self, name: u32) {
        compile!(self, Command::CallList(name));
        self.begin_calls();
        self.call(name);
    }

    /// `glCallLists`: `count` names of a type, each added to the list base.
    pub fn call_lists(&mut self, count: i32, data_type: u32, names: &[u8]) {
        let Some(mut offsets) = list_offsets(data_type, names) else {
            self.error.set(gl::INVALID_ENUM);
            return;
        };
        demand!(self, count >= 0, gl::INVALID_VALUE);
        offsets.truncate(count as usize);
        self.call_offsets(&offsets);
    }

    pub(crate) fn call_offsets(&mut self, offsets: &[u32]) {
        compile!(self, Command::CallLists(offsets.into()));
        self.begin_calls();
        for offset in offsets {
            self.call(self.state.list_base.wrapping_add(*offset));
        }
    }

    /// Sets how much the lists of one call may do.
    fn begin_calls(&mut self) {
        if self.nesting == 0 {
            self.executable = EXECUTED_COMMANDS;
        }
    }

    fn call(&mut self, name: u32) {
        if self.nesting >= LIST_NESTING {
            return;
        }
        let list = self.lists().get(name);
        let Some(list) = list else { return };
        self.nesting += 1;
        for command in list.iter() {
            if self.executable == 0 {
                self.error.set(gl::OUT_OF_MEMORY);
                break;
            }
            self.executable = self.executable.saturating_sub(command.count() as u64);
            self.execute(command);
        }
        self.nesting -= 1;
    }

    /// `glListBase`.
    pub fn list_base(&mut self, base: u32) {
        compile!(self, Command::ListBase(base));
        outside_begin!(self);
        self.state.list_base = base;
    }

    /// `glGenLists`: the first of so many names in a row; 0 for none.
    pub fn gen_lists(&mut self, range: i32) -> u32 {
        outside_begin!(self, 0);
        let Ok(count) = u32::try_from(range) else {
            self.error.set(gl::INVALID_VALUE);
            return 0;
        };
        if count == 0 { 0 } else { self.lists().generate(count) }
    }

    /// `glDeleteLists`.
    pub fn delete_lists(&mut self, first: u32, range: i32) {
        outside_begin!(self);
        match u32::try_from(range) {
            Ok(count) => self.lists().delete(first, count),
            Err(_) => self.error.set(gl::INVALID_VALUE),
        }
    }

    /// `glIsList`.
    pub fn is_list(&mut self, name: u32) -> bool {
        outside_begin!(self, false);
        self.lists().has(name)
    }

    /// Executes a command of a list by the method that compiled it.
    fn execute(&mut self, command: &Command) {
        match *command {
            Command::Error(error) => self.error.set(error),
            Command::Begin(mode) => self.begin(mode),
            Command::End => self.end(),
            Command::Vertices(ref run) => self.vertices_of_list(run),
            Command::Primitives(ref of) => self.primitives_of_list(of),
            Command::Index(index) => self.index(index),
            Command::RasterPos(position) => self.raster_pos(position),
            Command::WindowPos(position) => self.window_pos(position),
            Command::Rect(first, second) => self.rect(first, second),
            Command::MatrixMode(mode) => self.matrix_mode(mode),
            Command::LoadIdentity => self.load_identity(),
            Command::LoadMatrix(ref matrix) => self.load_matrix(matrix),
            Command::MultMatrix(ref matrix) => self.mult_matrix(matrix),
            Command::PushMatrix => self.push_matrix(),
            Command::PopMatrix => self.pop_matrix(),
            Command::Rotate(ref of) => self.rotate(of[0], of[1], of[2], of[3]),
            Command::Scale(ref of) => self.scale(of[0], of[1], of[2]),
            Command::Translate(ref of) => self.translate(of[0], of[1], of[2]),
            Command::Frustum(ref of) => self.frustum(of[0], of[1], of[2], of[3], of[4], of[5]),
            Command::Ortho(ref of) => self.ortho(of[0], of[1], of[2], of[3], of[4], of[5]),
            Command::Viewport([x, y, width, height]) => self.viewport(x, y, width, height),
            Command::DepthRange([near, far]) => self.depth_range(near, far),
            Command::ClipControl(origin, depth) => self.clip_control(origin, depth),
            Command::ActiveTexture(unit) => self.active_texture(unit),
            Command::Light(light, pname, ref values) => self.light(light, pname, values),
            Command::LightModel(pname, ref values) => self.light_model(pname, values),
            Command::Material(face, pname, ref values) => self.material(face, pname, values),
            Command::ColorMaterial(face, mode) => self.color_material(face, mode),
            Command::ShadeModel(mode) => self.shade_model(mode),
            Command::Fog(pname, ref values) => self.fog(pname, values),
            Command::Enable(capability) => self.enable(capability),
            Command::Disable(capability) => self.disable(capability),
            Command::Hint(target, mode) => self.hint(target, mode),
            Command::CullFace(mode) => self.cull_face(mode),
            Command::FrontFace(mode) => self.front_face(mode),
            Command::PolygonMode(face, mode) => self.polygon_mode(face, mode),
            Command::PolygonOffset([factor, units]) => self.polygon_offset(factor, units),
            Command::PolygonStipple(ref stipple) => self.set_polygon_stipple(**stipple),
            Command::LineWidth(width) => self.line_width(width),
            Command::LineStipple(factor, pattern) => self.line_stipple(factor, pattern),
            Command::PointSize(size) => self.point_size(size),
            Command::PointParameter(pname, ref values) => self.point_parameter(pname, values),
            Command::ClipPlane(plane, ref equation) => self.clip_plane(plane, **equation),
            Command::Scissor([x, y, width, height]) => self.scissor(x, y, width, height),
            Command::SampleCoverage(value, invert) => self.sample_coverage(value, invert),
            Command::AlphaFunc(func, reference) => self.alpha_func(func, reference),
            Command::DepthFunc(func) => self.depth_func(func),
            Command::DepthMask(mask) => self.depth_mask(mask),
            Command::ColorMask([r, g, b, a]) => self.color_mask(r, g, b, a),
            Command::StencilFunc(func, reference, mask) => self.stencil_func(func, reference, mask),
            Command::StencilOp([fail, depth_fail, pass]) => self.stencil_op(fail, depth_fail, pass),
            Command::StencilMask(mask) => self.stencil_mask(mask),
            Command::BlendFunc([s, d, sa, da]) => self.blend_func_separate(s, d, sa, da),
            Command::BlendEquation([colors, alphas]) => {
                self.blend_equation_separate(colors, alphas);
            }
            Command::BlendColor(color) => self.blend_color(color),
            Command::LogicOp(operation) => self.logic_op(operation),
            Command::IndexMask(mask) => self.index_mask(mask),
            Command::Clear(mask) => self.clear(mask),
            Command::ClearColor(color) => self.clear_color(color),
            Command::ClearDepth(depth) => self.clear_depth(depth),
            Command::ClearStencil(value) => self.clear_stencil(value),
            Command::ClearAccum(color) => self.clear_accum(color),
            Command::ClearIndex(index) => self.clear_index(index),
            Command::DrawBuffer(buffer) => self.draw_buffer(buffer),
            Command::ReadBuffer(buffer) => self.read_buffer(buffer),
            Command::CallList(name) => self.call_list(name),
            Command::CallLists(ref offsets) => self.call_offsets(offsets),
            Command::ListBase(base) => self.list_base(base),
            Command::PushAttrib(mask) => self.push_attrib(mask),
            Command::PopAttrib => self.pop_attrib(),
            Command::InitNames => self.init_names(),
            Command::LoadName(name) => self.load_name(name),
            Command::PushName(name) => self.push_name(name),
            Command::PopName => self.pop_name(),
            Command::Map(ref call) => self.map(call),
            Command::MapGrid1(steps, domain) => self.map_grid_1(steps, domain),
            Command::MapGrid2(steps, domain) => self.map_grid_2(steps, domain),
            Command::EvalCoord1(u) => self.eval_coord_1(u),
            Command::EvalCoord2(place) => self.eval_coord_2(place),
            Command::EvalPoint1(step) => self.eval_point_1(step),
            Command::EvalPoint2(steps) => self.eval_point_2(steps),
            Command::EvalMesh1(mode, run) => self.eval_mesh_1(mode, run),
            Command::EvalMesh2(mode, ref part) => {
                let [i1, i2, j1, j2] = **part;
                self.eval_mesh_2(mode, [i1, i2], [j1, j2]);
            }
            Command::BindTexture(target, name) => self.bind_texture(target, name),
            Command::PrioritizeTextures(count, ref pairs) => {
                let (names, priorities): (Vec<u32>, Vec<f32>) = pairs.iter().copied().unzip();
                self.prioritize_textures(count, &names, &priorities);
            }
            Command::TexParameter(target, pname, ref values) => {
                self.tex_parameter(target, pname, values);
            }
            Command::TexEnv(target, pname, ref values) => self.tex_env(target, pname, values),
            Command::TexGen(coordinate, pname, ref values) => {
                self.tex_gen(coordinate, pname, values);
            }
            Command::TexImage(ref call) => self.tex_image_from_list(call),
            Command::TexSubImage(ref call) => self.tex_sub_image_from_list(call),
            Command::CopyTexImage(ref call) => self.copy_image(call),
            Command::CopyTexSubImage(ref call) => self.copy_part(call),
            Command::PassThrough(mark) => self.pass_through(mark),
            Command::Bitmap(ref call) => self.draw_bitmap(call),
            Command::Accum(operation, value) => self.accum(operation, value),
            Command::PixelZoom([x, y]) => self.pixel_zoom(x, y),
            Command::PixelTransfer(pname, value) => self.pixel_transfer(pname, value),
            Command::PixelMap(map, size, ref values) => self.pixel_map(map, size, values),
            Command::DrawPixels(ref call) => self.draw_pixels_from_list(call),
            Command::CopyPixels(ref of, buffer) => {
                let [x, y, width, height] = **of;
                self.copy_pixels([x, y], [width, height], buffer);
            }
            Command::BeginQuery(target, name) => self.begin_query(target, name),
            Command::EndQuery(target) => self.end_query(target),
            Command::Draw(ref draw) => self.draw_recorded(draw),
        }
    }
}
