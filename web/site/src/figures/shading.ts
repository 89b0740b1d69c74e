/** The figures of the page on shading. */

import type { Settings } from "luxel";
import type { Comparison, FigureChoice } from "./comparison.ts";
import type { FigureNumber } from "./figure.ts";

export { firstSettings } from "./comparison.ts";

const MODES = ["flat", "gouraud", "phong", "subdivided"];

function angle(name: string, meaning: string, value: number, min: number, max: number): FigureNumber {
  return { name, symbol: "", meaning, value, min, max, step: 1 };
}

function mode(name: string, label: string, value: string): FigureChoice {
  return { name, label, options: MODES, value };
}

/** A camera at a distance from the origin, by angles about y and above the ground, in degrees. */
function around(azimuth: number, elevation: number, distance: number, fov: number): Settings {
  const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  const at = [Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e)];
  return { eye: at.map((part) => Number((part * distance).toFixed(6))).join(","), target: "0,0,0", fov };
}

const square: [number, number] = [480, 400];
const wide: [number, number] = [640, 400];

export const FIGURES: Comparison[] = [
  {
    id: "modes",
    size: square,
    problem: {
      demo: "lab-highlight",
      title: "left of the divider",
      alt: "A brown ball lit at its corners: a dim, angular smear of light",
      settings: ({ numbers, choices }) => ({ shading: choices["left"]!, shininess: numbers["n"]! }),
    },
    cure: {
      demo: "lab-highlight",
      title: "right of it",
      alt: "The same ball lit at every pixel: a small, round, bright highlight",
      settings: ({ numbers, choices }) => ({ shading: choices["right"]!, shininess: numbers["n"]! }),
    },
    choices: [mode("left", "Left", "gouraud"), mode("right", "Right", "phong")],
    numbers: [{ name: "n", symbol: "n", meaning: "shininess", value: 60, min: 1, max: 256, step: 1 }],
    lines: ["shininess n = {n}"],
  },
  {
    id: "mach",
    size: square,
    problem: {
      demo: "lab-mach",
      title: "Gouraud, or flat",
      alt: "A grey column of twelve faces with bright and dark lines along its edges",
      settings: ({ numbers, choices }) => ({ ...around(numbers["turn"]!, 0, 7, 18), shading: choices["left"]! }),
    },
    cure: {
      demo: "lab-mach",
      title: "Phong",
      alt: "The same column, smooth",
      settings: ({ numbers }) => ({ ...around(numbers["turn"]!, 0, 7, 18), shading: "phong" }),
    },
    choices: [{ name: "left", label: "Left", options: ["gouraud", "flat"], value: "gouraud" }],
    numbers: [angle("turn", "degrees by which the column is turned", 0, -30, 30)],
    lines: ["turned by {turn} degrees"],
    plot: true,
  },
  {
    id: "silhouette",
    size: square,
    problem: {
      demo: "lab-silhouette",
      title: "12 faces round",
      alt: "A glossy brown ball, smoothly shaded, whose outline is visibly made of straight pieces",
      settings: ({ numbers }) => ({ azimuth: numbers["azimuth"]!, elevation: numbers["elevation"]! }),
    },
    cure: {
      demo: "lab-silhouette-cured",
      title: "192 faces round",
      alt: "The same ball with a round outline",
      settings: ({ numbers }) => ({ azimuth: numbers["azimuth"]!, elevation: numbers["elevation"]! }),
    },
    numbers: [angle("azimuth", "degrees about the ball", 20, -90, 90), angle("elevation", "degrees above it", 15, -90, 90)],
    lines: ["seen from {azimuth} degrees about and {elevation} degrees above"],
  },
  {
    id: "perspective",
    size: wide,
    problem: {
      demo: "lab-perspective",
      title: "linear in the window",
      alt: "A chequered floor whose fields bend at the diagonal and don't shrink with distance",
      settings: ({ numbers }) => ({ ...around(numbers["turn"]!, numbers["height"]!, 8, 40), interpolation: "screen" }),
    },
    cure: {
      demo: "lab-perspective",
      title: "linear in space",
      alt: "The same floor, its fields straight and smaller the farther away they are",
      settings: ({ numbers }) => around(numbers["turn"]!, numbers["height"]!, 8, 40),
    },
    numbers: [angle("turn", "degrees about the floor", 10, -80, 80), angle("height", "degrees above it", 18, 8, 90)],
    lines: ["seen from {turn} degrees about and {height} degrees above: from straight above, both are right"],
  },
  {
    id: "rolling",
    size: square,
    problem: {
      demo: "lab-rolling",
      title: "by scan lines",
      alt: "A square with two bright and two dark corners, with a bright band that leans",
      settings: ({ numbers }) => ({ ...rolled(numbers["roll"]!), interpolation: "scanline" }),
    },
    cure: {
      demo: "lab-rolling-cured",
      title: "cut into 16 × 16",
      alt: "The same square, its colours fixed to it",
      settings: ({ numbers }) => ({ ...rolled(numbers["roll"]!), interpolation: "scanline" }),
    },
    numbers: [angle("roll", "degrees by which the square is rolled", 30, 0, 90)],
    lines: ["rolled by {roll} degrees"],
  },
  {
    id: "shared",
    size: wide,
    problem: {
      demo: "lab-t-junction",
      title: "corners on one side",
      alt: "A wavy sheet with a hard vertical line in its middle",
      settings: ({ numbers }) => ({ ...around(numbers["turn"]!, 4, 5, 28), shading: "gouraud" }),
    },
    cure: {
      demo: "lab-t-junction-cured",
      title: "corners on both",
      alt: "The same sheet, smooth from left to right",
      settings: ({ numbers }) => ({ ...around(numbers["turn"]!, 4, 5, 28), shading: "gouraud" }),
    },
    numbers: [angle("turn", "degrees about the sheet", 6, -60, 60)],
    lines: ["seen from {turn} degrees about"],
  },
  {
    id: "geometry",
    size: wide,
    problem: {
      demo: "lab-corrugated",
      title: "averaged over all faces",
      alt: "A blue-grey sheet of one even colour, with a zigzag for an edge",
      settings: ({ numbers }) => around(numbers["turn"]!, numbers["height"]!, 5.5, 34),
    },
    cure: {
      demo: "lab-corrugated",
      title: "not across sharp edges",
      alt: "The same sheet with bright and dark slopes in turns",
      settings: ({ numbers }) => ({ ...around(numbers["turn"]!, numbers["height"]!, 5.5, 34), normals: "mean", crease: numbers["crease"]! }),
    },
    numbers: [
      angle("turn", "degrees about the sheet", 12, -80, 80),
      angle("height", "degrees above it", 35, 10, 90),
      angle("crease", "edges sharper than this stay sharp, in degrees", 40, 0, 180),
    ],
    lines: ["seen from {turn} degrees about and {height} degrees above", "averages stop at edges of more than {crease} degrees"],
  },
  {
    id: "highlight",
    size: wide,
    problem: {
      demo: "lab-lamp",
      title: "lit at four corners",
      alt: "A teal panel, dull, without any highlight",
      settings: ({ numbers }) => ({ light: lamp(numbers), shading: "gouraud" }),
    },
    cure: {
      demo: "lab-lamp",
      title: "lit at every pixel",
      alt: "The same panel with a pool of light and a white highlight in it",
      settings: ({ numbers }) => ({ light: lamp(numbers) }),
    },
    numbers: [
      { name: "x", symbol: "", meaning: "the lamp's x", value: -0.3, min: -2, max: 2, step: 0.1 },
      { name: "y", symbol: "", meaning: "the lamp's y", value: 0.3, min: -2, max: 2, step: 0.1 },
      { name: "z", symbol: "", meaning: "the lamp's distance from the panel", value: 1.1, min: 0.2, max: 8, step: 0.1 },
    ],
    lines: ["the lamp is at ( {x} , {y} , {z} ): the nearer, the more is missed"],
  },
  {
    id: "length",
    size: square,
    problem: {
      demo: "lab-highlight",
      title: "as interpolation leaves them",
      alt: "A brown ball on which a dim patch is left of the highlight",
      settings: ({ numbers }) => ({ "normal-length": "interpolated", shininess: numbers["n"]! }),
    },
    cure: {
      demo: "lab-highlight",
      title: "of unit length",
      alt: "The same ball with one round highlight",
      settings: ({ numbers }) => ({ shininess: numbers["n"]! }),
    },
    numbers: [{ name: "n", symbol: "n", meaning: "shininess", value: 60, min: 1, max: 256, step: 1 }],
    lines: ["shininess n = {n}: the power makes much of a little"],
  },
];

function rolled(degrees: number): Settings {
  const a = (degrees * Math.PI) / 180;
  const up = [Math.sin(a), Math.cos(a), 0].map((part) => part.toFixed(6)).join(",");
  return { eye: "0,0,7", target: "0,0,0", up, fov: 25 };
}

function lamp({ x, y, z }: Record<string, number>): string[] {
  return [`point:pos=${x},${y},${z}:attenuation=1,0.2,0.3`, "ambient:color=0.15,0.15,0.15"];
}
