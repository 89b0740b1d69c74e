/** The answers of luxel, as it writes them with `--json`. */

import type { Pixels } from "./protocol.ts";

export type Vector = [x: number, y: number, z: number];
export type Color = [red: number, green: number, blue: number];

/** The layers of a picture. */
export type LayerName =
  | "depth"
  | "z"
  | "normal"
  | "position"
  | "object"
  | "triangle"
  | "barycentric"
  | "uv"
  | "ambient"
  | "diffuse"
  | "specular"
  | "emission"
  | "environment"
  | "fog"
  | "n_dot_l"
  | "openness"
  | `light:${string}`
  | `shadow:${string}`;

/** A surface at a point of the picture. */
export interface Hit {
  /** Its place in the scene's list of objects. */
  index: number;
  object: string;
  path: string[];
  /** Its number in the object; null of points and lines. */
  triangle: number | null;
  barycentric: Vector;
  position: Vector;
  normal: Vector;
  geometric_normal: Vector;
  uv: [number, number] | null;
  color: [number, number, number, number] | null;
  distance: number;
  depth: number;
  material: string;
}

export interface PickAnswer {
  hits: Hit[];
  at: [x: number, y: number];
  camera: { view_from_world: number[]; clip_from_view: number[] };
}

/** An object in a rectangle of the picture. */
export interface RegionHit {
  index: number;
  object: string;
  path: string[];
  names: string[];
  z_min: number;
  z_max: number;
  triangles: number;
  pixels?: number;
}

/** A light at an explained point. */
export interface ExplainedLight {
  name: string;
  kind: string;
  to_light: Vector;
  distance: number | null;
  attenuation: number;
  spot: number;
  n_dot_l: number;
  specular_cosine: number | null;
  ambient: Color;
  diffuse: Color;
  specular: Color;
  visibility?: number;
}

/** A sample of a pixel. `object` is null where the background is. */
export interface ExplainedSample {
  weight: number;
  index?: number;
  object: string | null;
  triangle?: number | null;
  barycentric?: Vector;
  position?: Vector;
  normal?: Vector;
  view?: Vector;
  emission?: Color;
  scene_ambient?: Color;
  lights?: ExplainedLight[];
  environment?: Color;
  sum?: Color;
  fog?: { factor: number; color: Color } | null;
  color: Color;
  alpha: number;
  [name: string]: unknown;
}

/** Why a pixel has its colour: the terms add up to its bytes. */
export interface Explanation {
  pixel: [x: number, y: number];
  samples: ExplainedSample[];
  rgba8: [number, number, number, number];
  [name: string]: unknown;
}

export type TermKind = "ambient" | "diffuse" | "specular" | "emission" | "environment" | "fog" | "sum";

/** A factor of a product: its symbol, what it means, and its number. */
export interface LedgerFactor {
  symbol: string;
  meaning: string;
  number: string;
}

export type LedgerLine =
  | { what: "heading"; name: string; facts: string[] }
  | { what: "term"; kind: TermKind; name: string; factors: LedgerFactor[]; value: string[]; is_part: boolean }
  | { what: "note"; text: string }
  | { what: "sum"; kind: TermKind; name: string; value: string[]; note: string };

/** A vector of the equation; `picture` is how it lies in the picture, y down. */
export interface LedgerVector {
  kind: "normal" | "view" | "light" | "highlight";
  name: "N" | "V" | "L" | "R" | "H";
  light: string | null;
  cosine: number | null;
  vector: Vector;
  picture: [x: number, y: number];
}

export interface LedgerSurface {
  what: "surface";
  object: string;
  path: string[];
  triangle: number | null;
  barycentric: Vector;
  position: Vector;
  material: string;
  alpha: number;
  terms: Record<Exclude<TermKind, "sum">, Color>;
  sum: Color;
  lines: LedgerLine[];
  vectors: LedgerVector[];
}

export interface LedgerBackground {
  what: "background" | "ground";
  color: Color;
  alpha: number;
}

/** The ledger of a pixel, for a page. */
export interface Ledger {
  pixel: [x: number, y: number];
  rgba8: [number, number, number, number];
  samples: { weight: number; layers: (LedgerSurface | LedgerBackground)[] }[];
  hints: string[];
}

/** A handle that moves a light in the picture. */
export interface LightHandle {
  kind: "position" | "target" | "direction";
  /** Where it is, in pixels of the picture. */
  place: [x: number, y: number];
  /** False for a direction on the far side of the sphere on which directions are shown. */
  isNear: boolean;
}

/** Where a light is and where it shines, in its own coordinates: the world's or the camera's. */
export interface LightPose {
  position: number[];
  direction: number[];
}

/** Something in a mesh that spoils shading. */
export interface Finding {
  kind: string;
  count: number;
  severity: number | null;
  pixels?: number;
  places: { index: number; object: string; path: string[]; triangle: number | null; position: Vector }[];
  cure: string;
  /** The colour of its marks, as in CSS. */
  color: string;
}

export interface CheckAnswer {
  findings: Finding[];
  /** What the kinds of findings are. */
  about: Record<string, string>;
  triangles: number;
  /** The model in grey with its findings in colour, of the view's size. */
  pixels: Pixels;
}

/** What is in a scene. */
export interface Description {
  triangles: number;
  bounds: { min: Vector; max: Vector } | null;
  up: Vector;
  objects: { name: string; path: string[]; triangles: number }[];
  materials: ({ name: string; reflection: string; color: Color; emission: Color } & Record<string, unknown>)[];
  /** Its lights, or the default ones, as `--light` takes them. */
  lights: string[];
  ambient: Color;
  has_own_lights: boolean;
  cameras: { name: string }[];
  warnings: string[];
}

/** A number that a reflection model depends on. */
export interface Parameter {
  name: string;
  symbol: string;
  help: string;
  is_whole: boolean;
  /** The largest value that sliders offer. */
  slider_end: number;
  default: number;
}

export interface Choice {
  name: string;
  help: string;
}

/** What can be chosen in settings. */
export interface Vocabulary {
  reflections: (Choice & { formula: string; source: string; parameters: Parameter[] })[];
  shadings: Choice[];
  tones: Choice[];
}

export interface Demo {
  name: string;
  about: string;
}
