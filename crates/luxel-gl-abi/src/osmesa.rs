//! The 13 functions of OSMesa 11.2, as Mesa 22.3 carries them out.
//!
//! Departures, all where Mesa's library would crash or overflow: handles that are none are refused; a context is
//! current in one thread at most; buffers have at most 16384 pixels a side. A context with a depth buffer has 24 bits of it.
//! OpenGL is of version 1.5: requests for more give no context.

use crate::client::Client;
use crate::current::{self, Bound};
use crate::entry::{call_uncaught, caught};
use crate::generated::table::ENTRIES;
use crate::memory::store;
use crate::window::{Buffer, Format, MOST, Window};
use luxel_gl::{Configuration, Context};
use std::ffi::{CStr, c_char, c_uint, c_void};
use std::ptr;

/// `OSMesaContext`.
type Handle = *mut Bound;

const ROW_LENGTH: i32 = 0x10;
const Y_UP: i32 = 0x11;
const WIDTH: i32 = 0x20;
const HEIGHT: i32 = 0x21;
const FORMAT: i32 = 0x22;
const TYPE: i32 = 0x23;
const MAX_WIDTH: i32 = 0x24;
const MAX_HEIGHT: i32 = 0x25;
const DEPTH_BITS: i32 = 0x30;
const STENCIL_BITS: i32 = 0x31;
const ACCUM_BITS: i32 = 0x32;
const PROFILE: i32 = 0x33;
const COMPAT_PROFILE: i32 = 0x35;
const CONTEXT_MAJOR_VERSION: i32 = 0x36;
const CONTEXT_MINOR_VERSION: i32 = 0x37;

/// The attributes that a context must have.
#[derive(Clone, Copy)]
struct Request {
    format: u32,
    depth: i32,
    stencil: i32,
    accum: i32,
}

/// A new context that shares lists and objects with `share`, unless that is null; null if it can't be had.
fn create(request: Request, share: Handle) -> Handle {
    let Some(format) = Format::new(request.format) else { return ptr::null_mut() };
    if request.depth < 0 || request.stencil < 0 || request.accum < 0 {
        return ptr::null_mut();
    }
    caught(|| {
        let depth_bits = if request.depth > 0 { 24 } else { 0 };
        let configuration = Configuration {
            depth_bits,
            stencil_bits: if request.stencil > 0 { 8 } else { 0 },
            accum_bits: if request.accum > 0 { 16 } else { 0 },
            alpha: format.has_alpha(),
        };
        let gl = if share.is_null() {
            Some(Context::new(configuration))
        } else {
            current::inspect(share, |shared| Context::sharing(configuration, &shared.gl))
        };
        gl.map_or(ptr::null_mut(), |gl| {
            let client = Client::new(Window::new(format, depth_bits));
            current::insert(Bound { gl, client })
        })
    })
}

/// A context with 24 bits of depth and 8 of stencil.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn OSMesaCreateContext(format: u32, share: Handle) -> Handle {
    create(Request { format, depth: 24, stencil: 8, accum: 0 }, share)
}

/// A context with at least these bits.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn OSMesaCreateContextExt(
    format: u32,
    depth_bits: i32,
    stencil_bits: i32,
    accum_bits: i32,
    share: Handle,
) -> Handle {
    create(Request { format, depth: depth_bits, stencil: stencil_bits, accum: accum_bits }, share)
}

/// A context by a list of pairs that a 0 ends; a null pointer is an empty list.
///
/// Null for core profiles, versions above 1.5 and attributes that are unknown.
#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn OSMesaCreateContextAttribs(
    attributes: *const i32,
    share: Handle,
) -> Handle {
    let mut request = Request { format: Format::DEFAULT.value(), depth: 0, stencil: 0, accum: 0 };
    let mut version = (1, 0);
    let mut at = attributes;
    // SAFETY: the caller ends the list by a 0, and each attribute before it has a value.
    while let Some([name]) = unsafe { crate::memory::array(at) }.filter(|&[name]| name != 0) {
        // SAFETY: as above.
        let value = unsafe { at.add(1).read_unaligned() };
        match name {
            FORMAT => request.format = value.cast_unsigned(),
            DEPTH_BITS => request.depth = value,
            STENCIL_BITS => request.stencil = value,
            ACCUM_BITS => request.accum = value,
            PROFILE if value == COMPAT_PROFILE => {}
            CONTEXT_MAJOR_VERSION => version.0 = value,
            CONTEXT_MINOR_VERSION => version.1 = value,
            _ => return ptr::null_mut(),
        }
        // SAFETY: the pair has been read, so the list goes on behind it.
        at = unsafe { at.add(2) };
    }
    if version.0 != 1 || !(0..=5).contains(&version.1) {
        return ptr::null_mut();
    }
    create(request, share)
}

/// Destroys a context. The caller's buffer is left as it is.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn OSMesaDestroyContext(context: Handle) {
    caught(|| current::destroy(context));
}

/// Makes a context current in this thread, with a buffer for its colours; all null and 0 leaves the current one.
///
/// A context that is left writes its colours to its buffer. False, and nothing changed, for a bad argument.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn OSMesaMakeCurrent(
    context: Handle,
    buffer: *mut c_void,
    kind: u32,
    width: i32,
    height: i32,
) -> u8 {
    if context.is_null() && buffer.is_null() && width == 0 && height == 0 {
        present();
        caught(current::leave);
        return 1;
    }
    let format = current::inspect(context, |bound| bound.client.window.format);
    let made = format.and_then(|format| Buffer::new(format, buffer, kind, width, height));
    let Some(made) = made else { return 0 };
    if context != current::current() {
        present();
    }
    if !current::make_current(context) {
        return 0;
    }
    caught(|| {
        call_uncaught(|gl, client| {
            client.window.buffer = Some(made);
            gl.resize_default(width.cast_unsigned(), height.cast_unsigned());
        });
    });
    1
}

/// Writes the colours of the current context to its buffer.
fn present() {
    caught(|| call_uncaught(|gl, client| client.present(gl)));
}

/// The context that is current in this thread, or null.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn OSMesaGetCurrentContext() -> Handle {
    current::current()
}

/// How pixels lie in the current context's buffer: `OSMESA_ROW_LENGTH` and `OSMESA_Y_UP`.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn OSMesaPixelStore(pname: i32, value: i32) {
    call_uncaught(|_, client| match pname {
        ROW_LENGTH => client.window.row_length = value,
        Y_UP => client.window.y_up = value != 0,
        _ => {}
    });
}

/// A value of the current context; names that are unknown write nothing.
#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn OSMesaGetIntegerv(pname: i32, value: *mut i32) {
    let of_window = |f: fn(&Window) -> i32| call_uncaught(|_, client| f(&client.window));
    let of_buffer = |f: fn(Buffer) -> i32| {
        call_uncaught(|_, client| client.window.buffer.map(f).unwrap_or_default())
    };
    let found = match pname {
        WIDTH => of_buffer(|buffer| buffer.width),
        HEIGHT => of_buffer(|buffer| buffer.height),
        FORMAT => of_window(|window| window.format.value().cast_signed()),
        TYPE => of_buffer(|buffer| buffer.kind.cast_signed()),
        ROW_LENGTH => of_window(|window| window.row_length),
        Y_UP => of_window(|window| i32::from(window.y_up)),
        MAX_WIDTH | MAX_HEIGHT => MOST,
        _ => return,
    };
    // SAFETY: the caller passes null or the address of one value.
    let _ = unsafe { store(value, 1, |_| found) };
}

/// The depths of a context: size, bytes of a value, and the address of the bottom row's first.
///
/// The copy is made by this call, and lives until the next one or the end of the context. False, with zeros, if there
/// are none.
#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn OSMesaGetDepthBuffer(
    context: Handle,
    width: *mut i32,
    height: *mut i32,
    bytes_per_value: *mut i32,
    buffer: *mut *mut c_void,
) -> u8 {
    let found = caught(|| {
        current::inspect(context, |bound| bound.client.window.depths(&mut bound.gl)).flatten()
    });
    let size = found.map_or((0, 0), |(found, _)| (found.width, found.height));
    // SAFETY: the caller passes null or the address of one value.
    unsafe {
        store(width, 1, |_| size.0);
        store(height, 1, |_| size.1);
        store(bytes_per_value, 1, |_| if found.is_some() { 4 } else { 0 });
        store(buffer, 1, |_| found.map_or(ptr::null_mut(), |(_, address)| address));
    }
    u8::from(found.is_some())
}

/// The buffer that a context was made current with. False, with zeros, if there is none.
#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn OSMesaGetColorBuffer(
    context: Handle,
    width: *mut i32,
    height: *mut i32,
    format: *mut i32,
    buffer: *mut *mut c_void,
) -> u8 {
    let found = current::inspect(context, |bound| {
        let window = &bound.client.window;
        window.buffer.map(|buffer| (buffer, window.format.value().cast_signed()))
    });
    let found = found.flatten();
    // SAFETY: the caller passes null or the address of one value.
    unsafe {
        store(width, 1, |_| found.map_or(0, |(buffer, _)| buffer.width));
        store(height, 1, |_| found.map_or(0, |(buffer, _)| buffer.height));
        store(format, 1, |_| found.map_or(0, |(_, format)| format));
        store(buffer, 1, |_| found.map_or(ptr::null_mut(), |(buffer, _)| buffer.address));
    }
    u8::from(found.is_some())
}

/// The address of an entry point; null for names that the library doesn't export.
#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn OSMesaGetProcAddress(name: *const c_char) -> *const c_void {
    if name.is_null() {
        return ptr::null();
    }
    // SAFETY: the caller passes a string that a 0 ends.
    let Ok(name) = unsafe { CStr::from_ptr(name) }.to_str() else { return ptr::null() };
    match ENTRIES.binary_search_by(|entry| entry.name.cmp(name)) {
        Ok(place) => ENTRIES[place].address,
        Err(_) => own(name),
    }
}

/// The address of a function of this file.
fn own(name: &str) -> *const c_void {
    match name {
        "OSMesaColorClamp" => OSMesaColorClamp as *const c_void,
        "OSMesaCreateContext" => OSMesaCreateContext as *const c_void,
        "OSMesaCreateContextAttribs" => OSMesaCreateContextAttribs as *const c_void,
        "OSMesaCreateContextExt" => OSMesaCreateContextExt as *const c_void,
        "OSMesaDestroyContext" => OSMesaDestroyContext as *const c_void,
        "OSMesaGetColorBuffer" => OSMesaGetColorBuffer as *const c_void,
        "OSMesaGetCurrentContext" => OSMesaGetCurrentContext as *const c_void,
        "OSMesaGetDepthBuffer" => OSMesaGetDepthBuffer as *const c_void,
        "OSMesaGetIntegerv" => OSMesaGetIntegerv as *const c_void,
        "OSMesaGetProcAddress" => OSMesaGetProcAddress as *const c_void,
        "OSMesaMakeCurrent" => OSMesaMakeCurrent as *const c_void,
        "OSMesaPixelStore" => OSMesaPixelStore as *const c_void,
        "OSMesaPostprocess" => OSMesaPostprocess as *const c_void,
        _ => ptr::null(),
    }
}

/// No effect: OpenGL 1.5 always clamps colours.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn OSMesaColorClamp(_enable: u8) {}

/// There are no filters for the finished picture: requests are ignored, as those for unknown filters are.
#[unsafe(no_mangle)]
pub(crate) extern "C" fn OSMesaPostprocess(
    _context: Handle,
    _filter: *const c_char,
    _value: c_uint,
) {
}
