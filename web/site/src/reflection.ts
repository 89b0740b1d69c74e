/** The page on reflection. */

import { LiveFigure } from "./article.ts";
import { LiveComparison } from "./compared.ts";
import { COMPARISONS, TABLE, VECTORS } from "./figures/reflection.ts";
import { page } from "./live.ts";
import { LiveTable } from "./table.ts";

page([
  new LiveFigure(VECTORS[0]!),
  ...COMPARISONS.map((comparison) => new LiveComparison(comparison)),
  new LiveTable("table", TABLE),
]);
