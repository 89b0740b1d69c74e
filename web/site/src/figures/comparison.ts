/** What a live comparison is: a problem and its cure, drawn from the same numbers. */

import type { Settings } from "luxel";
import type { FigureNumber } from "./figure.ts";

/** A choice of the reader. */
export interface FigureChoice {
  name: string;
  label: string;
  options: string[];
  value: string;
}

export type ComparedValues = { numbers: Record<string, number>; choices: Record<string, string> };

/** One of the two pictures. */
export interface Side {
  demo: string;
  /** What it is, in few words. */
  title: string;
  alt: string;
  settings(values: ComparedValues): Settings;
}

export interface Comparison {
  id: string;
  size: [width: number, height: number];
  problem: Side;
  cure: Side;
  numbers: FigureNumber[];
  choices?: FigureChoice[];
  /** Lines of text with `{name}`s of numbers. */
  lines: string[];
  /** Whether the intensity along the middle row is plotted below. */
  plot?: boolean;
}

/** The settings of both sides as their numbers are at first. */
export function firstSettings(comparison: Comparison): { demo: string; settings: Settings }[] {
  const { numbers, choices = [], size } = comparison;
  const values = {
    numbers: Object.fromEntries(numbers.map(({ name, value }) => [name, value])),
    choices: Object.fromEntries(choices.map(({ name, value }) => [name, value])),
  };
  return [comparison.problem, comparison.cure].map(({ demo, settings }) => ({
    demo,
    settings: { size, ...settings(values) },
  }));
}
