// Drives the pages with real mouse, keyboard and touch events: node tests/pages.mjs SITE PROGRAM [MODELS [NAME]].
//
// PROGRAM is the native `luxel`, whose pictures and answers the pages must equal. With NAME only tests run
// whose names contain it.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync, existsSync } from "node:fs";
import { createHash } from "node:crypto";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { isDeepStrictEqual } from "node:util";
import { PNG } from "pngjs";
import { launch, open, pixelsOfProgram, serve } from "./browser.mjs";

const [folder, program, models, only = ""] = process.argv.slice(2);
if (program === undefined) {
  console.error("usage: node tests/pages.mjs SITE PROGRAM [MODELS]");
  process.exit(2);
}
const site = await serve(resolve(folder));
const browser = await launch();
const work = mkdtempSync(join(tmpdir(), "luxel-pages-"));
const viewer = `${site.address}/index.html`;
const tests = [];
const test = (name, run) => tests.push({ name, run });

/** The pixels of a page's picture, when nothing is left to draw. */
async function pixelsOf(page) {
  const text = await page.evaluate(async () => {
    await window.luxel.settled();
    const bytes = window.luxel.pixels(document.querySelector("canvas"));
    let text = "";
    for (let at = 0; at < bytes.length; at += 0x8000) text += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
    return btoa(text);
  });
  return Buffer.from(text, "base64");
}

/** Opens the viewer, and fails if anything in the page went wrong. */
async function withViewer(hash, use, options = {}) {
  const { page, faults } = await open(browser.context, viewer + hash, options);
  try {
    await use(page);
    assert.deepEqual(faults, options.expected ?? []);
  } finally {
    await page.close();
  }
}

/** The canvas's middle, in pixels of the page. */
async function middle(page) {
  const box = await page.locator("#canvas").boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

test("the first page shows the teapot and no fault", () =>
  withViewer("", async (page) => {
    const pixels = await pixelsOf(page);
    assert.ok(pixels.some((byte) => byte > 100));
    assert.equal((await page.request.get(`${site.address}/favicon.ico`)).status(), 200);
    assert.equal(await page.locator("#demo option").count() > 10, true);
  }));

const DEMOS = ["teapot", "spheres", "cornell", "plane", "welcome", "primitives", "materials", "textures", "fog", "machine"];

test("ten demos have the bytes of the program", async () => {
  const list = JSON.parse(execFileSync(program, ["demos", "--json"], { encoding: "utf8" }));
  const names = (list.demos ?? list).map((demo) => demo.name);
  const chosen = [...DEMOS.filter((name) => names.includes(name)), ...names.filter((name) => !DEMOS.includes(name))];
  for (const [at, name] of chosen.slice(0, 12).entries()) {
    const samples = ["1", "4"][at % 2];
    const flags = ["--size", "300x200", "--samples", samples];
    await withViewer(`#demo=${name}&size=300x200&samples=${samples}`, async (page) => {
      const drawn = await pixelsOf(page);
      const expected = pixelsOfProgram(program, `demo:${name}`, flags);
      assert.ok(drawn.equals(expected), `${name} has other bytes than the program's`);
    });
  }
});

test("a link with lights, shadows and shading has the bytes of the program", async () => {
  const flags = {
    size: "320x240",
    azimuth: "70",
    light: "point:pos=4,5,6:diffuse=1,.8,.6:attenuation=0.5,0.05,0.01",
    shadows: "",
    background: "tomato",
    ks: "0.9",
    tone: "agx",
  };
  const line = Object.entries(flags).flatMap(([name, value]) => (value === "" ? [`--${name}`] : [`--${name}`, value]));
  const expected = pixelsOfProgram(program, "demo:teapot", line);
  await withViewer(`#demo=teapot&${new URLSearchParams(flags)}`, async (page) => {
    assert.ok((await pixelsOf(page)).equals(expected));
  });
});

test("two workers draw the bytes of one", () =>
  withViewer("#demo=teapot&size=64x64", async (page) => {
    const isSame = await page.evaluate(async () => {
      const { configure, demo } = await import("./luxel/luxel.js");
      configure({ workers: 3 });
      using_: {
        const scene = await demo("spheres");
        const view = await scene.view({ size: [700, 333], shadows: true });
        const alone = await view.render({ workers: 1 });
        await view.ready();
        const shared = await view.render();
        await view.set({ size: [700, 333], color: "red" });
        const red = await view.render({ workers: 1 });
        await view.ready();
        const sharedRed = await view.render();
        await view.hide([1, 2]);
        const hidden = await view.render({ workers: 1 });
        await view.ready();
        const sharedHidden = await view.render();
        scene.dispose();
        const same = (a, b) => a.data.every((byte, at) => byte === b.data[at]);
        return [same(alone, shared), same(red, sharedRed), same(hidden, sharedHidden), same(alone, red), same(red, hidden)];
      }
    });
    assert.deepEqual(isSame, [true, true, true, false, false]);
  }));

test("explanations and picks are the program's", () =>
  withViewer("#demo=teapot&size=320x240", async (page) => {
    const flags = ["--size", "320x240", "--json"];
    for (const [x, y] of [[160, 130], [10, 10], [120, 90], [250, 120]]) {
      const drawn = await page.evaluate(([x, y]) => window.luxel.explain(x, y), [x, y]);
      const expected = JSON.parse(execFileSync(program, ["explain", "demo:teapot", "--at", `${x},${y}`, ...flags]));
      for (const key of ["camera", "model"]) {
        delete drawn[key];
        delete expected[key];
      }
      assert.deepEqual(drawn, expected, `pixel ${x}, ${y}`);
      const picked = await page.evaluate(async ([x, y]) => {
        const { demo } = await import("./luxel/luxel.js");
        const scene = await demo("teapot");
        const view = await scene.view({ size: "320x240" });
        const answer = await view.pickAnswer(x + 0.5, y + 0.5);
        scene.dispose();
        return answer.hits;
      }, [x, y]);
      const hits = JSON.parse(execFileSync(program, ["pick", "demo:teapot", "--at", `${x},${y}`, ...flags])).hits;
      assert.deepEqual(picked, hits);
    }
  }));

test("a hand turns the model, and the log plays to the same camera", () =>
  withViewer("#demo=teapot&size=600x400", async (page) => {
    const before = await pixelsOf(page);
    const [x, y] = await middle(page);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 80, y - 30, { steps: 6 });
    await page.mouse.up();
    await page.mouse.wheel(0, -240);
    await page.keyboard.press("ArrowLeft");
    await page.waitForTimeout(400);
    assert.ok(!(await pixelsOf(page)).equals(before));
    const [download] = await Promise.all([
      page.waitForEvent("download"),
      page.evaluate(() => document.querySelector("#save-log").click()),
    ]);
    const log = join(work, "camera.log");
    await download.saveAs(log);
    const line = await page.locator("#command").textContent();
    const matrix = /--view-matrix (\S+)/.exec(line)[1].split(",").map(Number);
    const replayed = execFileSync(
      program,
      ["navigate", "demo:teapot", "--mode", "turntable", "--size", "600x400", "--replay", log, "--json"],
      { encoding: "utf8", maxBuffer: 1 << 26 },
    );
    assert.deepEqual(JSON.parse(replayed).camera.view_from_world, matrix);
    // The command of the page draws the page's picture.
    const flags = line.replace(/^luxel render \S+ /, "").replace(/ -o picture.png$/, "").split(" ");
    assert.ok((await pixelsOf(page)).equals(pixelsOfProgram(program, "demo:teapot", flags)));
  }));

test("keys and touch move the camera", () =>
  withViewer("", async (page) => {
    const start = await pixelsOf(page);
    await page.locator("#canvas").focus();
    await page.keyboard.press("t");
    await page.waitForTimeout(300);
    const top = await pixelsOf(page);
    assert.ok(!top.equals(start), "T shows the top");
    await page.keyboard.press("Home");
    await page.waitForTimeout(300);
    assert.ok((await pixelsOf(page)).equals(start), "Home goes back");
    const [x, y] = await middle(page);
    const session = await page.context().newCDPSession(page);
    const touch = (type, points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
    await touch("touchStart", [{ x, y, id: 1 }]);
    for (let step = 1; step <= 5; step++) await touch("touchMove", [{ x: x + 12 * step, y, id: 1 }]);
    await touch("touchEnd", []);
    await page.waitForTimeout(400);
    const turned = await pixelsOf(page);
    assert.ok(!turned.equals(start), "a finger turns");
    await touch("touchStart", [{ x: x - 40, y, id: 1 }, { x: x + 40, y, id: 2 }]);
    await touch("touchMove", [{ x: x - 80, y, id: 1 }, { x: x + 80, y, id: 2 }]);
    await touch("touchEnd", []);
    await page.waitForTimeout(400);
    assert.ok(!(await pixelsOf(page)).equals(turned), "two fingers zoom");
  }));

test("pointing explains, a click keeps, Escape lets go", () =>
  withViewer("", async (page) => {
    const [x, y] = await middle(page);
    await page.mouse.move(x, y + 20);
    await page.waitForFunction(() => document.querySelectorAll("#overlay line").length > 0);
    const text = await page.locator("#ledger").textContent();
    assert.match(text, /body, triangle \d+/);
    assert.match(text, /N\.L = /);
    assert.ok((await page.locator("#ledger math").count()) > 5);
    await page.mouse.click(x, y + 20);
    await page.mouse.move(x + 60, y + 20);
    await page.waitForFunction(() => /kept/.test(document.querySelector("#ledger").textContent));
    await page.keyboard.press("Escape");
    await page.waitForFunction(() => !/kept/.test(document.querySelector("#ledger").textContent));
  }));

test("every number changes the picture", () =>
  withViewer("#demo=teapot&size=300x200&samples=1", async (page) => {
    await page.evaluate(() => document.querySelectorAll("details").forEach((one) => (one.open = true)));
    await page.selectOption("select[aria-label='Kind of the new light']", "spot");
    await page.click("text=Add a light");
    const inputs = page.locator("#lights input[type=number]:enabled, #surface input[type=number]:enabled");
    const count = await inputs.count();
    assert.ok(count > 30, `${count} numbers`);
    for (let at = 0; at < count; at++) {
      const input = inputs.nth(at);
      const name = await input.evaluate((one) => one.getAttribute("aria-label") ?? document.querySelector(`label[for=${one.id}]`)?.textContent);
      const before = await pixelsOf(page);
      const value = Number(await input.inputValue());
      // An extent shows in soft shadows only.
      if (name === "radius" || name === "angle °") continue;
      await input.fill(String(Number((value * 0.3 + 0.37).toPrecision(4))));
      await page.waitForTimeout(30);
      assert.ok(!(await pixelsOf(page)).equals(before), `${name} (${at}) changes nothing`);
      await input.fill(String(value));
      await page.waitForTimeout(30);
    }
  }));

test("a dropped model is shown, turned and explained, and stays in the page", async () => {
  const triangle = join(work, "part.obj");
  writeFileSync(triangle, "mtllib part.mtl\no blade\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  writeFileSync(join(work, "part.mtl"), "newmtl red\nKd 0.8 0.1 0.1\n");
  await withViewer("", async (page) => {
    const [x, y] = await middle(page);
    const session = await page.context().newCDPSession(page);
    const data = { items: [], files: [triangle, join(work, "part.mtl")], dragOperationsMask: 1 };
    for (const type of ["dragEnter", "dragOver", "drop"]) await session.send("Input.dispatchDragEvent", { type, x, y, data });
    await page.waitForFunction(() => document.querySelector("#objects").textContent.includes("blade"));
    const pixels = await pixelsOf(page);
    const [width, height] = await page.evaluate(() => [document.querySelector("#canvas").width, document.querySelector("#canvas").height]);
    const expected = pixelsOfProgram(program, triangle, ["--size", `${width}x${height}`, "--exposure", "auto"]);
    assert.ok(pixels.equals(expected));
    await page.mouse.move(x - 60, y + 60, { steps: 3 });
    await page.waitForFunction(() => document.querySelector("#ledger").textContent.includes("blade"));
  });
});

for (const name of ["Fox.glb", "BoxTextured.glb", "CesiumMilkTruck.glb"]) {
  const file = models && [join(models, name), join(models, "gltf", name)].find((path) => existsSync(path));
  if (!file) continue;
  test(`${name} has the bytes of the program`, () =>
    withViewer("", async (page) => {
      await page.setInputFiles("#files", file);
      await page.waitForFunction((name) => document.title.startsWith(name), name);
      const drawn = await pixelsOf(page);
      const [width, height] = await page.evaluate(() => [document.querySelector("#canvas").width, document.querySelector("#canvas").height]);
      assert.ok(drawn.equals(pixelsOfProgram(program, file, ["--size", `${width}x${height}`, "--exposure", "auto"])));
    }));
}

test("broken files, settings and sizes say what is wrong, and the page goes on", async () => {
  const broken = join(work, "broken.glb");
  writeFileSync(broken, Buffer.concat([Buffer.from("glTF"), Buffer.alloc(40, 7)]));
  const expected = (() => {
    try {
      execFileSync(program, ["info", broken], { stdio: "pipe", encoding: "utf8" });
    } catch (error) {
      return error.stderr.split("\n")[0].replace(/^luxel: error: /, "").replace(`${work}/`, "");
    }
    return assert.fail("the program reads it");
  })();
  await withViewer("", async (page) => {
    await page.setInputFiles("#files", broken);
    await page.waitForSelector("#message:not([hidden])");
    const told = await page.locator("#message").textContent();
    assert.ok(told.startsWith(expected), `${told} is not ${expected}`);
    await page.selectOption("#demo", "spheres");
    await page.waitForFunction(() => document.title.includes("spheres"));
    assert.ok(await page.locator("#message").isHidden());
  });
  for (const [hash, message] of [
    ["#demo=teapot&size=100000x100000", /a side has 1 to 16384 pixels/],
    ["#demo=teapott", /there is no demo `teapott`/],
    ["#demo=teapot&azimut=3", /did you mean `azimuth`/],
    ["#demo=teapot&light=point", /light/],
  ]) {
    await withViewer(hash, async (page) => assert.match(await page.locator("#message").textContent(), message));
  }
});

test("a worker that ends is started anew, and the page says so", () =>
  withViewer(
    "#demo=teapot&size=64x64",
    async (page) => {
      const error = await page.evaluate(async () => {
        const { load, demo } = await import("./luxel/luxel.js");
        // A list of vertices that is longer than a module's memory, in a limit that allows it.
        const faces = 400_000_000;
        const head = `ply\nformat binary_little_endian 1.0\nelement vertex ${faces}\nproperty float x\nproperty float y\nproperty float z\nend_header\n`;
        const bytes = new Uint8Array(900_000_000);
        bytes.set(new TextEncoder().encode(head));
        let name = "no error";
        try {
          await load(bytes, { maxMemory: 1e12 });
        } catch (caught) {
          name = caught.name;
        }
        const scene = await demo("spheres");
        scene.dispose();
        return name;
      });
      assert.match(error, /LuxelError|WorkerEndedError/);
    },
    { expected: [] },
  ));

test("check marks what spoils shading, and leaves again", () =>
  withViewer("#demo=teapot&size=320x240", async (page) => {
    const before = await pixelsOf(page);
    await page.click("#check");
    await page.waitForSelector("#findings-panel:not([hidden])");
    const kinds = await page.locator("#findings h3").allTextContents();
    const program_ = (() => {
      try {
        return execFileSync(program, ["check", "demo:teapot", "--size", "320x240", "--json"], { encoding: "utf8", stdio: "pipe" });
      } catch (error) {
        return error.stdout;
      }
    })();
    assert.deepEqual(kinds.map((kind) => kind.split(":")[0]), JSON.parse(program_).findings.map((finding) => finding.kind));
    await page.click("#close-check");
    assert.ok((await pixelsOf(page)).equals(before));
  }));

test("objects can be hidden, and layers shown", () =>
  withViewer("#demo=teapot&size=320x240", async (page) => {
    const before = await pixelsOf(page);
    await page.click("#objects >> text=lid");
    await page.waitForTimeout(100);
    const without = await pixelsOf(page);
    assert.ok(!without.equals(before));
    await page.click("#objects >> text=lid");
    await page.waitForTimeout(100);
    assert.ok((await pixelsOf(page)).equals(before));
    const seen = new Set();
    for (const layer of ["normal", "diffuse", "object", "barycentric"]) {
      await page.selectOption("#layer", layer);
      await page.waitForTimeout(50);
      seen.add((await pixelsOf(page)).toString("base64"));
    }
    assert.equal(seen.size, 4);
  }));

test("memory stays flat while models come and go", () =>
  withViewer("#demo=teapot&size=64x64", async (page) => {
    const [early, late] = await page.evaluate(async () => {
      const { demo, memory } = await import("./luxel/luxel.js");
      const sizes = [];
      for (let turn = 0; turn < 60; turn++) {
        const scene = await demo("teapot");
        const view = await scene.view({ size: [320, 240] });
        await view.render();
        await view.pick(160, 120);
        scene.dispose();
        sizes.push(await memory());
      }
      return [sizes[5], sizes[59]];
    });
    assert.ok(late <= early * 1.1, `${early} bytes, then ${late}`);
  }));

test("the page never waits: no task of 50 ms while a hand turns the model", () =>
  withViewer("", async (page) => {
    await page.evaluate(() => {
      window.long = [];
      new PerformanceObserver((list) => window.long.push(...list.getEntries().map((entry) => entry.duration))).observe({ type: "longtask" });
    });
    const [x, y] = await middle(page);
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let step = 0; step < 40; step++) await page.mouse.move(x + 3 * step, y + step);
    await page.mouse.up();
    await page.waitForTimeout(400);
    const long = await page.evaluate(() => window.long);
    // A busy machine stretches tasks; the page's own take a few milliseconds.
    assert.ok(long.length <= 2, `tasks of ${long.map(Math.round).join(", ")} ms`);
  }));

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
    const still = await page.request.get(`${site.address}/stills/light-${await figure.getAttribute("id")}.png`);
    const { data } = PNG.sync.read(await still.body());
    const digest = createHash("sha256").update(data).digest();
    assert.equal([...digest].join(), first, "the still picture is the live one");
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
      const still = await page.request.get(`${site.address}/stills/${article}-${id}-${name}.png`);
      const { data } = PNG.sync.read(await still.body());
      assert.equal([...createHash("sha256").update(data).digest()].join(), first[side], `${id}, ${name}`);
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

test("axe finds nothing serious, in dark and light, on screens and phones", async () => {
  const axe = readFileSync(join(import.meta.dirname, "../node_modules/axe-core/axe.min.js"), "utf8");
  for (const name of ["index.html", "light.html", "reflection.html", "shading.html", "navigation.html"]) {
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

const chosen = tests.filter((one) => one.name.includes(only));
let failed = 0;
for (const { name, run } of chosen) {
  const begin = Date.now();
  try {
    await run();
    console.log(`ok: ${name} (${Date.now() - begin} ms)`);
  } catch (error) {
    failed += 1;
    console.log(`FAILED: ${name}\n${error.stack}`);
  }
}
await browser.close();
site.close();
rmSync(work, { recursive: true, force: true });
console.log(`${chosen.length - failed} of ${chosen.length} tests of pages passed`);
process.exit(failed === 0 ? 0 : 1);
