//! What frames cost, asked of the program.

use luxel_rivals::ball::{BALLS, ball};
use luxel_rivals::write_ply;
use std::error::Error;
use std::path::PathBuf;
use std::process::Command;

/// A frame to be timed.
#[derive(Clone)]
pub struct Frame {
    /// The mesh's name.
    pub mesh: String,
    pub size: (u32, u32),
    pub lights: u32,
    pub samples: u32,
    pub threads: u32,
    pub simd: &'static str,
}

impl Default for Frame {
    fn default() -> Self {
        let mesh = String::new();
        Self { mesh, size: (1280, 720), lights: 1, samples: 1, threads: 1, simd: "auto" }
    }
}

/// Medians in milliseconds; the stages are added up over threads.
pub struct Cost {
    pub frame: f64,
    pub bin: f64,
    pub visibility: f64,
    pub shade: f64,
    /// The level that was used.
    pub simd: String,
}

/// The program, and meshes by their numbers of triangles.
pub struct Bench {
    luxel: PathBuf,
    folder: PathBuf,
    frames: u32,
    rounds: u32,
    pub meshes: Vec<(String, f64)>,
}

impl Bench {
    /// Makes the meshes in a folder of their own.
    pub fn new(luxel: &str) -> Result<Self, Box<dyn Error>> {
        let number = |name: &str, usual: u32| {
            std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
        };
        let folder = std::env::temp_dir().join(format!("luxel-growth-{}", std::process::id()));
        std::fs::create_dir_all(&folder)?;
        let (frames, rounds) = (number("FRAMES", 15), number("ROUNDS", 3));
        let mut bench = Self { luxel: luxel.into(), folder, frames, rounds, meshes: Vec::new() };
        for (name, rings, segments) in BALLS {
            let mesh = ball(rings, segments);
            write_ply(&mesh, &bench.folder.join(format!("{name}.ply")))?;
            bench.meshes.push((name.to_owned(), mesh.triangles.len() as f64));
        }
        Ok(bench)
    }

    /// The mesh that has about so many triangles.
    pub fn nearest(&self, triangles: u32) -> String {
        let far = |count: f64| (count / f64::from(triangles)).ln().abs();
        let nearest =
            self.meshes.iter().min_by(|(_, one), (_, other)| far(*one).total_cmp(&far(*other)));
        nearest.map(|(name, _)| name.clone()).unwrap_or_default()
    }

    /// The best of some rounds: what else the machine does only ever adds.
    pub fn time(&self, frame: &Frame) -> Result<Cost, Box<dyn Error>> {
        let mut best = self.once(frame)?;
        for _ in 1..self.rounds {
            let cost = self.once(frame)?;
            if cost.frame < best.frame {
                best = cost;
            }
        }
        Ok(best)
    }

    fn once(&self, frame: &Frame) -> Result<Cost, Box<dyn Error>> {
        let mut command = Command::new(&self.luxel);
        command.arg("bench").arg(self.folder.join(format!("{}.ply", frame.mesh)));
        let line = "--eye 0,0,3 --target 0,0,0 --fov 45 --near .1 --far 10 --encoding none --cull none \
                    --environment none --reflection blinn-phong --color .8,.7,.6 --ks .4 --shininess 32 \
                    --ambient .1,.1,.1 --json";
        command.args(line.split_whitespace());
        command.args([
            "--frames",
            &self.frames.to_string(),
            "--size",
            &format!("{}x{}", frame.size.0, frame.size.1),
        ]);
        for (flag, value) in [("--samples", frame.samples), ("--threads", frame.threads)] {
            command.args([flag, &value.to_string()]);
        }
        command.args(["--simd", frame.simd]);
        command.args(["--light", "directional:dir=-.4,-.6,-1:in=camera:diffuse=.6,.6,.6"]);
        // The others stand around the camera.
        for number in 1..frame.lights {
            let angle = f64::from(number) * 2.399_963;
            let (x, y) = (1.9 * angle.cos(), 1.9 * angle.sin());
            let light = format!(
                "point:pos={x:.3},{y:.3},-1.5:in=camera:diffuse=.2,.2,.2:attenuation=1,.1,.05"
            );
            command.args(["--light", &light]);
        }
        let output = command.output()?;
        let text = String::from_utf8_lossy(&output.stdout);
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into());
        }
        let number = |of: &str, name: &str| -> Result<f64, Box<dyn Error>> {
            let all = text.split_once(&format!("\"{of}\":{{")).ok_or("no such figures")?.1;
            let rest = all.split_once(&format!("\"{name}\":")).ok_or("no such figure")?.1;
            let end = rest.find([',', '}']).ok_or("no end")?;
            Ok(rest[..end].parse()?)
        };
        let simd = text.split_once("\"simd\":\"").and_then(|(_, rest)| rest.split_once('"'));
        Ok(Cost {
            frame: number("frame_ms", "median")?,
            bin: number("stages_ms", "bin")?,
            visibility: number("stages_ms", "visibility")?,
            shade: number("stages_ms", "shade")?,
            simd: simd.ok_or("no level")?.0.to_owned(),
        })
    }
}

impl Drop for Bench {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}
