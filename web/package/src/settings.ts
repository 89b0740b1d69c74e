/** Settings of a view: the flags of `luxel render`, by their names and with their values. */

/** A value: a text as on the command line, a number, numbers of a vector or a colour, or a switch. */
export type SettingValue = string | number | boolean | readonly number[] | readonly string[] | null | undefined;

/**
 * The flags of `luxel render` that describe a picture, as `azimuth`, `samples`, `light`, `shadows`. Names have
 * dashes or capitals: `light-rays` is `lightRays`. A list of texts gives a flag several times, as `light` may be.
 */
export interface Settings {
  /** Width and height in pixels; 1280x720 by default. */
  size?: string | readonly [width: number, height: number];
  samples?: 1 | 2 | 4 | 8 | 16 | string;
  azimuth?: number | string;
  elevation?: number | string;
  eye?: readonly number[] | string;
  target?: readonly number[] | string;
  fov?: number | string;
  light?: string | readonly string[];
  ambient?: string | readonly number[];
  background?: string | readonly number[];
  shading?: "flat" | "gouraud" | "phong" | "subdivided" | (string & {});
  shadows?: boolean;
  ao?: boolean | number | string;
  ground?: boolean;
  exposure?: number | "auto" | (string & {});
  tone?: "none" | "neutral" | "aces" | "agx" | (string & {});
  [name: string]: SettingValue;
}

/** Pairs of names and texts, as the worker takes them. */
export function pairs(settings: Settings): [name: string, text: string][] {
  const list: [string, string][] = [];
  for (const [key, value] of Object.entries(settings)) {
    const name = key.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
    if (value === undefined || value === null || value === false) {
      continue;
    }
    if (value === true) {
      list.push([name, ""]);
    } else if (Array.isArray(value) && value.every((item) => typeof item === "string")) {
      list.push(...value.map((item): [string, string] => [name, item]));
    } else if (Array.isArray(value)) {
      list.push([name, value.join(name === "size" ? "x" : ",")]);
    } else {
      list.push([name, String(value)]);
    }
  }
  return list;
}
