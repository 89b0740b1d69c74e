/** Symbols of the lighting equation as MathML. */

const MATH = "http://www.w3.org/1998/Math/MathML";

function math(name: string, ...children: (Node | string)[]): Element {
  const made = document.createElementNS(MATH, name);
  made.append(...children);
  return made;
}

/** Words of letters are identifiers, digits numbers, all else operators. */
function plain(text: string): Element[] {
  const parts = text.match(/[A-Za-z]+'?|[0-9.]+|[^A-Za-z0-9.\s]|\./g) ?? [];
  return parts.map((part) => {
    if (/^[0-9]/.test(part)) return math("mn", part);
    if (/^[A-Za-z]/.test(part)) return math("mi", part === "pi" ? "π" : part);
    return math("mo", part === "." ? "·" : part === "-" ? "−" : part);
  });
}

/** `k_d`, `max(N.L, 0)^n` and the like. */
function row(text: string): Element[] {
  const made: Element[] = [];
  let rest = text;
  while (rest !== "") {
    const indexed = /^([A-Za-z]+)_([A-Za-z0-9]+(?:,[a-z])?)/.exec(rest);
    const powered = /^((?:max)?\([^()]*\))\^([A-Za-z0-9]+)/.exec(rest);
    if (indexed) {
      made.push(math("msub", math("mi", indexed[1]!), math(/^[0-9]/.test(indexed[2]!) ? "mn" : "mi", indexed[2]!)));
      rest = rest.slice(indexed[0].length);
    } else if (powered) {
      made.push(math("msup", math("mrow", ...row(powered[1]!)), math("mi", powered[2]!)));
      rest = rest.slice(powered[0].length);
    } else if (rest.startsWith(" ")) {
      const space = math("mspace");
      space.setAttribute("width", "0.2em");
      made.push(space);
      rest = rest.trimStart();
    } else {
      const next = /^(?:[A-Za-z]+'?(?!_)|.)/.exec(rest)![0];
      made.push(...plain(next));
      rest = rest.slice(next.length);
    }
  }
  return made;
}

/** A symbol as a formula. */
export function formula(text: string): Element {
  return math("math", ...row(text));
}
