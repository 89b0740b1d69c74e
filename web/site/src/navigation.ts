/** The page on navigation. */

import { LiveFigure } from "./article.ts";
import { byId } from "./dom.ts";
import { FIGURES } from "./figures/navigation.ts";
import { modes, rollingBall } from "./moving.ts";
import { offer } from "./testing.ts";

const tutor = new LiveFigure(FIGURES[0]!);
tutor.place();
const moved = [modes("modes"), rollingBall("rolling-ball")];
const near = new IntersectionObserver(
  (entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      near.unobserve(target);
      void moved[target.id === "modes" ? 0 : 1]!.draw();
    }
  },
  { rootMargin: "300px" },
);
near.observe(byId("modes"));
near.observe(byId("rolling-ball"));
offer(tutor.draw(), {
  pixels: (canvas) => [tutor, ...moved].find((one) => one.canvas === canvas)?.pixels ?? tutor.pixels,
  explain: async (x, y) => {
    await tutor.settled();
    return tutor.explain(x, y);
  },
  settled: async () => {
    await Promise.all([tutor.draw().then(() => tutor.settled()), ...moved.map((one) => one.draw().then(() => one.draw()))]);
  },
});
