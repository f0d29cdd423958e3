use crate::disk::{SPARE_BYTES, disk_room};
use crate::error::{Doing, Error};
use crate::event::Event;
use crate::figures::Figures;
use crate::hash::sha256_of_file;
use crate::journal::Journal;
use crate::library::{AuditCheck, DocumentKind, Library, NewWeld, WeldRecord, WeldResult};
use crate::moment::Moment;
use crate::private_files;
use crate::recording::{Plan, Recording, Settled, hash_of, lasted, missing, settle};
use crate::stored_message::joined;
use crate::trace::recover::is_written;
use crate::trace::{self, Trace};
use crate::waiting_file::{self, WaitingFile};
use crate::weld_log::{self, Entry, LogSummary, WeldLog};
use crate::weld_writer::{WeldFiles, weld_folder};
use seamwright_message::{Message, Unit};
use std::fs;
use std::path::{Path, PathBuf};

/// Problems of a trace that is being written, and of one that a crash left.
pub(crate) const UNFINISHED: &str = "record-problem-unfinished";
pub(crate) const LEFT_UNFINISHED: &str = "record-problem-left";

/// Files that only the owner of the folder may read, regardless of the permissions that they were made with.
const PRIVATE: [&str; 7] = [
    "library.sqlite",
    "library.sqlite-wal",
    "library.sqlite-shm",
    "welds",
    "position.a",
    "position.b",
    waiting_file::NAME,
];

/// The folder of everything that is recorded: `library.sqlite`, `welds/<number>/`, and the journal for power loss.
/// Methods fail if its files cannot be read or written.
#[derive(Debug)]
pub struct DataFolder {
    path: PathBuf,
    library: Library,
}

/// A weld that a crash left, recovered.
#[derive(Debug, Clone, PartialEq)]
pub struct Recovered {
    /// The weld.
    pub weld: WeldRecord,
    /// Rows of its trace.
    pub rows: u64,
    /// Bytes of it that form no whole rows.
    pub unread_bytes: u64,
}

/// Result of [`DataFolder::verify`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verified {
    /// Number of welds checked.
    pub welds: usize,
    /// Files whose hashes are right.
    pub files: usize,
    /// The audit log.
    pub audit: AuditCheck,
    /// Everything that is not in order.
    pub problems: Vec<Message>,
}

impl DataFolder {
    /// Opens the folder to write, and creates missing parts. An interrupted restore is finished first. Records that
    /// others may read, from older versions, become readable by the owner only.
    ///
    /// # Errors
    /// If it cannot be written, or its library cannot be opened.
    pub fn open(path: &Path) -> Result<Self, Error> {
        crate::replacement_steps::finish_replacing(path)?;
        let welds = path.join("welds");
        private_files::folder(&welds).map_err(|e| Error::io(&welds, Doing::Create, e))?;
        for name in PRIVATE {
            // Errors are ignored: the permissions of another user's files are left alone.
            drop(private_files::tighten(&path.join(name)));
        }
        Ok(Self { path: path.to_owned(), library: Library::open(&path.join("library.sqlite"))? })
    }

    /// Opens the folder only to read it.
    ///
    /// # Errors
    /// If its library is missing or unreadable.
    pub fn open_to_read(path: &Path) -> Result<Self, Error> {
        let library = Library::open_to_read(&path.join("library.sqlite"))?;
        Ok(Self { path: path.to_owned(), library })
    }

    /// Path of the folder.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The library.
    pub fn library(&self) -> &Library {
        &self.library
    }

    /// The library, for changes to it alone.
    pub fn library_mut(&mut self) -> &mut Library {
        &mut self.library
    }

    /// Folder of a weld's files.
    pub fn weld_folder(&self, weld: i64) -> PathBuf {
        weld_folder(&self.path, weld)
    }

    /// The figures of a weld, from its trace.
    pub fn figures(&self, weld: i64) -> Result<Figures, Error> {
        let files = self.library.files(weld)?;
        let traces = files.iter().filter(|f| f.rows.is_some());
        let traces =
            traces.map(|f| Trace::open(&self.weld_folder(weld).join(&f.name))).collect::<Result<Vec<_>, _>>()?;
        Figures::of(&traces, &self.library.basis(weld)?)
    }

    /// The journal for power loss.
    pub fn journal(&self) -> Result<Journal, Error> {
        Journal::open(&self.path)
    }

    /// Starts to record a weld.
    ///
    /// # Errors
    /// If the disk is full, or writing fails: the weld must not start then, and its folder and entry are removed.
    pub fn begin(&mut self, plan: &Plan) -> Result<Recording, Error> {
        let (files, begun) = self.enter(plan)?;
        let folder = files.folder();
        let weld = files.weld;
        Recording::new(files, begun, plan.note.clone()).inspect_err(|_| self.take_back(weld, &folder))
    }

    /// Starts a weld of so many passes whose files another process writes, by [`crate::WeldWriter`]. [`DataFolder::close`]
    /// ends it.
    ///
    /// # Errors
    /// See [`DataFolder::begin`].
    pub fn begin_elsewhere(&mut self, plan: &Plan, passes: usize, events: &[Event]) -> Result<WeldFiles, Error> {
        let (files, _) = self.enter(plan)?;
        let begun = || {
            let mut log = WeldLog::open(&files.folder())?;
            log.write(&Entry::Begun { passes })?;
            events.iter().try_for_each(|event| log.write(&Entry::Event(event.clone())))?;
            log.sync()
        };
        match begun() {
            Ok(()) => Ok(files),
            Err(e) => {
                self.take_back(files.weld, &files.folder());
                Err(e)
            }
        }
    }

    /// Adds an entry to the log of a weld that has not been closed.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn log(path: &Path, weld: i64, entry: &Entry) -> Result<(), Error> {
        WeldLog::open(&weld_folder(path, weld))?.write(entry)
    }

    /// Enters a weld into the library, with a folder of its own.
    fn enter(&mut self, plan: &Plan) -> Result<(WeldFiles, Moment), Error> {
        self.check_room(plan)?;
        let text = |kind, (name, text): &(String, String)| self.library.add_document(kind, name, text);
        let new = NewWeld {
            part: plan.part.clone(),
            title: plan.title.clone(),
            simulated: plan.simulated,
            job: plan.job.as_ref().map(|t| text(DocumentKind::Job, t)).transpose()?,
            program: text(DocumentKind::Program, &plan.program)?,
            machine: text(DocumentKind::Machine, &plan.machine)?,
            procedure: plan.procedure.as_ref().map(|t| text(DocumentKind::Procedure, t)).transpose()?,
            welder: plan.welder.clone(),
            begun: Moment::now(),
            basis: plan.basis.clone(),
            note: plan.note.clone(),
        };
        // Never into the folder of a weld that the library has lost.
        let last = self.weld_folders()?.into_iter().max().unwrap_or(0);
        let id = self.library.begin_weld(&new, last)?;
        let folder = self.weld_folder(id);
        let made = private_files::folder(&folder).map_err(|e| Error::io(&folder, Doing::Create, e));
        made.inspect_err(|_| self.take_back(id, &folder))?;
        let files = WeldFiles {
            weld: id,
            data: self.path.clone(),
            columns: plan.columns.clone(),
            about: plan.about.iter().map(|(key, value)| ((*key).to_owned(), value.clone())).collect(),
            most_rows: plan.most_rows,
            rows: plan.rows,
        };
        Ok((files, new.begun))
    }

    /// Removes the remains of a weld that failed to start. If that fails too, [`DataFolder::recover`] settles them.
    fn take_back(&self, id: i64, folder: &Path) {
        // The number is new, so no data of another weld are there.
        drop(fs::remove_file(folder.join("trace.raw")));
        drop(fs::remove_file(folder.join(weld_log::NAME)));
        drop(fs::remove_dir(folder));
        drop(self.library.take_back_weld(id));
    }

    /// Refuses a weld whose trace would not fit on the disk: as raw rows, and once more as Parquet.
    fn check_room(&self, plan: &Plan) -> Result<(), Error> {
        let row: u64 = plan.columns.iter().map(|c| c.kind.bytes() as u64).sum();
        let wanted = plan.rows.saturating_mul(2 * row).saturating_add(SPARE_BYTES);
        match disk_room(&self.path)?.map(|room| room.free_bytes) {
            Some(free) if free < wanted => {
                let mib = |bytes: u64| (bytes >> 20) as f64;
                let why = Message::new("record-no-room").quantity("free", mib(free), Unit::MiB, 0);
                let why = why.quantity("needed", mib(wanted), Unit::MiB, 0);
                Err(Error::Full { path: self.path.clone(), why })
            }
            _ => Ok(()),
        }
    }

    /// Numbers of welds that have files, but no entry in the library. For example, it loses entries by damage to its
    /// write-ahead log, which SQLite takes for its end.
    pub fn lost_welds(&self) -> Result<Vec<i64>, Error> {
        let known = self.library.weld_numbers()?;
        let mut lost = self.weld_folders()?;
        lost.retain(|id| known.binary_search(id).is_err());
        lost.sort_unstable();
        Ok(lost)
    }

    /// Numbers of the folders in `welds` that have files.
    fn weld_folders(&self) -> Result<Vec<i64>, Error> {
        let welds = self.path.join("welds");
        let Ok(entries) = fs::read_dir(&welds) else { return Ok(Vec::new()) };
        let number = |entry: fs::DirEntry| {
            let id = entry.file_name().to_str()?.parse().ok()?;
            fs::read_dir(entry.path()).ok()?.next().map(|_| id)
        };
        Ok(entries.flatten().filter_map(number).collect())
    }

    /// Repairs the data after a crash: traces to Parquet, running welds to interrupted ones, and orders and alarms that
    /// waited for the library into it. A weld that ended in order without a panel to close its record gets its result.
    pub fn recover(&mut self) -> Result<Vec<Recovered>, Error> {
        self.recover_except(&[])
    }

    /// The same, but leaves the welds in `open` alone, which another process is about to write.
    pub fn recover_except(&mut self, open: &[i64]) -> Result<Vec<Recovered>, Error> {
        self.store_waiting();
        let mut recovered = Vec::new();
        for weld in self.library.find(&crate::library::Query::default())?.into_iter().rev() {
            let folder = self.weld_folder(weld.id);
            let left = folder.exists() && has_raw(&folder)?;
            if (weld.result != WeldResult::Running && !left) || open.contains(&weld.id) || is_written(&folder) {
                continue;
            }
            recovered.push(self.close_left(weld, None)?);
        }
        Ok(recovered)
    }

    /// Closes the record of a weld whose writer has ended it or has gone: trace to Parquet, figures, and events and
    /// result from its log. `cause`: why its writer has gone, if it is known.
    ///
    /// # Errors
    /// If the weld is still being written ([`Error::Busy`]), or files or library cannot be written:
    /// [`DataFolder::recover`] closes it later.
    pub fn close(&mut self, weld: i64, cause: Option<&Message>) -> Result<WeldRecord, Error> {
        let folder = self.weld_folder(weld);
        if is_written(&folder) {
            return Err(Error::Busy { path: folder });
        }
        let weld = self.library.weld(weld)?;
        self.close_left(weld, cause).map(|closed| closed.weld)
    }

    /// Stores the entries that an earlier run could not; a running program stores its own. What the library still does
    /// not take stays in the file.
    fn store_waiting(&mut self) {
        if !self.path.join(waiting_file::NAME).exists() {
            return;
        }
        if let Ok((mut waiting, entries)) = WaitingFile::open(&self.path)
            && !waiting.is_empty()
            && self.library.store_missing(&entries).is_ok()
        {
            // Otherwise the next call finds that the library has them.
            drop(waiting.clear());
        }
    }

    fn close_left(&mut self, weld: WeldRecord, cause: Option<&Message>) -> Result<Recovered, Error> {
        let folder = self.weld_folder(weld.id);
        let parts = if folder.exists() { trace::recover(&folder)? } else { Vec::new() };
        let rows = parts.iter().map(|p| p.rows).sum();
        let unread_bytes: u64 = parts.iter().map(|p| p.unread_bytes).sum();
        let log = weld_log::read(&folder)?;
        let lasted = lasted(&log);
        let summary = LogSummary::of(&log);
        let result = match weld.result {
            WeldResult::Running if lasted.is_none() => WeldResult::Interrupted,
            WeldResult::Running => summary.result(),
            known => known,
        };
        let recovered = |code| Message::new(code).text("time", Moment::now().to_string());
        let mut notes = vec![weld.note, summary.note(), missing(&log).unwrap_or_default()];
        notes.push(match (lasted, unread_bytes, cause) {
            (Some(_), 0, _) => Message::default(),
            (None, 0, Some(cause)) => Message::new("record-interrupted").message("cause", cause.clone()),
            (_, 0, _) => recovered("record-recovered"),
            (_, n, _) => recovered("record-recovered-without").quantity("size", n as f64, Unit::Byte, 0),
        });
        let last = lasted.map_or_else(|| last_written(&folder, weld.begun), |ms| weld.begun.after_ms(ms));
        // A clock that was set back in between makes no weld end before it began.
        let ended = weld.ended.unwrap_or(last.max(weld.begun));
        // The library has the events of a weld that it knows to be over.
        let events = if weld.result == WeldResult::Running { summary.events } else { Vec::new() };
        let end = Settled { result, ended, note: joined(notes), events };
        let weld = settle(self, weld.id, &folder, end)?;
        Ok(Recovered { weld, rows, unread_bytes })
    }

    /// Checks the database, the audit log, and the hash of every file and text that the library names.
    ///
    /// # Errors
    /// If the library cannot be read at all; other faults are in the result.
    pub fn verify(&self) -> Result<Verified, Error> {
        let mut problems = self.library.integrity()?;
        problems.extend(self.library.foreign_schema()?);
        let audit = self.library.verify_audit()?;
        let of = |code, id: i64| Message::new(code).number("id", id as f64, 0);
        let broken = audit.broken.as_ref();
        problems.extend(broken.map(|(id, why)| of("record-problem-audit", *id).message("why", why.clone())));
        problems.extend(
            self.lost_welds()?
                .into_iter()
                .map(|id| of("record-problem-lost", id).text("folder", self.weld_folder(id).display().to_string())),
        );
        let (mut files, welds) = (0, self.library.find(&crate::library::Query::default())?);
        for weld in &welds {
            let folder = self.weld_folder(weld.id);
            if weld.result == WeldResult::Running || (folder.exists() && has_raw(&folder)?) {
                problems.push(of(if is_written(&folder) { UNFINISHED } else { LEFT_UNFINISHED }, weld.id));
            }
            let program = self.library.program_of(weld.id)?;
            if hash_of(&program.text) != program.sha256 {
                problems.push(of("record-problem-program", weld.id));
            }
            for file in self.library.files(weld.id)? {
                let path = folder.join(&file.name);
                match sha256_of_file(&path) {
                    Ok((hash, _)) if hash == file.sha256 => files += 1,
                    Ok(_) => {
                        problems.push(Message::new("record-problem-changed").text("path", path.display().to_string()));
                    }
                    Err(e) => problems.push(e.message()),
                }
            }
        }
        Ok(Verified { welds: welds.len(), files, audit, problems })
    }
}

/// Time of the last write to the files of a weld.
fn last_written(folder: &Path, begun: Moment) -> Moment {
    let modified = fs::read_dir(folder).into_iter().flatten().flatten();
    let modified = modified.filter_map(|f| f.metadata().ok()?.modified().ok()).max();
    let since = modified.and_then(|t| t.duration_since(std::time::UNIX_EPOCH).ok());
    since.map_or(begun, |d| Moment(i64::try_from(d.as_millis()).unwrap_or(i64::MAX)))
}

fn has_raw(folder: &Path) -> Result<bool, Error> {
    let entries = fs::read_dir(folder).map_err(|e| Error::io(folder, Doing::Read, e))?;
    Ok(entries.flatten().any(|f| f.path().extension().is_some_and(|e| e == "raw")))
}
