//! Writes logs.

use super::{Change, Entry, LOG_VERSION, Log, NAME};
use crate::event::Event;
use glam::{DMat4, DVec2, DVec3};
use luxel_scene::{Bounds, Lens};
use std::fmt::{self, Display, Formatter};

impl Display for Log {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        writeln!(formatter, "{NAME} {LOG_VERSION}")?;
        self.entries.iter().try_for_each(|entry| writeln!(formatter, "{entry}"))
    }
}

impl Display for Entry {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Set(change) => write!(formatter, "set {change}"),
            Self::Event { seconds, event } if *seconds == 0.0 => write!(formatter, "{event}"),
            Self::Event { seconds, event } => write!(formatter, "+{} {event}", Exact(*seconds)),
        }
    }
}

impl Display for Change {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Size(size) => write!(formatter, "size {} {}", size.width, size.height),
            Self::Lens(lens) => match lens {
                Lens::Perspective { fov_y_radians } => {
                    write!(formatter, "lens perspective {}", Exact(fov_y_radians))
                }
                Lens::Orthographic { height } => {
                    write!(formatter, "lens orthographic {}", Exact(height))
                }
                Lens::Intrinsics { fx, fy, cx, cy } => {
                    write!(formatter, "lens intrinsics")?;
                    numbers(formatter, &[fx, fy, cx, cy])
                }
            },
            Self::Up(up) => {
                write!(formatter, "up")?;
                numbers(formatter, &up.to_array())
            }
            Self::Bounds(bounds) => {
                write!(formatter, "bounds")?;
                box_corners(formatter, &bounds)
            }
            Self::Number(number, value) => write!(formatter, "{} {}", number.name(), Exact(value)),
        }
    }
}

impl Display for Event {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Wait => write!(formatter, "wait"),
            Self::Mode(mode) => write!(formatter, "mode {mode}"),
            Self::Grab { gesture, at, point } => {
                write!(formatter, "grab {gesture}")?;
                pointer(formatter, *at, *point)
            }
            Self::Drag { at } => {
                write!(formatter, "drag")?;
                pointer(formatter, *at, None)
            }
            Self::Release => write!(formatter, "release"),
            Self::Wheel { notches, at, point } => {
                write!(formatter, "wheel {}", Exact(*notches))?;
                pointer(formatter, *at, *point)
            }
            Self::Press(command) => write!(formatter, "press {command}"),
            Self::Lift(command) => write!(formatter, "lift {command}"),
            Self::Tap { command, steps } if *steps == 1.0 => write!(formatter, "tap {command}"),
            Self::Tap { command, steps } => write!(formatter, "tap {command} {}", Exact(*steps)),
            Self::Pivot(pivot) => {
                write!(formatter, "pivot")?;
                numbers(formatter, &pivot.to_array())
            }
            Self::View(view) => write!(formatter, "view {view}"),
            Self::Fit(None) => write!(formatter, "fit"),
            Self::Fit(Some(bounds)) => {
                write!(formatter, "fit")?;
                box_corners(formatter, bounds)
            }
            Self::Level => write!(formatter, "level"),
            Self::Go { view_from_world, pivot, scale } => {
                write!(formatter, "go")?;
                matrix(formatter, view_from_world)?;
                numbers(formatter, &pivot.to_array())?;
                numbers(formatter, &[*scale])
            }
            Self::Place(view_from_world) => {
                write!(formatter, "place")?;
                matrix(formatter, view_from_world)
            }
        }
    }
}

fn pointer(formatter: &mut Formatter<'_>, at: DVec2, point: Option<DVec3>) -> fmt::Result {
    numbers(formatter, &at.to_array())?;
    match point {
        Some(point) => {
            write!(formatter, " on")?;
            numbers(formatter, &point.to_array())
        }
        None => Ok(()),
    }
}

fn box_corners(formatter: &mut Formatter<'_>, bounds: &Bounds) -> fmt::Result {
    numbers(formatter, &bounds.min.to_array())?;
    numbers(formatter, &bounds.max.to_array())
}

fn matrix(formatter: &mut Formatter<'_>, matrix: &DMat4) -> fmt::Result {
    numbers(formatter, &matrix.to_cols_array())
}

fn numbers(formatter: &mut Formatter<'_>, numbers: &[f64]) -> fmt::Result {
    numbers.iter().try_for_each(|&number| write!(formatter, " {}", Exact(number)))
}

/// A number in the fewest digits that read back to the same bits.
struct Exact(f64);

impl Display for Exact {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        /// Numbers in this range are shorter without an exponent.
        const PLAIN: std::ops::Range<f64> = 1e-5..1e16;
        let Self(number) = self;
        if *number == 0.0 || PLAIN.contains(&number.abs()) {
            write!(formatter, "{number}")
        } else {
            write!(formatter, "{number:e}")
        }
    }
}
