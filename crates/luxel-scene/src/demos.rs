//! Scenes built into the program, made by formulas: no file is needed to see something.

mod blob;
mod builder;
mod cornell;
pub mod lab;
mod plane;
mod spheres;
mod teapot;
mod welcome;

use crate::Scene;

/// A built-in scene: name, one line of help, and constructor.
struct Demo {
    name: &'static str,
    about: &'static str,
    make: fn() -> Scene,
}

const DEMOS: [Demo; 6] = [
    Demo {
        name: "teapot",
        about: "the Utah teapot, from Newell's 32 patches",
        make: teapot::scene,
    },
    Demo {
        name: "spheres",
        about: "rows of spheres, one per reflection model",
        make: spheres::scene,
    },
    Demo {
        name: "cornell",
        about: "the Cornell box, a room with coloured walls and two blocks",
        make: cornell::scene,
    },
    Demo {
        name: "plane",
        about: "a coloured ground plane with named objects on it",
        make: plane::scene,
    },
    Demo {
        name: "welcome",
        about: "the teapot on the coloured ground, the default of the viewer",
        make: welcome::scene,
    },
    Demo {
        name: "blob",
        about: "a bumpy ball of a million triangles, for benchmarks",
        make: blob::scene,
    },
];

/// The names of the built-in scenes, each with one line of help.
#[must_use]
pub fn names() -> Vec<(&'static str, &'static str)> {
    demos().map(|demo| (demo.name, demo.about)).collect()
}

/// A built-in scene by its name.
#[must_use]
pub fn demo(name: &str) -> Option<Scene> {
    demos().find(|demo| demo.name == name).map(|demo| (demo.make)())
}

fn demos() -> impl Iterator<Item = &'static Demo> {
    DEMOS.iter().chain(&lab::DEMOS)
}

#[cfg(test)]
mod tests;
