//! Pbuffers (EGL 1.5, 3.5): sizes with a handle. Windows and pixmaps are refused.

use super::config::{CONFIG_ID, MOST, check_config, check_display, pairs};
use super::error::{
    BAD_ALLOC, BAD_ATTRIBUTE, BAD_MATCH, BAD_NATIVE_PIXMAP, BAD_NATIVE_WINDOW, BAD_PARAMETER,
    BAD_SURFACE, answer, succeeds,
};
use crate::memory::store;
use std::ffi::c_void;
use std::ptr;
use std::sync::{Mutex, MutexGuard, PoisonError};

const HEIGHT: i32 = 0x3056;
const WIDTH: i32 = 0x3057;
const LARGEST_PBUFFER: i32 = 0x3058;
const NO_TEXTURE: i32 = 0x305C;
const TEXTURE_FORMAT: i32 = 0x3080;
const TEXTURE_TARGET: i32 = 0x3081;
const MIPMAP_TEXTURE: i32 = 0x3082;
const MIPMAP_LEVEL: i32 = 0x3083;
const RENDER_BUFFER: i32 = 0x3086;
const BACK_BUFFER: i32 = 0x3084;
const SWAP_BEHAVIOR: i32 = 0x3093;
const BUFFER_DESTROYED: i32 = 0x3095;
const MULTISAMPLE_RESOLVE: i32 = 0x3099;
const MULTISAMPLE_RESOLVE_DEFAULT: i32 = 0x309A;
const GL_COLORSPACE: i32 = 0x309D;
const GL_COLORSPACE_LINEAR: i32 = 0x308A;

/// A pbuffer. Its handle is a number that is never followed.
#[derive(Clone, Copy)]
pub(super) struct Pbuffer {
    handle: usize,
    pub(super) width: i32,
    pub(super) height: i32,
    largest: bool,
}

/// All pbuffers, and how many there have been.
struct Pbuffers {
    alive: Vec<Pbuffer>,
    made: usize,
}

static PBUFFERS: Mutex<Pbuffers> = Mutex::new(Pbuffers { alive: Vec::new(), made: 0 });

fn pbuffers() -> MutexGuard<'static, Pbuffers> {
    // The list is whole between any two of its operations.
    PBUFFERS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The pbuffer of a handle.
pub(super) fn find(surface: *mut c_void) -> Result<Pbuffer, i32> {
    let handle = surface.addr();
    pbuffers().alive.iter().find(|found| found.handle == handle).copied().ok_or(BAD_SURFACE)
}

pub(super) unsafe extern "C" fn create_pbuffer(
    display: *mut c_void,
    config: *mut c_void,
    attributes: *const i32,
) -> *mut c_void {
    // SAFETY: the caller ends the list by NONE.
    let asked = unsafe { pairs(attributes) };
    let created = || {
        check_display(display)?;
        check_config(config)?;
        let mut made = Pbuffer { handle: 0, width: 0, height: 0, largest: false };
        for (name, value) in asked {
            match name {
                WIDTH => made.width = value,
                HEIGHT => made.height = value,
                LARGEST_PBUFFER => made.largest = value != 0,
                TEXTURE_FORMAT | TEXTURE_TARGET if value == NO_TEXTURE => {}
                TEXTURE_FORMAT | TEXTURE_TARGET => return Err(BAD_MATCH),
                MIPMAP_TEXTURE => {}
                GL_COLORSPACE if value == GL_COLORSPACE_LINEAR => {}
                _ => return Err(BAD_ATTRIBUTE),
            }
        }
        if made.width < 0 || made.height < 0 {
            return Err(BAD_PARAMETER);
        }
        if made.largest {
            (made.width, made.height) = (made.width.min(MOST), made.height.min(MOST));
        }
        if made.width > MOST || made.height > MOST {
            return Err(BAD_ALLOC);
        }
        let mut pbuffers = pbuffers();
        pbuffers.made += 1;
        made.handle = 16 * pbuffers.made;
        pbuffers.alive.push(made);
        Ok(made.handle)
    };
    ptr::without_provenance_mut(answer(created()))
}

pub(super) extern "C" fn destroy_surface(display: *mut c_void, surface: *mut c_void) -> u32 {
    succeeds(check_display(display).and_then(|()| find(surface)).map(|found| {
        pbuffers().alive.retain(|other| other.handle != found.handle);
    }))
}

pub(super) unsafe extern "C" fn query_surface(
    display: *mut c_void,
    surface: *mut c_void,
    name: i32,
    value: *mut i32,
) -> u32 {
    let found = || {
        check_display(display)?;
        let found = find(surface)?;
        let own = match name {
            WIDTH => found.width,
            HEIGHT => found.height,
            LARGEST_PBUFFER => i32::from(found.largest),
            CONFIG_ID => 1,
            TEXTURE_FORMAT | TEXTURE_TARGET => NO_TEXTURE,
            MIPMAP_TEXTURE | MIPMAP_LEVEL => 0,
            RENDER_BUFFER => BACK_BUFFER,
            SWAP_BEHAVIOR => BUFFER_DESTROYED,
            MULTISAMPLE_RESOLVE => MULTISAMPLE_RESOLVE_DEFAULT,
            GL_COLORSPACE => GL_COLORSPACE_LINEAR,
            // HORIZONTAL_RESOLUTION, VERTICAL_RESOLUTION and PIXEL_ASPECT_RATIO are unknown.
            0x3090..=0x3092 => -1,
            _ => return Err(BAD_ATTRIBUTE),
        };
        // SAFETY: the caller passes null or where to write a value.
        unsafe { store(value, 1, |_| own) }.ok_or(BAD_PARAMETER)
    };
    succeeds(found())
}

pub(super) extern "C" fn surface_attrib(
    display: *mut c_void,
    surface: *mut c_void,
    name: i32,
    value: i32,
) -> u32 {
    let set = || {
        check_display(display)?;
        find(surface)?;
        match (name, value) {
            (MIPMAP_LEVEL, _)
            | (SWAP_BEHAVIOR, BUFFER_DESTROYED)
            | (MULTISAMPLE_RESOLVE, MULTISAMPLE_RESOLVE_DEFAULT) => Ok(()),
            (SWAP_BEHAVIOR | MULTISAMPLE_RESOLVE, _) => Err(BAD_MATCH),
            _ => Err(BAD_ATTRIBUTE),
        }
    };
    succeeds(set())
}

pub(super) extern "C" fn create_window(
    display: *mut c_void,
    _config: *mut c_void,
    _window: *mut c_void,
    _attributes: *const c_void,
) -> *mut c_void {
    let refused: Result<usize, i32> = check_display(display).and(Err(BAD_NATIVE_WINDOW));
    ptr::without_provenance_mut(answer(refused))
}

pub(super) extern "C" fn create_pixmap(
    display: *mut c_void,
    _config: *mut c_void,
    _pixmap: *mut c_void,
    _attributes: *const c_void,
) -> *mut c_void {
    let refused: Result<usize, i32> = check_display(display).and(Err(BAD_NATIVE_PIXMAP));
    ptr::without_provenance_mut(answer(refused))
}

pub(super) extern "C" fn create_from_client_buffer(
    display: *mut c_void,
    _kind: u32,
    _buffer: *mut c_void,
    _config: *mut c_void,
    _attributes: *const i32,
) -> *mut c_void {
    let refused: Result<usize, i32> = check_display(display).and(Err(BAD_PARAMETER));
    ptr::without_provenance_mut(answer(refused))
}

pub(super) extern "C" fn copy_buffers(
    display: *mut c_void,
    surface: *mut c_void,
    _pixmap: *mut c_void,
) -> u32 {
    succeeds(check_display(display).and_then(|()| find(surface)).and(Err(BAD_NATIVE_PIXMAP)))
}

/// `eglBindTexImage` and `eglReleaseTexImage`: no pbuffer can be a texture.
pub(super) extern "C" fn tex_image(
    display: *mut c_void,
    surface: *mut c_void,
    _buffer: i32,
) -> u32 {
    succeeds(check_display(display).and_then(|()| find(surface)).and(Err(BAD_MATCH)))
}
