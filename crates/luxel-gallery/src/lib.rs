//! The gallery: shading errors, each beside its cure with both errors measured, and plots of light
//! and reflection.
//!
//! [`Gallery::make`] draws images (PNG, one of them animated), plots (SVG) and an HTML page that
//! explains them, all with luxel's renderer and lighting equation; the text of the page depends on
//! the measurements. The bytes are the same on every machine.

#![forbid(unsafe_code)]

mod chapter;
mod compare;
mod error;
mod file;
mod lab;
mod page;
mod picture;
mod plots;
mod shot;
mod svg;

pub use chapter::Pair;
pub use compare::Error;
pub use error::GalleryError;
pub use file::{File, Reproduced};

use chapter::Chapter;
use luxel::render::Execution;
use shot::Studio;

/// Images, plots, and the page that explains them.
#[derive(Clone, Debug)]
pub struct Gallery {
    /// All files: `index.html` first, then its images, in the order of the page.
    pub files: Vec<File>,
    /// Every problem with its cure.
    pub pairs: Vec<Pair>,
    /// The images that a command line reproduces.
    pub reproduced: Vec<Reproduced>,
}

/// Builds a chapter.
type Make = fn(&Studio) -> Result<Chapter, GalleryError>;

const CHAPTERS: [Make; 17] = [
    lab::silhouette::chapter,
    lab::perspective::chapter,
    lab::rolling::chapter,
    lab::seam::chapter,
    lab::normals::missed_geometry,
    lab::normals::missed_highlight,
    lab::chalk::chapter,
    lab::unnormalised::chapter,
    lab::mach::chapter,
    lab::shadow::chapter,
    plots::beam::chapter,
    plots::falloff::chapter,
    plots::spheres::phases,
    plots::lobes::chapter,
    plots::spheres::table,
    plots::microsurface::profile,
    plots::microsurface::lobe,
];

impl Gallery {
    /// Into how many steps the work falls.
    pub const STEPS: usize = CHAPTERS.len();

    /// Makes all of it; `step` is called after each of [`Gallery::STEPS`].
    ///
    /// # Errors
    /// [`GalleryError`] if the machine doesn't support `execution`.
    pub fn make(execution: &Execution, mut step: impl FnMut()) -> Result<Self, GalleryError> {
        let studio = Studio { execution: *execution };
        let mut chapters = Vec::with_capacity(CHAPTERS.len());
        for make in CHAPTERS {
            chapters.push(make(&studio)?);
            step();
        }
        let page = page::page(&chapters);
        let mut gallery = Self {
            files: vec![File { name: "index.html".into(), bytes: page.into_bytes() }],
            pairs: Vec::new(),
            reproduced: Vec::new(),
        };
        for chapter in chapters {
            gallery.files.extend(chapter.files);
            gallery.pairs.extend(chapter.pairs);
            gallery.reproduced.extend(chapter.reproduced);
        }
        Ok(gallery)
    }
}
