//! Terms of light of sixteen triangles, side by side: which are kept, and how they are computed.

use super::places::Places;
use crate::context::ShadingContext;
use crate::material::{SurfaceWitness, lights_with};
use crate::shade::place_terms::{PlaceTerms, Term, TermsOfPlace, kept_of};
use luxel_lighting::{LightTerms, Terms, Witness};
use luxel_math::{LANES, Lanes, Rgb, SplitLanes};

/// The terms of light that are read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct WantedTerms {
    /// Of the scene and of lights.
    pub(crate) ambient: bool,
    pub(crate) diffuse: bool,
    pub(crate) specular: bool,
    pub(crate) emission: bool,
    pub(crate) environment: bool,
    pub(crate) n_dot_l: bool,
}

impl WantedTerms {
    /// Whether any is read.
    pub(crate) fn any(self) -> bool {
        self != Self::default()
    }
}

/// Which column holds which term, three for a colour; `None` for a term that is not kept.
#[derive(Default)]
pub(crate) struct TermLayout {
    kept: Option<usize>,
    emission: Option<usize>,
    scene_ambient: Option<usize>,
    environment: Option<usize>,
    /// Of the first light, as the next three.
    ambient: Option<usize>,
    diffuse: Option<usize>,
    specular: Option<usize>,
    n_dot_l: Option<usize>,
    /// Columns from one light to the next.
    step: usize,
    lights: usize,
    columns: usize,
}

impl TermLayout {
    /// Of what is wanted; with what clamping leaves, if light is clamped.
    pub(super) fn new(wanted: WantedTerms, is_clamped: bool, lights: usize) -> Self {
        let mut columns = 0;
        let mut next = |is_wanted: bool, count: usize| {
            let first = columns;
            columns += if is_wanted { count } else { 0 };
            is_wanted.then_some(first)
        };
        let kept = next(is_clamped, 3);
        let emission = next(wanted.emission, 3);
        let scene_ambient = next(wanted.ambient, 3);
        let environment = next(wanted.environment, 3);
        let before = next(true, 0).unwrap_or(0);
        let ambient = next(wanted.ambient, 3);
        let diffuse = next(wanted.diffuse, 3);
        let specular = next(wanted.specular, 3);
        let n_dot_l = next(wanted.n_dot_l, 1);
        let step = columns - before;
        let columns = before + step * lights;
        Self {
            kept,
            emission,
            scene_ambient,
            environment,
            ambient,
            diffuse,
            specular,
            n_dot_l,
            step,
            lights,
            columns,
        }
    }

    /// Rows of eight that one place takes.
    pub(super) fn rows(&self) -> usize {
        self.columns.div_ceil(8)
    }

    /// The first column of a term.
    #[inline(always)]
    fn column(&self, term: Term) -> Option<usize> {
        match term {
            Term::Emission => self.emission,
            Term::SceneAmbient => self.scene_ambient,
            Term::Environment => self.environment,
            Term::Ambient(light) => self.of_light(self.ambient, light),
            Term::Diffuse(light) => self.of_light(self.diffuse, light),
            Term::Specular(light) => self.of_light(self.specular, light),
        }
    }

    /// The column of N.L of a light.
    #[inline(always)]
    fn n_dot_l(&self, light: usize) -> Option<usize> {
        self.of_light(self.n_dot_l, light)
    }

    /// The column of a light's term, by that of the first light's.
    #[inline(always)]
    fn of_light(&self, first: Option<usize>, light: usize) -> Option<usize> {
        Some(first? + light * self.step)
    }
}

/// The terms of one place of each lane's triangle.
#[derive(Default)]
pub(crate) struct TermColumns(pub(super) Vec<[f32; LANES]>);

impl TermColumns {
    /// Makes room for all columns, in whole rows of eight.
    pub(super) fn resize(&mut self, layout: &TermLayout) {
        self.0.resize(8 * layout.rows(), [0.0; LANES]);
    }

    /// Writes a colour from a lane on, if it is kept.
    #[inline(always)]
    fn put<N: Lanes>(&mut self, column: Option<usize>, first: usize, color: Rgb<N>) {
        let Some(column) = column else { return };
        let Some(columns) = self.0.get_mut(column..column + 3) else { return };
        let [r, g, b] = columns else { return };
        color.r.store(r, first);
        color.g.store(g, first);
        color.b.store(b, first);
    }

    /// Writes the terms of one lane's place.
    pub(super) fn put_lane(&mut self, layout: &TermLayout, lane: usize, place: &PlaceTerms) {
        let mut put = |column: Option<usize>, values: &[f32]| {
            let Some(first) = column else { return };
            for (column, value) in self.0.iter_mut().skip(first).zip(values) {
                column[lane & (LANES - 1)] = *value;
            }
        };
        put(layout.kept, &place.kept);
        let others = [Term::Emission, Term::SceneAmbient, Term::Environment];
        let of_lights = (0..layout.lights)
            .flat_map(|light| [Term::Ambient(light), Term::Diffuse(light), Term::Specular(light)]);
        for term in others.into_iter().chain(of_lights) {
            let color = place.term(0.0, term).map(|color| color.lane(0));
            put(layout.column(term), &color.unwrap_or_default());
        }
        for light in 0..layout.lights {
            put(layout.n_dot_l(light), &[place.n_dot_l(0.0, light).unwrap_or_default()]);
        }
    }

    #[inline(always)]
    fn color<N: Lanes>(&self, simd: N, column: usize) -> Rgb<N> {
        let column = |number: usize| simd.load(&self.0[column + number], 0);
        Rgb::new(column(0), column(1), column(2))
    }
}

impl<N: Lanes> TermsOfPlace<N> for (&TermLayout, &TermColumns) {
    #[inline(always)]
    fn kept(self, simd: N) -> Option<Rgb<N>> {
        color(self, simd, self.0.kept)
    }

    #[inline(always)]
    fn term(self, simd: N, term: Term) -> Option<Rgb<N>> {
        color(self, simd, self.0.column(term))
    }

    #[inline(always)]
    fn lights(self) -> usize {
        self.0.lights
    }

    #[inline(always)]
    fn n_dot_l(self, simd: N, light: usize) -> Option<N> {
        let column = self.0.n_dot_l(light)?;
        Some(simd.load(&self.1.0[column], 0))
    }
}

#[inline(always)]
fn color<N: Lanes>(
    (_, columns): (&TermLayout, &TermColumns),
    simd: N,
    column: Option<usize>,
) -> Option<Rgb<N>> {
    Some(columns.color(simd, column?))
}

/// Places of triangles of one material, lit together.
pub(super) struct Lit<'a> {
    pub(super) scene: &'a ShadingContext<'a>,
    /// The material's number, and the lanes.
    pub(super) of: (usize, u32),
    pub(super) at: &'a Places,
    pub(super) layout: &'a TermLayout,
    /// Of each of a triangle's places.
    pub(super) terms: &'a mut [TermColumns],
}

impl SplitLanes for Lit<'_> {
    #[inline(always)]
    fn part<N: Lanes>(&mut self, simd: N, first: usize) {
        let (number, lanes) = self.of;
        let lanes = lanes >> first & simd.all_lanes();
        if lanes == 0 {
            return;
        }
        let Self { scene, layout, .. } = *self;
        for (place, terms) in self.terms.iter_mut().enumerate() {
            let attributes = self.at.attributes(simd, place, first);
            let sum = Rgb::black(simd);
            let mut heard = ColumnWitness { layout, first, sum, into: terms };
            let light = lights_with(scene, &attributes, (number, lanes), &mut heard);
            let sum = heard.sum;
            if layout.kept.is_some() {
                terms.put(layout.kept, first, kept_of(sum, light));
            }
        }
    }
}

/// Writes terms into columns from a lane on.
struct ColumnWitness<'t, N> {
    layout: &'t TermLayout,
    first: usize,
    /// Of all terms.
    sum: Rgb<N>,
    into: &'t mut TermColumns,
}

impl<N: Lanes> Witness<N> for ColumnWitness<'_, N> {
    #[inline(always)]
    fn light(&mut self, index: usize, terms: &LightTerms<N>) {
        let layout = self.layout;
        self.into.put(layout.column(Term::Ambient(index)), self.first, terms.ambient);
        self.into.put(layout.column(Term::Diffuse(index)), self.first, terms.diffuse);
        self.into.put(layout.column(Term::Specular(index)), self.first, terms.specular);
        let n_dot_l = layout.n_dot_l(index);
        if let Some(column) = n_dot_l.and_then(|column| self.into.0.get_mut(column)) {
            terms.n_dot_l.store(column, self.first);
        }
    }

    #[inline(always)]
    fn terms(&mut self, terms: &Terms<N>) {
        let TermLayout { emission, scene_ambient, environment, .. } = *self.layout;
        self.into.put(emission, self.first, terms.emission);
        self.into.put(scene_ambient, self.first, terms.scene_ambient);
        self.into.put(environment, self.first, terms.environment);
        self.sum = terms.sum;
    }
}

impl<N: Lanes> SurfaceWitness<N> for ColumnWitness<'_, N> {}
