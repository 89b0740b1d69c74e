/** The viewer: drop a model, turn it, ask a pixel. */

import {
  demo,
  demos,
  load,
  LuxelError,
  vocabulary,
  WorkerEndedError,
  type CameraState,
  type LayerName,
  type Ledger,
  type NavigationEvent,
  type Scene,
  type Settings,
  type Source,
  type View,
  type Vocabulary,
} from "luxel";
import { byId, element } from "./dom.ts";
import { listenToDrops } from "./dropping.ts";
import { Handles } from "./handles.ts";
import { sentence, showLedger } from "./ledger.ts";
import { lightText, parseLight, showLights, type Light } from "./lights.ts";
import { command, readLink, writeLink } from "./link.ts";
import { showVectors } from "./overlay.ts";
import { listen, MODES } from "./pointing.ts";
import { showPicture, showSurface, type PageSettings } from "./surface.ts";
import { offer } from "./testing.ts";
import { Tree } from "./tree.ts";

const LAYERS: ("picture" | LayerName)[] = [
  "picture",
  "ambient",
  "diffuse",
  "specular",
  "emission",
  "environment",
  "normal",
  "depth",
  "object",
  "triangle",
  "barycentric",
  "n_dot_l",
  "openness",
];

/** A hand that rests as long gets the complete picture, in milliseconds. */
const REST = 140;

const canvas = byId<HTMLCanvasElement>("canvas");
const picture = byId("picture");
const overlay = document.getElementById("overlay") as unknown as SVGElement;
const status = byId("status");
const message = byId("message");

let scene: Scene | undefined;
let view: View | undefined;
/** The name of a demo, or of a file. */
let model: { demo?: string; name: string } = { demo: "teapot", name: "demo:teapot" };
let settings: PageSettings = {};
let lights: Light[] = [];
/** Whether the lights are others than the scene's. */
let hasLights = false;
let camera: CameraState | undefined;
/** What shows the lights in their panel, and what applies them. */
let showLightPanel = (): void => {};
let lightsChanged = (): void => {};
let isChecked = false;
let vocabularyOnce: Promise<Vocabulary> | undefined;
const layerChoice = byId<HTMLSelectElement>("layer");
const modeChoice = byId<HTMLSelectElement>("mode");

const tree = new Tree(byId("objects"), byId<HTMLInputElement>("search"), (hidden) => {
  void attempt(async () => {
    await view?.hide(hidden);
    redraw();
  });
});

/** Does something, and shows why it failed. */
async function attempt(work: () => Promise<void>): Promise<void> {
  try {
    await work();
  } catch (error) {
    status.textContent = model.name;
    const text = error instanceof LuxelError ? error.message : String(error);
    message.textContent = text;
    message.hidden = false;
    if (error instanceof WorkerEndedError) {
      view = scene = vocabularyOnce = undefined;
      await attempt(() => show(() => demo("teapot"), { demo: "teapot", name: "demo:teapot" }, {}, true));
    } else if (!(error instanceof LuxelError)) {
      console.error(error);
    }
  }
}

/** The pixels that the picture has: those of the link, else as many as the page shows. */
function sizeOfPage(): string {
  const box = picture.getBoundingClientRect();
  const scale = Math.min(devicePixelRatio, 2, 1920 / Math.max(box.width, 1));
  const side = (length: number): number => Math.max(16, Math.round(length * scale));
  return `${side(box.width)}x${side(box.height)}`;
}

let isFixed = false;

/** All settings of the view. */
function allSettings(): Settings {
  const all: Settings = { ...settings, size: (settings["size"] as string) ?? sizeOfPage() };
  if (hasLights) {
    const on = lights.filter((light) => light.isOn).map(lightText);
    // Without any light left, one that adds nothing keeps the scene's own away.
    all["light"] = on.length > 0 ? on : ["ambient:color=0,0,0"];
  }
  return all;
}

/** The settings that give this picture anywhere. */
function portableSettings(): Settings {
  const all = allSettings();
  if (camera?.isMoved) {
    for (const name of ["azimuth", "elevation", "eye", "target", "camera", "fov", "ortho", "intrinsics"]) {
      delete all[name];
    }
    Object.assign(all, camera.settings);
  }
  return all;
}

// --- Drawing -------------------------------------------------------------------------------------

let wanted: "nothing" | "draft" | "full" = "nothing";
let isDrawing = false;
let restTimer = 0;
let pending: NavigationEvent[] = [];
const drawnPixels = new WeakMap<HTMLCanvasElement, Uint8ClampedArray>();
/** The picture that is shown, and the one before it, whose memory the next one takes. */
let last: ImageData | undefined;
let before: ImageData | undefined;
let idle: (() => void)[] = [];

function redraw(): void {
  wanted = "full";
  void drawLoop();
}

/** Moves the camera; the complete picture follows when the hand rests. */
function move(...events: NavigationEvent[]): void {
  // Of drags that wait, the last one counts.
  for (const event of events) {
    const last = pending.at(-1);
    if (event[0] === "drag" && last?.[0] === "drag") pending.pop();
    pending.push(event);
  }
  if (wanted === "nothing") wanted = "draft";
  clearTimeout(restTimer);
  restTimer = setTimeout(redraw, REST);
  void drawLoop();
}

function shown(pixels: Uint8ClampedArray): void {
  drawnPixels.set(canvas, pixels);
  canvas.classList.remove("waits");
  byId("still").hidden = true;
  if (performance.getEntriesByName("first picture").length === 0) performance.mark("first picture");
}

async function drawLoop(): Promise<void> {
  if (isDrawing) return;
  isDrawing = true;
  let current: View | undefined;
  do {
    current = view;
    await attempt(() => unlessGone(current, drawAll));
    // Another scene may have come meanwhile.
  } while (current !== view);
  isDrawing = false;
  await attempt(() => handles.update());
  showCommand();
  const waiting = idle;
  idle = [];
  waiting.forEach((done) => done());
  askAgain();
}

/** Does something with a view; fails only if the view is still the page's. */
async function unlessGone(current: View | undefined, work: () => Promise<void>): Promise<void> {
  try {
    await work();
  } catch (error) {
    if (current === view) throw error;
  }
}

/** Draws until nothing is wanted any more. */
async function drawAll(): Promise<void> {
  while (view !== undefined && (wanted !== "nothing" || pending.length > 0)) {
    const current = view;
    const isFull = wanted === "full" && pending.length === 0;
    if (wanted !== "full" || isFull) wanted = "nothing";
    if (pending.length > 0) {
      const events = pending;
      pending = [];
      camera = await current.navigate(...events);
      modeChoice.value = camera.mode;
      if (isChecked) leaveCheck();
    }
    const layer = layerChoice.value as "picture" | LayerName;
    if (layer !== "picture") {
      const pixels = await current.layerPicture(layer);
      if (current !== view) continue;
      const frame = new ImageData(pixels, canvas.width, canvas.height);
      canvas.getContext("2d")!.putImageData(frame, 0, 0);
      shown(pixels);
      continue;
    }
    if (isChecked) continue;
    const isDraft = !isFull;
    const image = await current.render({ draft: isDraft }, before);
    before = undefined;
    if (current !== view) continue;
    if (canvas.width !== image.width) canvas.width = image.width;
    if (canvas.height !== image.height) canvas.height = image.height;
    canvas.getContext("2d")!.putImageData(image, 0, 0);
    shown(image.data);
    before = last;
    last = image;
  }
}

/** Waits until nothing is left to draw. */
function settled(): Promise<void> {
  if (!isDrawing && wanted === "nothing") return Promise.resolve();
  return new Promise((resolve) => idle.push(resolve));
}

// --- Settings -------------------------------------------------------------------------------------

let settingTimer: Promise<void> | undefined;
let isStale = false;

/** Applies the settings as they are then, once for all changes of a moment. */
function changed(): void {
  message.hidden = true;
  apply();
}

function apply(): void {
  isStale = true;
  settingTimer ??= (async () => {
    await attempt(async () => {
      while (isStale && view !== undefined) {
        isStale = false;
        const current = view;
        await unlessGone(current, () => current.set(allSettings()));
        redraw();
      }
    });
    settingTimer = undefined;
  })();
}

function showCommand(): void {
  byId("command").textContent = command(model.name, portableSettings());
}

// --- Explaining -----------------------------------------------------------------------------------

let kept: [number, number] | undefined;
let pointed: [number, number] | undefined;
let isAsking = false;
let asked: string | undefined;

/** The place of a pixel's centre over the picture, in pixels of the page. */
function placeOf([x, y]: [number, number]): [number, number] {
  const box = canvas.getBoundingClientRect();
  const outer = picture.getBoundingClientRect();
  const scale = Math.min(box.width / canvas.width, box.height / canvas.height);
  const left = box.left - outer.left + (box.width - canvas.width * scale) / 2;
  const top = box.top - outer.top + (box.height - canvas.height * scale) / 2;
  return [left + (x + 0.5) * scale, top + (y + 0.5) * scale];
}

function showAnswer(ledger: Ledger, at: [number, number]): void {
  showLedger(byId("ledger"), ledger, kept !== undefined);
  showVectors(overlay, ledger, placeOf(at));
  status.textContent = sentence(ledger);
  canvas.setAttribute("aria-label", `${model.name}. ${sentence(ledger)}`);
}

const handles = new Handles(document.getElementById("handles") as unknown as SVGElement, {
  view: () => view,
  lights: () => lights,
  middle: () => [canvas.width / 2, canvas.height / 2],
  toPage: ([x, y]) => placeOf([x - 0.5, y - 0.5]),
  wayToPicture: ([right, down]) => {
    const box = canvas.getBoundingClientRect();
    const scale = Math.min(box.width / canvas.width, box.height / canvas.height);
    return [right / scale, down / scale];
  },
  changed: () => {
    showLightPanel();
    lightsChanged();
  },
});

/** Explains the kept pixel, else the one under the pointer, one after the other. */
async function ask(): Promise<void> {
  const at = kept ?? pointed;
  if (isAsking || view === undefined) return;
  if (at === undefined || isChecked) {
    showVectors(overlay, undefined, [0, 0]);
    return;
  }
  if (isDrawing || asked === at.join()) return;
  isAsking = true;
  asked = at.join();
  try {
    const current = view;
    const [ledger, hit] = await Promise.all([current.ledger(...at), current.pick(at[0] + 0.5, at[1] + 0.5)]);
    if (current === view && asked === at.join()) {
      showAnswer(ledger, at);
      tree.mark(hit?.index);
    }
  } catch {
    // The picture became smaller meanwhile, or the scene another.
  }
  isAsking = false;
  if ((kept ?? pointed)?.join() !== asked) void ask();
}

/** After another picture the same pixel may have another light. */
function askAgain(): void {
  asked = undefined;
  void ask();
}

function keep(at: [number, number] | undefined): void {
  kept = at && (kept?.join() === at.join() ? undefined : at);
  askAgain();
}

function pixelAt([x, y]: [number, number]): [number, number] | undefined {
  const at: [number, number] = [Math.floor(x), Math.floor(y)];
  return at[0] >= 0 && at[1] >= 0 && at[0] < canvas.width && at[1] < canvas.height ? at : undefined;
}

// --- Check ----------------------------------------------------------------------------------------

function leaveCheck(): void {
  isChecked = false;
  byId("findings-panel").hidden = true;
}

async function check(): Promise<void> {
  if (view === undefined) return;
  await settled();
  const { findings, about, triangles, pixels } = await view.check();
  isChecked = true;
  canvas.getContext("2d")!.putImageData(new ImageData(pixels, canvas.width, canvas.height), 0, 0);
  const entries = findings.map((finding) => {
    const entry = element(
      "div",
      { class: "finding", style: `--of:${finding.color}` },
      element("h3", {}, `${finding.kind}: ${finding.count.toLocaleString("en")}`),
      element("p", { class: "quiet" }, about[finding.kind] ?? ""),
      element("p", {}, `Cure: ${finding.cure}`),
    );
    return entry;
  });
  const none = element("p", {}, `Nothing found in ${triangles.toLocaleString("en")} triangles.`);
  byId("findings").replaceChildren(...(entries.length > 0 ? entries : [none]));
  byId("findings-panel").hidden = false;
  askAgain();
  byId("findings-panel").scrollIntoView({ block: "nearest" });
}

// --- Scenes ---------------------------------------------------------------------------------------

/** Shows a scene with settings. */
async function show(
  open: () => Promise<Scene>,
  of: { demo?: string; name: string },
  given: PageSettings,
  keepsMessage = false,
): Promise<void> {
  if (!keepsMessage) message.hidden = true;
  status.textContent = `reading ${of.name} ...`;
  const [opened, words] = await Promise.all([open(), (vocabularyOnce ??= vocabulary())]);
  const next = { ...given };
  const { description } = opened;
  const given_lights = next["light"];
  const texts = Array.isArray(given_lights) ? given_lights : description.lights;
  delete next["light"];
  const before = { settings, lights, hasLights, model };
  settings = next;
  lights = texts.map(parseLight);
  hasLights = Array.isArray(given_lights);
  model = of;
  let made: View;
  try {
    made = await opened.view(allSettings());
  } catch (error) {
    ({ settings, lights, hasLights, model } = before);
    opened.dispose();
    throw error;
  }
  scene?.dispose();
  [scene, view, camera, kept, pointed] = [opened, made, undefined, undefined, undefined];
  isFixed = typeof settings["size"] === "string";
  picture.classList.toggle("fixed", isFixed);
  leaveCheck();
  const bounds = description.bounds;
  const radius = bounds ? Math.hypot(...bounds.max.map((far, axis) => far - bounds.min[axis]!)) / 2 : 1;
  tree.set(description.objects);
  const warnings = description.warnings.length > 0 ? `; ${description.warnings.join("; ")}` : "";
  byId("counts").textContent = `${description.triangles.toLocaleString("en")} triangles in ${description.objects.length.toLocaleString("en")} ${description.objects.length === 1 ? "object" : "objects"}${warnings}`;
  showLightPanel = () => showLights(byId("lights"), lights, radius, lightsChanged);
  lightsChanged = () => {
    hasLights = true;
    // Ambient light of the scene stays beside lights of the page.
    settings["ambient"] ??= description.ambient.join(",");
    changed();
  };
  showLightPanel();
  showSurface(byId("surface"), settings, description, words, changed);
  showPicture(byId("picture-settings"), settings, words, changed);
  byId("ledger").replaceChildren(element("p", { class: "quiet" }, "Point at the picture. A click keeps the pixel; a second one, or Escape, lets it go."));
  status.textContent = `${of.name}: point at the picture to see why it has its colour`;
  document.title = `${of.name}: luxel`;
  const demoChoice = byId<HTMLSelectElement>("demo");
  if (of.demo !== undefined) demoChoice.value = of.demo;
  else demoChoice.selectedIndex = -1;
  wanted = "full";
  await drawLoop();
}

function openDemo(name: string, given: PageSettings = {}): Promise<void> {
  return attempt(() => show(() => demo(name), { demo: name, name: `demo:${name}` }, given));
}

function openFiles(source: Source, name: string): Promise<void> {
  return attempt(() => show(() => load(source), { name }, { exposure: "auto" }));
}

function openSeveral(files: Map<string, File>): void {
  const names = [...files.keys()];
  const shownName = names.length === 1 ? names[0]! : `${names[0]!.split("/")[0]!}`;
  void openFiles(files, shownName);
}

// --- The page -------------------------------------------------------------------------------------

function download(data: Blob, name: string): void {
  const link = element("a", { href: URL.createObjectURL(data), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

async function copied(text: string, button: HTMLElement): Promise<void> {
  const label = button.textContent;
  await navigator.clipboard.writeText(text);
  button.textContent = "Copied";
  setTimeout(() => (button.textContent = label), 1500);
}

function stem(): string {
  return model.name.replace(/^demo:/, "").replace(/^.*\//, "").replace(/\.[^.]*$/, "") || "picture";
}

function connect(): void {
  for (const layer of LAYERS) layerChoice.append(element("option", {}, layer));
  for (const mode of MODES) modeChoice.append(element("option", {}, mode));
  layerChoice.addEventListener("change", () => {
    leaveCheck();
    redraw();
  });
  modeChoice.addEventListener("change", () => move(["set_mode", modeChoice.value]));
  const files = byId<HTMLInputElement>("files");
  byId("open").addEventListener("click", () => files.click());
  files.addEventListener("change", () => {
    const chosen = new Map([...(files.files ?? [])].map((file) => [file.name, file] as const));
    if (chosen.size > 0) openSeveral(chosen);
    files.value = "";
  });
  byId<HTMLSelectElement>("demo").addEventListener("change", ({ target }) => {
    void openDemo((target as HTMLSelectElement).value);
  });
  byId<HTMLInputElement>("show-handles").addEventListener("change", ({ target }) => {
    void attempt(() => handles.show((target as HTMLInputElement).checked));
  });
  byId("check").addEventListener("click", () => void attempt(check));
  byId("close-check").addEventListener("click", () => {
    leaveCheck();
    redraw();
  });
  byId("screenshot").addEventListener("click", () => {
    void attempt(async () => {
      if (view) download(await view.png(), `${stem()}.png`);
    });
  });
  byId("link").addEventListener("click", ({ currentTarget }) => {
    const hash = writeLink(model.demo, portableSettings());
    history.replaceState(null, "", hash);
    void attempt(() => copied(location.href, currentTarget as HTMLElement));
  });
  byId("copy-command").addEventListener("click", ({ currentTarget }) => {
    void attempt(() => copied(byId("command").textContent ?? "", currentTarget as HTMLElement));
  });
  byId("save-log").addEventListener("click", () => {
    void attempt(async () => {
      if (view) download(new Blob([await view.log()], { type: "text/plain" }), `${stem()}.log`);
    });
  });
  byId("help").addEventListener("click", () => byId<HTMLDialogElement>("keys").showModal());
  listenToDrops(byId("drop"), openSeveral);
  const hand = {
    place: (event: { clientX: number; clientY: number }): [number, number] => {
      const box = canvas.getBoundingClientRect();
      const scale = Math.min(box.width / canvas.width, box.height / canvas.height);
      const left = box.left + (box.width - canvas.width * scale) / 2;
      const top = box.top + (box.height - canvas.height * scale) / 2;
      return [(event.clientX - left) / scale, (event.clientY - top) / scale];
    },
    move,
    hover: (at: [number, number] | undefined) => {
      pointed = at && pixelAt(at);
      void ask();
    },
    click: (at: [number, number]) => keep(pixelAt(at)),
    key: (event: KeyboardEvent) => {
      if (event.key === "Escape") keep(undefined);
      else if (event.key === " ") keep([Math.floor(canvas.width / 2), Math.floor(canvas.height / 2)]);
      else return false;
      return true;
    },
  };
  listen(canvas, hand, () => camera?.mode ?? "turntable");
  new ResizeObserver(() => {
    if (!isFixed && view !== undefined && sizeOfPage() !== `${canvas.width}x${canvas.height}`) apply();
  }).observe(picture);
  addEventListener("hashchange", () => {
    const link = readLink(location.hash);
    void openDemo(link.demo ?? "teapot", link.settings);
  });
}

async function begin(): Promise<void> {
  connect();
  canvas.classList.add("waits");
  const link = readLink(location.hash);
  if (typeof link.settings["size"] === "string") {
    isFixed = true;
    byId("still").hidden = true;
  }
  const name = link.demo ?? "teapot";
  if (name !== "teapot" || location.hash.length > 1) byId("still").hidden = true;
  await openDemo(name, link.settings);
  await attempt(async () => {
    const list = await demos();
    const choice = byId<HTMLSelectElement>("demo");
    choice.replaceChildren(...list.map(({ name, about }) => element("option", { title: about }, name)));
    choice.value = name;
  });
}

offer(begin(), {
  pixels: (of) => drawnPixels.get(of ?? canvas),
  explain: async (x, y) => {
    await settled();
    if (view === undefined) throw new LuxelError("there is no picture");
    return view.explain(x, y);
  },
  settled,
});
