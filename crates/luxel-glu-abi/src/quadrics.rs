//! Quadrics (GLU 1.3, chapter 6).

use crate::gl::Current;
use crate::object::{
    Callback, ERROR, INVALID_ENUM, INVALID_VALUE, OUT_OF_MEMORY, caught, give, report, take, with,
};
use luxel_glu::{DrawStyle, InvalidValue, Normals, Orientation, Quadric};

/// `GLUquadric`.
#[derive(Default)]
pub(crate) struct GluQuadric {
    quadric: Quadric,
    error: Callback,
}

/// A quadric that draws filled, smooth, without texture coordinates.
#[unsafe(no_mangle)]
extern "C" fn gluNewQuadric() -> *mut GluQuadric {
    give(GluQuadric::default())
}

/// Ends a quadric.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluDeleteQuadric(quadric: *mut GluQuadric) {
    // SAFETY: the caller passes what `gluNewQuadric` returned, and doesn't use it any more.
    unsafe { take(quadric) };
}

/// Sets a property, or reports that its value is none.
///
/// # Safety
///
/// The address is null or of a quadric.
unsafe fn set<T>(address: *mut GluQuadric, value: Option<T>, f: impl FnOnce(&mut Quadric, T)) {
    // SAFETY: the caller of this function promises it.
    let failed = unsafe {
        with(address, |object| match value {
            Some(value) => {
                f(&mut object.quadric, value);
                None
            }
            None => object.error,
        })
    };
    report(failed, INVALID_ENUM);
}

/// The function to call for errors.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluQuadricCallback(quadric: *mut GluQuadric, which: u32, callback: Callback) {
    // SAFETY: the caller passes null or a quadric.
    let failed = unsafe {
        with(quadric, |object| {
            if which == ERROR {
                object.error = callback;
                None
            } else {
                object.error
            }
        })
    };
    report(failed, INVALID_ENUM);
}

/// `GLU_NONE`, `GLU_FLAT` or `GLU_SMOOTH`.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluQuadricNormals(quadric: *mut GluQuadric, normals: u32) {
    let value = match normals {
        100_000 => Some(Normals::Smooth),
        100_001 => Some(Normals::Flat),
        100_002 => Some(Normals::None),
        _ => None,
    };
    // SAFETY: the caller passes null or a quadric.
    unsafe { set(quadric, value, |quadric, value| quadric.normals = value) };
}

/// `GLU_POINT`, `GLU_LINE`, `GLU_FILL` or `GLU_SILHOUETTE`.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluQuadricDrawStyle(quadric: *mut GluQuadric, style: u32) {
    let value = match style {
        100_010 => Some(DrawStyle::Point),
        100_011 => Some(DrawStyle::Line),
        100_012 => Some(DrawStyle::Fill),
        100_013 => Some(DrawStyle::Silhouette),
        _ => None,
    };
    // SAFETY: the caller passes null or a quadric.
    unsafe { set(quadric, value, |quadric, value| quadric.draw_style = value) };
}

/// `GLU_OUTSIDE` or `GLU_INSIDE`.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluQuadricOrientation(quadric: *mut GluQuadric, orientation: u32) {
    let value = match orientation {
        100_020 => Some(Orientation::Outside),
        100_021 => Some(Orientation::Inside),
        _ => None,
    };
    // SAFETY: the caller passes null or a quadric.
    unsafe { set(quadric, value, |quadric, value| quadric.orientation = value) };
}

/// Whether vertices have texture coordinates.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluQuadricTexture(quadric: *mut GluQuadric, textured: u8) {
    // SAFETY: the caller passes null or a quadric.
    unsafe { set(quadric, Some(textured != 0), |quadric, value| quadric.textured = value) };
}

/// Draws a shape with a copy of the quadric, so that callbacks may change it.
///
/// # Safety
///
/// The address is null or of a quadric.
unsafe fn draw(address: *mut GluQuadric, f: impl FnOnce(&Quadric) -> Result<(), InvalidValue>) {
    // SAFETY: the caller of this function promises it.
    let found = unsafe { with(address, |object| Some((object.quadric, object.error))) };
    let Some((quadric, error)) = found else { return };
    match caught(|| f(&quadric)) {
        Some(Ok(())) => {}
        Some(Err(InvalidValue)) => report(error, INVALID_VALUE),
        None => report(error, OUT_OF_MEMORY),
    }
}

/// A sphere about the origin.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluSphere(quadric: *mut GluQuadric, radius: f64, slices: i32, stacks: i32) {
    // SAFETY: the caller passes null or a quadric.
    unsafe { draw(quadric, |quadric| quadric.sphere(&mut Current, radius, slices, stacks)) };
}

/// The wall of a cylinder or a frustum.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluCylinder(
    quadric: *mut GluQuadric,
    base: f64,
    top: f64,
    height: f64,
    slices: i32,
    stacks: i32,
) {
    let radii = [base, top];
    // SAFETY: the caller passes null or a quadric.
    unsafe {
        draw(quadric, |quadric| quadric.cylinder(&mut Current, radii, height, slices, stacks));
    };
}

/// A disk or a ring.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluDisk(
    quadric: *mut GluQuadric,
    inner: f64,
    outer: f64,
    slices: i32,
    loops: i32,
) {
    // SAFETY: the caller passes null or a quadric.
    unsafe { draw(quadric, |quadric| quadric.disk(&mut Current, [inner, outer], slices, loops)) };
}

/// A part of a disk or a ring.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluPartialDisk(
    quadric: *mut GluQuadric,
    inner: f64,
    outer: f64,
    slices: i32,
    loops: i32,
    start: f64,
    sweep: f64,
) {
    let (radii, angles) = ([inner, outer], [start, sweep]);
    // SAFETY: the caller passes null or a quadric.
    unsafe {
        draw(quadric, |quadric| quadric.partial_disk(&mut Current, radii, slices, loops, angles));
    };
}
