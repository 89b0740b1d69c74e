/** The laboratory of lights: each light of the scene with its numbers, as `--light` takes them. */

import { element } from "./dom.ts";
import { choiceRow, colorRow, numberRow, switchOf, vectorRow } from "./fields.ts";

/** A light: its kind and its fields by their names in a specification. */
export interface Light {
  kind: string;
  fields: Map<string, string>;
  isOn: boolean;
}

/** Reads `point:pos=1,2,3:name=key`. */
export function parseLight(text: string): Light {
  const [kind = "", ...rest] = text.split(":");
  const fields = new Map<string, string>();
  for (const part of rest) {
    const at = part.indexOf("=");
    fields.set(part.slice(0, at), part.slice(at + 1));
  }
  return { kind, fields, isOn: true };
}

/** Writes a light as `parseLight` reads it. */
export function lightText({ kind, fields }: Light): string {
  return [kind, ...[...fields].map(([name, value]) => `${name}=${value}`)].join(":");
}

const KINDS = ["directional", "point", "spot", "ambient"];

/** What a light of a kind has by default where the model is of a size. */
function fresh(kind: string, name: string, radius: number): Light {
  const far = Number((radius * 2).toPrecision(3));
  const fields = new Map<string, string>();
  if (kind === "directional") fields.set("dir", "-1,-2,-3");
  if (kind === "point" || kind === "spot") fields.set("pos", `${far},${far},${far}`);
  if (kind === "spot") fields.set("dir", "-1,-1,-1").set("cutoff", "30").set("exponent", "2");
  if (kind === "ambient") fields.set("color", "0.1,0.1,0.1");
  else fields.set("diffuse", "0.8,0.8,0.8");
  fields.set("name", name);
  return { kind, fields, isOn: true };
}

function numbers(text: string | undefined, otherwise: number[]): number[] {
  const parsed = (text ?? "").split(",").map(Number);
  return parsed.length === otherwise.length && parsed.every(Number.isFinite) ? parsed : otherwise;
}

/** The name of a light, which is the one at this place of the list. */
export function nameOf(light: Light, at: number): string {
  return light.fields.get("name") ?? `${light.kind} ${at + 1}`;
}

/** The colour of a light, the brightest of its channels at most 1. */
export function colorOf({ kind, fields }: Light): number[] {
  const color = numbers(fields.get(kind === "ambient" ? "color" : "diffuse"), [1, 1, 1]);
  const most = Math.max(1e-6, ...color);
  return color.map((part) => Math.max(0, part) / most);
}

/** The rows of a light's numbers. */
function rows(light: Light, changed: () => void): HTMLElement[] {
  const { kind, fields } = light;
  const set = (name: string, value: string): void => {
    fields.set(name, value);
    changed();
  };
  const vector = (name: string, label: string, otherwise: number[]): HTMLElement[] =>
    vectorRow(label, numbers(fields.get(name), otherwise), (value) => {
      // A direction needs a length.
      if (name !== "dir" || value.some((part) => part !== 0)) set(name, value.join(","));
    });
  const color = (name: string, label: string, otherwise: number[]): HTMLElement[] =>
    colorRow(label, numbers(fields.get(name), otherwise), (value) => set(name, value.join(",")));
  const number = (name: string, label: string, otherwise: number, min: number, max: number, step: number): HTMLElement[] =>
    numberRow({ label, value: Number(fields.get(name) ?? otherwise), min, max, step, change: (value) => set(name, String(Math.max(min, value))) });
  if (kind === "ambient") {
    return color("color", "I_a", [1, 1, 1]);
  }
  const diffuse = numbers(fields.get("diffuse"), [1, 1, 1]);
  const made: HTMLElement[] = [];
  if (kind === "directional" || kind === "spot") made.push(...vector("dir", "direction", [0, -1, 0]));
  if (kind === "point" || kind === "spot") made.push(...vector("pos", "position", [0, 0, 0]));
  made.push(...color("diffuse", "I_d", [1, 1, 1]), ...color("specular", "I_s", diffuse), ...color("ambient", "I_a", [0, 0, 0]));
  if (kind === "spot") {
    made.push(...number("cutoff", "cutoff °", 45, 0, 90, 1), ...number("exponent", "exponent", 0, 0, 64, 0.5));
  }
  if (kind === "point" || kind === "spot") {
    made.push(...vector("attenuation", "c1 c2 c3", [1, 0, 0]));
    made.push(...number("radius", "radius", 0, 0, 2, 0.01));
  } else {
    made.push(...number("angle", "angle °", 0, 0, 30, 0.5));
  }
  made.push(
    ...choiceRow("fixed to", ["world", "camera"], fields.get("in") ?? "world", (value) => set("in", value)),
  );
  return made;
}

/** Shows lights in a panel, and calls `changed` after each change. */
export function showLights(panel: HTMLElement, lights: Light[], radius: number, changed: () => void): void {
  const again = (): void => {
    showLights(panel, lights, radius, changed);
    changed();
  };
  const made = lights.map((light, at) => {
    const name = nameOf(light, at);
    const remove = element("button", { type: "button", "aria-label": `Remove ${name}` }, "Remove");
    remove.addEventListener("click", () => {
      lights.splice(at, 1);
      again();
    });
    const on = switchOf(name, light.isOn, (isOn) => {
      light.isOn = isOn;
      changed();
    });
    const header = element("header", {}, on, element("span", { class: "quiet" }, light.kind), remove);
    return element("div", { class: "light" }, header, element("div", { class: "fields" }, ...rows(light, changed)));
  });
  const kind = element("select", { "aria-label": "Kind of the new light" }, ...KINDS.map((one) => element("option", {}, one)));
  const add = element("button", { type: "button" }, "Add a light");
  add.addEventListener("click", () => {
    const taken = new Set(lights.map(nameOf));
    let number = lights.length + 1;
    while (taken.has(`light ${number}`)) number++;
    lights.push(fresh(kind.value, `light ${number}`, radius));
    again();
  });
  panel.replaceChildren(...made, element("p", {}, kind, " ", add));
}
