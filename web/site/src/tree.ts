/** The objects of a scene, with eyes and a search. */

import type { Description } from "luxel";
import { element } from "./dom.ts";

/** A page with more rows answers slowly. */
const MOST_ROWS = 500;

/** The list of objects. */
export class Tree {
  readonly #list: HTMLElement;
  readonly #search: HTMLInputElement;
  readonly #hidden = new Set<number>();
  #objects: Description["objects"] = [];
  #current: number | undefined;
  readonly #changed: (hidden: number[]) => void;

  constructor(list: HTMLElement, search: HTMLInputElement, changed: (hidden: number[]) => void) {
    this.#list = list;
    this.#search = search;
    this.#changed = changed;
    search.addEventListener("input", () => this.#show());
  }

  /** Shows the objects of another scene. */
  set(objects: Description["objects"]): void {
    this.#objects = objects;
    this.#hidden.clear();
    this.#current = undefined;
    this.#search.value = "";
    this.#search.hidden = objects.length < 12;
    this.#show();
  }

  /** Marks an object. */
  mark(object: number | undefined): void {
    if (object === this.#current) return;
    this.#current = object;
    for (const row of this.#list.children) {
      row.classList.toggle("current", (row as HTMLElement).dataset["object"] === String(object));
    }
  }

  #show(): void {
    const sought = this.#search.value.trim().toLowerCase();
    const rows: HTMLElement[] = [];
    let found = 0;
    this.#objects.forEach(({ name, path, triangles }, at) => {
      const whole = path.join(" / ") || name;
      if (!whole.toLowerCase().includes(sought) || ++found > MOST_ROWS) return;
      const box = element("input", { type: "checkbox" });
      box.checked = !this.#hidden.has(at);
      box.addEventListener("change", () => {
        if (box.checked) this.#hidden.delete(at);
        else this.#hidden.add(at);
        this.#changed([...this.#hidden]);
      });
      const label = element("label", { title: whole }, box, name || `object ${at}`);
      const count = element("span", { class: "num", title: "triangles" }, triangles.toLocaleString("en"));
      const row = element("li", { "data-object": String(at) }, label, count);
      row.classList.toggle("current", at === this.#current);
      rows.push(row);
    });
    if (found > MOST_ROWS) {
      rows.push(element("li", { class: "quiet" }, `and ${found - MOST_ROWS} more: search to find them`));
    }
    this.#list.replaceChildren(...rows);
  }
}
