/** The figures of the page on reflection. */

import type { Settings } from "luxel";
import type { Comparison } from "./comparison.ts";
import type { Figure, FigureNumber } from "./figure.ts";

export { firstSettings as firstOfComparison } from "./comparison.ts";
export { firstSettings } from "./figure.ts";

const square: [number, number] = [480, 400];

/** The light's angle about the up axis, from the camera to the right, in degrees. */
function about(value: number): FigureNumber {
  return { name: "about", symbol: "", meaning: "degrees by which the light stands to the right of the eye", value, min: -170, max: 170, step: 1 };
}

/** A light that shines along this direction before the camera. */
function litAlong(direction: readonly number[], more: Settings): Settings {
  const text = direction.map((part) => part.toFixed(5)).join(",");
  return {
    light: [`directional:dir=${text}:in=camera`, "ambient:color=0.04,0.04,0.04"],
    environment: "none",
    azimuth: 0,
    elevation: 0,
    ...more,
  };
}

/** A light that stands to the right of the eye by an angle, and a little above. */
function lit(degrees: number, more: Settings = {}, above = 0.35): Settings {
  const angle = (degrees * Math.PI) / 180;
  return litAlong([-Math.sin(angle), -above, -Math.cos(angle)], more);
}

/** A light that stands above the eye by an angle. */
function litFromAbove(degrees: number, more: Settings): Settings {
  const angle = (degrees * Math.PI) / 180;
  return litAlong([0, -Math.sin(angle), -Math.cos(angle)], more);
}

const ball = "lab-silhouette-cured";
const shininess = (name: string, meaning: string, value: number): FigureNumber => ({
  name, symbol: "", meaning, value, min: 1, max: 256, step: 1,
});

/** One point with its vectors. */
export const VECTORS: Figure[] = [
  {
    id: "vectors",
    demo: ball,
    size: [640, 400],
    pixel: [350, 170],
    numbers: [
      about(55),
      { name: "n", symbol: "n", meaning: "shininess", value: 24, min: 1, max: 256, step: 1 },
      { name: "ks", symbol: "k_s", meaning: "how much of the light is in the highlight", value: 0.8, min: 0, max: 1, step: 0.01 },
    ],
    formula: ["I = k_d O_d max(N.L, 0) + k_s {ks} max(R.V, 0)^n with n = {n}", "the light stands {about} degrees to the right of the eye"],
    settings: ({ about, n, ks }) => lit(about!, { reflection: "phong", shininess: n!, ks: ks! }),
  },
];

export const COMPARISONS: Comparison[] = [
  {
    id: "halfway",
    size: square,
    problem: {
      demo: ball,
      title: "Phong, R·V",
      alt: "A brown ball with a round highlight",
      settings: ({ numbers }) => lit(numbers["about"]!, { reflection: "phong", shininess: numbers["n"]!, ks: 0.8 }),
    },
    cure: {
      demo: ball,
      title: "Blinn–Phong, N·H",
      alt: "The same ball with a larger highlight",
      settings: ({ numbers }) => lit(numbers["about"]!, { reflection: "blinn-phong", shininess: numbers["m"]!, ks: 0.8 }),
    },
    numbers: [shininess("n", "the shininess of Phong's", 20), shininess("m", "the shininess of Blinn's", 20), about(0)],
    lines: ["n = {n} on the left, {m} on the right", "the light stands {about} degrees to the right of the eye"],
  },
  {
    id: "rough",
    size: square,
    problem: {
      demo: ball,
      title: "Lambert",
      alt: "A matt ball that darkens smoothly towards its edge",
      settings: ({ numbers }) => lit(numbers["about"]!, { reflection: "lambert", color: "0.8,0.78,0.75" }),
    },
    cure: {
      demo: ball,
      title: "Oren–Nayar",
      alt: "The same ball, flatter, as the full moon is",
      settings: ({ numbers }) => lit(numbers["about"]!, { reflection: "oren-nayar", color: "0.8,0.78,0.75" }),
    },
    numbers: [about(0)],
    lines: ["the light stands {about} degrees to the right of the eye"],
  },
  {
    id: "facets",
    size: square,
    problem: {
      demo: ball,
      title: "Blinn–Phong",
      alt: "A grey ball with a round highlight",
      settings: ({ numbers }) => litFromAbove(numbers["above"]!, { reflection: "blinn-phong", color: "0.1,0.1,0.12", shininess: numbers["n"]!, ks: 0.5 }),
    },
    cure: {
      demo: ball,
      title: "microfacets",
      alt: "The same ball, whose highlight grows bright when the light grazes it",
      settings: ({ numbers }) =>
        litFromAbove(numbers["above"]!, { reflection: "microfacet", color: "0.1,0.1,0.12", roughness: numbers["roughness"]!, ks: 1 }),
    },
    numbers: [
      { name: "above", symbol: "", meaning: "degrees by which the light stands above the eye", value: 125, min: 0, max: 170, step: 1 },
      shininess("n", "the shininess of Blinn's", 24),
      { name: "roughness", symbol: "", meaning: "the roughness of the facets", value: 0.45, min: 0.05, max: 1, step: 0.01 },
    ],
    lines: ["the light stands {above} degrees above the eye", "n = {n} on the left, roughness {roughness} on the right"],
  },
  {
    id: "retro",
    size: square,
    problem: {
      demo: ball,
      title: "Phong, R·V",
      alt: "A ball whose highlight is where the mirrored light meets the eye",
      settings: ({ numbers }) => lit(numbers["about"]!, { reflection: "phong", shininess: numbers["n"]!, ks: 0.6 }, 0.02),
    },
    cure: {
      demo: ball,
      title: "retro, V·L",
      alt: "The same ball, bright all over when the light is beside the eye",
      settings: ({ numbers }) => lit(numbers["about"]!, { reflection: "retro", shininess: numbers["n"]!, ks: 0.6 }, 0.02),
    },
    numbers: [about(8), shininess("n", "shininess", 40)],
    lines: ["the light stands {about} degrees to the right of the eye", "n = {n}"],
  },
];

/** The table of shininess: rows of k_s, columns of n. */
export const TABLE = {
  demo: ball,
  ks: [0.1, 0.25, 0.5, 1],
  n: [3, 5, 10, 27, 80, 200],
  size: [104, 104] as [number, number],
  settings: (ks: number, n: number, about: number): Settings =>
    lit(about, { reflection: "phong", shininess: n, ks, samples: 4 }),
  about: about(40),
};
