//! `luxel completions`: shell completions.

use crate::failure::Failure;
use crate::output;
use clap::{Args, Command};
use clap_complete::Shell;

/// Print completions for a shell
///
/// For example: luxel completions bash > ~/.local/share/bash-completion/completions/luxel
#[derive(Args, Debug)]
pub(crate) struct CompletionsCommand {
    /// The shell
    shell: Shell,
}

impl CompletionsCommand {
    pub(crate) fn run(self, mut program: Command) -> Result<(), Failure> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut program, "luxel", &mut script);
        output::print_bytes(&script)
    }
}
