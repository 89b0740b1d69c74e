//! Which colours a framebuffer object has: their components, which of several is drawn to, and what queries say
//! (ARB_framebuffer_object).

use crate::canvas::{canvas, draw, gl, pixels};
use luxel_gl::Context;

const FRAMEBUFFER: u32 = 0x8D40;
const READ: u32 = 0x8CA8;
const RENDERBUFFER: u32 = 0x8D41;
const COLOR: u32 = 0x8CE0;
const DEPTH: u32 = 0x8D00;
const STENCIL: u32 = 0x8D20;
const DEPTH_STENCIL: u32 = 0x821A;
const COMPLETE: u32 = 0x8CD5;
const INCOMPLETE_ATTACHMENT: u32 = 0x8CD6;
const OBJECT_TYPE: u32 = 0x8CD0;
const OBJECT_NAME: u32 = 0x8CD1;
const COMPONENT_TYPE: u32 = 0x8211;
const RED_SIZE: u32 = 0x8212;
const ALPHA: u32 = 0x1906;
const LUMINANCE: u32 = 0x1909;
const LUMINANCE_ALPHA: u32 = 0x190A;
const INTENSITY: u32 = 0x8049;
const RGB: u32 = 0x1907;

fn object(context: &mut Context) -> u32 {
    let [framebuffer] = context.gen_framebuffers(1).try_into().unwrap();
    context.bind_framebuffer(FRAMEBUFFER, framebuffer);
    framebuffer
}

/// Attaches a renderbuffer of 2x2 pixels.
fn attach(context: &mut Context, attachment: u32, format: u32) -> u32 {
    let [name] = context.gen_renderbuffers(1).try_into().unwrap();
    context.bind_renderbuffer(RENDERBUFFER, name);
    context.renderbuffer_storage(RENDERBUFFER, 0, format, 2, 2);
    context.framebuffer_renderbuffer(FRAMEBUFFER, attachment, RENDERBUFFER, name);
    name
}

fn first_pixel(context: &mut Context) -> [u8; 4] {
    let mut bytes = [0; 16];
    context.read_pixels(0, 0, 2, 2, gl::RGBA, gl::UNSIGNED_BYTE, &mut bytes);
    bytes[..4].try_into().unwrap()
}

/// Blends the alpha that is there with a colour.
fn by_destination_alpha(context: &mut Context, color: [f32; 4]) {
    context.enable(gl::BLEND);
    context.blend_func(0x0304, 0);
    context.color(color);
    draw(context, gl::TRIANGLES, &[[-9.0, -9.0, 0.0], [9.0, -9.0, 0.0], [0.0, 9.0, 0.0]]);
    context.disable(gl::BLEND);
}

#[test]
fn table_3_15_colours_have_the_components_of_their_format_and_read_as_those() {
    // After a clear with 0.2, 0.4, 0.6, 0.8, and after white is blended by the alpha that is there.
    let expected = [
        (gl::RGBA, [51, 102, 153, 204], [204; 4]),
        (RGB, [51, 102, 153, 255], [255; 4]),
        (ALPHA, [0, 0, 0, 204], [0, 0, 0, 204]),
        (LUMINANCE, [51, 0, 0, 255], [255, 0, 0, 255]),
        (LUMINANCE_ALPHA, [51, 0, 0, 204], [204, 0, 0, 204]),
        (INTENSITY, [51, 0, 0, 255], [51, 0, 0, 255]),
    ];
    for (format, cleared, blended) in expected {
        let mut context = canvas(2, 2);
        object(&mut context);
        attach(&mut context, COLOR, format);
        assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), COMPLETE, "{format:#x}");
        context.clear_color([0.2, 0.4, 0.6, 0.8]);
        context.clear(gl::COLOR_BUFFER_BIT);
        assert_eq!(first_pixel(&mut context), cleared, "{format:#x}");
        by_destination_alpha(&mut context, [1.0; 4]);
        assert_eq!(first_pixel(&mut context), blended, "{format:#x}");
        let bits: Vec<i32> =
            (0x0D52..=0x0D55).map(|name| context.get(name).unwrap().to_i32(0)).collect();
        let expected: Vec<i32> = (RED_SIZE..RED_SIZE + 4)
            .map(|pname| {
                let found = context.get_framebuffer_attachment_parameter(FRAMEBUFFER, COLOR, pname);
                found.unwrap().to_i32(0)
            })
            .collect();
        assert_eq!(bits, expected, "{format:#x}");
        assert_eq!(context.get_error(), gl::NO_ERROR);
    }
}

#[test]
fn ext_framebuffer_blit_leaves_components_out_that_the_target_lacks() {
    let mut context = canvas(2, 2);
    let from = object(&mut context);
    attach(&mut context, COLOR, RGB);
    context.clear_color([0.2, 0.4, 0.6, 0.0]);
    context.clear(gl::COLOR_BUFFER_BIT);
    for (format, expected) in [(LUMINANCE, [51, 0, 0, 255]), (gl::RGBA, [51, 102, 153, 255])] {
        let to = object(&mut context);
        attach(&mut context, COLOR, format);
        context.bind_framebuffer(READ, from);
        context.blit_framebuffer([0, 0, 2, 2], [0, 0, 2, 2], gl::COLOR_BUFFER_BIT, 0x2600);
        context.bind_framebuffer(READ, to);
        assert_eq!(first_pixel(&mut context), expected);
        assert_eq!(context.get_error(), gl::NO_ERROR);
    }
}

#[test]
fn ext_framebuffer_object_draws_to_the_colour_and_reads_the_one_that_is_named() {
    let mut context = canvas(2, 2);
    let several = object(&mut context);
    attach(&mut context, COLOR, gl::RGBA);
    attach(&mut context, COLOR + 3, gl::RGBA);
    assert_eq!(context.get(0x8CDF).unwrap().to_i32(0), 8);
    let fill = |context: &mut Context, buffer: u32, red: f32| {
        context.draw_buffer(buffer);
        context.clear_color([red, 0.0, 0.0, 1.0]);
        context.clear(gl::COLOR_BUFFER_BIT);
    };
    let red_of = |context: &mut Context, buffer: u32| {
        context.read_buffer(buffer);
        first_pixel(context)[0]
    };
    fill(&mut context, COLOR, 0.2);
    fill(&mut context, COLOR + 3, 0.4);
    assert_eq!([COLOR, COLOR + 3].map(|buffer| red_of(&mut context, buffer)), [51, 102]);
    // What is drawn to isn't what is read, and stays so.
    context.read_buffer(COLOR);
    fill(&mut context, COLOR + 3, 0.6);
    assert_eq!(first_pixel(&mut context)[0], 51);
    // The buffers belong to the object, also where it is bound for reading alone.
    context.bind_framebuffer(FRAMEBUFFER, 0);
    context.bind_framebuffer(READ, several);
    assert_eq!(context.get(0x0C02).unwrap().to_i32(0), COLOR as i32);
    assert_eq!(red_of(&mut context, COLOR + 3), 153);
    context.copy_pixels([0, 0], [2, 2], 0x1800);
    context.bind_framebuffer(READ, 0);
    assert_eq!(pixels(&mut context)[0][0], 153);
    // An attribute that is restored is drawn to.
    context.bind_framebuffer(FRAMEBUFFER, several);
    context.draw_buffer(COLOR);
    context.push_attrib(gl::COLOR_BUFFER_BIT);
    context.draw_buffer(COLOR + 3);
    context.pop_attrib();
    context.clear(gl::COLOR_BUFFER_BIT);
    assert_eq!(red_of(&mut context, COLOR), 153);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    context.draw_buffer(COLOR + 8);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
}

#[test]
fn section_6_1_3_what_is_attached_can_be_asked_for() {
    let mut context = canvas(2, 2);
    let ask = |context: &mut Context, attachment: u32, pname: u32| {
        let found = context.get_framebuffer_attachment_parameter(FRAMEBUFFER, attachment, pname);
        found.map(|values| values.to_i32(0)).ok_or_else(|| context.get_error())
    };
    // The default framebuffer.
    assert_eq!(ask(&mut context, 0x0402, OBJECT_TYPE), Ok(0x8218));
    assert_eq!(ask(&mut context, 0x1801, RED_SIZE + 4), Ok(24));
    assert_eq!(ask(&mut context, 0x0402, OBJECT_NAME), Err(gl::INVALID_ENUM));
    assert_eq!(ask(&mut context, COLOR, OBJECT_TYPE), Err(gl::INVALID_ENUM));
    object(&mut context);
    let depths = attach(&mut context, DEPTH, 0x8CAC);
    assert_eq!(ask(&mut context, DEPTH, OBJECT_TYPE), Ok(RENDERBUFFER as i32));
    assert_eq!(ask(&mut context, DEPTH, OBJECT_NAME), Ok(depths as i32));
    assert_eq!(ask(&mut context, DEPTH, COMPONENT_TYPE), Ok(gl::FLOAT as i32));
    assert_eq!(ask(&mut context, DEPTH, RED_SIZE + 4), Ok(32));
    assert_eq!(ask(&mut context, DEPTH, 0x8CD2), Err(gl::INVALID_ENUM));
    // Nothing has no name and no bits.
    assert_eq!(ask(&mut context, STENCIL, OBJECT_TYPE), Ok(0));
    assert_eq!(ask(&mut context, STENCIL, OBJECT_NAME), Ok(0));
    assert_eq!(ask(&mut context, STENCIL, RED_SIZE + 5), Err(gl::INVALID_OPERATION));
    assert_eq!(ask(&mut context, DEPTH_STENCIL, OBJECT_TYPE), Err(gl::INVALID_OPERATION));
    attach(&mut context, DEPTH_STENCIL, 0x88F0);
    assert_eq!(ask(&mut context, DEPTH_STENCIL, OBJECT_TYPE), Ok(RENDERBUFFER as i32));
    assert_eq!(ask(&mut context, STENCIL, COMPONENT_TYPE), Ok(0x8222));
    // The framebuffer has no colours to read.
    let mut bytes = [0; 4];
    context.read_pixels(0, 0, 1, 1, gl::RGBA, gl::UNSIGNED_BYTE, &mut bytes);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
}

#[test]
fn ext_framebuffer_object_is_incomplete_with_a_slice_that_a_volume_has_not() {
    let mut context = canvas(2, 2);
    object(&mut context);
    context.bind_texture(0x806F, 1);
    context.tex_image_3d(0x806F, 0, 4, [2, 2, 2], 0, gl::RGBA, gl::UNSIGNED_BYTE, None);
    for (layer, status) in [(1, COMPLETE), (2, INCOMPLETE_ATTACHMENT), (0, COMPLETE)] {
        context.framebuffer_texture(FRAMEBUFFER, COLOR, 0x806F, 1, 0, layer);
        assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), status, "{layer}");
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
}
