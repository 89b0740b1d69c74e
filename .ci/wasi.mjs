// wasi.mjs PROGRAM FOLDER ARGUMENTS...: runs a WebAssembly program with one folder as its world.
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

const [program, folder, ...rest] = process.argv.slice(2);
const wasi = new WASI({ version: 'preview1', args: ['luxel', ...rest], preopens: { '.': folder } });
const module = await WebAssembly.compile(await readFile(program));
const instance = await WebAssembly.instantiate(module, wasi.getImportObject());
process.exitCode = wasi.start(instance);
