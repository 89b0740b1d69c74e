//! The gallery: its claims, its page, and that the copy under `docs/` is up to date.
//!
//! `LUXEL_BLESS=1` writes `docs/gallery` instead of comparing with it, and fails.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel::render::Execution;
use luxel_gallery::Gallery;
use luxel_testing::blessing;
use luxel_testing::golden::{Golden, Pixels};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

fn gallery() -> &'static Gallery {
    static GALLERY: OnceLock<Gallery> = OnceLock::new();
    GALLERY.get_or_init(|| {
        let mut steps = 0;
        let gallery = Gallery::make(&Execution::default(), || steps += 1).unwrap();
        assert_eq!(steps, Gallery::STEPS);
        gallery
    })
}

fn page() -> &'static str {
    let page = gallery().files.iter().find(|file| file.name == "index.html").unwrap();
    std::str::from_utf8(&page.bytes).unwrap()
}

/// The gallery that is kept with the source.
fn kept() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/gallery")
}

#[test]
fn every_cure_is_five_times_better_or_explains_why_not() {
    for pair in &gallery().pairs {
        let [largest, mean] = pair.times_better();
        let told = format!("{}: {:?} to {:?}", pair.name, pair.problem, pair.cure);
        assert!(largest > 1.0 && mean > 1.0, "{told}: the cure does not improve it");
        // Mach bands are tiny differences that the eye amplifies.
        let is_seen = pair.problem.largest >= 8.0 || pair.name.starts_with("mach-bands");
        assert!(is_seen, "{told}: there is hardly a problem");
        // A reason that isn't needed any more would be a lie about the numbers.
        assert_eq!(pair.is_enough(), pair.because.is_none(), "{told}: {largest}, {mean} times");
    }
    let names: BTreeSet<_> = gallery().pairs.iter().map(|pair| pair.name).collect();
    for problem in [
        "silhouette",
        "perspective",
        "rolling",
        "shared-vertices",
        "missed-geometry",
        "missed-highlight",
        "chalk",
        "unnormalised",
        "mach-bands",
        "contact",
    ] {
        assert!(names.contains(problem), "{problem} isn't measured");
    }
    assert_eq!(names.len(), gallery().pairs.len(), "two pairs have one name");
}

#[test]
fn the_page_has_the_measured_numbers() {
    for pair in &gallery().pairs {
        let at = page().find(&pair.measure).unwrap_or_else(|| panic!("{} isn't told", pair.name));
        let row = &page()[at..];
        let row = &row[row.find("largest</th><td>").unwrap()..];
        let mut cells = row.split("<td>").skip(1).map(|cell| cell.split('<').next().unwrap());
        for value in [pair.problem.largest, pair.cure.largest] {
            let told: f64 = cells.next().unwrap().parse().unwrap();
            assert!((told - value).abs() <= 0.51, "{}: {told} and {value}", pair.name);
        }
    }
}

#[test]
fn the_page_shows_every_file_and_nothing_else() {
    let mut shown = BTreeSet::new();
    for image in page().split("<img ").skip(1) {
        let tag = &image[..image.find('>').unwrap()];
        let value = |key: &str| attribute(tag, key);
        assert!(value("alt").len() > 20, "{} has no text for those who don't see it", value("src"));
        assert!(shown.insert(value("src").to_owned()), "{} is shown twice", value("src"));
    }
    let written: BTreeSet<_> = gallery()
        .files
        .iter()
        .map(|file| file.name.clone())
        .filter(|name| name != "index.html")
        .collect();
    assert_eq!(shown, written);
    for outside in ["<script", "http://", "https://", "@import", "url("] {
        assert!(!page().contains(outside), "the page asks for {outside}");
    }
    for link in page().split("href=\"#").skip(1) {
        let id = &link[..link.find('"').unwrap()];
        assert!(page().contains(&format!("<section id=\"{id}\">")), "#{id} leads nowhere");
    }
}

/// The value of an attribute of a tag.
fn attribute<'a>(tag: &'a str, key: &str) -> &'a str {
    let at = tag.find(&format!("{key}=\"")).unwrap() + key.len() + 2;
    &tag[at..at + tag[at..].find('"').unwrap()]
}

#[test]
fn pictures_have_two_pixels_for_each_of_the_page() {
    let mut count = 0;
    for image in page().split("<img ").skip(1) {
        let tag = &image[..image.find('>').unwrap()];
        let name = attribute(tag, "src");
        if name.ends_with(".svg") {
            continue;
        }
        let file = gallery().files.iter().find(|file| file.name == name).unwrap();
        // The header of a PNG: width and height are its first values.
        let [width, height] =
            [16, 20].map(|at| u32::from_be_bytes(file.bytes[at..at + 4].try_into().unwrap()));
        let shown = ["width", "height"].map(|key| attribute(tag, key).parse::<u32>().unwrap());
        assert_eq!(shown.map(|side| 2 * side), [width, height], "{name} is blurred or huge");
        count += 1;
    }
    assert!(count > 30, "{count}");
}

#[test]
fn tables_beside_pictures_fit_there() {
    // Pixels of a verdict's width at which three stand beside one another in 1000, less its border;
    // of a character, the widest of common fonts; between columns.
    const ROOM: usize = 320 - 23;
    const CHARACTER: usize = 8;
    const GAP: usize = 14;
    let text = |cell: &str| cell[cell.find('>').unwrap() + 1..cell.find('<').unwrap()].len();
    let is_cell = |tag: &str| tag.starts_with("h ") || tag.starts_with("d>");
    let verdicts: Vec<_> = page().split("<div class=\"verdict\">").skip(1).collect();
    assert!(verdicts.len() >= 10);
    for verdict in verdicts {
        let table = &verdict[..verdict.find("</table>").unwrap()];
        let rows = table.split("<tr>").skip(1);
        let rows: Vec<Vec<usize>> = rows
            .map(|row| row.split("<t").filter(|cell| is_cell(cell)).map(text).collect())
            .collect();
        let columns = (0..4).map(|at| rows.iter().map(|row| row[at]).max().unwrap());
        let width: usize = columns.map(|widest| widest * CHARACTER).sum::<usize>() + 3 * GAP;
        assert!(width <= ROOM, "{width} pixels: {table}");
    }
}

#[test]
fn verdicts_speak_of_criteria_that_the_page_states() {
    let intro = &page()[..page().find("</header>").unwrap()];
    for stated in [
        "at least 5 times smaller",
        "amber is an error of 32",
        "white one of 64",
        "aren't compared",
    ] {
        assert!(intro.contains(stated), "nothing says: {stated}");
    }
    for said in page().split(" times smaller: ").skip(1) {
        assert!(said.find(".</p>").unwrap() > 20, "no reason is given");
    }
    // What the check finds depends on thresholds.
    for (kind, least) in [
        ("faceted-silhouette", "reports 6 pixels or more"),
        ("screen-drift", "reports 4 pixels or more"),
        ("missed-highlight", "reports 16 steps or more"),
    ] {
        let at = page().find(&format!("(<code>{kind}</code>)")).unwrap();
        let rest = &page()[at..];
        assert!(rest[..rest.find("</p>").unwrap()].contains(least), "{kind} has no threshold");
    }
}

#[test]
fn drawings_have_titles_and_no_broken_numbers() {
    for file in gallery().files.iter().filter(|file| file.name.ends_with(".svg")) {
        let text = std::str::from_utf8(&file.bytes).unwrap();
        assert!(text.contains("<title>"), "{}", file.name);
        for broken in ["NaN", "inf", "-0 "] {
            assert!(!text.contains(broken), "{}: {broken}", file.name);
        }
    }
}

#[test]
fn pictures_look_as_they_did() {
    let mut golden = Golden::new(&kept(), &Path::new(env!("CARGO_TARGET_TMPDIR")).join("gallery"));
    if blessing::is_blessing() {
        return write_all();
    }
    for file in gallery().files.iter().filter(|file| file.name.ends_with(".png")) {
        let pixels = Pixels::of_png(&file.bytes).unwrap();
        golden.compare(file.name.trim_end_matches(".png"), &pixels);
    }
    golden.finish();
}

#[test]
fn the_gallery_that_is_kept_is_the_one_that_is_made() {
    let mut size = 0;
    if blessing::is_blessing() {
        return write_all();
    }
    for file in &gallery().files {
        let there = fs::read(kept().join(&file.name)).unwrap_or_default();
        assert!(there == file.bytes, "docs/gallery/{} is behind: use LUXEL_BLESS=1", file.name);
        size += file.bytes.len();
    }
    let count = fs::read_dir(kept()).unwrap().count();
    assert_eq!(count, gallery().files.len(), "docs/gallery holds files that aren't made any more");
    assert!(size < 4_500_000, "{size} bytes");
}

/// Writes `docs/gallery`, once for both tests that compare with it, and fails.
fn write_all() {
    static WRITTEN: OnceLock<()> = OnceLock::new();
    WRITTEN.get_or_init(|| {
        let _ = fs::remove_dir_all(kept());
        fs::create_dir_all(kept()).unwrap();
        for file in &gallery().files {
            fs::write(kept().join(&file.name), &file.bytes).unwrap();
        }
    });
    blessing::fail(&kept());
}
