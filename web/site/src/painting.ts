/** Draws what the page shows: drafts while a hand moves the camera, and the complete picture once it rests. */

import type { CameraState, LayerName, NavigationEvent, View } from "luxel";

/** A hand that rests as long gets the complete picture, in milliseconds. */
const REST = 140;

/** What drawing needs of the page. */
export interface PaintingPage {
  view(): View | undefined;
  layer(): "picture" | LayerName;
  /** Whether marks are shown instead of a picture. */
  isMarked(): boolean;
  /** Does something with a view, and shows why it failed if the view is still the page's. */
  attempt(view: View | undefined, work: () => Promise<void>): Promise<void>;
  /** Events have moved the camera. */
  moved(camera: CameraState): void;
  /** There is another picture. */
  shown(): void;
  /** Nothing is left to draw. */
  rested(): Promise<void>;
}

export class Painting {
  readonly #canvas: HTMLCanvasElement;
  readonly #page: PaintingPage;
  #wanted: "nothing" | "draft" | "full" = "nothing";
  #isDrawing = false;
  #restTimer = 0;
  #pending: NavigationEvent[] = [];
  #pixels: Uint8ClampedArray | undefined;
  /** The picture that is shown, and the one before it, whose memory the next one takes. */
  #last: ImageData | undefined;
  #before: ImageData | undefined;
  #idle: (() => void)[] = [];

  constructor(canvas: HTMLCanvasElement, page: PaintingPage) {
    this.#canvas = canvas;
    this.#page = page;
  }

  get isDrawing(): boolean {
    return this.#isDrawing;
  }

  /** The bytes of the picture, as they were drawn. */
  get pixels(): Uint8ClampedArray | undefined {
    return this.#pixels;
  }

  /** Draws the complete picture. */
  redraw(): Promise<void> {
    this.#wanted = "full";
    return this.#loop();
  }

  /** Moves the camera; the complete picture follows when the hand rests. */
  move(...events: NavigationEvent[]): void {
    // Of drags that wait, the last one counts.
    for (const event of events) {
      if (event[0] === "drag" && this.#pending.at(-1)?.[0] === "drag") this.#pending.pop();
      this.#pending.push(event);
    }
    if (this.#wanted === "nothing") this.#wanted = "draft";
    clearTimeout(this.#restTimer);
    this.#restTimer = setTimeout(() => void this.redraw(), REST);
    void this.#loop();
  }

  /** Waits until nothing is left to draw. */
  settled(): Promise<void> {
    if (!this.#isDrawing && this.#wanted === "nothing") return Promise.resolve();
    return new Promise((resolve) => this.#idle.push(resolve));
  }

  async #loop(): Promise<void> {
    if (this.#isDrawing) return;
    this.#isDrawing = true;
    let current: View | undefined;
    do {
      current = this.#page.view();
      await this.#page.attempt(current, () => this.#drawAll());
      // Another scene may have come meanwhile.
    } while (current !== this.#page.view());
    this.#isDrawing = false;
    await this.#page.rested();
    const waiting = this.#idle;
    this.#idle = [];
    waiting.forEach((done) => done());
  }

  /** Draws until nothing is wanted any more. */
  async #drawAll(): Promise<void> {
    for (let view = this.#page.view(); view !== undefined && this.#isWanted; view = this.#page.view()) {
      const isFull = this.#wanted === "full" && this.#pending.length === 0;
      if (this.#wanted !== "full" || isFull) this.#wanted = "nothing";
      if (this.#pending.length > 0) {
        const events = this.#pending;
        this.#pending = [];
        this.#page.moved(await view.navigate(...events));
      }
      const layer = this.#page.layer();
      if (layer !== "picture") {
        const pixels = await view.layerPicture(layer);
        if (view === this.#page.view()) this.#put(new ImageData(pixels, this.#canvas.width, this.#canvas.height));
        continue;
      }
      if (this.#page.isMarked()) continue;
      const image = await view.render({ draft: !isFull }, this.#before);
      this.#before = undefined;
      if (view !== this.#page.view()) continue;
      this.#put(image);
      this.#before = this.#last;
      this.#last = image;
    }
  }

  get #isWanted(): boolean {
    return this.#wanted !== "nothing" || this.#pending.length > 0;
  }

  #put(image: ImageData): void {
    // Setting a size clears the canvas.
    if (this.#canvas.width !== image.width) this.#canvas.width = image.width;
    if (this.#canvas.height !== image.height) this.#canvas.height = image.height;
    this.#canvas.getContext("2d")!.putImageData(image, 0, 0);
    this.#pixels = image.data;
    this.#page.shown();
  }
}
