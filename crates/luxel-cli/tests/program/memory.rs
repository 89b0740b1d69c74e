//! Memory stays within ten times the file and 50 MB, whatever small things the file is made of.

use crate::output::shell;
use crate::program::Folder;
use std::fmt::Write;

/// Both commands read the file with so much memory. `ulimit -d` counts what a process may write to,
/// stacks included.
#[track_caller]
fn read_within_bounds(folder: &Folder, model: &str, bytes: usize) {
    let kilobytes = (10 * bytes + 50_000_000) / 1024;
    for line in [format!("info {model}"), format!("render {model} --size 64x48 -o x.png")] {
        let run = format!("ulimit -d {kilobytes} && \"$0\" {line} --quiet");
        let (status, message) = shell(folder, &run);
        assert_eq!(status, Some(0), "{line}, {kilobytes} kB: {message}");
    }
}

#[test]
fn tens_of_thousands_of_solids_take_ten_times_their_file() {
    let folder = Folder::new();
    let mut text = String::new();
    for z in 0..40_000 {
        let _ = write!(
            text,
            "solid {z}\nfacet normal 0 0 1\nouter loop\nvertex 0 0 {z}\nvertex 1 0 {z}\nvertex 0 1 {z}\n\
             endloop\nendfacet\nendsolid\n"
        );
    }
    folder.write("solids.stl", &text);
    read_within_bounds(&folder, "solids.stl", text.len());
}

#[test]
fn hundreds_of_thousands_of_unused_materials_take_ten_times_their_file() {
    let folder = Folder::new();
    let mut text = String::new();
    for number in 0..300_000 {
        let _ = writeln!(text, "newmtl m{number}\nKd 1 0 0");
    }
    folder.write("all.mtl", &text);
    let model = "mtllib all.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m7\nf 1 2 3\n";
    folder.write("one.obj", model);
    read_within_bounds(&folder, "one.obj", text.len() + model.len());
}

#[test]
fn hundreds_of_thousands_of_groups_take_ten_times_their_file() {
    let folder = Folder::new();
    let mut shared = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    let mut own = String::new();
    for number in 0..100_000 {
        let _ = writeln!(shared, "g g{number}\nf 1 2 3");
        let _ = writeln!(
            own,
            "v 0 0 {number}\nv 1 0 {number}\nv 0 1 {number}\ng g{number}\nf -3 -2 -1"
        );
    }
    for (name, text) in [("shared.obj", shared), ("own.obj", own)] {
        folder.write(name, &text);
        read_within_bounds(&folder, name, text.len());
    }
}
