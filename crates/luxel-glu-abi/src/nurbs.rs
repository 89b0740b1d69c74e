//! NURBS (GLU 1.3, chapter 7) are not drawn: what would draw reports `GLU_INVALID_OPERATION`.
//!
//! Renderers exist, so that programs that make one at their start run, and keep their error callback.

use crate::object::{Callback, ERROR, INVALID_OPERATION, give, report, store, take, with};
use std::ffi::c_void;

/// `GLUnurbs`.
#[derive(Default)]
pub(crate) struct GluNurbs {
    error: Callback,
}

/// A renderer.
#[unsafe(no_mangle)]
extern "C" fn gluNewNurbsRenderer() -> *mut GluNurbs {
    give(GluNurbs::default())
}

/// Ends a renderer.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluDeleteNurbsRenderer(nurbs: *mut GluNurbs) {
    // SAFETY: the caller passes what `gluNewNurbsRenderer` returned, and doesn't use it any more.
    unsafe { take(nurbs) };
}

/// The function to call for errors; other callbacks are never called.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluNurbsCallback(nurbs: *mut GluNurbs, which: u32, callback: Callback) {
    if which == ERROR {
        // SAFETY: the caller passes null or a renderer.
        unsafe { with(nurbs, |object| object.error = callback) };
    }
}

/// Properties have no effect, and are all 0.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluGetNurbsProperty(_nurbs: *mut GluNurbs, _property: u32, value: *mut f32) {
    // SAFETY: the caller passes null or where to write a value.
    unsafe { store(value, 0.0) };
}

/// Functions that report that there are no NURBS.
macro_rules! refused {
    ($($name:ident($($kind:ty),*);)*) => {$(
        #[doc = concat!("`", stringify!($name), "`: not carried out.")]
        #[unsafe(no_mangle)]
        #[allow(clippy::too_many_arguments, reason = "the parameters are GLU's")]
        unsafe extern "C" fn $name(nurbs: *mut GluNurbs $(, _: $kind)*) {
            // SAFETY: the caller passes null or a renderer.
            let error = unsafe { with(nurbs, |object| object.error) };
            report(error, INVALID_OPERATION);
        }
    )*};
}

refused! {
    gluBeginCurve();
    gluEndCurve();
    gluBeginSurface();
    gluEndSurface();
    gluBeginTrim();
    gluEndTrim();
    gluNurbsCallbackData(*mut c_void);
    gluNurbsCallbackDataEXT(*mut c_void);
    gluNurbsProperty(u32, f32);
    gluLoadSamplingMatrices(*const f32, *const f32, *const i32);
    gluNurbsCurve(i32, *mut f32, i32, *mut f32, i32, u32);
    gluNurbsSurface(i32, *mut f32, i32, *mut f32, i32, i32, *mut f32, i32, i32, u32);
    gluPwlCurve(i32, *mut f32, i32, u32);
}
