//! `seamwright tools bench tracking`: tables of few welds.

use crate::common::{bad, good};
use serde_json::Value;

fn table(name: &str) -> Value {
    let text = good(&["tools", "bench", "tracking", "--seeds", "1", "--json", "--table", name]);
    serde_json::from_str(&text).unwrap()
}

#[test]
fn faults_and_beam_mode_are_kept() {
    for (name, title, least) in [("faults", "Faults while tracking", 80), ("beam", "Beam mode at 10 mm/s", 19)] {
        let found = table(name);
        assert_eq!(found["gates"].as_array().map(Vec::len), Some(0), "only what was asked for");
        let tables = found["tables"].as_array().unwrap();
        assert_eq!((tables.len(), tables[0]["title"].as_str()), (1, Some(title)));
        let rows = tables[0]["rows"].as_array().unwrap();
        assert!(rows.len() >= least, "{name}: {}", rows.len());
        for row in rows {
            assert_eq!(row["kept"], true, "{row}");
            assert!(row["value"].as_f64().unwrap() <= row["limit"].as_f64().unwrap() || row["limit_is"] == "least");
        }
    }
}

#[test]
fn as_markdown_and_what_cannot_be() {
    let text = good(&["tools", "bench", "tracking", "--seeds", "1", "--table", "faults"]);
    assert!(
        text.starts_with("## Faults while tracking\n") && text.lines().filter(|l| l.starts_with("| ")).count() > 80
    );
    assert!(!text.contains("**no**"), "{text}");
    assert!(bad(2, &["tools", "bench", "tracking", "--seeds", "0"]).contains("1..=1000"));
    assert!(bad(2, &["tools", "bench", "tracking", "--table", "sems"]).contains("seams, parts, faults, beam"));
}
