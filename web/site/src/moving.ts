/** Figures that a hand moves: the six modes with their matrices, and the rolling ball's theorem. */

import type { CameraState, Explanation, NavigationEvent } from "luxel";
import { byId, element } from "./dom.ts";
import { DemoView, Live } from "./live.ts";
import { matrix } from "./matrix.ts";
import { draggable } from "./number.ts";
import { listen, MODES } from "./pointing.ts";

const SIZE: [number, number] = [640, 400];

/** A picture with a camera that moves. */
class Moved extends Live {
  readonly canvas = element("canvas", { role: "img", tabindex: "0" });
  readonly #view: DemoView;
  readonly #still: HTMLImageElement;
  readonly #shown: (camera: CameraState, log: string) => void;
  #pixels: Uint8ClampedArray | undefined;
  #pending: NavigationEvent[] = [];
  mode = "turntable";

  /** Puts the picture into its place; `shown` is called after each event with the camera and the log. */
  constructor(id: string, demo: string, shown: (camera: CameraState, log: string) => void) {
    super(id);
    this.#view = new DemoView(demo);
    this.#shown = shown;
    this.#still = byId(id).querySelector("img")!;
    [this.canvas.width, this.canvas.height] = SIZE;
    this.canvas.setAttribute("aria-label", this.#still.alt);
    this.canvas.hidden = true;
    byId(id).prepend(element("div", { class: "live-picture" }, this.#still, this.canvas));
  }

  move(...events: NavigationEvent[]): void {
    this.#pending.push(...events);
    this.changed();
  }

  protected override async drawOnce(): Promise<void> {
    const view = await this.#view.opened({ size: SIZE });
    const camera = await view.navigate(...this.#pending.splice(0));
    this.mode = camera.mode;
    const image = await view.render({ workers: 1 });
    this.canvas.getContext("2d")!.putImageData(image, 0, 0);
    this.#pixels = image.data;
    this.#still.remove();
    this.canvas.hidden = false;
    this.#shown(camera, await view.log());
  }

  protected override fail(message: string): void {
    byId(this.id).querySelector("figcaption")!.textContent = message;
  }

  override pixels(): Uint8ClampedArray | undefined {
    return this.#pixels;
  }

  override explain(x: number, y: number): Promise<Explanation> {
    return this.#view.explain(x, y);
  }
}

/** The six modes: drag the picture, and watch the matrix and the log. */
export function modes(id: string): Live {
  const values = element("div", { class: "matrix" });
  const log = element("pre", { class: "log", tabindex: "0", "aria-label": "The last events of the log" });
  const choice = element("select", { "aria-label": "Mode" }, ...MODES.map((mode) => element("option", {}, mode)));
  const moved = new Moved(id, "welcome", (camera, text) => {
    values.replaceChildren(matrix("V", camera.viewFromWorld));
    // The settings at the beginning are the same each time.
    log.textContent = text.trim().split("\n").filter((line) => !line.startsWith("set ")).slice(-6).join("\n");
    choice.value = camera.mode;
  });
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
  moved.canvas.parentElement!.after(element("p", { class: "buttons" }, choice, ...buttons, home), values, log);
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
export function rollingBall(id: string): Live {
  const values = element("div", { class: "matrix" });
  const said = element("p", { class: "said", "aria-live": "polite" });
  /** The ball's radius: 0.4 of the window's shorter side. */
  const radius = 0.4 * Math.min(...SIZE);
  let side = 60;
  let first: readonly number[] | undefined;
  const moved = new Moved(id, "teapot", (camera) => {
    const now = camera.viewFromWorld;
    if (first === undefined) {
      first = now;
      loop();
    }
    // The rotation from the first camera to this one, in camera space: R = V V0^T; its part about z.
    const at = (row: number, column: number): number =>
      [0, 1, 2].reduce((sum, k) => sum + now[k * 4 + row]! * first![k * 4 + column]!, 0);
    const twist = Math.atan2(at(1, 0) - at(0, 1), at(0, 0) + at(1, 1));
    const area = (side / radius) ** 2;
    const degrees = (radians: number): string => `${((radians * 180) / Math.PI).toFixed(2)}°`;
    said.textContent = `The loop's area is ${area.toFixed(4)} r², which is ${degrees(area)}; the teapot has turned by ${degrees(Math.abs(twist))} about the view axis.`;
    values.replaceChildren(matrix("V", now));
  });
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
  moved.canvas.parentElement!.after(
    element("p", { class: "line" }, "the hand goes round a square of ", slider.element, " pixels"),
    said,
    values,
  );
  return moved;
}
