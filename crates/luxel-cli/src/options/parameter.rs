//! Flags of the reflection parameters, built from their descriptions.

use crate::values::parameter;
use clap::{Arg, ArgMatches, Args, Command, Error, FromArgMatches};
use luxel::lighting::{Parameter, SHARED, own_parameters};

/// Reflection parameters for all surfaces: those of all materials or, if `OWN`, those of
/// a single reflection model.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ParameterOptions<const OWN: bool> {
    /// The parameters on the command line, with their values.
    pub(crate) values: Vec<(&'static Parameter, f32)>,
}

/// The parameters of a single reflection model, or those of all materials.
fn parameters(own: bool) -> Vec<&'static Parameter> {
    if own { own_parameters().map(|own| &own.parameter).collect() } else { SHARED.into() }
}

impl<const OWN: bool> Args for ParameterOptions<OWN> {
    fn augment_args(command: Command) -> Command {
        let arg = |of: &'static Parameter| {
            Arg::new(of.name)
                .long(of.name)
                .value_name(of.placeholder)
                .value_parser(move |text: &str| parameter(of, text))
                .allow_hyphen_values(true)
                .help(of.help)
        };
        command.args(parameters(OWN).into_iter().map(arg))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl<const OWN: bool> FromArgMatches for ParameterOptions<OWN> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let value = |of: &'static Parameter| Some((of, *matches.get_one(of.name)?));
        Ok(Self { values: parameters(OWN).into_iter().filter_map(value).collect() })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        self.values.extend(Self::from_arg_matches(matches)?.values);
        Ok(())
    }
}
