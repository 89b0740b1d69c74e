// Written by ../../generator from gl.xml and commands.toml: change these.

//! Framebuffer objects and renderbuffers (ARB_framebuffer_object, EXT_framebuffer_object, _blit, _multisample).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBindFramebuffer(target: u32, framebuffer: u32) {
    call(|gl, _| gl.bind_framebuffer(target, framebuffer));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBindFramebufferEXT(target: u32, framebuffer: u32) {
    call(|gl, _| gl.bind_framebuffer(target, framebuffer));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBindRenderbuffer(target: u32, renderbuffer: u32) {
    call(|gl, _| gl.bind_renderbuffer(target, renderbuffer));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBindRenderbufferEXT(target: u32, renderbuffer: u32) {
    call(|gl, _| gl.bind_renderbuffer(target, renderbuffer));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBlitFramebuffer(
    src_x0: i32,
    src_y0: i32,
    src_x1: i32,
    src_y1: i32,
    dst_x0: i32,
    dst_y0: i32,
    dst_x1: i32,
    dst_y1: i32,
    mask: u32,
    filter: u32,
) {
    call(|gl, _| {
        gl.blit_framebuffer(
            [src_x0, src_y0, src_x1, src_y1],
            [dst_x0, dst_y0, dst_x1, dst_y1],
            mask,
            filter,
        )
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glCheckFramebufferStatus(target: u32) -> u32 {
    call(|gl, _| gl.check_framebuffer_status(target))
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glDeleteFramebuffers(n: i32, framebuffers: *const u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if n < 0 {
            gl.set_error(GL_INVALID_VALUE);
        } else {
            gl.delete_framebuffers(&copied(framebuffers, n)?);
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glDeleteRenderbuffers(n: i32, renderbuffers: *const u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if n < 0 {
            gl.set_error(GL_INVALID_VALUE);
        } else {
            gl.delete_renderbuffers(&copied(renderbuffers, n)?);
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFramebufferRenderbuffer(
    target: u32,
    attachment: u32,
    renderbuffertarget: u32,
    renderbuffer: u32,
) {
    call(|gl, _| gl.framebuffer_renderbuffer(target, attachment, renderbuffertarget, renderbuffer));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFramebufferTexture1D(
    target: u32,
    attachment: u32,
    textarget: u32,
    texture: u32,
    level: i32,
) {
    call(|gl, _| gl.framebuffer_texture(target, attachment, textarget, texture, level, 0));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFramebufferTexture2D(
    target: u32,
    attachment: u32,
    textarget: u32,
    texture: u32,
    level: i32,
) {
    call(|gl, _| gl.framebuffer_texture(target, attachment, textarget, texture, level, 0));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFramebufferTexture3D(
    target: u32,
    attachment: u32,
    textarget: u32,
    texture: u32,
    level: i32,
    zoffset: i32,
) {
    call(|gl, _| gl.framebuffer_texture(target, attachment, textarget, texture, level, zoffset));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFramebufferTextureLayer(
    target: u32,
    attachment: u32,
    texture: u32,
    level: i32,
    layer: i32,
) {
    call(|gl, _| {
        gl.framebuffer_texture(
            target,
            attachment,
            if texture == 0 { 0 } else { GL_TEXTURE_3D },
            texture,
            level,
            layer,
        )
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenFramebuffers(n: i32, framebuffers: *mut u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        store_all(framebuffers, &gl.gen_framebuffers(n))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenRenderbuffers(n: i32, renderbuffers: *mut u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        store_all(renderbuffers, &gl.gen_renderbuffers(n))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetFramebufferAttachmentParameteriv(
    target: u32,
    attachment: u32,
    pname: u32,
    params: *mut i32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_framebuffer_attachment_parameter(target, attachment, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetRenderbufferParameteriv(
    target: u32,
    pname: u32,
    params: *mut i32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_renderbuffer_parameter(target, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsFramebuffer(framebuffer: u32) -> u8 {
    call(|gl, _| u8::from(gl.is_framebuffer(framebuffer)))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsRenderbuffer(renderbuffer: u32) -> u8 {
    call(|gl, _| u8::from(gl.is_renderbuffer(renderbuffer)))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRenderbufferStorage(
    target: u32,
    internalformat: u32,
    width: i32,
    height: i32,
) {
    call(|gl, _| gl.renderbuffer_storage(target, 0, internalformat, width, height));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRenderbufferStorageMultisample(
    target: u32,
    samples: i32,
    internalformat: u32,
    width: i32,
    height: i32,
) {
    call(|gl, _| gl.renderbuffer_storage(target, samples, internalformat, width, height));
}

aliases! {
    glCheckFramebufferStatusEXT = glCheckFramebufferStatus(target: u32) -> u32;
    unsafe glDeleteFramebuffersEXT = glDeleteFramebuffers(n: i32, framebuffers: *const u32);
    unsafe glDeleteRenderbuffersEXT = glDeleteRenderbuffers(n: i32, renderbuffers: *const u32);
    glFramebufferRenderbufferEXT = glFramebufferRenderbuffer(target: u32, attachment: u32, renderbuffertarget: u32, renderbuffer: u32);
    glFramebufferTexture1DEXT = glFramebufferTexture1D(target: u32, attachment: u32, textarget: u32, texture: u32, level: i32);
    glFramebufferTexture2DEXT = glFramebufferTexture2D(target: u32, attachment: u32, textarget: u32, texture: u32, level: i32);
    glFramebufferTexture3DEXT = glFramebufferTexture3D(target: u32, attachment: u32, textarget: u32, texture: u32, level: i32, zoffset: i32);
    glFramebufferTextureLayerEXT = glFramebufferTextureLayer(target: u32, attachment: u32, texture: u32, level: i32, layer: i32);
    unsafe glGenFramebuffersEXT = glGenFramebuffers(n: i32, framebuffers: *mut u32);
    unsafe glGenRenderbuffersEXT = glGenRenderbuffers(n: i32, renderbuffers: *mut u32);
    unsafe glGetFramebufferAttachmentParameterivEXT = glGetFramebufferAttachmentParameteriv(target: u32, attachment: u32, pname: u32, params: *mut i32);
    unsafe glGetRenderbufferParameterivEXT = glGetRenderbufferParameteriv(target: u32, pname: u32, params: *mut i32);
    glIsFramebufferEXT = glIsFramebuffer(framebuffer: u32) -> u8;
    glIsRenderbufferEXT = glIsRenderbuffer(renderbuffer: u32) -> u8;
    glRenderbufferStorageEXT = glRenderbufferStorage(target: u32, internalformat: u32, width: i32, height: i32);
    glRenderbufferStorageMultisampleEXT = glRenderbufferStorageMultisample(target: u32, samples: i32, internalformat: u32, width: i32, height: i32);
}
