/** The page on picking: what is under a pixel, found in four ways. */

import type { Explanation, Hit, RegionHit } from "luxel";
import { byId, drawn, element } from "./dom.ts";
import { DemoView, Live, page } from "./live.ts";
import { draggable } from "./number.ts";

const SIZE: [number, number] = [640, 400];
const DEMO = "plane";

/** A number in four digits. */
function short(value: number): string {
  return Number(value.toPrecision(4)).toString().replace("-", "−");
}

/** The eye of a camera: where V, a rotation and a translation, maps to the origin. */
function eyeOf(v: readonly number[]): [number, number, number] {
  const part = (column: number): number => -[0, 1, 2].reduce((sum, row) => sum + v[column * 4 + row]! * v[12 + row]!, 0);
  return [part(0), part(1), part(2)];
}

function row(...cells: (string | Node)[]): HTMLElement {
  return element("tr", {}, ...cells.map((cell) => element("td", {}, cell)));
}

function table(head: string[], rows: HTMLElement[]): HTMLElement {
  const heads = head.map((text) => element("th", { scope: "col" }, text));
  return element("table", { class: "records" }, element("thead", {}, element("tr", {}, ...heads)), element("tbody", {}, ...rows));
}

class LivePicking extends Live {
  readonly #canvas = element("canvas", { role: "img", tabindex: "0" });
  readonly #ids = element("canvas", { role: "img" });
  readonly #overlay = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  readonly #verdict = element("p", { class: "said", "aria-live": "polite" });
  readonly #side: { element: HTMLElement; set(value: number): void };
  #at: [number, number] = [330, 215];
  #width = 5;
  readonly #view = new DemoView(DEMO);
  #objects: Uint32Array | undefined;
  readonly #pixels = new Map<HTMLCanvasElement, Uint8ClampedArray>();

  constructor() {
    super("ray");
    const number = { name: "side", symbol: "", meaning: "the sliver's side in pixels", value: 5, min: 1, max: 81, step: 2 };
    this.#side = draggable(number, (value) => {
      this.#width = value;
      this.changed();
    });
    for (const [id, canvas] of [["ray", this.#canvas], ["ids", this.#ids]] as const) {
      [canvas.width, canvas.height] = SIZE;
      const still = byId(id).querySelector("img")!;
      canvas.setAttribute("aria-label", still.alt);
      const picture = element("div", { class: "live-picture" }, canvas);
      if (id === "ray") picture.append(this.#overlay);
      still.replaceWith(picture);
      canvas.addEventListener("click", (event) => this.#point(canvas, event));
    }
    this.#overlay.setAttribute("viewBox", `0 0 ${SIZE[0]} ${SIZE[1]}`);
    this.#overlay.setAttribute("aria-hidden", "true");
    byId("side").append("the sliver is ", this.#side.element, " pixels wide and high");
    byId("verdict").append(this.#verdict);
    this.#canvas.addEventListener("keydown", (event) => {
      const steps: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
      const step = steps[event.key];
      if (step === undefined) return;
      event.preventDefault();
      const far = event.shiftKey ? 1 : 8;
      this.#move(this.#at[0] + step[0] * far, this.#at[1] + step[1] * far);
    });
  }

  #point(canvas: HTMLCanvasElement, event: MouseEvent): void {
    const box = canvas.getBoundingClientRect();
    this.#move(((event.clientX - box.left) / box.width) * SIZE[0], ((event.clientY - box.top) / box.height) * SIZE[1]);
  }

  #move(x: number, y: number): void {
    const within = (at: number, side: number): number => Math.min(Math.max(Math.floor(at), 0), side - 1);
    this.#at = [within(x, SIZE[0]), within(y, SIZE[1])];
    this.changed();
  }

  protected override async drawOnce(): Promise<void> {
    const view = await this.#view.opened({ size: SIZE });
    if (this.#objects === undefined) {
      const image = await view.render({ workers: 1 });
      const ids = await view.layerPicture("object");
      for (const [canvas, data] of [[this.#canvas, image.data], [this.#ids, ids]] as const) {
        canvas.getContext("2d")!.putImageData(new ImageData(data as typeof ids, ...SIZE), 0, 0);
        this.#pixels.set(canvas, data);
      }
      this.#objects = (await view.layers(["object"])).object;
    }
    const [x, y] = this.#at;
    const camera = await view.navigate();
    const hits = await view.pickThrough(x + 0.5, y + 0.5);
    const left = x + 0.5 - this.#width / 2;
    const top = y + 0.5 - this.#width / 2;
    const records = await view.pickRect(left, top, this.#width, this.#width);
    const visible = await view.pickRect(left, top, this.#width, this.#width, true);
    this.#show(eyeOf(camera.viewFromWorld), hits, records, visible);
  }

  protected override fail(message: string): void {
    this.#verdict.textContent = message;
  }

  override pixels(canvas: HTMLCanvasElement | undefined): Uint8ClampedArray | undefined {
    return this.#pixels.get(canvas ?? this.#canvas);
  }

  override explain(x: number, y: number): Promise<Explanation> {
    return this.#view.explain(x, y);
  }

  #show(eye: readonly number[], hits: Hit[], records: RegionHit[], visible: RegionHit[]): void {
    const [x, y] = this.#at;
    const w = this.#width;
    const names = (path: string[]): string => path.join(" / ");
    const triples = (values: readonly number[]): string => `(${values.map(short).join(", ")})`;

    // The ray.
    const call = [
      `gluUnProject(${x}.5, ${SIZE[1] - y - 1}.5, 0, V, P, viewport, &nx, &ny, &nz);  /* the near plane */`,
      `gluUnProject(${x}.5, ${SIZE[1] - y - 1}.5, 1, V, P, viewport, &fx, &fy, &fz);  /* the far plane */`,
    ];
    byId("ray-calls").textContent = call.join("\n");
    const ofRay = hits.map((hit) =>
      row(names(hit.path), String(hit.triangle ?? ""), triples(hit.barycentric), triples(hit.position), short(hit.distance)),
    );
    byId("ray-hits").replaceChildren(
      element("p", {}, `The ray starts at the eye, ${triples(eye)}, and meets ${hits.length === 0 ? "nothing" : `${hits.length} ${hits.length === 1 ? "surface" : "surfaces"}`}, nearest first:`),
      table(["object", "triangle", "barycentrics", "place", "distance"], ofRay),
    );

    // The sliver, with selection mode's records.
    byId("sliver-calls").textContent = [
      "glSelectBuffer(SIZE, buffer);",
      "glRenderMode(GL_SELECT);",
      "glMatrixMode(GL_PROJECTION);",
      "glLoadIdentity();",
      `gluPickMatrix(${x}.5, ${SIZE[1] - y - 1}.5, ${w}, ${w}, viewport);`,
      "gluPerspective(fovy, aspect, near, far);",
      "/* glPushName(node) ... draw ... glPopName() for each node */",
      "hits = glRenderMode(GL_RENDER);",
    ].join("\n");
    const sorted = [...records].sort((a, b) => a.z_min - b.z_min);
    const whole = (depth: number): string => Math.round(depth * 4294967295).toLocaleString("en");
    const ofSliver = sorted.map((record) =>
      row(String(record.names.length), whole(record.z_min), whole(record.z_max), names(record.names)),
    );
    byId("sliver-hits").replaceChildren(
      element("p", {}, `${records.length} hit ${records.length === 1 ? "record" : "records"}: the count of names, the least and the greatest depth as OpenGL writes them, 0 to 2³² − 1, and the names on the stack.`),
      table(["names", "z min", "z max", "name stack"], ofSliver),
    );

    // The visible ids.
    const none = 4294967295;
    const id = this.#objects?.[y * SIZE[0] + x] ?? none;
    const ofIds = visible.map((hit) => row(String(hit.index), names(hit.path), String(hit.pixels ?? 0)));
    byId("ids-hits").replaceChildren(
      element("p", {}, id === none ? "The picture of ids holds nothing here." : `The picture of ids holds ${id} here. Within the square:`),
      table(["id", "object", "pixels"], ofIds),
    );

    // Do they agree?
    const byRay = hits[0]?.index ?? none;
    const bySliver = sorted.some((record) => record.index === byRay) || byRay === none;
    const agree = byRay === id && bySliver;
    const name = hits[0] === undefined ? "nothing" : names(hits[0].path);
    this.#verdict.textContent = agree
      ? `Pixel ${x}, ${y}: the ray, the sliver's records, the name stack and the picture of ids agree on ${name}.`
      : `Pixel ${x}, ${y}: they disagree: ray ${byRay}, ids ${id}.`;
    this.#verdict.dataset["agree"] = String(agree);
    this.#overlay.replaceChildren(
      drawn("rect", { x: x + 0.5 - w / 2, y: y + 0.5 - w / 2, width: w, height: w, fill: "none", stroke: "var(--accent)", "stroke-width": 1.5 }),
      drawn("circle", { cx: x + 0.5, cy: y + 0.5, r: Math.max(9, w), fill: "none", stroke: "var(--ground)", "stroke-width": 1 }),
    );
  }
}

page([new LivePicking()]);
