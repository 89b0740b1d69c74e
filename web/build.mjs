// Builds the npm package and the pages: node build.mjs OUT. `package/wasm` holds the modules with their bindings.

import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
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
for (const name of ["style.css", "favicon.svg"]) {
  cpSync(join(here, "site", name), join(out, name));
}

/** The links to all articles, of which one may be the page's own. */
const links = (own) => {
  const items = articles.map((name) => {
    const current = name === own ? ' aria-current="page"' : "";
    return `<li><a href="${name}.html"${current}>${name[0].toUpperCase()}${name.slice(1)}</a></li>`;
  });
  return `<nav aria-label="Pages"><ul class="pages">${items.join("")}</ul></nav>`;
};
const source = (name) => readFileSync(join(here, "site", name), "utf8");
writeFileSync(join(out, "index.html"), source("index.html").replace("{pages}", links()));
/** Writes an article: its text, with what figures add to it, in the frame that all have. */
const writeArticle = (name, change = (text) => text) => {
  const text = source(`${name}.html`);
  const [, title] = /^<!-- title: (.*) -->$/m.exec(text);
  const [, description] = /^<!-- description: (.*) -->$/m.exec(text);
  const main = change(text.slice(text.indexOf("<main>")).trimEnd());
  const parts = { title, description, name, pages: links(name), main };
  const page = source("article.html").replace(/\{(\w+)\}/g, (_, part) => parts[part]);
  writeFileSync(join(out, `${name}.html`), page);
};

// Still pictures, drawn by the same modules: shown before they arrive, without JavaScript, and in print.
const { initSync, Model, ModelView } = await import(join(here, "package/wasm/luxel.js"));
const { linkAnswers } = await import(join(here, "package/wasm/answers.js"));
initSync({ module: readFileSync(join(here, "package/wasm/luxel_bg.wasm")) });
linkAnswers(new WebAssembly.Module(readFileSync(join(here, "package/wasm/answers.wasm"))));
mkdirSync(join(out, "stills"), { recursive: true });
/** What a file of TypeScript exports that needs no document. */
const exportsOf = async (file) => {
  const { outputFiles } = await build({ ...common, entryPoints: [join(here, file)], write: false });
  return import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`);
};
const { pairs } = await exportsOf("package/src/settings.ts");
/** A picture as a small file: it is written once and fetched often. */
const compressed = (picture) => {
  const isOpaque = picture.data.every((byte, at) => at % 4 !== 3 || byte === 255);
  // Colour types of PNG: 2 without alpha, 6 with it.
  return PNG.sync.write(picture, { colorType: isOpaque ? 2 : 6, deflateLevel: 9, deflateStrategy: 0, filterType: -1 });
};
const still = (demo, settings) => {
  const view = ModelView.of(Model.demo(demo), JSON.stringify(pairs(settings)));
  const picture = PNG.sync.read(Buffer.from(view.png()));
  view.free();
  return compressed(picture);
};
writeFileSync(join(out, "stills/teapot.png"), still("teapot", { size: "960x540" }));
const light = await exportsOf("site/src/figures/light.ts");
/** The picture of ids, as a page shows it. */
const stillOfIds = (demo, [width, height]) => {
  const view = ModelView.of(Model.demo(demo), JSON.stringify([["size", `${width}x${height}`]]));
  const picture = new PNG({ width, height });
  picture.data.set(view.layer_picture("object"));
  view.free();
  return compressed(picture);
};
for (const figure of light.FIGURES) {
  writeFileSync(join(out, `stills/light-${figure.id}.png`), still(figure.demo, light.firstSettings(figure)));
}

const navigation = await exportsOf("site/src/figures/navigation.ts");
writeFileSync(join(out, "stills/navigation-look-at.png"), still("welcome", navigation.firstSettings(navigation.FIGURES[0])));
writeFileSync(join(out, "stills/picking-ray.png"), still("plane", { size: [640, 400] }));
writeFileSync(join(out, "stills/picking-ids.png"), stillOfIds("plane", [640, 400]));
writeFileSync(join(out, "stills/navigation-modes.png"), still("welcome", { size: [640, 400] }));
writeFileSync(join(out, "stills/navigation-rolling-ball.png"), still("teapot", { size: [640, 400] }));

// Of a comparison the page has a line, `<!-- figure: ID: CAPTION -->`; the rest is in its data.
const withComparisons = (page, name, comparisons, firstSettings) => {
  for (const figure of comparisons) {
    const [width, height] = figure.size;
    const pictures = firstSettings(figure).map(({ demo, settings }, at) => {
      const file = `stills/${name}-${figure.id}-${["problem", "cure"][at]}.png`;
      writeFileSync(join(out, file), still(demo, settings));
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
writeFileSync(join(out, "stills/reflection-vectors.png"), still(vectors.demo, reflection.firstSettings(vectors)));
const { TABLE } = reflection;
const cell = (ks, n) => {
  const file = `stills/reflection-table-${ks}-${n}.png`;
  const settings = { size: TABLE.size, ...TABLE.settings(ks, n, TABLE.about.value) };
  writeFileSync(join(out, file), still(TABLE.demo, settings));
  return `<td><img src="${file}" width="104" height="104" loading="lazy" alt="A ball with k_s = ${ks} and n = ${n}"></td>`;
};
const head = `<tr><th scope="col">k<sub>s</sub> \\ n</th>${TABLE.n.map((n) => `<th scope="col">${n}</th>`).join("")}</tr>`;
const rows = TABLE.ks.map((ks) => `<tr><th scope="row">${ks}</th>${TABLE.n.map((n) => cell(ks, n)).join("")}</tr>`);
const table = `<div class="scroll" tabindex="0" role="group" aria-label="The table of shininess"><table>${head}${rows.join("")}</table></div>`;
writeArticle("reflection", (text) => {
  const page = withComparisons(text, "reflection", reflection.COMPARISONS, reflection.firstOfComparison);
  return page.replace("<!-- table -->", table);
});

// A browser asks for an icon of this name, whatever the page says: a PNG picture in the container of ICO files.
const icon = still("spheres", { size: "32x32", samples: 16 });
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
