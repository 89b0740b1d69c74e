// How many bytes files take as servers send them.

import { readFileSync } from "node:fs";
import { brotliCompressSync, constants } from "node:zlib";

const COMPRESSED_BY_THEMSELVES = /\.(png|webp|ico)$/;

/** The bytes of a file: texts and modules by brotli at its best quality, pictures as they are. */
export function compressedSize(path) {
  const bytes = readFileSync(path);
  if (COMPRESSED_BY_THEMSELVES.test(path)) return bytes.length;
  const quality = { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24 } };
  return brotliCompressSync(bytes, quality).length;
}
