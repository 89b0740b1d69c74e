// How large the modules of WebAssembly are, compressed as servers do: node tests/sizes.mjs SITE. A test of the pages
// adds up what each of them fetches.

import { join } from "node:path";
import { compressedSize } from "./compressed.mjs";

const site = process.argv[2];
const size = (name) => compressedSize(join(site, "luxel", name));
const core = size("luxel_bg.wasm");
console.log(
  `brotli: module that draws ${core} bytes, the one that answers ${size("answers.wasm")}, readers ${size("readers_bg.wasm")}`,
);
const most = 600_000;
if (core > most) {
  console.error(`the module that draws has more than ${most} bytes`);
  process.exit(1);
}
