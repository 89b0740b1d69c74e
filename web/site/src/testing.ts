/** What a page offers to tests, also those of others, as `window.luxel`. */

import type { Explanation } from "luxel";

export interface Page {
  /** Resolves when the first picture is there. */
  ready: Promise<void>;
  /** The bytes of a canvas's picture as they were drawn, red, green, blue and alpha. */
  pixels(canvas?: HTMLCanvasElement): Uint8ClampedArray | undefined;
  /** Why a pixel of the page's first picture has its colour: the JSON of the program. */
  explain(x: number, y: number): Promise<Explanation>;
  /** Resolves when nothing is left to draw. */
  settled(): Promise<void>;
}

declare global {
  interface Window {
    luxel: Page;
  }
}

/** Offers a page to tests. */
export function offer(ready: Promise<void>, page: Omit<Page, "ready">): void {
  window.luxel = { ready, ...page };
}
