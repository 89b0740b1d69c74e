//! glGetPointerv (6.1.11).

use crate::client::Client;
use luxel_gl::Context;
use std::ffi::c_void;
use std::ptr;

const FEEDBACK_BUFFER_POINTER: u32 = 0x0DF0;
const SELECTION_BUFFER_POINTER: u32 = 0x0DF3;

/// The address that `pname` names; `None`, with an error set, if it names none.
pub(crate) fn address(gl: &mut Context, client: &Client, pname: u32) -> Option<*mut c_void> {
    match pname {
        FEEDBACK_BUFFER_POINTER => Some(client.feedback.address().cast()),
        SELECTION_BUFFER_POINTER => Some(client.selection.address().cast()),
        _ => gl.get_pointer(pname).map(ptr::with_exposed_provenance_mut),
    }
}
