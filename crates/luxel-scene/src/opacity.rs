//! Holes in surfaces: texels below the alpha cutoff, and fully transparent ones.

use crate::{AlphaMode, Mesh, Scene, SceneMaterial, TextureUse};
use luxel_math::{Lanes, Mask};

/// The inputs of a triangle's opacity: its corners, as rows to load lanes from.
///
/// Three texture coordinates of the base colour's set and the opacities of two colours; three of
/// the opacity map's set, that of the third colour, and 1 if there are colours.
#[derive(Clone, Copy, Debug, Default)]
pub struct OpacityCorners([[f32; 8]; 2]);

impl OpacityCorners {
    /// The corners of a triangle of a mesh; missing attributes are 0.
    ///
    /// # Panics
    /// If the mesh has no such triangle.
    #[must_use]
    pub fn new(mesh: &Mesh, triangle: u32, material: &SceneMaterial) -> Self {
        let corners = mesh.attribute_corners()[triangle as usize].map(|corner| corner as usize);
        let uvs = |used: Option<&TextureUse>| {
            let set = used.map(|used| &mesh.uvs[usize::from(used.uv_set & 1)]);
            corners.map(|corner| set.and_then(|set| set.get(corner)).copied().unwrap_or_default())
        };
        let [[u0, v0], [u1, v1], [u2, v2]] = uvs(material.base_color.as_deref());
        let [[s0, t0], [s1, t1], [s2, t2]] = uvs(material.opacity_map.as_deref());
        let colored = !mesh.colors.is_empty() && material.vertex_colors;
        let [a, b, c] =
            if colored { corners.map(|corner| mesh.colors[corner][3]) } else { [0.0; 3] };
        let is_colored = if colored { 1.0 } else { 0.0 };
        Self([[u0, v0, u1, v1, u2, v2, a, b], [s0, t0, s1, t1, s2, t2, c, is_colored]])
    }

    /// One triangle's corners in every lane; `simd` selects the lane type.
    #[inline(always)]
    #[must_use]
    pub fn everywhere<N: Lanes>(&self, simd: N) -> OpacityLanes<N> {
        let mut rows = [[simd; 8]; 2];
        for (lanes, row) in rows.as_flattened_mut().iter_mut().zip(self.0.as_flattened()) {
            *lanes = simd.constant(*row);
        }
        OpacityLanes(rows)
    }

    /// Each lane's own corners, from `of(lane)`; `simd` selects the lane type. The closure is
    /// to be marked `#[inline(always)]`.
    #[inline(always)]
    #[must_use]
    pub fn in_lanes<'c, N: Lanes>(simd: N, of: impl Fn(usize) -> &'c Self) -> OpacityLanes<N> {
        let first = simd.load_transposed(
            #[inline(always)]
            |lane| &of(lane).0[0],
        );
        let second = simd.load_transposed(
            #[inline(always)]
            |lane| &of(lane).0[1],
        );
        OpacityLanes([first, second])
    }
}

/// [`OpacityCorners`] of a triangle for each lane.
#[derive(Clone, Copy, Debug)]
pub struct OpacityLanes<N>([[N; 8]; 2]);

impl Scene {
    /// Whether a triangle of a mesh has a hole at the place with these barycentrics: see
    /// [`Scene::holes`].
    ///
    /// # Panics
    /// If the mesh has no such triangle.
    #[must_use]
    pub fn is_hole(
        &self,
        mesh: &Mesh,
        triangle: u32,
        barycentric: [f32; 3],
        material: &SceneMaterial,
    ) -> bool {
        material.alpha_mode != AlphaMode::Opaque && {
            let corners = OpacityCorners::new(mesh, triangle, material);
            self.holes(material, &corners.everywhere(0.0_f32), barycentric, 1) != 0
        }
    }

    /// How much of the light from behind a triangle of a mesh keeps at the place with these
    /// barycentrics: all but through a mask's holes, and a blended surface its alpha.
    ///
    /// # Panics
    /// If the mesh has no such triangle.
    #[must_use]
    pub fn opacity(
        &self,
        mesh: &Mesh,
        triangle: u32,
        barycentric: [f32; 3],
        material: &SceneMaterial,
    ) -> f32 {
        let corners = || OpacityCorners::new(mesh, triangle, material).everywhere(0.0_f32);
        match material.alpha_mode {
            AlphaMode::Opaque => 1.0,
            AlphaMode::Mask { .. } => {
                if self.holes(material, &corners(), barycentric, 1) == 0 {
                    1.0
                } else {
                    0.0
                }
            }
            AlphaMode::Blend => {
                Lanes::clamped(self.alpha(material, &corners(), barycentric, 1), 0.0, 1.0)
            }
        }
    }

    /// The lanes, of those whose bit is set, in which a triangle of this material has a hole at the
    /// place with these barycentrics: its alpha there, by the textures' finest level, is below a
    /// mask's cutoff, or is 0 and blended.
    #[must_use]
    #[inline(always)]
    pub fn holes<N: Lanes>(
        &self,
        material: &SceneMaterial,
        corners: &OpacityLanes<N>,
        barycentric: [N; 3],
        lanes: u32,
    ) -> u32 {
        let simd = barycentric[0];
        let holes = match material.alpha_mode {
            AlphaMode::Opaque => return 0,
            AlphaMode::Mask { cutoff } => {
                self.alpha(material, corners, barycentric, lanes).less(simd.constant(cutoff))
            }
            AlphaMode::Blend => {
                self.alpha(material, corners, barycentric, lanes).less_or_equal(simd.zero())
            }
        };
        holes.bits() & lanes
    }

    /// The alpha of a surface at places of triangles.
    #[inline(always)]
    fn alpha<N: Lanes>(
        &self,
        material: &SceneMaterial,
        OpacityLanes([first, second]): &OpacityLanes<N>,
        weights: [N; 3],
        lanes: u32,
    ) -> N {
        let one = weights[0].one();
        let mut alpha = one.constant(material.opacity);
        let colored = one.equal(second[7]);
        if colored.any() {
            let opacity = mix([first[6], first[7], second[6]], weights);
            alpha = (alpha * opacity).select(colored, alpha);
        }
        if let Some(used) = &material.base_color {
            let [u, v] = used.transformed(uv(first, weights));
            let texture = &self.textures[used.texture.index()];
            let [opacity] = texture.sample_base::<N, 3, 1>(u, v, lanes);
            alpha = alpha * opacity;
        }
        if let Some(used) = &material.opacity_map {
            let [u, v] = used.transformed(uv(second, weights));
            let texture = &self.textures[used.texture.index()];
            let [opacity] = texture.sample_base::<N, 0, 1>(u, v, lanes);
            alpha = alpha * opacity;
        }
        alpha
    }
}

/// Texture coordinates between three corners.
#[inline(always)]
fn uv<N: Lanes>([u0, v0, u1, v1, u2, v2, ..]: &[N; 8], weights: [N; 3]) -> [N; 2] {
    [mix([*u0, *u1, *u2], weights), mix([*v0, *v1, *v2], weights)]
}

#[inline(always)]
fn mix<N: Lanes>(at: [N; 3], weights: [N; 3]) -> N {
    at[0] * weights[0] + at[1] * weights[1] + at[2] * weights[2]
}
