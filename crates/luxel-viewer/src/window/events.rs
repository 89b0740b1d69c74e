//! Events of the window and of the worker.

use super::surface::WindowSurface;
use super::{App, UserEvent};
use crate::options::{Outcome, ViewerError};
use crate::render::{WorkerEvent, WorkerMessage};
use luxel::scene::{DVec2, Size};
use std::time::Instant;
use winit::application::ApplicationHandler;
use winit::dpi::{LogicalSize, PhysicalPosition};
use winit::event::{ElementState, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow};
use winit::keyboard::{Key, NamedKey};
use winit::window::{Window, WindowId};

impl ApplicationHandler<UserEvent> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.surface.is_some() {
            return;
        }
        let Size { width, height } = self.options.size;
        let attributes = Window::default_attributes()
            .with_title(format!("{} - luxel", self.status.name))
            .with_inner_size(LogicalSize::new(width, height));
        match WindowSurface::open(event_loop, attributes) {
            Ok(surface) => {
                if let Some(session) = &mut self.session {
                    session.resize(surface.size());
                }
                let is_light =
                    surface.window.theme().map(|theme| theme == winit::window::Theme::Light);
                self.ui.set_theme(self.options.theme.theme(is_light));
                self.surface = Some(surface);
            }
            Err(error) => self.end(event_loop, Err(error)),
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, event: UserEvent) {
        let UserEvent::Worker(WorkerMessage { model_number, event }) = event else {
            return self.end(event_loop, Ok(Outcome::Interrupted));
        };
        let is_current = model_number == self.model_number;
        match event {
            // Cancelled, or superseded by another request.
            WorkerEvent::Loaded(_)
                if model_number != self.worker.requested() || self.load_reason.is_none() => {}
            WorkerEvent::Loaded(Err(what)) => {
                if !self.load_failed(what) {
                    self.end(event_loop, Ok(Outcome::NotLoaded));
                }
            }
            WorkerEvent::Loaded(Ok(loaded)) => self.load_finished(*loaded),
            WorkerEvent::Rendered(frame) => {
                self.is_rendering = false;
                if is_current {
                    self.frame_rendered(frame);
                }
                // The next frame is rendered while this one is presented.
                self.update();
            }
            WorkerEvent::Interrupted => self.interrupted(),
            WorkerEvent::VisibleObjects(visible) if is_current => {
                if let Some(frame) = &mut self.frame {
                    frame.visible = visible;
                }
                self.is_base_stale = true;
                self.redraw();
            }
            WorkerEvent::VisibleObjects(_) => {}
            WorkerEvent::SelectedObjects(selected) => {
                self.is_selecting = false;
                if let Some(frame) = self.frame.as_mut().filter(|_| is_current) {
                    frame.selected = Some(selected);
                    self.is_base_stale = true;
                    self.redraw();
                }
            }
            WorkerEvent::Explained(explained) => {
                self.is_explaining = false;
                if is_current {
                    self.set_explanation(explained);
                }
            }
            WorkerEvent::Failed(what) => self.end(event_loop, Err(ViewerError::Draw(what))),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::Resized(_) => {
                if let (Some(surface), Some(session)) = (&self.surface, &mut self.session) {
                    session.resize(surface.size());
                }
                self.redraw();
            }
            WindowEvent::RedrawRequested => {
                if let Err(error) = self.paint() {
                    self.end(event_loop, Err(error));
                }
            }
            WindowEvent::ModifiersChanged(modifiers) => {
                self.modifiers = modifiers.state();
                self.ui.modifiers = egui::Modifiers {
                    alt: self.modifiers.alt_key(),
                    ctrl: self.modifiers.control_key(),
                    shift: self.modifiers.shift_key(),
                    mac_cmd: false,
                    command: self.modifiers.control_key(),
                };
            }
            WindowEvent::ThemeChanged(theme) => {
                let is_light = theme == winit::window::Theme::Light;
                self.ui.set_theme(self.options.theme.theme(Some(is_light)));
                self.is_base_stale = true;
                self.redraw();
            }
            WindowEvent::DroppedFile(path) => self.open(path),
            WindowEvent::Focused(false) => self.release_all(),
            WindowEvent::KeyboardInput { event, .. } => {
                if event.state == ElementState::Released {
                    self.release_key(&event.logical_key);
                }
                let is_pressed = event.state == ElementState::Pressed;
                let escapes = event.logical_key == Key::Named(NamedKey::Escape);
                if is_pressed && escapes && self.ui.close_popup() {
                    self.redraw();
                } else if !self.forward_key(&event) && is_pressed {
                    if !event.repeat {
                        self.press_key(event_loop, event.logical_key);
                    } else if self.ui.shows_help {
                        self.handle_help_key(&event.logical_key);
                    }
                }
            }
            WindowEvent::CursorMoved { position: PhysicalPosition { x, y }, .. } => {
                self.pointer = DVec2::new(x, y);
                self.is_pointer_in = true;
                if self.held_button.is_some() {
                    self.drag();
                } else {
                    let position = self.pointer_in_points();
                    self.ui.events.push(egui::Event::PointerMoved(position));
                    self.redraw();
                }
            }
            WindowEvent::CursorLeft { .. } => {
                self.is_pointer_in = false;
                self.ui.events.push(egui::Event::PointerGone);
                self.redraw();
            }
            WindowEvent::MouseInput { state: ElementState::Pressed, button, .. } => {
                self.press_button(button);
            }
            WindowEvent::MouseInput { state: ElementState::Released, button, .. } => {
                self.release_button(button);
            }
            WindowEvent::MouseWheel { delta, .. } => self.handle_wheel(delta),
            _ => {}
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        let now = Instant::now();
        if self.note_until.is_some_and(|until| until <= now) {
            self.note_until = None;
            self.status.note = None;
            self.redraw();
        }
        if self.repaint_at.is_some_and(|when| when <= now) {
            self.repaint_at = None;
            self.redraw();
        }
        let next = [self.update(), self.poll_file(), self.note_until, self.repaint_at]
            .into_iter()
            .flatten()
            .min();
        event_loop.set_control_flow(next.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
    }
}
