//! Every edit can be undone, byte by byte.

use super::random::{operation, program};
use seamwright_message::Message;
use seamwright_program::Program;
use seamwright_program::edit::{Editor, History, Operation, Patch};
use seamwright_testkit::{Random, cases};
use std::collections::BTreeMap;

#[test]
fn every_sequence_of_edits_gives_programs_and_goes_back() {
    let (mut accepted, mut refused) = (0, 0);
    let mut kinds: BTreeMap<String, [usize; 2]> = BTreeMap::new();
    for seed in 0..cases(300) {
        let mut random = Random::of_case(seed);
        let (text, _) = program(&mut random);
        let mut editor = Editor::new("p.toml", &text).unwrap_or_else(|e| panic!("seed {seed}: {e}\n{text}"));
        let mut texts = vec![text];
        for _ in 0..8 {
            let wanted = operation(&mut random, editor.program(), &[]);
            let name = serde_json::to_value(&wanted).unwrap()["op"].as_str().unwrap().to_owned();
            let before = (editor.text().to_owned(), editor.history().clone());
            match editor.apply(&wanted) {
                Ok(report) => {
                    assert_eq!(report.changed, before.0 != editor.text());
                    assert_ne!(report.words.code, "text");
                    kinds.entry(name).or_default()[0] += 1;
                    accepted += 1;
                }
                Err(e) => {
                    assert!(e.message.code != "program-edit-layout", "seed {seed}: {wanted:?}: {e}\n{}", before.0);
                    assert_eq!((editor.text(), editor.history()), (before.0.as_str(), &before.1));
                    kinds.entry(name).or_default()[1] += 1;
                    refused += 1;
                }
            }
            let read =
                Program::read("p.toml", editor.text()).unwrap_or_else(|e| panic!("seed {seed}: {wanted:?}: {e}"));
            assert_eq!(&read.value, editor.program());
            if editor.text() != texts[texts.len() - 1] {
                texts.push(editor.text().to_owned());
            }
            // Now and then a step back and another way.
            if random.below(6) == 0 && editor.undo().unwrap().is_some() {
                texts.pop();
                assert_eq!(editor.text(), texts[texts.len() - 1]);
            }
        }
        back_and_forth(editor, &texts);
    }
    println!("{accepted} accepted, {refused} refused: {kinds:?}");
    assert!(accepted > 2 * refused && kinds.len() == 24, "{kinds:?}");
    assert!(kinds.values().all(|[accepted, _]| *accepted > 3), "{kinds:?}");
}

/// Undoes and redoes all, also with the history from its file.
fn back_and_forth(mut editor: Editor, texts: &[String]) {
    for text in texts.iter().rev().skip(1) {
        assert!(editor.undo().unwrap().is_some());
        assert_eq!(editor.text(), text);
    }
    assert_eq!(editor.undo().unwrap(), None);
    let lines = editor.history().to_json_lines(editor.text()).unwrap();
    let (history, same) = History::from_json_lines("p.edits", &lines, editor.text()).unwrap();
    assert!(same && history == *editor.history());
    assert!(!History::from_json_lines("p.edits", &lines, &format!("{}\n", editor.text())).unwrap().1);
    let mut editor = Editor::with_history("p.toml", editor.text(), history).unwrap();
    for text in &texts[1..] {
        assert!(editor.redo().unwrap().is_some());
        assert_eq!(editor.text(), text);
        assert_eq!(*editor.program(), Program::read("p.toml", text).unwrap().value);
    }
    assert_eq!(editor.history().done().len() + 1, texts.len());
}

#[test]
fn patches_are_exact_for_any_texts() {
    let mut random = Random::new(3);
    let letters = ["a", "b", "\n", "é", "è", "€", "𝄞", ""];
    for _ in 0..cases(20_000) {
        let mut text = |n: usize| -> String { (0..n).map(|_| *random.one(&letters)).collect() };
        let (before, after) = (text(6), text(6));
        let mut history = History::default();
        history.push(Patch::between(Message::verbatim("x"), &before, &after));
        let (undone, name) = history.undo(&after).unwrap();
        assert_eq!((undone.as_str(), name), (before.as_str(), Message::verbatim("x")));
        assert_eq!(history.redo(&before).unwrap().0, after);
    }
}

#[test]
fn hundreds_of_edits_of_a_megabyte_take_little() {
    let rows: String = (0..25_000).map(|i| format!("    [{i}, 20.5, 30.25, 180, 0.5], # point {i}\n")).collect();
    let text = format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[[passes]]\nname = \"p\"\n[passes.points]\n\
        columns = [\"x_mm\", \"y_mm\", \"z_mm\", \"current_a\", \"time_s\"]\nstart = [0, 0, 0, 0, 0]\n\
        [[passes.points.spans]]\nalong = \"line\"\npoints = [\n{rows}]\n"
    );
    assert!(text.len() > 1_000_000);
    let (mut history, mut now) = (History::default(), text.clone());
    for i in 0..200 {
        let next = now.replacen(&format!("    [{i}, 20.5,"), &format!("    [{i}, 21.5,"), 1);
        history.push(Patch::between(Message::verbatim(format!("edit {i}")), &now, &next));
        now = next;
    }
    assert!(history.size() < 40_000, "{}", history.size());
    while let Some((before, _)) = history.undo(&now) {
        now = before;
    }
    assert!(now == text);
    // One through the editor, in a time that a panel can wait.
    let mut editor = Editor::new("p.toml", &text).unwrap();
    let set = serde_json::from_str::<Operation>(r#"{"op":"set_point","pass":1,"point":9000,"set":{"x_mm":1}}"#);
    let begin = std::time::Instant::now();
    editor.apply(&set.unwrap()).unwrap();
    println!("an edit of {} bytes: {:?}; history {} bytes", text.len(), begin.elapsed(), editor.history().size());
    assert!(editor.history().size() < 400);
}

#[test]
fn several_at_once_or_none() {
    let (text, _) = program(&mut Random::new(1));
    let mut editor = Editor::new("p.toml", &text).unwrap();
    let good = r#"{"op":"set_variable","name":"new","value":4}"#;
    let list = |last: &str| serde_json::from_str::<Vec<Operation>>(&format!("[{good}, {last}]")).unwrap();
    let (i, error) = editor.apply_all(&list(r#"{"op":"delete_pass","pass":99}"#)).unwrap_err();
    assert!(
        i == 1
            && error.message.to_string().contains("99")
            && editor.text() == text
            && editor.history().done().is_empty()
    );
    assert_eq!(editor.apply_all(&list(r#"{"op":"set_offset"}"#)).unwrap().len(), 2);
    assert_eq!(editor.history().done().len(), 2);
}
