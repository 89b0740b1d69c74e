/** Models as files: what a page was given, or what an address leads to, with all that it refers to. */

import { LuxelError } from "./error.ts";

/** A file, bytes, an address, or several files by their paths. */
export type Source =
  | string
  | URL
  | Blob
  | ArrayBuffer
  | Uint8Array
  | Iterable<File>
  | ReadonlyMap<string, Blob | Uint8Array | ArrayBuffer>;

/** The files of a model, and which of them is the model. */
export interface ModelFiles {
  path: string;
  files: Map<string, Uint8Array<ArrayBuffer>>;
}

/** The first bytes of OpenEXR files. */
const EXR = [0x76, 0x2f, 0x31, 0x01];

const MODELS = ["glb", "gltf", "obj", "stl", "ply", "toml"];

/** The part of a name after its last point, in small letters. */
export function extension(path: string): string {
  const name = path.slice(path.lastIndexOf("/") + 1);
  return name.includes(".") ? name.slice(name.lastIndexOf(".") + 1).toLowerCase() : "";
}

/** Whether luxel reads models with such a name. */
export function isModel(path: string): boolean {
  return MODELS.includes(extension(path));
}

/** Whether luxel reads pictures of environments with such a name. */
export function isEnvironment(path: string): boolean {
  return ["hdr", "exr"].includes(extension(path));
}

/** A copy, so that the worker may take it over. */
async function bytesOf(data: Blob | Uint8Array | ArrayBuffer): Promise<Uint8Array<ArrayBuffer>> {
  if (data instanceof Blob) {
    return new Uint8Array(await data.arrayBuffer());
  }
  return new Uint8Array(data instanceof ArrayBuffer ? data.slice(0) : data);
}

/** The extension that the first bytes of a model speak for. */
function formatOf(bytes: Uint8Array): string {
  const head = new TextDecoder("latin1").decode(bytes.subarray(0, 512));
  if (head.startsWith("glTF")) return "glb";
  if (/^ply\r?\n/.test(head)) return "ply";
  if (/^\s*\{/.test(head)) return "gltf";
  if (/^\s*(#|v |o |g |mtllib )/.test(head)) return "obj";
  return "stl";
}

/** The model among several files: the only one, or the one nearest to the root. */
export function modelAmong(paths: Iterable<string>): string {
  const all = [...paths];
  const models = all.filter(isModel);
  const depth = (path: string): number => path.split("/").length;
  const order = (path: string): number => MODELS.indexOf(extension(path));
  models.sort((a, b) => depth(a) - depth(b) || order(a) - order(b) || (a < b ? -1 : 1));
  const model = models[0];
  if (model === undefined) {
    const names = all.slice(0, 3).join(", ");
    throw new LuxelError(`${names || "nothing"}: no model among these files; luxel reads ${MODELS.join(", ")}`);
  }
  return model;
}

/** The files that glTF, OBJ and MTL refer to. */
function references(path: string, bytes: Uint8Array): string[] {
  const text = (): string => new TextDecoder().decode(bytes);
  const lines = (words: string[]): string[] =>
    text()
      .split(/\r?\n/)
      .map((line) => line.trim())
      .filter((line) => words.some((word) => line.toLowerCase().startsWith(`${word} `)))
      .map((line) => line.slice(line.indexOf(" ")).trim());
  switch (extension(path)) {
    case "gltf": {
      let document: { buffers?: { uri?: string }[]; images?: { uri?: string }[] };
      try {
        document = JSON.parse(text());
      } catch {
        return [];
      }
      const uris = [...(document.buffers ?? []), ...(document.images ?? [])].map((one) => one.uri);
      return uris.filter((uri): uri is string => typeof uri === "string" && !uri.startsWith("data:"));
    }
    case "obj":
      return lines(["mtllib"]);
    case "mtl":
      return lines(["map_kd", "map_ka", "map_ks", "map_ke", "map_d", "map_bump", "bump", "norm"]).map(
        (line) => line.split(/\s+/).at(-1) ?? "",
      );
    default:
      return [];
  }
}

async function fetched(url: URL): Promise<Uint8Array<ArrayBuffer>> {
  const response = await fetch(url);
  if (!response.ok) {
    throw new LuxelError(`${url.href}: ${response.status} ${response.statusText}`);
  }
  return new Uint8Array(await response.arrayBuffer());
}

/** The last part of an address, as the name of a file. */
function nameOf(url: URL): string {
  return decodeURIComponent(url.pathname.slice(url.pathname.lastIndexOf("/") + 1));
}

/** The picture of an environment: its name, made up where there is none, and its bytes. */
export async function environmentOf(
  source: string | URL | Blob | ArrayBuffer | Uint8Array,
): Promise<[name: string, bytes: Uint8Array<ArrayBuffer>]> {
  let name = source instanceof File ? source.name : "environment";
  let bytes: Uint8Array<ArrayBuffer>;
  if (typeof source === "string" || source instanceof URL) {
    const url = new URL(source, location.href);
    name = nameOf(url);
    bytes = await fetched(url);
  } else {
    bytes = await bytesOf(source);
  }
  if (isEnvironment(name)) return [name, bytes];
  const isExr = EXR.every((byte, at) => bytes[at] === byte);
  return [`${name}.${isExr ? "exr" : "hdr"}`, bytes];
}

/** The files behind an address: the model and what it refers to in its folder. What isn't there is left out. */
async function ofAddress(address: string | URL): Promise<ModelFiles> {
  const url = new URL(address, location.href);
  const folder = new URL(".", url);
  const path = nameOf(url);
  const files = new Map([[path, await fetched(url)]]);
  const open = [path];
  for (let from = open.pop(); from !== undefined; from = open.pop()) {
    for (const reference of references(from, files.get(from)!)) {
      const target = new URL(reference, folder);
      const name = decodeURIComponent(target.pathname.slice(folder.pathname.length));
      if (!target.href.startsWith(folder.href) || files.has(name)) continue;
      try {
        files.set(name, await fetched(target));
        open.push(name);
      } catch {
        // The reader says that it is missing.
      }
    }
  }
  return { path, files };
}

/** The files of a source. */
export async function filesOf(source: Source): Promise<ModelFiles> {
  if (typeof source === "string" || source instanceof URL) {
    return ofAddress(source);
  }
  const list: [string, Blob | Uint8Array | ArrayBuffer][] = [];
  if (source instanceof Map) {
    list.push(...(source as ReadonlyMap<string, Blob | Uint8Array | ArrayBuffer>));
  } else if (source instanceof File) {
    list.push([source.name, source]);
  } else if (source instanceof Blob || source instanceof Uint8Array || source instanceof ArrayBuffer) {
    const bytes = await bytesOf(source);
    return { path: `model.${formatOf(bytes)}`, files: new Map([[`model.${formatOf(bytes)}`, bytes]]) };
  } else {
    for (const file of source as Iterable<File>) {
      list.push([file.webkitRelativePath || file.name, file]);
    }
  }
  const path = modelAmong(list.map(([name]) => name));
  const files = new Map<string, Uint8Array<ArrayBuffer>>();
  for (const [name, data] of list) {
    files.set(name, await bytesOf(data));
  }
  return { path, files };
}
