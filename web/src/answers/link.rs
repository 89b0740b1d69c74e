//! How the module that draws comes by the one that answers.

use crate::answers::{ANSWERS, Answers};
use crate::error::exception;
use std::pin::pin;
use std::sync::OnceLock;
use std::task::{Context, Poll, Waker};
use wasm_bindgen::prelude::*;
use wasm_split_helpers::{SplitLoaderError, wasm_split};

static LINKED: OnceLock<&'static Answers> = OnceLock::new();

/// What answers.
///
/// # Errors
/// An exception before [`link_answers`] has been called.
pub(crate) fn answers() -> Result<&'static Answers, JsError> {
    let linked = LINKED.get().copied();
    linked.ok_or_else(|| exception("the module that answers has not been linked"))
}

/// In the module that answers, as is all that is reached from here alone.
#[wasm_split(answers, fallible)]
fn table() -> Result<&'static Answers, SplitLoaderError> {
    Ok(&ANSWERS)
}

/// Links the module that answers, which JavaScript has compiled.
///
/// # Errors
/// An exception if it is not the one that was built with this module, or memory is short.
#[wasm_bindgen]
pub fn link_answers() -> Result<(), JsError> {
    let mut table = pin!(table());
    let mut context = Context::from_waker(Waker::noop());
    // JavaScript links within the first poll, and the second one returns.
    for _ in 0..2 {
        if let Poll::Ready(Ok(answers)) = table.as_mut().poll(&mut context) {
            LINKED.get_or_init(|| answers);
            return Ok(());
        }
    }
    Err(exception("the module that answers can't be linked"))
}
