/** The page on shading. */

import { LiveComparison } from "./compared.ts";
import { FIGURES } from "./figures/shading.ts";
import { page } from "./live.ts";

const [first, ...rest] = FIGURES.map((comparison) => new LiveComparison(comparison));
page([first!, ...rest]);
