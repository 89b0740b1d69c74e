//! An explicit micro-surface with traced rays, beside its statistical model.

use super::point::sent;
use crate::GalleryError;
use crate::chapter::{Chapter, Figure};
use crate::shot::Studio;
use crate::svg::{Anchor, Ink, Svg};
use luxel::lighting::{Material, Reflection};
use luxel::pick::{Bvh, MeshRays, Quality, Ray, RayHit};
use luxel::scene::DVec3;
use std::f64::consts::{PI, TAU};

/// A surface of small mirrors; z is the way out of it.
struct Surface {
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
    tree: Bvh,
}

/// Numbers without a pattern, from 0 to 1: a multiplier and an increment of Knuth's MMIX.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

impl Surface {
    fn new(positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>) -> Result<Self, GalleryError> {
        let tree = Bvh::build(&positions, &triangles, Quality::Thorough)
            .map_err(|error| GalleryError::Rays(error.to_string()))?;
        Ok(Self { positions, triangles, tree })
    }

    /// The normal of a triangle, out of the surface.
    fn normal(&self, triangle: u32) -> DVec3 {
        let [a, b, c] = self.triangles[triangle as usize]
            .map(|corner| DVec3::from_array(self.positions[corner as usize].map(f64::from)));
        let normal = (b - a).cross(c - a).normalize_or(DVec3::Z);
        if normal.z < 0.0 { -normal } else { normal }
    }

    /// The first hit of each ray.
    fn meet(&self, rays: &[[DVec3; 2]]) -> Vec<Option<RayHit>> {
        let follow = MeshRays::new(&self.tree, &self.positions);
        let rays: Vec<_> = rays
            .iter()
            .map(|[origin, direction]| {
                Ray::new(origin.as_vec3().to_array(), direction.as_vec3().to_array())
            })
            .collect();
        follow.closest_of_each(&rays)
    }

    /// Where rays that have met the surface go on from, and how: mirrored.
    fn bounced(&self, [origin, direction]: [DVec3; 2], hit: &RayHit) -> [DVec3; 2] {
        let normal = self.normal(hit.triangle);
        let away = direction - normal * (2.0 * direction.dot(normal));
        // Slightly off the surface, or the ray would hit its origin.
        [origin + direction * f64::from(hit.t) + normal * OFF, away]
    }
}

/// How far rays start off the surface.
const OFF: f64 = 1e-5;

/// Where light is from: an angle to the normal, to the left.
fn to_light(degrees: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    DVec3::new(-sin, 0.0, cos)
}

/// The angle of the light in the drawing.
const DRAWN_LIGHT: f64 = 66.0;

pub(crate) fn profile(_: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("microsurface", "A surface of small mirrors");
    chapter.text(
        "The microfacet model stands for a rough surface of many small mirrors, each of which sends a \
         ray on by the law of mirroring. Two things keep light back: facets stand in the way of the \
         light for others (shadowing), and of what these send to the eye (masking). Here the mirrors \
         are really there, and rays are followed from one to the next.",
    );
    let figure = drawing(&mut chapter)?;
    chapter.figures(vec![figure]);
    Ok(chapter)
}

/// Corners of the profile.
const CORNERS: u32 = 17;

/// A profile of grooves, drawn out along y so that rays in the plane y = 0 stay in it.
fn grooves() -> Result<(Vec<DVec3>, Surface), GalleryError> {
    let mut random = Random(11);
    let mut profile = Vec::new();
    for corner in 0..CORNERS {
        let x = (f64::from(corner) + 0.5 * (random.next() - 0.5)) / f64::from(CORNERS - 1);
        let height = if corner % 2 == 0 { 0.01 } else { 0.06 } + 0.05 * random.next();
        profile.push(DVec3::new(x, 0.0, height));
    }
    let mut positions = Vec::new();
    for corner in &profile {
        for y in [-1.0, 1.0] {
            positions.push((*corner + DVec3::Y * y).as_vec3().to_array());
        }
    }
    let triangles = (0..CORNERS - 1)
        .flat_map(|at| [[2 * at, 2 * at + 2, 2 * at + 3], [2 * at, 2 * at + 3, 2 * at + 1]])
        .collect();
    Ok((profile, Surface::new(positions, triangles)?))
}

fn drawing(chapter: &mut Chapter) -> Result<Figure, GalleryError> {
    let (profile, surface) = grooves()?;
    let mut svg = Svg::new(660, 196);
    let place = |at: DVec3| [30.0 + at.x * 600.0, 178.0 - at.z * 600.0];
    let towards = to_light(DRAWN_LIGHT);

    let mut body: Vec<_> = profile.iter().map(|&at| place(at)).collect();
    svg.line(Ink::Quiet, 1.5, &body);
    body.extend([[place(profile[profile.len() - 1])[0], 186.0], [place(profile[0])[0], 186.0]]);
    svg.area(Ink::Quiet, 0.18, &body);

    // The lit parts, piece by piece.
    let (mut lit, mut facing) = (0_u32, 0_u32);
    for edge in profile.windows(2) {
        const PIECES: u32 = 24;
        let normal = DVec3::new(edge[0].z - edge[1].z, 0.0, edge[1].x - edge[0].x).normalize();
        let at = |step: f64| edge[0].lerp(edge[1], step / f64::from(PIECES));
        let middles: Vec<_> =
            (0..PIECES).map(|step| [at(f64::from(step) + 0.5) + normal * OFF, towards]).collect();
        let is_facing = normal.dot(towards) > 0.0;
        for (step, blocked) in surface.meet(&middles).iter().enumerate() {
            facing += u32::from(is_facing);
            if is_facing && blocked.is_none() {
                lit += 1;
                let ends = [at(step as f64), at(step as f64 + 1.0)].map(place);
                svg.line(Ink::Amber, 4.0, &ends);
            }
        }
    }

    // Rays at equal distances.
    const RAYS: u32 = 22;
    let (mut escaped, mut struck) = (0, 0);
    for ray in 0..RAYS {
        let x = 0.15 + 0.82 * f64::from(ray) / f64::from(RAYS - 1);
        let foot = DVec3::new(x, 0.0, 0.06);
        let mut path = [foot + towards * 0.4, -towards];
        for bounce in 0..4 {
            let Some(hit) = surface.meet(&[path])[0] else {
                let end = path[0] + path[1] * 0.12;
                let ink = if bounce == 1 { Ink::Blue } else { Ink::Pink };
                escaped += u32::from(bounce == 1);
                svg.arrow(ink, 1.3, place(path[0]), place(end));
                break;
            };
            let next = surface.bounced(path, &hit);
            let ends =
                if bounce == 0 { [next[0] + towards * 0.17, next[0]] } else { [path[0], next[0]] };
            let ink = if bounce == 0 { Ink::Amber } else { Ink::Pink };
            svg.line(ink, if bounce == 0 { 1.0 } else { 1.3 }, &ends.map(place));
            struck += u32::from(bounce == 1);
            path = next;
        }
    }
    svg.text(Ink::Amber, Anchor::Start, [30.0, 24.0], "light, and the surface that it reaches");
    svg.text(Ink::Blue, Anchor::Start, [290.0, 24.0], "mirrored once");
    svg.text(Ink::Pink, Anchor::Start, [400.0, 24.0], "masked: strikes again");
    svg.text(Ink::Quiet, Anchor::Start, [560.0, 24.0], "in shadow");
    let size = svg.size;
    let bytes = svg.finish("Rays on a surface of grooves");
    let alt = "Cross-section of a jagged surface. Light falls from the left; parts of the slopes that \
               face it are in the shadow of ridges; some mirrored rays leave, some strike again.";
    let caption = format!(
        "Light at {DRAWN_LIGHT:.0} degrees. Of the slopes that face it, {:.0} % are reached, the rest \
         is in shadow. Of {RAYS} rays, {escaped} leave after one bounce and {struck} strike again.",
        100.0 * f64::from(lit) / f64::from(facing.max(1))
    );
    Ok(chapter.file("microsurface-rays.svg", bytes, size, alt, &caption))
}

/// Cells along each side of the rough surface.
const CELLS: u32 = 120;
/// Waves that are added up.
const WAVES: u32 = 80;
/// Waves along a side.
const FREQUENCY: f64 = 14.0;
/// GGX's alpha.
const ALPHA: f64 = 0.4;
/// Areas of the surface, each with another steepness.
const AREAS: u32 = 12;
/// Rays that fall on each of them.
const RAYS: u32 = 9_000;
/// Degrees of a step of the histogram.
const STEP: f64 = 5.0;
/// How far off the plane of incidence rays still count, in degrees.
const ASIDE: f64 = 9.0;

/// Surfaces of random waves in all directions, whose slopes together are distributed as GGX's.
///
/// The slopes of one are normally distributed. Over all of them the variance of a slope is
/// alpha^2 / (2 E) with E distributed exponentially, which makes Student's distribution with two
/// degrees of freedom, and that is GGX's of slopes.
fn areas() -> Result<Vec<Surface>, GalleryError> {
    let mut random = Random(3);
    let waves: Vec<[f64; 3]> = (0..WAVES)
        .map(|_| {
            let (sin, cos) = libm::sincos(TAU * random.next());
            let number = TAU * FREQUENCY * (0.7 + 0.6 * random.next());
            [cos * number, sin * number, TAU * random.next()]
        })
        .collect();
    let heights: Vec<f64> = (0..=CELLS)
        .flat_map(|row| (0..=CELLS).map(move |column| [column, row]))
        .map(|at| at.map(|at| f64::from(at) / f64::from(CELLS)))
        .map(|[x, y]| waves.iter().map(|[a, b, phase]| libm::sin(a * x + b * y + phase)).sum())
        .collect();
    let stride = CELLS as usize + 1;
    let squares = heights.chunks_exact(stride).flat_map(|row| row.windows(2));
    let (sum, count) = squares.fold((0.0, 0.0), |(sum, count), pair| {
        let slope = (pair[1] - pair[0]) * f64::from(CELLS);
        (sum + slope * slope, count + 1.0)
    });
    let steepness = f64::sqrt(sum / count);
    let area = |number: u32| {
        let quantile = (f64::from(number) + 0.5) / f64::from(AREAS);
        let deviation = ALPHA / f64::sqrt(-2.0 * libm::log(1.0 - quantile));
        let scale = deviation / steepness;
        let place = |(at, height): (usize, &f64)| {
            let [x, y] = [at % stride, at / stride].map(|at| at as f64 / f64::from(CELLS));
            DVec3::new(x, y, height * scale).as_vec3().to_array()
        };
        let positions = heights.iter().enumerate().map(place).collect();
        let stride = CELLS + 1;
        let cells = (0..CELLS).flat_map(|row| (0..CELLS).map(move |column| row * stride + column));
        let triangles = cells
            .flat_map(|at| [[at, at + 1, at + stride + 1], [at, at + stride + 1, at + stride]]);
        Surface::new(positions, triangles.collect())
    };
    (0..AREAS).map(area).collect()
}

/// The paths of rays that fall on a surface from one direction.
struct Bounced {
    /// The light that goes to the eye at each angle in the plane of incidence, as the equation
    /// counts it.
    sent: Vec<[f64; 2]>,
    /// The part of the rays that leaves after one bounce.
    once: f64,
}

/// The directions in which rays leave a surface after one bounce.
fn leaving(surface: &Surface, towards: DVec3) -> Vec<DVec3> {
    // A sequence that fills the square evenly (Roberts 2018, after the golden ratio).
    let rays: Vec<_> = (0..RAYS)
        .map(|ray| {
            let at = |step: f64| (0.5 + step * f64::from(ray + 1)) % 1.0 * 0.5 + 0.25;
            let foot = DVec3::new(at(0.754_877_666_246_693), at(0.569_840_290_998_053), 0.0);
            [foot + towards * 0.3 / towards.z, -towards]
        })
        .collect();
    let met = surface.meet(&rays);
    let mirrored: Vec<_> = rays
        .iter()
        .zip(&met)
        .filter_map(|(ray, hit)| hit.as_ref().map(|hit| surface.bounced(*ray, hit)))
        .collect();
    let again = surface.meet(&mirrored);
    let left = mirrored.iter().zip(&again).filter(|([_, way], hit)| hit.is_none() && way.z > 0.0);
    left.map(|([_, way], _)| *way).collect()
}

fn bounce(areas: &[Surface], light_degrees: f64) -> Bounced {
    let towards = to_light(light_degrees);
    let leaving: Vec<DVec3> = areas.iter().flat_map(|area| leaving(area, towards)).collect();
    let rays = f64::from(RAYS * AREAS);
    let aside = libm::sin(ASIDE.to_radians());
    let solid_angle = 2.0 * aside * STEP.to_radians();
    let bins = (180.0 / STEP) as usize;
    let mut sums = vec![0.0; bins];
    for direction in &leaving {
        if direction.y.abs() < aside {
            let degrees = libm::atan2(direction.x, direction.z).to_degrees();
            let bin = ((degrees + 90.0) / STEP) as usize;
            sums[bin.min(bins - 1)] += 1.0 / direction.z.max(0.02);
        }
    }
    // pi f (N.L), where f is the radiance over the irradiance.
    let scale = PI * towards.z / (rays * solid_angle);
    let middle = |bin: usize| (bin as f64 + 0.5) * STEP - 90.0;
    Bounced {
        sent: sums.iter().enumerate().map(|(bin, sum)| [middle(bin), sum * scale]).collect(),
        once: leaving.len() as f64 / rays,
    }
}

pub(crate) fn lobe(_: &Studio) -> Result<Chapter, GalleryError> {
    let mut chapter = Chapter::new("microfacets", "The same in space, and the microfacet model");
    let areas = areas()?;
    let roughness = ALPHA.sqrt();
    let mirrors: usize = areas.iter().map(|area| area.triangles.len()).sum();
    chapter.text(format!(
        "{mirrors} mirrors: {AREAS} areas of random waves, from nearly flat to very steep, so that \
         the slopes of all are distributed as in the model (GGX, &alpha; = {ALPHA}). Dots: the light \
         that leaves after one bounce, of {} rays from each direction, counted within {ASIDE} degrees \
         of the plane of incidence. Line: luxel's microfacet material, white metal, of the same \
         &alpha; (roughness &radic;&alpha; = {roughness:.2}).",
        RAYS * AREAS
    ));
    let metal = Material {
        reflection: Reflection::Microfacet,
        diffuse: [1.0; 3],
        k_s: 1.0,
        metallic: 1.0,
        roughness: roughness as f32,
        ..Material::default()
    };
    let mut figures = Vec::new();
    for light in [10.0, 35.0, 60.0] {
        let bounced = bounce(&areas, light);
        let model: Vec<_> = (-178..=178)
            .map(|step| f64::from(step) * 0.5)
            .map(|eye| [eye, sent(&metal, -light, eye)])
            .collect();
        figures.push(polar_plot(&mut chapter, light, &bounced, &model));
    }
    chapter.figures(figures);
    chapter.text(
        "The model's shadowing and masking are Smith's, which takes each facet for itself; on a \
         surface that is really there neighbours are alike. Light that strikes more than once is left \
         out of the model: rough metals are darker than they should be by that part.",
    );
    Ok(chapter)
}

fn polar_plot(chapter: &mut Chapter, light: f64, bounced: &Bounced, model: &[[f64; 2]]) -> Figure {
    const POINT: [f64; 2] = [160.0, 186.0];
    const REACH: f64 = 140.0;
    /// The light at the outer ring.
    const LARGEST: f64 = 3.0;
    let polar = |degrees: f64, distance: f64| {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        [POINT[0] + distance * sin, POINT[1] - distance * cos]
    };
    let mut svg = Svg::new(320, 216);
    for ring in [1.0, 2.0, 3.0] {
        let radius = REACH * ring / LARGEST;
        let arc: Vec<_> = (-90..=90).step_by(3).map(|at| polar(f64::from(at), radius)).collect();
        svg.line(Ink::Line, 1.0, &arc);
        let at = [POINT[0] - radius, POINT[1] + 16.0];
        svg.note(Ink::Quiet, Anchor::Middle, at, &format!("{ring}"));
    }
    svg.line(Ink::Line, 1.0, &[POINT, polar(0.0, REACH)]);
    svg.dashed(Ink::Line, 1.0, &[POINT, polar(light, REACH)]);
    svg.line(Ink::Quiet, 1.5, &[[10.0, POINT[1]], [310.0, POINT[1]]]);
    svg.arrow(Ink::Amber, 1.5, polar(-light, REACH + 22.0), polar(-light, REACH - 28.0));
    let [x, y] = polar(light, REACH);
    svg.note(Ink::Quiet, Anchor::Start, [x + 4.0, y - 2.0], "R");
    // Points beyond the outer ring are not drawn.
    let is_inside = |value: &&[f64; 2]| value[1] <= LARGEST * 1.02 && value[0].abs() < 86.0;
    let place = |&[at, value]: &[f64; 2]| polar(at, value / LARGEST * REACH);
    let points: Vec<_> = model.iter().filter(is_inside).map(place).collect();
    svg.line(Ink::Blue, 2.0, &points);
    for value in bounced.sent.iter().filter(is_inside) {
        svg.dot(Ink::Pink, 2.2, place(value));
    }
    svg.text(Ink::Blue, Anchor::Start, [232.0, POINT[1] + 17.0], "model");
    svg.text(Ink::Pink, Anchor::Start, [276.0, POINT[1] + 17.0], "rays");
    let size = svg.size;
    let title = format!("Rays and model, light at {light} degrees");
    let alt = "Polar plot: dots of the counted rays lie along the line of the model, a lobe to the \
               right of the normal.";
    let caption = format!(
        "Light at {light:.0} degrees: {:.0} % of the rays leave after one bounce, {:.0} % strike \
         again.",
        100.0 * bounced.once,
        100.0 * (1.0 - bounced.once)
    );
    let file = format!("microsurface-{light:.0}.svg");
    chapter.file(&file, svg.finish(&title), size, alt, &caption)
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::lighting::{Material, Reflection};

    #[test]
    fn traced_microfacets_reflect_as_the_model_predicts() {
        let areas = areas().unwrap_or_default();
        assert_eq!(areas.len(), AREAS as usize);
        let metal = Material {
            reflection: Reflection::Microfacet,
            diffuse: [1.0; 3],
            k_s: 1.0,
            metallic: 1.0,
            roughness: ALPHA.sqrt() as f32,
            ..Material::default()
        };
        for light in [10.0, 35.0, 60.0] {
            let bounced = bounce(&areas, light);
            let (mut off, mut whole) = (0.0, 0.0);
            for &[eye, rays] in bounced.sent.iter().filter(|value| value[0].abs() < 75.0) {
                let model = sent(&metal, -light, eye);
                off += (rays - model).abs();
                whole += model;
            }
            // What is off is the counting of rays, and neighbours that shadow each other more alike
            // than Smith has it.
            assert!(off < 0.12 * whole, "light at {light}: {off} of {whole}");
            assert!(bounced.once > 0.8 && bounced.once < 1.0, "{}", bounced.once);
        }
    }
}
