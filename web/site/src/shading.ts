/** The page on shading. */

import { compared } from "./compared.ts";
import { FIGURES } from "./figures/shading.ts";

compared(FIGURES);
