//! `luxel navigate`: replays a log of events without a display.

use crate::camera;
use crate::console::Console;
use crate::failure::Failure;
use crate::model;
use crate::navigation;
use crate::options::{ExecutionOptions, FrameOptions, InputOptions};
use crate::output;
use clap::Args;
use luxel::navigation::{Entry, Mode, State};
use luxel::scene::Projection;
use serde_json::json;
use std::ffi::OsString;
use std::fmt::Write;

/// Replay a log of events and print the camera after each
///
/// Prints a line for each event: view_from_world, 16 numbers column by column, as --view-matrix
/// takes them. docs/navigation.md describes the log format.
///
/// For example: luxel navigate demo:teapot --mode rolling-ball --replay hand.log
#[derive(Args, Debug)]
pub(crate) struct NavigateCommand {
    #[command(flatten)]
    input: InputOptions,

    /// The initial navigation mode: absolute, look-at, rolling-ball, flying, mouselook,
    /// turntable
    #[arg(long, value_name = "MODE", default_value = "turntable")]
    mode: Mode,

    /// The log; `-` is the standard input
    #[arg(long, value_name = "FILE", required = true)]
    replay: OsString,

    /// Print a JSON document
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    frame: FrameOptions,
    #[command(flatten)]
    execution: ExecutionOptions,
}

impl NavigateCommand {
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        if self.input.model == "-" && self.replay == "-" {
            let message = "model and log can't both be the standard input: use a file";
            return Err(Failure::Usage(message.to_owned()));
        }
        let (log, lines) = navigation::read_log(&self.replay, self.execution.max_memory)?;
        let model = model::load(&self.input, &self.execution, console)?;
        let (mut state, mut settings, start) =
            navigation::start(&self.frame, &model.scene, self.mode)?;
        let mut text = String::new();
        let mut events = Vec::new();
        for (entry, line) in log.entries.iter().zip(lines) {
            (state, settings) = entry.play(&state, &settings);
            let Entry::Event { seconds, event } = entry else { continue };
            let view = state.view_from_world().to_cols_array();
            if self.json {
                events.push(json!({
                    "line": line,
                    "seconds": seconds,
                    "event": event.to_string(),
                    "mode": state.mode().to_string(),
                    "view_from_world": view,
                    "pivot": state.pivot().to_array(),
                    "scale": state.scale(),
                }));
            } else {
                let numbers: Vec<_> = view.iter().map(ToString::to_string).collect();
                // Writing to a string can't fail.
                let _ = writeln!(text, "{}", numbers.join(","));
            }
        }
        if !self.json {
            return output::print(&text);
        }
        let projection = Projection { lens: state.lens(settings.lens), ..start.projection };
        let end = |state: &State| luxel::scene::Camera {
            view_from_world: state.view_from_world(),
            projection,
        };
        output::print_json(&json!({
            "start": camera::to_json(&start, self.frame.size),
            "events": events,
            "camera": camera::to_json(&end(&state), settings.size),
            "warnings": model.warnings,
        }))
    }
}
