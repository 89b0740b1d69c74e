// What tests of pages have in common: the site, the browser, the program, and a list of tests.

import assert from "node:assert/strict";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { launch, open, serve } from "./browser.mjs";

const [siteFolder, program, models, only = ""] = process.argv.slice(2);
if (program === undefined) {
  console.error("usage: node tests/pages.mjs SITE PROGRAM [MODELS [NAME]]");
  process.exit(2);
}
/** The folder that holds the site. */
const folder = resolve(siteFolder);
const site = await serve(folder);
const browser = await launch();
/** A folder for files of tests. */
const work = mkdtempSync(join(tmpdir(), "luxel-pages-"));
const tests = [];

/** Adds a test; its name says what would be wrong if it failed. */
function test(name, run) {
  tests.push({ name, run });
}

/** The pixels of a page's first picture, when nothing is left to draw. */
async function pixelsOf(page) {
  const text = await page.evaluate(async () => {
    await window.luxel.settled();
    const bytes = window.luxel.pixels(document.querySelector("canvas"));
    let text = "";
    for (let at = 0; at < bytes.length; at += 0x8000) text += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
    return btoa(text);
  });
  return Buffer.from(text, "base64");
}

/** Opens the viewer, and fails if anything in the page went wrong. */
async function withViewer(hash, use, options = {}) {
  const { page, faults } = await open(browser.context, `${site.address}/index.html${hash}`, options);
  try {
    await use(page);
    assert.deepEqual(faults, []);
  } finally {
    await page.close();
  }
}

/** The middle of the viewer's picture, in pixels of the page. */
async function middle(page) {
  const box = await page.locator("#canvas").boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

export { browser, folder, middle, models, only, pixelsOf, program, site, test, tests, withViewer, work };
