/** The page on reflection. */

import { LiveFigure } from "./article.ts";
import { LiveComparison } from "./compared.ts";
import { byId } from "./dom.ts";
import { COMPARISONS, TABLE, VECTORS } from "./figures/reflection.ts";
import { LiveTable } from "./table.ts";
import { offer } from "./testing.ts";

const vectors = new LiveFigure(VECTORS[0]!);
vectors.place();
const comparisons = COMPARISONS.map((comparison) => new LiveComparison(comparison));
comparisons.forEach((one) => one.place());
const table = new LiveTable("table", TABLE);
const drawn = new Map<string, () => Promise<void>>([
  ["table", () => table.draw()],
  ...comparisons.map((one): [string, () => Promise<void>] => [one.comparison.id, () => one.draw()]),
]);
const near = new IntersectionObserver(
  (entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      near.unobserve(target);
      void drawn.get(target.id)?.();
    }
  },
  { rootMargin: "300px" },
);
for (const id of drawn.keys()) near.observe(byId(id));
const sides = comparisons.flatMap((one) => one.sides);
offer(vectors.draw(), {
  pixels: (canvas) =>
    sides.find((side) => side.canvas === canvas)?.pixels ?? table.pixels(canvas) ?? vectors.pixels,
  explain: async (x, y) => {
    await vectors.settled();
    return vectors.explain(x, y);
  },
  settled: async () => {
    await Promise.all([
      vectors.draw().then(() => vectors.settled()),
      table.draw(),
      ...comparisons.map((one) => one.draw().then(() => one.settled())),
    ]);
  },
});
