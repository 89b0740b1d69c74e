/** The workers of a page: one that leads, and others that draw shares of large pictures. */

import { compile } from "./compile.ts";
import { LuxelError } from "./error.ts";
import type { CallName, Calls, ModuleUrls, Request, Response } from "./protocol.ts";

/** A worker ended, for want of memory or by a bug; a new one takes its place, without what the old one held. */
export class WorkerEndedError extends LuxelError {
  override name = "WorkerEndedError";
}

/** Where the package's files are, and how many workers draw. */
export interface Options {
  /** Workers that draw, with the one that leads; by default one a core, and at most 4. */
  workers?: number;
  /** The address of the worker's script; by default beside this module. */
  workerUrl?: string | URL;
  /** The address of the module that draws. */
  wasmUrl?: string | URL;
  /** The address of the module that answers: picks, ledgers, layers. */
  answersUrl?: string | URL;
  /** The address of the module that reads files, and writes PNG. */
  readersUrl?: string | URL;
}

let options: Options = {};

/** Changes where files are and how many workers draw; to be called before anything is loaded. */
export function configure(changes: Options): void {
  options = { ...options, ...changes };
}

interface Waiting {
  resolve(result: unknown): void;
  reject(error: Error): void;
}

let compiled: Promise<WebAssembly.Module> | undefined;

/** The module that draws, compiled once for all workers. */
function drawingModule(): Promise<WebAssembly.Module> {
  compiled ??= compile(options.wasmUrl ?? new URL("./luxel_bg.wasm", import.meta.url));
  compiled.catch(() => (compiled = undefined));
  return compiled;
}

function absolute(url: string | URL): string {
  return new URL(url, location.href).href;
}

/** A worker with the calls that wait for it. */
export class Hand {
  #worker: Worker;
  #waiting = new Map<number, Waiting>();
  #next = 0;
  #ended: Error | undefined;
  readonly ready: Promise<void>;
  onEnd: (error: WorkerEndedError) => void = () => {};

  constructor() {
    // In one expression, by which bundlers know a worker.
    this.#worker =
      options.workerUrl === undefined
        ? new Worker(new URL("./worker.js", import.meta.url), { type: "module" })
        : new Worker(options.workerUrl, { type: "module" });
    this.#worker.onmessage = ({ data }: MessageEvent<Response>) => this.#answered(data);
    this.#worker.onerror = (event) => this.#end(event.message || "its script can't be loaded");
    const later: ModuleUrls = {
      answers: absolute(options.answersUrl ?? new URL("./answers.wasm", import.meta.url)),
      readers: absolute(options.readersUrl ?? new URL("./readers_bg.wasm", import.meta.url)),
    };
    this.ready = drawingModule().then((module) => this.call("start", [module, later]));
    this.ready.catch(() => {});
  }

  /** Calls the worker; `transfer` lists buffers that it takes over. */
  call<N extends CallName>(
    name: N,
    parameters: Parameters<Calls[N]>,
    transfer: Transferable[] = [],
  ): Promise<ReturnType<Calls[N]>> {
    return new Promise((resolve, reject) => {
      if (this.#ended !== undefined) {
        reject(this.#ended);
        return;
      }
      const id = this.#next++;
      this.#waiting.set(id, { resolve: resolve as Waiting["resolve"], reject });
      const request: Request = { id, name, parameters };
      this.#worker.postMessage(request, transfer);
    });
  }

  terminate(): void {
    this.#ended ??= new LuxelError("this worker was closed");
    this.#worker.terminate();
  }

  #answered(response: Response): void {
    const waiting = this.#waiting.get(response.id);
    this.#waiting.delete(response.id);
    if ("result" in response) {
      waiting?.resolve(response.result);
      return;
    }
    if (!response.isFatal) {
      waiting?.reject(new LuxelError(response.error));
      return;
    }
    const error = this.#end(response.error);
    waiting?.reject(error);
  }

  #end(why: string): WorkerEndedError {
    const error = new WorkerEndedError(
      `the worker ended, perhaps for want of memory, and was started anew (${why})`,
    );
    this.#ended = error;
    this.#worker.terminate();
    for (const waiting of this.#waiting.values()) {
      waiting.reject(error);
    }
    this.#waiting.clear();
    this.onEnd(error);
    return error;
  }
}

let leading: Hand | undefined;
let helping: Hand[] = [];

/** The worker that holds models and views. */
export function leader(): Hand {
  if (leading === undefined) {
    const hand = new Hand();
    hand.onEnd = () => {
      leading = undefined;
    };
    leading = hand;
  }
  return leading;
}

/** How many workers draw. */
export function drawers(): number {
  const cores = globalThis.navigator?.hardwareConcurrency ?? 1;
  return Math.max(1, Math.min(16, options.workers ?? Math.min(4, cores)));
}

/** The workers that help the leader; started when they are first needed. */
export function helpers(): readonly Hand[] {
  while (helping.length < drawers() - 1) {
    const hand = new Hand();
    hand.onEnd = () => {
      helping = helping.filter((other) => other !== hand);
    };
    helping.push(hand);
  }
  return helping;
}
