//! Where a surface isn't there: texels cut away, and what is wholly transparent.

use crate::{AlphaMode, Mesh, Scene, SceneMaterial, TextureUse};

impl Scene {
    /// Whether a triangle of a mesh has a hole at the place with these barycentrics: its alpha
    /// there, by the textures' finest level, is below a mask's cutoff, or is 0 and blended.
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
        match material.alpha_mode {
            AlphaMode::Opaque => false,
            AlphaMode::Mask { cutoff } => {
                self.alpha(mesh, triangle, barycentric, material) < cutoff
            }
            AlphaMode::Blend => self.alpha(mesh, triangle, barycentric, material) <= 0.0,
        }
    }

    /// The alpha of a surface at a place of a triangle.
    fn alpha(
        &self,
        mesh: &Mesh,
        triangle: u32,
        weights: [f32; 3],
        material: &SceneMaterial,
    ) -> f32 {
        let corners = mesh.attribute_corners()[triangle as usize].map(|corner| corner as usize);
        let mix = |at: [f32; 3]| at[0] * weights[0] + at[1] * weights[1] + at[2] * weights[2];
        let sample = |used: TextureUse| {
            let uvs = &mesh.uvs[usize::from(used.uv_set & 1)];
            let [u, v] = [0, 1]
                .map(|axis| mix(corners.map(|corner| uvs.get(corner).map_or(0.0, |uv| uv[axis]))));
            let [u, v] = used.transformed([u, v]);
            self.textures[used.texture.index()].sample_base(u, v)
        };
        let mut alpha = material.opacity;
        if !mesh.colors.is_empty() && material.vertex_colors {
            alpha *= mix(corners.map(|corner| mesh.colors[corner][3]));
        }
        if let Some(used) = material.base_color {
            alpha *= sample(used)[3];
        }
        if let Some(used) = material.opacity_map {
            alpha *= sample(used)[0];
        }
        alpha
    }
}
