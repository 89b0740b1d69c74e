/** The table of shininess: a ball for each k_s and n, all under one light. */

import type { Explanation } from "luxel";
import { byId, element } from "./dom.ts";
import type { TABLE } from "./figures/reflection.ts";
import { DemoView, Live } from "./live.ts";
import { draggable } from "./number.ts";

interface Cell {
  canvas: HTMLCanvasElement;
  still: HTMLImageElement;
  ks: number;
  n: number;
  pixels?: Uint8ClampedArray;
}

export class LiveTable extends Live {
  readonly #table: typeof TABLE;
  readonly #cells: Cell[] = [];
  readonly #view: DemoView;
  #about: number;

  constructor(id: string, table: typeof TABLE) {
    super(id);
    this.#table = table;
    this.#view = new DemoView(table.demo);
    this.#about = table.about.value;
    const place = byId(id);
    const images = [...place.querySelectorAll("img")];
    for (const ks of table.ks) {
      for (const n of table.n) {
        const canvas = element("canvas", { role: "img", "aria-label": `A ball with k_s = ${ks} and n = ${n}` });
        [canvas.width, canvas.height] = table.size;
        // In its place until the ball is drawn.
        const still = images[this.#cells.length]!;
        canvas.hidden = true;
        still.after(canvas);
        this.#cells.push({ canvas, still, ks, n });
      }
    }
    const slider = draggable(table.about, (value) => {
      this.#about = value;
      this.changed();
    });
    const line = element("p", { class: "line" }, "the light stands ", slider.element, " degrees to the right of the eye");
    place.querySelector("table")!.after(line);
  }

  protected override async drawOnce(): Promise<void> {
    const { size, settings } = this.#table;
    for (const cell of this.#cells) {
      const view = await this.#view.with({ size, ...settings(cell.ks, cell.n, this.#about) });
      const image = await view.render({ workers: 1 });
      cell.canvas.getContext("2d")!.putImageData(image, 0, 0);
      cell.canvas.hidden = false;
      cell.still.remove();
      cell.pixels = image.data;
    }
  }

  protected override fail(message: string): void {
    byId(this.id).querySelector("figcaption")!.textContent = message;
  }

  override pixels(canvas: HTMLCanvasElement | undefined): Uint8ClampedArray | undefined {
    return (this.#cells.find((cell) => cell.canvas === canvas) ?? this.#cells[0]!).pixels;
  }

  override explain(x: number, y: number): Promise<Explanation> {
    return this.#view.explain(x, y);
  }
}
