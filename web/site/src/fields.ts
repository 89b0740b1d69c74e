/** Native controls for numbers, colours and choices. */

import { element } from "./dom.ts";

let next = 0;

/** A number with a slider. */
export interface NumberField {
  label: string;
  value: number;
  min: number;
  max: number;
  step: number;
  change(value: number): void;
}

/** A row of a label, a slider and a number. The slider covers the usual range; the number takes any. */
export function numberRow({ label, value, min, max, step, change }: NumberField): HTMLElement[] {
  const id = `field-${next++}`;
  const bounds = { min: String(min), max: String(max), step: String(step) };
  const slider = element("input", { type: "range", ...bounds, "aria-label": label, tabindex: "-1" });
  const number = element("input", { type: "number", id, step: "any" });
  slider.value = number.value = String(value);
  slider.addEventListener("input", () => {
    number.value = slider.value;
    change(Number(slider.value));
  });
  number.addEventListener("input", () => {
    const typed = Number(number.value);
    if (number.value !== "" && Number.isFinite(typed)) {
      slider.value = number.value;
      change(typed);
    }
  });
  return [element("label", { for: id }, label), slider, number];
}

/** A row of a label and numbers of a vector. */
export function vectorRow(label: string, value: readonly number[], change: (value: number[]) => void): HTMLElement[] {
  const current = [...value];
  const inputs = current.map((part, axis) => {
    const name = `${label} ${"xyz"[axis] ?? axis + 1}`;
    const input = element("input", { type: "number", step: "0.1", "aria-label": name, value: String(part) });
    input.addEventListener("input", () => {
      const typed = Number(input.value);
      if (input.value !== "" && Number.isFinite(typed)) {
        current[axis] = typed;
        change([...current]);
      }
    });
    return input;
  });
  return [element("span", { class: "quiet" }, label), element("span", { class: "wide" }, ...inputs)];
}

/** A row of a label and a colour. Beyond white it is scaled by a number of its own. */
export function colorRow(
  label: string,
  value: readonly number[],
  change: (value: [number, number, number]) => void,
): HTMLElement[] {
  const id = `field-${next++}`;
  const most = Math.max(1, ...value);
  let [color, scale] = [value.map((part) => part / most), most];
  const well = element("input", { type: "color", id, value: hexOf(color) });
  const times = element("input", { type: "number", min: "0", step: "0.1", "aria-label": `${label}, times`, value: String(Number(scale.toPrecision(4))) });
  const tell = (): void => {
    // Black stays black, times any number.
    times.disabled = color.every((part) => part === 0);
    change(color.map((part) => part * scale) as [number, number, number]);
  };
  times.disabled = color.every((part) => part === 0);
  well.addEventListener("input", () => {
    color = linearOf(well.value);
    tell();
  });
  times.addEventListener("input", () => {
    const typed = Number(times.value);
    if (times.value !== "" && typed >= 0 && Number.isFinite(typed)) {
      scale = typed;
      tell();
    }
  });
  return [element("label", { for: id }, label), well, times];
}

/** A row of a label and a choice. */
export function choiceRow(
  label: string,
  choices: readonly string[],
  value: string,
  change: (value: string) => void,
): HTMLElement[] {
  const id = `field-${next++}`;
  const select = element("select", { id }, ...choices.map((choice) => element("option", {}, choice)));
  if (!choices.includes(value)) {
    select.append(element("option", {}, value));
  }
  select.value = value;
  select.addEventListener("change", () => change(select.value));
  return [element("label", { for: id }, label), element("span", { class: "wide" }, select)];
}

/** A switch. */
export function switchOf(label: string, value: boolean, change: (value: boolean) => void): HTMLElement {
  const box = element("input", { type: "checkbox" });
  box.checked = value;
  box.addEventListener("change", () => change(box.checked));
  return element("label", {}, box, label);
}

/** The curve of sRGB (IEC 61966-2-1), from linear light to a byte and back. */
function encoded(light: number): number {
  const part = Math.min(Math.max(light, 0), 1);
  return Math.round(255 * (part <= 0.0031308 ? 12.92 * part : 1.055 * part ** (1 / 2.4) - 0.055));
}

function decoded(byte: number): number {
  const part = byte / 255;
  return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
}

/** Linear light as `#rrggbb`. */
export function hexOf(color: readonly number[]): string {
  return `#${color.map((part) => encoded(part).toString(16).padStart(2, "0")).join("")}`;
}

/** `#rrggbb` as linear light. */
export function linearOf(hex: string): [number, number, number] {
  const byte = (at: number): number => decoded(parseInt(hex.slice(at, at + 2), 16));
  return [byte(1), byte(3), byte(5)].map((part) => Number(part.toFixed(5))) as [number, number, number];
}
