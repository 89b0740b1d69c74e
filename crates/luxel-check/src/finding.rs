//! Findings: kind, count, severity, places and remedy.

use luxel_scene::DVec3;

/// A kind of finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Kind {
    /// Triangles without area.
    DegenerateFace,
    /// Triangles over the same places as an earlier one.
    DuplicateFace,
    /// Faces wound against the rest of their surface.
    InconsistentWinding,
    /// Faces whose front is inside their solid, or behind their normals.
    FlippedWinding,
    /// Edges at which one-sided surfaces turn over.
    OneSidedSurface,
    /// Edges with three faces or more.
    NonManifoldEdge,
    /// Corners in the middle of a neighbour's edge.
    TJunction,
    /// Edges that run along each other with a gap between them.
    Crack,
    /// Vertices that duplicate another one on a smooth surface.
    DuplicateVertex,
    /// Vertex normals that are zero or not a number.
    UndefinedNormal,
    /// Vertex normals not of unit length.
    NonUnitNormal,
    /// Vertex normals that point behind one of their faces.
    NormalBehindFace,
    /// Faces that face another way than the average of their vertex normals.
    UnrepresentativeNormals,
    /// Folds that averaged vertex normals hide.
    HiddenFold,
    /// Long thin triangles that show as streaks or dots.
    Sliver,
    /// Faces with a highlight that their vertices miss.
    MissedHighlight,
    /// Triangles over which attributes drift in screen-space interpolation.
    ScreenDrift,
    /// Silhouettes of smooth surfaces that show their polygons.
    FacetedSilhouette,
}

impl Kind {
    /// All kinds, in the order of reports.
    pub const ALL: [Self; 18] = [
        Self::DegenerateFace,
        Self::DuplicateFace,
        Self::InconsistentWinding,
        Self::FlippedWinding,
        Self::OneSidedSurface,
        Self::NonManifoldEdge,
        Self::TJunction,
        Self::Crack,
        Self::DuplicateVertex,
        Self::UndefinedNormal,
        Self::NonUnitNormal,
        Self::NormalBehindFace,
        Self::UnrepresentativeNormals,
        Self::HiddenFold,
        Self::Sliver,
        Self::MissedHighlight,
        Self::ScreenDrift,
        Self::FacetedSilhouette,
    ];

    /// The name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::DegenerateFace => "degenerate-face",
            Self::DuplicateFace => "duplicate-face",
            Self::InconsistentWinding => "inconsistent-winding",
            Self::FlippedWinding => "flipped-winding",
            Self::OneSidedSurface => "one-sided-surface",
            Self::NonManifoldEdge => "non-manifold-edge",
            Self::TJunction => "t-junction",
            Self::Crack => "crack",
            Self::DuplicateVertex => "duplicate-vertex",
            Self::UndefinedNormal => "undefined-normal",
            Self::NonUnitNormal => "non-unit-normal",
            Self::NormalBehindFace => "normal-behind-face",
            Self::UnrepresentativeNormals => "unrepresentative-normals",
            Self::HiddenFold => "hidden-fold",
            Self::Sliver => "sliver",
            Self::MissedHighlight => "missed-highlight",
            Self::ScreenDrift => "screen-drift",
            Self::FacetedSilhouette => "faceted-silhouette",
        }
    }

    /// A description of the counted elements and their fault, in the plural.
    #[must_use]
    pub const fn about(self) -> &'static str {
        match self {
            Self::DegenerateFace => "triangles without area: they have no normal",
            Self::DuplicateFace => "triangles that repeat another one",
            Self::InconsistentWinding => {
                "triangles wound against their neighbours: averaged normals cancel out"
            }
            Self::FlippedWinding => {
                "triangles that face away from their normals or into their solid: culling drops \
                 the wrong ones"
            }
            Self::OneSidedSurface => "edges where a one-sided surface flips its orientation",
            Self::NonManifoldEdge => {
                "edges of three or more triangles: their normals average over unrelated surfaces"
            }
            Self::TJunction => {
                "corners in the middle of a neighbour's edge: the two sides interpolate different \
                 colours, and the background may show through"
            }
            Self::Crack => "edges with a narrow gap to the edge that they should meet",
            Self::DuplicateVertex => {
                "vertices that repeat another one on a smooth surface: programs that average \
                 normals by index show a seam here (luxel averages by position)"
            }
            Self::UndefinedNormal => "vertex normals that are zero or not a number",
            Self::NonUnitNormal => {
                "vertex normals not of unit length: programs that don't normalize them compute \
                 too much or too little light"
            }
            Self::NormalBehindFace => {
                "vertices with a normal that points behind one of their faces, which is lit from \
                 the wrong side"
            }
            Self::UnrepresentativeNormals => {
                "triangles that deviate from the average of their vertex normals: shading shows a \
                 shape that isn't there"
            }
            Self::HiddenFold => "sharp edges with smooth vertex normals: shading hides the fold",
            Self::Sliver => {
                "long thin triangles with a corner normal that contradicts the edge next to it, \
                 or thinner than a thousandth of their length: they show as streaks or dots"
            }
            Self::MissedHighlight => {
                "triangles with a possible highlight that none of their vertices sees: shading \
                 per vertex misses it"
            }
            Self::ScreenDrift => {
                "triangles of such depth that colours and textures slide over them under \
                 screen-linear interpolation"
            }
            Self::FacetedSilhouette => "straight silhouette edges of a curved surface",
        }
    }

    /// A renderer setting that avoids the fault.
    #[must_use]
    pub const fn hint(self) -> Option<Hint> {
        match self {
            Self::UndefinedNormal | Self::NormalBehindFace => Some(Hint::ComputeNormals),
            Self::UnrepresentativeNormals | Self::HiddenFold => {
                Some(Hint::ComputeNormalsWithCreases)
            }
            Self::MissedHighlight => Some(Hint::ShadePerPixel),
            Self::ScreenDrift => Some(Hint::InterpolateInSpace),
            _ => None,
        }
    }

    /// The remedy.
    #[must_use]
    pub const fn cure(self) -> &'static str {
        match self {
            Self::DegenerateFace => "delete them, or merge their corners",
            Self::DuplicateFace => "delete all but one of each",
            Self::InconsistentWinding => "make the winding consistent, and recompute normals",
            Self::FlippedWinding => "reverse the order of their corners",
            Self::OneSidedSurface => "cut the surface there, and give each half its own vertices",
            Self::NonManifoldEdge => "split the vertices there, one for each surface",
            Self::TJunction => "split the neighbour's edge at the corner",
            Self::Crack => "merge the vertices on both sides of the gap",
            Self::DuplicateVertex => "merge vertices with equal attributes",
            Self::UndefinedNormal => "recompute normals",
            Self::NonUnitNormal => "normalize them",
            Self::NormalBehindFace => "recompute normals, or split vertices at sharp edges",
            Self::UnrepresentativeNormals => {
                "split vertices at sharp edges, or refine the \
                 mesh"
            }
            Self::HiddenFold => "split vertices at sharp edges",
            Self::Sliver => "split them across, or flip the diagonals of their neighbours",
            Self::MissedHighlight => "shade per pixel, or refine the mesh",
            Self::ScreenDrift => "interpolate in space, or refine the mesh",
            Self::FacetedSilhouette => "refine the mesh, or render it smaller",
        }
    }
}

/// A renderer setting that avoids a fault. It is data: each program words it as its setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Hint {
    /// Compute normals, weighted by area and angle.
    ComputeNormals,
    /// Compute them, and keep sharp edges.
    ComputeNormalsWithCreases,
    /// Phong shading.
    ShadePerPixel,
    /// Perspective-correct interpolation.
    InterpolateInSpace,
}

/// The place of a finding.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The object's index.
    pub object: u32,
    /// The triangle's index in the object, if there is one.
    pub triangle: Option<u32>,
    /// In world space: a triangle's centroid, an edge's middle, a vertex.
    pub position: DVec3,
}

/// All findings of one kind in a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The kind.
    pub kind: Kind,
    /// The number of triangles, edges or vertices, depending on the kind.
    pub count: u64,
    /// The largest difference in a picture, in 8-bit steps; `None` if undefined or unknown.
    pub severity: Option<f32>,
    /// The largest deviation of a silhouette from its curve, or the largest drift, in pixels.
    pub pixels: Option<f32>,
    /// The first places, in the order of objects and triangles.
    pub places: Vec<Place>,
}
