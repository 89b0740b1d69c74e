/** Comparisons of an article: two pictures under a divider, and what they differ by. */

import type { Explanation, Settings } from "luxel";
import { byId, drawn, element } from "./dom.ts";
import { choiceRow } from "./fields.ts";
import type { Comparison, ComparedValues, Side } from "./figures/comparison.ts";
import { DemoView, Live } from "./live.ts";
import { draggable } from "./number.ts";

/** How two pictures differ, in steps of 255. */
interface Difference {
  largest: number;
  mean: number;
  /** The share of pixels that differ by more than a step, of those that either shows. */
  share: number;
}

/** The difference over all pixels that either picture covers. */
function difference(one: Uint8ClampedArray, other: Uint8ClampedArray): Difference {
  let [largest, sum, more, count] = [0, 0, 0, 0];
  for (let at = 0; at < one.length; at += 4) {
    if (one[at + 3] === 0 && other[at + 3] === 0) continue;
    count += 1;
    let most = 0;
    for (let channel = 0; channel < 3; channel++) {
      const steps = Math.abs(one[at + channel]! - other[at + channel]!);
      most = Math.max(most, steps);
      sum += steps / 3;
    }
    largest = Math.max(largest, most);
    if (most > 1) more += 1;
  }
  return { largest, mean: count > 0 ? sum / count : 0, share: count > 0 ? more / count : 0 };
}

/** The green channel along the middle row, as points of a line over 0 to 255. */
function row(pixels: Uint8ClampedArray, width: number, height: number): string {
  const start = Math.floor(height / 2) * width * 4;
  const points: string[] = [];
  for (let x = 0; x < width; x++) {
    if (pixels[start + x * 4 + 3] === 255) points.push(`${x},${(100 * (1 - pixels[start + x * 4 + 1]! / 255)).toFixed(1)}`);
  }
  return points.join(" ");
}

/** One of the two pictures. */
class LiveSide {
  readonly canvas: HTMLCanvasElement;
  readonly view: DemoView;
  pixels: Uint8ClampedArray | undefined;

  constructor({ alt, demo }: Side, [width, height]: [number, number]) {
    this.canvas = element("canvas", { role: "img", "aria-label": alt });
    [this.canvas.width, this.canvas.height] = [width, height];
    this.view = new DemoView(demo);
  }

  async draw(settings: Settings): Promise<void> {
    const image = await (await this.view.with(settings)).render({ workers: 1 });
    this.canvas.getContext("2d")!.putImageData(image, 0, 0);
    this.pixels = image.data;
  }
}

/** A problem and its cure. */
export class LiveComparison extends Live {
  readonly #comparison: Comparison;
  readonly #sides: [problem: LiveSide, cure: LiveSide];
  readonly #said = element("p", { class: "said", "aria-live": "polite" });
  readonly #plot = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  readonly #values: ComparedValues;
  readonly #shown = new Map<string, (value: number) => void>();

  constructor(comparison: Comparison) {
    const { problem, cure, numbers, choices = [], size } = comparison;
    super(comparison.id);
    this.#comparison = comparison;
    this.#sides = [new LiveSide(problem, size), new LiveSide(cure, size)];
    this.#values = {
      numbers: Object.fromEntries(numbers.map(({ name, value }) => [name, value])),
      choices: Object.fromEntries(choices.map(({ name, value }) => [name, value])),
    };
    this.#place();
  }

  /** Puts the comparison into its place in the page. */
  #place(): void {
    const { id, lines, numbers, choices = [], problem, cure, plot, size } = this.#comparison;
    const place = byId(id);
    const picture = element("div", { class: "live-picture compared" }, this.#sides[0].canvas, this.#sides[1].canvas);
    picture.style.setProperty("--cut", "50%");
    picture.style.aspectRatio = `${size[0]} / ${size[1]}`;
    const divider = element("input", { type: "range", min: "0", max: "100", value: "50", "aria-label": `Divider between ${problem.title} and ${cure.title}` });
    divider.addEventListener("input", () => picture.style.setProperty("--cut", `${divider.value}%`));
    const titles = element("p", { class: "titles" }, element("span", {}, problem.title), divider, element("span", {}, cure.title));
    const controls = element("div", { class: "numbers" });
    const fields = choices.flatMap(({ name, label, options }) =>
      choiceRow(label, options, this.#values.choices[name]!, (value) => {
        this.#values.choices[name] = value;
        this.changed();
      }),
    );
    if (fields.length > 0) controls.append(element("div", { class: "fields" }, ...fields));
    for (const line of lines) {
      const parts = line.split(/(\{\w+\})/).map((part) => {
        const name = /^\{(\w+)\}$/.exec(part)?.[1];
        if (name === undefined) return part;
        const slider = draggable(numbers.find((one) => one.name === name)!, (value) => {
          this.#values.numbers[name] = value;
          this.changed();
        });
        this.#shown.set(name, slider.set);
        return slider.element;
      });
      controls.append(element("p", { class: "line" }, ...parts));
    }
    const reset = element("button", { type: "button" }, "Start again");
    reset.addEventListener("click", () => {
      for (const { name, value } of numbers) {
        this.#values.numbers[name] = value;
        this.#shown.get(name)?.(value);
      }
      for (const { name, value } of choices) this.#values.choices[name] = value;
      controls.querySelectorAll("select").forEach((select, at) => (select.value = choices[at]!.value));
      this.changed();
    });
    const stills = place.querySelector(".stills")!;
    stills.after(picture, titles, ...(plot ? [this.#plot] : []), this.#said, controls, element("p", {}, reset));
    picture.hidden = titles.hidden = true;
    this.#plot.setAttribute("viewBox", `0 0 ${size[0]} 100`);
    this.#plot.setAttribute("class", "plot");
    this.#plot.setAttribute("role", "img");
    this.#plot.setAttribute("aria-label", "Intensity along the middle row: of the left picture in steps or with kinks, of the right one smooth");
  }

  protected override async drawOnce(): Promise<void> {
    const { problem, cure, size, plot } = this.#comparison;
    const [left, right] = this.#sides;
    await left.draw({ size, ...problem.settings(this.#values) });
    await right.draw({ size, ...cure.settings(this.#values) });
    const { largest, mean, share } = difference(left.pixels!, right.pixels!);
    this.#said.textContent = `They differ by up to ${largest} of 255 steps, by ${mean.toFixed(2)} on average, at ${(share * 100).toFixed(1)} % of the pixels by more than one.`;
    if (plot) this.#drawPlot();
    const place = byId(this.id);
    place.querySelectorAll<HTMLElement>(".live-picture, .titles").forEach((one) => (one.hidden = false));
    place.querySelector(".stills")?.remove();
  }

  protected override fail(message: string): void {
    this.#said.textContent = message;
  }

  override pixels(canvas: HTMLCanvasElement | undefined): Uint8ClampedArray | undefined {
    return (this.#sides.find((side) => side.canvas === canvas) ?? this.#sides[0]).pixels;
  }

  override explain(x: number, y: number): Promise<Explanation> {
    return this.#sides[0].view.explain(x, y);
  }

  #drawPlot(): void {
    const [width, height] = this.#comparison.size;
    const line = (side: LiveSide, color: string): SVGElement =>
      drawn("polyline", { points: row(side.pixels!, width, height), fill: "none", "stroke-width": 1.5, style: `stroke:${color}` });
    this.#plot.replaceChildren(line(this.#sides[1], "var(--normal)"), line(this.#sides[0], "var(--accent)"));
  }
}
