/**
 * luxel: 3D models lit, drawn, picked and explained on the CPU, with the same bytes on every machine.
 *
 * ```js
 * import { load } from "luxel";
 *
 * const scene = await load(file);                         // a File, an address, bytes, or a Map of names
 * const view = await scene.view({ size: [1280, 720], azimuth: 30, elevation: 20 });
 * await view.draw(canvas);
 * const hit = await view.pick(640.5, 360.5);              // null, or object, triangle, barycentric, position ...
 * const why = await view.explain(640, 360);               // every term of the pixel's light
 * scene.dispose();
 * ```
 *
 * All work is done in workers. Nothing is sent anywhere, and nothing is fetched but the package's own files and
 * what an address names.
 */

import type { Demo, Description, Vocabulary } from "./answers.ts";
import { leader, type Hand } from "./crew.ts";
import { environmentOf, filesOf, type Source } from "./files.ts";
import { pairs, type Settings } from "./settings.ts";
import { View } from "./view.ts";

export type * from "./answers.ts";
export { configure, drawers, WorkerEndedError, type Options } from "./crew.ts";
export { LuxelError } from "./error.ts";
export { isEnvironment, isModel, modelAmong, type Source } from "./files.ts";
export type { CameraState, NavigationEvent, Pixels } from "./protocol.ts";
export { pairs, type Settings, type SettingValue } from "./settings.ts";
export { View, type DrawOptions } from "./view.ts";

let next = 1;

/** Frees what nobody refers to any more; `dispose` does it at once. */
const forgotten = new FinalizationRegistry<() => void>((free) => free());

/** A scene in memory. */
export class Scene {
  readonly description: Description;
  readonly #hand: Hand;
  readonly #id: number;
  readonly #views = new Set<View>();

  /** @internal */
  constructor(hand: Hand, id: number, description: Description) {
    this.#hand = hand;
    this.#id = id;
    this.description = description;
    forgotten.register(this, () => void hand.call("freeModel", [id]).catch(() => {}), this);
  }

  /** A view of the scene; rejects if the settings are not possible. */
  async view(settings: Settings = {}): Promise<View> {
    const id = next++;
    const frame = await this.#hand.call("open", [id, this.#id, JSON.stringify(pairs(settings))]);
    const view: View = new View(this.#hand, id, frame, () => this.#views.delete(view));
    this.#views.add(view);
    return view;
  }

  /**
   * Reads a picture of an environment, HDR or EXR: a `File`, bytes, or an address. Its name is for the setting
   * `environment` of the scene's views.
   *
   * Rejects with a `LuxelError` that says what is wrong where, if it is damaged or too large.
   */
  async addEnvironment(
    source: string | URL | Blob | ArrayBuffer | Uint8Array,
    { maxMemory = MOST_MEMORY }: LoadOptions = {},
  ): Promise<AddedEnvironment> {
    const [path, bytes] = await environmentOf(source);
    const read = await this.#hand.call("addEnvironment", [this.#id, path, bytes, maxMemory], [bytes.buffer]);
    return { name: read.name, warnings: JSON.parse(read.warnings) };
  }

  /** Frees the scene and its views in all workers. */
  dispose(): void {
    for (const view of [...this.#views]) {
      view.dispose();
    }
    forgotten.unregister(this);
    this.#hand.call("freeModel", [this.#id]).catch(() => {});
  }

  [Symbol.dispose](): void {
    this.dispose();
  }
}

/** How a file is read. */
export interface LoadOptions {
  /** Bytes that its content may take in memory; 1 GB by default. */
  maxMemory?: number;
}

const MOST_MEMORY = 1 << 30;

/** An environment that views of a scene may have. */
export interface AddedEnvironment {
  /** The value of the setting `environment`. */
  name: string;
  /** What is odd in its file. */
  warnings: string[];
}

/**
 * Reads a model: a `File`, several files by their paths, bytes, or an address, with what it refers to.
 *
 * Rejects with a `LuxelError` that says what is wrong where, if it is damaged or too large.
 */
export async function load(source: Source, { maxMemory = MOST_MEMORY }: LoadOptions = {}): Promise<Scene> {
  const hand = leader();
  const [{ path, files }] = await Promise.all([filesOf(source), hand.ready]);
  const list = [...files];
  const id = next++;
  const buffers = list.map(([, bytes]) => bytes.buffer);
  const description = await hand.call("read", [id, path, list, maxMemory], buffers);
  return new Scene(hand, id, JSON.parse(description));
}

/** A scene that is built in. */
export async function demo(name: string): Promise<Scene> {
  const hand = leader();
  await hand.ready;
  const id = next++;
  return new Scene(hand, id, JSON.parse(await hand.call("demo", [id, name])));
}

/** The scenes that are built in. */
export async function demos(): Promise<Demo[]> {
  const hand = leader();
  await hand.ready;
  return JSON.parse(await hand.call("demos", []));
}

/** What can be chosen in settings: reflection models with their parameters, shading modes, tone curves. */
export async function vocabulary(): Promise<Vocabulary> {
  const hand = leader();
  await hand.ready;
  return JSON.parse(await hand.call("vocabulary", []));
}

/** The bytes of WebAssembly's memory in the leading worker. */
export async function memory(): Promise<number> {
  const hand = leader();
  await hand.ready;
  return hand.call("memory", []);
}
