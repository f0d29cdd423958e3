use super::answer::{Answer, Refused};
use super::panel::Panel;
use crate::wire::EditAnswer;
use axum::Json;
use axum::extract::State;
use seamwright_document::DocumentError;
use seamwright_program::edit::{Editor, Operation};
use serde::Deserialize;
use std::sync::Arc;

/// Most operations at once.
const MOST: usize = 1000;

/// A text and what is to be done to it, as `seamwright edit --script` takes it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Edit {
    text: String,
    operations: Vec<Operation>,
}

pub(super) async fn edit(State(panel): State<Arc<Panel>>, Json(edit): Json<Edit>) -> Answer<EditAnswer> {
    let edited = panel.reading.run(move || {
        if edit.operations.len() > MOST {
            return Err(Refused::input(format!("too many operations; allowed: up to {MOST} at once")));
        }
        let mut editor = Editor::new("job.toml", &edit.text).map_err(|e| refused(&e))?;
        let reports = editor.apply_all(&edit.operations).map_err(|(_, e)| refused(&e))?;
        let words = reports.into_iter().map(|report| report.words).collect();
        Ok(EditAnswer { text: editor.text().to_owned(), words })
    });
    edited.await.map(Json)
}

/// What is wrong, without the line: it is of a text that nobody sees, the operations' or what they would have made.
fn refused(e: &DocumentError) -> Refused {
    let of = if e.value.is_empty() { String::new() } else { format!("{} = {}: ", e.key, e.value) };
    let allowed = e.allowed.as_ref().map(|allowed| format!("; allowed: {allowed}"));
    Refused::input(format!("{of}{}{}", e.message, allowed.unwrap_or_default()))
}
