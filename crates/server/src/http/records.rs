use super::answer::{Answer, Refused, page_of};
use super::panel::{Panel, Shared};
use super::transfer_rate::Transfer;
use crate::cell::Change;
use crate::limits::{
    MAX_SEARCH_CHARS, MAX_TRACE_COLUMNS, MAX_TRACE_ROWS, MAX_TRACE_VALUES, MAX_WELDS, PIECE_TIME, SEARCH_TIME,
};
use crate::users::{Session, may};
use crate::view::written;
use crate::wire::{JudgedView, RecordRow, RecordView, RecordedAlarm, RecordedEvent, TraceView};
use axum::Json;
use axum::body::Body;
use axum::extract::{Path, Query, State};
use axum::http::{StatusCode, header};
use axum::response::{IntoResponse, Response};
use seamwright_executive::Alarm;
use seamwright_message::Message;
use seamwright_record::library::{Interrupt, Query as Find, WeldRecord, WeldResult};
use seamwright_record::trace::{Outline, Trace};
use seamwright_record::{DataFolder, Moment};
use seamwright_report::Language;
use serde::Deserialize;
use std::sync::Arc;
use std::task::Poll;
use tokio::runtime::Handle;
use tokio::sync::mpsc::Sender;
use tokio::sync::oneshot;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Asked {
    text: Option<String>,
    part: Option<String>,
    procedure: Option<String>,
    result: Option<String>,
    from: Option<String>,
    to: Option<String>,
}

fn wrong_query(name: &str, why: String) -> Refused {
    Refused::input(Message::new("server-query").text("name", name).text("why", why))
}

/// Refuses a text that is too long to be searched.
pub(super) fn searchable(text: Option<&str>) -> Result<(), Refused> {
    if text.is_some_and(|text| text.chars().count() > MAX_SEARCH_CHARS) {
        return Err(Message::new("server-search-too-long").count("max", MAX_SEARCH_CHARS).into());
    }
    Ok(())
}

impl Asked {
    fn query(self) -> Result<Find, Refused> {
        searchable(self.text.as_deref())?;
        let some = |text: Option<String>| text.filter(|t| !t.is_empty());
        let moment = |name: &str, text: Option<String>| {
            some(text).map(|t| t.parse::<Moment>().map_err(|e| wrong_query(name, e.to_string()))).transpose()
        };
        Ok(Find {
            part: some(self.part),
            since: moment("from", self.from)?,
            until: moment("to", self.to)?.map(Moment::next_day),
            program: None,
            procedure: some(self.procedure),
            machine: None,
            result: some(self.result)
                .map(|r| r.parse::<WeldResult>().map_err(|e| wrong_query("result", e.to_string())))
                .transpose()?,
            text: some(self.text),
            limit: Some(MAX_WELDS),
        })
    }
}

fn row(weld: &WeldRecord) -> RecordRow {
    RecordRow {
        id: weld.id,
        part: weld.part.clone(),
        title: weld.title.clone(),
        simulated: weld.simulated,
        begun: written(weld.begun),
        ended: weld.ended.map(written),
        result: weld.result.name().to_owned(),
        note: (&weld.note).into(),
        machine: weld.machine.0.clone(),
        procedure: weld.procedure.as_ref().map(|(number, _)| number.clone()),
        welder: weld.welder.clone(),
        heat_input_kj_mm: weld.heat_input_kj_mm,
        worst_deviation_mm: weld.worst_deviation_mm,
    }
}

/// Ends a query when dropped; without effect on one that has ended.
struct Ends(Interrupt);

impl Drop for Ends {
    fn drop(&mut self) {
        self.0.now();
    }
}

/// Reads the library in its own thread. A query that takes too long, or whose client has gone, is ended.
pub(super) async fn reads<T: Send + 'static>(
    panel: &Arc<Panel>,
    read: impl FnOnce(&DataFolder) -> Result<T, Refused> + Send + 'static,
) -> Answer<T> {
    let path = panel.data.clone();
    let (to, begun) = oneshot::channel();
    let answer = panel.reading.run(move || {
        let data = DataFolder::open_to_read(&path)?;
        // The caller may have gone.
        drop(to.send(Ends(data.library().interrupt())));
        read(&data)
    });
    let late = async {
        let ends = begun.await;
        tokio::time::sleep(SEARCH_TIME).await;
        drop(ends);
        std::future::pending().await
    };
    tokio::select! {
        answer = answer => answer.map(Json),
        never = late => never,
    }
}

pub(super) async fn list(State(panel): Shared, Query(asked): Query<Asked>) -> Answer<Vec<RecordRow>> {
    let query = asked.query()?;
    reads(&panel, move |data| Ok(data.library().find(&query)?.iter().map(row).collect())).await
}

fn traces(data: &DataFolder, weld: i64) -> Result<Vec<Trace>, Refused> {
    let files = data.library().files(weld)?;
    let parts = files.iter().filter(|f| f.rows.is_some());
    Ok(parts.map(|f| Trace::open(&data.weld_folder(weld).join(&f.name))).collect::<Result<_, _>>()?)
}

/// Returns title and cause of a recorded alarm as messages, also where an older version has recorded sentences.
fn words(title: &Message, cause: &Message) -> (Message, Message) {
    match Alarm::from_title(title) {
        Some((alarm, of)) if title.code == "text" => (alarm.title_of(of), alarm.entry().cause),
        _ => (title.clone(), cause.clone()),
    }
}

pub(super) async fn get(State(panel): Shared, Path(id): Path<i64>) -> Answer<RecordView> {
    reads(&panel, move |data| {
        let detail = data.library().detail(id)?;
        let traces = traces(data, id)?;
        let columns = traces.first().map_or(&[][..], Trace::columns);
        Ok(RecordView {
            weld: row(&detail.weld),
            values: detail
                .values
                .iter()
                .map(|v| JudgedView {
                    pass: v.pass,
                    name: v.name.clone(),
                    least: v.least,
                    mean: v.mean,
                    greatest: v.greatest,
                    allowed: v.allowed,
                    outside_s: v.outside_s,
                    outside_mm: v.outside_mm,
                })
                .collect(),
            alarms: detail
                .alarms
                .iter()
                .map(|a| {
                    let (name, cause) = words(&a.name, &a.cause);
                    RecordedAlarm {
                        name: name.into(),
                        cause: cause.into(),
                        priority: a.priority.clone(),
                        pass: a.place.pass,
                        s_mm: a.place.s_mm,
                        t_s: a.place.t_s,
                        first_out: a.first_out,
                    }
                })
                .collect(),
            events: detail
                .events
                .iter()
                .map(|e| RecordedEvent {
                    message: (&e.text).into(),
                    pass: e.place.pass,
                    s_mm: e.place.s_mm,
                    t_s: e.place.t_s,
                })
                .collect(),
            columns: columns.iter().map(|c| (c.name.clone(), c.unit.clone())).collect(),
            rows: traces.iter().map(Trace::rows).sum(),
        })
    })
    .await
}

/// Columns, and maximum number of rows.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Wanted {
    columns: String,
    most: Option<usize>,
}

pub(super) async fn trace(
    State(panel): Shared,
    Path(id): Path<i64>,
    Query(wanted): Query<Wanted>,
) -> Answer<TraceView> {
    let most = wanted.most.unwrap_or(2000);
    let columns: Vec<String> = wanted.columns.split(',').map(|c| c.trim().to_owned()).collect();
    if columns.len() > MAX_TRACE_COLUMNS || columns.len() * most > MAX_TRACE_VALUES {
        let message = Message::new("server-too-many-values").count("columns", columns.len()).count("rows", most);
        return Err(message.count("max-columns", MAX_TRACE_COLUMNS).count("max-values", MAX_TRACE_VALUES).into());
    }
    let least = Outline::least(columns.len());
    if !(least..=MAX_TRACE_ROWS).contains(&most) {
        return Err(Message::new("server-row-count")
            .count("value", most)
            .count("min", least)
            .count("max", MAX_TRACE_ROWS)
            .into());
    }
    reads(&panel, move |data| {
        let traces = traces(data, id)?;
        let known = traces.first().map_or(&[][..], Trace::columns);
        if let Some(unknown) = columns.iter().find(|c| known.iter().all(|k| k.name != **c)) {
            let names: Vec<&str> = known.iter().map(|c| c.name.as_str()).collect();
            return Err(Message::new("server-no-column")
                .text("column", unknown)
                .text("allowed", names.join(", "))
                .into());
        }
        let names: Vec<&str> = columns.iter().map(String::as_str).collect();
        let rows: u64 = traces.iter().map(Trace::rows).sum();
        let mut outline = Outline::new(columns.len(), rows, most);
        for part in &traces {
            part.read(&names, |row| outline.row(row))?;
        }
        let sent = |v: f64| v.is_finite().then_some(v);
        let values = outline.finish().into_iter().map(|column| column.into_iter().map(sent).collect()).collect();
        Ok(TraceView { columns, values })
    })
    .await
}

/// Optional language; default English.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Spoken {
    language: Option<String>,
}

/// Returns the language of this code; English without a code.
pub(super) fn spoken(code: Option<String>) -> Result<Language, Refused> {
    let known = |code: String| {
        code.parse::<Language>()
            .map_err(|e| Refused::input(Message::new("server-no-language").text("language", &code).text("allowed", e)))
    };
    Ok(code.map(known).transpose()?.unwrap_or_default())
}

pub(super) async fn report(
    State(panel): Shared,
    Path(id): Path<i64>,
    Query(asked): Query<Spoken>,
) -> Result<Response, Refused> {
    let language = spoken(asked.language)?;
    let page = reads(&panel, move |data| {
        let detail = data.library().detail(id)?;
        let figures = data.figures(id)?;
        let program = data.library().program_of(id)?;
        let date = Moment::now().to_string();
        Ok(seamwright_report::recorded_weld_page(&detail, &figures, &program.text, &date, language))
    });
    page.await.map(|Json(html)| page_of(html))
}

/// Size of a piece of an archive sent to a client, bytes, and maximum number of queued pieces.
const PIECE: usize = 64 << 10;
const PIECES: usize = 8;

/// Writer to the client, limited by the client's speed.
struct ToClient {
    to: Sender<std::io::Result<Vec<u8>>>,
    runtime: Handle,
    transfer: Transfer,
}

impl std::io::Write for ToClient {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let left = self.transfer.left();
        let sent = self.runtime.block_on(async { self.to.send_timeout(Ok(bytes.to_vec()), left).await });
        let gone = |_| std::io::Error::new(std::io::ErrorKind::BrokenPipe, "the client has gone or is too slow");
        sent.map_err(gone)?;
        self.transfer.moved(bytes.len());
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

pub(super) async fn backup(State(panel): Shared, session: Session) -> Result<Response, Refused> {
    let command = Message::new("server-audit-backup");
    panel.audit(&session.user, command, Change::default(), Message::new("server-audit-begun"));
    // Password hashes are only for users who may change passwords.
    let with_users = may(session.role, "users.write");
    let (to, mut from) = tokio::sync::mpsc::channel(PIECES);
    let (asked, runtime) = (Arc::clone(&panel), Handle::current());
    // Continues while the answer is read.
    tokio::spawn(async move {
        let failed = to.clone();
        let written = asked.backing_up.run({
            let path = asked.data.clone();
            move || {
                let out = std::io::BufWriter::with_capacity(
                    PIECE,
                    ToClient { to, runtime, transfer: Transfer::begin(PIECE_TIME) },
                );
                let data = DataFolder::open_to_read(&path)?;
                if with_users {
                    data.back_up(out)?;
                } else {
                    data.back_up_without_users(out)?;
                }
                Ok(())
            }
        });
        if let Err(e) = written.await {
            // The client receives a truncated archive.
            drop(failed.send_timeout(Err(std::io::Error::other(e.message.to_string())), PIECE_TIME).await);
        }
    });
    // A failure before the first piece becomes a normal refusal.
    let first = match from.recv().await {
        Some(Ok(first)) => first,
        Some(Err(e)) => return Err(Refused::new(StatusCode::SERVICE_UNAVAILABLE, "busy", e.to_string())),
        None => Vec::new(),
    };
    let mut first = Some(first);
    let body = Body::from_stream(futures_util::stream::poll_fn(move |context| match first.take() {
        Some(piece) => Poll::Ready(Some(Ok(piece))),
        None => from.poll_recv(context),
    }));
    // Day and minute in the name distinguish backups in one folder.
    let at: String = Moment::now().to_string().chars().filter(char::is_ascii_digit).take(12).collect();
    let name = format!("attachment; filename=\"seamwright-backup-{at}.tar\"");
    Ok(([(header::CONTENT_TYPE, "application/x-tar".to_owned()), (header::CONTENT_DISPOSITION, name)], body)
        .into_response())
}
