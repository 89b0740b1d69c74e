// Still pictures of figures, drawn by the modules that the pages fetch: shown before these arrive, without JavaScript,
// and in print.

import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import encodeWebp, { init as startWebp } from "@jsquash/webp/encode.js";
import { PNG } from "pngjs";
import { here } from "./common.mjs";
import { exportsOf } from "./typescript.mjs";

const { initSync, Model, ModelView } = await import(join(here, "package/wasm/luxel.js"));
const { linkAnswers } = await import(join(here, "package/wasm/answers.js"));
initSync({ module: readFileSync(join(here, "package/wasm/luxel_bg.wasm")) });
linkAnswers(new WebAssembly.Module(readFileSync(join(here, "package/wasm/answers.wasm"))));
const { pairs } = await exportsOf("package/src/settings.ts");

/** The pixels that `draw` gives of a view, as a picture. */
function pictureOf(demo, settings, draw) {
  const view = ModelView.of(Model.demo(demo), JSON.stringify(pairs(settings)));
  const picture = new PNG({ width: view.width, height: view.height });
  picture.data.set(draw(view));
  view.free();
  return picture;
}

/** The picture of a built-in scene with these settings. */
const drawn = (demo, settings) => pictureOf(demo, settings, (view) => view.draw(0));

/** Still pictures, until they are written. */
export class Stills {
  #pictures = new Map();
  /** What they show, and where in them: tests draw the same with the program. */
  #shown = [];

  #keep(name, picture) {
    const file = `stills/${name}.webp`;
    this.#pictures.set(file, picture);
    return file;
  }

  /** A scene's picture; its address. */
  add(name, demo, settings) {
    this.#shown.push({ name, demo, pairs: pairs(settings), at: [0, 0] });
    return this.#keep(name, drawn(demo, settings));
  }

  /** The picture of a scene's ids, as a page shows it; its address. */
  addIds(name, demo, settings) {
    this.#shown.push({ name, demo, pairs: [...pairs(settings), ["layer", "object"]], at: [0, 0] });
    return this.#keep(name, pictureOf(demo, settings, (view) => view.layer_picture("object")));
  }

  /** Rows of pictures of one size as one picture, which takes little more than half the bytes of one for each. */
  addTable(name, demo, [width, height], rows) {
    const table = new PNG({ width: width * rows[0].length, height: height * rows.length });
    for (const [row, columns] of rows.entries()) {
      for (const [column, settings] of columns.entries()) {
        const all = { size: [width, height], ...settings };
        const [x, y] = [column * width, row * height];
        PNG.bitblt(drawn(demo, all), table, 0, 0, width, height, x, y);
        this.#shown.push({ name, demo, pairs: pairs(all), at: [x, y] });
      }
    }
    return this.#keep(name, table);
  }

  /** Writes all of them into OUT/stills, and `stills.json`, the list for tests. */
  async write(out) {
    rmSync(join(out, "stills"), { recursive: true, force: true });
    mkdirSync(join(out, "stills"));
    const encoder = join(here, "node_modules/@jsquash/webp/codec/enc/webp_enc_simd.wasm");
    await startWebp(new WebAssembly.Module(readFileSync(encoder)));
    for (const [file, picture] of this.#pictures) {
      // WebP without loss takes about two thirds of PNG's bytes; `exact` keeps the colours of transparent pixels, too.
      writeFileSync(join(out, file), Buffer.from(await encodeWebp(picture, { lossless: 1, exact: 1 })));
    }
    writeFileSync(join(here, "stills.json"), JSON.stringify(this.#shown));
  }
}

/** The icon that browsers ask for, whatever a page says: a PNG picture in the container of ICO files. */
export function icon() {
  const png = PNG.sync.write(drawn("spheres", { size: "32x32", samples: 16 }));
  const container = Buffer.alloc(22);
  container.writeUInt16LE(1, 2);
  container.writeUInt16LE(1, 4);
  container.writeUInt8(32, 6);
  container.writeUInt8(32, 7);
  container.writeUInt16LE(1, 10);
  container.writeUInt16LE(32, 12);
  container.writeUInt32LE(png.length, 14);
  container.writeUInt32LE(22, 18);
  return Buffer.concat([container, png]);
}
