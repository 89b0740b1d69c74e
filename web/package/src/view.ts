/** Views: a scene seen by a camera, drawn by all workers, picked, explained and moved by one. */

import { helpers, type Hand } from "./crew.ts";
import { LuxelError } from "./error.ts";
import type {
  CheckAnswer,
  Explanation,
  Hit,
  LayerName,
  Ledger,
  LightHandle,
  LightPose,
  PickAnswer,
  RegionHit,
} from "./answers.ts";
import type { CameraState, Frame, NavigationEvent, Pixels } from "./protocol.ts";
import { pairs, type Settings } from "./settings.ts";


/** The height of a row of tiles, in pixels. */
const TILE = 64;

/** How a picture is drawn. */
export interface DrawOptions {
  /** One sample and no rays, for a moving hand. */
  draft?: boolean;
  /** Samples a pixel instead of the view's own. */
  samples?: number;
  /** How many workers draw; by default one for small pictures, else all. */
  workers?: number;
}

/** A drawn picture, by rows of tiles as workers have drawn them. */
interface Drawn {
  frame: Frame;
  parts: Pixels[];
}

/** A view of a scene. Its calls are answered in the order in which they are made. */
export class View {
  readonly #hand: Hand;
  readonly #id: number;
  /** What pictures are drawn from, after all calls so far. */
  #frame: Promise<Frame>;
  /** The versions of the scene that helpers have. */
  #prepared = new WeakMap<Hand, Promise<number>>();
  /** Shares of pictures that are shown already; fresh memory for each frame would cost a quarter of its time. */
  #spare: Pixels[] = [];
  #isOpen = true;
  readonly #onDispose: () => void;

  /** @internal */
  constructor(hand: Hand, id: number, frame: Frame, onDispose: () => void) {
    this.#hand = hand;
    this.#id = id;
    this.#frame = Promise.resolve(frame);
    this.#onDispose = onDispose;
  }

  /** Replaces all settings. A camera moved by hand stays, unless the settings choose another than before. */
  async set(settings: Settings): Promise<void> {
    await this.#change(this.#hand.call("set", [this.#id, JSON.stringify(pairs(settings))]));
  }

  /** Hides objects, by their places in `scene.description.objects`, and shows all others. */
  async hide(objects: Iterable<number>): Promise<void> {
    await this.#change(this.#hand.call("hide", [this.#id, [...objects]]));
  }

  /**
   * The picture: straight alpha, the bytes of the program's. An earlier one that is used no more may be `reused`: its
   * memory becomes the new one's.
   */
  async render(options: DrawOptions = {}, reused?: ImageData): Promise<ImageData> {
    if (reused !== undefined) this.#spare.push(reused.data as Pixels);
    const { frame, parts } = await this.#draw(options);
    const { width, height } = frame;
    if (parts.length === 1) {
      return new ImageData(parts[0]!, width, height);
    }
    const pixels = this.#pixels(width * height * 4);
    eachBand(width, height, parts, (band, top) => pixels.set(band, top * width * 4));
    this.#spare.push(...parts);
    return new ImageData(pixels, width, height);
  }

  /** Draws the picture into a canvas, which takes its size; the camera that it shows. */
  async draw(canvas: HTMLCanvasElement, options: DrawOptions = {}): Promise<CameraState & { hasRays: boolean }> {
    const { frame, parts } = await this.#draw(options);
    const { width, height } = frame;
    // Setting a size clears the canvas.
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const context = canvas.getContext("2d");
    if (context === null) {
      throw new LuxelError("this canvas can't be drawn to");
    }
    eachBand(width, height, parts, (band, top) => {
      context.putImageData(new ImageData(band, width), 0, top);
    });
    this.#spare.push(...parts);
    return { ...frame.camera, hasRays: frame.hasRays };
  }

  /** Layers as arrays, row by row from the top: ids as `Uint32Array`, others as `Float32Array`. */
  async layers<N extends LayerName>(
    names: readonly N[],
  ): Promise<{ [K in N]: K extends "object" | "triangle" ? Uint32Array : Float32Array }> {
    const layers: Record<string, Float32Array | Uint32Array> = {};
    for (const name of names) {
      layers[name] = await this.#hand.call("layer", [this.#id, name]);
    }
    return layers as { [K in N]: K extends "object" | "triangle" ? Uint32Array : Float32Array };
  }

  /** A layer as colours to look at, with the size of the view's picture. */
  layerPicture(name: LayerName): Promise<Pixels> {
    return this.#hand.call("layerPicture", [this.#id, name]);
  }

  /** The picture as a PNG file. */
  async png(): Promise<Blob> {
    return new Blob([await this.#hand.call("png", [this.#id])], { type: "image/png" });
  }

  /** What is visible at a point of the picture, in pixels from its upper left corner; null where nothing is. */
  async pick(x: number, y: number): Promise<Hit | null> {
    return (await this.pickAnswer(x, y)).hits[0] ?? null;
  }

  /** All surfaces at a point of the picture, nearest first. */
  async pickThrough(x: number, y: number): Promise<Hit[]> {
    return (await this.pickAnswer(x, y, true)).hits;
  }

  /** The document of `luxel pick --at X,Y --json`. */
  async pickAnswer(x: number, y: number, through = false): Promise<PickAnswer> {
    return JSON.parse(await this.#hand.call("pick", [this.#id, x, y, through]));
  }

  /** The objects in a rectangle of the picture, with the depths that they take there. */
  async pickRect(x: number, y: number, w: number, h: number, visible = false): Promise<RegionHit[]> {
    return JSON.parse(await this.#hand.call("pickRect", [this.#id, x, y, w, h, visible])).hits;
  }

  /** Why a pixel has its colour: the document of `luxel explain --at X,Y --json`. */
  async explain(x: number, y: number): Promise<Explanation> {
    return JSON.parse(await this.#hand.call("explain", [this.#id, x, y, "json"]));
  }

  /** Why a pixel has its colour, in words. */
  explainText(x: number, y: number): Promise<string> {
    return this.#hand.call("explain", [this.#id, x, y, "text"]);
  }

  /** Why a pixel has its colour, as LaTeX. */
  explainLatex(x: number, y: number): Promise<string> {
    return this.#hand.call("explain", [this.#id, x, y, "latex"]);
  }

  /** The ledger of a pixel for a page: lines of the equation, and vectors as they lie in the picture. */
  async ledger(x: number, y: number): Promise<Ledger> {
    return JSON.parse(await this.#hand.call("ledger", [this.#id, x, y]));
  }

  /** Moves the camera. */
  async navigate(...events: NavigationEvent[]): Promise<CameraState> {
    return (await this.#change(this.#hand.call("step", [this.#id, events]))).camera;
  }

  /** The log of all that has moved the camera; `luxel navigate --replay` plays it. */
  log(): Promise<string> {
    return this.#hand.call("log", [this.#id]);
  }

  /** The handles of lights in the picture: for each of these texts of `--light` a list, which may be empty. */
  async lightHandles(lights: readonly string[]): Promise<LightHandle[][]> {
    const lists: (Omit<LightHandle, "isNear"> & { is_near: boolean })[][] = JSON.parse(
      await this.#hand.call("lightHandles", [this.#id, [...lights]]),
    );
    return lists.map((handles) => handles.map(({ is_near, ...handle }) => ({ ...handle, isNear: is_near })));
  }

  /** The pose of a light of which a handle is moved to a place of the picture; null if no point is there. */
  async moveLight(light: string, handle: LightHandle, x: number, y: number): Promise<LightPose | null> {
    const moved = await this.#hand.call("moveLight", [this.#id, light, handle.kind, x, y, handle.isNear]);
    return moved && { position: moved.slice(0, 3), direction: moved.slice(3) };
  }

  /** What in the mesh spoils shading, and a picture that marks it. */
  async check(): Promise<CheckAnswer> {
    const { json, pixels } = await this.#hand.call("check", [this.#id]);
    return { ...JSON.parse(json), pixels };
  }

  /** Frees the view's memory in all workers. */
  dispose(): void {
    if (!this.#isOpen) return;
    this.#isOpen = false;
    for (const hand of [this.#hand, ...helpers()]) {
      hand.call("close", [this.#id]).catch(() => {});
    }
    this.#onDispose();
  }

  [Symbol.dispose](): void {
    this.dispose();
  }

  /** Notes the frame after a call that changes it; one that fails may have changed it, too. */
  #change(call: Promise<Frame>): Promise<Frame> {
    this.#frame = call.catch(() => this.#hand.call("frame", [this.#id]));
    // A worker that has ended says so to those who draw.
    this.#frame.catch(() => {});
    return call;
  }

  async #draw({ draft = false, samples = 0, workers }: DrawOptions): Promise<Drawn> {
    const frame = await this.#frame;
    const { width, height, view, version } = frame;
    const rows = Math.ceil(height / TILE);
    /** A smaller picture is drawn before a second worker has heard of it. */
    const least = 40_000;
    const many = workers ?? (width * height < least ? 1 : Infinity);
    const hands = [this.#hand, ...(many > 1 ? await this.#ready(version, many - 1) : [])];
    const count = Math.min(hands.length, rows);
    const quality = { isDraft: draft, samples };
    const drawn = await Promise.all(
      hands.slice(0, count).map((hand, part) => {
        const into = this.#pixels(shareBytes(width, height, part, count));
        return hand.call("draw", [this.#id, { view, version }, quality, [part, count], into], [into.buffer]);
      }),
    );
    const parts = drawn.map(({ pixels }) => pixels);
    if (drawn.every(({ isDrawn }) => isDrawn)) {
      return { frame, parts };
    }
    // The scene was changed meanwhile: the picture is drawn as it is now.
    this.#spare.push(...parts);
    return this.#draw({ draft, samples, workers });
  }

  /** Memory for a share of a picture: an earlier picture's, if it has as many bytes. */
  #pixels(bytes: number): Pixels {
    const at = this.#spare.findIndex((pixels) => pixels.length === bytes);
    if (at >= 0) return this.#spare.splice(at, 1)[0]!;
    // What is left is of pictures of another size.
    this.#spare = [];
    return new Uint8ClampedArray(bytes);
  }

  /** Helpers that have the scene. Those that don't are given it, and help with later pictures. */
  async #ready(version: number, most: number): Promise<Hand[]> {
    const ready: Hand[] = [];
    for (const hand of helpers().slice(0, most)) {
      const prepared = this.#prepared.get(hand);
      const has = prepared && (await Promise.race([prepared, Promise.resolve(-1)]));
      if (has === version) {
        ready.push(hand);
      } else if (prepared === undefined || has !== -1) {
        const next = this.#prepare(hand);
        next.catch(() => this.#prepared.delete(hand));
        this.#prepared.set(hand, next);
      }
    }
    return ready;
  }

  /** Gives a helper the scene; the version that it has then. */
  async #prepare(hand: Hand): Promise<number> {
    await hand.ready;
    const packed = await this.#hand.call("packedScene", [this.#id]);
    const buffers = packed.map ? [packed.scene.buffer, packed.map.buffer] : [packed.scene.buffer];
    await hand.call("prepare", [this.#id, packed], buffers);
    return packed.version;
  }

  /** Waits until all helpers have the scene. */
  async ready(): Promise<void> {
    await this.#hand.ready;
    const { version } = await this.#frame;
    await this.#ready(version, Infinity);
    await Promise.all(helpers().map((hand) => this.#prepared.get(hand)));
  }
}

/** The bytes of a share of a picture: every `parts`-th row of tiles from `part` on. */
function shareBytes(width: number, height: number, part: number, parts: number): number {
  let lines = 0;
  for (let top = part * TILE; top < height; top += parts * TILE) {
    lines += Math.min(TILE, height - top);
  }
  return lines * width * 4;
}

/** Each row of tiles with its first line; part p of n holds rows p, p + n, p + 2n and so on. */
function eachBand(
  width: number,
  height: number,
  parts: readonly Pixels[],
  use: (band: Pixels, top: number) => void,
): void {
  if (parts.length === 1) {
    use(parts[0]!, 0);
    return;
  }
  for (let row = 0; row * TILE < height; row++) {
    const start = Math.floor(row / parts.length) * TILE * width * 4;
    const lines = Math.min(TILE, height - row * TILE);
    use(parts[row % parts.length]!.subarray(start, start + lines * width * 4), row * TILE);
  }
}

