//! Surface points in memory, while the shadow rays of other batches are traced, too.

use luxel_lighting::SurfacePoint;
use luxel_math::{LANES, Lanes, Vec3};

/// The material and the surface points of a batch.
pub(super) struct KeptPoints {
    material: u32,
    rows: [[f32; LANES]; 10],
}

impl KeptPoints {
    pub(super) const NONE: Self = Self { material: 0, rows: [[0.0; LANES]; 10] };

    #[inline(always)]
    pub(super) fn keep<N: Lanes>(&mut self, material: u32, point: &SurfacePoint<N>) {
        self.material = material;
        let SurfacePoint { position, normal, view, depth } = *point;
        let [
            position_x,
            position_y,
            position_z,
            normal_x,
            normal_y,
            normal_z,
            view_x,
            view_y,
            view_z,
            depth_row,
        ] = &mut self.rows;
        position.x.store(position_x, 0);
        position.y.store(position_y, 0);
        position.z.store(position_z, 0);
        normal.x.store(normal_x, 0);
        normal.y.store(normal_y, 0);
        normal.z.store(normal_z, 0);
        view.x.store(view_x, 0);
        view.y.store(view_y, 0);
        view.z.store(view_z, 0);
        depth.store(depth_row, 0);
    }

    #[inline(always)]
    pub(super) fn of<N: Lanes>(&self, simd: N) -> (u32, SurfacePoint<N>) {
        let [px, py, pz, nx, ny, nz, vx, vy, vz, depth] = &self.rows;
        let point = SurfacePoint {
            position: Vec3::new(simd.load(px, 0), simd.load(py, 0), simd.load(pz, 0)),
            normal: Vec3::new(simd.load(nx, 0), simd.load(ny, 0), simd.load(nz, 0)),
            view: Vec3::new(simd.load(vx, 0), simd.load(vy, 0), simd.load(vz, 0)),
            depth: simd.load(depth, 0),
        };
        (self.material, point)
    }
}
