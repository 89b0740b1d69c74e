/** The figures of the page on navigation whose pictures follow from numbers alone. */

import type { Figure, FigureNumber } from "./figure.ts";

export { firstSettings } from "./figure.ts";

function coordinate(name: string, meaning: string, value: number): FigureNumber {
  return { name, symbol: "", meaning, value, min: -12, max: 12, step: 0.1 };
}

export const FIGURES: Figure[] = [
  {
    id: "look-at",
    demo: "welcome",
    size: [640, 400],
    pixel: [320, 200],
    showsMatrices: true,
    numbers: [
      coordinate("ex", "the eye's x", 5),
      coordinate("ey", "the eye's y", 4),
      coordinate("ez", "the eye's z", 9),
      coordinate("tx", "the target's x", 0),
      coordinate("ty", "the target's y", 1),
      coordinate("tz", "the target's z", 0),
      { name: "ux", symbol: "", meaning: "x of the up direction", value: 0, min: -1, max: 1, step: 0.01 },
      { name: "fov", symbol: "", meaning: "the field of view from bottom to top, in degrees", value: 40, min: 5, max: 150, step: 1 },
      { name: "near", symbol: "", meaning: "the distance of the near plane", value: 1, min: 0.1, max: 9.9, step: 0.1 },
      { name: "far", symbol: "", meaning: "the distance of the far plane", value: 60, min: 10, max: 100, step: 0.5 },
    ],
    formula: [],
    tutors: [
      {
        title: "C",
        lines: [
          "glMatrixMode(GL_PROJECTION);",
          "glLoadIdentity();",
          "gluPerspective( {fov} , 640.0 / 400.0, {near} , {far} );",
          "glMatrixMode(GL_MODELVIEW);",
          "glLoadIdentity();",
          "gluLookAt( {ex} , {ey} , {ez} ,   {tx} , {ty} , {tz} ,   {ux} , 1, 0);",
        ],
      },
      {
        title: "luxel",
        lines: [
          "luxel render demo:welcome --eye {ex},{ey},{ez} --target {tx},{ty},{tz} --up {ux},1,0 --fov {fov} --near {near} --far {far} -o picture.png",
        ],
      },
    ],
    settings: ({ ex, ey, ez, tx, ty, tz, ux, fov, near, far }) => ({
      // Eye and target at one place show no direction.
      eye: `${ex},${ey},${ex === tx && ey === ty && ez === tz ? ez! + 0.01 : ez}`,
      target: `${tx},${ty},${tz}`,
      up: `${ux},1,0`,
      fov: fov!,
      near: near!,
      far: far!,
    }),
  },
];
