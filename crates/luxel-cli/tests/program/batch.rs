//! `luxel batch`: lists of tasks, drawn by worker processes.

use crate::program::{Folder, Run, SQUARE_PLY};
use luxel_batch::Digest;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// A folder with a model and a list of tasks.
fn folder_of(tasks: &[Value]) -> Folder {
    let folder = Folder::new();
    folder.write("square.ply", SQUARE_PLY);
    let lines: Vec<String> = tasks.iter().map(Value::to_string).collect();
    folder.write("tasks.jsonl", lines.join("\n"));
    folder
}

/// Many small tasks, whose outputs all differ.
fn many(count: u32) -> Vec<Value> {
    let task = |number: u32| {
        json!({
            "id": format!("task {number}"),
            "model": if number.is_multiple_of(2) { "square.ply" } else { "demo:plane" },
            "views": [{"azimuth": number}, {"azimuth": number, "elevation": 60}],
            "size": "24x16",
            "samples": 1,
            "layers": ["rgba", "z"],
        })
    };
    (0..count).map(task).collect()
}

fn batch(folder: &Folder, out: &str, flags: &[&str]) -> Run {
    let mut line = vec!["batch", "tasks.jsonl", "-o", out, "-q", "--json"];
    line.extend(flags);
    folder.run(line)
}

#[track_caller]
fn manifest(folder: &Folder, out: &str) -> Value {
    serde_json::from_slice(&folder.read(&format!("{out}/manifest.json"))).unwrap()
}

#[track_caller]
fn root(folder: &Folder, out: &str, flags: &[&str]) -> String {
    let report = batch(folder, out, flags).json();
    let root = report["root"].as_str().unwrap().to_owned();
    assert_eq!(manifest(folder, out)["root"], root, "report and manifest differ");
    root
}

/// All files below a folder.
fn files(folder: &Path) -> BTreeSet<PathBuf> {
    let mut found = BTreeSet::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => found.extend(files(&path)),
            false => drop(found.insert(path)),
        }
    }
    found
}

/// The names of the entries of a tar archive.
fn entries(archive: &[u8]) -> Vec<String> {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).trim_matches('\0').to_owned();
    let (mut names, mut place) = (Vec::new(), 0);
    while archive[place] != 0 {
        names.push(text(&archive[place..place + 100]));
        let length = usize::from_str_radix(&text(&archive[place + 124..place + 136]), 8).unwrap();
        place += 512 + length.next_multiple_of(512);
    }
    names
}

/// Every output of the manifest is there with its digest, and nothing else is.
#[track_caller]
fn check_whole(folder: &Folder, out: &str) {
    let manifest = manifest(folder, out);
    let out = folder.path(out);
    let mut expected = BTreeSet::new();
    for output in manifest["outputs"].as_array().unwrap() {
        let path = out.join(output["path"].as_str().unwrap());
        let bytes = fs::read(&path).unwrap();
        assert_eq!(Digest::of(&bytes).to_string(), output["sha256"].as_str().unwrap());
        expected.insert(path);
    }
    let is_output = |path: &PathBuf| path.components().count() > out.components().count() + 1;
    let found: BTreeSet<_> = files(&out).into_iter().filter(is_output).collect();
    assert_eq!(found, expected, "files without a line in the manifest, or lines without a file");
}

fn start(folder: &Folder, out: &str, flags: &[&str]) -> Child {
    Command::new(env!("CARGO_BIN_EXE_luxel"))
        .args(["batch", "tasks.jsonl", "-o", out, "-q"])
        .args(flags)
        .current_dir(folder.path(""))
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap()
}

#[test]
fn outputs_have_other_bytes_than_render() {
    let folder = folder_of(&[json!({
        "id": "a",
        "model": "demo:spheres",
        "views": [{"azimuth": 70, "elevation": -10, "name": "low"}],
        "orbit": {"count": 3, "elevation": 35},
        "size": "60x40",
        "layers": ["rgba", "z", "normal.exr", "object.png", "rgba.exr"],
        "light": ["directional:dir=-1,-2,-1", "ambient:color=.2,.2,.2"],
        "shadows": true,
        "background": [1, 1, 1],
        "fov": 30,
    })]);
    batch(&folder, "out", &[]).json();
    let outputs = manifest(&folder, "out")["outputs"].as_array().unwrap().clone();
    assert_eq!(outputs.len(), 4 * 5);
    let common = "render demo:spheres --size 60x40 --fov 30 --shadows --background 1,1,1 \
                  --light directional:dir=-1,-2,-1 --light ambient:color=.2,.2,.2";
    for (number, (layer, extension)) in
        [("", "png"), ("z", "npy"), ("normal", "exr"), ("object", "png"), ("", "exr")]
            .into_iter()
            .enumerate()
    {
        let layer = if layer.is_empty() { String::new() } else { format!("--layer {layer}") };
        let single = format!("{common} {layer} --azimuth 70 --elevation -10 -o single.{extension}");
        folder.run(single.split_whitespace()).done();
        let turned = format!("{common} {layer} --elevation 35 --turntable 3 -o t{{n}}.{extension}");
        folder.run(turned.split_whitespace()).done();
        let names = ["single", "t0", "t1", "t2"];
        for (view, name) in names.iter().enumerate() {
            let output = &outputs[5 * view + number];
            assert_eq!(output["view"], view);
            assert_eq!(output["name"].as_str(), (view == 0).then_some("low"));
            let path = format!("out/{}", output["path"].as_str().unwrap());
            let expected = folder.read(&format!("{name}.{extension}"));
            assert!(folder.read(&path) == expected, "{name} {layer} .{extension}");
        }
    }
}

#[test]
fn the_root_depends_on_workers_shards_archives_or_order() {
    let mut tasks = many(24);
    let folder = folder_of(&tasks);
    let one = root(&folder, "one", &["--workers", "1"]);
    assert_eq!(root(&folder, "four", &["--workers", "4"]), one);
    assert_eq!(root(&folder, "archives", &["--tar", "20K"]), one);
    assert!(folder.path("archives/outputs-00001.tar").exists());
    for part in ["1/3", "2/3", "3/3"] {
        batch(&folder, "parts", &["--shard", part]).json();
        assert!(!folder.path("parts/manifest.json").exists());
    }
    let joined = batch(&folder, "parts", &[]).json();
    assert_eq!(
        [&joined["drawn"], &joined["whole"], &joined["root"]],
        [&json!(0), &json!(24), &json!(one)]
    );
    tasks.reverse();
    let lines: Vec<String> = tasks.iter().map(Value::to_string).collect();
    folder.write("tasks.jsonl", lines.join("\n\n"));
    assert_eq!(root(&folder, "reversed", &[]), one);
    for out in ["one", "four", "parts", "reversed"] {
        check_whole(&folder, out);
    }
    for out in ["one", "archives"] {
        let line = ["batch", "verify", "tasks.jsonl", out, "--sample", "3", "-q"];
        folder.run(line).done();
    }
}

#[test]
fn tasks_of_the_same_content_end_a_run_into_archives_or_are_stored_twice() {
    let copies = |task: Value| {
        (0..9).map(move |copy| {
            let mut task = task.clone();
            task["id"] = json!(format!("{} {copy}", task["id"]));
            task
        })
    };
    let tasks: Vec<Value> = many(20).into_iter().flat_map(copies).collect();
    let folder = folder_of(&tasks);
    let expected = root(&folder, "folder", &["--workers", "3"]);
    assert_eq!(root(&folder, "archives", &["--workers", "3", "--tar", "20K"]), expected);
    let mut names = BTreeSet::new();
    for path in files(&folder.path("archives")) {
        if path.extension().is_some_and(|extension| extension == "tar") {
            for name in entries(&fs::read(path).unwrap()) {
                assert!(names.insert(name.clone()), "{name} is there twice");
            }
        }
    }
    assert_eq!(names.len(), 20 * 4);
    let verify = ["batch", "verify", "tasks.jsonl", "archives", "--sample", "5", "-q"];
    folder.run(verify).done();
    assert_eq!(batch(&folder, "archives", &["--tar", "20K"]).json()["whole"], 180);
}

#[test]
#[cfg(target_os = "linux")]
fn a_limit_of_files_ends_the_program_without_a_word() {
    let folder = folder_of(&many(40));
    let run = Command::new("sh")
        .args(["-c", "ulimit -f 4; exec \"$0\" batch tasks.jsonl -o out -q"])
        .arg(env!("CARGO_BIN_EXE_luxel"))
        .current_dir(folder.path(""))
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&run.stderr);
    assert_eq!(run.status.code(), Some(1), "{said}");
    assert!(said.contains("log.jsonl: File too large"), "{said}");
}

#[test]
fn a_killed_run_leaves_partial_files_or_draws_whole_tasks_again() {
    let folder = folder_of(&many(60));
    let expected = root(&folder, "whole", &[]);
    for (out, flags) in [("files", &["--workers", "2"][..]), ("archives", &["--tar", "30K"])] {
        let mut known = 0;
        for kill in 0..8 {
            let mut run = start(&folder, out, flags);
            std::thread::sleep(Duration::from_millis(20 + 17 * kill));
            run.kill().unwrap();
            run.wait().unwrap();
            let log = fs::read(folder.path(out).join("log.jsonl")).unwrap_or_default();
            let lines = log.iter().filter(|&&byte| byte == b'\n').count();
            assert!(lines >= known, "a line of the log was lost");
            known = lines;
        }
        let report = batch(&folder, out, flags).json();
        assert_eq!(report["root"], json!(expected), "{out}");
        assert_eq!(report["whole"], known, "tasks in the log were drawn again");
        if out == "files" {
            check_whole(&folder, out);
        }
        folder.run(["batch", "verify", "tasks.jsonl", out, "--sample", "2", "-q"]).done();
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_killed_worker_costs_a_task() {
    let folder = folder_of(&many(60));
    let expected = root(&folder, "whole", &[]);
    let mut run = start(&folder, "out", &["--workers", "2"]);
    let parent = format!("PPid:\t{}\n", run.id());
    let mut killed = 0;
    while run.try_wait().unwrap().is_none() {
        for entry in fs::read_dir("/proc").unwrap().filter_map(Result::ok) {
            let status = fs::read_to_string(entry.path().join("status")).unwrap_or_default();
            if status.contains(&parent) && killed < 12 {
                let pid = entry.file_name();
                killed += usize::from(
                    Command::new("kill").arg("-9").arg(pid).status().unwrap().success(),
                );
            }
        }
        std::thread::sleep(Duration::from_millis(15));
    }
    assert!(killed > 0, "nothing was killed");
    // Whatever was lost three times is drawn now.
    assert_eq!(root(&folder, "out", &[]), expected);
    check_whole(&folder, "out");
}

#[cfg(unix)]
#[test]
fn a_machine_that_is_taken_away_is_a_failure() {
    let folder = folder_of(&many(400));
    let mut run = start(&folder, "out", &["--workers", "1"]);
    while !folder.path("out/log.jsonl").exists() {
        std::thread::sleep(Duration::from_millis(5));
    }
    std::thread::sleep(Duration::from_millis(100));
    Command::new("kill").arg(run.id().to_string()).status().unwrap();
    let status = run.wait().unwrap();
    if !folder.path("out/manifest.json").exists() {
        assert_eq!(status.code(), Some(0));
        let log = folder.read("out/log.jsonl");
        assert!(log.ends_with(b"\n"), "a line is torn");
        for line in log.split(|&byte| byte == b'\n').filter(|line| !line.is_empty()) {
            serde_json::from_slice::<Value>(line).unwrap();
        }
    }
    batch(&folder, "out", &[]).json();
    check_whole(&folder, "out");
}

#[test]
fn a_hostile_task_costs_more_than_itself() {
    let slow = json!({"id": "slow", "model": "demo:blob", "size": "3000x3000", "samples": 16, "ao": true, "ao-rays": 4096});
    let huge =
        json!({"id": "huge", "model": "square.ply", "size": "16384x16384", "layers": ["normal"]});
    let mut tasks = many(6);
    tasks.insert(1, slow);
    tasks.insert(3, huge);
    let folder = folder_of(&tasks);
    let flags = ["--time-limit", "1", "--tries", "2", "--max-memory", "300M", "--workers", "2"];
    let run = batch(&folder, "out", &flags);
    assert_eq!(run.status, Some(1));
    let manifest = manifest(&folder, "out");
    let failed = manifest["failed"].as_array().unwrap();
    let said = |number: usize| failed[number]["error"].as_str().unwrap().to_owned();
    assert_eq!([&failed[0]["id"], &failed[1]["id"]], ["slow", "huge"]);
    assert_eq!(said(0), "it took longer than 1 seconds, 2 times");
    assert!(said(1).contains("the limit is 314572800"), "{}", said(1));
    assert_eq!(manifest["outputs"].as_array().unwrap().len(), 6 * 4);
    check_whole(&folder, "out");
}

#[test]
fn broken_lines_end_the_run_or_have_no_place() {
    let folder = folder_of(&many(1));
    let tasks = String::from_utf8(folder.read("tasks.jsonl")).unwrap();
    let broken = [
        "{\"id\": \"a\", \"model\": \"square.ply\", \"sise\": \"8x8\"}",
        "{\"id\": \"b\", \"model\": \"square.ply\", \"size\": \"8y8\"}",
        "not JSON",
        "{\"id\": \"task 0\", \"model\": \"square.ply\"}",
        "{\"id\": \"c\", \"model\": \"missing.ply\"}",
        "{\"id\": \"d\", \"model\": \"square.ply\", \"views\": [{\"color\": \"red\"}]}",
    ];
    folder.write("tasks.jsonl", format!("{tasks}\n\n{}\n", broken.join("\n")));
    let run = batch(&folder, "out", &[]);
    assert_eq!(run.status, Some(1));
    let manifest = manifest(&folder, "out");
    let failed: Vec<(Option<&str>, &str)> = manifest["failed"]
        .as_array()
        .unwrap()
        .iter()
        .map(|task| (task["id"].as_str(), task["error"].as_str().unwrap()))
        .collect();
    let expected = [
        (Some("a"), "tasks.jsonl:3: `sise` is unknown: did you mean `size`?"),
        (Some("b"), "tasks.jsonl:4: `size`: "),
        (None, "tasks.jsonl:5: a task is a JSON object"),
        (Some("task 0"), "tasks.jsonl:6: the id `task 0` is there twice"),
        (Some("c"), "missing.ply: No such file"),
        (Some("d"), "tasks.jsonl:8: `views`, number 0: `color` changes the model"),
    ];
    assert_eq!(failed.len(), expected.len(), "{failed:?}");
    for ((id, error), (expected_id, begins)) in failed.into_iter().zip(expected) {
        assert_eq!(id, expected_id);
        assert!(error.starts_with(begins), "{error}");
    }
    assert_eq!(manifest["outputs"].as_array().unwrap().len(), 4);
}

#[test]
fn what_is_torn_lost_or_changed_is_not_drawn_again() {
    let folder = folder_of(&many(8));
    let expected = root(&folder, "out", &[]);
    let log = folder.path("out/log.jsonl");
    let mut torn = fs::read(&log).unwrap();
    torn.extend_from_slice(b"{\"task\":\"00");
    fs::write(&log, torn).unwrap();
    let manifest = manifest(&folder, "out");
    let path = |number: usize| {
        folder.path("out").join(manifest["outputs"][number]["path"].as_str().unwrap())
    };
    fs::remove_file(path(0)).unwrap();
    fs::write(path(9), b"half").unwrap();
    let report = batch(&folder, "out", &[]).json();
    assert_eq!(
        [&report["drawn"], &report["whole"], &report["root"]],
        [&json!(2), &json!(6), &json!(expected)]
    );
    check_whole(&folder, "out");
    // Another model under the same name: half of the tasks.
    folder.write("square.ply", SQUARE_PLY.replace("1 1 0", "1 2 0"));
    let changed = batch(&folder, "out", &[]).json();
    assert_eq!([&changed["drawn"], &changed["whole"]], [&json!(4), &json!(4)]);
    assert_ne!(changed["root"], json!(expected));
}

#[test]
fn verifying_overlooks_a_changed_byte_or_a_wrong_root() {
    let folder = folder_of(&many(5));
    root(&folder, "out", &[]);
    let verify = |flags: &[&str]| {
        let mut line = vec!["batch", "verify", "tasks.jsonl", "out", "-q"];
        line.extend(flags);
        folder.run(line)
    };
    verify(&["--sample", "all"]).done();
    let manifest = manifest(&folder, "out");
    let path = folder.path("out").join(manifest["outputs"][3]["path"].as_str().unwrap());
    let sound = fs::read(&path).unwrap();
    let mut flipped = sound.clone();
    *flipped.last_mut().unwrap() ^= 1;
    fs::write(&path, flipped).unwrap();
    let run = verify(&["--sample", "0"]);
    assert_eq!(run.status, Some(1));
    assert!(String::from_utf8(run.stdout).unwrap().contains("its SHA-256 is"));
    fs::write(&path, sound).unwrap();
    // Digest and file agree, but nothing draws such bytes.
    let other = manifest["outputs"][0]["sha256"].as_str().unwrap();
    let forged =
        manifest.to_string().replacen(manifest["outputs"][3]["sha256"].as_str().unwrap(), other, 1);
    folder.write("out/manifest.json", forged);
    let run = verify(&["--sample", "all"]);
    assert_eq!(run.status, Some(1));
    let said = String::from_utf8(run.stdout).unwrap();
    assert!(said.contains("its root is") && said.contains("drawn again"), "{said}");
}

#[test]
fn a_folder_that_can_not_be_written_is_found_after_the_work() {
    let folder = folder_of(&many(2));
    folder.write("file", "");
    batch(&folder, "file", &[]).failed(1, "can't be written: file");
    folder.run(["batch", "none.jsonl", "-o", "out"]).failed(1, "none.jsonl: No such file");
    folder.run(["batch", "tasks.jsonl"]).failed(2, "--output");
    batch(&folder, "out", &["--shard", "3/2"]).failed(2, "use I/N");
    folder.run(["batch", "verify", "tasks.jsonl", "empty"]).failed(1, "manifest.json");
}

#[test]
fn tasks_of_the_standard_input_are_not_drawn() {
    let folder = folder_of(&[]);
    let task = json!({"id": "a", "model": "square.ply", "size": "8x8"}).to_string();
    let run = folder.run_with_input(["batch", "-", "-o", "out", "-q", "--json"], task.as_bytes());
    assert_eq!(run.json()["drawn"], 1);
}
