/** Matrices as formulas. */

const MATH = "http://www.w3.org/1998/Math/MathML";

function math(name: string, ...children: (Node | string)[]): Element {
  const made = document.createElementNS(MATH, name);
  made.append(...children);
  return made;
}

/** A number of a matrix, in a width that doesn't jump. */
function entry(value: number): string {
  const text = Math.abs(value) < 5e-5 ? "0.0000" : value.toFixed(4);
  return text.replace("-", "−");
}

/** A matrix of four rows and columns, given column by column. */
export function matrix(name: string, values: readonly number[]): Element {
  const rows = [0, 1, 2, 3].map((row) =>
    math("mtr", ...[0, 1, 2, 3].map((column) => math("mtd", math("mn", entry(values[column * 4 + row] ?? 0))))),
  );
  const table = math("mrow", math("mo", "("), math("mtable", ...rows), math("mo", ")"));
  return math("math", math("mi", name), math("mo", "="), table);
}
