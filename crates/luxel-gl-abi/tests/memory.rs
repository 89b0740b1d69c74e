//! Commands that take pointers read and write exactly as many values as OpenGL says: the arrays here have not one more,
//! so that miri, or the address sanitizer, finds each that goes beyond.
//!
//! ```text
//! cargo +nightly miri test -p luxel-gl-abi --test memory
//! ```

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]
#![allow(non_snake_case, reason = "the names are OpenGL's")]

use luxel_gl_abi as _;
use std::ffi::{c_char, c_void};
use std::ptr;

unsafe extern "C" {
    fn OSMesaCreateContextExt(
        format: u32,
        depth: i32,
        stencil: i32,
        accum: i32,
        share: *mut c_void,
    ) -> *mut c_void;
    fn OSMesaCreateContextAttribs(list: *const i32, share: *mut c_void) -> *mut c_void;
    fn OSMesaDestroyContext(context: *mut c_void);
    fn OSMesaMakeCurrent(
        context: *mut c_void,
        buffer: *mut c_void,
        kind: u32,
        width: i32,
        height: i32,
    ) -> u8;
    fn OSMesaGetIntegerv(pname: i32, value: *mut i32);
    fn OSMesaGetProcAddress(name: *const c_char) -> *const c_void;
    fn OSMesaGetColorBuffer(
        context: *mut c_void,
        width: *mut i32,
        height: *mut i32,
        format: *mut i32,
        buffer: *mut *mut c_void,
    ) -> u8;
    fn glGetError() -> u32;
    fn glLightfv(light: u32, pname: u32, params: *const f32);
    fn glLightiv(light: u32, pname: u32, params: *const i32);
    fn glGetLightfv(light: u32, pname: u32, params: *mut f32);
    fn glGetLightiv(light: u32, pname: u32, params: *mut i32);
    fn glMaterialfv(face: u32, pname: u32, params: *const f32);
    fn glMaterialiv(face: u32, pname: u32, params: *const i32);
    fn glGetMaterialfv(face: u32, pname: u32, params: *mut f32);
    fn glLightModelfv(pname: u32, params: *const f32);
    fn glLightModeliv(pname: u32, params: *const i32);
    fn glFogfv(pname: u32, params: *const f32);
    fn glFogiv(pname: u32, params: *const i32);
    fn glPointParameterfv(pname: u32, params: *const f32);
    fn glClipPlane(plane: u32, equation: *const f64);
    fn glGetClipPlane(plane: u32, equation: *mut f64);
    fn glLoadMatrixd(m: *const f64);
    fn glLoadMatrixf(m: *const f32);
    fn glMultTransposeMatrixf(m: *const f32);
    fn glGetDoublev(pname: u32, data: *mut f64);
    fn glGetFloatv(pname: u32, data: *mut f32);
    fn glGetIntegerv(pname: u32, data: *mut i32);
    fn glGetBooleanv(pname: u32, data: *mut u8);
    fn glPolygonStipple(mask: *const u8);
    fn glGetPolygonStipple(mask: *mut u8);
    fn glNewList(list: u32, mode: u32);
    fn glEndList();
    fn glCallLists(n: i32, kind: u32, lists: *const c_void);
    fn glSelectBuffer(size: i32, buffer: *mut u32);
    fn glFeedbackBuffer(size: i32, kind: u32, buffer: *mut f32);
    fn glGetPointerv(pname: u32, params: *mut *mut c_void);
    fn glRenderMode(mode: u32) -> i32;
    fn glInitNames();
    fn glPushName(name: u32);
    fn glPassThrough(token: f32);
    fn glColor3ubv(v: *const u8);
    fn glColor4iv(v: *const i32);
    fn glNormal3bv(v: *const i8);
    fn glNormal3dv(v: *const f64);
    fn glTexCoord2sv(v: *const i16);
    fn glMultiTexCoord3fv(target: u32, v: *const f32);
    fn glRasterPos4dv(v: *const f64);
    fn glWindowPos2iv(v: *const i32);
    fn glEdgeFlagv(flag: *const u8);
    fn glRectsv(v1: *const i16, v2: *const i16);
    fn glSecondaryColor3usv(v: *const u16);
    fn glFogCoorddv(v: *const f64);
    fn glIndexubv(v: *const u8);
}

const RGBA: u32 = 0x1908;
const UNSIGNED_BYTE: u32 = 0x1401;
const INVALID_VALUE: u32 = 0x0501;

/// A context that is current while it lives. It is destroyed without being left first, so that nothing is drawn.
struct Current(*mut c_void, #[expect(dead_code, reason = "the context draws there")] Box<[u8]>);

impl Current {
    fn new() -> Self {
        let mut buffer = vec![0u8; 4 * 4 * 4].into_boxed_slice();
        // SAFETY: the buffer has 4x4 pixels of four bytes, and lives as long as the context is current.
        unsafe {
            let context = OSMesaCreateContextExt(RGBA, 24, 8, 0, ptr::null_mut());
            assert_eq!(
                OSMesaMakeCurrent(context, buffer.as_mut_ptr().cast(), UNSIGNED_BYTE, 4, 4),
                1
            );
            Self(context, buffer)
        }
    }
}

impl Drop for Current {
    fn drop(&mut self) {
        // SAFETY: the context is alive.
        unsafe { OSMesaDestroyContext(self.0) };
    }
}

fn error() -> u32 {
    // SAFETY: the function takes no pointer.
    unsafe { glGetError() }
}

/// An array of exactly `length` values on the heap, at an odd address unless `T` is a byte.
struct Exact<T>(Vec<u8>, std::marker::PhantomData<T>);

impl<T: Copy> Exact<T> {
    fn new(values: &[T]) -> Self {
        let mut bytes = vec![0u8; 1 + size_of_val(values)];
        let size = size_of_val(values);
        // SAFETY: the vector has as many bytes behind its first.
        unsafe {
            ptr::copy_nonoverlapping(values.as_ptr().cast(), bytes.as_mut_ptr().add(1), size);
        }
        Self(bytes, std::marker::PhantomData)
    }

    fn at(&self) -> *const T {
        self.0[1..].as_ptr().cast()
    }

    fn at_mut(&mut self) -> *mut T {
        self.0[1..].as_mut_ptr().cast()
    }

    fn value(&self, place: usize) -> T {
        assert!((place + 1) * size_of::<T>() < self.0.len());
        // SAFETY: the place has been checked.
        unsafe { self.at().add(place).read_unaligned() }
    }
}

/// Parameters by name: (pname, how many values).
const OF_LIGHTS: [(u32, usize); 10] = [
    (0x1200, 4),
    (0x1201, 4),
    (0x1202, 4),
    (0x1203, 4),
    (0x1204, 3),
    (0x1205, 1),
    (0x1206, 1),
    (0x1207, 1),
    (0x1208, 1),
    (0x1209, 1),
];
const OF_MATERIALS: [(u32, usize); 7] =
    [(0x1200, 4), (0x1201, 4), (0x1202, 4), (0x1600, 4), (0x1601, 1), (0x1602, 4), (0x1603, 3)];
const OF_MODELS: [(u32, usize); 4] = [(0x0B51, 1), (0x0B52, 1), (0x0B53, 4), (0x81F8, 1)];
const OF_FOG: [(u32, usize); 7] =
    [(0x0B61, 1), (0x0B62, 1), (0x0B63, 1), (0x0B64, 1), (0x0B65, 1), (0x0B66, 4), (0x8450, 1)];

#[test]
fn parameters_of_lights_materials_and_fog_have_the_lengths_of_2_14_and_3_10() {
    let _current = Current::new();
    for (pname, length) in OF_LIGHTS {
        let mut floats = Exact::new(&vec![0.5f32; length]);
        let mut integers = Exact::new(&vec![1i32; length]);
        // SAFETY: the arrays have as many values as the parameter.
        unsafe {
            glLightfv(0x4001, pname, floats.at());
            glGetLightfv(0x4001, pname, floats.at_mut());
            glLightiv(0x4001, pname, integers.at());
            glGetLightiv(0x4001, pname, integers.at_mut());
        }
        assert_eq!(error(), 0, "{pname:#x}");
    }
    for (pname, length) in OF_MATERIALS {
        let mut floats = Exact::new(&vec![0.5f32; length]);
        let integers = Exact::new(&vec![1i32; length]);
        // SAFETY: the arrays have as many values as the parameter.
        unsafe {
            glMaterialfv(0x0404, pname, floats.at());
            if pname != 0x1602 {
                glGetMaterialfv(0x0404, pname, floats.at_mut());
            }
            glMaterialiv(0x0404, pname, integers.at());
        }
        assert_eq!(error(), 0, "{pname:#x}");
    }
    for (pname, length) in OF_MODELS {
        let color_control = pname == 0x81F8;
        let floats = Exact::new(&vec![if color_control { 33273.0f32 } else { 0.5 }; length]);
        let integers = Exact::new(&vec![if color_control { 33273 } else { 1 }; length]);
        // SAFETY: the arrays have as many values as the parameter.
        unsafe {
            glLightModelfv(pname, floats.at());
            glLightModeliv(pname, integers.at());
        }
        assert_eq!(error(), 0, "{pname:#x}");
    }
    for (pname, length) in OF_FOG {
        let value = match pname {
            0x0B65 => 2048,   // GL_FOG_MODE: GL_EXP
            0x8450 => 0x8452, // GL_FOG_COORD_SRC: GL_FRAGMENT_DEPTH
            _ => 1,
        };
        let floats = Exact::new(&vec![value as f32; length]);
        let integers = Exact::new(&vec![value; length]);
        // SAFETY: the arrays have as many values as the parameter.
        unsafe {
            glFogfv(pname, floats.at());
            glFogiv(pname, integers.at());
        }
        assert_eq!(error(), 0, "{pname:#x}");
    }
    for (pname, length) in [(0x8126, 1), (0x8127, 1), (0x8128, 1), (0x8129, 3)] {
        let floats = Exact::new(&vec![0.5f32; length]);
        // SAFETY: the array has as many values as the parameter.
        unsafe { glPointParameterfv(pname, floats.at()) };
        assert_eq!(error(), 0, "{pname:#x}");
    }
}

#[test]
fn unknown_parameters_read_nothing() {
    let _current = Current::new();
    // SAFETY: an unknown parameter has no values.
    unsafe {
        glLightfv(0x4000, 0x1234, ptr::null());
        assert_eq!(error(), 0x0500);
        glMaterialiv(0x0404, 0x1234, ptr::null());
        assert_eq!(error(), 0x0500);
        glFogfv(0x1234, ptr::null());
        assert_eq!(error(), 0x0500);
        glGetIntegerv(0x1234, ptr::null_mut());
        assert_eq!(error(), 0x0500);
    }
}

#[test]
fn matrices_and_planes_have_sixteen_and_four_values() {
    let _current = Current::new();
    let doubles: Vec<f64> = (0..16).map(f64::from).collect();
    let floats: Vec<f32> = doubles.iter().map(|&x| x as f32).collect();
    let (doubles, floats) = (Exact::new(&doubles), Exact::new(&floats));
    let mut back = Exact::new(&[0.0f64; 16]);
    let mut plane = Exact::new(&[1.0f64, 2.0, 3.0, 4.0]);
    // SAFETY: the arrays have as many values.
    unsafe {
        glLoadMatrixd(doubles.at());
        glGetDoublev(0x0BA6, back.at_mut());
        assert_eq!((back.value(1), back.value(15)), (1.0, 15.0));
        glLoadMatrixf(floats.at());
        glMultTransposeMatrixf(floats.at());
        glClipPlane(0x3005, plane.at());
        glGetClipPlane(0x3005, plane.at_mut());
    }
    assert_eq!(error(), 0);
}

#[test]
fn queries_write_as_many_values_as_the_state_has() {
    let _current = Current::new();
    for (pname, length) in
        [(0x0BA2, 4), (0x0B00, 4), (0x0B02, 3), (0x0B70, 2), (0x0B40, 2), (0x8129, 3), (0x0BE2, 1)]
    {
        let (mut f, mut d) = (Exact::new(&vec![0f32; length]), Exact::new(&vec![0f64; length]));
        let (mut i, mut b) = (Exact::new(&vec![0i32; length]), Exact::new(&vec![0u8; length]));
        // SAFETY: the arrays have as many values.
        unsafe {
            glGetFloatv(pname, f.at_mut());
            glGetDoublev(pname, d.at_mut());
            glGetIntegerv(pname, i.at_mut());
            glGetBooleanv(pname, b.at_mut());
        }
        assert_eq!(error(), 0, "{pname:#x}");
    }
}

#[test]
fn attributes_by_address_have_the_widths_in_their_names() {
    let _current = Current::new();
    // SAFETY: the arrays have as many values as the names say.
    unsafe {
        glColor3ubv(Exact::new(&[255u8, 0, 51]).at());
        let mut color = [0f32; 4];
        glGetFloatv(0x0B00, color.as_mut_ptr());
        assert_eq!(color, [1.0, 0.0, 0.2, 1.0]);
        glColor4iv(Exact::new(&[i32::MAX; 4]).at());
        glNormal3bv(Exact::new(&[127i8, -128, 0]).at());
        glNormal3dv(Exact::new(&[0.0f64, 0.0, 1.0]).at());
        glTexCoord2sv(Exact::new(&[1i16, 2]).at());
        glMultiTexCoord3fv(0x84C1, Exact::new(&[1f32, 2.0, 3.0]).at());
        glSecondaryColor3usv(Exact::new(&[65535u16; 3]).at());
        glFogCoorddv(Exact::new(&[2f64]).at());
        glIndexubv(Exact::new(&[3u8]).at());
        glEdgeFlagv(Exact::new(&[1u8]).at());
        glRasterPos4dv(Exact::new(&[0f64, 0.0, 0.0, 1.0]).at());
        glWindowPos2iv(Exact::new(&[1i32, 2]).at());
        glRectsv(Exact::new(&[0i16; 2]).at(), Exact::new(&[0i16; 2]).at());
    }
    assert_eq!(error(), 0);
}

#[test]
fn a_stipple_has_the_bytes_that_its_rows_take() {
    let _current = Current::new();
    let mut mask = Exact::new(&[0x5Au8; 128]);
    // SAFETY: 32 rows of 32 bits.
    unsafe {
        glPolygonStipple(mask.at());
        glGetPolygonStipple(mask.at_mut());
    }
    assert_eq!((mask.value(0), mask.value(127), error()), (0x5A, 0x5A, 0));
}

#[test]
fn names_of_lists_have_the_size_of_their_type() {
    let _current = Current::new();
    // SAFETY: the arrays have three names.
    unsafe {
        glNewList(1, 0x1300);
        glEndList();
        for (kind, size) in [
            (0x1400, 1),
            (0x1401, 1),
            (0x1402, 2),
            (0x1403, 2),
            (0x1404, 4),
            (0x1405, 4),
            (0x1406, 4),
            (0x1407, 2),
            (0x1408, 3),
            (0x1409, 4),
        ] {
            let names = Exact::new(&vec![1u8; 3 * size]);
            glCallLists(3, kind, names.at().cast());
            assert_eq!(error(), 0, "{kind:#x}");
        }
    }
}

#[test]
fn selection_and_feedback_write_to_the_last_array_that_was_taken() {
    let _current = Current::new();
    let (mut names, mut other) = (Exact::new(&[77u32; 4]), Exact::new(&[77u32; 4]));
    let mut values = Exact::new(&[77f32; 2]);
    let mut address = ptr::null_mut();
    // SAFETY: the arrays have the lengths that are given, and live until the end of the test.
    unsafe {
        glSelectBuffer(4, names.at_mut());
        assert_eq!(glRenderMode(0x1C02), 0);
        glSelectBuffer(4, other.at_mut());
        assert_eq!(error(), 0x0502);
        glGetPointerv(0x0DF3, &raw mut address);
        assert_eq!(address, names.at_mut().cast());
        glInitNames();
        glPushName(5);
        assert_eq!(glRenderMode(0x1C00), 0);
        glFeedbackBuffer(2, 0x0601, values.at_mut());
        glRenderMode(0x1C01);
        glPassThrough(3.5);
        assert_eq!(glRenderMode(0x1C00), 2);
        assert_eq!((values.value(0), values.value(1)), (1792.0, 3.5));
        glGetPointerv(0x1234, &raw mut address);
        assert_eq!(error(), 0x0500);
    }
    assert_eq!(other.value(0), 77);
}

#[test]
fn null_pointers_set_an_error_and_change_nothing() {
    let _current = Current::new();
    // SAFETY: null is what is tried.
    unsafe {
        glLoadMatrixd(ptr::null());
        assert_eq!(error(), INVALID_VALUE);
        glColor3ubv(ptr::null());
        assert_eq!(error(), INVALID_VALUE);
        glLightfv(0x4000, 0x1200, ptr::null());
        assert_eq!(error(), INVALID_VALUE);
        glGetIntegerv(0x0BA2, ptr::null_mut());
        assert_eq!(error(), INVALID_VALUE);
        glCallLists(1, UNSIGNED_BYTE, ptr::null());
        assert_eq!(error(), INVALID_VALUE);
        glGetPointerv(0x0DF3, ptr::null_mut());
        assert_eq!(error(), INVALID_VALUE);
    }
}

#[test]
fn osmesa_writes_single_values_and_follows_no_dead_handle() {
    let list = Exact::new(&[0x30i32, 24, 0x31, 8, 0]);
    // SAFETY: a 0 ends the list; other pointers lead to one value or are null; handles may be dead.
    unsafe {
        let context = OSMesaCreateContextAttribs(list.at(), ptr::null_mut());
        assert!(!context.is_null());
        let (mut w, mut h, mut f) = (7, 7, 7);
        let mut buffer: *mut c_void = ptr::dangling_mut();
        assert_eq!(
            OSMesaGetColorBuffer(context, &raw mut w, &raw mut h, &raw mut f, &raw mut buffer),
            0
        );
        assert_eq!((w, h, f, buffer), (0, 0, 0, ptr::null_mut()));
        OSMesaGetIntegerv(0x24, &raw mut w);
        assert_eq!(w, 16384);
        OSMesaGetIntegerv(0x24, ptr::null_mut());
        OSMesaDestroyContext(context);
        OSMesaDestroyContext(context);
        let mut pixels = [0u8; 4];
        assert_eq!(OSMesaMakeCurrent(context, pixels.as_mut_ptr().cast(), UNSIGNED_BYTE, 1, 1), 0);
        assert!(!OSMesaGetProcAddress(c"glVertex3f".as_ptr()).is_null());
        assert!(!OSMesaGetProcAddress(c"OSMesaGetProcAddress".as_ptr()).is_null());
        assert!(OSMesaGetProcAddress(c"glNothing".as_ptr()).is_null());
        assert!(OSMesaGetProcAddress(ptr::null()).is_null());
    }
}

#[test]
fn a_context_is_current_in_one_thread_and_left_at_its_end() {
    /// A handle on its way to another thread.
    struct Sent(*mut c_void);
    // SAFETY: the library itself says which thread may use a context.
    unsafe impl Send for Sent {}

    let context = Current::new();
    let handle = Sent(context.0);
    let take = move || {
        let Sent(handle) = { handle };
        let mut pixels = [0u8; 4];
        // SAFETY: the buffer has one pixel; the context isn't drawn to.
        unsafe { OSMesaMakeCurrent(handle, pixels.as_mut_ptr().cast(), UNSIGNED_BYTE, 1, 1) }
    };
    assert_eq!(std::thread::spawn(take).join().unwrap(), 0);
}
