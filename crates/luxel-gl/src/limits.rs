//! Limits that programs can ask for (OpenGL 1.5, tables 6.29 to 6.31).

/// `GL_MAX_LIGHTS`
pub(crate) const LIGHTS: usize = 8;
/// `GL_MAX_CLIP_PLANES`
pub(crate) const CLIP_PLANES: usize = 8;
/// `GL_MAX_TEXTURE_UNITS`
pub(crate) const TEXTURE_UNITS: usize = 8;
/// `GL_MAX_MODELVIEW_STACK_DEPTH`
pub(crate) const MODELVIEW_DEPTH: usize = 32;
/// `GL_MAX_PROJECTION_STACK_DEPTH`
pub(crate) const PROJECTION_DEPTH: usize = 32;
/// `GL_MAX_TEXTURE_STACK_DEPTH`
pub(crate) const TEXTURE_DEPTH: usize = 10;
/// `GL_MAX_ATTRIB_STACK_DEPTH` and `GL_MAX_CLIENT_ATTRIB_STACK_DEPTH`
pub(crate) const ATTRIBUTE_DEPTH: usize = 16;
/// `GL_MAX_LIST_NESTING`
pub(crate) const LIST_NESTING: usize = 64;
/// `GL_MAX_VIEWPORT_DIMS`: what a side of a framebuffer can be.
pub(crate) const VIEWPORT: i32 = 16384;
/// The largest size of points and width of lines.
pub(crate) const LARGEST_SIZE: f32 = 255.0;
/// Bits of a position in the window below the pixel.
pub(crate) const SUBPIXEL_BITS: i32 = 8;
/// Vertices between `glBegin` and `glEnd`: beyond that, `GL_OUT_OF_MEMORY`.
pub(crate) const STREAM_VERTICES: usize = 1 << 24;
/// Vertices after which a stream of independent primitives is drawn in part; a multiple of all their lengths.
pub(crate) const PART_VERTICES: usize = 12 << 16;
/// Vertices that wait after `glEnd` for more: as many as are worth two threads' while.
pub(crate) const WAITING_VERTICES: usize = 1 << 14;
/// Commands of all display lists together: beyond that, `GL_OUT_OF_MEMORY`.
pub(crate) const LIST_COMMANDS: usize = 1 << 26;
/// Commands that one call of lists executes, however they call one another: beyond that, `GL_OUT_OF_MEMORY`. Lists that
/// call lists twice each would keep a program for ever.
pub(crate) const EXECUTED_COMMANDS: u64 = 1 << 27;
/// `GL_MAX_SAMPLES`
pub(crate) const MOST_SAMPLES: i32 = 4;
/// Names of renderbuffers.
pub(crate) const RENDERBUFFER_NAMES: usize = 1 << 22;
/// Names of framebuffer objects.
pub(crate) const FRAMEBUFFER_NAMES: usize = 1 << 22;
/// Names of queries.
pub(crate) const QUERY_NAMES: usize = 1 << 22;
/// Names of buffer objects.
pub(crate) const BUFFER_NAMES: usize = 1 << 22;
/// Bytes that the log of draws holds before it is carried out.
pub(crate) const LOG_BYTES: usize = 64 << 20;
/// `GL_MAX_TEXTURE_SIZE`
pub(crate) const TEXTURE_SIDE: u32 = 16384;
/// `GL_MAX_3D_TEXTURE_SIZE`
pub(crate) const TEXTURE_3D_SIDE: u32 = 2048;
/// `GL_MAX_CUBE_MAP_TEXTURE_SIZE`
pub(crate) const CUBE_SIDE: u32 = 16384;
/// Levels of a texture of the largest side.
pub(crate) const TEXTURE_LEVELS: usize = TEXTURE_SIDE.ilog2() as usize + 1;
/// Texels of one image: beyond that, `GL_OUT_OF_MEMORY`.
pub(crate) const TEXELS: usize = 1 << 28;
/// Bytes of all images of a group of contexts: beyond that, `GL_OUT_OF_MEMORY`.
pub(crate) const TEXTURE_BYTES: usize = 4 << 30;
/// Names of textures: beyond that, `GL_OUT_OF_MEMORY`.
pub(crate) const TEXTURE_NAMES: usize = 1 << 22;
/// `GL_MAX_PIXEL_MAP_TABLE`
pub(crate) const PIXEL_MAP: i32 = 256;
/// `GL_MAX_EVAL_ORDER`
pub(crate) const EVALUATOR_ORDER: i32 = 30;
/// `GL_MAX_TEXTURE_LOD_BIAS`
pub(crate) const LOD_BIAS: f32 = 16.0;
