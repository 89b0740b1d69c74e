//! Contexts (EGL 1.5, 3.7): of OpenGL up to 1.5, with a configuration or without, with a pbuffer or without.

use super::config::{CONFIG_ID, check_config, check_display, pairs};
use super::error::{
    BAD_ATTRIBUTE, BAD_CONTEXT, BAD_MATCH, BAD_PARAMETER, BAD_SURFACE, answer, succeeds,
};
use super::surface::find;
use super::vendor::current_api;
use crate::client::Client;
use crate::current::{self, Bound};
use crate::entry::{call_uncaught, caught};
use crate::memory::store;
use crate::window::{Format, Window};
use luxel_gl::{Configuration, Context};
use std::ffi::c_void;

const OPENGL_API: u32 = 0x30A2;
const CONTEXT_CLIENT_TYPE: i32 = 0x3097;
const CONTEXT_MAJOR_VERSION: i32 = 0x3098;
const CONTEXT_MINOR_VERSION: i32 = 0x30FB;
const CONTEXT_FLAGS: i32 = 0x30FC;
const CONTEXT_PROFILE_MASK: i32 = 0x30FD;
const CONTEXT_OPENGL_DEBUG: i32 = 0x31B0;
const RENDER_BUFFER: i32 = 0x3086;
const BACK_BUFFER: i32 = 0x3084;

/// The display, a configuration or null, a context to share objects with or null, and a list of attributes.
pub(super) unsafe extern "C" fn create_context(
    display: *mut c_void,
    config: *mut c_void,
    share: *mut Bound,
    attributes: *const i32,
) -> *mut Bound {
    // SAFETY: the caller ends the list by NONE.
    let asked = unsafe { pairs(attributes) };
    let created = || {
        check_display(display)?;
        if !config.is_null() {
            check_config(config)?;
        }
        if current_api() != OPENGL_API {
            return Err(BAD_MATCH);
        }
        let mut version = (1, 0);
        for (name, value) in asked {
            match name {
                CONTEXT_MAJOR_VERSION => version.0 = value,
                CONTEXT_MINOR_VERSION => version.1 = value,
                // Profiles are of versions above; that of a debug context is to be the same.
                CONTEXT_PROFILE_MASK | CONTEXT_OPENGL_DEBUG => {}
                CONTEXT_FLAGS if value & !1 == 0 => {}
                _ => return Err(BAD_ATTRIBUTE),
            }
        }
        if version.0 != 1 || !(0..=5).contains(&version.1) {
            return Err(BAD_MATCH);
        }
        let bits = Configuration { depth_bits: 24, stencil_bits: 8, accum_bits: 16, alpha: true };
        let gl = if share.is_null() {
            Context::new(bits)
        } else {
            let shared = current::inspect(share, |shared| Context::sharing(bits, &shared.gl));
            shared.ok_or(BAD_CONTEXT)?
        };
        let client = Client::new(Window::new(Format::DEFAULT, 24));
        Ok(current::insert(Bound { gl, client }))
    };
    caught(|| answer(created()))
}

/// A context that is current lives on until it is left.
pub(super) extern "C" fn destroy_context(display: *mut c_void, context: *mut Bound) -> u32 {
    let destroyed = check_display(display)
        .and_then(|()| if current::destroy_when_left(context) { Ok(()) } else { Err(BAD_CONTEXT) });
    caught(|| succeeds(destroyed))
}

/// Surfaces are both null, or one pbuffer.
pub(super) extern "C" fn make_current(
    display: *mut c_void,
    draw: *mut c_void,
    read: *mut c_void,
    context: *mut Bound,
) -> u32 {
    let made = || {
        if context.is_null() {
            if !draw.is_null() || !read.is_null() {
                return Err(BAD_MATCH);
            }
            caught(|| call_uncaught(|gl, _| gl.flush()));
            current::leave();
            return Ok(());
        }
        check_display(display)?;
        let pbuffer = match (draw.is_null(), read.is_null()) {
            (true, true) => None,
            (false, false) if draw == read => Some(find(draw)?),
            (false, false) => return Err(BAD_MATCH),
            _ => return Err(BAD_SURFACE),
        };
        if context != current::current() {
            caught(|| call_uncaught(|gl, _| gl.flush()));
        }
        if !current::make_current(context) {
            return Err(BAD_CONTEXT);
        }
        caught(|| {
            call_uncaught(|gl, _| match pbuffer {
                Some(pbuffer) => {
                    let [width, height] = [pbuffer.width, pbuffer.height].map(i32::cast_unsigned);
                    gl.resize_default(width, height);
                }
                None => gl.remove_default(),
            });
        });
        Ok(())
    };
    caught(|| succeeds(made()))
}

pub(super) unsafe extern "C" fn query_context(
    display: *mut c_void,
    context: *mut Bound,
    name: i32,
    value: *mut i32,
) -> u32 {
    let found = || {
        check_display(display)?;
        if !current::is_context(context) {
            return Err(BAD_CONTEXT);
        }
        let own = match name {
            CONFIG_ID | CONTEXT_MAJOR_VERSION => 1,
            CONTEXT_CLIENT_TYPE => OPENGL_API.cast_signed(),
            RENDER_BUFFER => BACK_BUFFER,
            _ => return Err(BAD_ATTRIBUTE),
        };
        // SAFETY: the caller passes null or where to write a value.
        unsafe { store(value, 1, |_| own) }.ok_or(BAD_PARAMETER)
    };
    succeeds(found())
}

/// There is nothing to show a picture on: what has been drawn is carried out.
pub(super) extern "C" fn swap_buffers(display: *mut c_void, surface: *mut c_void) -> u32 {
    let swapped = check_display(display).and_then(|()| find(surface)).map(|_| {
        caught(|| call_uncaught(|gl, _| gl.flush()));
    });
    succeeds(swapped)
}

pub(super) extern "C" fn wait() -> u32 {
    caught(|| call_uncaught(|gl, _| gl.finish()));
    succeeds(Ok(()))
}

pub(super) extern "C" fn wait_native(_engine: i32) -> u32 {
    wait()
}

pub(super) extern "C" fn swap_interval(display: *mut c_void, _interval: i32) -> u32 {
    succeeds(check_display(display))
}

pub(super) extern "C" fn release_thread() -> u32 {
    caught(current::leave);
    succeeds(Ok(()))
}
