// Written by ../../generator from gl.xml and commands.toml: change these.

//! Vertex arrays (2.8) and buffer objects (2.9).

use crate::prelude::*;
use std::ffi::c_void;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glArrayElement(i: i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.array_element(i, &caller_memory());
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBindBuffer(target: u32, buffer: u32) {
    call(|gl, _| gl.bind_buffer(target, buffer));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glBufferData(
    target: u32,
    size: isize,
    data: *const c_void,
    usage: u32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, client| unsafe {
        client.buffer_data(gl, target, size, optional_bytes(data, extent(size)), usage);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glBufferSubData(
    target: u32,
    offset: isize,
    size: isize,
    data: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.buffer_part_bytes(target, offset, size);
        if length > 0 {
            gl.buffer_sub_data(target, offset, bytes(data, length)?);
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColorPointer(
    size: i32,
    kind: u32,
    stride: i32,
    pointer: *const c_void,
) {
    call(|gl, _| gl.color_pointer(size, kind, stride, address(pointer)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColorPointerEXT(
    size: i32,
    kind: u32,
    stride: i32,
    count: i32,
    pointer: *const c_void,
) {
    call(|gl, _| {
        let _ = count;
        gl.color_pointer(size, kind, stride, address(pointer))
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glDeleteBuffers(n: i32, buffers: *const u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, client| unsafe {
        if n < 0 {
            gl.set_error(GL_INVALID_VALUE);
        } else {
            client.delete_buffers(gl, &copied(buffers, n)?);
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glDisableClientState(array: u32) {
    call(|gl, _| gl.disable_client_state(array));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glDrawArrays(mode: u32, first: i32, count: i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.draw_arrays(mode, first, count, &caller_memory());
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glDrawElements(
    mode: u32,
    count: i32,
    kind: u32,
    indices: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.draw_elements(mode, count, kind, address(indices), &caller_memory());
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glDrawRangeElements(
    mode: u32,
    start: u32,
    end: u32,
    count: i32,
    kind: u32,
    indices: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.draw_range_elements(mode, start, end, count, kind, address(indices), &caller_memory());
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glEdgeFlagPointer(stride: i32, pointer: *const c_void) {
    call(|gl, _| gl.edge_flag_pointer(stride, address(pointer)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glEdgeFlagPointerEXT(stride: i32, count: i32, pointer: *const u8) {
    call(|gl, _| {
        let _ = count;
        gl.edge_flag_pointer(stride, address(pointer))
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEnableClientState(array: u32) {
    call(|gl, _| gl.enable_client_state(array));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFlushMappedBufferRange(target: u32, offset: isize, length: isize) {
    call(|gl, client| client.flush_range(gl, target, offset, length));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glFogCoordPointer(kind: u32, stride: i32, pointer: *const c_void) {
    call(|gl, _| gl.fog_coord_pointer(kind, stride, address(pointer)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenBuffers(n: i32, buffers: *mut u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        store_all(buffers, &gl.gen_buffers(n))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetBufferParameteriv(target: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_buffer_parameter(target, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetBufferPointerv(
    target: u32,
    pname: u32,
    params: *mut *mut c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, client| unsafe {
        if let Some(address) = client.mapped_address(gl, target, pname) {
            store(params, 1, |_| address)?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetBufferSubData(
    target: u32,
    offset: isize,
    size: isize,
    data: *mut c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.buffer_part_bytes(target, offset, size);
        if length > 0 {
            gl.get_buffer_sub_data(target, offset, bytes_mut(data, length)?);
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glIndexPointer(kind: u32, stride: i32, pointer: *const c_void) {
    call(|gl, _| gl.index_pointer(kind, stride, address(pointer)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glIndexPointerEXT(
    kind: u32,
    stride: i32,
    count: i32,
    pointer: *const c_void,
) {
    call(|gl, _| {
        let _ = count;
        gl.index_pointer(kind, stride, address(pointer))
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glInterleavedArrays(
    format: u32,
    stride: i32,
    pointer: *const c_void,
) {
    call(|gl, _| gl.interleaved_arrays(format, stride, address(pointer)));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsBuffer(buffer: u32) -> u8 {
    call(|gl, _| u8::from(gl.is_buffer(buffer)))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glLockArraysEXT(first: i32, count: i32) {
    call(|gl, _| gl.lock_arrays(first, count));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMapBuffer(target: u32, access: u32) -> *mut c_void {
    call(|gl, client| client.map_buffer(gl, target, access))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMapBufferRange(
    target: u32,
    offset: isize,
    length: isize,
    access: u32,
) -> *mut c_void {
    call(|gl, client| client.map_range(gl, target, offset, length, access))
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiDrawArrays(
    mode: u32,
    first: *const i32,
    count: *const i32,
    drawcount: i32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if drawcount < 0 {
            gl.set_error(GL_INVALID_VALUE);
        } else {
            gl.multi_draw_arrays(
                mode,
                &copied(first, drawcount)?,
                &copied(count, drawcount)?,
                &caller_memory(),
            );
        }

        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiDrawElements(
    mode: u32,
    count: *const i32,
    kind: u32,
    indices: *const *const c_void,
    drawcount: i32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if drawcount < 0 {
            gl.set_error(GL_INVALID_VALUE);
        } else {
            let indices: Vec<usize> =
                copied(indices, drawcount)?.into_iter().map(address).collect();
            gl.multi_draw_elements(
                mode,
                &copied(count, drawcount)?,
                kind,
                &indices,
                &caller_memory(),
            );
        }

        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glNormalPointer(kind: u32, stride: i32, pointer: *const c_void) {
    call(|gl, _| gl.normal_pointer(kind, stride, address(pointer)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glNormalPointerEXT(
    kind: u32,
    stride: i32,
    count: i32,
    pointer: *const c_void,
) {
    call(|gl, _| {
        let _ = count;
        gl.normal_pointer(kind, stride, address(pointer))
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColorPointer(
    size: i32,
    kind: u32,
    stride: i32,
    pointer: *const c_void,
) {
    call(|gl, _| gl.secondary_color_pointer(size, kind, stride, address(pointer)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoordPointer(
    size: i32,
    kind: u32,
    stride: i32,
    pointer: *const c_void,
) {
    call(|gl, _| gl.tex_coord_pointer(size, kind, stride, address(pointer)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoordPointerEXT(
    size: i32,
    kind: u32,
    stride: i32,
    count: i32,
    pointer: *const c_void,
) {
    call(|gl, _| {
        let _ = count;
        gl.tex_coord_pointer(size, kind, stride, address(pointer))
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glUnlockArraysEXT() {
    call(|gl, _| gl.unlock_arrays());
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glUnmapBuffer(target: u32) -> u8 {
    call(|gl, client| client.unmap_buffer(gl, target))
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertexPointer(
    size: i32,
    kind: u32,
    stride: i32,
    pointer: *const c_void,
) {
    call(|gl, _| gl.vertex_pointer(size, kind, stride, address(pointer)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertexPointerEXT(
    size: i32,
    kind: u32,
    stride: i32,
    count: i32,
    pointer: *const c_void,
) {
    call(|gl, _| {
        let _ = count;
        gl.vertex_pointer(size, kind, stride, address(pointer))
    });
}

aliases! {
    glArrayElementEXT = glArrayElement(i: i32);
    glBindBufferARB = glBindBuffer(target: u32, buffer: u32);
    unsafe glBufferDataARB = glBufferData(target: u32, size: isize, data: *const c_void, usage: u32);
    unsafe glBufferSubDataARB = glBufferSubData(target: u32, offset: isize, size: isize, data: *const c_void);
    unsafe glDeleteBuffersARB = glDeleteBuffers(n: i32, buffers: *const u32);
    glDrawArraysEXT = glDrawArrays(mode: u32, first: i32, count: i32);
    unsafe glDrawRangeElementsEXT = glDrawRangeElements(mode: u32, start: u32, end: u32, count: i32, kind: u32, indices: *const c_void);
    unsafe glFogCoordPointerEXT = glFogCoordPointer(kind: u32, stride: i32, pointer: *const c_void);
    unsafe glGenBuffersARB = glGenBuffers(n: i32, buffers: *mut u32);
    unsafe glGetBufferParameterivARB = glGetBufferParameteriv(target: u32, pname: u32, params: *mut i32);
    unsafe glGetBufferPointervARB = glGetBufferPointerv(target: u32, pname: u32, params: *mut *mut c_void);
    unsafe glGetBufferSubDataARB = glGetBufferSubData(target: u32, offset: isize, size: isize, data: *mut c_void);
    glIsBufferARB = glIsBuffer(buffer: u32) -> u8;
    glMapBufferARB = glMapBuffer(target: u32, access: u32) -> *mut c_void;
    unsafe glMultiDrawArraysEXT = glMultiDrawArrays(mode: u32, first: *const i32, count: *const i32, primcount: i32);
    unsafe glMultiDrawElementsEXT = glMultiDrawElements(mode: u32, count: *const i32, kind: u32, indices: *const *const c_void, primcount: i32);
    unsafe glSecondaryColorPointerEXT = glSecondaryColorPointer(size: i32, kind: u32, stride: i32, pointer: *const c_void);
    glUnmapBufferARB = glUnmapBuffer(target: u32) -> u8;
}
