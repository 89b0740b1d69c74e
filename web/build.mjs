// Builds the npm package and the pages: node build.mjs OUT. `package/wasm` holds the modules with their bindings.

import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import encodeWebp, { init as startWebp } from "@jsquash/webp/encode.js";
import { build, transform } from "esbuild";
import { PNG } from "pngjs";

const here = dirname(fileURLToPath(import.meta.url));
const out = resolve(process.argv[2] ?? "");
if (process.argv.length !== 3) {
  console.error("usage: node build.mjs OUT");
  process.exit(2);
}
const common = { bundle: true, format: "esm", target: "es2022", minify: true, legalComments: "none", logLevel: "warning" };

// The package: one module for pages, one script for workers, and the modules of WebAssembly beside them.
const npm = join(out, "npm");
const dist = join(npm, "dist");
rmSync(npm, { recursive: true, force: true });
mkdirSync(dist, { recursive: true });
await build({ ...common, entryPoints: [join(here, "package/src/index.ts")], outfile: join(dist, "luxel.js") });
await build({ ...common, entryPoints: [join(here, "package/src/worker.ts")], outfile: join(dist, "worker.js") });
for (const name of ["luxel_bg.wasm", "answers.wasm", "readers_bg.wasm"]) {
  cpSync(join(here, "package/wasm", name), join(dist, name));
}
execFileSync(process.execPath, [join(here, "node_modules/typescript/bin/tsc"), "-p", join(here, "package"), "--outDir", dist], {
  stdio: "inherit",
});
const version = /^version = "(.*)"/m.exec(readFileSync(join(here, "../Cargo.toml"), "utf8"))[1];
const manifest = JSON.parse(readFileSync(join(here, "package/package.json"), "utf8"));
writeFileSync(join(npm, "package.json"), `${JSON.stringify({ ...manifest, version }, null, 2)}\n`);
cpSync(join(here, "package/README.md"), join(npm, "README.md"));
if (existsSync(join(here, "NOTICES.md"))) cpSync(join(here, "NOTICES.md"), join(npm, "NOTICES.md"));
for (const licence of ["LICENSE-APACHE", "LICENSE-MIT"]) {
  cpSync(join(here, "..", licence), join(npm, licence));
}

// The pages, which share one copy of the package.
const asPage = {
  name: "luxel beside the page",
  setup(bundle) {
    bundle.onResolve({ filter: /^luxel$/ }, () => ({ path: "./luxel/luxel.js", external: true }));
  },
};
mkdirSync(join(out, "luxel"), { recursive: true });
cpSync(dist, join(out, "luxel"), { recursive: true, filter: (path) => !path.endsWith(".d.ts") });
const articles = ["light", "reflection", "shading", "picking", "navigation"];
const entries = ["viewer", ...articles].map((name) => join(here, `site/src/${name}.ts`));
await build({ ...common, plugins: [asPage], entryPoints: entries, outdir: out });
cpSync(join(here, "site/favicon.svg"), join(out, "favicon.svg"));

/** The links to all articles, of which one may be the page's own. */
const links = (own) => {
  const items = articles.map((name) => {
    const current = name === own ? ' aria-current="page"' : "";
    return `<li><a href="${name}.html"${current}>${name[0].toUpperCase()}${name.slice(1)}</a></li>`;
  });
  return `<nav aria-label="Pages"><ul class="pages">${items.join("")}</ul></nav>`;
};
const source = (name) => readFileSync(join(here, "site", name), "utf8");
const { code: style } = await transform(source("style.css"), { loader: "css", minify: true });
/** Writes a page with its style in it: the first paint waits for no second file. */
const writePage = (name, page) => {
  const link = '<link rel="stylesheet" href="style.css">';
  if (!page.includes(link)) throw new Error(`${name} has no style`);
  writeFileSync(join(out, name), page.replace(link, () => `<style>${style.trim()}</style>`));
};
writePage("index.html", source("index.html").replace("{pages}", links()));
/** Writes an article: its text, with what figures add to it, in the frame that all have. */
const writeArticle = (name, change = (text) => text) => {
  const text = source(`${name}.html`);
  const [, title] = /^<!-- title: (.*) -->$/m.exec(text);
  const [, description] = /^<!-- description: (.*) -->$/m.exec(text);
  const main = change(text.slice(text.indexOf("<main>")).trimEnd());
  const parts = { title, description, name, pages: links(name), main };
  const page = source("article.html").replace(/\{(\w+)\}/g, (_, part) => parts[part]);
  writePage(`${name}.html`, page);
};

// Still pictures, drawn by the same modules: shown before they arrive, without JavaScript, and in print.
const { initSync, Model, ModelView } = await import(join(here, "package/wasm/luxel.js"));
const { linkAnswers } = await import(join(here, "package/wasm/answers.js"));
initSync({ module: readFileSync(join(here, "package/wasm/luxel_bg.wasm")) });
linkAnswers(new WebAssembly.Module(readFileSync(join(here, "package/wasm/answers.wasm"))));
rmSync(join(out, "stills"), { recursive: true, force: true });
mkdirSync(join(out, "stills"));
/** What a file of TypeScript exports that needs no document. */
const exportsOf = async (file) => {
  const { outputFiles } = await build({ ...common, entryPoints: [join(here, file)], write: false });
  return import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`);
};
const { pairs } = await exportsOf("package/src/settings.ts");
/** All still pictures by their files. */
const stills = new Map();
/** What they show, and where in them: tests draw the same with the program. */
const shown = [];
/** Keeps a still picture to be written; gives its address. */
const kept = (name, picture) => {
  const file = `stills/${name}.webp`;
  stills.set(file, picture);
  return file;
};
const pictureOf = (width, height, pixels) => {
  const picture = new PNG({ width, height });
  picture.data.set(pixels);
  return picture;
};
const drawn = (demo, settings) => {
  const view = ModelView.of(Model.demo(demo), JSON.stringify(pairs(settings)));
  const picture = pictureOf(view.width, view.height, view.draw(0));
  view.free();
  return picture;
};
const still = (name, demo, settings) => {
  shown.push({ name, demo, pairs: pairs(settings), at: [0, 0] });
  return kept(name, drawn(demo, settings));
};
still("teapot", "teapot", { size: "960x540" });
const light = await exportsOf("site/src/figures/light.ts");
/** The picture of ids, as a page shows it. */
const drawnIds = (demo, [width, height]) => {
  const view = ModelView.of(Model.demo(demo), JSON.stringify([["size", `${width}x${height}`]]));
  const picture = pictureOf(width, height, view.layer_picture("object"));
  view.free();
  return picture;
};
for (const figure of light.FIGURES) {
  still(`light-${figure.id}`, figure.demo, light.firstSettings(figure));
}

const navigation = await exportsOf("site/src/figures/navigation.ts");
still("navigation-look-at", "welcome", navigation.firstSettings(navigation.FIGURES[0]));
still("picking-ray", "plane", { size: [640, 400] });
kept("picking-ids", drawnIds("plane", [640, 400]));
still("navigation-modes", "welcome", { size: [640, 400] });
still("navigation-rolling-ball", "teapot", { size: [640, 400] });

// Of a comparison the page has a line, `<!-- figure: ID: CAPTION -->`; the rest is in its data.
const withComparisons = (page, name, comparisons, firstSettings) => {
  for (const figure of comparisons) {
    const [width, height] = figure.size;
    const pictures = firstSettings(figure).map(({ demo, settings }, at) => {
      const file = still(`${name}-${figure.id}-${["problem", "cure"][at]}`, demo, settings);
      const { alt } = [figure.problem, figure.cure][at];
      return `<img src="${file}" width="${width}" height="${height}" loading="lazy" alt="${alt}">`;
    });
    const line = new RegExp(`<!-- figure: ${figure.id}: (.*) -->`);
    const [, caption] = line.exec(page);
    page = page.replace(
      line,
      `<figure class="live" id="${figure.id}">\n<div class="stills">${pictures.join("")}</div>\n<figcaption>${caption}</figcaption>\n</figure>`,
    );
  }
  if (page.includes("<!-- figure")) throw new Error(`a figure of ${name}.html has no data`);
  return page;
};
for (const name of ["light", "picking", "navigation"]) writeArticle(name);

const shading = await exportsOf("site/src/figures/shading.ts");
writeArticle("shading", (text) => withComparisons(text, "shading", shading.FIGURES, shading.firstSettings));

const reflection = await exportsOf("site/src/figures/reflection.ts");
const [vectors] = reflection.VECTORS;
still("reflection-vectors", vectors.demo, reflection.firstSettings(vectors));
const { TABLE } = reflection;
// All balls are one picture, which takes little more than half the bytes of one for each.
const [ballWidth, ballHeight] = TABLE.size;
const balls = new PNG({ width: ballWidth * TABLE.n.length, height: ballHeight * TABLE.ks.length });
const ballsFile = kept("reflection-table", balls);
const cell = (ks, n) => {
  const settings = { size: TABLE.size, ...TABLE.settings(ks, n, TABLE.about.value) };
  const [x, y] = [TABLE.n.indexOf(n) * ballWidth, TABLE.ks.indexOf(ks) * ballHeight];
  PNG.bitblt(drawn(TABLE.demo, settings), balls, 0, 0, ballWidth, ballHeight, x, y);
  shown.push({ name: "reflection-table", demo: TABLE.demo, pairs: pairs(settings), at: [x, y] });
  const place = `width="${ballWidth}" height="${ballHeight}" style="object-position: ${-x}px ${-y}px"`;
  return `<td><img src="${ballsFile}" ${place} loading="lazy" alt="A ball with k_s = ${ks} and n = ${n}"></td>`;
};
const head = `<tr><th scope="col">k<sub>s</sub> \\ n</th>${TABLE.n.map((n) => `<th scope="col">${n}</th>`).join("")}</tr>`;
const rows = TABLE.ks.map((ks) => `<tr><th scope="row">${ks}</th>${TABLE.n.map((n) => cell(ks, n)).join("")}</tr>`);
const table = `<div class="scroll" tabindex="0" role="group" aria-label="The table of shininess"><table>${head}${rows.join("")}</table></div>`;
writeArticle("reflection", (text) => {
  const page = withComparisons(text, "reflection", reflection.COMPARISONS, reflection.firstOfComparison);
  return page.replace("<!-- table -->", table);
});

// WebP without loss takes about two thirds of PNG's bytes; `exact` keeps the colours of transparent pixels, too.
await startWebp(new WebAssembly.Module(readFileSync(join(here, "node_modules/@jsquash/webp/codec/enc/webp_enc_simd.wasm"))));
for (const [file, picture] of stills) {
  writeFileSync(join(out, file), Buffer.from(await encodeWebp(picture, { lossless: 1, exact: 1 })));
}
writeFileSync(join(here, "stills.json"), JSON.stringify(shown));

// A browser asks for an icon of this name, whatever the page says: a PNG picture in the container of ICO files.
const icon = PNG.sync.write(drawn("spheres", { size: "32x32", samples: 16 }));
const container = Buffer.alloc(22);
container.writeUInt16LE(1, 2);
container.writeUInt16LE(1, 4);
container.writeUInt8(32, 6);
container.writeUInt8(32, 7);
container.writeUInt16LE(1, 10);
container.writeUInt16LE(32, 12);
container.writeUInt32LE(icon.length, 14);
container.writeUInt32LE(22, 18);
writeFileSync(join(out, "favicon.ico"), Buffer.concat([container, icon]));
