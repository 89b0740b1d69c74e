//! The buffer of feedback mode (OpenGL 2.1, section 5.3): tokens, and values of vertices.

use luxel_scene::Size;

/// A corner in the window, lit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeedbackVertex {
    /// Pixels from the window's left.
    pub x: f64,
    /// Pixels from the window's top, or from its bottom: as the buffer is [made](FeedbackBuffer::from_bottom).
    pub y: f64,
    /// Window depth, 0 near to 1 far.
    pub depth: f64,
    /// The fourth clip coordinate: the distance along the viewing axis; 1 for parallel rays.
    pub w: f64,
    /// Linear red, green, blue, clamped to 0..1 unless the view says otherwise, and alpha.
    pub color: [f32; 4],
    /// Texture coordinates s, t, r, q of the first set; (0, 0, 0, 1) where there are none.
    pub texture: [f32; 4],
}

/// One item of the stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Feedback<'a> {
    /// A marker (`glPassThrough`). Feedback of a scene has one before the primitives of each object: its number.
    PassThrough(f32),
    /// A point.
    Point(&'a FeedbackVertex),
    /// A line by itself, which begins a stipple pattern anew.
    Line(&'a [FeedbackVertex; 2]),
    /// A line that continues the last one's stipple pattern, as the later ones of a strip.
    ContinuedLine(&'a [FeedbackVertex; 2]),
    /// Where a bitmap would be drawn (`glBitmap`).
    Bitmap(&'a FeedbackVertex),
    /// Where pixels would be drawn (`glDrawPixels`).
    DrawPixels(&'a FeedbackVertex),
    /// Where pixels would be copied to (`glCopyPixels`).
    CopyPixels(&'a FeedbackVertex),
    /// A convex polygon: what clipping left of a triangle, in the order of its corners.
    Polygon(&'a [FeedbackVertex]),
}

/// What a feedback buffer holds of each corner: the `type` of `glFeedbackBuffer`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedbackType {
    /// `GL_2D`: x, y.
    TwoD,
    /// `GL_3D`: x, y, z.
    ThreeD,
    /// `GL_3D_COLOR`: x, y, z, and red, green, blue, alpha.
    ThreeDColor,
    /// `GL_3D_COLOR_TEXTURE`: these, and s, t, r, q.
    ThreeDColorTexture,
    /// `GL_4D_COLOR_TEXTURE`: x, y, z, w, red, green, blue, alpha, s, t, r, q.
    FourDColorTexture,
}

/// A buffer as `glFeedbackBuffer` fills it: tokens and values as `f32`, y from the window's bottom.
///
/// A polygon is the token 1795, the number of its corners, and the corners. Lines that stand by
/// themselves have the token 1799 (`GL_LINE_RESET_TOKEN`).
///
/// ```
/// use luxel_pick::{Feedback, FeedbackBuffer, FeedbackType, FeedbackVertex};
/// use luxel_scene::Size;
///
/// let vertex =
///     FeedbackVertex { x: 3.0, y: 2.0, depth: 0.5, w: 1.0, color: [1.0; 4], texture: [0.0; 4] };
/// let size = Size { width: 10, height: 10 };
/// let mut buffer = FeedbackBuffer::new(FeedbackType::ThreeD, 100, size);
/// buffer.put(&Feedback::PassThrough(7.0));
/// buffer.put(&Feedback::Point(&vertex));
/// assert_eq!(buffer.values(), [1792.0, 7.0, 1793.0, 3.0, 8.0, 0.5]);
/// assert_eq!(buffer.count(), 6);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FeedbackBuffer {
    of: FeedbackType,
    room: usize,
    /// The window's height, where vertices are given from its top.
    height: Option<f64>,
    values: Vec<f32>,
    overflowed: bool,
}

impl FeedbackBuffer {
    /// `GL_PASS_THROUGH_TOKEN`
    pub const PASS_THROUGH_TOKEN: f32 = 1792.0;
    /// `GL_POINT_TOKEN`
    pub const POINT_TOKEN: f32 = 1793.0;
    /// `GL_LINE_TOKEN`
    pub const LINE_TOKEN: f32 = 1794.0;
    /// `GL_POLYGON_TOKEN`
    pub const POLYGON_TOKEN: f32 = 1795.0;
    /// `GL_BITMAP_TOKEN`
    pub const BITMAP_TOKEN: f32 = 1796.0;
    /// `GL_DRAW_PIXEL_TOKEN`
    pub const DRAW_PIXEL_TOKEN: f32 = 1797.0;
    /// `GL_COPY_PIXEL_TOKEN`
    pub const COPY_PIXEL_TOKEN: f32 = 1798.0;
    /// `GL_LINE_RESET_TOKEN`
    pub const LINE_RESET_TOKEN: f32 = 1799.0;

    /// An empty buffer with room for `room` values, about a window of this size.
    #[must_use]
    pub fn new(of: FeedbackType, room: usize, window: Size) -> Self {
        let height = Some(f64::from(window.height));
        Self { of, room, height, values: Vec::new(), overflowed: false }
    }

    /// An empty buffer with room for `room` values, whose vertices are given from the window's bottom already.
    #[must_use]
    pub fn from_bottom(of: FeedbackType, room: usize) -> Self {
        Self { of, room, height: None, values: Vec::new(), overflowed: false }
    }

    /// Appends an item; beyond the capacity it is dropped, and [`FeedbackBuffer::count`] is -1.
    pub fn put(&mut self, item: &Feedback<'_>) {
        match *item {
            Feedback::PassThrough(mark) => self.write(&[Self::PASS_THROUGH_TOKEN, mark]),
            Feedback::Point(vertex) => self.item(Self::POINT_TOKEN, std::slice::from_ref(vertex)),
            Feedback::Line(ends) => self.item(Self::LINE_RESET_TOKEN, ends),
            Feedback::ContinuedLine(ends) => self.item(Self::LINE_TOKEN, ends),
            Feedback::Bitmap(vertex) => self.item(Self::BITMAP_TOKEN, std::slice::from_ref(vertex)),
            Feedback::DrawPixels(vertex) => {
                self.item(Self::DRAW_PIXEL_TOKEN, std::slice::from_ref(vertex));
            }
            Feedback::CopyPixels(vertex) => {
                self.item(Self::COPY_PIXEL_TOKEN, std::slice::from_ref(vertex));
            }
            Feedback::Polygon(corners) => {
                self.write(&[Self::POLYGON_TOKEN, corners.len() as f32]);
                corners.iter().for_each(|corner| self.vertex(corner));
            }
        }
    }

    fn item(&mut self, token: f32, vertices: &[FeedbackVertex]) {
        self.write(&[token]);
        vertices.iter().for_each(|vertex| self.vertex(vertex));
    }

    fn vertex(&mut self, vertex: &FeedbackVertex) {
        let FeedbackVertex { x, y, depth, w, color, texture } = vertex;
        let y = self.height.map_or(*y, |height| height - y);
        let place = [*x, y, *depth, *w].map(|value| value as f32);
        match self.of {
            FeedbackType::TwoD => self.write(&place[..2]),
            FeedbackType::ThreeD => self.write(&place[..3]),
            FeedbackType::ThreeDColor => {
                self.write(&place[..3]);
                self.write(color);
            }
            FeedbackType::ThreeDColorTexture => {
                self.write(&place[..3]);
                self.write(color);
                self.write(texture);
            }
            FeedbackType::FourDColorTexture => {
                self.write(&place);
                self.write(color);
                self.write(texture);
            }
        }
    }

    fn write(&mut self, values: &[f32]) {
        let fits = values.len().min(self.room - self.values.len());
        self.values.extend_from_slice(&values[..fits]);
        self.overflowed |= fits < values.len();
    }

    /// Appends all that another buffer of the same type holds, which has at least as much room: as if it had been put
    /// here.
    pub fn append(&mut self, other: &Self) {
        self.write(&other.values);
        self.overflowed |= other.overflowed;
    }

    /// Forgets all items, but keeps the memory.
    pub fn clear(&mut self) {
        self.values.clear();
        self.overflowed = false;
    }

    /// For how many values there is memory.
    #[must_use]
    pub fn capacity(&self) -> usize {
        self.values.capacity()
    }

    /// The values that had room, without a copy.
    #[must_use]
    pub fn into_values(self) -> Vec<f32> {
        self.values
    }

    /// The values that had room.
    #[must_use]
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// How many values there are, or -1 if there was no room for all: what `glRenderMode` gives.
    #[must_use]
    pub fn count(&self) -> i64 {
        if self.overflowed { -1 } else { self.values.len() as i64 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_5_3_lines_of_a_strip_are_told_from_those_that_begin_a_stipple() {
        let vertex = FeedbackVertex {
            x: 3.0,
            y: 2.0,
            depth: 0.5,
            w: 1.0,
            color: [1.0; 4],
            texture: [0.0; 4],
        };
        let mut buffer = FeedbackBuffer::from_bottom(FeedbackType::TwoD, 12);
        buffer.put(&Feedback::Line(&[vertex; 2]));
        buffer.put(&Feedback::ContinuedLine(&[vertex; 2]));
        assert_eq!(buffer.values()[..5], [1799.0, 3.0, 2.0, 3.0, 2.0]);
        assert_eq!((buffer.values()[5], buffer.count()), (1794.0, 10));
        for (item, token) in [
            (Feedback::Bitmap(&vertex), 1796.0),
            (Feedback::DrawPixels(&vertex), 1797.0),
            (Feedback::CopyPixels(&vertex), 1798.0),
        ] {
            let mut buffer = FeedbackBuffer::from_bottom(FeedbackType::TwoD, 2);
            buffer.put(&item);
            assert_eq!((buffer.values(), buffer.count()), ([token, 3.0].as_slice(), -1));
        }
    }
}
