// What a page fetches without models, compressed as servers do: node tests/sizes.mjs SITE.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, constants } from "node:zlib";

const site = process.argv[2];
const size = (name) => {
  const bytes = readFileSync(join(site, name));
  const quality = { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24 } };
  return brotliCompressSync(bytes, quality).length;
};
const core = size("luxel/luxel_bg.wasm");
const answers = size("luxel/answers.wasm");
const readers = size("luxel/readers_bg.wasm");
const texts = ["index.html", "style.css", "viewer.js", "luxel/luxel.js", "luxel/worker.js"];
const still = readFileSync(join(site, "stills/teapot.png")).length;
const page = texts.map(size).reduce((sum, one) => sum + one, core + answers + still);
console.log(
  `brotli: module that draws ${core} bytes, the one that answers ${answers}, readers ${readers}, the viewer with its still in all ${page}`,
);
const most = { core: 600_000, page: 1_000_000 };
if (core > most.core || page > most.page) {
  console.error(`more than ${most.core} bytes for the module, or ${most.page} for the page`);
  process.exit(1);
}
