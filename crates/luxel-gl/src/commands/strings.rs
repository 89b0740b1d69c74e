//! `glGetString` (OpenGL 1.5, section 6.1.11).

use crate::Context;
use crate::context::outside_begin;
use crate::enums as gl;
use std::ffi::CStr;

/// What is implemented beyond the core, or by other names.
const EXTENSIONS: &CStr = c"\
    GL_APPLE_packed_pixels GL_ARB_clip_control GL_ARB_depth_buffer_float GL_ARB_depth_texture \
    GL_ARB_framebuffer_object GL_ARB_multisample GL_ARB_multitexture GL_ARB_occlusion_query \
    GL_ARB_point_parameters GL_ARB_shadow GL_ARB_texture_border_clamp GL_ARB_texture_compression \
    GL_ARB_texture_cube_map GL_ARB_texture_env_add GL_ARB_texture_env_combine \
    GL_ARB_texture_env_crossbar GL_ARB_texture_env_dot3 GL_ARB_texture_mirrored_repeat \
    GL_ARB_texture_non_power_of_two GL_ARB_transpose_matrix GL_ARB_vertex_buffer_object \
    GL_ARB_window_pos GL_EXT_abgr GL_EXT_bgra GL_EXT_blend_color GL_EXT_blend_equation_separate \
    GL_EXT_blend_func_separate GL_EXT_blend_minmax GL_EXT_blend_subtract \
    GL_EXT_compiled_vertex_array GL_EXT_copy_texture GL_EXT_draw_range_elements GL_EXT_fog_coord \
    GL_EXT_framebuffer_blit GL_EXT_framebuffer_multisample GL_EXT_framebuffer_object \
    GL_EXT_multi_draw_arrays GL_EXT_packed_depth_stencil GL_EXT_packed_pixels \
    GL_EXT_point_parameters GL_EXT_polygon_offset GL_EXT_rescale_normal GL_EXT_secondary_color \
    GL_EXT_separate_specular_color GL_EXT_shadow_funcs GL_EXT_stencil_wrap GL_EXT_subtexture \
    GL_EXT_texture GL_EXT_texture3D GL_EXT_texture_cube_map GL_EXT_texture_edge_clamp \
    GL_EXT_texture_env_add GL_EXT_texture_env_combine GL_EXT_texture_env_dot3 \
    GL_EXT_texture_lod_bias GL_EXT_texture_object GL_EXT_texture_sRGB GL_EXT_vertex_array \
    GL_IBM_texture_mirrored_repeat GL_NV_blend_square GL_NV_packed_depth_stencil \
    GL_NV_texgen_reflection GL_SGIS_generate_mipmap GL_SGIS_texture_border_clamp \
    GL_SGIS_texture_edge_clamp GL_SGIS_texture_lod GL_SUN_multi_draw_arrays ";

impl Context {
    /// `glGetString`: vendor, renderer, version, extensions. `GL_INVALID_ENUM` for other names.
    pub fn get_string(&mut self, name: u32) -> Option<&'static CStr> {
        outside_begin!(self, None);
        Some(match name {
            gl::VENDOR => c"luxel",
            gl::RENDERER => c"luxel",
            gl::VERSION => c"1.5 luxel",
            gl::EXTENSIONS => EXTENSIONS,
            _ => {
                self.error.set(gl::INVALID_ENUM);
                return None;
            }
        })
    }
}
