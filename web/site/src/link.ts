/** The link that holds the whole view: the flags of the program after `#`. */

import type { Settings } from "luxel";

/** What a link says. */
export interface Link {
  demo: string | undefined;
  settings: Record<string, string | string[] | boolean>;
}

/** Reads what stands after `#`. */
export function readLink(hash: string): Link {
  const settings: Link["settings"] = {};
  let demo: string | undefined;
  for (const [name, value] of new URLSearchParams(hash.replace(/^#/, ""))) {
    if (name === "demo") {
      demo = value;
    } else if (name === "light") {
      const lights = settings["light"];
      settings["light"] = [...(Array.isArray(lights) ? lights : []), value];
    } else {
      settings[name] = value === "" || value === "true" ? true : value;
    }
  }
  return { demo, settings };
}

/** Writes what `readLink` reads. */
export function writeLink(demo: string | undefined, settings: Settings): string {
  const parameters = new URLSearchParams();
  if (demo !== undefined) parameters.append("demo", demo);
  for (const [name, value] of Object.entries(settings)) {
    if (value === undefined || value === null || value === false) continue;
    if (value === true) parameters.append(name, "");
    else if (Array.isArray(value) && value.some((item) => typeof item === "string")) {
      for (const item of value) parameters.append(name, String(item));
    } else if (Array.isArray(value)) parameters.append(name, value.join(name === "size" ? "x" : ","));
    else parameters.append(name, String(value));
  }
  // Signs that mean nothing in an address stay readable.
  return `#${parameters.toString().replace(/%2C/g, ",").replace(/%3A/g, ":").replace(/%3D/g, "=").replace(/%2F/g, "/")}`;
}

/** Settings without environments that are files, which a link can't hold. */
export function withoutFiles(settings: Settings, files: readonly string[]): Settings {
  if (!files.includes(String(settings["environment"]))) return settings;
  const { environment: _, "environment-rotation": __, "environment-background": ___, ...others } = settings;
  return others;
}

/** A word as a shell reads it. */
function quoted(word: string): string {
  return /^[A-Za-z0-9_.,:=/@%+-]+$/.test(word) ? word : `'${word.replace(/'/g, "'\\''")}'`;
}

/** The command that draws the same picture. */
export function command(model: string, settings: Settings): string {
  const words = ["luxel", "render", quoted(model)];
  for (const [name, value] of new URLSearchParams(writeLink(undefined, settings).slice(1))) {
    words.push(value === "" ? `--${name}` : name === "ao" ? `--ao=${value}` : `--${name} ${quoted(value)}`);
  }
  return [...words, "-o picture.png"].join(" ");
}
