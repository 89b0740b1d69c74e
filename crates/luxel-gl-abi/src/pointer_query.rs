//! glGetPointerv (6.1.11).

use crate::client::Client;
use luxel_gl::Context;
use std::ffi::c_void;

const FEEDBACK_BUFFER_POINTER: u32 = 0x0DF0;
const SELECTION_BUFFER_POINTER: u32 = 0x0DF3;
const INVALID_ENUM: u32 = 0x0500;

/// The address that `pname` names; `None`, with GL_INVALID_ENUM set, if it names none.
pub(crate) fn address(gl: &mut Context, client: &Client, pname: u32) -> Option<*mut c_void> {
    match pname {
        FEEDBACK_BUFFER_POINTER => Some(client.feedback.address().cast()),
        SELECTION_BUFFER_POINTER => Some(client.selection.address().cast()),
        _ => {
            gl.set_error(INVALID_ENUM);
            None
        }
    }
}
