//! The display and its one configuration (EGL 1.5, 3.2 to 3.4).

use super::error::{
    BAD_ATTRIBUTE, BAD_CONFIG, BAD_DISPLAY, BAD_PARAMETER, NOT_INITIALIZED, answer, succeeds,
};
use crate::memory::{array, store};
use std::ffi::{c_char, c_void};
use std::ptr;
use std::sync::atomic::{AtomicBool, Ordering};

/// What handles of displays and configurations are the addresses of.
static DISPLAY: u8 = 0;
static CONFIG: u8 = 0;
static INITIALIZED: AtomicBool = AtomicBool::new(false);

pub(super) const NONE: i32 = 0x3038;
const DONT_CARE: i32 = -1;
pub(super) const CONFIG_ID: i32 = 0x3028;
/// The largest pbuffer.
pub(super) const MOST: i32 = 16384;

/// How a configuration is chosen by an attribute (table 3.4).
#[derive(Clone, Copy)]
enum Match {
    AtLeast,
    Exact,
    Mask,
    Ignored,
}

/// The attributes: name, value, how `eglChooseConfig` compares it, and its default in a request.
#[rustfmt::skip]
const ATTRIBUTES: [(i32, i32, Match, i32); 32] = [
    (0x3020, 32, Match::AtLeast, 0),               // BUFFER_SIZE
    (0x3021, 8, Match::AtLeast, 0),                // ALPHA_SIZE
    (0x3022, 8, Match::AtLeast, 0),                // BLUE_SIZE
    (0x3023, 8, Match::AtLeast, 0),                // GREEN_SIZE
    (0x3024, 8, Match::AtLeast, 0),                // RED_SIZE
    (0x3025, 24, Match::AtLeast, 0),               // DEPTH_SIZE
    (0x3026, 8, Match::AtLeast, 0),                // STENCIL_SIZE
    (0x3027, NONE, Match::Exact, DONT_CARE),       // CONFIG_CAVEAT
    (CONFIG_ID, 1, Match::Exact, DONT_CARE),
    (0x3029, 0, Match::Exact, 0),                  // LEVEL
    (0x302A, MOST, Match::Ignored, 0),             // MAX_PBUFFER_HEIGHT
    (0x302B, MOST * MOST, Match::Ignored, 0),      // MAX_PBUFFER_PIXELS
    (0x302C, MOST, Match::Ignored, 0),             // MAX_PBUFFER_WIDTH
    (0x302D, 0, Match::Exact, DONT_CARE),          // NATIVE_RENDERABLE
    (0x302E, 0, Match::Ignored, 0),                // NATIVE_VISUAL_ID
    (0x302F, NONE, Match::Exact, DONT_CARE),       // NATIVE_VISUAL_TYPE
    (0x3031, 0, Match::AtLeast, 0),                // SAMPLES
    (0x3032, 0, Match::AtLeast, 0),                // SAMPLE_BUFFERS
    (0x3033, 1, Match::Mask, 4),                   // SURFACE_TYPE: PBUFFER_BIT; WINDOW_BIT by default
    (0x3034, NONE, Match::Exact, NONE),            // TRANSPARENT_TYPE
    (0x3035, 0, Match::Exact, DONT_CARE),          // TRANSPARENT_BLUE_VALUE
    (0x3036, 0, Match::Exact, DONT_CARE),          // TRANSPARENT_GREEN_VALUE
    (0x3037, 0, Match::Exact, DONT_CARE),          // TRANSPARENT_RED_VALUE
    (0x3039, 0, Match::Exact, DONT_CARE),          // BIND_TO_TEXTURE_RGB
    (0x303A, 0, Match::Exact, DONT_CARE),          // BIND_TO_TEXTURE_RGBA
    (0x303B, 0, Match::Exact, DONT_CARE),          // MIN_SWAP_INTERVAL
    (0x303C, 0, Match::Exact, DONT_CARE),          // MAX_SWAP_INTERVAL
    (0x303D, 0, Match::AtLeast, 0),                // LUMINANCE_SIZE
    (0x303E, 0, Match::AtLeast, 0),                // ALPHA_MASK_SIZE
    (0x303F, 0x308E, Match::Exact, 0x308E),        // COLOR_BUFFER_TYPE: RGB_BUFFER
    (0x3040, 8, Match::Mask, 1),                   // RENDERABLE_TYPE: OPENGL_BIT; OPENGL_ES_BIT by default
    (0x3042, 8, Match::Mask, 0),                   // CONFORMANT
];
/// MATCH_NATIVE_PIXMAP: there are no pixmaps to match.
const MATCH_NATIVE_PIXMAP: i32 = 0x3041;

/// The handle of the display.
pub(super) fn display() -> *mut c_void {
    ptr::from_ref(&DISPLAY).cast_mut().cast()
}

fn config() -> *mut c_void {
    ptr::from_ref(&CONFIG).cast_mut().cast()
}

/// Whether a handle is that of the display, and the display is initialized.
pub(super) fn check_display(handle: *mut c_void) -> Result<(), i32> {
    if handle != display() {
        Err(BAD_DISPLAY)
    } else if INITIALIZED.load(Ordering::Relaxed) {
        Ok(())
    } else {
        Err(NOT_INITIALIZED)
    }
}

/// Whether a handle is that of the configuration.
pub(super) fn check_config(handle: *mut c_void) -> Result<(), i32> {
    if handle == config() { Ok(()) } else { Err(BAD_CONFIG) }
}

/// The pairs of a list that `NONE` ends; a null pointer is an empty list.
///
/// # Safety
///
/// The address is null, or `NONE` ends the list there, and each name before it has a value.
pub(super) unsafe fn pairs(mut list: *const i32) -> Vec<(i32, i32)> {
    let mut pairs = Vec::new();
    // SAFETY: the caller of this function promises it.
    while let Some([name]) = unsafe { array(list) }.filter(|&[name]| name != NONE) {
        // SAFETY: the name isn't the end, so that a value and the next name follow.
        unsafe {
            pairs.push((name, list.add(1).read_unaligned()));
            list = list.add(2);
        }
    }
    pairs
}

pub(super) unsafe extern "C" fn initialize(
    handle: *mut c_void,
    major: *mut i32,
    minor: *mut i32,
) -> u32 {
    succeeds(if handle == display() {
        INITIALIZED.store(true, Ordering::Relaxed);
        // SAFETY: the caller passes null or where to write a value.
        unsafe {
            store(major, 1, |_| 1);
            store(minor, 1, |_| 5);
        }
        Ok(())
    } else {
        Err(BAD_DISPLAY)
    })
}

pub(super) extern "C" fn terminate(handle: *mut c_void) -> u32 {
    succeeds(if handle == display() {
        INITIALIZED.store(false, Ordering::Relaxed);
        Ok(())
    } else {
        Err(BAD_DISPLAY)
    })
}

pub(super) extern "C" fn query_string(handle: *mut c_void, name: i32) -> *const c_char {
    answer(check_display(handle).and_then(|()| {
        match name {
            0x3053 => Ok(c"luxel".as_ptr()),
            0x3054 => Ok(c"1.5 luxel".as_ptr()),
            0x3055 => {
                Ok(c"EGL_KHR_create_context EGL_KHR_no_config_context EGL_KHR_surfaceless_context"
                    .as_ptr())
            }
            0x308D => Ok(c"OpenGL".as_ptr()),
            _ => Err(BAD_PARAMETER),
        }
    }))
}

/// Writes the configuration, if it is among the results and there is room, and how many there are.
///
/// # Safety
///
/// The addresses are null, or `size` configurations and a number can be written there.
unsafe fn list(
    matches: bool,
    configs: *mut *mut c_void,
    size: i32,
    count: *mut i32,
) -> Result<(), i32> {
    if count.is_null() {
        return Err(BAD_PARAMETER);
    }
    let room = if configs.is_null() { 1 } else { size };
    let found = i32::from(matches).min(room);
    // SAFETY: the caller of this function promises it.
    unsafe {
        if found > 0 && !configs.is_null() {
            store(configs, 1, |_| config());
        }
        store(count, 1, |_| found);
    }
    Ok(())
}

pub(super) unsafe extern "C" fn get_configs(
    handle: *mut c_void,
    configs: *mut *mut c_void,
    size: i32,
    count: *mut i32,
) -> u32 {
    // SAFETY: the caller passes null or room for so many configurations, and for a number.
    succeeds(check_display(handle).and_then(|()| unsafe { list(true, configs, size, count) }))
}

pub(super) unsafe extern "C" fn choose_config(
    handle: *mut c_void,
    attributes: *const i32,
    configs: *mut *mut c_void,
    size: i32,
    count: *mut i32,
) -> u32 {
    // SAFETY: the caller ends the list by NONE.
    let asked = unsafe { pairs(attributes) };
    let chosen = || {
        check_display(handle)?;
        let is_known = |name: i32| {
            name == MATCH_NATIVE_PIXMAP || ATTRIBUTES.iter().any(|attribute| attribute.0 == name)
        };
        if !asked.iter().all(|&(name, _)| is_known(name)) {
            return Err(BAD_ATTRIBUTE);
        }
        let fits = |&(name, own, rule, default): &(i32, i32, Match, i32)| {
            let wanted = asked.iter().rfind(|pair| pair.0 == name).map_or(default, |pair| pair.1);
            wanted == DONT_CARE
                || match rule {
                    Match::AtLeast => own >= wanted,
                    Match::Exact => own == wanted,
                    Match::Mask => own & wanted == wanted,
                    Match::Ignored => true,
                }
        };
        // SAFETY: the caller passes null or room for so many configurations, and for a number.
        unsafe { list(ATTRIBUTES.iter().all(fits), configs, size, count) }
    };
    succeeds(chosen())
}

pub(super) unsafe extern "C" fn get_config_attrib(
    handle: *mut c_void,
    config: *mut c_void,
    name: i32,
    value: *mut i32,
) -> u32 {
    let found = || {
        check_display(handle)?;
        check_config(config)?;
        let attribute = ATTRIBUTES.iter().find(|attribute| attribute.0 == name);
        let &(_, own, _, _) = attribute.ok_or(BAD_ATTRIBUTE)?;
        // SAFETY: the caller passes null or where to write a value.
        unsafe { store(value, 1, |_| own) }.ok_or(BAD_PARAMETER)
    };
    succeeds(found())
}
