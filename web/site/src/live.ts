/** What live figures have in common: they draw until nothing has changed meanwhile, once they come near the window. */

import { demo, LuxelError, type Explanation, type Settings, type View } from "luxel";
import { byId } from "./dom.ts";
import { offer } from "./testing.ts";

/** A view of a built-in scene, opened by its first settings. */
export class DemoView {
  readonly #demo: string;
  #view: Promise<View> | undefined;

  constructor(name: string) {
    this.#demo = name;
  }

  /** The view with these settings. */
  async with(settings: Settings): Promise<View> {
    if (this.#view === undefined) {
      this.#view = demo(this.#demo).then((scene) => scene.view(settings));
      return this.#view;
    }
    const view = await this.#view;
    await view.set(settings);
    return view;
  }

  /** The view as it is; with these settings if it isn't open. */
  async opened(settings: Settings): Promise<View> {
    return this.#view ?? this.with(settings);
  }

  async explain(x: number, y: number): Promise<Explanation> {
    if (this.#view === undefined) throw new LuxelError("there is no picture yet");
    return (await this.#view).explain(x, y);
  }
}

/** A figure of a page, at the element with its id. */
export abstract class Live {
  readonly id: string;
  #isStale = true;
  #busy: Promise<void> | undefined;

  constructor(id: string) {
    this.id = id;
  }

  /** Draws the figure as it is now. */
  protected abstract drawOnce(): Promise<void>;

  /** Says why it can't be drawn. */
  protected abstract fail(message: string): void;

  /** The bytes of one of its canvases; of the first one if none is named. */
  abstract pixels(canvas: HTMLCanvasElement | undefined): Uint8ClampedArray | undefined;

  abstract explain(x: number, y: number): Promise<Explanation>;

  /** Draws it again. */
  changed(): void {
    this.#isStale = true;
    void this.draw();
  }

  /** Draws until nothing has changed meanwhile. */
  draw(): Promise<void> {
    this.#busy ??= this.#drawAll().finally(() => (this.#busy = undefined));
    return this.#busy;
  }

  async #drawAll(): Promise<void> {
    try {
      while (this.#isStale) {
        this.#isStale = false;
        await this.drawOnce();
      }
    } catch (error) {
      this.fail(error instanceof LuxelError ? error.message : String(error));
    }
  }
}

/** Makes the figures of a page live: the first one at once, the others when they come near the window. */
export function page(figures: readonly [Live, ...Live[]]): void {
  const near = new IntersectionObserver(
    (entries) => {
      for (const { isIntersecting, target } of entries) {
        if (!isIntersecting) continue;
        near.unobserve(target);
        void figures.find((figure) => figure.id === target.id)?.draw();
      }
    },
    { rootMargin: "300px" },
  );
  for (const figure of figures) near.observe(byId(figure.id));
  const [first] = figures;
  offer(first.draw(), {
    pixels: (canvas) => {
      const own = figures.find((figure) => canvas !== undefined && byId(figure.id).contains(canvas));
      return (own ?? first).pixels(canvas);
    },
    explain: async (x, y) => {
      await first.draw();
      return first.explain(x, y);
    },
    settled: async () => {
      await Promise.all(figures.map((figure) => figure.draw()));
    },
  });
}
