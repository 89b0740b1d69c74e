/** The figures of the page on light. */

export { firstSettings } from "./figure.ts";

import { share, type Figure, type FigureNumber } from "./figure.ts";

const size: [number, number] = [640, 400];

function place(axis: string, value: number, least = -8, most = 8): FigureNumber {
  return { name: axis, symbol: "", meaning: `the light's ${axis}`, value, min: least, max: most, step: 0.1 };
}

/** Linear colour of a lamp from three numbers. */
const rgb = (...parts: (number | undefined)[]): string => parts.join(",");

export const FIGURES: Figure[] = [
  {
    id: "ambient",
    demo: "teapot",
    size,
    pixel: [300, 240],
    numbers: [share("Ia", "I_a", "ambient light", 0.4), share("ka", "k_a", "how much ambient light the surface reflects", 1)],
    formula: ["I = I_a {Ia} k_a {ka} O_a"],
    settings: ({ Ia, ka }) => ({ light: `ambient:color=${rgb(Ia, Ia, Ia)}`, ka: ka!, color: "0.52,0.18,0.06", ks: 0 }),
  },
  {
    id: "diffuse",
    demo: "teapot",
    size,
    pixel: [300, 240],
    numbers: [
      share("Id", "I_d", "the light's diffuse intensity", 0.9),
      share("kd", "k_d", "how much light the surface reflects to all sides", 1),
      place("x", -1, -1, 1),
      place("y", -1, -1, 1),
      place("z", -0.6, -1, 1),
    ],
    formula: ["I = I_d {Id} k_d {kd} O_d max(N.L, 0)", "L = −( {x} , {y} , {z} ) / |...|"],
    settings: ({ Id, kd, x, y, z }) => ({
      light: `directional:dir=${x},${y},${x === 0 && y === 0 && z === 0 ? -1 : z}:diffuse=${rgb(Id, Id, Id)}`,
      kd: kd!,
      ks: 0,
      reflection: "lambert",
    }),
  },
  {
    id: "attenuation",
    demo: "lab-contact",
    size,
    pixel: [330, 285],
    numbers: [
      { name: "c1", symbol: "c_1", meaning: "constant attenuation", value: 0.3, min: 0, max: 2, step: 0.01 },
      { name: "c2", symbol: "c_2", meaning: "linear attenuation", value: 0.1, min: 0, max: 1, step: 0.01 },
      { name: "c3", symbol: "c_3", meaning: "quadratic attenuation", value: 0.2, min: 0, max: 1, step: 0.01 },
      { name: "height", symbol: "d", meaning: "the lamp's height over the board", value: 1.8, min: 0.1, max: 6, step: 0.1 },
    ],
    formula: ["f = 1 / ( c_1 {c1} + c_2 {c2} d + c_3 {c3} d² )", "the lamp hangs {height} over the board"],
    settings: ({ c1, c2, c3, height }) => ({
      light: [
        `point:pos=0,${height},0:attenuation=${c1! + c2! + c3! > 0 ? c1 : 0.01},${c2},${c3}`,
        "ambient:color=0.04,0.04,0.04",
      ],
      ks: 0,
    }),
  },
  {
    id: "spot",
    demo: "lab-contact",
    size,
    pixel: [330, 285],
    numbers: [
      { name: "cutoff", symbol: "cutoff", meaning: "half of the cone's angle", value: 28, min: 0, max: 90, step: 1 },
      { name: "exponent", symbol: "e", meaning: "how much the light gathers about the axis", value: 6, min: 0, max: 64, step: 0.5 },
      place("x", 0.4, -3, 3),
      place("z", 0.6, -3, 3),
    ],
    formula: ["f = max(−L.D, 0)^e with e = {exponent} , and 0 beyond the cutoff of {cutoff} degrees", "the axis D meets the board at ( {x} , 0 , {z} )"],
    settings: ({ cutoff, exponent, x, z }) => ({
      light: [`spot:pos=0,3,0:dir=${x},-3,${z}:cutoff=${cutoff}:exponent=${exponent}`, "ambient:color=0.04,0.04,0.04"],
      ks: 0,
    }),
  },
  {
    id: "cueing",
    demo: "spheres",
    size,
    pixel: [320, 200],
    numbers: [
      { name: "near", symbol: "z_f", meaning: "where it begins", value: 6, min: 0, max: 30, step: 0.5 },
      { name: "far", symbol: "z_b", meaning: "where it ends", value: 16, min: 0.5, max: 40, step: 0.5 },
      share("front", "s_f", "the part of the light that is left at the front", 1),
      share("back", "s_b", "the part of the light that is left at the back", 0.15),
    ],
    formula: ["I' = s I + (1 − s) I_dc", "s from s_f {front} at z_f {near} to s_b {back} at z_b {far}"],
    settings: ({ near, far, front, back }) => ({
      azimuth: 65,
      elevation: 12,
      fog: `near=${near}:far=${Math.max(far!, near! + 0.5)}:front=${front}:back=${back}:color=0.75,0.8,0.85`,
    }),
  },
  {
    id: "colours",
    demo: "teapot",
    size,
    pixel: [300, 240],
    numbers: [
      share("Ir", "I_r", "red of the light", 1),
      share("Ig", "I_g", "green of the light", 0.3),
      share("Ib", "I_b", "blue of the light", 0.3),
      share("Or", "O_r", "red of the surface", 0.2),
      share("Og", "O_g", "green of the surface", 0.7),
      share("Ob", "O_b", "blue of the surface", 0.3),
    ],
    formula: ["light ( {Ir} , {Ig} , {Ib} ) × surface ( {Or} , {Og} , {Ob} )", "I = I_d k_d O_d max(N.L, 0), for red, green and blue apart"],
    settings: ({ Ir, Ig, Ib, Or, Og, Ob }) => ({
      light: [`directional:dir=1,-1,-1:in=camera:diffuse=${rgb(Ir, Ig, Ib)}:specular=0,0,0`, "ambient:color=0.05,0.05,0.05"],
      color: rgb(Or, Og, Ob),
    }),
  },
  {
    id: "tutor",
    demo: "teapot",
    size,
    pixel: [330, 210],
    numbers: [
      place("x", 6), place("y", 7), place("z", 5),
      share("ar", "", "red of GL_AMBIENT", 0.1), share("ag", "", "green of GL_AMBIENT", 0.1), share("ab", "", "blue of GL_AMBIENT", 0.1),
      share("dr", "", "red of GL_DIFFUSE", 1), share("dg", "", "green of GL_DIFFUSE", 0.95), share("db", "", "blue of GL_DIFFUSE", 0.85),
      share("sr", "", "red of GL_SPECULAR", 1), share("sg", "", "green of GL_SPECULAR", 1), share("sb", "", "blue of GL_SPECULAR", 1),
      { name: "c1", symbol: "", meaning: "constant attenuation", value: 1, min: 0, max: 2, step: 0.01 },
      { name: "c2", symbol: "", meaning: "linear attenuation", value: 0, min: 0, max: 1, step: 0.01 },
      { name: "c3", symbol: "", meaning: "quadratic attenuation", value: 0, min: 0, max: 0.2, step: 0.001 },
      share("mr", "", "red of the material", 0.3), share("mg", "", "green of the material", 0.4), share("mb", "", "blue of the material", 0.7),
      share("ks", "", "grey of the material's GL_SPECULAR", 0.5),
      { name: "n", symbol: "", meaning: "the material's shininess", value: 48, min: 0, max: 128, step: 1 },
      share("gr", "", "GL_LIGHT_MODEL_AMBIENT", 0.1),
    ],
    formula: [],
    tutors: [
      {
        title: "C",
        lines: [
          "GLfloat position[] = { {x} , {y} , {z} , 1 };",
          "GLfloat ambient[] = { {ar} , {ag} , {ab} , 1 };",
          "GLfloat diffuse[] = { {dr} , {dg} , {db} , 1 };",
          "GLfloat specular[] = { {sr} , {sg} , {sb} , 1 };",
          "/* After gluLookAt, so that the light stands in the world. */",
          "glLightfv(GL_LIGHT0, GL_POSITION, position);",
          "glLightfv(GL_LIGHT0, GL_AMBIENT, ambient);",
          "glLightfv(GL_LIGHT0, GL_DIFFUSE, diffuse);",
          "glLightfv(GL_LIGHT0, GL_SPECULAR, specular);",
          "glLightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, {c1} );",
          "glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, {c2} );",
          "glLightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, {c3} );",
          "GLfloat surface[] = { {mr} , {mg} , {mb} , 1 };",
          "GLfloat shine[] = { {ks} , {ks} , {ks} , 1 };",
          "GLfloat room[] = { {gr} , {gr} , {gr} , 1 };",
          "glMaterialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, surface);",
          "glMaterialfv(GL_FRONT, GL_SPECULAR, shine);",
          "glMaterialf(GL_FRONT, GL_SHININESS, {n} );",
          "glLightModelfv(GL_LIGHT_MODEL_AMBIENT, room);",
          "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);",
        ],
      },
      {
        title: "luxel",
        lines: [
          "luxel render demo:teapot \\",
          "  --light point:pos={x},{y},{z}:ambient={ar},{ag},{ab}:diffuse={dr},{dg},{db}:specular={sr},{sg},{sb}:attenuation={c1},{c2},{c3} \\",
          "  --color {mr},{mg},{mb} --ks {ks} --shininess {n} --ambient {gr},{gr},{gr} -o teapot.png",
        ],
      },
    ],
    settings: (v) => ({
      light: `point:pos=${rgb(v["x"], v["y"], v["z"])}:ambient=${rgb(v["ar"], v["ag"], v["ab"])}:diffuse=${rgb(v["dr"], v["dg"], v["db"])}:specular=${rgb(v["sr"], v["sg"], v["sb"])}:attenuation=${v["c1"]! + v["c2"]! + v["c3"]! > 0 ? v["c1"] : 0.01},${v["c2"]},${v["c3"]}`,
      color: rgb(v["mr"], v["mg"], v["mb"]),
      ks: v["ks"]!,
      shininess: v["n"]!,
      ambient: rgb(v["gr"], v["gr"], v["gr"]),
    }),
  },
];
