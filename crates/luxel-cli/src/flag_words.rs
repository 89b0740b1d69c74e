//! Words the hints of library errors, warnings and advice as flags.

use luxel::check::{Hint as MeshHint, Kind};
use luxel::formats::{Error, Hint, Section, UnknownFormat, Warning};

/// An error with its hint.
pub(crate) fn error_text(error: &Error) -> String {
    format!("{error}{}", hint_text(error.hint()))
}

/// A warning with its hint.
pub(crate) fn warning_text(warning: &Warning) -> String {
    format!("{warning}{}", hint_text(warning.hint))
}

/// An unknown format with its hint.
pub(crate) fn unknown_format_text(error: &UnknownFormat) -> String {
    format!("{error}{}", hint_text(error.hint()))
}

/// The text that follows a message with a hint.
fn hint_text(hint: Option<Hint>) -> &'static str {
    match hint {
        Some(Hint::RaiseMemoryLimit) => ": raise it with --max-memory",
        Some(Hint::PassFormat) => ": set it with --format",
        Some(Hint::ListNames) => ": `luxel info` lists the objects and materials of a model",
        _ => "",
    }
}

/// The help of a section of scene files.
pub(crate) fn about(section: &Section) -> String {
    let Section { about, setting, .. } = section;
    setting.map_or_else(
        || (*about).to_owned(),
        |setting| format!("{about}; the keys are the fields of --{setting}"),
    )
}

/// The remedy of a finding, with the flags that apply it.
pub(crate) fn cure(kind: Kind) -> String {
    let flags = match kind.hint() {
        Some(MeshHint::ComputeNormals) => "--normals area-angle",
        Some(MeshHint::ComputeNormalsWithCreases) => "--normals area-angle --crease 40",
        Some(MeshHint::ShadePerPixel) => "--shading phong",
        Some(MeshHint::InterpolateInSpace) => "--interpolation perspective",
        _ => return kind.cure().to_owned(),
    };
    format!("{}; in luxel: {flags}", kind.cure())
}
