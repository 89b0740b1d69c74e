//! Picks positions: one from the command line, or one per line of the standard input.

use super::{QueryOptions, SNAP_WITHIN, SnapChoice};
use crate::failure::Failure;
use crate::output;
use crate::values::at as position;
use luxel::math::SUBPIXELS;
use luxel::pick::{PickHit, PickView, SnapTo, Snapped};
use luxel::render::At;
use luxel::report::{PickReport, camera_to_json};
use luxel::scene::Size;
use std::io::{self, BufRead, Write};

/// Maximum bytes of positions per batch.
const BATCH: usize = 1 << 20;
/// Positions per task.
const RUN: usize = 64;

/// The hits at a position.
struct Found {
    /// The position, in pixels.
    at: [f64; 2],
    /// Nearest first.
    hits: Vec<PickHit>,
    /// The snapped feature, if snapping is requested.
    snapped: Option<Option<Snapped>>,
}

impl QueryOptions {
    /// Picks one position.
    pub(super) fn one(&self, view: &PickView<'_>, at: At) -> Result<(), Failure> {
        let hits = view.at(point(at)).into_iter().collect();
        let found = self.find(view, at, hits);
        let report = found.report(view);
        if self.json {
            output::print_json(&report.to_json())
        } else {
            output::print(&report.to_text())
        }
    }

    /// Picks each line of the standard input as soon as it arrives, and prints the answers in
    /// order.
    pub(super) fn many(&self, view: &PickView<'_>) -> Result<(), Failure> {
        let mut input = io::stdin().lock();
        let mut output = io::stdout().lock();
        let mut left: Vec<u8> = Vec::new();
        let mut line = 0;
        loop {
            let read = match input.fill_buf() {
                Ok(read) => read,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
                Err(error) => {
                    return Err(Failure::work(format!("standard input: {error}"), ""));
                }
            };
            let count = read.len();
            left.extend_from_slice(read);
            input.consume(count);
            let ended = count == 0;
            if ended && !left.is_empty() {
                left.push(b'\n');
            }
            let Some(end) = left.iter().rposition(|&byte| byte == b'\n') else {
                if left.len() > BATCH {
                    return Err(unreadable(line + 1, "the line is too long"));
                }
                if ended {
                    return Ok(());
                }
                continue;
            };
            let answered = self.answers(view, &left[..=end], &mut line);
            output
                .write_all(&answered.0)
                .and_then(|()| output.flush())
                .map_err(|error| Failure::standard_output(&error))?;
            if let Some(failure) = answered.1 {
                return Err(failure);
            }
            left.drain(..=end);
            if ended {
                return Ok(());
            }
        }
    }

    /// The answers for complete lines, up to the first invalid one.
    fn answers(
        &self,
        view: &PickView<'_>,
        lines: &[u8],
        line: &mut usize,
    ) -> (Vec<u8>, Option<Failure>) {
        let mut places = Vec::new();
        let mut failure = None;
        for own in lines.split_inclusive(|&byte| byte == b'\n') {
            *line += 1;
            let own = String::from_utf8_lossy(own);
            let own = own.trim();
            if own.is_empty() {
                continue;
            }
            let place = position(own).map_err(|message| unreadable(*line, &message));
            match place.and_then(|at| check_inside(at, view.size()).map(|()| at)) {
                Ok(at) => places.push(at),
                Err(refused) => {
                    failure = Some(refused);
                    break;
                }
            }
        }
        // All answers share the camera, so it is formatted once.
        let camera = camera_to_json(view.camera(), view.size()).to_string();
        let points: Vec<[f64; 2]> = places.iter().map(|&at| point(at)).collect();
        let nearest = if self.through { vec![None; places.len()] } else { view.at_many(&points) };
        let answers = luxel_parallel::gather(places.len(), RUN, &|run, bytes| {
            for (&at, hit) in places[run.clone()].iter().zip(&nearest[run]) {
                let found = self.find(view, at, hit.iter().cloned().collect());
                let report = found.report(view);
                if self.json {
                    report.append_json_line(&camera, bytes);
                } else {
                    bytes.extend_from_slice(report.to_text().as_bytes());
                }
            }
        });
        (answers, failure)
    }

    /// Completes the answer of the nearest surface at a position, if any.
    fn find(&self, view: &PickView<'_>, at: At, mut hits: Vec<PickHit>) -> Found {
        let [x, y] = point(at);
        let stroke = self.within.and_then(|within| view.stroke_near([x, y], within));
        if self.through {
            hits = view.through([x, y]);
        }
        if let Some(stroke) = stroke {
            if self.through {
                hits.retain(|hit| (hit.object, hit.element) != (stroke.object, stroke.element));
                hits.insert(0, stroke);
            } else {
                hits = vec![stroke];
            }
        }
        let snapped = self.snap.map(|choice| {
            let to = match choice {
                SnapChoice::Vertex => SnapTo::Vertex,
                SnapChoice::Edge => SnapTo::Edge,
                SnapChoice::Face => SnapTo::Face,
            };
            view.snap([x, y], to, self.within.unwrap_or(SNAP_WITHIN))
        });
        Found { at: [x, y], hits, snapped }
    }
}

impl Found {
    fn report<'a>(&'a self, view: &'a PickView<'a>) -> PickReport<'a> {
        let report = PickReport::new(view, self.at, &self.hits);
        match &self.snapped {
            Some(snapped) => report.with_snap(snapped.as_ref()),
            None => report,
        }
    }
}

/// The position in pixels; for a whole pixel, its centre.
fn point(at: At) -> [f64; 2] {
    match at {
        At::Pixel([x, y]) => [f64::from(x) + 0.5, f64::from(y) + 0.5],
        At::Point(point) => point,
    }
}

fn unreadable(line: usize, message: &str) -> Failure {
    Failure::work(
        format!("standard input, line {line}: {message}"),
        "write one position per line, such as 640,360",
    )
}

/// Refuses a position outside of the image, also when rounded to the steps of sample positions.
pub(super) fn check_inside(at: At, size: Size) -> Result<(), Failure> {
    let Size { width, height } = size;
    let [x, y] = point(at);
    let is_inside = |position: f64, side: u32| {
        (position * f64::from(SUBPIXELS)).round() >= 0.0 && position < f64::from(side)
    };
    if is_inside(x, width) && is_inside(y, height) {
        return Ok(());
    }
    let at = match at {
        At::Pixel([x, y]) => format!("{x},{y}"),
        At::Point([x, y]) => format!("{x},{y}"),
    };
    Err(Failure::Usage(format!("{at} lies outside of the picture of {width}x{height} pixels")))
}
