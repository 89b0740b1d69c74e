/** N, L, V and R or H at the explained point, drawn over the picture. */

import type { Ledger } from "luxel";
import { drawn } from "./dom.ts";
import { surfaceOf } from "./ledger.ts";

/** The length of a vector parallel to the picture, in pixels of the page. */
const LENGTH = 72;

function degrees(cosine: number): string {
  return `${((Math.acos(Math.min(Math.max(cosine, -1), 1)) * 180) / Math.PI).toFixed(1)}°`;
}

/** Draws the vectors of a ledger at a point of the overlay; a pixel of the page is `unit` of the overlay's units long. */
export function showVectors(overlay: SVGElement, ledger: Ledger | undefined, at: [number, number], unit = 1): void {
  overlay.replaceChildren();
  const surface = ledger && surfaceOf(ledger);
  if (surface === undefined) return;
  // In pixels of the page from the point, so that letters are as large in a narrow window.
  const vectors = drawn("g", { transform: `translate(${at.join(" ")}) scale(${unit})` });
  overlay.append(vectors);
  const taken: [number, number][] = [];
  const texts: SVGElement[] = [];
  for (const { kind, name, cosine, picture } of surface.vectors) {
    const [right, down] = picture;
    const [toX, toY] = [right * LENGTH, down * LENGTH];
    const color = `var(--${kind})`;
    const ends = { x1: 0, y1: 0, x2: toX, y2: toY };
    vectors.append(
      drawn("line", { ...ends, stroke: "var(--ground)", "stroke-width": 4, "stroke-linecap": "round" }),
      drawn("line", { ...ends, style: `stroke:${color}`, "stroke-width": 2, "stroke-linecap": "round" }),
      drawn("circle", { cx: toX, cy: toY, r: 3, style: `fill:${color}` }),
    );
    const length = Math.hypot(right, down) || 1;
    let [textX, textY] = [toX + (right / length) * 12, toY + (down / length) * 14 + 4];
    while (taken.some(([otherX, otherY]) => Math.abs(otherX - textX) < 60 && Math.abs(otherY - textY) < 15)) {
      textY += 16;
    }
    taken.push([textX, textY]);
    const anchor = right < -0.2 ? "end" : right > 0.2 ? "start" : "middle";
    const text = drawn("text", { x: textX, y: textY, "text-anchor": anchor, style: `fill:${color}` });
    text.textContent = cosine === null ? name : `${name} ${degrees(cosine)}`;
    texts.push(text);
  }
  vectors.append(drawn("circle", { cx: 0, cy: 0, r: 4, fill: "none", stroke: "var(--accent)", "stroke-width": 1.5 }), ...texts);
}
