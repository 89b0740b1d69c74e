/** Controls of surfaces, shading and the picture, as flags of the program. */

import type { Description, Vocabulary } from "luxel";
import { element } from "./dom.ts";
import { choiceRow, colorRow, numberRow, switchOf } from "./fields.ts";

/** The settings of the page, by the names of flags. */
export type PageSettings = Record<string, string | string[] | boolean>;

const SAME = "as in the file";

function set(settings: PageSettings, name: string, value: string | boolean | undefined, changed: () => void): void {
  if (value === undefined || value === false) delete settings[name];
  else settings[name] = value;
  changed();
}

/** Material and shading: the parameters that the reflection model heeds. */
export function showSurface(
  panel: HTMLElement,
  settings: PageSettings,
  description: Description,
  vocabulary: Vocabulary,
  changed: () => void,
): void {
  const again = (): void => {
    showSurface(panel, settings, description, vocabulary, changed);
    changed();
  };
  const first = description.materials[0];
  const chosen = settings["reflection"] as string | undefined;
  const name = (chosen ?? first?.reflection ?? "").split(":")[0];
  const model = vocabulary.reflections.find((one) => one.name === name);
  const numbers = (model?.parameters ?? []).flatMap((parameter) => {
    const { name, symbol, is_whole, slider_end } = parameter;
    const inFile = first?.[name];
    const value = Number(settings[name] ?? (typeof inFile === "number" ? inFile : parameter.default));
    const shown = Number(value.toPrecision(6));
    const step = is_whole || slider_end > 50 ? 1 : slider_end / 100;
    const change = (typed: number): void => set(settings, name, String(Math.max(is_whole ? 1 : 0, typed)), changed);
    return numberRow({ label: symbol, value: shown, min: 0, max: slider_end, step, change });
  });
  const given = settings["color"];
  const color = typeof given === "string" ? given.split(",").map(Number) : (first?.color ?? [0.6, 0.57, 0.52]);
  const rows = [
    ...choiceRow("reflection", [SAME, ...vocabulary.reflections.map((one) => one.name)], chosen ?? SAME, (value) => {
      if (value === SAME) delete settings["reflection"];
      else settings["reflection"] = value;
      again();
    }),
    ...colorRow("O_d", color, (value) => set(settings, "color", value.join(","), changed)),
    ...numbers,
    ...choiceRow("shading", vocabulary.shadings.map((one) => one.name), (settings["shading"] as string) ?? "phong", (value) =>
      set(settings, "shading", value === "phong" ? undefined : value, changed),
    ),
  ];
  const reset = element("button", { type: "button" }, "As in the file");
  reset.addEventListener("click", () => {
    const parameters = vocabulary.reflections.flatMap((one) => one.parameters.map((parameter) => parameter.name));
    for (const name of ["reflection", "color", "emission", "shading", ...parameters]) delete settings[name];
    again();
  });
  const help = element("p", { class: "quiet" }, model === undefined ? "" : `${model.name}: ${model.help}`);
  panel.replaceChildren(element("div", { class: "fields" }, ...rows), help, reset);
}

/** Shadows, occlusion, exposure, samples and the environment, which may be one of the `environments` that were opened. */
export function showPicture(
  panel: HTMLElement,
  settings: PageSettings,
  vocabulary: Vocabulary,
  environments: readonly string[],
  changed: () => void,
): void {
  const flag = (name: string, label: string): HTMLElement =>
    switchOf(label, settings[name] !== undefined, (isOn) => set(settings, name, isOn, changed));
  const turned = numberRow({
    label: "turned °",
    value: Number(settings["environment-rotation"] ?? 0),
    min: -180,
    max: 180,
    step: 1,
    change: (degrees) => set(settings, "environment-rotation", degrees === 0 ? undefined : String(degrees), changed),
  });
  const [, ...turnedInputs] = turned as [HTMLElement, ...HTMLInputElement[]];
  /** Only pictures turn. */
  const showTurned = (): void => {
    const isPicture = environments.includes(String(settings["environment"]));
    for (const part of turned) part.hidden = !isPicture;
    if (isPicture) return;
    delete settings["environment-rotation"];
    for (const input of turnedInputs) input.value = "0";
  };
  showTurned();
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
    ...choiceRow("tone", vocabulary.tones.map((one) => one.name), String(settings["tone"] ?? "none"), (value) =>
      set(settings, "tone", value === "none" ? undefined : value, changed),
    ),
    ...choiceRow("environment", ["default", "none", "studio", ...environments], String(settings["environment"] ?? "default"), (value) => {
      set(settings, "environment", value === "default" ? undefined : value, showTurned);
      changed();
    }),
    ...turned,
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
    flag("environment-background", "environment behind"),
  );
  panel.replaceChildren(switches, element("div", { class: "fields" }, ...rows));
}
