/** What a live figure is: numbers that a reader may drag, and the picture that they make. No document is needed. */

import type { Settings } from "luxel";

/** A number that can be dragged. */
export interface FigureNumber {
  name: string;
  /** As the formula writes it; empty for a number that stands in a call. */
  symbol: string;
  /** What it is, for those who hear the page. */
  meaning: string;
  value: number;
  min: number;
  max: number;
  step: number;
}

export type Values = Record<string, number>;

export interface Figure {
  id: string;
  demo: string;
  size: [width: number, height: number];
  /** The pixel whose ledger is shown at first. */
  pixel: [x: number, y: number];
  numbers: FigureNumber[];
  /**
   * The formula, line by line: words are symbols, `{name}` is a number, and the rest stands as it is.
   */
  formula: string[];
  /** The same in other words, each a text with `{name}`s: calls of OpenGL, for example. */
  /** Whether the matrices of the camera stand below. */
  showsMatrices?: boolean;
  tutors?: { title: string; lines: string[] }[];
  settings(values: Values): Settings;
}

/** The settings of a figure as its numbers are at first. */
export function firstSettings(figure: Figure): Settings {
  const values = Object.fromEntries(figure.numbers.map(({ name, value }) => [name, value]));
  return { size: figure.size, ...figure.settings(values) };
}

/** A number between 0 and 1. */
export function share(name: string, symbol: string, meaning: string, value: number): FigureNumber {
  return { name, symbol, meaning, value, min: 0, max: 1, step: 0.01 };
}
