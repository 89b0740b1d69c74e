/** The ledger of a pixel: its colour, its terms as a bar, and the equation with its numbers. */

import type { Ledger, LedgerLine, LedgerSurface } from "luxel";
import { element } from "./dom.ts";
import { formula } from "./formula.ts";

const KINDS = ["ambient", "diffuse", "specular", "emission", "environment", "fog"] as const;

/** A number in three digits. */
function short(value: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e4 || size < 1e-4 ? value.toExponential(2) : String(Number(value.toPrecision(3)));
}

function columns(values: readonly (string | number)[]): string {
  return values.map((value) => (typeof value === "number" ? short(value) : value).padStart(7)).join(" ");
}

/** The relative luminance of linear light (ITU-R BT.709). */
function luminance([r, g, b]: readonly [number, number, number]): number {
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** The nearest surface that a pixel shows. */
export function surfaceOf(ledger: Ledger): LedgerSurface | undefined {
  const layers = ledger.samples.flatMap((sample) => sample.layers);
  return layers.find((layer): layer is LedgerSurface => layer.what === "surface");
}

/** What a pixel shows, in one sentence. */
export function sentence(ledger: Ledger): string {
  const [x, y] = ledger.pixel;
  const surface = surfaceOf(ledger);
  if (surface === undefined) {
    const ground = ledger.samples.some((sample) => sample.layers.some((layer) => layer.what === "ground"));
    return `Pixel ${x}, ${y}: ${ground ? "the ground" : "the background"}`;
  }
  const most = KINDS.map((kind) => ({ kind, light: luminance(surface.terms[kind]) })).sort((a, b) => b.light - a.light)[0]!;
  const triangle = surface.triangle === null ? "" : `, triangle ${surface.triangle}`;
  const kind = most.kind === "fog" ? "fog" : `${most.kind} light`;
  const light = most.light > 0 ? `, mostly ${kind}` : ", without light";
  return `Pixel ${x}, ${y}: ${surface.path.join(" / ") || surface.object}${triangle}${light}`;
}

function bar(surface: LedgerSurface): HTMLElement {
  const parts = KINDS.map((kind) => ({ kind, light: Math.max(luminance(surface.terms[kind]), 0) }));
  const all = parts.reduce((sum, part) => sum + part.light, 0);
  const stack = element("div", { class: "stack", role: "img" });
  const shown = parts.filter((part) => part.light > 0);
  for (const { kind, light } of shown) {
    const share = (light / all) * 100;
    stack.append(element("span", { class: kind, style: `width:${share}%`, title: `${kind}: ${share.toFixed(1)} %` }));
  }
  const spoken = shown.map(({ kind, light }) => `${kind} ${((light / all) * 100).toFixed(0)} percent`);
  stack.setAttribute("aria-label", spoken.join(", ") || "no light");
  return stack;
}

function line(of: LedgerLine): HTMLElement[] {
  switch (of.what) {
    case "heading":
      return [element("h3", {}, of.name), ...of.facts.map((fact) => element("p", { class: "quiet" }, fact))];
    case "note":
      return [element("p", { class: "quiet" }, of.text)];
    case "term": {
      const name = element("span", { class: of.is_part ? "" : `swatch ${of.kind}` }, of.name);
      const row = element("div", { class: "row" }, name, element("span", { class: "num" }, columns(of.value)));
      const product = element("div", { class: "product" }, "= ");
      of.factors.forEach((factor) => {
        product.append(element("abbr", { title: factor.meaning }, formula(factor.symbol)), " ");
      });
      const numbers = of.factors.map((factor) => factor.number).join(" × ");
      return [row, product, element("div", { class: "quiet" }, `= ${numbers}`)];
    }
    case "sum": {
      const name = element("span", { class: `swatch ${of.kind}` }, of.name);
      const row = element("div", { class: "row" }, name, element("span", { class: "num" }, columns(of.value)));
      return of.note === "" ? [row] : [row, element("p", { class: "quiet" }, of.note)];
    }
  }
}

function surfaceOfPage(surface: LedgerSurface): HTMLElement[] {
  const path = surface.path.join(" / ") || surface.object;
  const place = surface.position.map(short).join(", ");
  const triangle = surface.triangle === null ? "" : `, triangle ${surface.triangle}`;
  const material = surface.material === "" ? "" : `; material ${surface.material}`;
  return [
    element("p", {}, element("strong", {}, path), triangle),
    element("p", { class: "quiet num" }, `at ${place}${material}`),
    bar(surface),
    element("div", { class: "equation" }, ...surface.lines.flatMap(line)),
  ];
}

/** Shows a ledger in a panel. */
export function showLedger(panel: HTMLElement, ledger: Ledger, isKept: boolean): void {
  const [r, g, b, a] = ledger.rgba8;
  const hex = [r, g, b].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  const [x, y] = ledger.pixel;
  const parts: HTMLElement[] = [
    element(
      "div",
      { class: "patch" },
      element("i", { style: `background:rgb(${r} ${g} ${b} / ${a / 255})` }),
      element(
        "div",
        {},
        element("div", { class: "num" }, `#${hex}  ${r} ${g} ${b}, alpha ${a}`),
        element("div", { class: "quiet" }, `pixel ${x}, ${y}${isKept ? ", kept" : ""}`),
      ),
    ),
  ];
  const { samples } = ledger;
  for (const sample of samples) {
    if (samples.length > 1) {
      parts.push(element("h3", {}, `${Number((sample.weight * 100).toFixed(2))} % of the pixel`));
    }
    for (const layer of sample.layers) {
      if (layer.what === "surface") {
        parts.push(...surfaceOfPage(layer));
      } else {
        const light = columns(layer.color);
        parts.push(element("p", {}, `the ${layer.what}`), element("p", { class: "num quiet" }, `${light}, alpha ${short(layer.alpha)}`));
      }
    }
  }
  parts.push(...ledger.hints.map((hint) => element("p", { class: "quiet" }, hint)));
  panel.replaceChildren(...parts);
}
