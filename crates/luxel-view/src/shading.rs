//! Shading mode and interpolation. Flags, scene files and the viewer use the names of the choices.

/// Names the variants of a choice: `VARIANT => NAME, HELP;`.
macro_rules! named {
    ($type:ident: $($variant:pat => $name:literal, $help:literal;)*) => {
        impl $type {
            /// The name, as flags and scene files have it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $($variant => $name,)*
                }
            }

            /// A few words of help.
            #[must_use]
            pub const fn help(self) -> &'static str {
                match self {
                    $($variant => $help,)*
                }
            }
        }
    };
}

/// Shading mode and interpolation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Shading {
    /// Where light is computed.
    pub mode: ShadingMode,
    /// The interpolation of normals, texture coordinates, colours and intensities.
    pub interpolation: Interpolation,
    /// Where intensities are clamped to 0..1.
    pub clamp: Clamp,
    /// Whether interpolated normals are normalized.
    pub normal_length: NormalLength,
}

/// Where light is computed.
///
/// `Flat` and `Gouraud` compute light without the base colour texture, which multiplies it at the
/// pixel, highlight included, like `GL_MODULATE` in OpenGL 1.x. They use no normal maps, and sample other
/// textures where light is computed. `Subdivided` interpolates light apart from what the texture
/// colours, like OpenGL's separate specular colour. Fog comes last.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum ShadingMode {
    /// Once for each polygon: at its centroid, with its own normal (Bouknight 1970).
    Flat,
    /// At the corners; the intensity is interpolated (Gouraud, *Continuous Shading of Curved
    /// Surfaces*, 1971).
    Gouraud,
    /// At every pixel; the normal is interpolated and normalized (Phong, *Illumination
    /// for Computer Generated Pictures*, 1975).
    #[default]
    Phong,
    /// At the corners of smaller triangles: visible triangles are subdivided until interpolated
    /// intensities agree with `Phong`, within the tolerance. Within a small triangle the intensity
    /// is interpolated with perspective.
    ///
    /// Where light jumps, no tolerance holds: at the edge of a cone, and where N.L becomes 0 in models
    /// whose highlight doesn't (Phong's). Subdivision then ends at 1/16 of a pixel. With several samples
    /// a pixel, light beyond 1 needs [`Clamp::End`]. Surfaces with normal maps or other textures beside
    /// the base colour's are lit at their pixels: no piece of them would be larger.
    Subdivided {
        /// The maximum difference, in 8-bit steps after encoding.
        tolerance: f32,
    },
}

impl ShadingMode {
    /// All modes, subdivision to one step of 8 bits.
    pub const ALL: [Self; 4] =
        [Self::Flat, Self::Gouraud, Self::Phong, Self::Subdivided { tolerance: 1.0 }];
}

named! { ShadingMode:
    Self::Flat => "flat", "at polygons' centroids";
    Self::Gouraud => "gouraud", "at corners";
    Self::Phong => "phong", "at pixels";
    Self::Subdivided { .. } => "subdivided", "at corners of ever smaller triangles";
}

/// The interpolation of vertex attributes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Interpolation {
    /// Linearly in space: correct.
    #[default]
    Perspective,
    /// Linearly in the window, over the triangle: textures slide on slanted surfaces.
    Screen,
    /// Linearly in the window along the edges of the *polygon* and then along the row between them:
    /// colours within change as the polygon turns (Foley et al., *Computer Graphics: Principles and
    /// Practice*, 1990, section 16.2.6). Polygons of more than 256 corners, or whose outline meets
    /// itself, are taken triangle by triangle.
    Scanline,
}

impl Interpolation {
    /// All interpolations.
    pub const ALL: [Self; 3] = [Self::Perspective, Self::Screen, Self::Scanline];
}

named! { Interpolation:
    Self::Perspective => "perspective", "linear in space";
    Self::Screen => "screen", "linear in the window";
    Self::Scanline => "scanline", "along edges and rows of polygons";
}

/// Where intensities computed at corners are clamped to 0..1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Clamp {
    /// At the corners, as fixed-function OpenGL does; where [`Subdivided`](ShadingMode::Subdivided) light is
    /// apart from a texture, at the end.
    #[default]
    Vertex,
    /// At the end, where colours become bytes.
    End,
}

impl Clamp {
    /// All places.
    pub const ALL: [Self; 2] = [Self::Vertex, Self::End];
}

named! { Clamp:
    Self::Vertex => "vertex", "at the vertex";
    Self::End => "end", "at the end";
}

/// The length of the normals that pixels are lit with. At corners it is 1 always.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum NormalLength {
    /// 1, as the equation requires (Phong 1975).
    #[default]
    Unit,
    /// As interpolation left it: less than 1 between corners, by the more the farther apart their
    /// normals point. It shows the effect on highlights.
    Interpolated,
}

impl NormalLength {
    /// All lengths.
    pub const ALL: [Self; 2] = [Self::Unit, Self::Interpolated];
}

named! { NormalLength:
    Self::Unit => "unit", "1";
    Self::Interpolated => "interpolated", "as it is between corners";
}
