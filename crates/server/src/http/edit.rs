use super::answer::{Answer, Refused};
use super::loading::document_message;
use super::panel::Shared;
use crate::form;
use crate::limits::{MAX_FORM_CHANGES, MAX_OPERATIONS};
use crate::wire::{EditAnswer, FormAnswer, FormText};
use axum::Json;
use axum::extract::State;
use seamwright_message::Message;
use seamwright_program::edit::{Editor, Operation};
use serde::Deserialize;

/// A text and operations on it, in the format of `seamwright edit --script`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Edit {
    text: String,
    operations: Vec<Operation>,
}

pub(super) async fn edit(State(panel): Shared, Json(edit): Json<Edit>) -> Answer<EditAnswer> {
    let edited = panel.reading.run(move || edited(&edit).map_err(Refused::input));
    edited.await.map(Json)
}

/// Returns the text after all operations, or the reason why one of them fails.
pub(super) fn edited(edit: &Edit) -> Result<EditAnswer, Message> {
    if edit.operations.len() > MAX_OPERATIONS {
        return Err(Message::new("server-too-many-operations").count("max", MAX_OPERATIONS));
    }
    let mut editor = Editor::new("job.toml", &edit.text).map_err(|e| document_message(&e))?;
    let several = edit.operations.len() > 1;
    let reports = editor.apply_all(&edit.operations).map_err(|(i, e)| match document_message(&e) {
        why if several => Message::new("server-operation").count("n", i + 1).message("why", why),
        why => why,
    })?;
    let words = reports.into_iter().map(|report| report.words.into()).collect();
    Ok(EditAnswer { text: editor.text().to_owned(), words })
}

pub(super) async fn form(State(panel): Shared, Json(asked): Json<FormText>) -> Answer<FormAnswer> {
    if asked.changes.len() > MAX_FORM_CHANGES {
        return Err(Message::new("server-too-many-operations").count("max", MAX_FORM_CHANGES).into());
    }
    let answer = move || form::answer(asked).map_err(|e| Refused::input(document_message(&e)));
    panel.reading.run(answer).await.map(Json)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Errors name key, value and allowed values without the line; with several operations also the operation's number.
    #[test]
    fn what_is_wrong_is_told_by_its_key() {
        let points = include_str!("../../../../examples/points.toml");
        let wrong = |text: &str, operations: &str| {
            let edit = Edit { text: text.to_owned(), operations: serde_json::from_str(operations).unwrap() };
            edited(&edit).unwrap_err().to_string()
        };
        let (done, pass_7) = (r#"{"op":"delete_points","pass":1,"from":2}"#, r#"{"op":"duplicate_pass","pass":7}"#);
        let text = wrong(points, &format!("[{pass_7}]"));
        assert!(text.contains("there is no pass 7") && !text.contains("operation"), "{text}");
        let text = wrong(points, &format!("[{done},{pass_7}]"));
        assert!(text.starts_with("operation 2: ") && text.contains("there is no pass 7"), "{text}");
        let text = wrong(&points.replace("along = \"arc\"", "along = \"bow\""), &format!("[{done}]"));
        assert!(text.contains("along = ") && text.contains("; allowed: "), "{text}");
        assert!(!text.contains("job.toml") && !text.contains('\n'), "{text}");
    }
}
