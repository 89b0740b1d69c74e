/** Asks why a pixel has its colour: the one that a click keeps, else the one under the pointer. */

import type { Ledger, View } from "luxel";

export type Pixel = [x: number, y: number];

/** What questions need of the page. */
export interface AskingPage {
  view(): View | undefined;
  /** Whether the picture shows marks instead of light. */
  isMarked(): boolean;
  isDrawing(): boolean;
  /** The ledger of a pixel, and the number of the object there. */
  answered(ledger: Ledger, at: Pixel, object: number | undefined): void;
  /** The pointer has left the picture. */
  left(): void;
}

export class Asking {
  readonly #page: AskingPage;
  #kept: Pixel | undefined;
  #pointed: Pixel | undefined;
  #isAsking = false;
  /** The pixel of the last question. */
  #asked: string | undefined;

  constructor(page: AskingPage) {
    this.#page = page;
  }

  get isKept(): boolean {
    return this.#kept !== undefined;
  }

  /** The pointer is at a pixel, or beside the picture. */
  point(at: Pixel | undefined): void {
    this.#pointed = at;
    void this.#ask();
  }

  /** Keeps a pixel; the same one again, or none, lets it go. */
  keep(at: Pixel | undefined): void {
    this.#kept = at && (this.#kept?.join() === at.join() ? undefined : at);
    this.again();
  }

  /** After another picture the same pixel may have another light. */
  again(): void {
    this.#asked = undefined;
    void this.#ask();
  }

  /** Another scene is shown. */
  forget(): void {
    this.#kept = this.#pointed = undefined;
  }

  /** Asks one question after the other. */
  async #ask(): Promise<void> {
    const { view, isMarked, isDrawing } = this.#page;
    const at = this.#kept ?? this.#pointed;
    const current = view();
    if (this.#isAsking || current === undefined) return;
    if (at === undefined || isMarked()) {
      this.#page.left();
      return;
    }
    const question = at.join();
    if (isDrawing() || this.#asked === question) return;
    this.#isAsking = true;
    this.#asked = question;
    try {
      const [ledger, hit] = await Promise.all([current.ledger(...at), current.pick(at[0] + 0.5, at[1] + 0.5)]);
      if (current === view() && this.#asked === question) this.#page.answered(ledger, at, hit?.index);
    } catch {
      // The picture became smaller meanwhile, or the scene another.
    }
    this.#isAsking = false;
    if ((this.#kept ?? this.#pointed)?.join() !== this.#asked) void this.#ask();
  }
}
