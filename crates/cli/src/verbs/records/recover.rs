use super::folder;
use crate::args::records::RecoverArgs;
use crate::failure::Failure;
use crate::rows::{print_json, print_text};
use crate::verbs::recorded::audit;
use seamwright_record::DataFolder;
use seamwright_record::library::Library;
use serde_json::{Value, json};

pub(super) fn run(args: &RecoverArgs) -> Result<(), Failure> {
    let folder = folder(args.data.data.as_deref())?;
    // A folder without a library is a mistake, and no library is created in it.
    if !folder.join("library.sqlite").is_file() {
        Library::open_to_read(&folder.join("library.sqlite"))?;
    }
    let mut data = DataFolder::open(&folder)?;
    let recovered = data.recover()?;
    for r in &recovered {
        audit(&mut data, &format!("records recover: weld {}", r.weld.id), &format!("{} rows", r.rows))?;
    }
    if args.data.json {
        let rows = recovered.iter().map(|r| {
            json!({
                "id": r.weld.id,
                "part": r.weld.part,
                "result": r.weld.result.name(),
                "rows": r.rows,
                "unread_bytes": r.unread_bytes,
            })
        });
        return print_json(&rows.collect::<Vec<Value>>());
    }
    let lines = recovered.iter().map(|r| {
        let unread =
            if r.unread_bytes > 0 { format!(", {} bytes at its end unread", r.unread_bytes) } else { String::new() };
        format!("weld {} ({}): {} rows recovered{unread}, {}\n", r.weld.id, r.weld.part, r.rows, r.weld.result)
    });
    let text: String = lines.collect();
    print_text(if text.is_empty() { "nothing to recover\n" } else { &text })
}
