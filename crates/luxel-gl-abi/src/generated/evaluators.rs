// Written by ../../generator from gl.xml and commands.toml: change these.

//! Evaluators (5.1).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEvalCoord1d(u: f64) {
    call(|gl, _| gl.eval_coord_1(u as f32));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glEvalCoord1dv(u: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [u] = array(u)?;
        gl.eval_coord_1(u as f32);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEvalCoord1f(u: f32) {
    call(|gl, _| gl.eval_coord_1(u));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glEvalCoord1fv(u: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [u] = array(u)?;
        gl.eval_coord_1(u);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEvalCoord2d(u: f64, v: f64) {
    call(|gl, _| gl.eval_coord_2([u as f32, v as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glEvalCoord2dv(u: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.eval_coord_2(array(u)?.map(|x: f64| x as f32));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEvalCoord2f(u: f32, v: f32) {
    call(|gl, _| gl.eval_coord_2([u, v]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glEvalCoord2fv(u: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.eval_coord_2(array(u)?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEvalMesh1(mode: u32, i1: i32, i2: i32) {
    call(|gl, _| gl.eval_mesh_1(mode, [i1, i2]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEvalMesh2(mode: u32, i1: i32, i2: i32, j1: i32, j2: i32) {
    call(|gl, _| gl.eval_mesh_2(mode, [i1, i2], [j1, j2]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEvalPoint1(i: i32) {
    call(|gl, _| gl.eval_point_1(i));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEvalPoint2(i: i32, j: i32) {
    call(|gl, _| gl.eval_point_2([i, j]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetMapdv(target: u32, query: u32, v: *mut f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_map(target, query) {
            store_all(v, &values)?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetMapfv(target: u32, query: u32, v: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_map(target, query) {
            store(v, values.len(), |at| values[at] as f32)?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetMapiv(target: u32, query: u32, v: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_map(target, query) {
            store(v, values.len(), |at| values[at].round() as i32)?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMap1d(
    target: u32,
    u1: f64,
    u2: f64,
    stride: i32,
    order: i32,
    points: *const f64,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let points = copied(points, lengths::map_1(target, stride, order) as i32)?;
        gl.map_1(target, [u1, u2], stride, order, &points);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMap1f(
    target: u32,
    u1: f32,
    u2: f32,
    stride: i32,
    order: i32,
    points: *const f32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let points = copied(points, lengths::map_1(target, stride, order) as i32)?
            .into_iter()
            .map(f64::from)
            .collect::<Vec<_>>();
        gl.map_1(target, [u1.into(), u2.into()], stride, order, &points);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMap2d(
    target: u32,
    u1: f64,
    u2: f64,
    ustride: i32,
    uorder: i32,
    v1: f64,
    v2: f64,
    vstride: i32,
    vorder: i32,
    points: *const f64,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let (stride, order) = ([ustride, vstride], [uorder, vorder]);
        let points = copied(points, lengths::map_2(target, stride, order) as i32)?;
        gl.map_2(target, [[u1, u2], [v1, v2]], stride, order, &points);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMap2f(
    target: u32,
    u1: f32,
    u2: f32,
    ustride: i32,
    uorder: i32,
    v1: f32,
    v2: f32,
    vstride: i32,
    vorder: i32,
    points: *const f32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let (stride, order) = ([ustride, vstride], [uorder, vorder]);
        let points = copied(points, lengths::map_2(target, stride, order) as i32)?
            .into_iter()
            .map(f64::from)
            .collect::<Vec<_>>();
        gl.map_2(target, [[u1.into(), u2.into()], [v1.into(), v2.into()]], stride, order, &points);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMapGrid1d(un: i32, u1: f64, u2: f64) {
    call(|gl, _| gl.map_grid_1(un, [u1 as f32, u2 as f32]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMapGrid1f(un: i32, u1: f32, u2: f32) {
    call(|gl, _| gl.map_grid_1(un, [u1, u2]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMapGrid2d(un: i32, u1: f64, u2: f64, vn: i32, v1: f64, v2: f64) {
    call(|gl, _| gl.map_grid_2([un, vn], [[u1 as f32, u2 as f32], [v1 as f32, v2 as f32]]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMapGrid2f(un: i32, u1: f32, u2: f32, vn: i32, v1: f32, v2: f32) {
    call(|gl, _| gl.map_grid_2([un, vn], [[u1, u2], [v1, v2]]));
}
