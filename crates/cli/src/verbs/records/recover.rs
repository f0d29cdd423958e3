use super::data::{folder, result};
use crate::args::records::RecoverArgs;
use crate::rows::{print_json, print_text};
use crate::verbs::row_destination::audit;
use seamwright_message::{Message, Unit};
use seamwright_project::failure::Failure;
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
        let line = match r.unread_bytes {
            0 => Message::new("cli-recovered"),
            unread => Message::new("cli-recovered-unread").quantity("unread", unread as f64, Unit::Byte, 0),
        };
        let line = line.text("weld", r.weld.id.to_string()).text("part", &r.weld.part).count("rows", r.rows as usize);
        format!("{}\n", line.message("result", result(r.weld.result)))
    });
    let mut text: String = lines.collect();
    if text.is_empty() {
        text = format!("{}\n", Message::new("cli-nothing-to-recover"));
    }
    print_text(&text)
}
