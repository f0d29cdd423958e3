//! Texts that nest deeply, or hold very many keys.

use seamwright_document::{Document, DocumentError, TomlText};
use serde::Deserialize;

/// Any table.
#[derive(Debug, Deserialize)]
struct Anything {}

fn read(text: &str) -> Result<(), DocumentError> {
    let read = Document::<Anything>::read("job.toml", text).map(drop);
    let parsed = TomlText::parse("job.toml", text).map(|text| drop(text.entries()));
    assert_eq!(read.is_ok(), parsed.is_ok(), "{read:?} {parsed:?}");
    read
}

/// Tables in tables, each at a key of several parts.
fn nested(tables: usize, parts: usize) -> String {
    let key = vec!["a"; parts].join(".");
    let open = format!("{{ {key} = ");
    format!("{key} = {}1{}", open.repeat(tables - 1), " }".repeat(tables - 1))
}

/// Each of these would end the program by a full stack, or take it seconds, if it were parsed.
#[test]
fn texts_that_nest_too_deeply_are_refused_before_they_are_parsed() {
    for text in [
        nested(75, 75),
        nested(4000, 1),
        nested(1, 100_000),
        format!("[{}]", vec!["a"; 100_000].join(".")),
        format!("a = {}", "[".repeat(100_000)),
        format!("a = {}", "{ a = ".repeat(100_000)),
        format!("a = [{}", "[1.5], [".repeat(20) + &nested(75, 75)),
        format!("a = 1\n\n# {{\nb = {}1{}", "[".repeat(2000), "]".repeat(2000)),
        format!("{}]", "[a.".repeat(50_000)),
        format!("a = {}", "}]".repeat(100) + &nested(75, 75)),
    ] {
        let error = read(&text).unwrap_err();
        let start: String = text.chars().take(40).collect();
        assert!(error.message.code == "document-nested" || error.line == 1, "{start}: {error}");
    }
    let error = read(&format!("a = 1\n[b]\n{}", nested(20, 20))).unwrap_err();
    assert_eq!((error.line, error.message.code.as_ref()), (3, "document-nested"), "{error}");
    assert!(error.to_string().contains("allowed: up to 32 levels"), "{error}");
}

/// Neither brackets in texts and comments nor points of numbers count, and the deepest that is allowed is read.
#[test]
fn texts_as_deep_as_allowed_are_read() {
    let numbers = format!("a = [{}]", "1.5, -2.25e3, [3.5], ".repeat(1000));
    let text = format!("a = '{}' # {}\nb = \"{}\"", "[".repeat(100), "{".repeat(100), ".".repeat(100));
    for text in [nested(4, 7), numbers, text, format!("[{}]", vec!["a"; 32].join("."))] {
        assert_eq!(read(&text).map_err(|e| e.to_string()), Ok(()));
    }
}

/// A hundred thousand keys, or tables, are read in one go: the time per key does not grow with their number.
#[test]
fn hundred_thousand_keys_are_read() {
    let keys: String = (0..100_000).map(|i| format!("key_{i} = {i}\n")).collect();
    let tables: String = (0..100_000).map(|i| format!("[[table]]\nkey = {i}\n")).collect();
    for text in [keys, tables] {
        assert_eq!(read(&text).map_err(|e| e.to_string()), Ok(()));
    }
}
