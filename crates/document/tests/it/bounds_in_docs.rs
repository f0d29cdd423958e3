//! The table of bounds in docs/reference/job.md is the one that files are held against.

use seamwright_document::BOUNDS;
use seamwright_message::Message;

#[test]
fn the_documented_bounds_are_those_of_the_code() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/reference/job.md")).unwrap();
    let rows: Vec<Vec<&str>> = text
        .lines()
        .filter(|line| line.starts_with("| `_"))
        .map(|line| line.trim_matches('|').split('|').map(str::trim).collect())
        .collect();
    assert_eq!(rows.len(), BOUNDS.len());
    for (row, bound) in rows.iter().zip(BOUNDS) {
        let least = if bound.min > 0.0 { bound.min.to_string() } else { String::new() };
        let expected = [format!("`{}`", bound.suffix), bound.unit.to_string(), least, bound.max.to_string()];
        assert_eq!(row[..4], expected, "{row:?}");
        assert_eq!(row[4], Message::new(bound.reason).to_string());
    }
}
