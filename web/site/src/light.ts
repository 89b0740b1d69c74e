/** The page on light. */

import { article } from "./article.ts";
import { FIGURES } from "./figures/light.ts";

article(FIGURES);
