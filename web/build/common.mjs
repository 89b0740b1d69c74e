// What all parts of the build have in common.

import { dirname } from "node:path";
import { fileURLToPath } from "node:url";

/** The folder `web`. */
export const here = dirname(dirname(fileURLToPath(import.meta.url)));

/** How esbuild writes scripts. */
export const common = {
  bundle: true,
  format: "esm",
  target: "es2022",
  minify: true,
  legalComments: "none",
  logLevel: "warning",
};
