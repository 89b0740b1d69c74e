//! What libglvnd's libEGL asks of a vendor library (libeglabi.h, version 0.2).

use super::config::{self, NONE, display};
use super::error::{BAD_PARAMETER, answer, get_error, succeeds};
use super::{context, surface};
use crate::generated::table::ENTRIES;
use std::ffi::{CStr, c_char, c_void};
use std::ptr;
use std::sync::OnceLock;

const PLATFORM_SURFACELESS: u32 = 0x31DD;
const OPENGL_API: u32 = 0x30A2;

/// The first of the functions that libEGL offers; those behind them aren't called.
#[repr(C)]
pub(crate) struct ApiExports {
    thread_init: Option<extern "C" fn()>,
    get_current_api: Option<extern "C" fn() -> u32>,
}

/// The functions that libEGL wants; it has set them to null, and those behind them are optional.
#[repr(C)]
pub(crate) struct ApiImports {
    get_platform_display: Option<extern "C" fn(u32, *mut c_void, *const isize) -> *mut c_void>,
    get_supports_api: Option<extern "C" fn(u32) -> u32>,
    get_vendor_string: Option<extern "C" fn(i32) -> *const c_char>,
    get_proc_address: Option<unsafe extern "C" fn(*const c_char) -> *const c_void>,
    get_dispatch_address: Option<extern "C" fn(*const c_char) -> *const c_void>,
    set_dispatch_index: Option<extern "C" fn(*const c_char, i32)>,
}

static CURRENT_API: OnceLock<extern "C" fn() -> u32> = OnceLock::new();

/// The API that `eglBindAPI` of this thread names.
pub(super) fn current_api() -> u32 {
    CURRENT_API.get().map_or(OPENGL_API, |api| api())
}

/// A display without a screen; the default display only where the user wants it, so that an installed library takes no
/// desktop away from another vendor.
extern "C" fn get_platform_display(
    platform: u32,
    native: *mut c_void,
    _attributes: *const isize,
) -> *mut c_void {
    let wanted = match platform {
        PLATFORM_SURFACELESS => true,
        _ => platform == NONE.cast_unsigned() && std::env::var_os("LUXEL_EGL_DEFAULT").is_some(),
    };
    let found = if wanted && native.is_null() { Ok(display()) } else { Err(BAD_PARAMETER) };
    answer(found)
}

extern "C" fn get_supports_api(api: u32) -> u32 {
    u32::from(api == OPENGL_API)
}

/// The platforms that `eglGetPlatformDisplay` takes.
extern "C" fn get_vendor_string(name: i32) -> *const c_char {
    if name == 0 { c"EGL_MESA_platform_surfaceless".as_ptr() } else { ptr::null() }
}

extern "C" fn bind_api(api: u32) -> u32 {
    succeeds(if api == OPENGL_API { Ok(()) } else { Err(BAD_PARAMETER) })
}

/// The functions of EGL that libEGL hands calls to, and those of OpenGL.
unsafe extern "C" fn get_proc_address(name: *const c_char) -> *const c_void {
    if name.is_null() {
        return ptr::null();
    }
    // SAFETY: libEGL passes a string that a 0 ends.
    let Ok(name) = unsafe { CStr::from_ptr(name) }.to_str() else { return ptr::null() };
    match name {
        "eglBindAPI" => bind_api as *const c_void,
        "eglBindTexImage" | "eglReleaseTexImage" => surface::tex_image as *const c_void,
        "eglChooseConfig" => config::choose_config as *const c_void,
        "eglCopyBuffers" => surface::copy_buffers as *const c_void,
        "eglCreateContext" => context::create_context as *const c_void,
        "eglCreatePbufferFromClientBuffer" => surface::create_from_client_buffer as *const c_void,
        "eglCreatePbufferSurface" => surface::create_pbuffer as *const c_void,
        "eglCreatePixmapSurface" | "eglCreatePlatformPixmapSurface" => {
            surface::create_pixmap as *const c_void
        }
        "eglCreateWindowSurface" | "eglCreatePlatformWindowSurface" => {
            surface::create_window as *const c_void
        }
        "eglDestroyContext" => context::destroy_context as *const c_void,
        "eglDestroySurface" => surface::destroy_surface as *const c_void,
        "eglGetConfigAttrib" => config::get_config_attrib as *const c_void,
        "eglGetConfigs" => config::get_configs as *const c_void,
        "eglGetError" => get_error as *const c_void,
        "eglInitialize" => config::initialize as *const c_void,
        "eglMakeCurrent" => context::make_current as *const c_void,
        "eglQueryContext" => context::query_context as *const c_void,
        "eglQueryString" => config::query_string as *const c_void,
        "eglQuerySurface" => surface::query_surface as *const c_void,
        "eglReleaseThread" => context::release_thread as *const c_void,
        "eglSurfaceAttrib" => surface::surface_attrib as *const c_void,
        "eglSwapBuffers" => context::swap_buffers as *const c_void,
        "eglSwapInterval" => context::swap_interval as *const c_void,
        "eglTerminate" => config::terminate as *const c_void,
        "eglWaitClient" | "eglWaitGL" => context::wait as *const c_void,
        "eglWaitNative" => context::wait_native as *const c_void,
        _ => ENTRIES
            .binary_search_by(|entry| entry.name.cmp(name))
            .map_or(ptr::null(), |place| ENTRIES[place].address),
    }
}

/// There are no extensions with functions of their own.
extern "C" fn get_dispatch_address(_name: *const c_char) -> *const c_void {
    ptr::null()
}

extern "C" fn set_dispatch_index(_name: *const c_char, _index: i32) {}

/// libEGL's way in: fills `imports` with the library's functions. False for another major version of the interface.
#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn __egl_Main(
    version: u32,
    exports: *const ApiExports,
    _vendor: *mut c_void,
    imports: *mut ApiImports,
) -> u32 {
    if version >> 16 != 0 || exports.is_null() || imports.is_null() {
        return 0;
    }
    // SAFETY: libEGL passes its table, which begins with these functions.
    if let Some(api) = unsafe { (*exports).get_current_api } {
        CURRENT_API.get_or_init(|| api);
    }
    // SAFETY: libEGL passes a table to fill, which begins with these functions.
    unsafe {
        imports.write(ApiImports {
            get_platform_display: Some(get_platform_display),
            get_supports_api: Some(get_supports_api),
            get_vendor_string: Some(get_vendor_string),
            get_proc_address: Some(get_proc_address),
            get_dispatch_address: Some(get_dispatch_address),
            set_dispatch_index: Some(set_dispatch_index),
        });
    }
    1
}
