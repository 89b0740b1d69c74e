/** Runs in a worker: holds models and views in WebAssembly, and draws. */

import { linkAnswers } from "../wasm/answers.js";
import initialize, { Drawer, Model, ModelView } from "../wasm/luxel.js";
import type * as Readers from "../wasm/readers.js";
import { compile } from "./compile.ts";
import type {
  CallName,
  Calls,
  CameraState,
  Files,
  Frame,
  ModuleUrls,
  NavigationEvent,
  Pixels,
  Request,
  Response,
} from "./protocol.ts";

interface OpenView {
  view: ModelView;
  version: number;
  hidden: number[];
}

const models = new Map<number, Model>();
const views = new Map<number, OpenView>();
const drawers = new Map<number, { drawer: Drawer; version: number }>();
let memory: WebAssembly.Memory | undefined;
let urls: ModuleUrls;
let answering: Promise<void> | undefined;
/** The first fetch of the module that answers: only questions repeat one that failed. */
let fetched: Promise<void> | undefined;
let readers: Promise<typeof Readers> | undefined;

function got<T>(things: Map<number, T>, id: number, what: string): T {
  const thing = things.get(id);
  if (thing === undefined) {
    throw new Error(`this ${what} is no longer there`);
  }
  return thing;
}

/** The module that answers, fetched once the first picture is drawn, or for the first question. */
async function canAnswer(): Promise<void> {
  answering ??= compile(urls.answers).then(linkAnswers);
  const own = answering;
  try {
    await own;
  } catch (error) {
    // Another question may have begun to fetch it anew.
    if (answering === own) answering = undefined;
    throw error;
  }
}

const QUESTIONS: ReadonlySet<CallName> = new Set([
  "check",
  "explain",
  "layer",
  "layerPicture",
  "ledger",
  "pick",
  "pickRect",
]);

/** Motion about the point under the pointer. */
const POINTING: ReadonlySet<NavigationEvent[0]> = new Set(["grab", "wheel", "turn_about"]);

/** Whether a call needs the module that answers. */
function asks({ name, parameters }: Request): boolean {
  if (name !== "step") return QUESTIONS.has(name);
  const [, events] = parameters as Parameters<Calls["step"]>;
  return events.some(([event]) => POINTING.has(event));
}

/** The module that reads and writes files, fetched for the first one. */
async function readersModule(): Promise<typeof Readers> {
  readers ??= import("../wasm/readers.js").then(async (module) => {
    await module.default({ module_or_path: await compile(urls.readers) });
    return module;
  });
  try {
    return await readers;
  } catch (error) {
    readers = undefined;
    throw error;
  }
}

/** What a reader makes of a file and those that it refers to. */
async function readWith(
  reader: "read" | "read_environment",
  path: string,
  list: Files,
  maxMemory: number,
): Promise<{ bytes: Uint8Array; warnings: string }> {
  const module = await readersModule();
  const files = new module.Files();
  for (const [name, bytes] of list) {
    files.add(name, bytes);
  }
  // The reader takes the files, and frees them.
  const read = module[reader](path, files, maxMemory);
  try {
    return { bytes: read.take_bytes(), warnings: read.warnings };
  } finally {
    read.free();
  }
}

function cameraState(view: ModelView): CameraState {
  const settings: Record<string, string> = {};
  const pairs = view.camera_settings();
  for (let at = 0; at + 1 < pairs.length; at += 2) {
    settings[pairs[at]!] = pairs[at + 1]!;
  }
  return {
    viewFromWorld: Array.from(view.camera),
    clipFromView: Array.from(view.projection),
    mode: view.mode,
    isMoved: view.is_moved,
    isMoving: view.is_moving,
    settings,
  };
}

function frameOf(id: number): Frame {
  const { view, version } = got(views, id, "view");
  return {
    view: view.pack() as Uint8Array<ArrayBuffer>,
    version,
    width: view.width,
    height: view.height,
    hasRays: view.has_rays,
    camera: cameraState(view),
  };
}

function pixels(bytes: Uint8Array): Pixels {
  return new Uint8ClampedArray(bytes.buffer as ArrayBuffer, bytes.byteOffset, bytes.byteLength);
}

type Answers = { [N in CallName]: (...parameters: Parameters<Calls[N]>) => ReturnType<Calls[N]> | Promise<ReturnType<Calls[N]>> };

const answers: Answers = {
  async start(module, later) {
    const exports = await initialize({ module_or_path: module });
    memory = exports.memory;
    urls = later;
  },

  demos: () => Model.demos(),
  vocabulary: () => Model.vocabulary(),

  demo(id, name) {
    const model = Model.demo(name);
    models.set(id, model);
    return model.describe();
  },

  async read(id, path, files, maxMemory) {
    const { bytes, warnings } = await readWith("read", path, files, maxMemory);
    const model = Model.unpack(bytes, warnings);
    models.set(id, model);
    return model.describe();
  },

  async addEnvironment(id, path, bytes, maxMemory) {
    const read = await readWith("read_environment", path, [[path, bytes]], maxMemory);
    const name = got(models, id, "scene").add_environment(read.bytes);
    return { name, warnings: read.warnings };
  },

  freeModel(id) {
    models.get(id)?.free();
    models.delete(id);
  },

  open(id, model, settings) {
    views.set(id, { view: ModelView.of(got(models, model, "scene"), settings), version: 0, hidden: [] });
    return frameOf(id);
  },

  close(id) {
    views.get(id)?.view.free();
    views.delete(id);
    drawers.get(id)?.drawer.free();
    drawers.delete(id);
  },

  set(id, settings) {
    const open = got(views, id, "view");
    if (open.view.set(settings)) {
      open.version += 1;
    }
    return frameOf(id);
  },

  hide(id, objects) {
    const open = got(views, id, "view");
    open.view.hide(Uint32Array.from(objects));
    open.hidden = objects;
    open.version += 1;
    return frameOf(id);
  },

  step(id, events) {
    const { view } = got(views, id, "view");
    for (const [name, ...values] of events) {
      (view[name] as (...values: unknown[]) => void).apply(view, values);
    }
    return frameOf(id);
  },

  frame: frameOf,

  packedScene(id) {
    const { view, version, hidden } = got(views, id, "view");
    const map = view.pack_map() as Uint8Array<ArrayBuffer> | undefined;
    return { version, scene: view.pack_scene() as Uint8Array<ArrayBuffer>, hidden, map };
  },

  layer(id, name) {
    const { view } = got(views, id, "view");
    const isIds = name === "object" || name === "triangle";
    return (isIds ? view.layer_ids(name) : view.layer(name)) as
      Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>;
  },

  layerPicture: (id, name) => pixels(got(views, id, "view").view.layer_picture(name)),

  async png(id) {
    const { write_png } = await readersModule();
    const { view } = got(views, id, "view");
    return write_png(view.width, view.height, view.is_srgb, view.draw(0)) as Uint8Array<ArrayBuffer>;
  },

  pick: (id, x, y, through) => got(views, id, "view").view.pick_json(x, y, through),
  pickRect: (id, x, y, w, h, visible) => got(views, id, "view").view.pick_rect(x, y, w, h, visible),

  explain(id, x, y, format) {
    const { view } = got(views, id, "view");
    switch (format) {
      case "json":
        return view.explain_json(x, y);
      case "latex":
        return view.explain_latex(x, y);
      case "text":
        return view.explain(x, y);
    }
  },

  ledger: (id, x, y) => got(views, id, "view").view.ledger(x, y),
  log: (id) => got(views, id, "view").view.log(),
  lightHandles: (id, lights) => got(views, id, "view").view.light_handles(lights),

  moveLight(id, light, kind, x, y, isNear) {
    const moved = got(views, id, "view").view.move_light(light, kind, x, y, isNear);
    return moved === undefined ? null : Array.from(moved);
  },

  check(id) {
    const checked = got(views, id, "view").view.check();
    try {
      return { json: checked.json, pixels: pixels(checked.take_pixels()) };
    } finally {
      checked.free();
    }
  },

  prepare(id, { version, scene, hidden, map }) {
    drawers.get(id)?.drawer.free();
    drawers.delete(id);
    drawers.set(id, { drawer: new Drawer(scene, Uint32Array.from(hidden), map), version });
  },

  draw(id, { view, version }, { isDraft, samples }, [part, parts], into) {
    const open = views.get(id);
    const { drawer, version: own } =
      open === undefined ? got(drawers, id, "view") : { drawer: open.view, version: open.version };
    if (own === version) drawer.draw_part(view, isDraft, samples, part, parts, into);
    // Not to be waited for: a question says what is wrong.
    if (open !== undefined) fetched ??= canAnswer().catch(() => {});
    return { isDrawn: own === version, pixels: into };
  },

  memory: () => memory?.buffer.byteLength ?? 0,
};

/** The buffers of an answer that go to the page without a copy. */
function buffers(result: unknown): ArrayBuffer[] {
  const own = (value: unknown): ArrayBuffer[] =>
    ArrayBuffer.isView(value) && value.buffer instanceof ArrayBuffer ? [value.buffer] : [];
  const parts = typeof result === "object" && result !== null && !ArrayBuffer.isView(result);
  return parts ? Object.values(result).flatMap(own) : own(result);
}

// One call after the other, also where one waits for the readers.
let queue: Promise<void> = Promise.resolve();

async function answer(request: Request): Promise<void> {
  const { id, name, parameters } = request;
  let response: Response;
  let transfer: ArrayBuffer[] = [];
  try {
    if (asks(request)) await canAnswer();
    const call = answers[name] as (...parameters: unknown[]) => unknown;
    const result = await call(...parameters);
    transfer = buffers(result);
    response = { id, result };
  } catch (error) {
    // A trap leaves the module's memory in a state that nothing may rely on.
    const isFatal = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
    const message = error instanceof Error ? error.message : String(error);
    response = { id, error: message, isFatal };
  }
  postMessage(response, { transfer });
}

addEventListener("message", ({ data }: MessageEvent<Request>) => {
  queue = queue.then(() => answer(data));
});
