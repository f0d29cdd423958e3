use super::answer::{Answer, Refused};
use super::panel::Panel;
use crate::wire::EditAnswer;
use axum::Json;
use axum::extract::State;
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
        let mut editor = Editor::new("job.toml", &edit.text).map_err(|e| Refused::input(e.to_string()))?;
        let reports =
            editor.apply_all(&edit.operations).map_err(|(i, e)| Refused::input(format!("operation {}: {e}", i + 1)))?;
        let words = reports.into_iter().map(|report| report.words).collect();
        Ok(EditAnswer { text: editor.text().to_owned(), words })
    });
    edited.await.map(Json)
}
