// Tests of the articles: their numbers, their stills, their tutors; and of all pages, what they fetch, and that axe finds
// no barriers.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { isDeepStrictEqual } from "node:util";
import decodeWebp, { init as startWebp } from "@jsquash/webp/decode.js";
import { open, pixelsOfProgram } from "./browser.mjs";
import { compressedSize } from "./compressed.mjs";
import { browser, folder, middle, program, site, test } from "./harness.mjs";

const PAGES = ["index.html", "light.html", "reflection.html", "shading.html", "picking.html", "navigation.html"];

const decoder = join(import.meta.dirname, "../node_modules/@jsquash/webp/codec/dec/webp_dec.wasm");
await startWebp(new WebAssembly.Module(readFileSync(decoder)));

/** A still picture: its width and its pixels, four bytes each. */
async function readStill(page, name) {
  const still = await page.request.get(`${site.address}/stills/${name}.webp`);
  assert.ok(still.ok(), `there is no still ${name}`);
  const { width, data } = await decodeWebp(await still.body());
  return { width, data: Buffer.from(data.buffer) };
}

/** The pixels of a part of a picture. */
function partOf({ width, data }, [left, top], [partWidth, partHeight]) {
  const row = (y) => data.subarray(4 * (y * width + left), 4 * (y * width + left + partWidth));
  return Buffer.concat(Array.from({ length: partHeight }, (_, y) => row(top + y)));
}

const digestOf = (bytes) => [...createHash("sha256").update(bytes).digest()].join();

/** The digest of a still picture's pixels. */
const digestOfStill = async (page, name) => digestOf((await readStill(page, name)).data);

test("every still picture of the pages is the program's", async () => {
  const shown = JSON.parse(readFileSync(join(import.meta.dirname, "../stills.json"), "utf8"));
  assert.ok(shown.length > 50);
  const page = await browser.context.newPage();
  for (const { name, demo, pairs, at } of shown) {
    const flags = pairs.map(([flag, text]) => (text === "" ? `--${flag}` : `--${flag}=${text}`));
    const [width, height] = pairs.find(([flag]) => flag === "size")[1].split("x").map(Number);
    const part = partOf(await readStill(page, name), at, [width, height]);
    assert.ok(part.equals(pixelsOfProgram(program, `demo:${demo}`, flags)), `${name} at ${at}: ${flags.join(" ")}`);
  }
  await page.close();
});

test("every number of the page on light changes its picture and its ledger, and its stills are the program's", async () => {
  const { page, faults } = await open(browser.context, `${site.address}/light.html`);
  await page.evaluate(() => window.luxel.settled());
  const figures = page.locator("figure.live");
  assert.equal(await figures.count(), 7);
  for (let at = 0; at < (await figures.count()); at++) {
    const figure = figures.nth(at);
    const state = () =>
      figure.evaluate(async (one) => {
        await window.luxel.settled();
        const bytes = await crypto.subtle.digest("SHA-256", window.luxel.pixels(one.querySelector("canvas")));
        return [...new Uint8Array(bytes)].join();
      });
    const first = await state();
    const still = await digestOfStill(page, `light-${await figure.getAttribute("id")}`);
    assert.equal(still, first, "the still picture is the live one");
    const numbers = figure.locator("[role=slider]");
    const seen = new Set();
    for (let number = 0; number < (await numbers.count()); number++) {
      const slider = numbers.nth(number);
      const name = await slider.getAttribute("aria-label");
      if (seen.has(name)) continue;
      seen.add(name);
      const before = await state();
      const value = Number(await slider.getAttribute("aria-valuenow"));
      const [min, max] = [Number(await slider.getAttribute("aria-valuemin")), Number(await slider.getAttribute("aria-valuemax"))];
      await slider.scrollIntoViewIfNeeded();
      const box = await slider.boundingBox();
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + (value - min > max - value ? -90 : 90), y, { steps: 4 });
      await page.mouse.up();
      assert.notEqual(Number(await slider.getAttribute("aria-valuenow")), value, `${name} can be dragged`);
      assert.notEqual(await state(), before, `${name} changes nothing`);
      await slider.press("ArrowRight");
      await slider.press("ArrowLeft");
    }
    await figure.locator("text=Start again").click();
    assert.equal(await state(), first);
  }
  assert.deepEqual(faults, []);
  await page.close();
});

for (const [article, count] of [["shading", 9], ["reflection", 4]]) {
  test(`every number and choice of the comparisons on ${article} changes a picture, and stills are live`, () =>
    compared(article, count));
}

/** Tests the comparisons of a page. */
async function compared(article, count) {
  const { page, faults } = await open(browser.context, `${site.address}/${article}.html`);
  await page.evaluate(() => window.luxel.settled());
  const figures = page.locator("figure.live:has(.compared)");
  assert.equal(await figures.count(), count);
  for (let at = 0; at < (await figures.count()); at++) {
    const figure = figures.nth(at);
    const id = await figure.getAttribute("id");
    const state = () =>
      figure.evaluate(async (one) => {
        await window.luxel.settled();
        const digests = [];
        for (const canvas of one.querySelectorAll("canvas")) {
          const bytes = await crypto.subtle.digest("SHA-256", window.luxel.pixels(canvas));
          digests.push([...new Uint8Array(bytes)].join());
        }
        return digests;
      });
    const first = await state();
    for (const [side, name] of ["problem", "cure"].entries()) {
      assert.equal(await digestOfStill(page, `${article}-${id}-${name}`), first[side], `${id}, ${name}`);
    }
    assert.notEqual(first[0], first[1], `${id}: the cure changes something`);
    assert.match(await figure.locator(".said").textContent(), /differ by up to [1-9]/);
    for (const slider of await figure.locator("[role=slider]").all()) {
      const before = await state();
      await slider.press("PageUp");
      // Some angles matter only beyond that of the mesh.
      if (isDeepStrictEqual(await state(), before)) await slider.press("End");
      assert.notDeepEqual(await state(), before, `${id}: ${await slider.getAttribute("aria-label")} changes nothing`);
    }
    for (const choice of await figure.locator("select").all()) {
      const before = await state();
      await choice.selectOption("flat");
      assert.notDeepEqual(await state(), before);
    }
    const divider = figure.locator("input[type=range]");
    await divider.focus();
    await page.keyboard.press("End");
    assert.equal(await figure.locator(".compared").evaluate((one) => one.style.getPropertyValue("--cut")), "100%");
    await figure.locator("text=Start again").click();
    assert.deepEqual(await state(), first);
  }
  assert.deepEqual(faults, []);
  await page.close();
}

test("every number of the page on reflection changes its vectors, its ledger and the table of shininess", async () => {
  const { page, faults } = await open(browser.context, `${site.address}/reflection.html`);
  const state = () =>
    page.evaluate(async () => {
      await window.luxel.settled();
      const cells = [...document.querySelectorAll("#vectors canvas, #table canvas")];
      const digests = [];
      for (const cell of cells) {
        const bytes = await crypto.subtle.digest("SHA-256", window.luxel.pixels(cell));
        digests.push([...new Uint8Array(bytes)].join());
      }
      return digests;
    });
  const first = await state();
  assert.equal(new Set(first).size, 25, "each ball of the table is another one");
  const still = await readStill(page, "reflection-table");
  for (const [at, live] of first.slice(1).entries()) {
    const [left, top] = [(at % 6) * 104, Math.floor(at / 6) * 104];
    assert.equal(digestOf(partOf(still, [left, top], [104, 104])), live, `ball ${at} of the still picture is the live one`);
  }
  for (const slider of await page.locator("#vectors [role=slider]").all()) {
    const before = await state();
    await slider.press("PageDown");
    assert.notEqual((await state())[0], before[0]);
  }
  assert.match(await page.locator("#vectors svg").textContent(), /N.*R|R.*N/);
  const before = await state();
  await page.locator("#table [role=slider]").press("PageUp");
  const after = await state();
  assert.ok(after.slice(1).every((cell, at) => cell !== before[at + 1]), "all balls have other light");
  assert.deepEqual(faults, []);
  await page.close();
});

test("the tutors' commands draw their pictures", async () => {
  for (const [name, id, model] of [["light", "tutor", "demo:teapot"], ["navigation", "look-at", "demo:welcome"]]) {
    const { page, faults } = await open(browser.context, `${site.address}/${name}.html`);
    await page.evaluate(() => window.luxel.settled());
    const digest = () =>
      page.evaluate(async (id) => {
        await window.luxel.settled();
        const bytes = await crypto.subtle.digest("SHA-256", window.luxel.pixels(document.querySelector(`#${id} canvas`)));
        return [...new Uint8Array(bytes)].join();
      }, id);
    const sliders = page.locator(`#${id} [role=slider]`);
    const seen = new Set();
    for (const slider of await sliders.all()) {
      const label = await slider.getAttribute("aria-label");
      if (seen.has(label)) continue;
      seen.add(label);
      const before = await digest();
      const isLast = (await slider.getAttribute("aria-valuenow")) === (await slider.getAttribute("aria-valuemax"));
      // The planes are before and beyond everything at first.
      const key = label.includes("near plane") ? "End" : label.includes("far plane") ? "Home" : isLast ? "PageDown" : "PageUp";
      await slider.press(key);
      assert.notEqual(await digest(), before, `${label} changes nothing`);
    }
    const text = await page.locator(`#${id} pre`).last().textContent();
    const words = text.replace(/−/g, "-").replace(/\\\n/g, " ").trim().split(/\s+/);
    const flags = [...words.slice(3, -2), "--size", "640x400"];
    const expected = createHash("sha256").update(pixelsOfProgram(program, model, flags)).digest();
    assert.equal(await digest(), [...expected].join(), name);
    assert.deepEqual(faults, []);
    await page.close();
  }
});

test("the page on navigation moves by mouse, keys and buttons, in all modes, with its matrix and log", async () => {
  const { page, faults } = await open(browser.context, `${site.address}/navigation.html`);
  await page.evaluate(() => window.luxel.settled());
  const figure = page.locator("#modes");
  const matrix = async () => {
    await page.evaluate(() => window.luxel.settled());
    return figure.locator("math").textContent();
  };
  await figure.scrollIntoViewIfNeeded();
  const box = await figure.locator("canvas").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  for (const mode of await figure.locator("select option").allTextContents()) {
    await figure.locator("select").selectOption(mode);
    const before = await matrix();
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 50, y + 10, { steps: 5 });
    await page.mouse.up();
    assert.notEqual(await matrix(), before, `${mode} by mouse`);
    const dragged = await matrix();
    await page.keyboard.press("ArrowLeft");
    const buttons = { absolute: "turn-y+", "look-at": "target-x+" };
    await figure.getByRole("button", { name: buttons[mode] ?? "forward", exact: true }).click();
    assert.notEqual(await matrix(), dragged, `${mode} by button`);
    assert.match(await figure.locator(".log").textContent(), /tap /);
  }
  const loop = page.locator("#rolling-ball");
  const [area, angle] = (await loop.locator(".said").textContent()).match(/-?\d+\.\d+(?=°)/g).map(Number);
  assert.ok(Math.abs(area - angle) < 0.06 * area, `${area} and ${angle} degrees`);
  assert.deepEqual(faults, []);
  await page.close();
});

test("ray, sliver, name stack and picture of ids agree wherever one clicks, and with the program", async () => {
  const { page, faults } = await open(browser.context, `${site.address}/picking.html`);
  const canvas = page.locator("#ray canvas");
  await page.evaluate(() => window.luxel.settled());
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const flags = ["--size", "640x400", "--json"];
  for (let turn = 0; turn < 24; turn++) {
    // Places all over the picture, the same ones in each run.
    const [x, y] = [(turn * 197 + 40) % 640, (turn * 131 + 30) % 400];
    await page.mouse.click(box.x + ((x + 0.5) / 640) * box.width, box.y + ((y + 0.5) / 400) * box.height);
    const verdict = await page.evaluate(async () => {
      await window.luxel.settled();
      return document.querySelector("#verdict p").textContent;
    });
    const place = verdict.match(/Pixel (\d+), (\d+)/).slice(1).join();
    assert.match(verdict, /agree on/);
    const { hits } = JSON.parse(execFileSync(program, ["pick", "demo:plane", "--at", place, ...flags], { encoding: "utf8" }));
    assert.ok(verdict.endsWith(`agree on ${hits[0] ? hits[0].path.join(" / ") : "nothing"}.`), verdict);
    const [left, top] = place.split(",").map((at) => Number(at) + 0.5 - 2.5);
    const rect = JSON.parse(execFileSync(program, ["pick", "demo:plane", "--rect", `${left},${top},5,5`, ...flags], { encoding: "utf8" }));
    const records = await page.locator("#sliver-hits tbody tr td:last-child").allTextContents();
    assert.deepEqual(records.sort(), rect.hits.map((hit) => hit.names.join(" / ")).sort());
  }
  const before = await page.locator("#sliver-hits").textContent();
  await page.locator("#side [role=slider]").press("End");
  await page.evaluate(() => window.luxel.settled());
  assert.notEqual(await page.locator("#sliver-hits").textContent(), before, "a wide sliver finds more");
  assert.deepEqual(faults, []);
  await page.close();
});

test("no page fetches more than a megabyte until its first picture and its answers are there", async () => {
  const sizes = new Map();
  const sizeOf = (path) => {
    if (!sizes.has(path)) sizes.set(path, compressedSize(join(folder, path)));
    return sizes.get(path);
  };
  for (const name of PAGES) {
    const page = await browser.context.newPage();
    const fetched = new Set();
    page.on("request", (request) => fetched.add(new URL(request.url()).pathname));
    await page.goto(`${site.address}/${name}`);
    await page.evaluate(() => window.luxel.ready);
    await page.waitForLoadState("networkidle");
    await page.close();
    assert.ok(fetched.has("/luxel/answers.wasm"), `${name} has not fetched all`);
    const sum = [...fetched].reduce((sum, path) => sum + sizeOf(path), 0);
    console.log(`${name}: ${sum} bytes in ${fetched.size} files`);
    assert.ok(sum <= 1_000_000, `${name}: ${sum} bytes`);
  }
});

test("axe finds nothing serious, in dark and light, on screens and phones", async () => {
  const axe = readFileSync(join(import.meta.dirname, "../node_modules/axe-core/axe.min.js"), "utf8");
  for (const name of PAGES) {
    for (const colorScheme of ["dark", "light"]) {
      for (const viewport of [{ width: 1280, height: 800 }, { width: 390, height: 844 }]) {
        const { page, faults } = await open(browser.context, `${site.address}/${name}`, { colorScheme, viewport });
        await page.evaluate(() => window.luxel.settled());
        if (name === "index.html") {
          await page.mouse.move(...(await middle(page)));
          await page.waitForFunction(() => document.querySelectorAll("#overlay line").length > 0);
        }
        await page.evaluate(() => document.querySelectorAll("details").forEach((one) => (one.open = true)));
        await page.evaluate(axe);
        const { violations } = await page.evaluate(() => window.axe.run());
        const serious = violations.filter((one) => ["serious", "critical"].includes(one.impact));
        const of = (one) => one.nodes.map((node) => node.html.slice(0, 120)).slice(0, 4).join(" | ");
        assert.deepEqual(serious.map((one) => `${name}, ${colorScheme}: ${one.id}: ${of(one)}`), []);
        assert.deepEqual(faults, []);
        await page.close();
      }
    }
  }
});
