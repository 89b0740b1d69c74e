//! Tessellation of polygons (GLU 1.3, chapter 5).
//!
//! Callbacks may call the library: so no reference to the object is held while they run. The tessellator is taken out of
//! the object, works with a copy of the callbacks, and is put back.

use crate::object::{
    Callback, ERROR, INVALID_ENUM, OUT_OF_MEMORY, array, caught, give, store, take, with,
};
use luxel_glu::{Listener, Tessellator};
use std::ffi::c_void;
use std::mem;
use std::ptr;

/// The first callback, `GLU_TESS_BEGIN`; its variant with the polygon's data is [`WITH_DATA`] higher.
const BEGIN: u32 = 100_100;
const VERTEX: usize = 1;
const END: usize = 2;
const ERRORS: usize = 3;
const EDGE_FLAG: usize = 4;
const COMBINE: usize = 5;
const WITH_DATA: usize = 6;

const _: () = assert!(BEGIN + ERRORS as u32 == ERROR);

/// The callbacks, and the data of the polygon.
#[derive(Clone, Copy)]
struct Callbacks {
    functions: [Callback; 2 * WITH_DATA],
    data: *mut c_void,
}

/// `GLUtesselator`.
pub(crate) struct GluTess {
    tessellator: Tessellator,
    callbacks: Callbacks,
}

/// Calls a callback, with the polygon's data if it is registered for that.
macro_rules! callback {
    ($self:ident, $which:expr, ($($value:expr),*), ($($kind:ty),*)) => {
        if let Some(function) = $self.functions[WITH_DATA + $which] {
            // SAFETY: the caller registered it under the name of this type of function.
            let function: unsafe extern "C" fn($($kind,)* *mut c_void) = unsafe { mem::transmute(function) };
            // SAFETY: arguments are values, or lead to arrays that live until it returns.
            unsafe { function($($value,)* $self.data) };
        } else if let Some(function) = $self.functions[$which] {
            // SAFETY: the caller registered it under the name of this type of function.
            let function: unsafe extern "C" fn($($kind),*) = unsafe { mem::transmute(function) };
            // SAFETY: arguments are values, or lead to arrays that live until it returns.
            unsafe { function($($value),*) };
        }
    };
}

impl Listener for Callbacks {
    fn begin(&mut self, mode: u32) {
        callback!(self, 0, (mode), (u32));
    }

    fn edge_flag(&mut self, is_outline: bool) {
        callback!(self, EDGE_FLAG, (u8::from(is_outline)), (u8));
    }

    fn wants_edge_flags(&self) -> bool {
        self.functions[EDGE_FLAG].or(self.functions[WITH_DATA + EDGE_FLAG]).is_some()
    }

    fn vertex(&mut self, handle: usize) {
        callback!(self, VERTEX, (pointer(handle)), (*mut c_void));
    }

    #[allow(clippy::useless_transmute, reason = "its type is that of registration")]
    fn end(&mut self) {
        callback!(self, END, (), ());
    }

    fn error(&mut self, error: u32) {
        callback!(self, ERRORS, (error), (u32));
    }

    fn combine(
        &mut self,
        mut coordinates: [f64; 3],
        vertices: [usize; 4],
        mut weights: [f32; 4],
    ) -> Option<usize> {
        let mut vertices = vertices.map(pointer);
        let mut made: *mut c_void = ptr::null_mut();
        callback!(
            self,
            COMBINE,
            (coordinates.as_mut_ptr(), vertices.as_mut_ptr(), weights.as_mut_ptr(), &raw mut made),
            (*mut f64, *mut *mut c_void, *mut f32, *mut *mut c_void)
        );
        (!made.is_null()).then(|| made.expose_provenance())
    }
}

/// The caller's pointer to a vertex, from the number that the tessellator kept.
fn pointer(handle: usize) -> *mut c_void {
    ptr::with_exposed_provenance_mut(handle)
}

/// Runs `f` on a tessellator and its callbacks, without a reference to the object.
///
/// # Safety
///
/// The address is null or of a tessellator, which the callbacks may use but not delete.
unsafe fn run<R: Default>(
    tess: *mut GluTess,
    f: impl FnOnce(&mut Tessellator, &mut Callbacks) -> R,
) -> R {
    // SAFETY: the caller of this function promises it.
    let taken = unsafe {
        with(tess, |object| Some((mem::take(&mut object.tessellator), object.callbacks)))
    };
    let Some((mut tessellator, mut callbacks)) = taken else { return R::default() };
    let result = caught(|| f(&mut tessellator, &mut callbacks));
    if result.is_none() {
        tessellator = Tessellator::default();
    }
    // SAFETY: as above.
    unsafe { with(tess, |object| object.tessellator = tessellator) };
    result.unwrap_or_else(|| {
        callbacks.error(OUT_OF_MEMORY);
        R::default()
    })
}

/// A tessellator.
#[unsafe(no_mangle)]
extern "C" fn gluNewTess() -> *mut GluTess {
    let callbacks = Callbacks { functions: [None; 2 * WITH_DATA], data: ptr::null_mut() };
    give(GluTess { tessellator: Tessellator::default(), callbacks })
}

/// Ends a tessellator.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluDeleteTess(tess: *mut GluTess) {
    // SAFETY: the caller passes what `gluNewTess` returned, and doesn't use it any more.
    unsafe { take(tess) };
}

/// The function to call for an event.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluTessCallback(tess: *mut GluTess, which: u32, callback: Callback) {
    let place = which.wrapping_sub(BEGIN) as usize;
    if place >= 2 * WITH_DATA {
        // SAFETY: the caller passes null or a tessellator.
        unsafe { run(tess, |_, callbacks| callbacks.error(INVALID_ENUM)) };
        return;
    }
    // SAFETY: as above.
    unsafe { with(tess, |object| object.callbacks.functions[place] = callback) };
}

/// Sets a property.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluTessProperty(tess: *mut GluTess, which: u32, value: f64) {
    // SAFETY: the caller passes null or a tessellator.
    unsafe { run(tess, |tess, callbacks| tess.set_property(which, value, callbacks)) };
}

/// Writes a property.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluGetTessProperty(tess: *mut GluTess, which: u32, data: *mut f64) {
    // SAFETY: the caller passes null or a tessellator, and where to write a value.
    unsafe {
        if let Some(value) = run(tess, |tess, callbacks| tess.property(which, callbacks)) {
            store(data, value);
        }
    }
}

/// The direction that polygons are seen from.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluTessNormal(tess: *mut GluTess, x: f64, y: f64, z: f64) {
    // SAFETY: the caller passes null or a tessellator.
    unsafe { run(tess, |tess, _| tess.set_normal([x, y, z])) };
}

/// Begins a polygon, with data for callbacks.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluTessBeginPolygon(tess: *mut GluTess, data: *mut c_void) {
    // SAFETY: the caller passes null or a tessellator.
    unsafe {
        with(tess, |object| object.callbacks.data = data);
        run(tess, Tessellator::begin_polygon);
    }
}

/// Begins a contour.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluTessBeginContour(tess: *mut GluTess) {
    // SAFETY: the caller passes null or a tessellator.
    unsafe { run(tess, Tessellator::begin_contour) };
}

/// Adds a vertex.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluTessVertex(tess: *mut GluTess, location: *mut f64, data: *mut c_void) {
    // SAFETY: the caller passes null or three coordinates.
    let Some(location) = (unsafe { array(location.cast_const()) }) else { return };
    let handle = data.expose_provenance();
    // SAFETY: the caller passes null or a tessellator.
    unsafe { run(tess, |tess, callbacks| tess.vertex(location, handle, callbacks)) };
}

/// Ends a contour.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluTessEndContour(tess: *mut GluTess) {
    // SAFETY: the caller passes null or a tessellator.
    unsafe { run(tess, Tessellator::end_contour) };
}

/// Ends a polygon: its triangles, or its outlines, go to the callbacks.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluTessEndPolygon(tess: *mut GluTess) {
    // SAFETY: the caller passes null or a tessellator.
    unsafe { run(tess, Tessellator::end_polygon) };
}

/// Begins a polygon and its first contour, as GLU 1.1 did.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluBeginPolygon(tess: *mut GluTess) {
    // SAFETY: the caller passes null or a tessellator.
    unsafe {
        gluTessBeginPolygon(tess, ptr::null_mut());
        gluTessBeginContour(tess);
    }
}

/// Ends a contour and begins the next one, as GLU 1.1 did. Which kind it is of is found from its winding.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluNextContour(tess: *mut GluTess, _kind: u32) {
    // SAFETY: the caller passes null or a tessellator.
    unsafe {
        gluTessEndContour(tess);
        gluTessBeginContour(tess);
    }
}

/// Ends the last contour and the polygon, as GLU 1.1 did.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluEndPolygon(tess: *mut GluTess) {
    // SAFETY: the caller passes null or a tessellator.
    unsafe {
        gluTessEndContour(tess);
        gluTessEndPolygon(tess);
    }
}
