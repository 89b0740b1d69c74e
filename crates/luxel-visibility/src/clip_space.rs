//! Triangles given in clip coordinates: what each pixel's centre sees, without scene or camera.
//!
//! A [`Frame`] draws meshes with three coordinates a vertex and one matrix an instance. Clip coordinates
//! (x, y, z, w) that one projection made lie in a hyperplane, so that one of them is an affine function of the
//! others: z of x, y and w for perspectives, w of x, y and z for parallel rays. Three coordinates become
//! the mesh, the function a row of the matrix. Vertices of several projections have no such function: then each
//! triangle is an instance with a matrix of its own.

use crate::cluster::{Clusters, Frames, Instance, TooManyTriangles, TriangleOf};
use crate::frame::Frame;
use crate::query::{Forms, WindowRays};
use crate::raster::Tile;
use crate::types::{Coverage, CullFaces, PartUse, Samples, TILE, TriangleId, ViewFromLocal};
use glam::{DMat4, DVec4};
use luxel_math::{Level, SUBPIXELS};
use luxel_scene::{Lens, MaterialId, Mesh, Part, Projection, Size};
use std::sync::Arc;

/// What the centre of a pixel sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fragment {
    /// The triangle, by its place in the list.
    pub triangle: u32,
    /// The weights of its corners, as the ray through the centre meets it (perspective-correct).
    pub barycentric: [f32; 3],
    /// z/w there, from -1 at the near plane to 1 at the far one.
    pub depth: f32,
}

/// Draws triangles of vertices in clip coordinates, as OpenGL has them: what lies within -w..w in x, y and z is
/// seen, y up. Both sides are drawn; of equally near triangles the first one is seen.
///
/// Fragments are in rows from the top of the window; `None` where nothing is seen.
///
/// # Errors
/// [`TooManyTriangles`] beyond some billions.
///
/// # Panics
/// If a side of the window is 0 or more than [`MAX_SIDE`](crate::MAX_SIDE) pixels, or a face names a vertex
/// that isn't there.
pub fn rasterize(
    vertices: &[[f32; 4]],
    faces: &[[u32; 3]],
    size: Size,
    level: Level,
) -> Result<Vec<Option<Fragment>>, TooManyTriangles> {
    let placed = Placed::new(vertices, faces);
    let clusters = Clusters::new(&placed.mesh, Frames::One);
    let parts: Arc<[PartUse]> =
        [PartUse { coverage: Coverage::Opaque, cull: CullFaces::None }].into();
    // A window that shows clip coordinates as they are, but for its sides' ratio.
    let window = Projection { lens: Lens::Orthographic { height: 2.0 }, near: -1.0, far: 1.0 };
    let view_from_clip = window.clip_from_view(size).inverse();
    let view_from_mesh =
        |matrix: &DMat4| ViewFromLocal::new(&(view_from_clip * *matrix), placed.mesh.origin);
    let places: Vec<_> = placed.clip_from_mesh.iter().map(view_from_mesh).collect();
    let instance = |view_from_local| Instance {
        mesh: &placed.mesh,
        clusters: &clusters,
        view_from_local,
        parts: Arc::clone(&parts),
        ranks: &[],
        is_repeated: false,
    };
    let instances = places.iter().map(instance).collect();
    let frame = Frame::new(instances, &window, size, Samples::ONE, level)?;
    let lookup = Lookup { vertices, faces, eye: Eye::new(size), one_by_one: placed.one_by_one };
    let rows = luxel_parallel::map(frame.tiles()[1], 1, &|row| {
        row.map(|row| lookup.row(&frame, row, level)).collect::<Vec<_>>().concat()
    });
    Ok(rows.concat())
}

/// A mesh with the matrices of its instances.
struct Placed {
    mesh: Mesh,
    clip_from_mesh: Vec<DMat4>,
    /// Whether each triangle is an instance of its own.
    one_by_one: bool,
}

const Z: usize = 2;
const W: usize = 3;

impl Placed {
    fn new(vertices: &[[f32; 4]], faces: &[[u32; 3]]) -> Self {
        [Z, W]
            .iter()
            .find_map(|&left_out| Self::whole(vertices, faces, left_out))
            .unwrap_or_else(|| Self::one_by_one(vertices, faces))
    }

    /// `None` if the coordinate left out is no affine function of the three others.
    fn whole(vertices: &[[f32; 4]], faces: &[[u32; 3]], left_out: usize) -> Option<Self> {
        let last = Z + W - left_out;
        let used = faces.iter().flatten().map(|&vertex| &vertices[vertex as usize]);
        let row = affine_row(used, last, left_out)?;
        let mut rows = [DVec4::X, DVec4::Y, DVec4::ZERO, DVec4::ZERO];
        rows[last] = DVec4::Z;
        rows[left_out] = row;
        let positions = vertices.iter().map(|vertex| [vertex[0], vertex[1], vertex[last]]);
        Some(Self {
            mesh: mesh(positions.collect(), faces.to_vec()),
            clip_from_mesh: vec![by_columns(rows).transpose()],
            one_by_one: false,
        })
    }

    /// The triangle of the three unit vectors, which a matrix with clip coordinates as columns takes to them
    /// without rounding: edges that triangles share stay shared.
    fn one_by_one(vertices: &[[f32; 4]], faces: &[[u32; 3]]) -> Self {
        let units = vec![[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let matrix = |face: &[u32; 3]| {
            let [a, b, c] =
                face.map(|vertex| DVec4::from_array(vertices[vertex as usize].map(f64::from)));
            by_columns([a, b, c, DVec4::ZERO])
        };
        Self {
            mesh: mesh(units, vec![[0, 1, 2]]),
            clip_from_mesh: faces.iter().map(matrix).collect(),
            one_by_one: true,
        }
    }
}

fn mesh(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>) -> Mesh {
    let part = Part { first: 0, count: triangles.len() as u32, material: MaterialId(0) };
    Mesh { positions, triangles, parts: vec![part], ..Mesh::default() }
}

fn by_columns([x, y, z, w]: [DVec4; 4]) -> DMat4 {
    DMat4::from_cols(x, y, z, w)
}

/// How far a value may be from the affine function, in parts of z and w: some roundings of f32, in which clip
/// coordinates are computed.
const ROUNDING: f64 = 8.0 * f32::EPSILON as f64;
/// How large terms of the function may be, in the same parts, since f32 adds them up.
const LARGEST_TERM: f64 = 4.0;

/// The affine function a x + b y + c z + d, z for the coordinate `last`, that gives all vertices their
/// coordinate `value`, by least squares; `None` if there is none.
fn affine_row<'v>(
    vertices: impl Iterator<Item = &'v [f32; 4]> + Clone,
    last: usize,
    value: usize,
) -> Option<DVec4> {
    let points =
        || vertices.clone().map(|vertex| [0, 1, last, value].map(|axis| f64::from(vertex[axis])));
    let count = points().count().max(1) as f64;
    let mut mean = [0.0; 4];
    for point in points() {
        for (mean, number) in mean.iter_mut().zip(point) {
            *mean += number / count;
        }
    }
    // Normal equations about the mean, the value in the last column.
    let mut system = [[0.0; 4]; 3];
    for point in points() {
        let about: [f64; 4] = std::array::from_fn(|axis| point[axis] - mean[axis]);
        for (row, sums) in system.iter_mut().enumerate() {
            for (sum, number) in sums.iter_mut().zip(about) {
                *sum += about[row] * number;
            }
        }
    }
    let [a, b, c] = solve(system);
    let d = mean[3] - a * mean[0] - b * mean[1] - c * mean[2];
    let fits = points().all(|[x, y, z, value]| {
        let terms = [a * x, b * y, c * z, d];
        let size = z.abs().max(value.abs());
        (terms.iter().sum::<f64>() - value).abs() <= ROUNDING * size
            && terms.iter().all(|term| term.abs() <= LARGEST_TERM * size)
    });
    fits.then_some(DVec4::new(a, b, c, d))
}

/// Solves three equations by elimination with the largest pivot; unknowns on which nothing hangs are 0.
fn solve(mut system: [[f64; 4]; 3]) -> [f64; 3] {
    let mut unknowns = [None; 3];
    let mut column_of = [None; 3];
    let largest =
        system.iter().flat_map(|row| row[..3].iter()).fold(0.0, |a: f64, b| a.max(b.abs()));
    for row in 0..3 {
        let mut best = (1e-12 * largest, None);
        for at in row..3 {
            for column in (0..3).filter(|&column| unknowns[column].is_none()) {
                if system[at][column].abs() > best.0 {
                    best = (system[at][column].abs(), Some((at, column)));
                }
            }
        }
        let Some((at, column)) = best.1 else { break };
        system.swap(row, at);
        unknowns[column] = Some(row);
        column_of[row] = Some(column);
        let pivot = system[row];
        for (_, other) in system.iter_mut().enumerate().filter(|(other, _)| *other != row) {
            let factor = other[column] / pivot[column];
            for (number, of_pivot) in other.iter_mut().zip(pivot) {
                *number -= factor * of_pivot;
            }
        }
    }
    std::array::from_fn(|column| {
        unknowns[column].map_or(0.0, |row: usize| system[row][3] / system[row][column])
    })
}

/// The view in which barycentrics are found: the eye of homogeneous coordinates (x, y, w).
struct Eye {
    rays: WindowRays,
    /// The window's width by its height.
    ratio: f64,
}

impl Eye {
    fn new(size: Size) -> Self {
        let lens = Lens::Perspective { fov_y_radians: std::f64::consts::FRAC_PI_2 };
        let projection = Projection { lens, near: 1.0, far: 2.0 };
        let ratio = f64::from(size.width) / f64::from(size.height);
        Self { rays: WindowRays::new(&projection, size), ratio }
    }
}

/// What turns ids into fragments.
struct Lookup<'a> {
    vertices: &'a [[f32; 4]],
    faces: &'a [[u32; 3]],
    eye: Eye,
    one_by_one: bool,
}

impl Lookup<'_> {
    /// A row of tiles, in rows of pixels.
    fn row(&self, frame: &Frame<'_>, row: usize, level: Level) -> Vec<Option<Fragment>> {
        let [across, _] = frame.tiles();
        let Size { width, height } = frame.size();
        let top = row as i32 * TILE;
        let rows = TILE.min(height as i32 - top);
        let mut pixels = vec![None; width as usize * rows as usize];
        let no_holes = |_: TriangleId, _: [i32; 2]| false;
        let mut tile = Tile::new(1);
        // Neighbouring pixels often see the same triangle.
        let mut last: Option<(TriangleId, u32, Forms)> = None;
        for number in (row * across..(row + 1) * across).filter(|&tile| !frame.is_tile_empty(tile))
        {
            frame.draw_opaque(level, number, &no_holes, &mut tile);
            let [left, _] = frame.tile_origin(number);
            for y in 0..rows {
                for x in 0..TILE.min(width as i32 - left) {
                    let id = tile.id(x, y, 0);
                    let Some(of) = frame.triangle(id) else { continue };
                    let known = last.take().filter(|(known, ..)| *known == id);
                    let (_, triangle, forms) = &*last.insert(known.unwrap_or_else(|| {
                        let triangle = self.triangle(of);
                        (id, triangle, self.forms(triangle))
                    }));
                    let centre = [left + x, top + y].map(|at| at * SUBPIXELS + SUBPIXELS / 2);
                    let at = y as usize * width as usize + (left + x) as usize;
                    pixels[at] = Some(self.fragment(*triangle, forms, centre));
                }
            }
        }
        pixels
    }

    fn triangle(&self, of: TriangleOf) -> u32 {
        if self.one_by_one { of.instance as u32 } else { of.triangle }
    }

    fn corners(&self, triangle: u32) -> [[f64; 4]; 3] {
        let corner = |vertex: u32| self.vertices[vertex as usize].map(f64::from);
        self.faces[triangle as usize].map(corner)
    }

    fn forms(&self, triangle: u32) -> Forms {
        let in_view = |[x, y, _, w]: [f64; 4]| [x * self.eye.ratio, y, -w];
        Forms::new(&self.eye.rays, self.corners(triangle).map(in_view))
    }

    fn fragment(&self, triangle: u32, forms: &Forms, centre: [i32; 2]) -> Fragment {
        let barycentric = forms.exact_barycentric(&self.eye.rays, centre);
        let corners = self.corners(triangle);
        let mean = |coordinate: usize| -> f64 {
            let [a, b, c] = corners.map(|corner| corner[coordinate]);
            let [u, v, t] = barycentric.map(f64::from);
            u * a + v * b + t * c
        };
        // Rounding must not carry it past the planes that clip.
        let depth = (mean(Z) / mean(W)).clamp(-1.0, 1.0) as f32;
        Fragment { triangle, barycentric, depth }
    }
}
