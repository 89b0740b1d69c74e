//! The page: one file of HTML that explains all pictures, without any script.

use crate::chapter::{Block, Chapter, ENOUGH, Figure, Pair, Table, steps, times};
use crate::compare::WHITE;
use crate::picture::DENSITY;
use crate::svg::escaped;
use std::fmt::Write;

const STYLE: &str = include_str!("page.css");

/// Chapters from this one on are plots.
const FIRST_PLOT: &str = "beam";

/// Pixels for the headings of rows.
const HEADING: u32 = 64;

/// The page about all chapters.
pub(crate) fn page(chapters: &[Chapter]) -> String {
    let mut html = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta \
         name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<meta \
         name=\"color-scheme\" content=\"light dark\">\n<title>Light and shade: shading errors and \
         their cures</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n<header>\n<h1>Light \
         and shade</h1>\n<p class=\"lede\">The problems of classical shading, each beside its cure, with \
         both errors measured; and plots of the light and reflection models. \
         Drawn, measured and written by <code>luxel gallery</code>, with the renderer and the equation \
         that <code>luxel render</code> uses.</p>\n"
    );
    contents(&mut html, chapters);
    let _ = writeln!(
        html,
        "<p>An error is a difference of 8-bit values (sRGB, 0 to 255), of which the largest of red, green \
         and blue counts for each pixel. The line above each table names the pixels that are compared, and \
         the reference: an image without the problem. In images of errors, amber is an error of {} and \
         white one of {WHITE} or more; pixels that aren't compared are nearly black. A cure is expected to \
         make the largest and the mean error at least {ENOUGH} times smaller; where it doesn't, the text \
         below the table says why. The command below an image reproduces it, in {DENSITY} pixels for each \
         pixel of this page along a side.</p>\n</header>",
        WHITE / 2.0
    );
    let mut is_lab = true;
    html.push_str("<h2 class=\"part\">Shading errors</h2>\n");
    for chapter in chapters {
        if chapter.id == FIRST_PLOT && is_lab {
            is_lab = false;
            html.push_str("<h2 class=\"part\">Plots of the models</h2>\n");
        }
        section(&mut html, chapter);
    }
    html.push_str("</main>\n</body>\n</html>\n");
    html
}

fn contents(html: &mut String, chapters: &[Chapter]) {
    html.push_str("<nav aria-label=\"Contents\">\n<ol>\n");
    for Chapter { id, title, .. } in chapters {
        let _ = writeln!(html, "<li><a href=\"#{id}\">{title}</a></li>");
    }
    html.push_str("</ol>\n</nav>\n");
}

fn section(html: &mut String, chapter: &Chapter) {
    let Chapter { id, title, .. } = chapter;
    let _ = writeln!(html, "<section id=\"{id}\">\n<h3>{title}</h3>");
    let mut blocks = chapter.blocks.iter().peekable();
    while let Some(block) = blocks.next() {
        match block {
            Block::Text(text) => {
                let _ = writeln!(html, "<p>{text}</p>");
            }
            Block::Figures(figures) => {
                html.push_str("<div class=\"figures\">\n");
                for figure in figures {
                    draw(html, figure);
                }
                // Beside the pictures of errors stand the numbers.
                if let Some(Block::Pair(pair)) =
                    blocks.next_if(|next| matches!(next, Block::Pair(_)))
                {
                    let _ = writeln!(html, "{}", verdict(pair));
                }
                html.push_str("</div>\n");
            }
            Block::Table(table) => tabulate(html, table),
            Block::Pair(pair) => {
                let _ = writeln!(html, "{}", verdict(pair));
            }
            Block::Command(words) => {
                let _ = writeln!(html, "<pre><code>{}</code></pre>", escaped(&words.join(" ")));
            }
        }
    }
    html.push_str("</section>\n");
}

fn draw(html: &mut String, figure: &Figure) {
    let Figure { file, size, alt, caption, command, headings } = figure;
    let kind = if file.ends_with(".svg") { "plot" } else { "picture" };
    let image = format!(
        "<img class=\"{kind}\" src=\"{file}\" width=\"{}\" height=\"{}\" alt=\"{}\" loading=\"lazy\">",
        size.width,
        size.height,
        escaped(alt)
    );
    let spans = |names: &[String]| -> String {
        names.iter().map(|name| format!("<span>{name}</span>")).collect()
    };
    let (image, width) = match headings {
        None => (image, size.width),
        Some([rows, columns]) => (
            format!(
                "<div class=\"sheet\"><div class=\"columns\">{}</div><div class=\"rows\">{}</div>{image}</div>",
                spans(columns),
                spans(rows)
            ),
            size.width + HEADING,
        ),
    };
    let _ = writeln!(html, "<figure style=\"width:{width}px\">\n{image}\n<figcaption>{caption}");
    if let Some(words) = command {
        let line = escaped(&words.join(" "));
        let _ = writeln!(html, "<details><summary>command</summary><code>{line}</code></details>");
    }
    html.push_str("</figcaption>\n</figure>\n");
}

fn tabulate(html: &mut String, table: &Table) {
    let Table { caption, head, rows } = table;
    let _ = writeln!(
        html,
        "<div class=\"table\"><p class=\"note\">{caption}</p>
<table>
<thead><tr>"
    );
    for cell in head {
        let _ = write!(html, "<th scope=\"col\">{cell}</th>");
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for row in rows {
        html.push_str("<tr>");
        for (place, cell) in row.iter().enumerate() {
            let _ = if place == 0 {
                write!(html, "<th scope=\"row\">{cell}</th>")
            } else {
                write!(html, "<td>{cell}</td>")
            };
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n</table></div>\n");
}

/// The result of a pair, in words.
fn verdict(pair: &Pair) -> String {
    let Pair { measure, problem, cure, because, .. } = pair;
    let [largest, mean] = pair.times_better();
    let row = |name: &str, before: f64, after: f64, better: f64| {
        format!(
            "<tr><th scope=\"row\">{name}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            steps(before),
            steps(after),
            times(better)
        )
    };
    let mut html = format!(
        "<div class=\"verdict\"><p class=\"note\">{measure}</p>\n<table>\n<thead><tr><th \
         scope=\"col\">error</th><th scope=\"col\">problem</th><th scope=\"col\">cure</th><th \
         scope=\"col\">smaller by</th></tr></thead>\n<tbody>\n{}{}</tbody>\n</table>\n",
        row("largest", problem.largest, cure.largest, largest),
        row("mean", problem.mean, cure.mean, mean)
    );
    if let (false, Some(because)) = (pair.is_enough(), because) {
        let which = match (largest >= ENOUGH, mean >= ENOUGH) {
            (false, false) => "Neither error is",
            (false, true) => "The largest error isn't",
            _ => "The mean error isn't",
        };
        let _ = writeln!(html, "<p>{which} {ENOUGH} times smaller: {because}.</p>");
    }
    html.push_str("</div>");
    html
}
