use super::data::open;
use crate::args::records::VerifyArgs;
use crate::rows::{print_json, print_text};
use seamwright_message::{Language, Message};
use seamwright_project::failure::Failure;
use serde_json::json;

pub(super) fn run(args: &VerifyArgs) -> Result<(), Failure> {
    let verified = open(args.data.data.as_deref())?.verify()?;
    let audit = &verified.audit;
    if args.data.json {
        let english = |message: &Message| message.in_language(Language::English);
        let broken = audit.broken.as_ref().map(|(id, why)| json!({ "entry": id, "why": english(why) }));
        print_json(&json!({
            "welds": verified.welds,
            "files": verified.files,
            "audit": { "entries": audit.entries, "broken": broken },
            "problems": verified.problems.iter().map(english).collect::<Vec<_>>(),
        }))?;
    } else {
        let code = if verified.problems.is_empty() { "cli-verified" } else { "cli-verified-problems" };
        let counts = Message::new(code).count("welds", verified.welds).count("files", verified.files);
        let mut text = format!("{}\n", counts.count("entries", audit.entries as usize));
        let problem = |problem: &Message| Message::new("cli-problem").message("problem", problem.clone());
        text.extend(verified.problems.iter().map(|found| format!("{}\n", problem(found))));
        print_text(&text)?;
    }
    if verified.problems.is_empty() { Ok(()) } else { Err(Failure::Printed) }
}
