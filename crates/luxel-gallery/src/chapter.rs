//! The elements of a chapter.

use crate::GalleryError;
use crate::compare::{Error, error, error_picture};
use crate::picture::Picture;
use crate::shot::{Shot, Studio};
use crate::{File, Reproduced};
use luxel::check::{Finding, Kind, Setup, check};
use luxel::scene::{NormalOptions, Size, demos};

/// A problem and its cure, measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// The chapter and the measure, for machines: `silhouette`.
    pub name: &'static str,
    /// The measured quantity, in words.
    pub measure: String,
    /// How far the problem is off.
    pub problem: Error,
    /// How far the cure is off.
    pub cure: Error,
    /// Why the cure is less than five times better; for each of the two numbers for which it is.
    pub because: Option<&'static str>,
}

/// So many times better a cure has to be; the page states it.
pub(crate) const ENOUGH: f64 = 5.0;

impl Pair {
    /// By how much the cure makes the largest and the mean error smaller; infinite where none is
    /// left.
    #[must_use]
    pub fn times_better(&self) -> [f64; 2] {
        let Self { problem, cure, .. } = self;
        [[problem.largest, cure.largest], [problem.mean, cure.mean]]
            .map(|[before, after]| if after > 0.0 { before / after } else { f64::INFINITY })
    }

    /// Whether the cure is at least five times better, by the largest and by the mean error.
    #[must_use]
    pub fn is_enough(&self) -> bool {
        self.times_better().into_iter().all(|times| times >= ENOUGH)
    }
}

/// A chapter of the page.
pub(crate) struct Chapter {
    /// The anchor of links: short, without spaces.
    pub(crate) id: &'static str,
    pub(crate) title: &'static str,
    pub(crate) blocks: Vec<Block>,
    pub(crate) files: Vec<File>,
    pub(crate) pairs: Vec<Pair>,
    pub(crate) reproduced: Vec<Reproduced>,
}

/// A piece of a chapter. Texts are HTML.
pub(crate) enum Block {
    Text(String),
    Figures(Vec<Figure>),
    Table(Table),
    Pair(Pair),
    Command(Vec<String>),
}

/// A picture or plot with its caption.
pub(crate) struct Figure {
    pub(crate) file: String,
    /// In pixels of the page; pictures have [`DENSITY`](crate::picture::DENSITY) times as many.
    pub(crate) size: Size,
    /// The alternative text.
    pub(crate) alt: String,
    pub(crate) caption: String,
    /// The command that draws it.
    pub(crate) command: Option<Vec<String>>,
    /// The labels of rows and columns in a table of images.
    pub(crate) headings: Option<[Vec<String>; 2]>,
}

/// Numbers in columns.
pub(crate) struct Table {
    pub(crate) caption: String,
    pub(crate) head: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl Chapter {
    pub(crate) fn new(id: &'static str, title: &'static str) -> Self {
        Self {
            id,
            title,
            blocks: Vec::new(),
            files: Vec::new(),
            pairs: Vec::new(),
            reproduced: Vec::new(),
        }
    }

    /// Adds a paragraph.
    pub(crate) fn text(&mut self, html: impl Into<String>) {
        self.blocks.push(Block::Text(html.into()));
    }

    pub(crate) fn table(&mut self, caption: &str, head: &[&str], rows: Vec<Vec<String>>) {
        let head = head.iter().map(|&word| word.to_owned()).collect();
        self.blocks.push(Block::Table(Table { caption: caption.to_owned(), head, rows }));
    }

    /// Figures beside one another.
    pub(crate) fn figures(&mut self, figures: Vec<Figure>) {
        self.blocks.push(Block::Figures(figures));
    }

    /// Adds a measured pair, with a sentence about the result.
    pub(crate) fn pair(&mut self, pair: Pair) {
        self.pairs.push(pair.clone());
        self.blocks.push(Block::Pair(pair));
    }

    /// Adds the findings of `luxel check` for a scene, with an image's flags.
    pub(crate) fn checked(&mut self, studio: &Studio, shot: &Shot) {
        let shot = Shot { samples: 4, ..shot.clone() };
        let scene = demos::demo(shot.demo).unwrap_or_default();
        let normals = NormalOptions { source: shot.normals, ..NormalOptions::default() };
        let setup = Setup { view: shot.view(&scene), normals, execution: studio.execution };
        let findings = check(&scene, &setup).findings;
        let told: Vec<_> = findings.iter().map(found).collect();
        let told = if told.is_empty() { "nothing.".to_owned() } else { told.join(" It finds ") };
        self.text(format!("With the same flags, <code>luxel check</code> finds {told}"));
        self.blocks.push(Block::Command(shot.check_command()));
    }

    /// A picture that a command line draws.
    pub(crate) fn drawn(
        &mut self,
        shot: &Shot,
        picture: &Picture,
        file: &str,
        alt: &str,
        caption: &str,
    ) -> Result<Figure, GalleryError> {
        let command = shot.command(file);
        self.reproduced.push(Reproduced { file: file.to_owned(), command: command.clone() });
        let mut figure = self.picture(picture, file, alt, caption)?;
        figure.command = Some(command);
        Ok(figure)
    }

    /// A picture that no single command line draws.
    pub(crate) fn picture(
        &mut self,
        picture: &Picture,
        file: &str,
        alt: &str,
        caption: &str,
    ) -> Result<Figure, GalleryError> {
        let figure = self.file(file, picture.png()?, picture.shown(), alt, caption);
        Ok(figure)
    }

    /// A file of the page's, shown as a figure.
    pub(crate) fn file(
        &mut self,
        file: &str,
        bytes: Vec<u8>,
        size: Size,
        alt: &str,
        caption: &str,
    ) -> Figure {
        self.files.push(File { name: file.to_owned(), bytes });
        Figure {
            file: file.to_owned(),
            size,
            alt: alt.to_owned(),
            caption: caption.to_owned(),
            command: None,
            headings: None,
        }
    }

    /// Where two pictures differ from a reference, beside one another.
    pub(crate) fn error_pictures(
        &mut self,
        name: &str,
        [problem, cure]: [&Picture; 2],
        reference: &Picture,
        counts: &[bool],
    ) -> Result<[Error; 2], GalleryError> {
        let mut figures = Vec::new();
        let mut errors = [Error { largest: 0.0, mean: 0.0 }; 2];
        let both = [(problem, "problem", "the problem"), (cure, "cure", "the cure")];
        for (at, (picture, part, of)) in both.into_iter().enumerate() {
            errors[at] = error(picture, reference, counts);
            let Error { largest, mean } = errors[at];
            let file = format!("{name}-{part}-error.png");
            let alt = format!("How far {of} is off, pixel by pixel; largest {largest:.0}.");
            let caption =
                format!("Error of {of}: largest {}, mean {}.", steps(largest), steps(mean));
            let drawn = error_picture(picture, reference, counts);
            figures.push(self.picture(&drawn, &file, &alt, &caption)?);
        }
        self.figures(figures);
        Ok(errors)
    }
}

/// A number of 8-bit steps, rounded to significant digits.
pub(crate) fn steps(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else if value < 0.0995 {
        format!("{value:.3}")
    } else if value < 0.995 {
        format!("{value:.2}")
    } else if value < 9.95 {
        format!("{value:.1}")
    } else {
        format!("{value:.0}")
    }
}

/// How many times better something is.
pub(crate) fn times(value: f64) -> String {
    if value.is_infinite() {
        "none is left".to_owned()
    } else if value < 10.0 {
        format!("{value:.1} times")
    } else {
        format!("{value:.0} times")
    }
}

/// A finding: what and how many, how far off, and from what on it is reported.
fn found(finding: &Finding) -> String {
    let Finding { kind, count, severity, pixels, .. } = finding;
    let mut told = format!("{count} {} (<code>{}</code>).", kind.about(), kind.name());
    let mut say = |words: String| {
        told.push(' ');
        told.push_str(&words);
    };
    if let Some(pixels) = pixels {
        say(format!("The worst is {pixels:.1} pixels off."));
    }
    if let Some(severity) = severity {
        say(format!("Their repair changes pixels by up to {severity} steps of 255."));
    }
    let least = match kind {
        Kind::FacetedSilhouette => format!("{} pixels", Setup::LEAST_OUTLINE),
        Kind::ScreenDrift => format!("{} pixels", Setup::LEAST_DRIFT),
        Kind::MissedHighlight => format!("{} steps", Setup::LEAST_HIGHLIGHT),
        _ => return told,
    };
    say(format!("The check reports {least} or more."));
    told
}
