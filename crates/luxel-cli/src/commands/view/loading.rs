//! What window and terminal share: the model with its first view, the theme, files that are written.

use super::{ThemeName, ViewCommand};
use crate::console::Console;
use crate::failure::Failure;
use crate::options::InputOptions;
use crate::values::Exposure;
use crate::{camera, model, navigation, output, surface, view};
use luxel_viewer::{LoadProgress, Model, ThemeChoice};
use std::ffi::OsStr;
use std::path::Path;
use std::sync::Arc;

/// Fails after a stop; the failure is not shown.
fn stopped(progress: &LoadProgress) -> Result<(), Failure> {
    if progress.is_stopped() { Err(Failure::work("it was stopped", "")) } else { Ok(()) }
}

/// Writes a file. The error omits the remedy, which names a flag.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), String> {
    output::write_file(path, bytes)
        .map_err(|failure| failure.lines().first().copied().unwrap_or_default().to_owned())
}

impl ViewCommand {
    pub(super) fn theme(&self) -> ThemeChoice {
        match self.theme {
            ThemeName::Auto => ThemeChoice::Auto,
            ThemeName::Dark => ThemeChoice::Dark,
            ThemeName::Light => ThemeChoice::Light,
        }
    }

    /// Another model, of the same format if `--format` is given.
    pub(super) fn input(&self, model: &OsStr) -> InputOptions {
        InputOptions { model: model.to_owned(), format: self.input.format }
    }

    pub(super) fn load(
        &self,
        file: &OsStr,
        console: Console,
        progress: &LoadProgress,
    ) -> Result<Model, Failure> {
        self.view.execution.limit_threads();
        let input = self.input(file);
        let reading = Some(progress.reader.clone());
        let mut model = model::load_with_progress(&input, &self.view.execution, console, reading)?;
        progress.file_parsed();
        stopped(progress)?;
        if model.scene.is_empty() {
            return Err(model::nothing_to_draw(&input.name()));
        }
        surface::apply_material(&self.view.material, &mut model.scene);
        surface::apply_normals(&self.view.shading, &mut model.scene);
        progress.normals_computed();
        stopped(progress)?;
        let scene = model.scene;
        let (state, settings, camera) = navigation::start(&self.view.frame, &scene, self.mode)?;
        let mut options = self.view.clone();
        options.picture.exposure.get_or_insert(Exposure::Auto);
        let mut view = view::view(&options, None, camera, &scene)?;
        // A scene file says itself how its light falls, and a terminal is to be quick.
        let is_scene =
            Path::new(file).extension().is_some_and(|end| end.eq_ignore_ascii_case("toml"));
        if !is_scene && !self.no_occlusion && !self.terminal {
            view.ground = true;
            view.ambient_occlusion.get_or_insert_default();
        }
        let exposure_note = view::expose(&mut view, &options, &scene);
        let is_fitted = camera::is_fitted(&self.view.frame, &scene)?;
        Ok(Model {
            scene: Arc::new(scene),
            view,
            up: settings.up,
            pivot: state.pivot(),
            is_fitted,
            planes: [self.view.frame.near, self.view.frame.far],
            is_auto_exposed: options.picture.exposure == Some(Exposure::Auto),
            exposure_note,
        })
    }
}
