/** The table of shininess: a ball for each k_s and n, all under one light. */

import { demo, type View } from "luxel";
import { byId, element } from "./dom.ts";
import type { TABLE } from "./figures/reflection.ts";
import { draggable } from "./number.ts";

export class LiveTable {
  readonly #table: typeof TABLE;
  readonly #cells: { canvas: HTMLCanvasElement; ks: number; n: number; pixels?: Uint8ClampedArray }[] = [];
  #about: number;
  #view: Promise<View> | undefined;
  #isStale = true;
  #busy: Promise<void> | undefined;

  constructor(id: string, table: typeof TABLE) {
    this.#table = table;
    this.#about = table.about.value;
    const place = byId(id);
    const images = [...place.querySelectorAll("img")];
    for (const ks of table.ks) {
      for (const n of table.n) {
        const canvas = element("canvas", { role: "img", "aria-label": `A ball with k_s = ${ks} and n = ${n}` });
        [canvas.width, canvas.height] = table.size;
        images[this.#cells.length]!.replaceWith(canvas);
        this.#cells.push({ canvas, ks, n });
      }
    }
    const slider = draggable(table.about, (value) => {
      this.#about = value;
      this.#isStale = true;
      void this.draw();
    });
    const line = element("p", { class: "line" }, "the light stands ", slider.element, " degrees to the right of the eye");
    place.querySelector("table")!.after(line);
  }

  draw(): Promise<void> {
    this.#busy ??= this.#draw().finally(() => (this.#busy = undefined));
    return this.#busy;
  }

  async #draw(): Promise<void> {
    const { size, settings } = this.#table;
    this.#view ??= demo(this.#table.demo).then((scene) => scene.view({ size }));
    const view = await this.#view;
    while (this.#isStale) {
      this.#isStale = false;
      for (const cell of this.#cells) {
        await view.set({ size, ...settings(cell.ks, cell.n, this.#about) });
        const image = await view.render({ workers: 1 });
        cell.canvas.getContext("2d")!.putImageData(image, 0, 0);
        cell.pixels = image.data;
      }
    }
  }

  pixels(canvas: HTMLCanvasElement | undefined): Uint8ClampedArray | undefined {
    return this.#cells.find((cell) => cell.canvas === canvas)?.pixels;
  }
}
