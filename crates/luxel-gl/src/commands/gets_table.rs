//! The one table of what `glGet` returns (OpenGL 1.5, tables 6.5 to 6.36).

use crate::Context;
use crate::enums as gl;
use crate::limits::{
    ATTRIBUTE_DEPTH, CLIP_PLANES, CUBE_SIDE, EVALUATOR_ORDER, LARGEST_SIZE, LIGHTS, LIST_NESTING,
    LOD_BIAS, MODELVIEW_DEPTH, MOST_SAMPLES, PIXEL_MAP, PROJECTION_DEPTH, SUBPIXEL_BITS,
    TEXTURE_3D_SIDE, TEXTURE_DEPTH, TEXTURE_SIDE, TEXTURE_UNITS, VIEWPORT,
};
use crate::objects::framebuffer::COLORS;
use crate::state::arrays::VertexArray;
use crate::state::attributes::Hints;
use crate::state::pixel::PixelStore;
use crate::texture::{Target, locked};
use crate::values::Values;
use glam::DMat4;
use luxel_pick::MAX_NAMES;

fn matrix(matrix: DMat4) -> Values {
    Values::doubles(matrix.to_cols_array())
}

/// The value of a piece of state; `None` for a name that isn't one.
pub(super) fn value_of(context: &Context, pname: u32) -> Option<Values> {
    of_vertices(context, pname)
        .or_else(|| of_lighting(context, pname))
        .or_else(|| of_rasterization(context, pname))
        .or_else(|| of_fragments(context, pname))
        .or_else(|| of_pixels(context, pname))
        .or_else(|| of_textures(context, pname))
        .or_else(|| of_lists_and_modes(context, pname))
        .or_else(|| of_arrays(context, pname))
        .or_else(|| limit(context, pname))
        .or_else(|| {
            let enabled = context.state.enables.get(pname, context.state.active_texture)?;
            Some(Values::boolean(enabled))
        })
}

/// Current values, matrices, viewport (tables 6.5, 6.8).
fn of_vertices(context: &Context, pname: u32) -> Option<Values> {
    let state = &context.state;
    let current = &state.current;
    let raster = &current.raster;
    let unit = state.active_texture;
    let matrices = &context.matrices;
    let texture = &matrices.texture[unit];
    Some(match pname {
        gl::CURRENT_COLOR => Values::scaled(current.color),
        gl::CURRENT_SECONDARY_COLOR => {
            let [r, g, b] = current.secondary;
            Values::scaled([r, g, b, 1.0])
        }
        gl::CURRENT_INDEX => Values::real(current.index),
        gl::CURRENT_TEXTURE_COORDS => Values::reals(current.tex_coords[unit]),
        gl::CURRENT_NORMAL => Values::scaled(current.normal),
        gl::CURRENT_FOG_COORD => Values::real(current.fog_coord),
        gl::CURRENT_RASTER_POSITION => Values::reals(raster.window),
        gl::CURRENT_RASTER_DISTANCE => Values::real(raster.distance),
        gl::CURRENT_RASTER_COLOR => Values::scaled(raster.color),
        gl::CURRENT_RASTER_SECONDARY_COLOR => Values::scaled(raster.secondary),
        gl::CURRENT_RASTER_INDEX => Values::real(raster.index),
        gl::CURRENT_RASTER_TEXTURE_COORDS => Values::reals(raster.tex_coords[unit]),
        gl::CURRENT_RASTER_POSITION_VALID => Values::boolean(raster.valid),
        gl::EDGE_FLAG => Values::boolean(current.edge_flag),
        gl::MATRIX_MODE => Values::name(state.transform.matrix_mode),
        gl::MODELVIEW_MATRIX => matrix(matrices.modelview.top),
        gl::PROJECTION_MATRIX => matrix(matrices.projection.top),
        gl::TEXTURE_MATRIX => matrix(texture.top),
        gl::TRANSPOSE_MODELVIEW_MATRIX => matrix(matrices.modelview.top.transpose()),
        gl::TRANSPOSE_PROJECTION_MATRIX => matrix(matrices.projection.top.transpose()),
        gl::TRANSPOSE_TEXTURE_MATRIX => matrix(texture.top.transpose()),
        gl::MODELVIEW_STACK_DEPTH => Values::count(matrices.modelview.depth()),
        gl::PROJECTION_STACK_DEPTH => Values::count(matrices.projection.depth()),
        gl::TEXTURE_STACK_DEPTH => Values::count(texture.depth()),
        gl::VIEWPORT => {
            let area = state.viewport.area;
            Values::integers([area.x, area.y, area.width, area.height])
        }
        gl::CLIP_ORIGIN => {
            let upper = state.transform.clip.upper_left;
            Values::name(if upper { gl::UPPER_LEFT } else { gl::LOWER_LEFT })
        }
        gl::CLIP_DEPTH_MODE => {
            let from_zero = state.transform.clip.zero_to_one;
            Values::name(if from_zero { gl::ZERO_TO_ONE } else { gl::NEGATIVE_ONE_TO_ONE })
        }
        gl::DEPTH_RANGE => Values::scaled_doubles([state.viewport.near, state.viewport.far]),
        gl::ACTIVE_TEXTURE => Values::name(gl::TEXTURE0 + unit as u32),
        gl::CLIENT_ACTIVE_TEXTURE => Values::name(gl::TEXTURE0 + context.client.arrays.unit as u32),
        _ => return None,
    })
}

/// Lighting and fog (tables 6.9 to 6.11).
fn of_lighting(context: &Context, pname: u32) -> Option<Values> {
    let state = &context.state;
    let (lights, fog) = (&state.lights, &state.fog);
    Some(match pname {
        gl::LIGHT_MODEL_AMBIENT => Values::scaled(lights.model.ambient),
        gl::LIGHT_MODEL_LOCAL_VIEWER => Values::boolean(lights.model.local_viewer),
        gl::LIGHT_MODEL_TWO_SIDE => Values::boolean(lights.model.two_side),
        gl::LIGHT_MODEL_COLOR_CONTROL => Values::name(lights.model.color_control),
        gl::SHADE_MODEL => Values::name(lights.shade_model),
        gl::COLOR_MATERIAL_FACE => Values::name(state.color_material.face),
        gl::COLOR_MATERIAL_PARAMETER => Values::name(state.color_material.mode),
        gl::FOG_COLOR => Values::scaled(fog.color),
        gl::FOG_INDEX => Values::real(fog.index),
        gl::FOG_DENSITY => Values::real(fog.density),
        gl::FOG_START => Values::real(fog.start),
        gl::FOG_END => Values::real(fog.end),
        gl::FOG_MODE => Values::name(fog.mode),
        gl::FOG_COORD_SRC => Values::name(fog.source),
        _ => return None,
    })
}

/// Points, lines, polygons, hints (tables 6.12, 6.32).
fn of_rasterization(context: &Context, pname: u32) -> Option<Values> {
    let state = &context.state;
    let (points, lines, polygons) = (&state.points, &state.lines, &state.polygons);
    if let Some(place) = Hints::TARGETS.iter().position(|target| *target == pname) {
        return Some(Values::name(state.hints.0[place]));
    }
    Some(match pname {
        gl::POINT_SIZE => Values::real(points.size),
        gl::POINT_SIZE_MIN => Values::real(points.least),
        gl::POINT_SIZE_MAX => Values::real(points.largest),
        gl::POINT_FADE_THRESHOLD_SIZE => Values::real(points.fade),
        gl::POINT_DISTANCE_ATTENUATION => Values::reals(points.attenuation),
        gl::LINE_WIDTH => Values::real(lines.width),
        gl::LINE_STIPPLE_PATTERN => Values::integer(i32::from(lines.pattern)),
        gl::LINE_STIPPLE_REPEAT => Values::integer(lines.factor),
        gl::CULL_FACE_MODE => Values::name(polygons.cull),
        gl::FRONT_FACE => Values::name(polygons.front),
        gl::POLYGON_MODE => Values::integers(polygons.modes.map(|mode| mode as i32)),
        gl::POLYGON_OFFSET_FACTOR => Values::real(polygons.offset_factor),
        gl::POLYGON_OFFSET_UNITS => Values::real(polygons.offset_units),
        _ => return None,
    })
}

/// Tests, blending, masks, clear values (tables 6.19 to 6.21).
fn of_fragments(context: &Context, pname: u32) -> Option<Values> {
    let state = &context.state;
    let (color, stencil, depth) = (&state.color, &state.stencil, &state.depth);
    Some(match pname {
        gl::SCISSOR_BOX => {
            let area = state.scissor;
            Values::integers([area.x, area.y, area.width, area.height])
        }
        gl::ALPHA_TEST_FUNC => Values::name(color.alpha_func),
        gl::ALPHA_TEST_REF => Values::scaled([color.alpha_reference]),
        gl::STENCIL_FUNC => Values::name(stencil.func),
        gl::STENCIL_VALUE_MASK => Values::name(stencil.value_mask),
        gl::STENCIL_REF => Values::integer(stencil.reference.clamp(0, 255)),
        gl::STENCIL_FAIL => Values::name(stencil.fail),
        gl::STENCIL_PASS_DEPTH_FAIL => Values::name(stencil.depth_fail),
        gl::STENCIL_PASS_DEPTH_PASS => Values::name(stencil.pass),
        gl::STENCIL_WRITEMASK => Values::name(stencil.write_mask),
        gl::STENCIL_CLEAR_VALUE => Values::integer(stencil.clear),
        gl::DEPTH_FUNC => Values::name(depth.func),
        gl::DEPTH_WRITEMASK => Values::boolean(depth.mask),
        gl::DEPTH_CLEAR_VALUE => Values::scaled_doubles([depth.clear]),
        gl::BLEND_SRC | gl::BLEND_SRC_RGB => Values::name(color.blend[0]),
        gl::BLEND_DST | gl::BLEND_DST_RGB => Values::name(color.blend[1]),
        gl::BLEND_SRC_ALPHA => Values::name(color.blend[2]),
        gl::BLEND_DST_ALPHA => Values::name(color.blend[3]),
        gl::ARRAY_ELEMENT_LOCK_FIRST => Values::integer(context.client.arrays.locked[0]),
        gl::ARRAY_ELEMENT_LOCK_COUNT => Values::integer(context.client.arrays.locked[1]),
        gl::BLEND_EQUATION => Values::name(color.blend_equations[0]),
        gl::BLEND_EQUATION_ALPHA => Values::name(color.blend_equations[1]),
        gl::BLEND_COLOR => Values::scaled(color.blend_color),
        gl::LOGIC_OP_MODE => Values::name(color.logic_op),
        gl::DRAW_BUFFER => Values::name(color.draw_buffer),
        gl::INDEX_WRITEMASK => Values::name(color.index_mask),
        gl::COLOR_WRITEMASK => Values::booleans(color.mask),
        gl::COLOR_CLEAR_VALUE => Values::scaled(color.clear),
        gl::INDEX_CLEAR_VALUE => Values::real(color.clear_index),
        gl::SAMPLE_COVERAGE_VALUE => Values::scaled([state.sample_coverage.0.0]),
        gl::SAMPLE_COVERAGE_INVERT => Values::boolean(state.sample_coverage.0.1),
        gl::ACCUM_CLEAR_VALUE => Values::scaled(state.clear_accum),
        _ => return None,
    })
}

/// Storage of pixels (tables 6.22 to 6.25).
fn of_pixels(context: &Context, pname: u32) -> Option<Values> {
    let of = |store: &PixelStore, place: u32| {
        Some(match place {
            0 => Values::boolean(store.swap_bytes),
            1 => Values::boolean(store.lsb_first),
            2 => Values::count(store.row_length),
            3 => Values::count(store.skip_rows),
            4 => Values::count(store.skip_pixels),
            5 => Values::count(store.alignment),
            _ => return None,
        })
    };
    let client = &context.client;
    Some(match pname {
        gl::UNPACK_IMAGE_HEIGHT => Values::count(client.unpack.image_height),
        gl::UNPACK_SKIP_IMAGES => Values::count(client.unpack.skip_images),
        gl::PACK_IMAGE_HEIGHT => Values::count(client.pack.image_height),
        gl::PACK_SKIP_IMAGES => Values::count(client.pack.skip_images),
        gl::UNPACK_SWAP_BYTES..=gl::UNPACK_ALIGNMENT => {
            return of(&client.unpack, pname - gl::UNPACK_SWAP_BYTES);
        }
        gl::PACK_SWAP_BYTES..=gl::PACK_ALIGNMENT => {
            return of(&client.pack, pname - gl::PACK_SWAP_BYTES);
        }
        gl::MAP_COLOR => Values::boolean(context.state.pixel.transfer.map_color),
        gl::MAP_STENCIL => Values::boolean(context.state.pixel.transfer.map_stencil),
        gl::INDEX_SHIFT => Values::integer(context.state.pixel.transfer.index_shift),
        gl::INDEX_OFFSET => Values::integer(context.state.pixel.transfer.index_offset),
        gl::PIXEL_MAP_I_TO_I_SIZE..=gl::PIXEL_MAP_A_TO_A_SIZE => {
            let place = (pname - gl::PIXEL_MAP_I_TO_I_SIZE) as usize;
            Values::count(context.pixel_maps.0[place].len())
        }
        gl::MAX_PIXEL_MAP_TABLE => Values::integer(PIXEL_MAP),
        gl::ZOOM_X => Values::real(context.state.pixel.zoom[0]),
        gl::ZOOM_Y => Values::real(context.state.pixel.zoom[1]),
        gl::READ_BUFFER => Values::name(context.read_buffer_name()),
        _ => {
            return { context.state.pixel.transfer }
                .factor(pname)
                .map(|factor| Values::real(*factor));
        }
    })
}

/// Textures: bindings and limits (tables 6.15, 6.30).
fn of_textures(context: &Context, pname: u32) -> Option<Values> {
    let unit = &context.state.texture.units[context.state.active_texture];
    let name =
        |target: Target| Values::name(unit.bound(target).map_or(0, |texture| locked(texture).name));
    Some(match pname {
        gl::TEXTURE_BINDING_1D => name(Target::One),
        gl::TEXTURE_BINDING_2D => name(Target::Two),
        gl::TEXTURE_BINDING_3D => name(Target::Three),
        gl::TEXTURE_BINDING_CUBE_MAP => name(Target::Cube),
        gl::MAX_TEXTURE_SIZE => Values::name(TEXTURE_SIDE),
        gl::MAX_3D_TEXTURE_SIZE => Values::name(TEXTURE_3D_SIDE),
        gl::MAX_CUBE_MAP_TEXTURE_SIZE => Values::name(CUBE_SIDE),
        gl::MAX_TEXTURE_LOD_BIAS => Values::real(LOD_BIAS),
        _ => return None,
    })
}

/// Evaluators, lists, stacks, modes (tables 6.33, 6.36).
fn of_lists_and_modes(context: &Context, pname: u32) -> Option<Values> {
    let open = context.list.as_ref();
    let grids = &context.state.grids;
    let [u, v] = &grids.two;
    Some(match pname {
        gl::MAP1_GRID_SEGMENTS => Values::integer(grids.one.steps),
        gl::MAP1_GRID_DOMAIN => Values::reals(grids.one.domain),
        gl::MAP2_GRID_SEGMENTS => Values::integers([u.steps, v.steps]),
        gl::MAP2_GRID_DOMAIN => Values::reals([u.domain[0], u.domain[1], v.domain[0], v.domain[1]]),
        gl::LIST_BASE => Values::name(context.state.list_base),
        gl::LIST_INDEX => Values::name(open.map_or(0, |list| list.name)),
        gl::LIST_MODE => Values::name(open.map_or(0, |list| list.mode)),
        gl::ATTRIB_STACK_DEPTH => Values::count(context.attribute_stack.len()),
        gl::CLIENT_ATTRIB_STACK_DEPTH => Values::count(context.client_stack.len()),
        gl::NAME_STACK_DEPTH => Values::count(context.selection.depth()),
        gl::RENDER_MODE => Values::name(context.render_mode),
        gl::SELECTION_BUFFER_SIZE => Values::count(context.selection.room()),
        gl::FEEDBACK_BUFFER_SIZE => Values::count(context.feedback.room()),
        gl::FEEDBACK_BUFFER_TYPE => Values::name(context.feedback.of()),
        _ => return None,
    })
}

/// Vertex arrays and buffers (tables 6.6 and 6.7).
fn of_arrays(context: &Context, pname: u32) -> Option<Values> {
    let arrays = &context.client.arrays;
    let texture = &arrays.tex_coords[arrays.unit];
    let name = |array: &VertexArray| Some(Values::name(array.data_type));
    let size = |array: &VertexArray| Some(Values::count(array.size));
    let stride = |array: &VertexArray| Some(Values::count(array.stride));
    let buffer = |array: &VertexArray| Some(Values::name(array.buffer));
    match pname {
        gl::VERTEX_ARRAY_SIZE => size(&arrays.vertex),
        gl::VERTEX_ARRAY_TYPE => name(&arrays.vertex),
        gl::VERTEX_ARRAY_STRIDE => stride(&arrays.vertex),
        gl::VERTEX_ARRAY_BUFFER_BINDING => buffer(&arrays.vertex),
        gl::NORMAL_ARRAY_TYPE => name(&arrays.normal),
        gl::NORMAL_ARRAY_STRIDE => stride(&arrays.normal),
        gl::NORMAL_ARRAY_BUFFER_BINDING => buffer(&arrays.normal),
        gl::COLOR_ARRAY_SIZE => size(&arrays.color),
        gl::COLOR_ARRAY_TYPE => name(&arrays.color),
        gl::COLOR_ARRAY_STRIDE => stride(&arrays.color),
        gl::COLOR_ARRAY_BUFFER_BINDING => buffer(&arrays.color),
        gl::SECONDARY_COLOR_ARRAY_SIZE => size(&arrays.secondary),
        gl::SECONDARY_COLOR_ARRAY_TYPE => name(&arrays.secondary),
        gl::SECONDARY_COLOR_ARRAY_STRIDE => stride(&arrays.secondary),
        gl::SECONDARY_COLOR_ARRAY_BUFFER_BINDING => buffer(&arrays.secondary),
        gl::INDEX_ARRAY_TYPE => name(&arrays.index),
        gl::INDEX_ARRAY_STRIDE => stride(&arrays.index),
        gl::INDEX_ARRAY_BUFFER_BINDING => buffer(&arrays.index),
        gl::EDGE_FLAG_ARRAY_STRIDE => stride(&arrays.edge_flag),
        gl::EDGE_FLAG_ARRAY_BUFFER_BINDING => buffer(&arrays.edge_flag),
        gl::FOG_COORD_ARRAY_TYPE => name(&arrays.fog_coord),
        gl::FOG_COORD_ARRAY_STRIDE => stride(&arrays.fog_coord),
        gl::FOG_COORD_ARRAY_BUFFER_BINDING => buffer(&arrays.fog_coord),
        gl::TEXTURE_COORD_ARRAY_SIZE => size(texture),
        gl::TEXTURE_COORD_ARRAY_TYPE => name(texture),
        gl::TEXTURE_COORD_ARRAY_STRIDE => stride(texture),
        gl::TEXTURE_COORD_ARRAY_BUFFER_BINDING => buffer(texture),
        gl::ARRAY_BUFFER_BINDING => Some(Values::name(arrays.array_buffer)),
        gl::ELEMENT_ARRAY_BUFFER_BINDING => Some(Values::name(arrays.element_buffer)),
        _ => {
            let enabled = arrays.named(pname)?.enabled;
            Some(Values::boolean(enabled))
        }
    }
}

/// What the implementation can do, and what the framebuffer has (tables 6.29 to 6.31, 6.34).
fn limit(context: &Context, pname: u32) -> Option<Values> {
    let configuration = &context.configuration;
    let samples = match context.framebuffer.samples() {
        1 => 0,
        samples => samples,
    };
    let [has_depth, has_stencil] = context.has_depth_and_stencil();
    Some(match pname {
        gl::MAX_LIGHTS => Values::count(LIGHTS),
        gl::MAX_CLIP_PLANES => Values::count(CLIP_PLANES),
        gl::MAX_MODELVIEW_STACK_DEPTH => Values::count(MODELVIEW_DEPTH),
        gl::MAX_PROJECTION_STACK_DEPTH => Values::count(PROJECTION_DEPTH),
        gl::MAX_TEXTURE_STACK_DEPTH => Values::count(TEXTURE_DEPTH),
        gl::MAX_TEXTURE_UNITS => Values::count(TEXTURE_UNITS),
        gl::MAX_ATTRIB_STACK_DEPTH | gl::MAX_CLIENT_ATTRIB_STACK_DEPTH => {
            Values::count(ATTRIBUTE_DEPTH)
        }
        gl::MAX_NAME_STACK_DEPTH => Values::count(MAX_NAMES),
        gl::MAX_LIST_NESTING => Values::count(LIST_NESTING),
        gl::MAX_VIEWPORT_DIMS => Values::integers([VIEWPORT; 2]),
        gl::SUBPIXEL_BITS => Values::integer(SUBPIXEL_BITS),
        gl::POINT_SIZE_RANGE | gl::ALIASED_POINT_SIZE_RANGE => Values::reals([1.0, LARGEST_SIZE]),
        gl::LINE_WIDTH_RANGE | gl::ALIASED_LINE_WIDTH_RANGE => Values::reals([1.0, LARGEST_SIZE]),
        gl::POINT_SIZE_GRANULARITY | gl::LINE_WIDTH_GRANULARITY => Values::real(0.1),
        gl::MAX_ELEMENTS_VERTICES | gl::MAX_ELEMENTS_INDICES => Values::integer(1 << 20),
        gl::MAX_EVAL_ORDER => Values::integer(EVALUATOR_ORDER),
        gl::NUM_COMPRESSED_TEXTURE_FORMATS => Values::integer(0),
        gl::COMPRESSED_TEXTURE_FORMATS => Values::none(),
        gl::RED_BITS..=gl::ALPHA_BITS => {
            let there = context.color_format().present()[(pname - gl::RED_BITS) as usize];
            Values::integer(if there { 8 } else { 0 })
        }
        gl::INDEX_BITS | gl::AUX_BUFFERS => Values::integer(0),
        gl::SAMPLES => Values::count(samples),
        gl::SAMPLE_BUFFERS => Values::integer(i32::from(samples > 0)),
        gl::DEPTH_BITS => {
            Values::count(if has_depth { context.framebuffer.depth_kind().bits() } else { 0 })
        }
        gl::STENCIL_BITS => Values::integer(if has_stencil { 8 } else { 0 }),
        gl::ACCUM_RED_BITS | gl::ACCUM_GREEN_BITS | gl::ACCUM_BLUE_BITS | gl::ACCUM_ALPHA_BITS => {
            Values::integer(if configuration.accum_bits > 0 { 16 } else { 0 })
        }
        gl::FRAMEBUFFER_BINDING => Values::name(context.framebuffers.draw),
        gl::READ_FRAMEBUFFER_BINDING => Values::name(context.framebuffers.read),
        gl::RENDERBUFFER_BINDING => Values::name(context.framebuffers.renderbuffer),
        gl::MAX_RENDERBUFFER_SIZE => Values::integer(VIEWPORT),
        gl::MAX_COLOR_ATTACHMENTS => Values::count(COLORS),
        gl::MAX_SAMPLES => Values::integer(MOST_SAMPLES),
        gl::RGBA_MODE => Values::boolean(true),
        gl::INDEX_MODE | gl::DOUBLEBUFFER | gl::STEREO => Values::boolean(false),
        _ => return None,
    })
}
