//! Measures how the cost of luxel's frames grows, and what the machine can do, and draws plots of it. See
//! the script `growth` beside the crate.

mod machine;
mod plot;
mod timing;

use plot::{Axis, Bar, Line, bars, lines};
use std::error::Error;
use std::path::Path;
use timing::{Bench, Cost, Frame};

/// Counts as they are written under ticks.
fn told(count: f64) -> String {
    match count {
        count if count >= 1e6 => format!("{} M", (count / 1e5).round() / 10.0),
        count if count >= 1e4 => format!("{} k", (count / 1e3).round()),
        count if count >= 1e3 => format!("{} k", (count / 1e2).round() / 10.0),
        count => count.to_string(),
    }
}

/// The whole frame and its stages, over what it grows with.
fn of_stages(costs: &[(f64, Cost)]) -> Vec<Line> {
    let line = |name, color, of: fn(&Cost) -> f64| Line {
        name,
        color,
        values: costs.iter().map(|(x, cost)| (*x, of(cost))).collect(),
    };
    vec![
        line("frame", 't', |cost| cost.frame),
        line("visibility", 'b', |cost| cost.visibility),
        line("shade", 'a', |cost| cost.shade),
        line("bin", 'v', |cost| cost.bin),
    ]
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [luxel, out] = arguments.as_slice() else {
        return Err("growth LUXEL OUT".into());
    };
    let out = Path::new(out);
    let bench = Bench::new(luxel)?;
    let still = Frame { mesh: bench.nearest(100_000), ..Frame::default() };
    println!("one thread, one light, one sample, 1280x720 and {} but where told:", still.mesh);
    println!(
        "{:10} {:>12} {:>9} {:>9} {:>11} {:>9}  ms",
        "", "", "frame", "bin", "visibility", "shade"
    );

    let run = |name: &str, frames: Vec<(f64, Frame)>| -> Result<Vec<(f64, Cost)>, Box<dyn Error>> {
        let mut costs = Vec::new();
        for (x, frame) in frames {
            let cost = bench.time(&frame)?;
            println!(
                "{name:10} {:>12} {:9.2} {:9.2} {:11.2} {:9.2}  {}",
                told(x),
                cost.frame,
                cost.bin,
                cost.visibility,
                cost.shade,
                cost.simd
            );
            costs.push((x, cost));
        }
        Ok(costs)
    };
    let ms = |name: &str| format!("milliseconds a frame, {name}");
    let write = |name: &str, svg: String| std::fs::write(out.join(name), svg);

    let meshes = bench.meshes.iter();
    let frames =
        meshes.map(|(name, count)| (*count, Frame { mesh: name.clone(), ..still.clone() }));
    let costs = run("triangles", frames.collect())?;
    let axis = Axis {
        name: "triangles",
        is_log: true,
        ticks: costs.iter().map(|(x, _)| (*x, told(*x))).collect(),
    };
    write("triangles.svg", lines(&ms("one thread, 1280x720"), &axis, true, &of_stages(&costs)))?;

    let sizes = [(320, 240), (640, 480), (1280, 720), (1920, 1080), (3840, 2160)];
    let pixels = |(width, height): (u32, u32)| f64::from(width) * f64::from(height);
    let frames = sizes.map(|size| (pixels(size), Frame { size, ..still.clone() }));
    let costs = run("pixels", frames.to_vec())?;
    let ticks = sizes.map(|size| (pixels(size), format!("{}x{}", size.0, size.1)));
    let axis = Axis { name: "pixels of the window", is_log: true, ticks: ticks.to_vec() };
    write(
        "pixels.svg",
        lines(&ms("one thread, 100 k triangles"), &axis, true, &of_stages(&costs)),
    )?;

    let frames =
        [1, 2, 5, 10, 20].map(|lights| (f64::from(lights), Frame { lights, ..still.clone() }));
    let costs = run("lights", frames.to_vec())?;
    let ticks = costs.iter().map(|(x, _)| (*x, told(*x))).collect();
    let axis = Axis { name: "lights", is_log: false, ticks };
    write(
        "lights.svg",
        lines(&ms("one thread, 100 k triangles, 1280x720"), &axis, false, &of_stages(&costs)),
    )?;

    let frames =
        [1, 2, 4, 8, 16].map(|samples| (f64::from(samples), Frame { samples, ..still.clone() }));
    let costs = run("samples", frames.to_vec())?;
    let ticks = costs.iter().map(|(x, _)| (*x, told(*x))).collect();
    let axis = Axis { name: "samples a pixel", is_log: false, ticks };
    write(
        "samples.svg",
        lines(&ms("one thread, 100 k triangles, 1280x720"), &axis, false, &of_stages(&costs)),
    )?;

    let frames = [1, 2].map(|threads| (f64::from(threads), Frame { threads, ..still.clone() }));
    let costs = run("threads", frames.to_vec())?;
    let mut rows: Vec<Bar> = costs
        .iter()
        .map(|(count, cost)| {
            Bar::new(format!("{count} thread{}", if *count > 1.0 { "s" } else { "" }), cost, *count)
        })
        .collect();
    let mut seen = Vec::new();
    for simd in ["sse2", "sse4.2", "avx2", "avx512"] {
        // A machine may lack a level.
        let Ok(cost) = bench.time(&Frame { simd, ..still.clone() }) else { continue };
        if !seen.contains(&cost.simd) {
            println!(
                "{:10} {simd:>12} {:9.2} {:9.2} {:11.2} {:9.2}  {}",
                "level", cost.frame, cost.bin, cost.visibility, cost.shade, cost.simd
            );
            rows.push(Bar::new(cost.simd.clone(), &cost, 1.0));
            seen.push(cost.simd);
        }
    }
    write("threads.svg", bars(&ms("100 k triangles, 1280x720"), &rows))?;
    machine::told();
    Ok(())
}
