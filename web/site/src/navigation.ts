/** The page on navigation. */

import { LiveFigure } from "./article.ts";
import { FIGURES } from "./figures/navigation.ts";
import { page } from "./live.ts";
import { modes, rollingBall } from "./moving.ts";

page([new LiveFigure(FIGURES[0]!), modes("modes"), rollingBall("rolling-ball")]);
