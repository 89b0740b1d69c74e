//! `luxel demos`: the built-in scenes.

use crate::failure::Failure;
use crate::output;
use clap::Args;
use luxel::scene::demos;
use serde_json::{Value, json};

/// List the built-in scenes
#[derive(Args, Debug)]
pub(crate) struct DemosCommand {
    /// Print a JSON document
    #[arg(long)]
    json: bool,
}

impl DemosCommand {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let names: Vec<_> = demos::names();
        if self.json {
            let entry = |(name, about): &(&str, &str)| json!({ "name": name, "about": about });
            return output::print_json(&names.iter().map(entry).collect::<Value>());
        }
        let width = names.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
        let lines = names.iter().map(|(name, about)| format!("demo:{name:width$}  {about}\n"));
        output::print(&lines.collect::<String>())
    }
}
