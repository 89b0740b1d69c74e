//! Reports for readers: the ledger of a pixel as text, JSON, LaTeX and
//! HTML, and the answers of picks as text and JSON.
//!
//! [`Report`] writes an [`Explanation`](luxel_render::Explanation), the light of one pixel term by
//! term. All formats give the same terms:
//!
//! ```
//! use luxel_render::{At, Execution, Renderer};
//! # use luxel_render::{Cull, EnvironmentChoice, Shading, View};
//! # use luxel_lighting::PictureEncoding;
//! # use luxel_scene::{DEFAULT_AMBIENT, DVec3, Lens, Scene, Size, Viewpoint, default_lights, demos,
//! fit_view};
//! # fn default_view(scene: &Scene, size: Size) -> View {
//! #     let viewpoint = Viewpoint { up: DVec3::Y, azimuth_radians: 0.5, elevation_radians: 0.3 };
//! #     View::new(size, fit_view(scene, &viewpoint, Lens::Perspective { fov_y_radians: 0.8 },
//! size)).with_samples(4).with_cull(Cull::Auto).with_lights(default_lights()).with_ambient(DEFAULT_AMBIENT).with_environment(EnvironmentChoice::StudioForMicrofacets).with_fog(None).with_background([0.0;
//! 4]).with_encoding(PictureEncoding::Srgb).with_edges(None).with_shading(Shading::default())
//! # }
//! use luxel_report::Report;
//! use std::sync::Arc;
//!
//! let scene = Arc::new(demos::demo("teapot").ok_or("no such demo")?);
//! let view = default_view(&scene, Size { width: 96, height: 54 });
//! let renderer = Renderer::new(Arc::clone(&scene), &Execution::default())?;
//! let explanation = renderer.explain(&view, At::Pixel([48, 30]))?;
//!
//! let report = Report::new(&explanation, &scene, &view).with_model("the teapot");
//! assert!(report.to_text().contains("N.L = "));
//! assert_eq!(report.to_json()["pixel"], serde_json::json!([48, 30]));
//! assert!(report.to_latex().contains("\\begin{align*}"));
//! assert!(report.to_html().starts_with("<!doctype html>"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`Report::with_unseen`] adds the surfaces that the pixel doesn't show, [`Report::with_pictures`]
//! the picture around it. [`ledger_lines`] gives the equation line by line, for panels,
//! [`ledger_vectors`] its vectors, for drawings, [`term_sums`] the light by kind of term.
//! [`PickReport`] and [`RegionReport`] write the results of a [`PickView`](luxel_pick::PickView).
//!
//! # Symbols
//!
//! [`meanings_in`] explains the symbols in a text:
//!
//! | symbol | meaning |
//! | --- | --- |
//! | N, L, V, R, H | unit vectors in world space: the normal, to the light, to the eye, L mirrored
//! at N, halfway between L and V |
//! | I_a, I_d, I_s | ambient, diffuse and specular intensity of a light, linear red, green, blue |
//! | k_a, k_d, k_s | the material's constants of reflection |
//! | O_a, O_d, O_s, O_e | the material's ambient, diffuse, specular and emitted colour |
//! | n | the material's shininess |
//! | f | attenuation by distance times the cone of a spot light |
//! | I, I' | the sum of all terms, before and after fog |
//! | T, EV | the tone curve, and the exposure in stops: what is shown is T(2^EV I) |

#![forbid(unsafe_code)]

mod equation;
mod pick;
mod pixel;
mod words;

pub use equation::{TermKind, meanings_in};
pub use pick::{PickReport, RegionReport, camera_to_json};
pub use pixel::{
    Hint, LedgerFactor, LedgerLine, LedgerVector, Pictures, PicturesError, Report, VectorKind,
    display_to_json, ledger_lines, ledger_vectors, luminance, term_sums,
};
pub use words::{number, printable};
