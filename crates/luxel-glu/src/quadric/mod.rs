//! Spheres, cylinders and disks (GLU 1.3, chapter 6).
//!
//! A shape is a grid of corners: `across` steps about the z axis, `up` steps along it. Its styles are walks over the grid,
//! the same for all shapes. Texture coordinates run as those of the GLU that everybody has, where s falls from 1 at +y
//! over 0.75 at +x to 0, though the specification lets it rise.

mod cylinder;
mod disk;
mod sphere;
mod walk;

use crate::drawing::Drawing;
use walk::Grid;

/// Which normals a quadric has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Normals {
    /// None.
    None,
    /// One for each facet.
    Flat,
    /// One for each vertex.
    Smooth,
}

/// How a quadric is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DrawStyle {
    /// Its vertices.
    Point,
    /// The edges of its facets.
    Line,
    /// As lines, without edges between facets of one plane.
    Silhouette,
    /// Its facets.
    Fill,
}

/// Where the normals of a quadric point to, and from where its facets are counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orientation {
    /// Away from the axis; of disks, to +z.
    Outside,
    /// Towards the axis; of disks, to -z.
    Inside,
}

/// How the shapes that follow are drawn (`GLUquadric`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadric {
    /// `gluQuadricNormals`.
    pub normals: Normals,
    /// `gluQuadricDrawStyle`.
    pub draw_style: DrawStyle,
    /// `gluQuadricOrientation`.
    pub orientation: Orientation,
    /// `gluQuadricTexture`: whether vertices have texture coordinates.
    pub textured: bool,
}

impl Default for Quadric {
    fn default() -> Self {
        Self {
            normals: Normals::Smooth,
            draw_style: DrawStyle::Fill,
            orientation: Orientation::Outside,
            textured: false,
        }
    }
}

/// A size or a number of steps that no shape has (`GLU_INVALID_VALUE`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InvalidValue;

/// The most steps in either direction; larger numbers count as this one.
pub const MOST_STEPS: i32 = 2048;

impl Quadric {
    /// A sphere about the origin (`gluSphere`), its poles on the z axis.
    ///
    /// # Errors
    ///
    /// A negative radius, fewer than two slices, no stack.
    pub fn sphere(
        &self,
        drawing: &mut impl Drawing,
        radius: f64,
        slices: i32,
        stacks: i32,
    ) -> Result<(), InvalidValue> {
        let grid = steps(slices, stacks)?;
        if radius.is_nan() || radius < 0.0 {
            return Err(InvalidValue);
        }
        walk::draw(self, &sphere::Sphere { radius }, grid, drawing);
        Ok(())
    }

    /// The wall of a cylinder or a frustum (`gluCylinder`), from the radius `base` at z = 0 to `top` at z = `height`.
    ///
    /// # Errors
    ///
    /// A negative radius or height, fewer than two slices, no stack.
    pub fn cylinder(
        &self,
        drawing: &mut impl Drawing,
        [base, top]: [f64; 2],
        height: f64,
        slices: i32,
        stacks: i32,
    ) -> Result<(), InvalidValue> {
        let grid = steps(slices, stacks)?;
        if [base, top, height].iter().any(|size| size.is_nan() || *size < 0.0) {
            return Err(InvalidValue);
        }
        walk::draw(self, &cylinder::Cylinder { base, top, height }, grid, drawing);
        Ok(())
    }

    /// A disk in the plane z = 0 (`gluDisk`), with a hole if the inner radius is above 0.
    ///
    /// # Errors
    ///
    /// As for [`partial_disk`](Self::partial_disk).
    pub fn disk(
        &self,
        drawing: &mut impl Drawing,
        radii: [f64; 2],
        slices: i32,
        loops: i32,
    ) -> Result<(), InvalidValue> {
        self.partial_disk(drawing, radii, slices, loops, [0.0, 360.0])
    }

    /// The part of a disk (`gluPartialDisk`) from an angle over a sweep, in degrees from +y towards +x.
    ///
    /// # Errors
    ///
    /// Radii that are negative or no ring, fewer than two slices, no loop.
    pub fn partial_disk(
        &self,
        drawing: &mut impl Drawing,
        [inner, outer]: [f64; 2],
        slices: i32,
        loops: i32,
        [start, sweep]: [f64; 2],
    ) -> Result<(), InvalidValue> {
        let grid = steps(slices, loops)?;
        // Not a number is in no range.
        let is_ring = (0.0..=outer).contains(&inner) && outer > 0.0;
        if !(is_ring && (start + sweep).is_finite()) {
            return Err(InvalidValue);
        }
        let whole = sweep.abs() >= 360.0;
        let (start, sweep) = if whole {
            (start, 360.0)
        } else if sweep < 0.0 {
            (start + sweep, -sweep)
        } else {
            (start, sweep)
        };
        walk::draw(self, &disk::Disk { inner, outer, start, sweep, whole }, grid, drawing);
        Ok(())
    }
}

/// Steps across and up, within bounds: two across and one up at least.
fn steps(across: i32, up: i32) -> Result<Grid, InvalidValue> {
    if across < 2 || up < 1 {
        return Err(InvalidValue);
    }
    let bounded = |steps: i32| steps.min(MOST_STEPS).unsigned_abs();
    Ok(Grid { across: bounded(across), up: bounded(up) })
}

/// The sine and cosine of `part` of a turn that begins at `start` and sweeps over `sweep` degrees.
fn turned(start: f64, sweep: f64, part: f64) -> [f64; 2] {
    let angle = (start + sweep * part).to_radians();
    [libm::sin(angle), libm::cos(angle)]
}
