// Builds the npm package and the pages: node build.mjs OUT. `package/wasm` holds the modules with their bindings.

import { writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { addFigures } from "./build/figures.mjs";
import { writePackage } from "./build/package.mjs";
import { writeScripts, writeTexts } from "./build/pages.mjs";
import { Stills, icon } from "./build/stills.mjs";

if (process.argv.length !== 3) {
  console.error("usage: node build.mjs OUT");
  process.exit(2);
}
const out = resolve(process.argv[2]);
const dist = await writePackage(out);
await writeScripts(out, dist);
const stills = new Stills();
// The texts come first: some stills are added with them.
await writeTexts(out, await addFigures(stills));
await stills.write(out);
writeFileSync(join(out, "favicon.ico"), icon());
