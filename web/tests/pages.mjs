// Drives the pages in a browser: node tests/pages.mjs SITE PROGRAM [MODELS [NAME]].
//
// PROGRAM is the native `luxel`, whose pictures and answers the pages must equal. With NAME only tests run
// whose names contain it.

import { rmSync } from "node:fs";
import { browser, only, site, tests, work } from "./harness.mjs";

await import("./viewer.mjs");
await import("./articles.mjs");

const chosen = tests.filter((one) => one.name.includes(only));
let failed = 0;
for (const { name, run } of chosen) {
  const begin = Date.now();
  try {
    await run();
    console.log(`ok: ${name} (${Date.now() - begin} ms)`);
  } catch (error) {
    failed += 1;
    console.log(`FAILED: ${name}\n${error.stack}`);
  }
}
await browser.close();
site.close();
rmSync(work, { recursive: true, force: true });
console.log(`${chosen.length - failed} of ${chosen.length} tests of pages passed`);
process.exit(failed === 0 ? 0 : 1);
