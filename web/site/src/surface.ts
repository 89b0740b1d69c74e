/** Controls of surfaces, shading and the picture, as flags of the program. */

import type { Description } from "luxel";
import { element } from "./dom.ts";
import { choiceRow, colorRow, numberRow, switchOf } from "./fields.ts";

/** The settings of the page, by the names of flags. */
export type PageSettings = Record<string, string | string[] | boolean>;

const SAME = "as in the file";
const REFLECTIONS = [SAME, "unlit", "lambert", "oren-nayar", "phong", "blinn-phong", "toon", "microfacet", "mirror", "retro"];
const SHADINGS = ["phong", "gouraud", "flat", "subdivided"];

function set(settings: PageSettings, name: string, value: string | boolean | undefined, changed: () => void): void {
  if (value === undefined || value === false) delete settings[name];
  else settings[name] = value;
  changed();
}

/** Material and shading. */
export function showSurface(panel: HTMLElement, settings: PageSettings, description: Description, changed: () => void): void {
  const first = description.materials[0];
  const number = (name: string, label: string, otherwise: number, max: number, step: number): HTMLElement[] => {
    const inFile = first?.[name];
    const value = Number(settings[name] ?? (typeof inFile === "number" ? inFile : otherwise));
    return numberRow({ label, value, min: 0, max, step, change: (typed) => set(settings, name, String(Math.max(0, typed)), changed) });
  };
  const color = typeof settings["color"] === "string" ? settings["color"].split(",").map(Number) : (first?.color ?? [0.6, 0.57, 0.52]);
  const rows = [
    ...choiceRow("reflection", REFLECTIONS, (settings["reflection"] as string) ?? SAME, (value) =>
      set(settings, "reflection", value === SAME ? undefined : value, changed),
    ),
    ...colorRow("O_d", color, (value) => set(settings, "color", value.join(","), changed)),
    ...number("ka", "k_a", 1, 1, 0.01),
    ...number("kd", "k_d", 1, 1, 0.01),
    ...number("ks", "k_s", 0.2, 1, 0.01),
    ...number("shininess", "n", 32, 256, 1),
    ...number("roughness", "roughness", 0.5, 1, 0.01),
    ...number("metallic", "metallic", 0, 1, 0.01),
    ...choiceRow("shading", SHADINGS, (settings["shading"] as string) ?? "phong", (value) =>
      set(settings, "shading", value === "phong" ? undefined : value, changed),
    ),
  ];
  const reset = element("button", { type: "button" }, "As in the file");
  reset.addEventListener("click", () => {
    for (const name of ["reflection", "color", "ka", "kd", "ks", "shininess", "roughness", "metallic", "emission", "shading"]) {
      delete settings[name];
    }
    showSurface(panel, settings, description, changed);
    changed();
  });
  panel.replaceChildren(element("div", { class: "fields" }, ...rows), reset);
}

/** Shadows, occlusion, exposure and samples. */
export function showPicture(panel: HTMLElement, settings: PageSettings, changed: () => void): void {
  const flag = (name: string, label: string): HTMLElement =>
    switchOf(label, settings[name] !== undefined, (isOn) => set(settings, name, isOn, changed));
  const rows = [
    ...choiceRow("samples", ["1", "2", "4", "8", "16"], String(settings["samples"] ?? "4"), (value) =>
      set(settings, "samples", value === "4" ? undefined : value, changed),
    ),
    ...choiceRow("background", ["transparent", "studio", "white", "black"], String(settings["background"] ?? "transparent"), (value) =>
      set(settings, "background", value === "transparent" ? undefined : value, changed),
    ),
    ...choiceRow("exposure", ["0", "auto", "-2", "-1", "1", "2"], String(settings["exposure"] ?? "0"), (value) =>
      set(settings, "exposure", value === "0" ? undefined : value, changed),
    ),
    ...choiceRow("tone", ["none", "neutral", "aces", "agx"], String(settings["tone"] ?? "none"), (value) =>
      set(settings, "tone", value === "none" ? undefined : value, changed),
    ),
    ...choiceRow("environment", ["default", "none", "studio"], String(settings["environment"] ?? "default"), (value) =>
      set(settings, "environment", value === "default" ? undefined : value, changed),
    ),
    ...choiceRow("faces", ["auto", "none", "back"], String(settings["cull"] ?? "auto"), (value) =>
      set(settings, "cull", value === "auto" ? undefined : value, changed),
    ),
  ];
  const switches = element(
    "div",
    { class: "switches" },
    flag("shadows", "shadows"),
    flag("ao", "occlusion"),
    flag("ground", "ground"),
    flag("wireframe", "wireframe"),
    flag("edges", "edges"),
  );
  panel.replaceChildren(switches, element("div", { class: "fields" }, ...rows));
}
