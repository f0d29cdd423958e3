//! Comments, layout and expressions.

use super::random::{operation, program};
use seamwright_program::Program;
use seamwright_program::edit::{Editor, Operation};
use seamwright_testkit::{Random, cases};

fn lost(text: &str, comments: usize) -> Vec<String> {
    let each = (1..=comments).flat_map(|i| [format!("# line {i}."), format!("# behind {i}.")]);
    let found = each.filter(|comment| text.contains(comment.as_str())).count();
    (found < comments).then(|| format!("{found} of {comments}")).into_iter().collect()
}

/// Operations that remove the subject of comments.
const TAKING: [&str; 7] =
    ["delete_points", "delete_pass", "delete_event", "reduce", "join_spans", "reverse_pass", "shift_start"];

#[test]
fn comments_survive_what_takes_nothing_away() {
    for seed in 0..cases(400) {
        let mut random = Random::of_case(10_000 + seed);
        let (text, comments) = program(&mut random);
        let mut editor = Editor::new("p.toml", &text).unwrap();
        for _ in 0..4 {
            let wanted = operation(&mut random, editor.program(), &[&TAKING[..], &["set_offset"]].concat());
            let before = editor.text().to_owned();
            let _ = editor.apply(&wanted);
            assert!(
                lost(editor.text(), comments).is_empty(),
                "seed {seed}: {wanted:?}\n{before}\n====\n{}",
                editor.text()
            );
        }
    }
}

#[test]
fn formatting_is_idempotent_and_keeps_program_and_comments() {
    for seed in 0..cases(400) {
        let (text, comments) = program(&mut Random::of_case(20_000 + seed));
        let mut editor = Editor::new("p.toml", &text).unwrap();
        let before = editor.program().clone();
        editor.apply(&Operation::Format).unwrap_or_else(|e| panic!("seed {seed}: {e}\n{text}"));
        assert_eq!(*editor.program(), before);
        let once = editor.text().to_owned();
        assert!(lost(&once, comments).is_empty(), "seed {seed}: {:?}\n{text}\n====\n{once}", lost(&once, comments));
        assert_eq!(text.matches("\"= ").count(), once.matches("\"= ").count(), "seed {seed}\n{text}\n====\n{once}");
        assert!(!editor.apply(&Operation::Format).unwrap().changed, "seed {seed}\n{once}\n====\n{}", editor.text());
        // Without comments and expressions it is the usual text of a program.
        let plain = Program::read("p.toml", &text).unwrap().value.to_toml().unwrap();
        let mut editor = Editor::new("p.toml", &plain).unwrap();
        assert!(!editor.apply(&Operation::Format).unwrap().changed);
    }
}

const TEXT: &str = "# mine
schema = 1
title = \"t\"
machine = \"m\" # the small one
variables = { lift = 3 }

[[passes]]
name = \"root\"

[passes.points] # by hand
columns = [\"x_mm\", \"y_mm\", \"z_mm\", \"current_a\", \"time_s\"]
start = [0, 0, 0, 100, 0] # home
events = [{ after = 1, gas = true }]

[[passes.points.spans]]
along = \"line\"
points = [ # the table
    [10, 0, 0.50, 100, 1.0], # first
    # the clamp is here
    [20, 0, \"= lift\", 100, 1], # second
    [30, 0, 0, 100, 1] # third
]
";

fn edited(operation: &str) -> String {
    let mut editor = Editor::new("p.toml", TEXT).unwrap();
    editor.apply(&serde_json::from_str(operation).unwrap()).unwrap_or_else(|e| panic!("{e}"));
    editor.text().to_owned()
}

#[test]
fn only_what_is_edited_changes() {
    let set = edited(r#"{"op":"set_point","pass":1,"point":1,"set":{"y_mm":2.5}}"#);
    assert_eq!(set, TEXT.replace("[10, 0, 0.50,", "[10, 2.5, 0.50,"));
    let start = edited(r#"{"op":"set_point","pass":1,"point":0,"set":{"x_mm":-1}}"#);
    assert_eq!(start, TEXT.replace("start = [0,", "start = [-1,"));
    let deleted = edited(r#"{"op":"delete_points","pass":1,"from":1}"#);
    let rest = TEXT
        .replace("    [10, 0, 0.50, 100, 1.0], # first\n", "")
        .replace("\"= lift\", 100, 1]", "\"= lift\", 100, 2]");
    assert_eq!(deleted, rest.replace("after = 1", "after = 0"));
    assert_eq!(edited(r#"{"op":"set_variable","name":"lift","value":4}"#), TEXT.replace("lift = 3", "lift = 4"));
    let inserted = edited(r#"{"op":"insert_point","pass":1,"after":1}"#);
    let between = "    [10, 0, 0.50, 100, 1.0], # first\n    [15, 0, 1.75, 100, 0.5],\n    # the clamp is here\n";
    let wanted = TEXT.replace("    [10, 0, 0.50, 100, 1.0], # first\n    # the clamp is here\n", between);
    assert_eq!(inserted, wanted.replace("\"= lift\", 100, 1]", "\"= lift\", 100, 0.5]"));
}

#[test]
fn comments_go_with_their_points() {
    let turned = edited(r#"{"op":"reverse_pass","pass":1}"#);
    for line in [
        "    [20, 0, \"= lift\", 100, 1], # second\n",
        "    # the clamp is here\n    [20,",
        "    [10, 0, 0.50, 100, 1.0], # first\n",
    ] {
        assert!(turned.contains(line), "{turned}");
    }
    assert!(turned.contains("start = [30, 0, 0, 100, 0] # home"), "{turned}");
}
