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
            Self::DuplicateFace => "triangles in the place of another one",
            Self::InconsistentWinding => {
                "triangles wound the other way round than their neighbours: averages of normals \
                 cancel out"
            }
            Self::FlippedWinding => {
                "triangles whose front is behind their normals or inside their solid: culling \
                 takes the wrong ones"
            }
            Self::OneSidedSurface => "edges at which a surface with only one side turns over",
            Self::NonManifoldEdge => {
                "edges with three triangles or more: their normals are an average over surfaces \
                 that don't go on into one another"
            }
            Self::TJunction => {
                "corners in the middle of a neighbour's edge: the two sides interpolate different \
                 colours, and the background may shine through"
            }
            Self::Crack => "edges with a narrow gap to the edge that they should meet",
            Self::DuplicateVertex => {
                "vertices that repeat another one on a smooth surface: programs that average \
                 normals by number show a seam here (luxel goes by place)"
            }
            Self::UndefinedNormal => "vertex normals that are zero or not a number",
            Self::NonUnitNormal => {
                "vertex normals of another length than 1: programs that don't normalise light them \
                 too bright or too dark"
            }
            Self::NormalBehindFace => {
                "vertices whose normal points behind one of their faces: it is lit from the wrong \
                 side"
            }
            Self::UnrepresentativeNormals => {
                "triangles that face another way than the average of their vertex normals: shading \
                 shows a shape that isn't there"
            }
            Self::HiddenFold => {
                "edges at which faces turn sharply while their vertex normals don't: shading shows \
                 a smooth sheet"
            }
            Self::Sliver => {
                "long thin triangles whose corners disagree with the edge that they almost lie in, \
                 or thinner than a thousandth of their length: they show as streaks or dots"
            }
            Self::MissedHighlight => {
                "triangles that hold, or can hold, a highlight which none of their vertices sees: \
                 shading per vertex loses it"
            }
            Self::ScreenDrift => {
                "triangles that reach so far into the depth that colours and textures slide over \
                 them where they are interpolated in the window"
            }
            Self::FacetedSilhouette => {
                "edges of the outline that are straight where the surface is curved"
            }
        }
    }

    /// The remedy. Settings of the renderer stand in backticks, as `` `shading phong` ``.
    #[must_use]
    pub const fn cure(self) -> &'static str {
        match self {
            Self::DegenerateFace => "delete them, or merge their corners",
            Self::DuplicateFace => "delete all but one of each",
            Self::InconsistentWinding => "make the winding consistent, and compute normals anew",
            Self::FlippedWinding => "reverse the order of their corners",
            Self::OneSidedSurface => "cut the surface there, and give each half its own vertices",
            Self::NonManifoldEdge => "split the vertices there, one for each surface",
            Self::TJunction => "split the neighbour's edge at the corner",
            Self::Crack => "merge the vertices on both sides of the gap",
            Self::DuplicateVertex => "merge vertices with equal attributes",
            Self::UndefinedNormal => "compute normals anew (`normals area-angle`)",
            Self::NonUnitNormal => "normalise them",
            Self::NormalBehindFace => {
                "compute normals anew (`normals area-angle`), or split vertices at sharp edges"
            }
            Self::UnrepresentativeNormals => {
                "split vertices at sharp edges (`normals area-angle` `crease 40`), or refine the \
                 mesh"
            }
            Self::HiddenFold => "split vertices at sharp edges (`normals area-angle` `crease 40`)",
            Self::Sliver => "divide them across, or flip the diagonals of their neighbours",
            Self::MissedHighlight => "shade per pixel (`shading phong`), or refine the mesh",
            Self::ScreenDrift => {
                "interpolate in space (`interpolation perspective`), or refine the mesh"
            }
            Self::FacetedSilhouette => "refine the mesh, or draw it smaller",
        }
    }
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
