/** Pointers, wheel and keys, as events of navigation. */

import type { NavigationEvent } from "luxel";

/** What the hand does. */
export interface Hand {
  /** The place of a pointer in the picture, in its pixels. */
  place(event: { clientX: number; clientY: number }): [x: number, y: number];
  move(...events: NavigationEvent[]): void;
  /** A pointer rests on a place, or left the picture. */
  hover(at: [x: number, y: number] | undefined): void;
  /** A press without a drag. */
  click(at: [x: number, y: number]): void;
  /** A key that doesn't move the camera; true if it did something. */
  key(event: KeyboardEvent): boolean;
}

/** A press that moves less is a click, in pixels of the page. */
const CLICK = 4;

const TAPS: Record<string, string> = {
  ArrowLeft: "orbit-left",
  ArrowRight: "orbit-right",
  ArrowUp: "orbit-up",
  ArrowDown: "orbit-down",
  KeyW: "forward",
  KeyS: "back",
  KeyA: "left",
  KeyD: "right",
  KeyE: "up",
  KeyQ: "down",
};

/** The commands of arrows in modes that look around. */
const LOOKS: Record<string, string> = {
  ArrowLeft: "yaw-left",
  ArrowRight: "yaw-right",
  ArrowUp: "pitch-up",
  ArrowDown: "pitch-down",
};

const VIEWS: Record<string, string> = {
  KeyF: "front",
  KeyB: "back",
  KeyL: "left",
  KeyR: "right",
  KeyT: "top",
  KeyU: "bottom",
};

export const MODES = ["turntable", "rolling-ball", "look-at", "flying", "mouselook", "absolute"];

/** Listens to a canvas. `mode` tells the navigation mode. */
export function listen(canvas: HTMLCanvasElement, hand: Hand, mode: () => string): void {
  const pointers = new Map<number, { x: number; y: number }>();
  let from: { x: number; y: number; isClick: boolean } | undefined;
  let pinch: { distance: number } | undefined;

  const middle = (): { clientX: number; clientY: number } => {
    const all = [...pointers.values()];
    const sum = (axis: "x" | "y"): number => all.reduce((total, pointer) => total + pointer[axis], 0) / all.length;
    return { clientX: sum("x"), clientY: sum("y") };
  };
  const distance = (): number => {
    const [a, b] = [...pointers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 1;
  };

  canvas.addEventListener("pointerdown", (event) => {
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (pointers.size === 1) {
      from = { x: event.clientX, y: event.clientY, isClick: event.button === 0 };
      const isPan = event.button === 2 || event.button === 1 || event.shiftKey;
      hand.move(["grab", isPan ? "pan" : event.ctrlKey ? "zoom" : "turn", ...hand.place(event)]);
    } else if (pointers.size === 2) {
      if (from) from.isClick = false;
      pinch = { distance: distance() };
      hand.move(["release"], ["grab", "pan", ...hand.place(middle())]);
    }
    event.preventDefault();
  });

  canvas.addEventListener("pointermove", (event) => {
    const pointer = pointers.get(event.pointerId);
    if (pointer === undefined) {
      if (event.pointerType !== "touch") hand.hover(hand.place(event));
      return;
    }
    [pointer.x, pointer.y] = [event.clientX, event.clientY];
    if (from && Math.hypot(event.clientX - from.x, event.clientY - from.y) > CLICK) from.isClick = false;
    if (pointers.size === 1 && from && !from.isClick) {
      hand.move(["drag", ...hand.place(event)]);
    } else if (pointers.size === 2 && pinch) {
      const now = distance();
      // A notch of the wheel divides the distance by 1.2.
      const notches = Math.log(now / pinch.distance) / Math.log(1.2);
      pinch.distance = now;
      const at = hand.place(middle());
      hand.move(["drag", ...at], ["wheel", notches, ...at]);
    }
  });

  const up = (event: PointerEvent): void => {
    if (!pointers.delete(event.pointerId)) return;
    hand.move(["release"]);
    pinch = undefined;
    if (pointers.size === 0 && from?.isClick && event.type === "pointerup") hand.click(hand.place(event));
    if (pointers.size === 0) from = undefined;
    else hand.move(["grab", "turn", ...hand.place(middle())]);
  };
  canvas.addEventListener("pointerup", up);
  canvas.addEventListener("pointercancel", up);
  canvas.addEventListener("pointerleave", () => hand.hover(undefined));
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());

  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY / 3 : event.deltaY / 100;
      hand.move(["wheel", -Math.min(Math.max(lines, -5), 5), ...hand.place(event)]);
    },
    { passive: false },
  );

  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (hand.key(event)) {
      event.preventDefault();
      return;
    }
    const looks = mode() === "flying" || mode() === "mouselook";
    const tap = (looks && LOOKS[event.code]) || TAPS[event.code];
    const box = canvas.getBoundingClientRect();
    const centre = hand.place({ clientX: box.left + box.width / 2, clientY: box.top + box.height / 2 });
    const number = /^Digit([1-6])$/.exec(event.code);
    if (tap !== undefined) hand.move(["tap", tap, 1]);
    else if (VIEWS[event.code] !== undefined) hand.move(["look_from", VIEWS[event.code]!]);
    else if (number) hand.move(["set_mode", MODES[Number(number[1]) - 1]!]);
    else if (event.key === "+" || event.key === "=") hand.move(["wheel", 1, ...centre]);
    else if (event.key === "-") hand.move(["wheel", -1, ...centre]);
    else if (event.key === "Home") hand.move(["home"]);
    else return;
    event.preventDefault();
  });
}
