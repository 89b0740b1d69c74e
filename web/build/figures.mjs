// What figures add to the texts of articles: their still pictures, and what is in their data alone.

import { exportsOf } from "./typescript.mjs";

const figuresOf = (article) => exportsOf(`site/src/figures/${article}.ts`);

/**
 * Adds the stills of all pages; for articles with figures that are in their data alone, gives what puts these into the
 * text, and adds their stills.
 */
export async function addFigures(stills) {
  stills.add("teapot", "teapot", { size: "960x540" });
  const light = await figuresOf("light");
  for (const figure of light.FIGURES) {
    stills.add(`light-${figure.id}`, figure.demo, light.firstSettings(figure));
  }
  stills.add("picking-ray", "plane", { size: [640, 400] });
  stills.addIds("picking-ids", "plane", { size: [640, 400] });
  const navigation = await figuresOf("navigation");
  stills.add("navigation-look-at", "welcome", navigation.firstSettings(navigation.FIGURES[0]));
  stills.add("navigation-modes", "welcome", { size: [640, 400] });
  stills.add("navigation-rolling-ball", "teapot", { size: [640, 400] });

  const shading = await figuresOf("shading");
  const reflection = await figuresOf("reflection");
  const [vectors] = reflection.VECTORS;
  stills.add("reflection-vectors", vectors.demo, reflection.firstSettings(vectors));
  return {
    shading: (text) => withComparisons(stills, text, "shading", shading.FIGURES, shading.firstSettings),
    reflection: (text) =>
      withComparisons(stills, text, "reflection", reflection.COMPARISONS, reflection.firstOfComparison).replace(
        "<!-- table -->",
        tableOfShininess(stills, reflection.TABLE),
      ),
  };
}

/** Puts comparisons in place of their lines, `<!-- figure: ID: CAPTION -->`. */
function withComparisons(stills, text, article, comparisons, firstSettings) {
  for (const figure of comparisons) {
    const [width, height] = figure.size;
    const pictures = firstSettings(figure).map(({ demo, settings }, at) => {
      const file = stills.add(`${article}-${figure.id}-${["problem", "cure"][at]}`, demo, settings);
      const { alt } = [figure.problem, figure.cure][at];
      return `<img src="${file}" width="${width}" height="${height}" loading="lazy" alt="${alt}">`;
    });
    const line = new RegExp(`<!-- figure: ${figure.id}: (.*) -->`);
    const [, caption] = line.exec(text);
    text = text.replace(
      line,
      `<figure class="live" id="${figure.id}">\n<div class="stills">${pictures.join("")}</div>\n<figcaption>${caption}</figcaption>\n</figure>`,
    );
  }
  if (text.includes("<!-- figure")) throw new Error(`a figure of ${article}.html has no data`);
  return text;
}

/** The table of shininess: each of its images is a part of one still picture. */
function tableOfShininess(stills, { demo, size, ks, n, settings, about }) {
  const balls = ks.map((ks) => n.map((n) => settings(ks, n, about.value)));
  const file = stills.addTable("reflection-table", demo, size, balls);
  const [width, height] = size;
  const cell = (row, column) => {
    const place = `width="${width}" height="${height}" style="object-position: ${-column * width}px ${-row * height}px"`;
    const alt = `A ball with k_s = ${ks[row]} and n = ${n[column]}`;
    return `<td><img src="${file}" ${place} loading="lazy" alt="${alt}"></td>`;
  };
  const head = `<tr><th scope="col">k<sub>s</sub> \\ n</th>${n.map((n) => `<th scope="col">${n}</th>`).join("")}</tr>`;
  const rows = ks.map((ks, row) => `<tr><th scope="row">${ks}</th>${n.map((_, column) => cell(row, column)).join("")}</tr>`);
  return `<div class="scroll" tabindex="0" role="group" aria-label="The table of shininess"><table>${head}${rows.join("")}</table></div>`;
}
