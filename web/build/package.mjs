// The npm package: one module for pages, one script for workers, and the modules of WebAssembly beside them.

import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { build } from "esbuild";
import { common, here } from "./common.mjs";

/** Writes the package into OUT/npm; the folder of its scripts and modules. */
export async function writePackage(out) {
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
  return dist;
}
