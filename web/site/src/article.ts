/** Figures of an article: a picture, a formula whose numbers can be dragged, and the ledger of a pixel. */

import type { Explanation } from "luxel";
import { byId, element } from "./dom.ts";
import type { Figure, Values } from "./figures/figure.ts";
import { formula } from "./formula.ts";
import { matrix } from "./matrix.ts";
import { sentence, showLedger } from "./ledger.ts";
import { DemoView, Live } from "./live.ts";
import { draggable } from "./number.ts";
import { showVectors } from "./overlay.ts";

/** A figure in the page. */
export class LiveFigure extends Live {
  readonly #figure: Figure;
  readonly #canvas = element("canvas", { role: "img", tabindex: "0" });
  readonly #overlay = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  readonly #ledger = element("div");
  readonly #matrices = element("div", { class: "matrix" });
  readonly #said = element("p", { class: "said", "aria-live": "polite" });
  readonly #values: Values;
  readonly #shown = new Map<string, ((value: number) => void)[]>();
  #pixel: [number, number];
  readonly #view: DemoView;
  #pixels: Uint8ClampedArray | undefined;

  constructor(figure: Figure) {
    super(figure.id);
    this.#figure = figure;
    this.#view = new DemoView(figure.demo);
    this.#pixel = figure.pixel;
    this.#values = Object.fromEntries(figure.numbers.map(({ name, value }) => [name, value]));
    this.#place();
  }

  /** Puts the figure into its place in the page. */
  #place(): void {
    const { id, size, formula: lines, tutors } = this.#figure;
    const place = byId(id);
    const still = place.querySelector("img")!;
    [this.#canvas.width, this.#canvas.height] = size;
    this.#canvas.setAttribute("aria-label", still.alt);
    this.#overlay.setAttribute("viewBox", `0 0 ${size[0]} ${size[1]}`);
    this.#overlay.setAttribute("aria-hidden", "true");
    const picture = element("div", { class: "live-picture" }, this.#canvas, this.#overlay);
    still.replaceWith(picture);
    this.#canvas.hidden = true;
    picture.prepend(still);
    const numbers = element("div", { class: "numbers" });
    for (const line of lines) numbers.append(element("p", { class: "line" }, ...this.#line(line, true)));
    for (const tutor of tutors ?? []) numbers.append(this.#tutor(tutor));
    const reset = element("button", { type: "button" }, "Start again");
    reset.addEventListener("click", () => {
      for (const { name, value } of this.#figure.numbers) this.#set(name, value);
      this.changed();
    });
    const why = element("details", {}, element("summary", {}, "Why this pixel has its colour"), this.#ledger);
    if (this.#figure.showsMatrices) numbers.append(this.#matrices);
    picture.after(numbers, this.#said, why, element("p", {}, reset));
    this.#canvas.addEventListener("click", (event) => this.#point(event));
    this.#canvas.addEventListener("keydown", (event) => this.#key(event));
  }

  /** The elements of a line: symbols as formulas if it is one, numbers as sliders. */
  #line(text: string, isFormula: boolean): (Node | string)[] {
    return text.split(/(\{\w+\})/).flatMap((part): (Node | string)[] => {
      const name = /^\{(\w+)\}$/.exec(part)?.[1];
      if (name === undefined) {
        if (!isFormula) return [part];
        return part.split(/([A-Za-z]+_[A-Za-z0-9]+|max\([^()]*\)(?:\^\w+)?|N\.L)/).map((word) =>
          /_|max|N\.L/.test(word) ? formula(word) : word,
        );
      }
      const number = this.#figure.numbers.find((one) => one.name === name)!;
      const slider = draggable({ ...number, value: this.#values[name]! }, (value) => {
        this.#set(name, value);
        this.changed();
      });
      this.#shown.set(name, [...(this.#shown.get(name) ?? []), slider.set]);
      return [slider.element];
    });
  }

  #tutor({ title, lines }: { title: string; lines: string[] }): HTMLElement {
    const code = element("pre", { class: "tutor" });
    for (const line of lines) code.append(...this.#line(line, false), "\n");
    const copy = element("button", { type: "button" }, "Copy");
    copy.addEventListener("click", () => {
      void navigator.clipboard.writeText((code.textContent ?? "").replace(/−/g, "-")).then(() => {
        copy.textContent = "Copied";
        setTimeout(() => (copy.textContent = "Copy"), 1500);
      });
    });
    return element("section", {}, element("h3", {}, title, " ", copy), code);
  }

  #set(name: string, value: number): void {
    this.#values[name] = value;
    for (const show of this.#shown.get(name) ?? []) show(value);
  }

  #point(event: MouseEvent): void {
    const box = this.#canvas.getBoundingClientRect();
    const part = (at: number, start: number, length: number, side: number): number =>
      Math.min(Math.max(Math.floor(((at - start) / length) * side), 0), side - 1);
    const { width, height } = this.#canvas;
    this.#pixel = [part(event.clientX, box.left, box.width, width), part(event.clientY, box.top, box.height, height)];
    this.changed();
  }

  #key(event: KeyboardEvent): void {
    const steps: Record<string, [number, number]> = {
      ArrowLeft: [-4, 0],
      ArrowRight: [4, 0],
      ArrowUp: [0, -4],
      ArrowDown: [0, 4],
    };
    const step = steps[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const { width, height } = this.#canvas;
    const [x, y] = this.#pixel;
    this.#pixel = [Math.min(Math.max(x + step[0], 0), width - 1), Math.min(Math.max(y + step[1], 0), height - 1)];
    this.changed();
  }

  protected override async drawOnce(): Promise<void> {
    const { size, settings, showsMatrices } = this.#figure;
    const view = await this.#view.with({ size, ...settings(this.#values) });
    const image = await view.render({ workers: 1 });
    this.#canvas.getContext("2d")!.putImageData(image, 0, 0);
    this.#pixels = image.data;
    this.#canvas.hidden = false;
    this.#canvas.parentElement?.querySelector("img")?.remove();
    if (showsMatrices) {
      const { viewFromWorld, clipFromView } = await view.navigate();
      this.#matrices.replaceChildren(matrix("V", viewFromWorld), matrix("P", clipFromView));
    }
    const ledger = await view.ledger(...this.#pixel);
    showLedger(this.#ledger, ledger, false);
    const unit = size[0] / (this.#overlay.clientWidth || size[0]);
    showVectors(this.#overlay, ledger, [this.#pixel[0] + 0.5, this.#pixel[1] + 0.5], unit);
    this.#said.textContent = sentence(ledger);
  }

  protected override fail(message: string): void {
    this.#said.textContent = message;
  }

  override pixels(): Uint8ClampedArray | undefined {
    return this.#pixels;
  }

  override explain(x: number, y: number): Promise<Explanation> {
    return this.#view.explain(x, y);
  }
}
