//! One context: all of its state, and the rules that every command obeys.

use crate::enums as gl;
use crate::error::ErrorFlag;
use crate::modes::{FeedbackMode, SelectionMode};
use crate::objects::buffer::Buffers;
use crate::objects::framebuffer::FramebufferObjects;
use crate::objects::list::{Command, Lists, OpenList};
use crate::objects::query::Queries;
use crate::objects::renderbuffer::Renderbuffers;
use crate::raster::{Framebuffer, Log};
use crate::state::Attributes;
use crate::state::evaluator::Maps;
use crate::state::matrices::Matrices;
use crate::state::pixel::Client;
use crate::state::transfer::PixelMaps;
use crate::texture::{TextureImage, Textures};
use crate::vertex::{Stream, Vertices};
use luxel_math::{Level, SimdLevel};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What a context's framebuffer consists of: the arguments of `OSMesaCreateContextExt`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Configuration {
    /// Bits of depth; 0 for no depth buffer, else there are 24.
    pub depth_bits: u32,
    /// Bits of the stencil buffer; 0 for none, else there are 8.
    pub stencil_bits: u32,
    /// Bits of a component of the accumulation buffer; 0 for none.
    pub accum_bits: u32,
    /// Whether colours have alpha; without it reads return 1.
    pub alpha: bool,
}

impl Default for Configuration {
    /// 24 bits of depth, 8 of stencil, alpha.
    fn default() -> Self {
        Self { depth_bits: 24, stencil_bits: 8, accum_bits: 0, alpha: true }
    }
}

/// One GL context. Each command of the API is a method.
///
/// A command that the specification doesn't allow sets the error flag and changes nothing else.
#[derive(Debug)]
pub struct Context {
    pub(crate) configuration: Configuration,
    pub(crate) level: Level,
    pub(crate) error: ErrorFlag,
    pub(crate) state: Attributes,
    pub(crate) matrices: Matrices,
    pub(crate) client: Client,
    pub(crate) attribute_stack: Vec<(u32, Box<Attributes>)>,
    pub(crate) client_stack: Vec<(u32, Client)>,
    /// What is between `glBegin` and `glEnd`, or waits to be drawn.
    pub(crate) stream: Stream,
    pub(crate) maps: Maps,
    pub(crate) shared: Arc<Mutex<Lists>>,
    pub(crate) textures: Arc<Mutex<Textures>>,
    /// Images of proxies, without texels, by target and level.
    pub(crate) proxies: BTreeMap<(usize, usize), TextureImage>,
    pub(crate) shared_buffers: Arc<Mutex<Buffers>>,
    pub(crate) shared_renderbuffers: Arc<Mutex<Renderbuffers>>,
    pub(crate) framebuffers: FramebufferObjects,
    pub(crate) queries: Queries,
    pub(crate) pixel_maps: Arc<PixelMaps>,
    /// Sums of the default framebuffer, row by row; none before the first use.
    pub(crate) accumulation: Vec<[f32; 4]>,
    /// The default framebuffer, while an object is drawn to.
    pub(crate) parked: Framebuffer,
    pub(crate) list: Option<OpenList>,
    /// Memory for vertices of the next list, which the system doesn't have to clear again.
    pub(crate) list_room: Vertices,
    /// How many lists call one another at the moment.
    pub(crate) nesting: usize,
    /// Commands that lists may still execute in this call.
    pub(crate) executable: u64,
    pub(crate) render_mode: u32,
    pub(crate) selection: SelectionMode,
    pub(crate) feedback: FeedbackMode,
    pub(crate) framebuffer: Framebuffer,
    pub(crate) log: Log,
    /// Whether the default framebuffer has had a size.
    pub(crate) sized: bool,
    /// Whether there is a default framebuffer.
    pub(crate) has_default: bool,
    /// Whether something was drawn that the caller's colour buffer doesn't show.
    pub(crate) drawn: bool,
}

impl Context {
    /// A context with its own lists and textures. Its framebuffer has no pixels until
    /// [`resize_default`](Self::resize_default).
    #[must_use]
    pub fn new(configuration: Configuration) -> Self {
        Self::with_shared(configuration, Arc::default(), Arc::default())
    }

    /// A context that shares lists, textures and buffer objects with another one.
    #[must_use]
    pub fn sharing(configuration: Configuration, other: &Self) -> Self {
        let (lists, textures) = (Arc::clone(&other.shared), Arc::clone(&other.textures));
        let mut context = Self::with_shared(configuration, lists, textures);
        context.shared_buffers = Arc::clone(&other.shared_buffers);
        context.shared_renderbuffers = Arc::clone(&other.shared_renderbuffers);
        context
    }

    fn with_shared(
        configuration: Configuration,
        shared: Arc<Mutex<Lists>>,
        textures: Arc<Mutex<Textures>>,
    ) -> Self {
        Self {
            configuration,
            level: SimdLevel::Auto.resolve().unwrap_or_else(|_| Level::baseline()),
            error: ErrorFlag::default(),
            state: Attributes::default(),
            matrices: Matrices::new(),
            client: Client::default(),
            attribute_stack: Vec::new(),
            client_stack: Vec::new(),
            stream: Stream::default(),
            maps: Maps::default(),
            shared,
            textures,
            proxies: BTreeMap::new(),
            shared_buffers: Arc::default(),
            shared_renderbuffers: Arc::default(),
            framebuffers: FramebufferObjects::default(),
            queries: Queries::default(),
            pixel_maps: Arc::default(),
            accumulation: Vec::new(),
            parked: Framebuffer::default(),
            list: None,
            list_room: Vertices::default(),
            nesting: 0,
            executable: 0,
            render_mode: gl::RENDER,
            selection: SelectionMode::default(),
            feedback: FeedbackMode::default(),
            framebuffer: Framebuffer::default(),
            log: Log::default(),
            sized: false,
            has_default: false,
            drawn: false,
        }
    }

    /// Selects the instruction set of all kernels, which changes no result.
    ///
    /// # Errors
    /// [`UnavailableSimdLevel`](luxel_math::UnavailableSimdLevel) if this machine lacks it.
    pub fn set_simd_level(
        &mut self,
        level: SimdLevel,
    ) -> Result<(), luxel_math::UnavailableSimdLevel> {
        self.level = level.resolve()?;
        Ok(())
    }

    /// Sets an error, unless one is set already: for what a caller finds wrong with its arguments.
    pub fn set_error(&mut self, error: u32) {
        self.error.set(error);
    }

    /// The error since the last call (`glGetError`, section 2.5). Between `glBegin` and `glEnd` 0.
    pub fn get_error(&mut self) -> u32 {
        if self.stream.is_open() {
            self.error.set(gl::INVALID_OPERATION);
            return 0;
        }
        self.error.take()
    }

    /// Whether this call stands between `glBegin` and `glEnd`, where it isn't allowed: an error. Elsewhere, what waits is
    /// drawn, since the command may change its state.
    #[inline]
    pub(crate) fn is_within_begin(&mut self) -> bool {
        if self.stream.is_open() {
            self.error.set(gl::INVALID_OPERATION);
            return true;
        }
        if self.stream.is_waiting() {
            self.draw_waiting();
        }
        false
    }

    /// Whether commands go into a list.
    #[inline(always)]
    pub(crate) fn is_compiling(&self) -> bool {
        self.list.is_some() && self.nesting == 0
    }

    /// Puts something into the list that is open; whether it is to be left at that.
    pub(crate) fn put_in_list(
        &mut self,
        put: impl FnOnce(&mut OpenList) -> Result<(), u32>,
    ) -> bool {
        let Some(list) = &mut self.list else { return false };
        if let Err(error) = put(list) {
            self.error.set(error);
        }
        list.mode == gl::COMPILE
    }

    /// Puts a command into the list that is open; whether it is to be left at that.
    pub(crate) fn compile(&mut self, command: Command) -> bool {
        self.put_in_list(|list| list.push(command))
    }

    pub(crate) fn textures(&self) -> MutexGuard<'_, Textures> {
        self.textures.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn renderbuffers(&self) -> MutexGuard<'_, Renderbuffers> {
        self.shared_renderbuffers.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn buffers(&self) -> MutexGuard<'_, Buffers> {
        self.shared_buffers.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn lists(&self) -> MutexGuard<'_, Lists> {
        self.shared.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Puts a command into the open list, if there is one, and returns from the method if it isn't to be executed, too.
macro_rules! compile {
    ($context:ident, $command:expr) => {
        if $context.is_compiling() && $context.compile($command) {
            return;
        }
    };
}

/// Puts a vertex or attributes of the next one into the open list, if there is one, and returns from the method if they
/// aren't to be executed, too.
macro_rules! record {
    ($context:ident, |$list:ident| $put:expr) => {
        if $context.is_compiling() && $context.put_in_list(|$list| $put) {
            return;
        }
    };
}

/// Returns from the method with `GL_INVALID_OPERATION` between `glBegin` and `glEnd`.
macro_rules! outside_begin {
    ($context:ident) => {
        if $context.is_within_begin() {
            return;
        }
    };
    ($context:ident, $otherwise:expr) => {
        if $context.is_within_begin() {
            return $otherwise;
        }
    };
}

/// Returns from the method with an error unless a condition holds.
macro_rules! demand {
    ($context:ident, $condition:expr, $error:expr) => {
        // NaN holds no comparison.
        let holds: bool = $condition;
        if !holds {
            $context.error.set($error);
            return;
        }
    };
}

pub(crate) use {compile, demand, outside_begin, record};

/// The first values of a slice, zeros where there are fewer.
pub(crate) fn first_values<T: Copy + Default, const N: usize>(values: &[T]) -> [T; N] {
    std::array::from_fn(|at| values.get(at).copied().unwrap_or_default())
}
