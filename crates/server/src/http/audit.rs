use super::answer::Answer;
use super::panel::Shared;
use super::records::{reads, searchable};
use crate::cell::from_stored;
use crate::limits::MAX_AUDIT_ENTRIES;
use crate::view::written;
use crate::wire::AuditRow;
use axum::extract::{Query, State};
use seamwright_record::library::{AuditEntry, AuditQuery};
use serde::Deserialize;

/// Default number of entries sent.
const SENT: u32 = 200;

/// Filter: number, older than an entry, newer than an entry, containing a text.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Asked {
    most: Option<u32>,
    before: Option<i64>,
    after: Option<i64>,
    text: Option<String>,
}

fn row(id: i64, entry: AuditEntry) -> AuditRow {
    AuditRow {
        id,
        at: written(entry.at),
        user: entry.user,
        station: from_stored(entry.station).into(),
        command: from_stored(entry.command).into(),
        old: entry.old,
        new: entry.new,
        result: from_stored(entry.result).into(),
    }
}

pub(super) async fn list(State(panel): Shared, Query(asked): Query<Asked>) -> Answer<Vec<AuditRow>> {
    searchable(asked.text.as_deref())?;
    let query = AuditQuery {
        before: asked.before,
        after: asked.after.unwrap_or(0),
        text: asked.text.unwrap_or_default(),
        most: asked.most.unwrap_or(SENT).min(MAX_AUDIT_ENTRIES),
    };
    reads(&panel, move |data| {
        Ok(data.library().audit_page(&query)?.into_iter().map(|(id, entry)| row(id, entry)).collect())
    })
    .await
}
