/** Numbers in a text that can be dragged, typed and stepped by keys. */

import { element } from "./dom.ts";
import type { FigureNumber } from "./figures/figure.ts";

/** Pixels of the page for a whole range. */
const RANGE = 260;

/** A number in as many digits as its step has. */
export function shown(value: number, step: number): string {
  const digits = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
  return value.toFixed(digits).replace("-", "−");
}

/** A slider in a line of text: drag sideways, or use the arrows, Page keys, Home and End. */
export function draggable(of: FigureNumber, change: (value: number) => void): { element: HTMLElement; set(value: number): void } {
  const { min, max, step, meaning, symbol } = of;
  let value = of.value;
  const label = symbol === "" ? meaning : `${symbol.replace("_", " ")}, ${meaning}`;
  const made = element("span", {
    class: "number",
    role: "slider",
    tabindex: "0",
    "aria-label": label,
    "aria-valuemin": String(min),
    "aria-valuemax": String(max),
    title: `${label}: drag, or use the arrow keys`,
  });
  const show = (): void => {
    made.textContent = shown(value, step);
    made.setAttribute("aria-valuenow", String(value));
  };
  const set = (wanted: number): void => {
    const steps = Math.round((Math.min(Math.max(wanted, min), max) - min) / step);
    value = Number((min + steps * step).toPrecision(10));
    show();
  };
  const move = (wanted: number): void => {
    const before = value;
    set(wanted);
    if (value !== before) change(value);
  };
  let from: { x: number; value: number } | undefined;
  made.addEventListener("pointerdown", (event) => {
    made.setPointerCapture(event.pointerId);
    from = { x: event.clientX, value };
    made.focus();
    event.preventDefault();
  });
  made.addEventListener("pointermove", (event) => {
    if (from) move(from.value + ((event.clientX - from.x) / RANGE) * (max - min));
  });
  for (const end of ["pointerup", "pointercancel"] as const) made.addEventListener(end, () => (from = undefined));
  made.addEventListener("keydown", (event) => {
    const large = Math.max(step, (max - min) / 10);
    const steps: Record<string, number> = {
      ArrowRight: value + step,
      ArrowUp: value + step,
      ArrowLeft: value - step,
      ArrowDown: value - step,
      PageUp: value + large,
      PageDown: value - large,
      Home: min,
      End: max,
    };
    const wanted = steps[event.key];
    if (wanted !== undefined) {
      move(wanted);
      event.preventDefault();
    }
  });
  show();
  return { element: made, set };
}
