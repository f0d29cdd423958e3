use super::answer::{Answer, Refused};
use super::login::From;
use super::panel::{Panel, Shared};
use super::transfer_rate::Transfer;
use super::users::again;
use crate::cell::Change;
use crate::limits::PIECE_TIME;
use crate::users::{Accounts, Session};
use crate::view::written;
use crate::wire::{ArchiveView, OwnPassword};
use axum::Json;
use axum::body::{Body, Bytes};
use axum::extract::State;
use axum::http::{HeaderMap, StatusCode, header};
use futures_util::StreamExt as _;
use seamwright_message::{Message, Unit};
use seamwright_record::library::{Query, WeldResult};
use seamwright_record::{DataFolder, Error, check_archive, discard_checked, has_checked};
use std::fs::File;
use std::io::Write as _;
use std::path::Path;
use std::sync::Arc;
use tokio::sync::mpsc::{Receiver, Sender, channel};

/// Maximum number of queued pieces of an archive.
const PIECES: usize = 8;
/// File name of an archive while it is received, in the data folder.
const UPLOAD: &str = "restore-upload.tar";

/// A piece of an archive; `None` marks its end.
type Piece = Option<Bytes>;

/// Refuses unless the machine is off: data are replaced only then.
fn off(panel: &Panel) -> Result<(), Refused> {
    let mode = panel.cell.hub.latest().map_or_else(|| "off".to_owned(), |status| status.mode.clone());
    if mode == "off" {
        return Ok(());
    }
    Err(Refused::new(StatusCode::CONFLICT, "busy", Message::new("server-not-off")))
}

fn too_large(most: u64) -> Refused {
    let message = Message::new("server-archive-too-large").value("max", (most >> 20) as f64, Unit::MiB);
    Refused::new(StatusCode::PAYLOAD_TOO_LARGE, "size", message)
}

/// Converts the error of an archive; the panel has words for its key.
fn unfit(e: &Error) -> Refused {
    let (status, key) = match e {
        Error::Newer { .. } => (StatusCode::UNPROCESSABLE_ENTITY, "archive_newer"),
        Error::Full { .. } => (StatusCode::INSUFFICIENT_STORAGE, "archive_room"),
        Error::ReadOnly { .. } | Error::Busy { .. } => (StatusCode::INTERNAL_SERVER_ERROR, "server"),
        _ => (StatusCode::UNPROCESSABLE_ENTITY, "archive"),
    };
    Refused::new(status, key, e.message())
}

/// Receives an archive and checks it completely; replaces nothing.
pub(super) async fn take(
    State(panel): Shared,
    session: Session,
    headers: HeaderMap,
    body: Body,
) -> Answer<ArchiveView> {
    off(&panel)?;
    let most = panel.most_archive;
    let length = headers.get(header::CONTENT_LENGTH).and_then(|v| v.to_str().ok()?.parse::<u64>().ok());
    if length.is_some_and(|length| length > most) {
        return Err(too_large(most));
    }
    let (to, from) = channel(PIECES);
    let asked = Arc::clone(&panel);
    let checked = panel.backing_up.run(move || {
        let upload = asked.data.join(UPLOAD);
        let checked = keep(&upload, from, most).and_then(|()| checked(&asked, &upload));
        // The upload is unpacked, or invalid.
        drop(std::fs::remove_file(&upload));
        checked
    });
    let ((), checked) = tokio::join!(feed(body, to), checked);
    let said = checked.as_ref().map_or_else(|e| e.message.clone(), |_| Message::new("server-audit-checked"));
    panel.audit(&session.user, Message::new("server-audit-check-archive"), Change::default(), said);
    checked.map(Json)
}

/// Forwards received pieces, then the end. A sender that is too slow is given up.
async fn feed(body: Body, to: Sender<Piece>) {
    let mut pieces = body.into_data_stream();
    let mut transfer = Transfer::begin(PIECE_TIME);
    loop {
        let piece = match tokio::time::timeout(transfer.left(), pieces.next()).await {
            Ok(Some(Ok(piece))) => {
                transfer.moved(piece.len());
                Some(piece)
            }
            Ok(None) => None,
            // Aborted: the reader sees no end.
            Ok(Some(Err(_))) | Err(_) => return,
        };
        let all = piece.is_none();
        if to.send(piece).await.is_err() || all {
            return;
        }
    }
}

fn keep(upload: &Path, mut from: Receiver<Piece>, most: u64) -> Result<(), Refused> {
    let failed = |e: std::io::Error| match e.kind() {
        std::io::ErrorKind::StorageFull => {
            Refused::new(StatusCode::INSUFFICIENT_STORAGE, "archive_room", e.to_string())
        }
        _ => Refused::server(
            Message::new("server-file-trouble").text("file", upload.display().to_string()).text("why", e.to_string()),
        ),
    };
    let mut file = File::create(upload).map_err(failed)?;
    let mut bytes = 0;
    loop {
        match from.blocking_recv() {
            Some(Some(piece)) => {
                bytes += piece.len() as u64;
                if bytes > most {
                    return Err(too_large(most));
                }
                file.write_all(&piece).map_err(failed)?;
            }
            Some(None) => return Ok(()),
            None => return Err(Message::new("server-archive-broke-off").into()),
        }
    }
}

fn checked(panel: &Panel, upload: &Path) -> Result<ArchiveView, Refused> {
    let (contents, folder) = check_archive(upload, &panel.data).map_err(|e| unfit(&e))?;
    // An archive without users keeps those of the cell.
    let with_users = folder.join("users.json").is_file();
    let users = Accounts::open(if with_users { &folder } else { &panel.data });
    let fits = match &users {
        Err(e) => Err(Refused::new(StatusCode::UNPROCESSABLE_ENTITY, "archive", e.0.clone())),
        Ok(users) if panel.accounts.has_admin() && !users.has_admin() => {
            Err(Refused::new(StatusCode::UNPROCESSABLE_ENTITY, "archive", Message::new("server-archive-no-admin")))
        }
        Ok(users) => Ok(users.list().len()),
    };
    let users = fits.inspect_err(|_| drop(discard_checked(&panel.data)))?;
    Ok(ArchiveView {
        welds: contents.welds,
        newest: contents.newest.map(written),
        jobs: contents.jobs,
        users,
        audit: contents.audit,
    })
}

/// Replaces all data by the last checked archive: the cell ends and restarts with it.
pub(super) async fn begin(
    State(panel): Shared,
    from: From,
    headers: HeaderMap,
    session: Session,
    Json(own): Json<OwnPassword>,
) -> Result<StatusCode, Refused> {
    again(&panel, &from, &headers, &session, own.own_password).await?;
    off(&panel)?;
    let data = panel.data.clone();
    let running = Query { result: Some(WeldResult::Running), ..Query::default() };
    let find = move || -> Result<bool, Refused> {
        if !has_checked(&data) {
            return Err(Refused::not_found(Message::new("server-no-archive")));
        }
        Ok(DataFolder::open_to_read(&data)?.library().find(&running)?.is_empty())
    };
    if !panel.reading.run(find).await? {
        return Err(Refused::new(StatusCode::CONFLICT, "busy", Message::new("server-record-being-written")));
    }
    // Excludes other backups and archives meanwhile; only one archive is restored.
    let Some(turn) = panel.backing_up.now() else {
        return Err(Refused::new(StatusCode::SERVICE_UNAVAILABLE, "busy", Message::new("server-backup-runs")));
    };
    let command = Message::new("server-audit-restore");
    panel.audit(&session.user, command, Change::default(), Message::new("server-audit-begun"));
    panel.restores.send_replace(Some(Arc::new((session.user, turn))));
    Ok(StatusCode::ACCEPTED)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body without a known length stops at the limit; an aborted one is not accepted.
    #[test]
    fn no_more_is_kept_than_allowed_and_nothing_that_broke_off() {
        let folder = tempfile::tempdir().unwrap();
        let upload = folder.path().join("upload.tar");
        for (sizes, ends, key) in
            [(&[600, 400][..], true, None), (&[600, 401], true, Some("size")), (&[600], false, Some("input"))]
        {
            let (to, from) = channel(PIECES);
            for size in sizes {
                to.try_send(Some(Bytes::from(vec![1; *size]))).unwrap();
            }
            if ends {
                to.try_send(None).unwrap();
            }
            drop(to);
            assert_eq!(keep(&upload, from, 1000).err().map(|e| e.key), key);
        }
    }
}
