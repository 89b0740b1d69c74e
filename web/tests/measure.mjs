// Measures the pages in a browser beside the program, in turns: node tests/measure.mjs SITE PROGRAM [TURNS].
//
// Prints JSON: milliseconds from navigation to the first paint and to the first picture; medians of frames of 1280x720
// with one sample, by one worker and by two, beside the program on as many threads with the same width of vectors; of
// explanations; and the longest task of the page while a hand turns the model. A busy machine makes all of them
// meaningless.

import { execFileSync } from "node:child_process";
import { resolve } from "node:path";
import { launch, open, serve } from "./browser.mjs";

const [folder, program, turns = "3"] = process.argv.slice(2);
const site = await serve(resolve(folder));
const browser = await launch();
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const round = (value) => Number(value.toFixed(2));
const DEMOS = ["lab-silhouette", "teapot", "blob"];
const FRAMES = 40;
/** Frames before those: each worker begins with code from the compiler that is quick to compile. */
const WARM_UP = 40;

/** Frames of a demo in the page, turned a little before each. */
async function framesOfPage(demo, workers) {
  const { page } = await open(browser.context, `${site.address}/index.html#demo=teapot&size=64x64`);
  const times = await page.evaluate(
    async ([name, workers, frames, before]) => {
      const { configure, demo } = await import("./luxel/luxel.js");
      configure({ workers });
      const scene = await demo(name);
      const view = await scene.view({ size: "1280x720", samples: 1, azimuth: 30, elevation: 20 });
      await view.ready();
      const canvas = document.createElement("canvas");
      const times = [];
      for (let frame = 0; frame < before + frames; frame++) {
        await view.navigate(["tap", "orbit-right", 0.2]);
        const begin = performance.now();
        await view.draw(canvas, { workers });
        times.push(performance.now() - begin);
      }
      scene.dispose();
      return times.slice(before);
    },
    [demo, workers, FRAMES, WARM_UP],
  );
  await page.close();
  return median(times);
}

function framesOfProgram(demo, threads) {
  const flags = ["--size", "1280x720", "--samples", "1", "--threads", String(threads), "--simd", "sse4.2", "--frames", String(FRAMES), "--json"];
  return JSON.parse(execFileSync(program, ["bench", `demo:${demo}`, ...flags], { encoding: "utf8" })).frame_ms.median;
}

const results = { first_paint_ms: [], first_picture_ms: [], frames: {}, explain_ms: 0, longest_task_ms: 0 };
for (let turn = 0; turn < Number(turns); turn++) {
  const { page } = await open(browser.context, `${site.address}/index.html`);
  results.first_picture_ms.push(round(await page.evaluate(async () => {
    await window.luxel.ready;
    return performance.getEntriesByName("first picture")[0]?.startTime ?? performance.now();
  })));
  results.first_paint_ms.push(round(await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0].startTime)));
  await page.close();
}
for (const demo of DEMOS) {
  const [one, two, native, nativeTwo] = [[], [], [], []];
  for (let turn = 0; turn < Number(turns); turn++) {
    native.push(framesOfProgram(demo, 1));
    nativeTwo.push(framesOfProgram(demo, 2));
    one.push(await framesOfPage(demo, 1));
    two.push(await framesOfPage(demo, 2));
  }
  const [a, b, c, d] = [one, two, native, nativeTwo].map(median);
  const ratios = { to_program: round(a / c), two_to_one: round(a / b), two_to_one_of_program: round(c / d) };
  results.frames[demo] = { one: round(a), two: round(b), program: round(c), ...ratios };
}
const { page } = await open(browser.context, `${site.address}/index.html`);
results.explain_ms = round(median(await page.evaluate(async () => {
  const { demo } = await import("./luxel/luxel.js");
  const view = await (await demo("teapot")).view({ size: "1280x720" });
  const times = [];
  for (let at = 0; at < 60; at++) {
    const begin = performance.now();
    await view.ledger(500 + 4 * at, 360);
    times.push(performance.now() - begin);
  }
  return times;
})));
await page.evaluate(() => {
  window.long = [0];
  new PerformanceObserver((list) => window.long.push(...list.getEntries().map((entry) => entry.duration))).observe({ type: "longtask" });
});
const box = await page.locator("#canvas").boundingBox();
await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
await page.mouse.down();
for (let step = 0; step < 60; step++) await page.mouse.move(box.x + box.width / 2 + 3 * step, box.y + box.height / 2 + step);
await page.mouse.up();
await page.waitForTimeout(500);
// Tasks of less than 50 ms aren't listed.
results.longest_task_ms = Math.max(...(await page.evaluate(() => window.long)));
console.log(JSON.stringify(results, null, 2));
await browser.close();
site.close();
