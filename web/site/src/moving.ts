/** Figures that a hand moves: the six modes with their matrices, and the rolling ball's theorem. */

import { demo, LuxelError, type CameraState, type NavigationEvent, type View } from "luxel";
import { byId, element } from "./dom.ts";
import { matrix } from "./matrix.ts";
import { draggable } from "./number.ts";
import { listen, MODES } from "./pointing.ts";

const SIZE: [number, number] = [640, 400];

/** A picture with a camera that moves. */
class Moved {
  readonly canvas = element("canvas", { role: "img", tabindex: "0" });
  pixels: Uint8ClampedArray | undefined;
  readonly #demo: string;
  readonly #shown: (camera: CameraState, log: string) => void;
  #view: Promise<View> | undefined;
  #pending: NavigationEvent[] = [];
  #isStale = true;
  #busy: Promise<void> | undefined;
  mode = "turntable";

  constructor(name: string, alt: string, shown: (camera: CameraState, log: string) => void) {
    this.#demo = name;
    this.#shown = shown;
    [this.canvas.width, this.canvas.height] = SIZE;
    this.canvas.setAttribute("aria-label", alt);
  }

  move(...events: NavigationEvent[]): void {
    this.#pending.push(...events);
    this.#isStale = true;
    void this.draw();
  }

  draw(): Promise<void> {
    this.#busy ??= this.#draw().finally(() => (this.#busy = undefined));
    return this.#busy;
  }

  async #draw(): Promise<void> {
    this.#view ??= demo(this.#demo).then((scene) => scene.view({ size: SIZE }));
    const view = await this.#view;
    while (this.#isStale) {
      this.#isStale = false;
      const camera = await view.navigate(...this.#pending.splice(0));
      this.mode = camera.mode;
      const image = await view.render({ workers: 1 });
      this.canvas.getContext("2d")!.putImageData(image, 0, 0);
      this.pixels = image.data;
      this.#shown(camera, await view.log());
    }
  }

  async explain(x: number, y: number): ReturnType<View["explain"]> {
    if (this.#view === undefined) throw new LuxelError("there is no picture yet");
    return (await this.#view).explain(x, y);
  }
}

/** The six modes: drag the picture, and watch the matrix and the log. */
export function modes(id: string): Moved {
  const place = byId(id);
  const still = place.querySelector("img")!;
  const values = element("div", { class: "matrix" });
  const log = element("pre", { class: "log", tabindex: "0", "aria-label": "The last events of the log" });
  const choice = element("select", { "aria-label": "Mode" }, ...MODES.map((mode) => element("option", {}, mode)));
  const moved = new Moved("welcome", still.alt, (camera, text) => {
    values.replaceChildren(matrix("V", camera.viewFromWorld));
    // The settings at the beginning are the same each time.
    log.textContent = text.trim().split("\n").filter((line) => !line.startsWith("set ")).slice(-6).join("\n");
    choice.value = camera.mode;
    still.remove();
    moved.canvas.hidden = false;
  });
  moved.canvas.hidden = true;
  choice.addEventListener("change", () => moved.move(["set_mode", choice.value]));
  const taps: [string, string][] = [
    ["orbit-left", "yaw-left"],
    ["orbit-right", "yaw-right"],
    ["orbit-up", "pitch-up"],
    ["orbit-down", "pitch-down"],
    ["forward", "forward"],
    ["back", "back"],
    ["roll-left", "roll-left"],
    ["roll-right", "roll-right"],
    ["x+", "x+"],
    ["turn-y+", "turn-y+"],
    ["target-x+", "target-x+"],
  ];
  const buttons = taps.map(([orbit, look]) => {
    const button = element("button", { type: "button" }, orbit);
    button.addEventListener("click", () => {
      const looks = moved.mode === "flying" || moved.mode === "mouselook";
      moved.move(["tap", looks ? look : orbit, 1]);
    });
    return button;
  });
  const home = element("button", { type: "button" }, "Start again");
  home.addEventListener("click", () => moved.move(["home"]));
  const picture = element("div", { class: "live-picture" }, still, moved.canvas);
  place.prepend(picture);
  picture.after(element("p", { class: "buttons" }, choice, ...buttons, home), values, log);
  const hand = {
    place: ({ clientX, clientY }: { clientX: number; clientY: number }): [number, number] => {
      const box = moved.canvas.getBoundingClientRect();
      return [((clientX - box.left) / box.width) * SIZE[0], ((clientY - box.top) / box.height) * SIZE[1]];
    },
    move: (...events: NavigationEvent[]) => moved.move(...events),
    hover: () => {},
    click: () => {},
    key: () => false,
  };
  listen(moved.canvas, hand, () => moved.mode);
  return moved;
}

/** The theorem: a closed loop of the hand rolls the ball about the view axis, by its area over r². */
export function rollingBall(id: string): Moved {
  const place = byId(id);
  const still = place.querySelector("img")!;
  const values = element("div", { class: "matrix" });
  const said = element("p", { class: "said", "aria-live": "polite" });
  /** The ball's radius: 0.4 of the window's shorter side. */
  const radius = 0.4 * Math.min(...SIZE);
  let side = 60;
  let first: readonly number[] | undefined;
  const moved = new Moved("teapot", still.alt, (camera) => {
    still.remove();
    moved.canvas.hidden = false;
    const now = camera.viewFromWorld;
    first ??= now;
    // The rotation from the first camera to this one, in camera space: R = V V0^T; its part about z.
    const at = (row: number, column: number): number =>
      [0, 1, 2].reduce((sum, k) => sum + now[k * 4 + row]! * first![k * 4 + column]!, 0);
    const twist = Math.atan2(at(1, 0) - at(0, 1), at(0, 0) + at(1, 1));
    const area = (side / radius) ** 2;
    const degrees = (radians: number): string => `${((radians * 180) / Math.PI).toFixed(2)}°`;
    said.textContent = `The loop's area is ${area.toFixed(4)} r², which is ${degrees(area)}; the teapot has turned by ${degrees(Math.abs(twist))} about the view axis.`;
    values.replaceChildren(matrix("V", now));
  });
  moved.canvas.hidden = true;
  const loop = (): void => {
    const [x, y] = [SIZE[0] / 2, SIZE[1] / 2];
    const corners: [number, number][] = [[x + side, y], [x + side, y - side], [x, y - side], [x, y]];
    const drags = corners.flatMap(([toX, toY], at): NavigationEvent[] => {
      const [fromX, fromY] = at === 0 ? [x, y] : corners[at - 1]!;
      const steps = 16;
      return Array.from({ length: steps }, (_, step): NavigationEvent => {
        const part = (step + 1) / steps;
        return ["drag", fromX + (toX - fromX) * part, fromY + (toY - fromY) * part];
      });
    });
    moved.move(["home"], ["set_mode", "rolling-ball"], ["grab", "turn", x, y], ...drags, ["release"]);
  };
  const slider = draggable(
    { name: "side", symbol: "", meaning: "the loop's side in pixels", value: side, min: 0, max: 200, step: 1 },
    (value) => {
      side = value;
      loop();
    },
  );
  const picture = element("div", { class: "live-picture" }, still, moved.canvas);
  place.prepend(picture);
  picture.after(element("p", { class: "line" }, "the hand goes round a square of ", slider.element, " pixels"), said, values);
  const begin = moved.draw.bind(moved);
  let isFirst = true;
  moved.draw = () => {
    if (isFirst) {
      isFirst = false;
      // The first camera is known before the loop begins.
      return begin().then(() => {
        loop();
        return begin();
      });
    }
    return begin();
  };
  return moved;
}
