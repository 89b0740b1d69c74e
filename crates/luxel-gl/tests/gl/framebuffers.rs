//! Framebuffer objects and renderbuffers (EXT_framebuffer_object, EXT_framebuffer_blit).

use crate::canvas::{canvas, draw, gl, pixels};
use luxel_gl::Context;

const FRAMEBUFFER: u32 = 0x8D40;
const READ: u32 = 0x8CA8;
const DRAW: u32 = 0x8CA9;
const RENDERBUFFER: u32 = 0x8D41;
const COLOR: u32 = 0x8CE0;
const DEPTH: u32 = 0x8D00;
const COMPLETE: u32 = 0x8CD5;
const INVALID_FRAMEBUFFER_OPERATION: u32 = 0x0506;
const RGBA8: u32 = 0x8058;
const DEPTH24: u32 = 0x81A6;
const WHOLE: [[f32; 3]; 3] = [[-50.0, -50.0, 0.0], [50.0, -50.0, 0.0], [0.0, 90.0, 0.0]];

/// A framebuffer object with colour and depth in renderbuffers, bound.
fn with_renderbuffers(context: &mut Context, width: i32, height: i32) -> u32 {
    let [framebuffer] = context.gen_framebuffers(1).try_into().unwrap();
    context.bind_framebuffer(FRAMEBUFFER, framebuffer);
    for (attachment, format) in [(COLOR, RGBA8), (DEPTH, DEPTH24)] {
        let [name] = context.gen_renderbuffers(1).try_into().unwrap();
        context.bind_renderbuffer(RENDERBUFFER, name);
        context.renderbuffer_storage(RENDERBUFFER, 0, format, width, height);
        context.framebuffer_renderbuffer(FRAMEBUFFER, attachment, RENDERBUFFER, name);
    }
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), COMPLETE);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    framebuffer
}

fn read(context: &mut Context, width: i32, height: i32) -> Vec<[u8; 4]> {
    let mut bytes = vec![0; (width * height * 4) as usize];
    context.read_pixels(0, 0, width, height, gl::RGBA, gl::UNSIGNED_BYTE, &mut bytes);
    bytes.as_chunks().0.to_vec()
}

#[test]
fn ext_framebuffer_object_draws_to_its_images_and_leaves_the_window_alone() {
    let mut context = canvas(8, 8);
    context.clear_color([0.0, 0.0, 1.0, 1.0]);
    context.clear(gl::COLOR_BUFFER_BIT);
    let object = with_renderbuffers(&mut context, 8, 8);
    context.clear_color([0.0; 4]);
    context.clear(gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT);
    context.enable(gl::DEPTH_TEST);
    context.color([1.0, 0.0, 0.0, 1.0]);
    draw(&mut context, gl::TRIANGLES, &[[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]]);
    context.bind_framebuffer(FRAMEBUFFER, 0);
    assert_eq!(pixels(&mut context), vec![[0, 0, 255, 255]; 64]);
    // What was drawn is there when it is bound again, depths too.
    context.bind_framebuffer(FRAMEBUFFER, object);
    context.color([0.0, 1.0, 0.0, 1.0]);
    draw(&mut context, gl::TRIANGLES, &WHOLE.map(|[x, y, _]| [x, y, -0.5]));
    let found = read(&mut context, 8, 8);
    assert_eq!([found[0], found[63]], [[255, 0, 0, 255], [0, 255, 0, 255]]);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn ext_framebuffer_blit_copies_stretches_and_mirrors() {
    let mut context = canvas(8, 8);
    let object = with_renderbuffers(&mut context, 4, 4);
    context.enable(gl::SCISSOR_TEST);
    for (x, red) in [(0, 0.0), (1, 0.2), (2, 0.4), (3, 1.0)] {
        context.scissor(x, 0, 1, 4);
        context.clear_color([red, 0.0, 0.0, 1.0]);
        context.clear(gl::COLOR_BUFFER_BIT);
    }
    context.disable(gl::SCISSOR_TEST);
    context.bind_framebuffer(DRAW, 0);
    context.bind_framebuffer(READ, object);
    context.blit_framebuffer([0, 0, 4, 4], [8, 0, 0, 8], gl::COLOR_BUFFER_BIT, 0x2600);
    context.bind_framebuffer(READ, 0);
    let row: Vec<u8> = pixels(&mut context)[..8].iter().map(|pixel| pixel[0]).collect();
    assert_eq!(row, [255, 255, 102, 102, 51, 51, 0, 0]);
    context.bind_framebuffer(READ, object);
    context.blit_framebuffer([0, 0, 4, 4], [0, 0, 8, 8], gl::COLOR_BUFFER_BIT, 0x2601);
    context.bind_framebuffer(READ, 0);
    let row: Vec<u8> = pixels(&mut context)[..8].iter().map(|pixel| pixel[0]).collect();
    assert_eq!(row, [0, 13, 38, 64, 89, 140, 217, 255]);
    context.blit_framebuffer([0, 0, 4, 4], [0, 0, 4, 4], gl::DEPTH_BUFFER_BIT, 0x2601);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
}

#[test]
fn ext_framebuffer_object_tells_what_is_missing() {
    let mut context = canvas(8, 8);
    let [object] = context.gen_framebuffers(1).try_into().unwrap();
    assert!(!context.is_framebuffer(object));
    context.bind_framebuffer(FRAMEBUFFER, object);
    assert!(context.is_framebuffer(object));
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), 0x8CD7);
    context.clear(gl::COLOR_BUFFER_BIT);
    assert_eq!(context.get_error(), INVALID_FRAMEBUFFER_OPERATION);
    context.begin(gl::TRIANGLES);
    assert_eq!(context.get_error(), INVALID_FRAMEBUFFER_OPERATION);
    context.rect([0.0; 2], [1.0; 2]);
    assert_eq!(context.get_error(), INVALID_FRAMEBUFFER_OPERATION);
    read(&mut context, 1, 1);
    assert_eq!(context.get_error(), INVALID_FRAMEBUFFER_OPERATION);
    context.bind_renderbuffer(RENDERBUFFER, 5);
    context.renderbuffer_storage(RENDERBUFFER, 0, DEPTH24, 8, 8);
    // Depth in the place of colour.
    context.framebuffer_renderbuffer(FRAMEBUFFER, COLOR, RENDERBUFFER, 5);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), 0x8CD6);
    context.framebuffer_renderbuffer(FRAMEBUFFER, COLOR, RENDERBUFFER, 0);
    context.framebuffer_renderbuffer(FRAMEBUFFER, DEPTH, RENDERBUFFER, 5);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), COMPLETE);
    context.delete_renderbuffers(&[5]);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), 0x8CD7);
    context.delete_framebuffers(&[object]);
    assert_eq!(context.get(0x8CA6).unwrap().to_i32(0), 0);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn ext_framebuffer_object_has_these_errors() {
    type Case = (&'static str, fn(&mut Context), u32);
    let cases: [Case; 7] = [
        ("glBindFramebuffer", |c| c.bind_framebuffer(1, 0), gl::INVALID_ENUM),
        ("glBindRenderbuffer", |c| c.bind_renderbuffer(1, 0), gl::INVALID_ENUM),
        (
            "glRenderbufferStorage",
            |c| c.renderbuffer_storage(RENDERBUFFER, 0, 1, 1, 1),
            gl::INVALID_ENUM,
        ),
        (
            "glRenderbufferStorage of none",
            |c| c.renderbuffer_storage(RENDERBUFFER, 0, RGBA8, 1, 1),
            gl::INVALID_OPERATION,
        ),
        (
            "glRenderbufferStorageMultisample",
            |c| c.renderbuffer_storage(RENDERBUFFER, 5, RGBA8, 1, 1),
            gl::INVALID_VALUE,
        ),
        (
            "glFramebufferRenderbuffer",
            |c| c.framebuffer_renderbuffer(FRAMEBUFFER, COLOR, RENDERBUFFER, 0),
            gl::INVALID_OPERATION,
        ),
        ("glBlitFramebuffer", |c| c.blit_framebuffer([0; 4], [0; 4], 1, 0x2600), gl::INVALID_VALUE),
    ];
    for (name, command, error) in cases {
        let mut context = canvas(4, 4);
        command(&mut context);
        assert_eq!(context.get_error(), error, "{name}");
    }
}

#[test]
fn ext_framebuffer_object_has_storage_of_the_size_that_was_asked_for() {
    let mut context = canvas(4, 4);
    with_renderbuffers(&mut context, 70, 3);
    let mut get =
        |pname| context.get_renderbuffer_parameter(RENDERBUFFER, pname).unwrap().to_i32(0);
    assert_eq!([get(0x8D42), get(0x8D43), get(0x8D54), get(0x8D50)], [70, 3, 24, 0]);
    let kind = context.get_framebuffer_attachment_parameter(FRAMEBUFFER, COLOR, 0x8CD0).unwrap();
    assert_eq!(kind.to_i32(0), RENDERBUFFER as i32);
    // The viewport stays that of the window.
    context.clear_color([1.0; 4]);
    context.clear(gl::COLOR_BUFFER_BIT);
    assert_eq!(read(&mut context, 70, 3), vec![[255; 4]; 210]);
}

/// A texture of 8x8 texels, without mipmaps.
fn texture(context: &mut Context, internal: i32, format: u32) -> u32 {
    context.bind_texture(0x0DE1, 77);
    context.tex_image_2d(0x0DE1, 0, internal, [8, 8], 0, format, gl::UNSIGNED_BYTE, None);
    for (pname, value) in [(0x2801, 9728.0), (0x2800, 9728.0)] {
        context.tex_parameter(0x0DE1, pname, &[value]);
    }
    77
}

#[test]
fn ext_framebuffer_object_textures_show_what_was_drawn_to_them() {
    let mut context = canvas(8, 8);
    let name = texture(&mut context, 0x1908, gl::RGBA);
    context.bind_framebuffer(FRAMEBUFFER, 3);
    context.framebuffer_texture(FRAMEBUFFER, COLOR, 0x0DE1, name, 0, 0);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), COMPLETE);
    context.clear_color([0.0, 0.0, 1.0, 1.0]);
    context.clear(gl::COLOR_BUFFER_BIT);
    context.color([1.0, 1.0, 0.0, 1.0]);
    draw(&mut context, gl::TRIANGLES, &[[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.0, 8.0, 0.0]]);
    let drawn = read(&mut context, 8, 8);
    context.bind_framebuffer(FRAMEBUFFER, 0);
    context.enable(0x0DE1);
    context.color([1.0; 4]);
    context.begin(gl::QUADS);
    for [x, y] in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        context.tex_coord(0x84C0, [x, y, 0.0, 1.0]);
        context.vertex([8.0 * x, 8.0 * y, 0.0, 1.0]);
    }
    context.end();
    assert_eq!(pixels(&mut context), drawn);
    assert!(drawn.contains(&[255, 255, 0, 255]) && drawn.contains(&[0, 0, 255, 255]));
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn ext_framebuffer_object_depth_textures_need_no_colour() {
    let mut context = canvas(8, 8);
    let name = texture(&mut context, DEPTH24 as i32, gl::DEPTH_COMPONENT);
    context.bind_framebuffer(FRAMEBUFFER, 3);
    context.framebuffer_texture(FRAMEBUFFER, DEPTH, 0x0DE1, name, 0, 0);
    context.draw_buffer(0);
    context.read_buffer(0);
    context.bind_framebuffer(FRAMEBUFFER, 0);
    context.bind_framebuffer(FRAMEBUFFER, 3);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), COMPLETE);
    context.enable(gl::DEPTH_TEST);
    context.clear(gl::DEPTH_BUFFER_BIT);
    draw(&mut context, gl::TRIANGLES, &[[0.0, 0.0, 0.5], [8.0, 0.0, 0.5], [0.0, 8.0, 0.5]]);
    let depths = crate::canvas::depths(&mut context);
    assert!((depths[0] - 0.25).abs() < 1e-6 && depths[63] == 1.0);
    context.bind_framebuffer(FRAMEBUFFER, 0);
    let mut bytes = vec![0; 256];
    context.get_tex_image(0x0DE1, 0, gl::DEPTH_COMPONENT, gl::FLOAT, &mut bytes);
    let kept: Vec<f32> = bytes.as_chunks().0.iter().map(|b| f32::from_ne_bytes(*b)).collect();
    assert_eq!(kept, depths);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn colours_without_alphas_are_read_and_blended_as_if_these_were_1() {
    const DST_ALPHA: u32 = 0x0304;
    const ONE_MINUS_DST_ALPHA: u32 = 0x0305;
    const RGB8: u32 = 0x8051;
    const ALPHA_SIZE: u32 = 0x8d53;
    let blended = |context: &mut Context| {
        context.clear_color([0.0; 4]);
        context.clear(gl::COLOR_BUFFER_BIT);
        context.enable(gl::BLEND);
        context.blend_func(DST_ALPHA, ONE_MINUS_DST_ALPHA);
        context.color([0.2, 0.6, 1.0, 0.4]);
        draw(context, gl::TRIANGLES, &WHOLE);
        read(context, 1, 1)[0]
    };
    for (format, alpha_bits, expected) in [(RGBA8, 8, [0, 0, 0, 0]), (RGB8, 0, [51, 153, 255, 255])]
    {
        let mut context = canvas(8, 8);
        with_renderbuffers(&mut context, 8, 8);
        let name = context.gen_renderbuffers(1)[0];
        context.bind_renderbuffer(RENDERBUFFER, name);
        context.renderbuffer_storage(RENDERBUFFER, 0, format, 8, 8);
        context.framebuffer_renderbuffer(FRAMEBUFFER, COLOR, RENDERBUFFER, name);
        let size = context.get_renderbuffer_parameter(RENDERBUFFER, ALPHA_SIZE).unwrap();
        assert_eq!(size.to_i32(0), alpha_bits);
        assert_eq!(context.get(0x0d55).unwrap().to_i32(0), alpha_bits);
        assert_eq!(blended(&mut context), expected, "{format:#x}");
    }
    let mut context = Context::new(luxel_gl::Configuration { alpha: false, ..Default::default() });
    context.resize_default(8, 8);
    assert_eq!(blended(&mut context), [51, 153, 255, 255]);
}
