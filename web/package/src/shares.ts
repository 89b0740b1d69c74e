/** How workers share a picture: each draws cells, rectangles along the borders of tiles. */

import type { Pixels } from "./protocol.ts";

/** The side of a tile in pixels. */
const TILE = 64;

/** A rectangle of a picture, in pixels. */
export interface Cell {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** The cells of one worker, one after the other, each row by row. */
export interface DrawnShare {
  cells: readonly Cell[];
  pixels: Pixels;
}

/**
 * The cells of each of so many shares, or of as many as there are rows of tiles. A row is cut into a cell for each share,
 * and the next row begins with the next share: no worker has all of the model in its cells.
 */
export function sharesOf(width: number, height: number, most: number): Cell[][] {
  const count = Math.min(most, Math.ceil(height / TILE));
  if (count === 1) return [[{ left: 0, top: 0, right: width, bottom: height }]];
  const shares: Cell[][] = Array.from({ length: count }, () => []);
  const columns = Math.ceil(width / TILE);
  const edge = (cut: number): number => Math.min(width, Math.ceil((cut * columns) / count) * TILE);
  for (let row = 0; row * TILE < height; row++) {
    const [top, bottom] = [row * TILE, Math.min(height, (row + 1) * TILE)];
    for (let cut = 0; cut < count; cut++) {
      const [left, right] = [edge(cut), edge(cut + 1)];
      if (left < right) shares[(row + cut) % count]!.push({ left, top, right, bottom });
    }
  }
  return shares;
}

/** The cells for a worker: four numbers each. */
export function numbersOf(cells: readonly Cell[]): Uint32Array {
  return Uint32Array.from(cells.flatMap(({ left, top, right, bottom }) => [left, top, right, bottom]));
}

/** The bytes of all of these cells. */
export function bytesOf(cells: readonly Cell[]): number {
  return cells.reduce((sum, cell) => sum + cellBytes(cell), 0);
}

function cellBytes({ left, top, right, bottom }: Cell): number {
  return (right - left) * (bottom - top) * 4;
}

/** Each cell with its pixels. */
export function* drawnCells(shares: readonly DrawnShare[]): Generator<{ cell: Cell; pixels: Pixels }> {
  for (const { cells, pixels } of shares) {
    let start = 0;
    for (const cell of cells) {
      const end = start + cellBytes(cell);
      yield { cell, pixels: pixels.subarray(start, end) };
      start = end;
    }
  }
}

/** Copies the pixels of a cell to their places in a picture. */
export function copyCell({ left, top, right }: Cell, pixels: Pixels, picture: Pixels, width: number): void {
  const bytes = (right - left) * 4;
  for (let row = 0; row * bytes < pixels.length; row++) {
    picture.set(pixels.subarray(row * bytes, (row + 1) * bytes), ((top + row) * width + left) * 4);
  }
}
