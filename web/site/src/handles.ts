/** Handles of lights over the picture: positions, targets of spot lights, and directions on a sphere. */

import type { LightHandle, View } from "luxel";
import { drawn } from "./dom.ts";
import { hexOf } from "./fields.ts";
import { colorOf, lightText, nameOf, type Light } from "./lights.ts";

/** The step of an arrow key, in pixels of the page. */
const STEP = 8;

const ARROWS: Record<string, [right: number, down: number]> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, -STEP],
  ArrowDown: [0, STEP],
};

/** What handles need of the page. */
export interface HandlePage {
  view(): View | undefined;
  lights(): readonly Light[];
  /** The middle of the picture, in its pixels. */
  middle(): [x: number, y: number];
  /** A place of the picture as one over it, in pixels of the page, and back as a way. */
  toPage(place: readonly [number, number]): [x: number, y: number];
  wayToPicture(way: readonly [number, number]): [x: number, y: number];
  /** A light is another one now. */
  changed(): void;
}

interface Shown {
  light: Light;
  handle: LightHandle;
  drawing: SVGElement;
}

/** A place that a light is moved to, from where its handle was grabbed. */
interface Move {
  light: Light;
  handle: LightHandle;
  to: [number, number];
}

/** The handles of all lights that are on. */
export class Handles {
  readonly #layer: SVGElement;
  readonly #page: HandlePage;
  readonly #shown = new Map<string, Shown>();
  #isOn = false;
  #next: Move | undefined;
  #moving: Promise<void> | undefined;

  constructor(layer: SVGElement, page: HandlePage) {
    this.#layer = layer;
    this.#page = page;
  }

  /** Shows or hides them. */
  async show(isOn: boolean): Promise<void> {
    this.#isOn = isOn;
    await this.update();
  }

  /** Puts them where they are in the present picture. */
  async update(): Promise<void> {
    const view = this.#page.view();
    const lights = this.#isOn ? this.#page.lights().filter((light) => light.isOn) : [];
    const of = view === undefined || lights.length === 0 ? [] : await view.lightHandles(lights.map(lightText));
    const left = new Set(this.#shown.keys());
    of.forEach((handles, at) => {
      const light = lights[at]!;
      const name = nameOf(light, this.#page.lights().indexOf(light));
      for (const handle of handles) {
        const key = `${this.#page.lights().indexOf(light)} ${handle.kind}`;
        left.delete(key);
        const shown = this.#shown.get(key) ?? this.#add(key, light, handle);
        Object.assign(shown, { light, handle });
        const [x, y] = this.#page.toPage(handle.place);
        shown.drawing.setAttribute("transform", `translate(${x} ${y})`);
        this.#aim(shown, handles, [x, y]);
        shown.drawing.setAttribute("aria-label", `${name}, ${handle.kind}: the arrow keys move it`);
        shown.drawing.style.setProperty("--of", hexOf(colorOf(light)));
        shown.drawing.classList.toggle("far", !handle.isNear);
        shown.drawing.querySelector("text")!.textContent = name;
      }
    });
    for (const key of left) {
      this.#shown.get(key)?.drawing.remove();
      this.#shown.delete(key);
    }
  }

  /** Draws the way of the light: from a position to its target, from a direction towards the middle. */
  #aim({ handle, drawing }: Shown, all: readonly LightHandle[], [x, y]: [number, number]): void {
    const position = all.find(({ kind }) => kind === "position");
    const ends = { position: undefined, target: position?.place, direction: this.#page.middle() }[handle.kind];
    const [otherX, otherY] = ends === undefined ? [x, y] : this.#page.toPage(ends);
    const part = handle.kind === "direction" ? 0.6 : 1;
    for (const line of drawing.querySelectorAll("line")) {
      line.setAttribute("x2", String((otherX - x) * part));
      line.setAttribute("y2", String((otherY - y) * part));
    }
  }

  #add(key: string, light: Light, handle: LightHandle): Shown {
    const knob = drawn("circle", { r: handle.kind === "target" ? 5 : 8, class: "knob" });
    const drawing = drawn("g", { class: `handle ${handle.kind}`, tabindex: 0, role: "button" });
    const line = (name: string): SVGElement => drawn("line", { x1: 0, y1: 0, x2: 0, y2: 0, class: name });
    const reach = drawn("circle", { r: 14, class: "reach" });
    drawing.append(line("halo"), line("way"), reach, knob, drawn("text", { x: 16, y: 4 }));
    const shown = { light, handle, drawing };
    this.#shown.set(key, shown);
    this.#layer.append(drawing);
    this.#listen(shown);
    return shown;
  }

  #listen(shown: Shown): void {
    const { drawing } = shown;
    let grabbed: { from: [number, number]; handle: LightHandle } | undefined;
    drawing.addEventListener("pointerdown", (event) => {
      drawing.setPointerCapture(event.pointerId);
      drawing.focus({ preventScroll: true });
      grabbed = { from: [event.clientX, event.clientY], handle: shown.handle };
      event.preventDefault();
    });
    drawing.addEventListener("pointermove", (event) => {
      if (grabbed === undefined) return;
      const { from, handle } = grabbed;
      this.#moveBy(shown.light, handle, [event.clientX - from[0], event.clientY - from[1]]);
    });
    const release = (): void => {
      grabbed = undefined;
    };
    drawing.addEventListener("pointerup", release);
    drawing.addEventListener("pointercancel", release);
    drawing.addEventListener("keydown", (event) => {
      const way = ARROWS[event.key];
      if (way === undefined) return;
      this.#moveBy(shown.light, shown.handle, way);
      event.preventDefault();
    });
  }

  /** Moves a light by a way in pixels of the page. Of moves that wait, the last one counts. */
  #moveBy(light: Light, handle: LightHandle, way: readonly [number, number]): void {
    const [right, down] = this.#page.wayToPicture(way);
    this.#next = { light, handle, to: [handle.place[0] + right, handle.place[1] + down] };
    this.#moving ??= this.#move();
  }

  /** Resolves when no light is about to move. */
  async settled(): Promise<void> {
    await this.#moving;
  }

  async #move(): Promise<void> {
    try {
      for (let next = this.#next; next !== undefined; next = this.#next) {
        this.#next = undefined;
        const { light, handle, to } = next;
        const pose = await this.#page.view()?.moveLight(lightText(light), handle, ...to);
        if (!pose) continue;
        const text = (vector: readonly number[]): string => vector.map((part) => Number(part.toPrecision(5))).join(",");
        if (handle.kind === "position") light.fields.set("pos", text(pose.position));
        else light.fields.set("dir", text(pose.direction));
        this.#page.changed();
      }
    } finally {
      this.#moving = undefined;
    }
  }
}
