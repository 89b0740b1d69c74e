// Reads modules of TypeScript that need no document.

import { join } from "node:path";
import { build } from "esbuild";
import { common, here } from "./common.mjs";

/** What a file exports. */
export async function exportsOf(file) {
  const { outputFiles } = await build({ ...common, entryPoints: [join(here, file)], write: false });
  return import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`);
}
