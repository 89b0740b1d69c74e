// Written by ../../generator from gl.xml and commands.toml: change these.

//! Commands of OpenGL 1.5 and of framebuffer objects that are not carried out yet.

use std::ffi::c_void;

crate::entry::unsupported! {
    glAccum(op: u32, value: f32);
    glBeginQuery(target: u32, id: u32);
    glBeginQueryARB(target: u32, id: u32);
    glCompressedTexSubImage1D(target: u32, level: i32, xoffset: i32, width: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage1DARB(target: u32, level: i32, xoffset: i32, width: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage2D(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage2DARB(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage3D(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage3DARB(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, image_size: i32, data: *const c_void);
    glCopyPixels(x: i32, y: i32, width: i32, height: i32, kind: u32);
    glDeleteQueries(n: i32, ids: *const u32);
    glDeleteQueriesARB(n: i32, ids: *const u32);
    glDrawPixels(width: i32, height: i32, format: u32, kind: u32, pixels: *const c_void);
    glEndQuery(target: u32);
    glEndQueryARB(target: u32);
    glEvalCoord1d(u: f64);
    glEvalCoord1dv(u: *const f64);
    glEvalCoord1f(u: f32);
    glEvalCoord1fv(u: *const f32);
    glEvalCoord2d(u: f64, v: f64);
    glEvalCoord2dv(u: *const f64);
    glEvalCoord2f(u: f32, v: f32);
    glEvalCoord2fv(u: *const f32);
    glEvalMesh1(mode: u32, i1: i32, i2: i32);
    glEvalMesh2(mode: u32, i1: i32, i2: i32, j1: i32, j2: i32);
    glEvalPoint1(i: i32);
    glEvalPoint2(i: i32, j: i32);
    glGenQueries(n: i32, ids: *mut u32);
    glGenQueriesARB(n: i32, ids: *mut u32);
    glGetCompressedTexImage(target: u32, level: i32, img: *mut c_void);
    glGetCompressedTexImageARB(target: u32, level: i32, img: *mut c_void);
    glGetMapdv(target: u32, query: u32, v: *mut f64);
    glGetMapfv(target: u32, query: u32, v: *mut f32);
    glGetMapiv(target: u32, query: u32, v: *mut i32);
    glGetPixelMapfv(map: u32, values: *mut f32);
    glGetPixelMapuiv(map: u32, values: *mut u32);
    glGetPixelMapusv(map: u32, values: *mut u16);
    glGetQueryObjectiv(id: u32, pname: u32, params: *mut i32);
    glGetQueryObjectivARB(id: u32, pname: u32, params: *mut i32);
    glGetQueryObjectuiv(id: u32, pname: u32, params: *mut u32);
    glGetQueryObjectuivARB(id: u32, pname: u32, params: *mut u32);
    glGetQueryiv(target: u32, pname: u32, params: *mut i32);
    glGetQueryivARB(target: u32, pname: u32, params: *mut i32);
    glIsQuery(id: u32) -> u8;
    glIsQueryARB(id: u32) -> u8;
    glMap1d(target: u32, u1: f64, u2: f64, stride: i32, order: i32, points: *const f64);
    glMap1f(target: u32, u1: f32, u2: f32, stride: i32, order: i32, points: *const f32);
    glMap2d(target: u32, u1: f64, u2: f64, ustride: i32, uorder: i32, v1: f64, v2: f64, vstride: i32, vorder: i32, points: *const f64);
    glMap2f(target: u32, u1: f32, u2: f32, ustride: i32, uorder: i32, v1: f32, v2: f32, vstride: i32, vorder: i32, points: *const f32);
    glMapGrid1d(un: i32, u1: f64, u2: f64);
    glMapGrid1f(un: i32, u1: f32, u2: f32);
    glMapGrid2d(un: i32, u1: f64, u2: f64, vn: i32, v1: f64, v2: f64);
    glMapGrid2f(un: i32, u1: f32, u2: f32, vn: i32, v1: f32, v2: f32);
    glPixelMapfv(map: u32, mapsize: i32, values: *const f32);
    glPixelMapuiv(map: u32, mapsize: i32, values: *const u32);
    glPixelMapusv(map: u32, mapsize: i32, values: *const u16);
    glPixelTransferf(pname: u32, param: f32);
    glPixelTransferi(pname: u32, param: i32);
    glPixelZoom(xfactor: f32, yfactor: f32);
    glSampleCoverage(value: f32, invert: u8);
    glSampleCoverageARB(value: f32, invert: u8);
}
