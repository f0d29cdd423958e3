use super::open;
use crate::args::records::VerifyArgs;
use crate::failure::Failure;
use crate::rows::{print_json, print_text};
use serde_json::json;

pub(super) fn run(args: &VerifyArgs) -> Result<(), Failure> {
    let verified = open(args.data.data.as_deref())?.verify()?;
    let audit = &verified.audit;
    if args.data.json {
        let broken = audit.broken.as_ref().map(|(id, why)| json!({ "entry": id, "why": why }));
        print_json(&json!({
            "welds": verified.welds,
            "files": verified.files,
            "audit": { "entries": audit.entries, "broken": broken },
            "problems": verified.problems,
        }))?;
    } else {
        let mut text =
            format!("{} welds, {} files as recorded, {} audit entries", verified.welds, verified.files, audit.entries);
        text += if verified.problems.is_empty() { ": in order\n" } else { ": not in order\n" };
        text.extend(verified.problems.iter().map(|problem| format!("problem: {problem}\n")));
        print_text(&text)?;
    }
    if verified.problems.is_empty() { Ok(()) } else { Err(Failure::Printed) }
}
