/** What the page and its workers say to one another. */

/** Bytes of a picture, or of a share of it: rows of tiles, one below the other. */
export type Pixels = Uint8ClampedArray<ArrayBuffer>;

/** How a picture is drawn: a draft has one sample and casts no rays, others the view's samples if these are 0. */
export interface Quality {
  isDraft: boolean;
  samples: number;
}

/** An event of navigation: the name of a method and its arguments. */
export type NavigationEvent =
  | readonly ["grab", gesture: "turn" | "pan" | "zoom", x: number, y: number]
  | readonly ["drag", x: number, y: number]
  | readonly ["release"]
  | readonly ["wheel", notches: number, x: number, y: number]
  | readonly ["tap", command: string, steps: number]
  | readonly ["play", line: string, seconds: number]
  | readonly ["set_mode", mode: string]
  | readonly ["look_from", name: string]
  | readonly ["fit"]
  | readonly ["turn_about", x: number, y: number]
  | readonly ["home"];

/** Where the camera is, after events. */
export interface CameraState {
  /** From world to camera coordinates: 16 numbers, column by column. */
  viewFromWorld: number[];
  /** From camera to clip coordinates: 16 numbers, column by column. */
  clipFromView: number[];
  mode: string;
  isMoved: boolean;
  /** Whether it still moves by itself. */
  isMoving: boolean;
  /** The camera as settings. */
  settings: Record<string, string>;
}

/** What pictures of a view are drawn from, by any worker that has the scene. */
export interface Frame {
  view: Uint8Array<ArrayBuffer>;
  /** Counts changes of the scene: a drawer with another number needs it anew. */
  version: number;
  width: number;
  height: number;
  hasRays: boolean;
  camera: CameraState;
}

/** The scene of a view, for drawers. */
export interface PackedScene {
  version: number;
  scene: Uint8Array<ArrayBuffer>;
  hidden: number[];
  /** The map of its environment. */
  map: Uint8Array<ArrayBuffer> | undefined;
}

/** Files by their paths. */
export type Files = [path: string, bytes: Uint8Array<ArrayBuffer>][];

/** The addresses of the modules that a worker fetches when it needs them. */
export interface ModuleUrls {
  answers: string;
  readers: string;
}

/** The calls that a worker answers. */
export interface Calls {
  start(module: WebAssembly.Module, later: ModuleUrls): void;
  demos(): string;
  vocabulary(): string;
  demo(id: number, name: string): string;
  read(id: number, path: string, files: Files, maxMemory: number): string;
  addEnvironment(
    id: number,
    path: string,
    bytes: Uint8Array<ArrayBuffer>,
    maxMemory: number,
  ): { name: string; warnings: string };
  freeModel(id: number): void;
  open(id: number, model: number, settings: string): Frame;
  close(id: number): void;
  set(id: number, settings: string): Frame;
  hide(id: number, objects: number[]): Frame;
  step(id: number, events: readonly NavigationEvent[]): Frame;
  frame(id: number): Frame;
  packedScene(id: number): PackedScene;
  layer(id: number, name: string): Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;
  layerPicture(id: number, name: string): Pixels;
  png(id: number): Uint8Array<ArrayBuffer>;
  pick(id: number, x: number, y: number, through: boolean): string;
  pickRect(id: number, x: number, y: number, w: number, h: number, visible: boolean): string;
  explain(id: number, x: number, y: number, format: "json" | "text" | "latex"): string;
  ledger(id: number, x: number, y: number): string;
  log(id: number): string;
  lightHandles(id: number, lights: string[]): string;
  moveLight(id: number, light: string, kind: string, x: number, y: number, isNear: boolean): number[] | null;
  check(id: number): { json: string; pixels: Pixels };
  /** For drawers: the scene of a view, and which of its objects are hidden. */
  prepare(id: number, scene: PackedScene): void;
  /**
   * Draws a share of a picture into `into`, which comes back: every `parts`-th row of tiles from `part` on. Nothing is
   * drawn if the scene is another one meanwhile.
   */
  draw(
    id: number,
    frame: Pick<Frame, "view" | "version">,
    quality: Quality,
    share: readonly [part: number, parts: number],
    into: Pixels,
  ): { isDrawn: boolean; pixels: Pixels };
  memory(): number;
}

export type CallName = keyof Calls;

export interface Request {
  id: number;
  name: CallName;
  parameters: unknown[];
}

export type Response =
  | { id: number; result: unknown }
  | { id: number; error: string; isFatal: boolean };
