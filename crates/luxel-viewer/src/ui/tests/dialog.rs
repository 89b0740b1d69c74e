//! The dialog for a model.

use super::*;

/// Types into the open dialog, letter by letter, and presses Enter; the path that it opens.
fn opened(stage: &mut Stage, events: Vec<Event>) -> Option<std::path::PathBuf> {
    stage.ui.dialog = Some(PathCompletion::beside("demo:plane".as_ref()));
    stage.pass(Vec::new());
    stage.pass(Vec::new());
    for event in events {
        stage.pass(vec![event]);
    }
    stage.press(Key::Enter);
    stage.commands.drain(..).find_map(|command| match command {
        UiCommand::Open(path) => Some(path),
        _ => None,
    })
}

#[test]
fn a_typed_or_pasted_path_from_the_root_replaces_the_dialog_s_text() {
    let mut stage = Stage::new("plane", (640, 480));
    let name = format!("luxel-dialog-{}.stl", std::process::id());
    let path = std::env::temp_dir().join(name);
    std::fs::write(&path, "").unwrap();
    let text = path.display().to_string();
    let typed = text.chars().map(|letter| Event::Text(letter.to_string())).collect();
    assert_eq!(opened(&mut stage, typed), Some(path.clone()), "typed");
    assert_eq!(opened(&mut stage, vec![Event::Text(text.clone())]), Some(path.clone()), "at once");
    assert_eq!(opened(&mut stage, vec![Event::Paste(text.clone())]), Some(path.clone()), "pasted");
    let behind_a_name = vec![Event::Text("Car".to_owned()), Event::Paste(text)];
    assert_eq!(opened(&mut stage, behind_a_name), Some(path.clone()), "pasted behind a name");
    std::fs::remove_file(path).unwrap();
}
