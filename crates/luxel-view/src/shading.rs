//! Where light is computed, and how it gets to the pixels between: each choice with its name, which
//! flags, scene files and the window read.

/// Where light is computed, and how it gets to the pixels between.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shading {
    /// Where light is computed.
    pub mode: ShadingMode,
    /// How normals, texture coordinates, colours and intensities get from corners to pixels.
    pub interpolation: Interpolation,
    /// Where intensities are brought into 0..1.
    pub clamp: Clamp,
    /// Whether interpolated normals are brought to unit length.
    pub normal_length: NormalLength,
}

/// Where light is computed.
///
/// In all modes but `Phong`, what is computed elsewhere is the light of the surface without the
/// texture of its base colour; that multiplies it at the pixel, as `GL_MODULATE` does in OpenGL
/// 1.x, and fog comes last. Normal maps count in `Phong` only; other textures are looked up where
/// the light is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ShadingMode {
    /// Once for each polygon: at its centroid, with its own normal (Bouknight 1970).
    Flat,
    /// At the corners; the intensity is interpolated (Gouraud, *Continuous Shading of Curved
    /// Surfaces*, 1971).
    Gouraud,
    /// At every pixel; the normal is interpolated and brought to unit length (Phong, *Illumination
    /// for Computer Generated Pictures*, 1975).
    #[default]
    Phong,
    /// At the corners of smaller triangles, into which those that are seen are divided until
    /// interpolating the intensity gives what `Phong` gives, to the tolerance. Within a small
    /// triangle the intensity is interpolated with perspective.
    Subdivided {
        /// The difference that is left, in steps of 8 bits after encoding.
        tolerance: f32,
    },
}

impl ShadingMode {
    /// All modes, subdivision to one step of 8 bits.
    pub const ALL: [Self; 4] =
        [Self::Flat, Self::Gouraud, Self::Phong, Self::Subdivided { tolerance: 1.0 }];

    /// The name, as flags and scene files have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.words().0
    }

    /// What it means, in a few words.
    #[must_use]
    pub const fn help(self) -> &'static str {
        self.words().1
    }

    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Flat => ("flat", "at polygons' centroids"),
            Self::Gouraud => ("gouraud", "at corners"),
            Self::Phong => ("phong", "at pixels"),
            Self::Subdivided { .. } => ("subdivided", "at corners of ever smaller triangles"),
        }
    }
}

/// How what corners carry gets to the pixels between.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// Linearly in space, which is right.
    #[default]
    Perspective,
    /// Linearly in the window, over the triangle: things slide where the surface slants away.
    Screen,
    /// Linearly in the window along the edges of the *polygon* and then along the row between them:
    /// colours within change as the polygon turns (Foley et al., *Computer Graphics: Principles and
    /// Practice*, 1990, section 16.2.6). Polygons of more than 256 corners, or whose outline meets
    /// itself, are taken triangle by triangle.
    Scanline,
}

impl Interpolation {
    /// All ways.
    pub const ALL: [Self; 3] = [Self::Perspective, Self::Screen, Self::Scanline];

    /// The name, as flags and scene files have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.words().0
    }

    /// What it means, in a few words.
    #[must_use]
    pub const fn help(self) -> &'static str {
        self.words().1
    }

    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Perspective => ("perspective", "linear in space"),
            Self::Screen => ("screen", "linear in the window"),
            Self::Scanline => ("scanline", "along edges and rows of polygons"),
        }
    }
}

/// Where intensities that are computed at corners are brought into 0..1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Clamp {
    /// At the corners, as fixed-function OpenGL does.
    #[default]
    Vertex,
    /// At the end, where colours become bytes.
    End,
}

impl Clamp {
    /// All places.
    pub const ALL: [Self; 2] = [Self::Vertex, Self::End];

    /// The name, as flags and scene files have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.words().0
    }

    /// What it means, in a few words.
    #[must_use]
    pub const fn help(self) -> &'static str {
        self.words().1
    }

    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Vertex => ("vertex", "at the vertex"),
            Self::End => ("end", "at the end"),
        }
    }
}

/// The length of the normals that pixels are lit with. At corners it is 1 always.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NormalLength {
    /// 1, as the equation wants it (Phong 1975).
    #[default]
    Unit,
    /// As interpolation left it: less than 1 between corners, by the more the farther apart their
    /// normals point. It shows what becomes of highlights then.
    Interpolated,
}

impl NormalLength {
    /// All lengths.
    pub const ALL: [Self; 2] = [Self::Unit, Self::Interpolated];

    /// The name, as flags and scene files have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.words().0
    }

    /// What it means, in a few words.
    #[must_use]
    pub const fn help(self) -> &'static str {
        self.words().1
    }

    const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Unit => ("unit", "1"),
            Self::Interpolated => ("interpolated", "as it is between corners"),
        }
    }
}
