// Frames of luxel in a page beside three.js on SwiftShader and beside the program, in turns:
//
//     node frames.mjs SITE THREE PROGRAM [TURNS]
//
// SITE is the folder that `packaging/web` makes, THREE the folder of the npm package `three`, PROGRAM luxel's program,
// which has one thread and vectors as wide as a page's (SSE4.2); web/node_modules has what
// drives the browser (`npm ci` there). All draw the same mesh of 1 020 and of 99 904 triangles in 1280x720, one sample a
// pixel, Blinn-Phong per pixel under one directional light and ambient light, both sides of each triangle. luxel has one
// worker, and then two; three.js has all threads of SwiftShader, and waits for each picture by reading one of its pixels.
// Each has a browser of its own: luxel's without a GPU, three.js's with SwiftShader in the place of one.
// Prints medians in milliseconds as JSON.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { launch, serve } from "../../../web/tests/browser.mjs";

const [folder, three, program, turns = "3"] = process.argv.slice(2);
const SWIFTSHADER = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"];
const VIEWER = "index.html#demo=teapot&size=64x64";
const FRAMES = 30;
/** Frames before those, of both: workers begin with code from the compiler that is quick to compile. */
const WARM_UP = 40;
const PEER = `<!doctype html><canvas id="c" width="1280" height="720"></canvas>
<script type="importmap">{"imports": {"three": "/three/build/three.module.js"}}</script>`;

/** A ball with bumps: rings and segments of a sphere, moved along the radius. Runs in the page. */
function bumpyBall([rings, segments]) {
  const places = [];
  const triangles = [];
  const put = (polar, around) => {
    const [x, y, z] = [Math.sin(polar) * Math.cos(around), Math.cos(polar), Math.sin(polar) * Math.sin(around)];
    const radius = 0.8 + 0.08 * Math.sin(5 * x + 3 * y) + 0.05 * Math.sin(11 * z - 7 * x) + 0.02 * Math.sin(23 * y + 19 * z);
    places.push(radius * x, radius * y, radius * z);
  };
  put(0, 0);
  for (let ring = 1; ring < rings; ring++) {
    for (let at = 0; at < segments; at++) put((Math.PI * ring) / rings, (2 * Math.PI * at) / segments);
  }
  put(Math.PI, 0);
  const place = (ring, at) => 1 + (ring - 1) * segments + (at % segments);
  const last = 1 + (rings - 1) * segments;
  for (let at = 0; at < segments; at++) {
    triangles.push(0, place(1, at + 1), place(1, at));
    for (let ring = 1; ring < rings - 1; ring++) {
      triangles.push(place(ring, at), place(ring, at + 1), place(ring + 1, at));
      triangles.push(place(ring, at + 1), place(ring + 1, at + 1), place(ring + 1, at));
    }
    triangles.push(place(rings - 1, at), place(rings - 1, at + 1), last);
  }
  return { places, triangles };
}

/** A mesh as an OBJ file. */
function objOf({ places, triangles }) {
  const lines = (of) => Array.from({ length: of.length / 3 }, (_, at) => of.slice(3 * at, 3 * at + 3));
  return [
    ...lines(places).map((place) => `v ${place.join(" ")}`),
    ...lines(triangles).map((triangle) => `f ${triangle.map((corner) => corner + 1).join(" ")}`),
  ].join("\n");
}

const SETTINGS = {
  size: "1280x720", samples: 1, eye: "0,0,3", target: "0,0,0", fov: 45, reflection: "blinn-phong",
  light: "directional:dir=-.4,-.6,-1", ambient: ".3,.3,.3",
};

function framesOfProgram(model) {
  const flags = Object.entries(SETTINGS).flatMap(([name, value]) => [`--${name}`, String(value)]);
  flags.push("--threads", "1", "--simd", "sse4.2", "--frames", String(FRAMES), "--json");
  return JSON.parse(execFileSync(program, ["bench", model, ...flags], { encoding: "utf8" })).frame_ms.median;
}

async function framesOfLuxel(text, settings, workers, before, frames) {
  const { configure, load } = await import("./luxel/luxel.js");
  configure({ workers });
  const scene = await load(new File([text], "ball.obj"));
  const view = await scene.view(settings);
  await view.ready();
  const canvas = document.createElement("canvas");
  const times = [];
  for (let frame = 0; frame < before + frames; frame++) {
    await view.navigate(["tap", "orbit-right", 0.02]);
    const begin = performance.now();
    await view.draw(canvas, { workers });
    times.push(performance.now() - begin);
  }
  scene.dispose();
  return times.slice(before);
}

async function framesOfThree({ places, triangles }, before, frames) {
  const T = await import("three");
  const geometry = new T.BufferGeometry();
  geometry.setAttribute("position", new T.BufferAttribute(new Float32Array(places), 3));
  geometry.setIndex(new T.BufferAttribute(new Uint32Array(triangles), 1));
  geometry.computeVertexNormals();
  const canvas = document.getElementById("c");
  const renderer = new T.WebGLRenderer({ canvas, antialias: false, preserveDrawingBuffer: true });
  renderer.setSize(1280, 720, false);
  const scene = new T.Scene();
  const material = { color: 0xccb399, specular: 0x666666, shininess: 32, side: T.DoubleSide };
  scene.add(new T.Mesh(geometry, new T.MeshPhongMaterial(material)));
  scene.add(new T.AmbientLight(0xffffff, 0.3));
  const light = new T.DirectionalLight(0xffffff, 2);
  light.position.set(0.4, 0.6, 1);
  scene.add(light);
  const camera = new T.PerspectiveCamera(45, 1280 / 720, 0.1, 10);
  camera.position.z = 3;
  const gl = renderer.getContext();
  const pixel = new Uint8Array(4);
  const times = [];
  for (let frame = 0; frame < before + frames; frame++) {
    scene.rotation.y += 0.01;
    const begin = performance.now();
    renderer.render(scene, camera);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    times.push(performance.now() - begin);
  }
  return times.slice(before);
}

const site = await serve(resolve(folder));
const browser = await launch();
const peers = await launch(SWIFTSHADER);
await peers.context.route(`${site.address}/peer.html`, (route) => route.fulfill({ contentType: "text/html", body: PEER }));
await peers.context.route(`${site.address}/three/**`, (route) => {
  const path = new URL(route.request().url()).pathname.slice("/three/".length);
  return route.fulfill({ contentType: "text/javascript", body: readFileSync(join(three, path)) });
});

async function times({ context }, address, work, ...inputs) {
  const page = await context.newPage();
  await page.goto(`${site.address}/${address}`);
  const all = await page.evaluate(`(${work})(...${JSON.stringify(inputs)})`);
  await page.close();
  return all;
}

const median = (values) => Number([...values].sort((a, b) => a - b)[Math.floor(values.length / 2)].toFixed(2));
const results = {};
const work = mkdtempSync(join(tmpdir(), "luxel-frames-"));
for (const shape of [[16, 34], [224, 224]]) {
  const ball = bumpyBall(shape);
  const text = objOf(ball);
  const model = join(work, "ball.obj");
  writeFileSync(model, text);
  const [one, two, peer, native] = [[], [], [], []];
  for (let turn = 0; turn < Number(turns); turn++) {
    peer.push(...(await times(peers, "peer.html", framesOfThree, ball, WARM_UP, FRAMES)));
    one.push(...(await times(browser, VIEWER, framesOfLuxel, text, SETTINGS, 1, WARM_UP, FRAMES)));
    two.push(...(await times(browser, VIEWER, framesOfLuxel, text, SETTINGS, 2, WARM_UP, FRAMES)));
    native.push(framesOfProgram(model));
  }
  const [a, b, c, d] = [one, two, peer, native].map(median);
  const ratio = (more, less) => Number((more / less).toFixed(2));
  results[`${ball.triangles.length / 3} triangles`] = {
    luxel_one_worker: a, luxel_two_workers: b, three: c, program: d,
    three_to_one_worker: ratio(c, a), two_workers_to_one: ratio(a, b), one_worker_to_program: ratio(a, d),
  };
}
console.log(JSON.stringify(results, null, 2));
await browser.close();
await peers.close();
rmSync(work, { recursive: true });
site.close();
