// Uses the npm package as a stranger would: node tests/package.mjs PACKAGE TOOLS.
//
// Packs it, installs the archive into an empty folder, checks its types against a program, and bundles that program.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { build } from "esbuild";

const [packageFolder, tools] = process.argv.slice(2).map((path) => resolve(path));
const folder = mkdtempSync(join(tmpdir(), "luxel-package-"));
const run = (command, parameters) => execFileSync(command, parameters, { cwd: folder, encoding: "utf8" });
try {
  const archive = run("npm", ["pack", "--silent", packageFolder]).trim().split("\n").at(-1);
  writeFileSync(join(folder, "package.json"), '{ "private": true, "type": "module" }\n');
  run("npm", ["install", "--silent", "--offline", `./${archive}`]);
  for (const file of ["luxel.js", "worker.js", "luxel_bg.wasm", "answers.wasm", "readers_bg.wasm", "index.d.ts"]) {
    assert.ok(existsSync(join(folder, "node_modules/luxel/dist", file)), file);
  }
  // The lines of the README, and types that must not pass.
  const readme = readFileSync(join(packageFolder, "README.md"), "utf8");
  const lines = /```js\n([\s\S]*?)```/.exec(readme)[1].replace('document.querySelector("canvas")', 'document.querySelector("canvas")!');
  writeFileSync(join(folder, "page.ts"), lines);
  writeFileSync(join(folder, "wrong.ts"), 'import { load } from "luxel";\n// @ts-expect-error A source is never a number.\nvoid load(3);\n');
  const compiler = ["--noEmit", "--strict", "--target", "es2022", "--module", "esnext", "--moduleResolution", "bundler"];
  const libraries = ["--lib", "es2022,esnext.disposable,dom,dom.iterable", "--types", ""];
  run(process.execPath, [join(tools, "node_modules/typescript/bin/tsc"), ...compiler, ...libraries, "page.ts", "wrong.ts"]);
  await build({ entryPoints: [join(folder, "page.ts")], bundle: true, format: "esm", outfile: join(folder, "page.js"), logLevel: "error" });
  console.log("the package installs, has types, and its README's lines bundle");
} finally {
  rmSync(folder, { recursive: true, force: true });
}
