//! Logs as text.

use crate::stage::{LENS, MODES, deviation, settings, somewhere};
use glam::{DMat4, DVec2, DVec3};
use luxel_navigation::{
    Change, Entry, Event, Gesture, Log, LogErrorKind, Mode, Number, StandardView,
};
use luxel_scene::{Bounds, Camera, Lens, Size};
use proptest::prelude::*;

fn numbers() -> impl Strategy<Value = f64> {
    use prop::num::f64::{NEGATIVE, NORMAL, POSITIVE, SUBNORMAL, ZERO};
    prop_oneof![-2000.0..2000.0, NORMAL | SUBNORMAL | ZERO | POSITIVE | NEGATIVE]
}

fn vectors() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(numbers()).prop_map(DVec3::from_array)
}

fn places() -> impl Strategy<Value = DVec2> {
    prop::array::uniform2(numbers()).prop_map(DVec2::from_array)
}

fn views() -> impl Strategy<Value = DMat4> {
    (prop::array::uniform3(-9.0..9.0), prop::array::uniform3(-9.0..9.0)).prop_map(|(eye, at)| {
        Camera::look_at(DVec3::from_array(eye), DVec3::from_array(at), DVec3::Y)
    })
}

fn commands() -> impl Strategy<Value = luxel_navigation::Command> {
    prop::sample::select(vec!["x+", "turn-y-", "target-z+", "forward", "roll-left", "slower"])
        .prop_map(|name| name.parse().unwrap())
}

fn events() -> impl Strategy<Value = Event> {
    let gestures = prop::sample::select(vec![Gesture::Turn, Gesture::Pan, Gesture::Zoom]);
    prop_oneof![
        Just(Event::Wait),
        Just(Event::Release),
        Just(Event::Level),
        Just(Event::Mode(Mode::RollingBall)),
        Just(Event::View(StandardView::Bottom)),
        Just(Event::Fit(None)),
        (gestures, places(), prop::option::of(vectors()))
            .prop_map(|(gesture, at, point)| Event::Grab { gesture, at, point }),
        places().prop_map(|at| Event::Drag { at }),
        (numbers(), places(), prop::option::of(vectors()))
            .prop_map(|(notches, at, point)| Event::Wheel { notches, at, point }),
        commands().prop_map(Event::Press),
        commands().prop_map(Event::Lift),
        (commands(), numbers()).prop_map(|(command, steps)| Event::Tap { command, steps }),
        vectors().prop_map(Event::Pivot),
        (vectors(), vectors())
            .prop_map(|(a, b)| Event::Fit(Some(Bounds { min: a.min(b), max: a.max(b) }))),
        views().prop_map(Event::Place),
        (views(), vectors(), 1e-9..1e9).prop_map(|(view_from_world, pivot, scale)| Event::Go {
            view_from_world,
            pivot,
            scale
        }),
    ]
}

fn entries() -> impl Strategy<Value = Entry> {
    prop_oneof![
        4 => (prop_oneof![Just(0.0), 0.0..10.0], events())
            .prop_map(|(seconds, event)| Entry::Event { seconds, event }),
        1 => (1..9999_u32, 1..9999_u32)
            .prop_map(|(width, height)| Entry::Set(Change::Size(Size { width, height }))),
        1 => (0.1..3.0).prop_map(|fov_y_radians| {
            Entry::Set(Change::Lens(Lens::Perspective { fov_y_radians }))
        }),
        1 => (1.0..9.0, 1.0..9.0, numbers(), numbers()).prop_map(|(fx, fy, cx, cy)| {
            Entry::Set(Change::Lens(Lens::Intrinsics { fx, fy, cx, cy }))
        }),
        1 => (0.0..1e9).prop_map(|value| Entry::Set(Change::Number(Number::MoveRate, value))),
    ]
}

fn bits(log: &Log) -> String {
    // Zeros of either sign are equal, but not the same bits; Debug tells them apart.
    format!("{log:?}")
}

proptest! {
    #[test]
    fn what_is_written_reads_back_to_the_bit(entries in prop::collection::vec(entries(), 0..30)) {
        let log = Log { entries };
        let text = log.to_string();
        let again: Log = text.parse().unwrap();
        prop_assert_eq!(bits(&log), bits(&again));
    }

    #[test]
    fn numbers_of_any_size_leave_a_rotation_at_a_place(
        entries in prop::collection::vec(entries(), 0..30),
        mode in prop::sample::select(MODES.to_vec()),
    ) {
        let start = (somewhere(mode), settings(LENS));
        let end = entries.iter().fold(start, |(state, settings), entry| entry.play(&state, &settings));
        let view = end.0.view_from_world();
        prop_assert!(view.is_finite(), "{view}");
        prop_assert!(end.0.pivot().is_finite(), "{}", end.0.pivot());
        prop_assert!(deviation(&end.0) < 1e-12, "{view}");
    }

    #[test]
    fn any_text_is_a_log_or_an_error(text in "(luxel-navigation 1\n)?([+ a-z0-9.#-]{0,20}\n){0,5}") {
        let _ = text.parse::<Log>();
    }
}

#[test]
fn a_log_of_all_settings_sets_them() {
    let original = settings(LENS).with(Number::Inertia, 0.1).with(Number::BallRadius, 77.0);
    let entries = Change::all_of(&original).map(Entry::Set).collect();
    let log: Log = Log { entries }.to_string().parse().unwrap();
    let other = luxel_navigation::Settings::new(
        Bounds::EMPTY,
        DVec3::Z,
        Lens::Orthographic { height: 1.0 },
        Size { width: 1, height: 1 },
    );
    let set = log.entries.iter().fold(other, |settings, entry| match entry {
        Entry::Set(change) => change.apply(&settings),
        Entry::Event { .. } => settings,
    });
    assert_eq!(set, original);
}

#[test]
fn errors_name_their_line() {
    let error = |text: &str| text.parse::<Log>().unwrap_err();
    for (text, line, expected) in [
        ("", 1, "a log begins with"),
        ("\n# nothing\n", 1, "a log begins with"),
        ("mode flying\n", 1, "a log begins with"),
        ("luxel-navigation 2\n", 1, "version `2`"),
        ("luxel-navigation 1 x\n", 1, "`x` is too much"),
        ("luxel-navigation 1\n\n# a\njump 3\n", 4, "no event `jump`"),
        ("luxel-navigation 1\nmode ball\n", 2, "no mode `ball`: use absolute, look-at"),
        ("luxel-navigation 1\nwait\ngrab turn 1\n", 3, "a place's y is missing"),
        ("luxel-navigation 1\ngrab hold 1 2\n", 2, "no gesture `hold`"),
        ("luxel-navigation 1\ndrag 1 2 3\n", 2, "`3` is too much"),
        ("luxel-navigation 1\ndrag 1 nan\n", 2, "`nan` is not a finite number"),
        ("luxel-navigation 1\ndrag 1e999 1\n", 2, "`1e999` is not a finite number"),
        ("luxel-navigation 1\n+x drag 1 1\n", 2, "`x` is not a finite number"),
        ("luxel-navigation 1\n+-1 drag 1 1\n", 2, "time can't be -1"),
        ("luxel-navigation 1\n+1\n", 2, "an event is missing"),
        ("luxel-navigation 1\ntap jump\n", 2, "no command `jump`"),
        ("luxel-navigation 1\nset\n", 2, "the setting's name is missing"),
        ("luxel-navigation 1\nset speed 1\n", 2, "no setting `speed`"),
        ("luxel-navigation 1\nset size 0 3\n", 2, "a width can't be 0"),
        ("luxel-navigation 1\nset wheel-factor 0.5\n", 2, "wheel-factor can't be 0.5"),
        ("luxel-navigation 1\nset up 0 0 0\n", 2, "an axis can't be 0 0 0"),
        ("luxel-navigation 1\nset lens perspective 3.2\n", 2, "can't be 3.2"),
        ("luxel-navigation 1\nset lens fisheye 1\n", 2, "no lens `fisheye`"),
        ("luxel-navigation 1\nfit 1 1 1 0 0 0\n", 2, "a box can't be upside down"),
        ("luxel-navigation 1\nplace 2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1\n", 2, "not a rotation"),
        ("luxel-navigation 1\nplace 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0\n", 2, "16 numbers is missing"),
    ] {
        let found = error(text);
        assert_eq!(found.line, line, "{text}");
        assert!(found.to_string().contains(expected), "{text}: {found}");
    }
    assert_eq!(error("x").kind, LogErrorKind::NoLog);
}

#[test]
fn a_number_that_is_none_is_refused_wherever_it_stands() {
    let lines = [
        "set size 1280 720",
        "set up 0 0 1",
        "set bounds -1 -1 -1 1 1 1",
        "set lens perspective 0.8",
        "set lens orthographic 2",
        "set lens intrinsics 700 700 320 240",
        "set wheel-factor 1.1",
        "+0.5 wait",
        "grab turn 640 360",
        "grab pan 640 360 on 1 2 3",
        "drag 652.5 360",
        "wheel -1 3 4 on 0.5 -0 1e-7",
        "tap x+ 2",
        "pivot 1 2 3",
        "fit -1 -1 -1 1 1 1",
        "place 1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1",
        "go 1 0 0 0 0 1 0 0 0 0 1 0 0 0 -5 1 0 0 0 1",
    ];
    for line in lines {
        let sound = format!("luxel-navigation 1\nwait\n{line}\n");
        assert!(sound.parse::<Log>().is_ok(), "{line}");
        let words: Vec<_> = line.split(' ').collect();
        let is_number = |word: &&str| word.parse::<f64>().is_ok();
        let numbers = (0..words.len()).filter(|at| is_number(&words[*at])).count();
        assert!(numbers > 0, "{line}");
        for at in (0..words.len()).filter(|at| is_number(&words[*at])) {
            for none in ["nan", "-NaN", "inf", "-inf", "infinity", "1e999", "+nan"] {
                // What begins with a plus is a time.
                let sign = if words[at].starts_with('+') { "+" } else { "" };
                let mut words: Vec<_> = words.iter().map(ToString::to_string).collect();
                words[at] = format!("{sign}{none}");
                let text = format!("luxel-navigation 1\nwait\n{}\n", words.join(" "));
                let error = text.parse::<Log>().unwrap_err();
                assert_eq!(error.line, 3, "{text}");
                assert!(error.to_string().contains(none), "{text}: {error}");
            }
        }
    }
}

#[test]
fn the_text_is_the_one_that_is_documented() {
    let text = "luxel-navigation 1\nset size 1280 720\nmode rolling-ball\ngrab turn 640 360\n\
                +0.016 drag 652.5 360\nwheel -1 3 4 on 0.5 -0 1e-7\nrelease\ntap x+ 2\ntap x-\n";
    let log: Log = text.parse().unwrap();
    assert_eq!(log.to_string(), text);
    let (_, lines) = Log::with_lines("# a\nluxel-navigation 1\n\nwait # now\n  \nfit\n").unwrap();
    assert_eq!(lines, [4, 6]);
}
