// The pages: their scripts beside one copy of the package, and their texts in the frames that they share.

import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { build, transform } from "esbuild";
import { common, here } from "./common.mjs";

const ARTICLES = ["light", "reflection", "shading", "picking", "navigation"];

const source = (name) => readFileSync(join(here, "site", name), "utf8");

/** Writes all scripts, with a copy of the package's folder of scripts and modules. */
export async function writeScripts(out, dist) {
  mkdirSync(join(out, "luxel"), { recursive: true });
  cpSync(dist, join(out, "luxel"), { recursive: true, filter: (path) => !path.endsWith(".d.ts") });
  const asPage = {
    name: "luxel beside the page",
    setup(bundle) {
      bundle.onResolve({ filter: /^luxel$/ }, () => ({ path: "./luxel/luxel.js", external: true }));
    },
  };
  const entryPoints = ["viewer", ...ARTICLES].map((name) => join(here, `site/src/${name}.ts`));
  await build({ ...common, plugins: [asPage], entryPoints, outdir: out });
}

/** Writes all texts; `changes` are what figures add to those of articles. */
export async function writeTexts(out, changes) {
  cpSync(join(here, "site/favicon.svg"), join(out, "favicon.svg"));
  const { code: style } = await transform(source("style.css"), { loader: "css", minify: true });
  // The style is in the page: the first paint waits for no second file.
  const write = (name, page) => {
    const link = '<link rel="stylesheet" href="style.css">';
    if (!page.includes(link)) throw new Error(`${name} has no style`);
    writeFileSync(join(out, name), page.replace(link, () => `<style>${style.trim()}</style>`));
  };
  write("index.html", source("index.html").replace("{pages}", links()));
  for (const name of ARTICLES) {
    const text = source(`${name}.html`);
    const [, title] = /^<!-- title: (.*) -->$/m.exec(text);
    const [, description] = /^<!-- description: (.*) -->$/m.exec(text);
    const change = changes[name] ?? ((main) => main);
    const main = change(text.slice(text.indexOf("<main>")).trimEnd());
    const parts = { title, description, name, pages: links(name), main };
    write(`${name}.html`, source("article.html").replace(/\{(\w+)\}/g, (_, part) => parts[part]));
  }
}

/** The links to all articles, of which one may be the page's own. */
function links(own) {
  const items = ARTICLES.map((name) => {
    const current = name === own ? ' aria-current="page"' : "";
    return `<li><a href="${name}.html"${current}>${name[0].toUpperCase()}${name.slice(1)}</a></li>`;
  });
  return `<nav aria-label="Pages"><ul class="pages">${items.join("")}</ul></nav>`;
}
