//! A window with its pixel buffer.

use crate::options::ViewerError;
use luxel::scene::Size;
use softbuffer::{Context, Surface};
use std::num::NonZeroU32;
use std::rc::Rc;
use winit::event_loop::ActiveEventLoop;
use winit::window::{Window, WindowAttributes};

/// A window with its pixel buffer.
pub(crate) struct WindowSurface {
    pub(crate) window: Rc<Window>,
    surface: Surface<Rc<Window>, Rc<Window>>,
}

impl WindowSurface {
    pub(crate) fn open(
        event_loop: &ActiveEventLoop,
        attributes: WindowAttributes,
    ) -> Result<Self, ViewerError> {
        let no_display = |error: String| ViewerError::NoDisplay(error);
        let window = event_loop.create_window(attributes);
        let window = Rc::new(window.map_err(|error| no_display(error.to_string()))?);
        let surface = Context::new(Rc::clone(&window))
            .and_then(|context| Surface::new(&context, Rc::clone(&window)))
            .map_err(|error| no_display(error.to_string()))?;
        Ok(Self { window, surface })
    }

    /// The size in physical pixels, at least 1x1.
    pub(crate) fn size(&self) -> Size {
        let size = self.window.inner_size();
        Size { width: size.width.max(1), height: size.height.max(1) }
    }

    /// Presents the pixels that `paint` fills: 0RGB, row by row from the top.
    pub(crate) fn present(
        &mut self,
        paint: impl FnOnce(&mut [u32], Size),
    ) -> Result<(), ViewerError> {
        let size = self.size();
        let no_display = |error: softbuffer::SoftBufferError| {
            ViewerError::NoDisplay(format!("its pixels can't be reached: {error}"))
        };
        let side = |side: u32| NonZeroU32::new(side).unwrap_or(NonZeroU32::MIN);
        self.surface.resize(side(size.width), side(size.height)).map_err(no_display)?;
        let mut buffer = self.surface.buffer_mut().map_err(no_display)?;
        paint(&mut buffer, size);
        buffer.present().map_err(no_display)
    }
}
