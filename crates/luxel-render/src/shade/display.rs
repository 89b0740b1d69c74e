//! Exposure and tone curve of what samples see: between fog and the mean of the samples.

use luxel_lighting::Display;
use luxel_math::{Lanes, Rgb};

/// Colours of surfaces as the picture shows them; alpha stays.
///
/// Outlined: one copy per lane type, for every kernel that shades. Cold: pictures without either aren't to
/// notice.
#[cold]
#[inline(never)]
pub(crate) fn displayed<N: Lanes>(display: &Display, color: &[N; 4]) -> [N; 4] {
    let [r, g, b, alpha] = *color;
    r.vectorized(
        #[inline(always)]
        || {
            let shown = display.shown(Rgb::new(r, g, b));
            [shown.r, shown.g, shown.b, alpha]
        },
    )
}
