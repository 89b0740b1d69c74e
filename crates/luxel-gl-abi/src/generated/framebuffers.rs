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
pub(crate) extern "C" fn glCheckFramebufferStatusEXT(target: u32) -> u32 {
    glCheckFramebufferStatus(target)
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
pub(crate) unsafe extern "C" fn glDeleteFramebuffersEXT(n: i32, framebuffers: *const u32) {
    // SAFETY: the same contract.
    unsafe { glDeleteFramebuffers(n, framebuffers) };
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
pub(crate) unsafe extern "C" fn glDeleteRenderbuffersEXT(n: i32, renderbuffers: *const u32) {
    // SAFETY: the same contract.
    unsafe { glDeleteRenderbuffers(n, renderbuffers) };
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
pub(crate) extern "C" fn glFramebufferRenderbufferEXT(
    target: u32,
    attachment: u32,
    renderbuffertarget: u32,
    renderbuffer: u32,
) {
    glFramebufferRenderbuffer(target, attachment, renderbuffertarget, renderbuffer);
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
pub(crate) extern "C" fn glFramebufferTexture1DEXT(
    target: u32,
    attachment: u32,
    textarget: u32,
    texture: u32,
    level: i32,
) {
    glFramebufferTexture1D(target, attachment, textarget, texture, level);
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
pub(crate) extern "C" fn glFramebufferTexture2DEXT(
    target: u32,
    attachment: u32,
    textarget: u32,
    texture: u32,
    level: i32,
) {
    glFramebufferTexture2D(target, attachment, textarget, texture, level);
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
pub(crate) extern "C" fn glFramebufferTexture3DEXT(
    target: u32,
    attachment: u32,
    textarget: u32,
    texture: u32,
    level: i32,
    zoffset: i32,
) {
    glFramebufferTexture3D(target, attachment, textarget, texture, level, zoffset);
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
pub(crate) extern "C" fn glFramebufferTextureLayerEXT(
    target: u32,
    attachment: u32,
    texture: u32,
    level: i32,
    layer: i32,
) {
    glFramebufferTextureLayer(target, attachment, texture, level, layer);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenFramebuffers(n: i32, framebuffers: *mut u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let names = gl.gen_framebuffers(n);
        store(framebuffers, names.len(), |at| names[at])?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenFramebuffersEXT(n: i32, framebuffers: *mut u32) {
    // SAFETY: the same contract.
    unsafe { glGenFramebuffers(n, framebuffers) };
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenRenderbuffers(n: i32, renderbuffers: *mut u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let names = gl.gen_renderbuffers(n);
        store(renderbuffers, names.len(), |at| names[at])?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenRenderbuffersEXT(n: i32, renderbuffers: *mut u32) {
    // SAFETY: the same contract.
    unsafe { glGenRenderbuffers(n, renderbuffers) };
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
        if let Some(values) = gl.get_framebuffer_attachment_parameter(target, attachment, pname) {
            store(params, values.len(), |at| values.to_i32(at))?;
        }

        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetFramebufferAttachmentParameterivEXT(
    target: u32,
    attachment: u32,
    pname: u32,
    params: *mut i32,
) {
    // SAFETY: the same contract.
    unsafe { glGetFramebufferAttachmentParameteriv(target, attachment, pname, params) };
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetRenderbufferParameteriv(
    target: u32,
    pname: u32,
    params: *mut i32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_renderbuffer_parameter(target, pname) {
            store(params, values.len(), |at| values.to_i32(at))?;
        }

        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetRenderbufferParameterivEXT(
    target: u32,
    pname: u32,
    params: *mut i32,
) {
    // SAFETY: the same contract.
    unsafe { glGetRenderbufferParameteriv(target, pname, params) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsFramebuffer(framebuffer: u32) -> u8 {
    call(|gl, _| u8::from(gl.is_framebuffer(framebuffer)))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsFramebufferEXT(framebuffer: u32) -> u8 {
    glIsFramebuffer(framebuffer)
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsRenderbuffer(renderbuffer: u32) -> u8 {
    call(|gl, _| u8::from(gl.is_renderbuffer(renderbuffer)))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsRenderbufferEXT(renderbuffer: u32) -> u8 {
    glIsRenderbuffer(renderbuffer)
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
pub(crate) extern "C" fn glRenderbufferStorageEXT(
    target: u32,
    internalformat: u32,
    width: i32,
    height: i32,
) {
    glRenderbufferStorage(target, internalformat, width, height);
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

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRenderbufferStorageMultisampleEXT(
    target: u32,
    samples: i32,
    internalformat: u32,
    width: i32,
    height: i32,
) {
    glRenderbufferStorageMultisample(target, samples, internalformat, width, height);
}
