//! A software painter for egui: triangles with colours and textures, over the window's pixels.
//!
//! egui's shapes are triangle meshes with premultiplied colours in sRGB values, blended as such. Their
//! edges are antialiased by a fading fringe, so coverage is tested at pixel centres only, by the rule of
//! the renderer: coordinates in 1/256 pixel, top and left edges inside, so that neighbours never blend
//! a pixel twice. Text is aligned to pixels, one texel each.

use egui::epaint::{ImageData, Primitive, Vertex};
use egui::{ClippedPrimitive, Color32, TextureId, TexturesDelta};
use luxel::scene::Size;
use std::collections::HashMap;

/// The painter with its textures.
#[derive(Default)]
pub(crate) struct Painter {
    textures: HashMap<TextureId, Texture>,
}

#[derive(Default)]
struct Texture {
    size: [usize; 2],
    texels: Vec<Color32>,
}

/// Fixed-point steps of a pixel.
const STEPS: f32 = 256.0;
/// Triangles with larger coordinates are skipped: products stay within 64 bits.
const MAX_COORDINATE: f32 = 1e5;

impl Painter {
    /// Updates textures.
    pub(crate) fn update(&mut self, delta: &TexturesDelta) {
        for (id, change) in &delta.set {
            let ImageData::Color(image) = &change.image;
            let texture = self.textures.entry(*id).or_default();
            let [width, height] = image.size;
            let Some([left, top]) = change.pos else {
                *texture = Texture { size: image.size, texels: image.pixels.clone() };
                continue;
            };
            for y in 0..height {
                let start = (top + y) * texture.size[0] + left;
                if let Some(row) = texture.texels.get_mut(start..start + width) {
                    row.copy_from_slice(&image.pixels[y * width..][..width]);
                }
            }
        }
    }

    /// Frees unused textures.
    pub(crate) fn free(&mut self, delta: &TexturesDelta) {
        for id in &delta.free {
            self.textures.remove(id);
        }
    }

    /// Paints over 0RGB pixels.
    pub(crate) fn paint(
        &self,
        primitives: &[ClippedPrimitive],
        pixels_per_point: f32,
        size: Size,
        pixels: &mut [u32],
    ) {
        for ClippedPrimitive { clip_rect, primitive } in primitives {
            let Primitive::Mesh(mesh) = primitive else { continue };
            let Some(texture) = self.textures.get(&mesh.texture_id) else { continue };
            let limit = |value: f32, most: u32| {
                (value * pixels_per_point).round().clamp(0.0, most as f32) as i64
            };
            let clip = [
                limit(clip_rect.min.x, size.width),
                limit(clip_rect.min.y, size.height),
                limit(clip_rect.max.x, size.width),
                limit(clip_rect.max.y, size.height),
            ];
            let width = size.width as usize;
            let mut target = Target { pixels, width, clip, texture };
            for corners in mesh.indices.chunks_exact(3) {
                let corner = |at: usize| mesh.vertices.get(corners[at] as usize);
                if let (Some(a), Some(b), Some(c)) = (corner(0), corner(1), corner(2)) {
                    target.triangle([a, b, c], pixels_per_point);
                }
            }
        }
    }
}

/// The target of triangles.
struct Target<'a> {
    pixels: &'a mut [u32],
    width: usize,
    /// Left, top, right, bottom.
    clip: [i64; 4],
    texture: &'a Texture,
}

impl Target<'_> {
    fn triangle(&mut self, corners: [&Vertex; 3], pixels_per_point: f32) {
        let mut corners = corners;
        let place = |vertex: &Vertex| {
            let [x, y] = [vertex.pos.x, vertex.pos.y].map(|value| value * pixels_per_point);
            let is_near = x.abs() < MAX_COORDINATE && y.abs() < MAX_COORDINATE;
            is_near.then(|| [x, y].map(|value| (value * STEPS).round() as i64))
        };
        let [Some(a), Some(b), Some(c)] = corners.map(place) else { return };
        let mut places = [a, b, c];
        let double_area = |[a, b, c]: [[i64; 2]; 3]| {
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        };
        let mut area = double_area(places);
        if area == 0 {
            return;
        }
        if area < 0 {
            // Makes it clockwise in the window, y down.
            places.swap(1, 2);
            corners.swap(1, 2);
            area = -area;
        }
        let [left, top, right, bottom] = self.clip;
        let lowest = |axis: usize| places.iter().map(|place| place[axis]).fold(i64::MAX, i64::min);
        let highest = |axis: usize| places.iter().map(|place| place[axis]).fold(i64::MIN, i64::max);
        let (left, right) = (left.max(lowest(0) >> 8), right.min((highest(0) >> 8) + 1));
        let (top, bottom) = (top.max(lowest(1) >> 8), bottom.min((highest(1) >> 8) + 1));
        // The edge function opposite a corner, and its steps to the right and down.
        let edges = [0, 1, 2].map(|corner| {
            let [from, to] = [places[(corner + 1) % 3], places[(corner + 2) % 3]];
            let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
            let is_inside = dy < 0 || (dy == 0 && dx > 0);
            let bias = if is_inside { 0 } else { 1 };
            let at = |x: i64, y: i64| {
                let (x, y) = ((x << 8) + 128, (y << 8) + 128);
                dx * (y - from[1]) - dy * (x - from[0])
            };
            Edge { start: at(left, top), right: -dy * 256, down: dx * 256, bias }
        });
        let paint = Paint::new(corners, area, self.texture);
        for y in top..bottom {
            let down = y - top;
            let (mut first, mut end) = (0, right - left);
            for edge in &edges {
                (first, end) = edge.inside(down, first, end);
            }
            if first >= end {
                continue;
            }
            let start = y as usize * self.width + (left + first) as usize;
            let Some(row) = self.pixels.get_mut(start..start + (end - first) as usize) else {
                continue;
            };
            let values = edges.map(|edge| edge.start + edge.down * down + edge.right * first);
            let steps = edges.map(|edge| edge.right);
            paint.row(row, values, steps);
        }
    }
}

/// An edge function: 0 on the edge, positive inside.
#[derive(Clone, Copy)]
struct Edge {
    start: i64,
    right: i64,
    down: i64,
    /// The least value inside.
    bias: i64,
}

impl Edge {
    /// The part of a run of pixels, so many rows down, that is inside: from `first` up to `end`.
    fn inside(&self, down: i64, first: i64, end: i64) -> (i64, i64) {
        let value = self.start + self.down * down - self.bias;
        match self.right {
            0 if value < 0 => (first, first),
            0 => (first, end),
            right if right > 0 => (first.max(-value.div_euclid(right)), end),
            right => (first, end.min(value.div_euclid(-right) + 1)),
        }
    }
}

/// The colour of a triangle: flat, or interpolated.
enum Paint<'a> {
    Flat(Color32),
    Interpolated { corners: [&'a Vertex; 3], by_area: f32, texture: &'a Texture },
}

impl<'a> Paint<'a> {
    fn new(corners: [&'a Vertex; 3], area: i64, texture: &'a Texture) -> Self {
        let [a, b, c] = corners;
        let is_flat = a.color == b.color && b.color == c.color && a.uv == b.uv && b.uv == c.uv;
        if is_flat {
            return Self::Flat(multiply(a.color, texture.at([a.uv.x, a.uv.y])));
        }
        Self::Interpolated { corners, by_area: 1.0 / area as f32, texture }
    }

    /// Blends a run of pixels; the edge functions have `values` at the first, and change by `steps` from each to the
    /// next.
    fn row(&self, pixels: &mut [u32], mut values: [i64; 3], steps: [i64; 3]) {
        match self {
            Self::Flat(color) if color.is_opaque() => pixels.fill(blend(*color, 0)),
            Self::Flat(color) => {
                for pixel in pixels {
                    *pixel = blend(*color, *pixel);
                }
            }
            Self::Interpolated { corners, by_area, texture } => {
                for pixel in pixels {
                    let [a, b, c] = values;
                    let weights = [a as f32 * by_area, b as f32 * by_area, c as f32 * by_area];
                    *pixel = blend(interpolated(corners, weights, texture), *pixel);
                    values = [a + steps[0], b + steps[1], c + steps[2]];
                }
            }
        }
    }
}

/// The colour at barycentric coordinates.
fn interpolated([a, b, c]: &[&Vertex; 3], weights: [f32; 3], texture: &Texture) -> Color32 {
    let mix = |[a, b, c]: [f32; 3]| a * weights[0] + b * weights[1] + c * weights[2];
    let channel = |[a, b, c]: [u8; 3]| {
        let sum = mix([f32::from(a), f32::from(b), f32::from(c)]);
        (sum + 0.5) as u8
    };
    let [of_a, of_b, of_c] = [a.color.to_array(), b.color.to_array(), c.color.to_array()];
    let color = Color32::from_rgba_premultiplied(
        channel([of_a[0], of_b[0], of_c[0]]),
        channel([of_a[1], of_b[1], of_c[1]]),
        channel([of_a[2], of_b[2], of_c[2]]),
        channel([of_a[3], of_b[3], of_c[3]]),
    );
    let uv = [mix([a.uv.x, b.uv.x, c.uv.x]), mix([a.uv.y, b.uv.y, c.uv.y])];
    multiply(color, texture.at(uv))
}

impl Texture {
    /// The nearest texel at texture coordinates from 0 to 1.
    fn at(&self, uv: [f32; 2]) -> Color32 {
        let texel = |axis: usize| {
            let size = self.size[axis];
            ((uv[axis] * size as f32).max(0.0) as usize).min(size.saturating_sub(1))
        };
        self.texels.get(texel(1) * self.size[0] + texel(0)).copied().unwrap_or(Color32::WHITE)
    }
}

fn multiply(a: Color32, b: Color32) -> Color32 {
    if b == Color32::WHITE {
        return a;
    }
    let (a, b) = (a.to_array(), b.to_array());
    let channel = |at: usize| ((u32::from(a[at]) * u32::from(b[at]) + 127) / 255) as u8;
    Color32::from_rgba_premultiplied(channel(0), channel(1), channel(2), channel(3))
}

fn blend(color: Color32, below: u32) -> u32 {
    let [r, g, b, alpha] = color.to_array();
    let through = 255 - u32::from(alpha);
    let channel = |color: u8, shift: u32| {
        let sum = u32::from(color) + ((below >> shift & 255) * through + 127) / 255;
        sum.min(255) << shift
    };
    channel(r, 16) | channel(g, 8) | channel(b, 0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::epaint::Mesh;
    use egui::{Pos2, Rect, pos2, vec2};

    const SIZE: Size = Size { width: 16, height: 12 };

    fn painted(mesh: Mesh, clip_rect: Rect) -> Vec<u32> {
        let mut painter = Painter::default();
        let white = Texture { size: [1, 1], texels: vec![Color32::WHITE] };
        painter.textures.insert(TextureId::default(), white);
        let mut pixels = vec![0; 16 * 12];
        let primitives = [ClippedPrimitive { clip_rect, primitive: Primitive::Mesh(mesh) }];
        painter.paint(&primitives, 1.0, SIZE, &mut pixels);
        pixels
    }

    #[test]
    fn neighbours_never_blend_a_pixel_twice() {
        // A fan of translucent triangles around a point: each pixel is covered once.
        let mut mesh = Mesh::default();
        let half = Color32::from_rgba_premultiplied(100, 100, 100, 128);
        let rim: Vec<Pos2> = vec![
            pos2(0.0, 0.0),
            pos2(16.0, 0.0),
            pos2(16.0, 12.0),
            pos2(3.3, 12.0),
            pos2(0.0, 12.0),
        ];
        mesh.colored_vertex(pos2(7.3, 5.1), half);
        for &place in &rim {
            mesh.colored_vertex(place, half);
        }
        for at in 0..rim.len() as u32 {
            mesh.add_triangle(0, 1 + at, 1 + (at + 1) % rim.len() as u32);
        }
        let pixels = painted(mesh, Rect::from_min_size(Pos2::ZERO, vec2(16.0, 12.0)));
        assert!(pixels.iter().all(|&pixel| pixel == 0x64_6464), "{pixels:x?}");
    }

    #[test]
    fn nothing_is_painted_outside_the_clip_and_the_window() {
        let mut mesh = Mesh::default();
        mesh.add_colored_rect(
            Rect::from_min_max(pos2(-1e4, -50.0), pos2(1e4, 9e9)),
            Color32::from_rgb(1, 2, 3),
        );
        mesh.add_colored_rect(
            Rect::from_min_max(pos2(-20.0, -50.0), pos2(60.0, 99.0)),
            Color32::from_rgb(9, 8, 7),
        );
        let pixels = painted(mesh, Rect::from_min_max(pos2(2.0, 3.0), pos2(5.0, 40.0)));
        for (at, &pixel) in pixels.iter().enumerate() {
            let (x, y) = (at % 16, at / 16);
            let inside = (2..5).contains(&x) && y >= 3;
            assert_eq!(pixel == 0x09_0807, inside, "{x} {y}");
        }
    }

    #[test]
    fn colours_are_interpolated() {
        let mut mesh = Mesh::default();
        let gray = |value: u8| Color32::from_rgb(value, value, value);
        mesh.colored_vertex(pos2(0.0, 0.0), gray(0));
        mesh.colored_vertex(pos2(16.0, 0.0), gray(160));
        mesh.colored_vertex(pos2(16.0, 12.0), gray(160));
        mesh.colored_vertex(pos2(0.0, 12.0), gray(0));
        mesh.add_triangle(0, 1, 2);
        mesh.add_triangle(0, 2, 3);
        let pixels = painted(mesh, Rect::EVERYTHING);
        for x in 0..16_usize {
            let found = pixels[5 * 16 + x] & 255;
            assert!(found.abs_diff(10 * x as u32 + 5) <= 1, "{x}: {found}");
        }
    }
}
