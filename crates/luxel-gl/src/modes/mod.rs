//! What happens to primitives beside rendering: selection and feedback.

mod feedback;
mod select;

pub(crate) use feedback::FeedbackMode;
pub(crate) use select::SelectionMode;
