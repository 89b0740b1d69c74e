//! Everything over the picture: the line below it, the axes, the panels, the help.

mod axes;

use crate::compare::Apart;
use crate::divider;
use crate::explain;
use crate::handles::{self, Grab};
use crate::help::help;
use crate::keys::{Action, Keys};
use crate::opener::{self, Opener};
use crate::paint::Painter;
use crate::panels;
use crate::probe::Explained;
use crate::ruler;
use crate::session::Session;
use crate::theme::{self, Theme};
pub(crate) use crate::wait::OnItsWay;
use crate::wait::{bar, hint};
use egui::{Context, Frame, Margin, RawInput, Rect, Stroke, vec2};
use luxel::navigation::{Mode, StandardView};
use luxel::report::LedgerLine;
use luxel::scene::{Bounds, Size};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// What the user asks for in the panels.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Wish {
    /// A side to look from.
    View(StandardView),
    /// A part of the scene into view; all of it.
    Fit(Option<Bounds>),
    /// Another way to navigate.
    Mode(Mode),
    /// Parallel rays or a perspective.
    Lens,
    /// The line of a terminal that draws what is seen.
    Line,
    /// What is seen into a scene file.
    Save,
    /// The dialog that opens a model.
    Ask,
    /// A model.
    Open(PathBuf),
    /// What is being read is not wanted any more.
    StopReading,
    /// A text into the clipboard.
    Copy(String),
}

/// What the line below the picture tells.
#[derive(Clone, Debug, Default)]
pub(crate) struct Status {
    pub(crate) name: String,
    pub(crate) triangles: u64,
    /// Milliseconds of the last picture, and its size in parts of the window's.
    pub(crate) drawn: Option<(f64, f64)>,
    pub(crate) note: Option<String>,
    /// The file that is being read.
    pub(crate) reading: Option<OnItsWay>,
    /// Whether what is seen is the user's, and not what is shown first.
    pub(crate) is_chosen: bool,
    /// How many the file is of how many.
    pub(crate) place: Option<[usize; 2]>,
}

/// Panels, their state, and what paints them.
pub(crate) struct Ui {
    pub(crate) events: Vec<egui::Event>,
    pub(crate) modifiers: egui::Modifiers,
    pub(crate) shows_panels: bool,
    pub(crate) shows_help: bool,
    /// How far the help is to be scrolled down, in points.
    pub(crate) help_by: f32,
    pub(crate) search: String,
    /// The tree's selected object that was last scrolled to, and which part of the tree is seen.
    pub(crate) found: (Option<usize>, std::ops::Range<f32>),
    pub(crate) tab: panels::Tab,
    /// Which panel is unfolded, where there is room for one at most.
    pub(crate) unfolded: Option<panels::Side>,
    /// Whether that is so.
    pub(crate) is_narrow: bool,
    /// The dialog in which a model is named, while it is there.
    pub(crate) opener: Option<Opener>,
    /// The light that is looked at.
    pub(crate) chosen: Option<usize>,
    /// Whether the first control of the panels is to have the keyboard.
    pub(crate) wants_focus: bool,
    /// The handle of a light that is dragged.
    grab: Option<Grab>,
    pub(crate) theme: &'static Theme,
    pub(crate) keys: Keys,
    /// How far two looks are apart, where that is shown.
    pub(crate) apart: Option<Apart>,
    /// Why the pixel under the pointer has its colour.
    pub(crate) explanation: Option<Box<Explained>>,
    /// The same as the lighting equation with its numbers.
    pub(crate) equation: Option<Vec<LedgerLine>>,
    /// Two corners of the rubber band, while it is drawn.
    pub(crate) band: Option<[egui::Pos2; 2]>,
    context: Context,
    painter: Painter,
    begun: Instant,
}

/// What is shown of the panels: whether any, which tab, which side where there is room for one.
pub(crate) type Panels = (bool, panels::Tab, Option<panels::Side>);

/// Narrower than this, in points, panels are folded to icons, and one is unfolded at a time.
const ROOM_FOR_BOTH: f32 = 900.0;
/// What a file's name may take of the line below the picture.
const NAME_SHARE: f32 = 0.4;
/// Letters of an object's name in the line below the picture.
const LONGEST_NAME: usize = 28;

impl Ui {
    pub(crate) fn new(theme: &'static Theme, keys: Keys) -> Self {
        let context = Context::default();
        context.set_style(theme.style());
        Self {
            events: Vec::new(),
            modifiers: egui::Modifiers::NONE,
            shows_panels: false,
            shows_help: false,
            help_by: 0.0,
            search: String::new(),
            found: (None, 0.0..f32::MAX),
            tab: panels::Tab::default(),
            unfolded: None,
            is_narrow: false,
            opener: None,
            chosen: Some(0),
            wants_focus: false,
            grab: None,
            theme,
            keys,
            apart: None,
            explanation: None,
            equation: None,
            band: None,
            context,
            painter: Painter::default(),
            begun: Instant::now(),
        }
    }

    /// What is shown of the panels.
    pub(crate) fn panels(&self) -> Panels {
        (self.shows_panels, self.tab, self.unfolded)
    }

    /// Shows of the panels what was shown before.
    pub(crate) fn show_panels_as(&mut self, panels: Panels) {
        (self.shows_panels, self.tab, self.unfolded) = panels;
    }

    /// Shows the ledger of the pixel under the pointer, or the panels no more.
    pub(crate) fn toggle_ledger(&mut self) {
        self.shows_panels = !self.explains();
        self.tab = panels::Tab::Explain;
        self.unfolded = self.shows_panels.then_some(panels::Side::Settings);
    }

    /// Shows the panels, and puts the keyboard into their first field.
    pub(crate) fn enter_panels(&mut self) {
        self.shows_panels = true;
        self.wants_focus = true;
        self.unfolded.get_or_insert(panels::Side::Settings);
    }

    /// Another theme from now on.
    pub(crate) fn dress(&mut self, theme: &'static Theme) {
        self.theme = theme;
        self.context.set_style(theme.style());
    }

    /// Whether the ledger is to be seen.
    pub(crate) fn explains(&self) -> bool {
        self.shows_settings() && self.tab == panels::Tab::Explain
    }

    /// Whether light, the ledger or the view can be set.
    fn shows_settings(&self) -> bool {
        let is_unfolded = !self.is_narrow || self.unfolded == Some(panels::Side::Settings);
        self.shows_panels && is_unfolded
    }

    /// Whether the pointer is the panels' and not the picture's.
    pub(crate) fn has_pointer(&self) -> bool {
        self.opener.is_some()
            || self.context.wants_pointer_input()
            || self.context.is_pointer_over_area()
    }

    /// Whether keys are typed into a field.
    pub(crate) fn has_keyboard(&self) -> bool {
        self.opener.is_some() || self.context.wants_keyboard_input()
    }

    /// Lays everything out and paints it over the window's pixels; what is asked for, and when it
    /// wants to be painted again.
    pub(crate) fn show(
        &mut self,
        mut session: Option<&mut Session>,
        status: &Status,
        (size, pixels_per_point): (Size, f32),
        pixels: &mut [u32],
    ) -> (Vec<Wish>, Duration) {
        let points = vec2(size.width as f32, size.height as f32) / pixels_per_point;
        self.context.set_pixels_per_point(pixels_per_point);
        let input = RawInput {
            screen_rect: Some(Rect::from_min_size(egui::Pos2::ZERO, points)),
            time: Some(self.begun.elapsed().as_secs_f64()),
            modifiers: self.modifiers,
            events: std::mem::take(&mut self.events),
            ..RawInput::default()
        };
        let mut wishes = Vec::new();
        let context = self.context.clone();
        let output = context.run(input, |context| {
            self.lay_out(context, session.as_deref_mut(), status, &mut wishes);
        });
        for command in output.platform_output.commands {
            if let egui::OutputCommand::CopyText(text) = command {
                wishes.push(Wish::Copy(text));
            }
        }
        self.painter.take(&output.textures_delta);
        let primitives = context.tessellate(output.shapes, pixels_per_point);
        self.painter.paint(&primitives, pixels_per_point, size, pixels);
        self.painter.free(&output.textures_delta);
        let again = output.viewport_output.values().map(|viewport| viewport.repaint_delay).min();
        (wishes, again.unwrap_or(Duration::MAX))
    }

    fn lay_out(
        &mut self,
        context: &Context,
        session: Option<&mut Session>,
        status: &Status,
        wishes: &mut Vec<Wish>,
    ) {
        status_line(context, status, session.as_deref(), &self.keys);
        self.wait(context, status, session.is_some(), wishes);
        let Some(session) = session else { return };
        self.is_narrow = context.content_rect().width() < ROOM_FOR_BOTH;
        if self.shows_panels {
            if self.is_narrow {
                panels::folded(self, context);
            }
            // The tree's objects are in the picture, too.
            if !self.is_narrow || self.unfolded == Some(panels::Side::Tree) {
                panels::tree(self, context, session, wishes);
            }
            if self.shows_settings() {
                panels::settings(self, context, session, wishes);
            }
            if let (true, Some(explanation)) = (self.explains(), &self.explanation) {
                explain::vectors(context, session, &explanation.explanation);
            }
            if self.shows_settings() && self.tab == panels::Tab::Light {
                handles::draw(context, session, &mut self.chosen, &mut self.grab);
            }
        }
        if let Some(apart) = self.apart.filter(|_| session.split().is_some()) {
            divider::scale(context, &apart);
        } else if let Some((split, look)) = session.divider() {
            divider::line(context, split, look);
        }
        ruler::draw(context, session);
        axes::axes(context, session, wishes);
        if let Some([from, to]) = self.band {
            rubber_band(context, Rect::from_two_pos(from, to));
        }
        if self.shows_help {
            let by = std::mem::take(&mut self.help_by);
            help(context, session.state.mode(), &self.keys, by);
        }
    }
}

impl Ui {
    /// What there is to wait for, or to be opened.
    fn wait(
        &mut self,
        context: &Context,
        status: &Status,
        has_model: bool,
        wishes: &mut Vec<Wish>,
    ) {
        if let Some(coming) = &status.reading {
            bar(context, coming, wishes);
        } else if self.opener.is_none() && (!status.is_chosen || !has_model) {
            hint(context, &self.keys);
        }
        let answer = self.opener.as_mut().and_then(|opener| opener::dialog(context, opener));
        if let Some(answer) = answer {
            self.opener = None;
            // Keys are for the picture again.
            context.memory_mut(|memory| {
                if let Some(field) = memory.focused() {
                    memory.surrender_focus(field);
                }
            });
            if let opener::Answer::Open(path) = answer {
                wishes.push(Wish::Open(path));
            }
            context.request_repaint();
        }
    }
}

/// One quiet line below the picture.
fn status_line(context: &Context, status: &Status, session: Option<&Session>, keys: &Keys) {
    let frame = Frame::new().fill(theme::of(context).panel).inner_margin(Margin::symmetric(12, 4));
    let panel = egui::TopBottomPanel::bottom("status").frame(frame).show_separator_line(false);
    panel.exact_height(28.0).show(context, |ui| {
        let from_right = egui::Layout::right_to_left(egui::Align::Center);
        ui.with_layout(from_right, |ui| {
            let (panels, help) = (keys.first_of(Action::Panels), keys.first_of(Action::Help));
            ui.weak(format!("{panels} panels    {help} help"));
            let mut parts = Vec::new();
            if let Some([place, count]) = status.place {
                parts.push(format!("{place} of {count}"));
            }
            match (&status.note, session) {
                (Some(note), _) => parts.push(note.clone()),
                (None, Some(session)) if status.reading.is_none() => {
                    parts.push(match session.marks.hovered {
                        Some(object) => pointed_at(session, object),
                        None => format!("{} triangles", grouped(status.triangles)),
                    });
                    let (selected, hidden) = (session.marks.selected(), session.marks.hidden());
                    for (marked, what) in [(selected, "selected"), (hidden, "hidden")] {
                        if !marked.is_empty() {
                            parts.push(format!("{} {what}", marked.len()));
                        }
                    }
                    if let Some((milliseconds, part)) = status.drawn {
                        let whole = if part < 0.99 {
                            format!(" at {:.0} %", part * 100.0)
                        } else {
                            String::new()
                        };
                        parts.push(format!("{milliseconds:.0} ms{whole}"));
                    }
                    parts.push(session.state.mode().to_string());
                }
                (None, _) => {
                    let coming = status.reading.as_ref().map(|coming| &coming.name);
                    let other = coming.filter(|name| **name != status.name);
                    let other = other.map(|name| format!("{name} ")).unwrap_or_default();
                    if coming.is_some() {
                        parts.push(format!("{other}is being read"));
                    }
                }
            }
            // What is left of the line is theirs, and no more of it.
            let rest = ui.available_size();
            let from_left = egui::Layout::left_to_right(egui::Align::Center);
            ui.allocate_ui_with_layout(rest, from_left, |ui| {
                ui.scope(|ui| {
                    ui.set_max_width(rest.x * NAME_SHARE);
                    ui.add(egui::Label::new(&status.name).truncate());
                });
                let told = egui::RichText::new(parts.join("   ")).weak();
                ui.add(egui::Label::new(told).truncate());
            });
        });
    });
}

/// The object under the pointer, with its triangles.
fn pointed_at(session: &Session, object: usize) -> String {
    let Some(one) = session.objects.get(object) else { return String::new() };
    let scene = &session.model.scene;
    let name = &scene.nodes[one.node.index()].name;
    let triangles = scene.meshes[one.mesh.index()].triangles.len() as u64;
    // Long names leave room for the rest.
    let short: String = name.chars().take(LONGEST_NAME).collect();
    let dots = if short.len() < name.len() { "..." } else { "" };
    format!("{short}{dots}, {} triangles", grouped(triangles))
}

/// The rectangle in which objects are selected when the button comes up.
fn rubber_band(context: &Context, rect: Rect) {
    let painter = context.layer_painter(egui::LayerId::background());
    let accent = theme::of(context).accent;
    painter.rect_filled(rect, 0, accent.gamma_multiply(0.1));
    let line = Stroke::new(1.0, accent);
    painter.rect_stroke(rect, 0, line, egui::StrokeKind::Inside);
}

/// A number with gaps between thousands.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests;
