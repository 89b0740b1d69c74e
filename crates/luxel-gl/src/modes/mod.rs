//! What happens to primitives beside rendering: selection and feedback.

mod feedback;
mod hits;
mod select;
mod tokens;

pub(crate) use feedback::{FEEDBACK_PARTS, FeedbackMode};
pub(crate) use hits::HitVisitor;
pub(crate) use select::{NameChange, SelectionMode};
pub(crate) use tokens::{FeedbackVisitor, UsedVisitor};
