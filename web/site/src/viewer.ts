/** The viewer: drop a model, turn it, ask a pixel. */

import {
  demo,
  demos,
  isEnvironment,
  isModel,
  load,
  LuxelError,
  vocabulary,
  WorkerEndedError,
  type CameraState,
  type LayerName,
  type NavigationEvent,
  type Scene,
  type Settings,
  type Source,
  type View,
  type Vocabulary,
} from "luxel";
import { Asking } from "./asking.ts";
import { byId, element } from "./dom.ts";
import { listenToDrops } from "./dropping.ts";
import { Handles } from "./handles.ts";
import { sentence, showLedger } from "./ledger.ts";
import { lightText, parseLight, showLights, type Light } from "./lights.ts";
import { command, readLink, withoutFiles, writeLink } from "./link.ts";
import { showVectors } from "./overlay.ts";
import { Painting } from "./painting.ts";
import { listen, MODES } from "./pointing.ts";
import { copied, download } from "./saving.ts";
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
/** The environments that were opened for the scene. */
let environments: string[] = [];
let showPicturePanel = (): void => {};
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
    void painting.redraw();
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

/** Does something with a view, and shows why it failed if the view is still the page's. */
function attemptWith(of: View | undefined, work: () => Promise<void>): Promise<void> {
  return attempt(async () => {
    try {
      await work();
    } catch (error) {
      if (of === view) throw error;
    }
  });
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

const painting = new Painting(canvas, {
  view: () => view,
  layer: () => layerChoice.value as "picture" | LayerName,
  isMarked: () => isChecked,
  attempt: attemptWith,
  moved: (state) => {
    camera = state;
    modeChoice.value = state.mode;
    if (isChecked) leaveCheck();
  },
  shown: () => {
    canvas.classList.remove("waits");
    byId("still").hidden = true;
    if (performance.getEntriesByName("first picture").length === 0) performance.mark("first picture");
  },
  rested: async () => {
    await attempt(() => handles.update());
    showCommand();
    asking.again();
  },
});

// --- Settings -------------------------------------------------------------------------------------

let applying: Promise<void> | undefined;
let isStale = false;

/** Applies the settings as they are then, once for all changes of a moment. */
function changed(): void {
  message.hidden = true;
  apply();
}

function apply(): void {
  isStale = true;
  applying ??= (async () => {
    while (isStale && view !== undefined) {
      isStale = false;
      const current = view;
      await attemptWith(current, async () => {
        await current.set(allSettings());
        void painting.redraw();
      });
    }
    applying = undefined;
  })();
}

/** Waits until no light moves, and nothing is left to apply or to draw. */
async function settled(): Promise<void> {
  await handles.settled();
  await applying;
  await painting.settled();
}

function showCommand(): void {
  byId("command").textContent = command(model.name, portableSettings());
}

// --- Explaining -----------------------------------------------------------------------------------

/** Where the picture is in the page: its upper left corner in the window, and the page's pixels for one of its own. */
function shownAt(): { left: number; top: number; scale: number } {
  const box = canvas.getBoundingClientRect();
  const scale = Math.min(box.width / canvas.width, box.height / canvas.height);
  return {
    left: box.left + (box.width - canvas.width * scale) / 2,
    top: box.top + (box.height - canvas.height * scale) / 2,
    scale,
  };
}

/** The place of a pixel's centre over the picture, in pixels of the page; a picture that is too large scrolls. */
function placeOf([x, y]: readonly [number, number]): [number, number] {
  const { left, top, scale } = shownAt();
  const outer = picture.getBoundingClientRect();
  const [right, down] = [picture.scrollLeft - outer.left, picture.scrollTop - outer.top];
  return [left + right + (x + 0.5) * scale, top + down + (y + 0.5) * scale];
}

const asking = new Asking({
  view: () => view,
  isMarked: () => isChecked,
  isDrawing: () => painting.isDrawing,
  answered: (ledger, at, index) => {
    showLedger(byId("ledger"), ledger, asking.isKept);
    showVectors(overlay, ledger, placeOf(at));
    status.textContent = sentence(ledger);
    canvas.setAttribute("aria-label", `${model.name}. ${sentence(ledger)}`);
    tree.mark(index);
  },
  left: () => showVectors(overlay, undefined, [0, 0]),
});

const handles = new Handles(document.getElementById("handles") as unknown as SVGElement, {
  view: () => view,
  lights: () => lights,
  middle: () => [canvas.width / 2, canvas.height / 2],
  toPage: ([x, y]) => placeOf([x - 0.5, y - 0.5]),
  wayToPicture: ([right, down]) => {
    const { scale } = shownAt();
    return [right / scale, down / scale];
  },
  changed: () => {
    showLightPanel();
    lightsChanged();
  },
});

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
  asking.again();
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
  [scene, view, camera, environments] = [opened, made, undefined, []];
  asking.forget();
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
  showPicturePanel = () => showPicture(byId("picture-settings"), settings, words, environments, changed);
  showPicturePanel();
  byId("ledger").replaceChildren(element("p", { class: "quiet" }, "Point at the picture. A click keeps the pixel; a second one, or Escape, lets it go."));
  status.textContent = `${of.name}: point at the picture to see why it has its colour`;
  document.title = `${of.name}: luxel`;
  const demoChoice = byId<HTMLSelectElement>("demo");
  if (of.demo !== undefined) demoChoice.value = of.demo;
  else demoChoice.selectedIndex = -1;
  await painting.redraw();
}

function openDemo(name: string, given: PageSettings = {}): Promise<void> {
  return attempt(() => show(() => demo(name), { demo: name, name: `demo:${name}` }, given));
}

function openFiles(source: Source, name: string): Promise<void> {
  return attempt(() => show(() => load(source), { name }, { exposure: "auto" }));
}

/** Puts the scene into the environment of a picture. */
function surround(file: File): Promise<void> {
  return attempt(async () => {
    const of = scene;
    if (of === undefined) return;
    message.hidden = true;
    status.textContent = `reading ${file.name} ...`;
    const { name, warnings } = await of.addEnvironment(file);
    if (of !== scene) return;
    if (!environments.includes(name)) environments.push(name);
    settings["environment"] = name;
    showPicturePanel();
    apply();
    status.textContent = [`${name} is the environment`, ...warnings].join("; ");
  });
}

function openSeveral(files: Map<string, File>): void {
  const names = [...files.keys()];
  const environment = names.some(isModel) ? undefined : names.find(isEnvironment);
  if (environment !== undefined) {
    void surround(files.get(environment)!);
    return;
  }
  const shownName = names.length === 1 ? names[0]! : `${names[0]!.split("/")[0]!}`;
  void openFiles(files, shownName);
}

// --- The page -------------------------------------------------------------------------------------

function stem(): string {
  return model.name.replace(/^demo:/, "").replace(/^.*\//, "").replace(/\.[^.]*$/, "") || "picture";
}

function connect(): void {
  for (const layer of LAYERS) layerChoice.append(element("option", {}, layer));
  for (const mode of MODES) modeChoice.append(element("option", {}, mode));
  layerChoice.addEventListener("change", () => {
    leaveCheck();
    void painting.redraw();
  });
  modeChoice.addEventListener("change", () => painting.move(["set_mode", modeChoice.value]));
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
    void painting.redraw();
  });
  byId("screenshot").addEventListener("click", () => {
    void attempt(async () => {
      if (view) download(await view.png(), `${stem()}.png`);
    });
  });
  byId("link").addEventListener("click", ({ currentTarget }) => {
    const hash = writeLink(model.demo, withoutFiles(portableSettings(), environments));
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
      const { left, top, scale } = shownAt();
      return [(event.clientX - left) / scale, (event.clientY - top) / scale];
    },
    move: (...events: NavigationEvent[]) => painting.move(...events),
    hover: (at: [number, number] | undefined) => {
      asking.point(at && pixelAt(at));
    },
    click: (at: [number, number]) => asking.keep(pixelAt(at)),
    key: (event: KeyboardEvent) => {
      if (event.key === "Escape") asking.keep(undefined);
      else if (event.key === " ") asking.keep([Math.floor(canvas.width / 2), Math.floor(canvas.height / 2)]);
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
  pixels: (of) => (of === undefined || of === canvas ? painting.pixels : undefined),
  explain: async (x, y) => {
    await settled();
    if (view === undefined) throw new LuxelError("there is no picture");
    return view.explain(x, y);
  },
  settled,
});
