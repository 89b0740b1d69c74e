//! A picture, and what drawing it took.

use crate::context::ShadingContext;
use luxel_lighting::PictureEncoding;
use luxel_scene::Size;
use luxel_view::ShadingMode;
use std::time::Duration;

/// A picture with what making it took.
#[derive(Clone, Debug)]
pub struct Picture<T> {
    /// Its size.
    pub size: Size,
    /// Pixels, row by row from the top.
    pub pixels: Vec<T>,
    /// How light becomes bytes, as the view had it.
    pub encoding: PictureEncoding,
    /// Culling and binning; then, added up over threads, finding what is visible, and lighting it.
    pub stages: Stages,
    /// What was divided, if the shading mode divides.
    pub subdivision: Option<Subdivision>,
}

/// What [`ShadingMode::Subdivided`](crate::ShadingMode::Subdivided) came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Subdivision {
    /// The small triangles into which those that are seen were divided.
    pub triangles: u64,
    /// The largest difference between the interpolated light and that of
    /// [`ShadingMode::Phong`](crate::ShadingMode::Phong) in
    /// steps of 8 bits: measured at places along the edges and inside of all pieces, so close
    /// together that no pixel goes without (but no triangle has more than a million of them), and
    /// three sevenths more for what lies between.
    pub largest_error: f32,
    /// The small triangles whose error is beyond the tolerance: where light jumps, as at the edge of
    /// a cone, division ends at parts of a pixel.
    pub beyond: u64,
    /// Their area in the picture, in pixels.
    pub beyond_pixels: f64,
}

impl Subdivision {
    /// What all triangles of a frame came to; `None` if its shading mode doesn't divide.
    pub(crate) fn of(scene: &ShadingContext<'_>) -> Option<Self> {
        let divides = matches!(scene.shading.mode, ShadingMode::Subdivided { .. });
        let counts = divides.then(|| scene.subdivided.counts())?;
        // Neither the sum nor the largest depends on the order.
        let areas = counts.iter().map(|one| one.beyond_area);
        let area = areas.fold(0, u64::saturating_add);
        let none = Self { beyond_pixels: area as f64 / 65_536.0, ..Self::default() };
        Some(counts.iter().fold(none, |all, one| Self {
            triangles: all.triangles + u64::from(one.pieces),
            largest_error: all.largest_error.max(one.error),
            beyond: all.beyond + u64::from(one.beyond),
            ..all
        }))
    }
}

impl<T> Default for Picture<T> {
    /// No pixels.
    fn default() -> Self {
        let size = Size { width: 0, height: 0 };
        Self {
            size,
            pixels: Vec::new(),
            encoding: PictureEncoding::default(),
            stages: Stages::default(),
            subdivision: None,
        }
    }
}

/// What the stages of a frame took, by the clock of [`Execution`](crate::Execution).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stages {
    /// Culling clusters and binning them to tiles.
    pub bin: Duration,
    /// Finding what each sample sees, added up over threads.
    pub visibility: Duration,
    /// Lighting it, added up over threads.
    pub shade: Duration,
    /// All of it, from start to end.
    pub frame: Duration,
}
