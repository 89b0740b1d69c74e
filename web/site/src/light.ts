/** The page on light. */

import { LiveFigure } from "./article.ts";
import { FIGURES } from "./figures/light.ts";
import { page } from "./live.ts";

const [first, ...rest] = FIGURES.map((figure) => new LiveFigure(figure));
page([first!, ...rest]);
