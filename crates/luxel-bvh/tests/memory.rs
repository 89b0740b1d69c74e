//! What building a tree takes, beside what it is said to take. Alone in its program, as the system counts
//! the memory of processes.

#![cfg(target_os = "linux")]

use luxel_bvh::{Bvh, Quality};
use std::fs;

/// The figure of a line of `/proc/self/status`, in bytes.
fn status(name: &str) -> Option<usize> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    let kilobytes: usize = line.trim_start_matches(':').trim().strip_suffix(" kB")?.parse().ok()?;
    Some(kilobytes * 1024)
}

/// The most memory that `work` takes at a time; `None` where the system doesn't say.
fn peak<T>(work: impl FnOnce() -> T) -> Option<usize> {
    // Begins to count the peak anew.
    fs::write("/proc/self/clear_refs", "5").ok()?;
    let before = status("VmRSS")?;
    let result = work();
    let peak = status("VmHWM")?;
    drop(result);
    Some(peak.saturating_sub(before))
}

type Triangles = (Vec<[f32; 3]>, Vec<[u32; 3]>);

/// A sheet of two triangles a cell, row by row.
fn sheet(side: u32) -> Triangles {
    let position = |at: u32| [(at % side) as f32, (at / side) as f32, (at as f32 * 0.7).fract()];
    let cells = (0..side * (side - 1)).filter(|at| at % side != side - 1);
    let triangles =
        cells.flat_map(|at| [[at, at + 1, at + side], [at + 1, at + side + 1, at + side]]);
    ((0..side * side).map(position).collect(), triangles.collect())
}

/// The same triangles without shared vertices.
fn unshared((positions, triangles): &Triangles) -> Triangles {
    let corners = triangles.as_flattened().iter().map(|&vertex| positions[vertex as usize]);
    let triangles = (0..triangles.len() as u32).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]);
    (corners.collect(), triangles.collect())
}

/// The same triangles in an order that has no neighbours.
fn shuffled((positions, triangles): &Triangles) -> Triangles {
    let count = triangles.len();
    let at = |number: usize| triangles[number * 7919 % count];
    (positions.clone(), (0..count).map(at).collect())
}

/// Clumps of triangles each a fraction of the one before, so that splits cut off one at a time.
fn shrinking(count: u32) -> Triangles {
    let corner = |number: u32, corner: u32| {
        let (clump, place) = (number / 48, number % 48);
        let size = libm::powf(0.3, (place % 24) as f32);
        let [x, y] = [clump % 128, clump / 128].map(|at| at as f32 * 4.0);
        [x + size * (1.0 + 0.1 * (corner & 1) as f32), y + size * 0.1 * (corner >> 1) as f32, 0.0]
    };
    let positions = (0..3 * count).map(|at| corner(at / 3, at % 3)).collect();
    (positions, (0..count).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]).collect())
}

/// What threads work on, and pages that are counted before they are used.
const SLACK: usize = 4 << 20;

#[test]
fn building_takes_no_more_than_it_says() {
    let even = sheet(500);
    let meshes = [
        ("shared", even.clone()),
        ("unshared", unshared(&even)),
        ("shuffled", shuffled(&even)),
        ("shuffled, unshared", shuffled(&unshared(&even))),
        ("shrinking", shrinking(500_000)),
        ("few", sheet(3)),
    ];
    for quality in [Quality::Thorough, Quality::Fast, Quality::InOrder] {
        for (name, (positions, triangles)) in &meshes {
            let Some(peak) = peak(|| Bvh::build(positions, triangles, quality)) else { return };
            let most = quality.bytes_needed(triangles.len());
            assert!(peak <= most + SLACK, "{name}, {quality:?}: {peak} bytes, not {most}");
        }
    }
}
