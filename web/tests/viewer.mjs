// Tests of the viewer, with real mouse, keyboard and touch events.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { open, pixelsOfProgram } from "./browser.mjs";
import { browser, middle, models, pixelsOf, program, site, test, withViewer, work } from "./harness.mjs";

test("the first page shows the teapot and no fault", () =>
  withViewer("", async (page) => {
    const pixels = await pixelsOf(page);
    assert.ok(pixels.some((byte) => byte > 100));
    assert.equal((await page.request.get(`${site.address}/favicon.ico`)).status(), 200);
    assert.equal(await page.locator("#demo option").count() > 10, true);
  }));

/** Names of the built-in scenes. */
const DEMOS = JSON.parse(execFileSync(program, ["demos", "--json"], { encoding: "utf8" })).map((demo) => demo.name);

test("the viewer fills the window and no more, and its first picture stays", async () => {
  for (const viewport of [{ width: 1280, height: 800 }, { width: 900, height: 700 }, { width: 1280, height: 420 }]) {
    await withViewer(
      "",
      async (page) => {
        const seen = () =>
          page.evaluate(() => {
            const canvas = document.querySelector("#canvas");
            const fits = window.luxel.pixels(canvas).length === 4 * canvas.width * canvas.height;
            return [fits, canvas.width, canvas.height, document.documentElement.scrollHeight];
          });
        const first = await seen();
        await page.evaluate(() => window.luxel.settled());
        await page.waitForFunction(() => document.querySelectorAll("#lights input").length > 0);
        await page.mouse.move(...(await middle(page)));
        await page.waitForFunction(() => document.querySelectorAll("#overlay line").length > 0);
        assert.deepEqual(await seen(), first);
        assert.deepEqual([first[0], first[3]], [true, viewport.height]);
      },
      { viewport },
    );
  }
});

test("vectors begin at the pixel that they are of, in a picture that is scrolled, too", () =>
  withViewer("#demo=teapot&size=2000x1500", async (page) => {
    await page.evaluate(() => document.querySelector("#picture").scrollTo(500, 300));
    const box = await page.locator("#picture").boundingBox();
    const pointer = [box.x + 420.5, box.y + 300.5];
    await page.mouse.move(...pointer, { steps: 3 });
    await page.waitForFunction(() => document.querySelector("#status").textContent.startsWith("Pixel 920, 600"));
    const begins = await page.evaluate(() => {
      const line = document.querySelector("#overlay line");
      const toWindow = line.getScreenCTM();
      return [line.x1.baseVal.value + toWindow.e, line.y1.baseVal.value + toWindow.f];
    });
    assert.deepEqual(begins, pointer);
  }));

test("all demos have the bytes of the program", async () => {
  assert.ok(DEMOS.length > 15);
  for (const [at, name] of DEMOS.entries()) {
    const samples = ["1", "4"][at % 2];
    const flags = ["--size", "300x200", "--samples", samples];
    await withViewer(`#demo=${name}&size=300x200&samples=${samples}`, async (page) => {
      const drawn = await pixelsOf(page);
      const expected = pixelsOfProgram(program, `demo:${name}`, flags);
      assert.ok(drawn.equals(expected), `${name} has other bytes than the program's`);
    });
  }
});

/** Names of layers, as the program lists them: with NAME for that of a light. */
const LAYERS = spawnSync(program, ["render", "demo:teapot", "--layer", "?", "-o", "-"], { encoding: "utf8" })
  .stderr.match(/is not a layer: use (.*)/)[1]
  .split(/, | or /);

test("all layers have the program's values", () =>
  withViewer("#demo=teapot&size=64x64", async (page) => {
    const settings = { size: "160x120", samples: 4, shadows: true, ao: true, fog: "law=exp:density=0.1" };
    const flags = ["--size", "160x120", "--samples", "4", "--shadows", "--ao", "--fog", settings.fog];
    assert.ok(LAYERS.length > 15 && LAYERS.includes("light:NAME"), LAYERS.join());
    for (const [demo, light] of [["teapot", "key"], ["welcome", "sun"]]) {
      for (const layer of LAYERS.map((name) => name.replace("NAME", light))) {
        const [length, digest] = await page.evaluate(
          async ([name, settings, layer]) => {
            const { demo } = await import("./luxel/luxel.js");
            const scene = await demo(name);
            const view = await scene.view(settings);
            const { buffer } = (await view.layers([layer]))[layer];
            scene.dispose();
            return [buffer.byteLength, [...new Uint8Array(await crypto.subtle.digest("SHA-256", buffer))].join()];
          },
          [demo, settings, layer],
        );
        const file = join(work, "layer.npy");
        execFileSync(program, ["render", `demo:${demo}`, ...flags, "--layer", layer, "-o", file, "--quiet"]);
        const array = readFileSync(file);
        // NumPy's format, version 1: a magic number of eight bytes, the length of a header, the header.
        const values = array.subarray(10 + array.readUInt16LE(8));
        assert.equal(values.length, length, `${layer} of ${demo}`);
        assert.equal([...createHash("sha256").update(values).digest()].join(), digest, `${layer} of ${demo}`);
      }
    }
  }));

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

test("a saved picture is the program's file, byte for byte, in linear light, too", () =>
  withViewer("#demo=teapot&size=64x64", async (page) => {
    for (const settings of [{ size: "320x240" }, { size: "33x20", encoding: "none", background: "tomato" }]) {
      const file = await page.evaluate(async (settings) => {
        const { demo } = await import("./luxel/luxel.js");
        const scene = await demo("teapot");
        const view = await scene.view(settings);
        const bytes = [...new Uint8Array(await (await view.png()).arrayBuffer())];
        scene.dispose();
        return bytes;
      }, settings);
      const flags = Object.entries(settings).flatMap(([name, value]) => [`--${name}`, value]);
      const expected = execFileSync(program, ["render", "demo:teapot", ...flags, "-o", "-", "--quiet"]);
      assert.ok(expected.equals(Buffer.from(file)), JSON.stringify(settings));
    }
    const [saved] = await Promise.all([page.waitForEvent("download"), page.locator("#screenshot").click()]);
    const expected = execFileSync(program, ["render", "demo:teapot", "--size", "64x64", "-o", "-", "--quiet"]);
    assert.ok(expected.equals(readFileSync(await saved.path())), saved.suggestedFilename());
  }));

test("a picture that can't be saved says what is missing, and is saved once that is there", async () => {
  const page = await browser.context.newPage();
  let answer = (route) => route.fulfill({ status: 404 });
  await page.context().route("**/readers_bg.wasm", (route) => answer(route));
  try {
    await page.goto(`${site.address}/index.html#demo=teapot&size=64x64`);
    const saved = () =>
      page.evaluate(async () => {
        const { demo } = await import("./luxel/luxel.js");
        const scene = await demo("teapot");
        const view = await scene.view({ size: "32x32" });
        return view.png().then((file) => file.size, (error) => error.message).finally(() => scene.dispose());
      });
    assert.match(String(await saved()), /readers_bg\.wasm: 404/);
    answer = (route) => route.continue();
    assert.ok((await saved()) > 100);
  } finally {
    await page.context().unroute("**/readers_bg.wasm");
    await page.close();
  }
});

test("several workers draw the bytes of one", () =>
  withViewer("#demo=teapot&size=64x64", async (page) => {
    const isSame = await page.evaluate(async () => {
      const { configure, demo } = await import("./luxel/luxel.js");
      configure({ workers: 3 });
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
    });
    assert.deepEqual(isSame, [true, true, true, false, false]);
  }));

test("after events of which the second is unknown, pictures show what the first did", () =>
  withViewer("#demo=teapot&size=64x64", async (page) => {
    const [said, moved, drawn, before] = await page.evaluate(async () => {
      const { demo } = await import("./luxel/luxel.js");
      const scene = await demo("teapot");
      const view = await scene.view({ size: "64x64" });
      const canvas = document.createElement("canvas");
      const before = (await view.draw(canvas)).viewFromWorld;
      const said = await view.navigate(["tap", "orbit-right", 5], ["tap", "orbit", 1]).catch(String);
      const drawn = (await view.draw(canvas)).viewFromWorld;
      const moved = (await view.navigate()).viewFromWorld;
      scene.dispose();
      return [said, moved, drawn, before];
    });
    assert.match(said, /orbit/);
    assert.deepEqual(drawn, moved);
    assert.notDeepEqual(drawn, before);
  }));

test("a picture waits for no answers, and a question says why none come, until they do", async () => {
  const page = await browser.context.newPage();
  let arrives = () => {};
  const arrived = new Promise((resolve) => (arrives = resolve));
  let answer = (route) => route.fulfill({ status: 404 });
  let fetches = 0;
  await page.context().route("**/answers.wasm", async (route) => {
    fetches += 1;
    await arrived;
    await answer(route);
  });
  try {
    await page.goto(`${site.address}/index.html#demo=teapot&size=64x64`);
    const pixels = await page.evaluate(async () => {
      await window.luxel.ready;
      return window.luxel.pixels(document.querySelector("canvas")).some((byte) => byte > 100);
    });
    assert.ok(pixels, "nothing is drawn before the module that answers is there");
    arrives();
    const asked = () => page.evaluate(() => window.luxel.explain(32, 40).then((why) => why.rgba8.length, (error) => error.message));
    assert.match(String(await asked()), /answers\.wasm: 404/);
    const before = fetches;
    await page.evaluate(async () => {
      const { demo } = await import("./luxel/luxel.js");
      const scene = await demo("teapot");
      const view = await scene.view({ size: "64x64" });
      for (let frame = 0; frame < 3; frame++) await view.render();
      scene.dispose();
    });
    assert.equal(fetches, before, "each picture fetches what is missing");
    const other = await (await fetch(`${site.address}/luxel/readers_bg.wasm`)).arrayBuffer();
    answer = (route) => route.fulfill({ body: Buffer.from(other), contentType: "application/wasm" });
    assert.match(String(await asked()), /another build/);
    answer = (route) => route.continue();
    assert.equal(await asked(), 4);
  } finally {
    await page.context().unroute("**/answers.wasm");
    await page.close();
  }
});

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

test("lights move with their handles, by mouse and by keys, and the command draws what they light", () =>
  withViewer("#demo=teapot&size=320x240&samples=1&light=directional:dir=-1,-1,-2:name=sun&light=spot:pos=2,3,1:dir=-2,-3,-1:cutoff=40:name=lamp", async (page) => {
    assert.equal(await page.locator("#handles .handle").count(), 0);
    await page.check("#show-handles");
    await page.waitForFunction(() => document.querySelectorAll("#handles .handle").length === 3);
    const lights = async () => [...(await page.locator("#command").textContent()).matchAll(/--light (\S+)/g)].map(([, text]) => text);
    const settled = () => page.evaluate(() => window.luxel.settled());
    const placeOf = async (kind) => {
      const box = await page.locator(`#handles .${kind} .knob`).boundingBox();
      return [box.x + box.width / 2, box.y + box.height / 2];
    };
    let before = await pixelsOf(page);
    for (const kind of ["direction", "position", "target"]) {
      const was = await lights();
      const [x, y] = await placeOf(kind);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x - 18, y + 14, { steps: 4 });
      await page.mouse.up();
      await page.waitForFunction((was) => !document.querySelector("#command").textContent.includes(was), kind === "direction" ? was[0] : was[1]);
      await settled();
      const [nowX, nowY] = await placeOf(kind);
      // Numbers of lights are rounded to five digits.
      assert.ok(Math.abs(nowX - (x - 18)) < 1 && Math.abs(nowY - (y + 14)) < 1, `${kind}: ${[x, y]} to ${[nowX, nowY]}`);
      const now = await lights();
      assert.notEqual(now.join(), was.join());
      const drawn = await pixelsOf(page);
      assert.ok(!drawn.equals(before), `${kind} changes nothing`);
      before = drawn;
    }
    const was = await lights();
    await page.locator("#handles .position").focus();
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction((was) => !document.querySelector("#command").textContent.includes(was), was[1]);
    const line = await page.locator("#command").textContent();
    const shown = await page.inputValue("#lights input[aria-label='position x']");
    assert.ok(line.includes(`pos=${shown},`), `${line} has no x of ${shown}`);
    const flags = line.replace(/^luxel render \S+ /, "").replace(/ -o picture.png$/, "").split(" ");
    assert.ok((await pixelsOf(page)).equals(pixelsOfProgram(program, "demo:teapot", flags)));
    await page.uncheck("#show-handles");
    await page.waitForFunction(() => document.querySelectorAll("#handles .handle").length === 0);
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

/** A picture of an environment in Radiance's format: bright on one side, blue above. */
function radiance(width, height) {
  const texels = Buffer.alloc(4 * width * height);
  for (let at = 0; at < width * height; at++) {
    const [x, y] = [at % width, Math.floor(at / width)];
    texels.set([60 + 190 * (x < width / 3), 80 + y, 200 - 3 * y, 129], 4 * at);
  }
  return Buffer.concat([Buffer.from(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`), texels]);
}

test("a picture of an environment surrounds the scene, turns, and has the bytes of the program", async () => {
  const sky = join(work, "sky.hdr");
  writeFileSync(sky, radiance(64, 32));
  const flags = ["--size", "320x240", "--samples", "1", "--environment", sky];
  await withViewer("#demo=spheres&size=320x240&samples=1", async (page) => {
    const before = await pixelsOf(page);
    await page.setInputFiles("#files", sky);
    await page.waitForFunction(() => document.querySelector("#command").textContent.includes("--environment sky.hdr"));
    const surrounded = await pixelsOf(page);
    assert.ok(!surrounded.equals(before));
    assert.ok(surrounded.equals(pixelsOfProgram(program, "demo:spheres", flags)));
    const terms = await page.evaluate(() => window.luxel.explain(100, 120));
    const explained = execFileSync(program, ["explain", "demo:spheres", "--at", "100,120", "--json", ...flags]);
    assert.deepEqual(terms.samples[0].environment, JSON.parse(explained).samples[0].environment);
    await page.evaluate(() => document.querySelectorAll("details").forEach((one) => (one.open = true)));
    await page.getByLabel("turned °").last().fill("40");
    await page.getByLabel("environment behind").check();
    await page.waitForFunction(() => /--environment-rotation 40.*--environment-background|--environment-background.*--environment-rotation 40/.test(document.querySelector("#command").textContent));
    const turned = pixelsOfProgram(program, "demo:spheres", [...flags, "--environment-rotation", "40", "--environment-background"]);
    assert.ok((await pixelsOf(page)).equals(turned));
    await page.click("#link");
    assert.ok(!page.url().includes("environment"), `${page.url()} names a file`);
    await page.selectOption("label:text-is('environment') + span select", "none");
    await page.waitForFunction(() => document.querySelector("#command").textContent.includes("--environment none"));
    assert.ok(await page.getByLabel("turned °").last().isHidden(), "a plain environment turns");
    assert.ok(!(await page.locator("#command").textContent()).includes("rotation"));
    const damaged = join(work, "damaged.hdr");
    writeFileSync(damaged, radiance(64, 32).subarray(0, 300));
    await page.setInputFiles("#files", damaged);
    await page.waitForSelector("#message:not([hidden])");
    assert.match(await page.locator("#message").textContent(), /damaged\.hdr/);
    const named = await page.evaluate(async (bytes) => {
      const { demo } = await import("./luxel/luxel.js");
      const scene = await demo("teapot");
      const { name, warnings } = await scene.addEnvironment(Uint8Array.from(bytes));
      const unknown = await scene.view({ environment: "other.hdr" }).then(() => "no error", (error) => error.message);
      await scene.view({ environment: name, reflection: "mirror" });
      scene.dispose();
      return [name, warnings.length, unknown];
    }, [...radiance(16, 8)]);
    assert.deepEqual(named, ["environment.hdr", 0, "`environment`: other.hdr is a file: add it to the scene first"]);
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
    const shown = await page.locator("#message").textContent();
    assert.ok(shown.startsWith(expected), `${shown} is not ${expected}`);
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

test("a worker that runs out of memory ends with an error of its own, and another one takes its place", async () => {
  const { page } = await open(browser.context, `${site.address}/index.html#demo=teapot&size=64x64`);
  const [ended, name, drawn] = await page.evaluate(async () => {
    const { demo, memory } = await import("./luxel/luxel.js");
    const scene = await demo("teapot");
    // Three numbers for each of so many pixels are more than a module can hold.
    const view = await scene.view({ size: "16384x16384" });
    const error = await view.layers(["position"]).then(() => new Error("no error"), (error) => error);
    const dead = await view.pick(1, 1).then(() => "no error", (error) => error.name);
    const next = await demo("spheres");
    const image = await (await next.view({ size: "64x64" })).render();
    next.dispose();
    return [error.name, dead, image.data.some((byte) => byte > 0) && (await memory()) > 0];
  });
  assert.deepEqual([ended, name, drawn], ["WorkerEndedError", "WorkerEndedError", true]);
  await page.close();
});

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

test("memory stays flat while models of a million triangles come and go", () =>
  withViewer("#demo=teapot&size=64x64", async (page) => {
    const [early, late] = await page.evaluate(async () => {
      const { demo, memory } = await import("./luxel/luxel.js");
      const sizes = [];
      for (let turn = 0; turn < 15; turn++) {
        const scene = await demo("blob");
        const view = await scene.view({ size: [320, 240] });
        await view.render();
        await view.pick(160, 120);
        scene.dispose();
        sizes.push(await memory());
      }
      return [sizes[4], sizes[14]];
    });
    assert.ok(late <= early * 1.1, `${early} bytes, then ${late}`);
  }));
