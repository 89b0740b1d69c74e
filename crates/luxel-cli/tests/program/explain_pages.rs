//! The formats of the ledger: hidden surfaces, LaTeX, HTML, files.

use crate::explain::rgb;
use crate::explain_terms::close;
use crate::program::{Folder, luxel};
use serde_json::Value;

/// A wall, one in front of it with its back to the eye, and one behind it.
const WALLS_OBJ: &str = "\
o back
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 4 3 2 1
o front
v -1 -1 0
v 1 -1 0
v 1 1 0
v -1 1 0
f 5 6 7 8
o behind
v -1 -1 -2
v 1 -1 -2
v 1 1 -2
v -1 1 -2
f 9 10 11 12
";

const BEFORE_THE_WALLS: &str = "--size 40x40 --eye 0,0,5 --target 0,0,0 --ortho 4";

fn objects(entries: &Value) -> Vec<(&str, u64)> {
    entries
        .as_array()
        .unwrap()
        .iter()
        .map(|entry| (entry["object"].as_str().unwrap(), entry["triangle"].as_u64().unwrap()))
        .collect()
}

#[test]
fn culled_and_hidden_surfaces_are_listed() {
    let folder = Folder::new();
    folder.write("walls.obj", WALLS_OBJ);
    let ask = |more: &str| {
        let line = format!("explain walls.obj {BEFORE_THE_WALLS} {more}");
        folder.run(line.split_whitespace())
    };
    let document = ask("--at 24,12 --json --cull back").json();
    let entry = &document["samples"][0];
    assert_eq!(entry["object"], "front");
    // Polygons are fans: the second half of the first is at the upper left.
    assert_eq!(objects(&entry["culled"]), [("back", 0)]);
    let triangle = entry["triangle"].as_u64().unwrap();
    assert_eq!(objects(&entry["behind"]), [("behind", triangle)]);
    close("z", entry["behind"][0]["z"].as_f64().unwrap(), 7.0);
    close("z", entry["culled"][0]["z"].as_f64().unwrap(), 4.0);

    let drawn = ask("--at 24,12 --json --cull none").json();
    let entry = &drawn["samples"][0];
    assert_eq!(entry["object"], "back");
    assert_eq!(entry["culled"], serde_json::json!([]));
    let hidden: Vec<_> = objects(&entry["behind"]).into_iter().map(|(name, _)| name).collect();
    assert_eq!(hidden, ["front", "behind"]);

    let text = ask("--at 24,12 --cull back").text();
    for expected in ["triangle 0 of back, 4 away, would be seen here", "--cull back", "of behind"] {
        assert!(text.contains(expected), "`{expected}` is not in:\n{text}");
    }
    let latex = ask("--at 24,12 --cull back --latex").text();
    assert!(latex.contains("would be seen here"), "{latex}");
    let html = ask("--at 24,12 --cull back --html").text();
    assert!(html.contains("would be seen here"), "{html}");
}

#[test]
fn an_uncovered_pixel_lists_the_nearest_objects() {
    let folder = Folder::new();
    folder.write("walls.obj", WALLS_OBJ);
    let ask = |more: &str| {
        let line = format!("explain walls.obj {BEFORE_THE_WALLS} {more}");
        folder.run(line.split_whitespace())
    };
    // The walls cover the columns and rows 10 to 29.
    let document = ask("--at 6,7 --json").json();
    assert!(document["samples"][0]["object"].is_null());
    assert_eq!(document["nearest"]["object"], "back");
    assert_eq!(document["nearest"]["pixel"], serde_json::json!([10, 10]));
    close("pixels", document["nearest"]["pixels"].as_f64().unwrap(), 5.0);
    let text = ask("--at 6,7").text();
    assert!(text.contains("back, 5.0 pixels away at (10, 10)"), "{text}");
    assert!(ask("--at 15,15 --json").json()["nearest"].is_null());
    let away = ask("--size 400x400 --ortho 400 --at 2,2").text();
    assert!(away.contains("nothing lies within 100 pixels"), "{away}");
}

#[test]
fn a_light_without_effect_has_a_reason() {
    let folder = Folder::new();
    folder.write("walls.obj", WALLS_OBJ);
    let line = format!(
        "explain walls.obj {BEFORE_THE_WALLS} --cull back --at 20,20 --json --samples 1 --color 0,1,0 --ks 0 \
         --light directional:dir=0,0,1:name=behind \
         --light spot:pos=3,0,3:dir=0,0,-1:cutoff=20:name=narrow \
         --light point:pos=0,0,3:range=2:name=short --light point:pos=0,0,0:name=touching \
         --light point:pos=0,0,3:diffuse=0,0,0:name=dark --light point:pos=0,0,3:diffuse=1,0,0:name=red \
         --light point:pos=0,0,3:name=lamp"
    );
    let document = folder.run(line.split_whitespace()).json();
    let lights = document["samples"][0]["lights"].as_array().unwrap();
    let why: Vec<_> =
        lights.iter().map(|light| light["why_not"].as_str().unwrap_or_default()).collect();
    for (why, expected) in why.iter().zip([
        "stands behind the surface",
        // The centre of pixel (20, 20) is 0.05 off the middle, the lamp 3 away in both directions.
        "44.5 degrees off its axis, outside of its cone of 20.0 degrees",
        "beyond its range of 2",
        "or in its plane",
        "has no intensity",
        "reflects nothing of its colour",
        "",
    ]) {
        assert!(
            why.contains(expected) && why.is_empty() == expected.is_empty(),
            "{why}: {expected}"
        );
    }
    // A red light on a green surface is black.
    assert_eq!(rgb(&lights[5]["diffuse"]), [0.0; 3]);
    assert!(rgb(&lights[6]["diffuse"])[1] > 0.9);
}

/// Names can't inject LaTeX or HTML.
#[test]
fn pages_escape_names_and_contain_the_terms_of_the_text() {
    let folder = Folder::new();
    let nasty = WALLS_OBJ.replace("o front", "o <script>_$\\input{x}&\"'\u{6728}");
    folder.write("walls.obj", &nasty);
    let ask = |more: &str| {
        let line = format!(
            "explain walls.obj {BEFORE_THE_WALLS} --cull back --at 24,12 --light \
             directional:dir=0,0,-1:name=a_b<i> --light directional:dir=0,0,1:name=off \
             --fog near=1:far=9:color=.2,.3,.4 {more}"
        );
        folder.run(line.split_whitespace())
    };
    let latex = ask("--latex").text();
    assert!(latex.starts_with("% ") && latex.contains("\\usepackage{amsmath}"), "{latex}");
    for expected in [
        "\\textless{}script\\textgreater{}\\_\\$\\textbackslash{}input\\{x\\}\\&",
        "[U+6728]",
        "a\\_b",
        "I_{d,1}\\, k_d\\, O_d\\, \\max(\\mathbf N\\cdot\\mathbf L_{1}, 0)",
        "stands behind the surface",
        "I' &= s\\, I + (1 - s)\\, I_{dc}",
        "\\operatorname{round}",
    ] {
        assert!(latex.contains(expected), "`{expected}` is not in:\n{latex}");
    }
    let count = |text: &str, what: &str| text.matches(what).count();
    assert_eq!(count(&latex, "\\begin{align*}"), count(&latex, "\\end{align*}"));
    assert_eq!(count(&latex, "\\begingroup"), count(&latex, "\\endgroup"));
    let braces = latex.replace("\\{", "").replace("\\}", "");
    assert_eq!(count(&braces, "{"), count(&braces, "}"));

    let html = ask("--html").text();
    assert!(html.starts_with("<!doctype html>"));
    assert!(!html.contains("<script") && !html.contains("http"), "nothing from outside");
    for expected in [
        "&lt;script&gt;_$\\input{x}&amp;&quot;&#39;\u{6728}",
        "a_b&lt;i&gt;",
        "data:image/png;base64,",
        "<svg",
        "N to L",
        "stands behind the surface",
        "class=\"bar\"",
        "prefers-color-scheme: light",
    ] {
        assert!(html.contains(expected), "`{expected}` is not in the page");
    }
    for tag in ["figure", "svg", "section", "div", "g", "details", "dl", "span"] {
        let open = count(&html, &format!("<{tag}>")) + count(&html, &format!("<{tag} "));
        assert_eq!(open, count(&html, &format!("</{tag}>")), "{tag}");
    }
    // All formats have the same numbers.
    let document = ask("--json").json();
    let [r, g, b] = [0, 1, 2].map(|channel| document["rgba8"][channel].as_u64().unwrap());
    assert!(latex.contains(&format!("red {r}, green {g}, blue {b}")), "{latex}");
    assert!(html.contains(&format!("red {r}, green {g}, blue {b}")));
    assert!(ask("").text().contains(&format!("{r} {g} {b}")));
    let sum = format!("{:.4}", document["samples"][0]["sum"][1].as_f64().unwrap());
    for page in [&latex, &html, &ask("").text()] {
        assert!(page.contains(&sum), "{sum} is not in:\n{page}");
    }
}

#[test]
fn pages_are_written_completely_or_not_at_all() {
    let folder = Folder::new();
    for (flag, begin) in
        [("--html", "<!doctype"), ("--latex", "% "), ("--json", "{"), ("", "pixel")]
    {
        let line = format!("explain --size 40x30 --at 20,15 {flag} -o page");
        let output = folder.run(line.split_whitespace()).text();
        assert_eq!(output, "");
        let page = String::from_utf8(folder.read("page")).unwrap();
        assert!(page.starts_with(begin), "{flag}: {page}");
        let line = format!("explain --size 40x30 --at 20,15 {flag} -o -");
        assert_eq!(folder.run(line.split_whitespace()).text(), page);
    }
    luxel("explain --at 3,3 --html -o no/such/folder.html").failed(1, "no folder");
    luxel("explain --at 3,3 --html --latex").failed(2, "--latex");
    luxel("explain --at 3,3 --html --json").failed(2, "--json");
}

#[test]
fn vertex_lighting_is_explained_corner_by_corner() {
    let line = "explain --size 64x36 --at 30,18 --shading gouraud";
    let text = luxel(line).text();
    for expected in ["corner 1 of 3 weighs", "corner 3 of 3 weighs", "= light here"] {
        assert!(text.contains(expected), "`{expected}` is not in:\n{text}");
    }
    let latex = luxel(&format!("{line} --latex")).text();
    assert!(latex.contains("I &= \\sum_k w_k I_k"), "{latex}");
    assert!(luxel(&format!("{line} --html")).text().contains("Lit at corner 3 of 3"));
    let flat = luxel("explain --size 64x36 --at 30,18 --shading flat").text();
    assert!(flat.contains("the polygon's centroid weighs 1"), "{flat}");
}
