//! `luxel man`: the manual page, generated from the definition of the command line.

use crate::failure::Failure;
use crate::output;
use clap::Command;
use clap_mangen::Man;
use std::io::{self, Write};

/// Prints the manual page.
pub(crate) fn run(program: Command) -> Result<(), Failure> {
    let mut page = Vec::new();
    render(program, &mut page).map_err(|error| Failure::standard_output(&error))?;
    output::print_bytes(&page)
}

fn render(program: Command, page: &mut dyn Write) -> io::Result<()> {
    let mut program = program.disable_help_subcommand(true);
    program.build();
    let man = Man::new(program.clone());
    man.render_title(page)?;
    man.render_name_section(page)?;
    man.render_synopsis_section(page)?;
    man.render_description_section(page)?;
    man.render_options_section(page)?;
    for command in program.get_subcommands().filter(|command| !command.is_hide_set()) {
        describe(command, page)?;
    }
    page.write_all(ENDING.as_bytes())
}

/// A section for a command: its help and options.
fn describe(command: &Command, page: &mut dyn Write) -> io::Result<()> {
    let title = format!("luxel {}", command.get_name()).to_uppercase();
    writeln!(page, ".SH \"{title}\"")?;
    let about = command.get_long_about().or(command.get_about());
    for paragraph in about.map(ToString::to_string).unwrap_or_default().split("\n\n") {
        writeln!(page, ".PP\n{}", plain(paragraph))?;
    }
    // Global options are listed once, above.
    let own = command.clone().mut_args(|arg| {
        let hide = arg.is_global_set();
        arg.hide(hide)
    });
    let mut options = Vec::new();
    Man::new(own).render_options_section(&mut options)?;
    // A command is a section here, so its options are subsections.
    for line in String::from_utf8_lossy(&options).lines() {
        match line.strip_prefix(".SH ") {
            Some(title) => writeln!(page, ".SS {title}")?,
            None => writeln!(page, "{line}")?,
        }
    }
    Ok(())
}

/// Escapes text for troff.
fn plain(text: &str) -> String {
    text.replace('\\', "\\e").replace('-', "\\-").replace("\n.", "\n\\&.")
}

const ENDING: &str = r#".SH "EXIT STATUS"
.TP
0
done
.TP
1
failure: missing, malformed or unsupported input, or an input/output error
.TP
2
wrong usage
.TP
3
a check has findings
.SH ENVIRONMENT
.TP
NO_COLOR
disables colours in messages if set
"#;
