//! Selection and feedback (OpenGL 1.5, sections 5.2 and 5.3).

use crate::Context;
use crate::context::{compile, outside_begin};
use crate::enums as gl;
use crate::modes::NameChange;
use crate::objects::list::Command;

/// What is written to the program's memory when selection or feedback mode ends.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Words {
    /// Nothing: rendering has ended.
    #[default]
    None,
    /// Hit records: the number of names, two depths, the names.
    Selection(Vec<u32>),
    /// Tokens and values.
    Feedback(Vec<f32>),
}

/// What `glRenderMode` returns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RenderModeResult {
    /// Hit records or values; -1 if there was no room for all; 0 when rendering has ended.
    pub count: i32,
    /// What goes to the buffer of the mode that has ended. It fits.
    pub words: Words,
}

impl Context {
    /// `glRenderMode`: ends a mode, and begins another one. `GL_INVALID_OPERATION` if the buffer of the new mode
    /// has not been set.
    pub fn render_mode(&mut self, mode: u32) -> RenderModeResult {
        outside_begin!(self, RenderModeResult::default());
        let has_buffer = match mode {
            gl::RENDER => true,
            gl::SELECT => self.selection.has_buffer(),
            gl::FEEDBACK => self.feedback.has_buffer(),
            _ => {
                self.error.set(gl::INVALID_ENUM);
                return RenderModeResult::default();
            }
        };
        if !has_buffer {
            self.error.set(gl::INVALID_OPERATION);
            return RenderModeResult::default();
        }
        let result = match self.render_mode {
            gl::SELECT => {
                let (count, words) = self.selection.finish();
                RenderModeResult { count, words: Words::Selection(words) }
            }
            gl::FEEDBACK => {
                let (count, values) = self.feedback.finish();
                RenderModeResult { count, words: Words::Feedback(values) }
            }
            _ => RenderModeResult::default(),
        };
        match mode {
            gl::SELECT => self.selection.start(),
            gl::FEEDBACK => self.feedback.start(),
            _ => {}
        }
        self.render_mode = mode;
        result
    }

    /// `glSelectBuffer`: how many words there is room for. False, with an error recorded, if that isn't taken.
    pub fn select_buffer(&mut self, size: i32) -> bool {
        outside_begin!(self, false);
        let error = if size < 0 {
            gl::INVALID_VALUE
        } else if self.render_mode == gl::SELECT {
            gl::INVALID_OPERATION
        } else {
            self.selection.set_room(size as usize);
            return true;
        };
        self.error.set(error);
        false
    }

    /// `glFeedbackBuffer`: how many values there is room for, and what is written of each vertex. False, with an
    /// error recorded, if that isn't taken.
    pub fn feedback_buffer(&mut self, size: i32, of: u32) -> bool {
        outside_begin!(self, false);
        let error = if size < 0 {
            gl::INVALID_VALUE
        } else if !(gl::_2D..=gl::_4D_COLOR_TEXTURE).contains(&of) {
            gl::INVALID_ENUM
        } else if self.render_mode == gl::FEEDBACK {
            gl::INVALID_OPERATION
        } else {
            self.feedback.set_buffer(size as usize, of);
            return true;
        };
        self.error.set(error);
        false
    }

    /// `glInitNames`. Like all commands on names it has no effect outside of selection.
    pub fn init_names(&mut self) {
        compile!(self, Command::InitNames);
        self.change_names(NameChange::Init);
    }

    /// `glLoadName`. `GL_INVALID_OPERATION` if the stack is empty.
    pub fn load_name(&mut self, name: u32) {
        compile!(self, Command::LoadName(name));
        self.change_names(NameChange::Load(name));
    }

    /// `glPushName`. `GL_STACK_OVERFLOW` if the stack is full.
    pub fn push_name(&mut self, name: u32) {
        compile!(self, Command::PushName(name));
        self.change_names(NameChange::Push(name));
    }

    /// `glPopName`. `GL_STACK_UNDERFLOW` if the stack is empty.
    pub fn pop_name(&mut self) {
        compile!(self, Command::PopName);
        self.change_names(NameChange::Pop);
    }

    /// Changes the names of what is drawn from now on. What waits to be drawn goes on waiting.
    fn change_names(&mut self, change: NameChange) {
        if self.stream.is_open() {
            self.error.set(gl::INVALID_OPERATION);
        } else if self.render_mode == gl::SELECT {
            let result = self.selection.change(change, self.stream.waiting());
            if let Err(error) = result {
                self.error.set(error);
            }
            if self.selection.is_full() {
                self.draw_waiting();
            }
        }
    }

    /// `glPassThrough`: a marker in the feedback buffer.
    pub fn pass_through(&mut self, mark: f32) {
        compile!(self, Command::PassThrough(mark));
        outside_begin!(self);
        if self.render_mode == gl::FEEDBACK {
            self.feedback.pass_through(mark);
        }
    }
}
