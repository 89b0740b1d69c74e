//! `luxel demos`: the scenes built into the program.

use crate::failure::Failure;
use crate::flag_words::with_flags;
use crate::output;
use clap::Args;
use luxel::scene::demos;
use serde_json::json;

/// List the scenes built into the program
#[derive(Args, Debug)]
pub(crate) struct DemosCommand {
    /// Print a JSON document
    #[arg(long)]
    json: bool,
}

impl DemosCommand {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let names: Vec<_> =
            demos::names().into_iter().map(|(name, about)| (name, with_flags(about))).collect();
        if self.json {
            let entry = |(name, about): &(&str, String)| json!({ "name": name, "about": about });
            return output::print_json(&names.iter().map(entry).collect());
        }
        let width = names.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
        let lines = names.iter().map(|(name, about)| format!("demo:{name:width$}  {about}\n"));
        output::print(&lines.collect::<String>())
    }
}
