//! A thread that looks at the disk of the data folder: room, speed, and whether the library can be written.

use crate::wire::DiskView;
use seamwright_log as log;
use seamwright_message::{Message, Unit};
use seamwright_record::{DataFolder, DiskRoom, disk_room, probe_disk};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Period of looking.
const PERIOD: Duration = Duration::from_secs(5);
/// A small write that takes longer is reported.
const SLOW: Duration = Duration::from_secs(1);
/// Without a completed look for this time, the disk counts as hanging.
pub(super) const SILENT: Duration = Duration::from_secs(15);
/// Maximum wait for the disk at the end.
const PATIENCE: Duration = Duration::from_secs(10);

/// Result of a look.
#[derive(Debug, Clone, Default)]
pub(super) struct Look {
    pub(super) room: Option<DiskRoom>,
    /// Duration of a small write.
    wrote: Option<Duration>,
    /// Reason for which disk or library cannot be written.
    pub(super) trouble: Option<Message>,
}

#[derive(Debug)]
struct State {
    last: Option<Look>,
    /// End of the last look; before the first one the start.
    at: Instant,
    ends: bool,
    has_ended: bool,
}

#[derive(Debug)]
struct Shared {
    state: Mutex<State>,
    changed: Condvar,
}

impl Shared {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The thread that looks; it ends with this.
#[derive(Debug)]
pub(super) struct DiskProbe {
    folder: PathBuf,
    shared: Arc<Shared>,
}

impl DiskProbe {
    pub(super) fn start(folder: &Path) -> Self {
        let state = State { last: None, at: Instant::now(), ends: false, has_ended: false };
        let shared = Arc::new(Shared { state: Mutex::new(state), changed: Condvar::new() });
        let (its_folder, its) = (folder.to_owned(), Arc::clone(&shared));
        let started = std::thread::Builder::new().name("panel-disk".to_owned()).spawn(move || run(&its_folder, &its));
        if started.is_err() {
            shared.state().has_ended = true;
        }
        Self { folder: folder.to_owned(), shared }
    }

    /// Ends the thread and closes the library. Returns false if the disk keeps it from that.
    pub(super) fn close(&self) -> bool {
        let mut now = self.shared.state();
        now.ends = true;
        self.shared.changed.notify_all();
        let begun = Instant::now();
        while !now.has_ended && begun.elapsed() < PATIENCE {
            now = self.shared.changed.wait_timeout(now, PATIENCE).unwrap_or_else(PoisonError::into_inner).0;
        }
        now.has_ended
    }

    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Returns the last look, and the time since it ended; before the first one the time since the start.
    pub(super) fn last(&self) -> (Option<Look>, Duration) {
        let now = self.shared.state();
        (now.last.clone(), now.at.elapsed())
    }

    pub(super) fn view(&self) -> DiskView {
        let (look, age) = self.last();
        let Some(look) = look else { return DiskView { age_s: Some(age.as_secs_f64()), ..DiskView::default() } };
        DiskView {
            free_bytes: look.room.map(|room| room.free_bytes),
            total_bytes: look.room.map(|room| room.total_bytes),
            write_s: look.wrote.map(|time| time.as_secs_f64()),
            age_s: Some(age.as_secs_f64()),
        }
    }
}

impl Drop for DiskProbe {
    fn drop(&mut self) {
        self.shared.state().ends = true;
        self.shared.changed.notify_all();
    }
}

fn run(folder: &Path, shared: &Shared) {
    let mut data = None;
    loop {
        let look = look(folder, &mut data);
        let mut now = shared.state();
        (now.last, now.at) = (Some(look), Instant::now());
        let waited = shared.changed.wait_timeout_while(now, PERIOD, |now| !now.ends);
        let ends = waited.unwrap_or_else(PoisonError::into_inner).0.ends;
        if ends {
            drop(data);
            shared.state().has_ended = true;
            return shared.changed.notify_all();
        }
    }
}

fn look(folder: &Path, data: &mut Option<DataFolder>) -> Look {
    let begun = Instant::now();
    let written = probe_disk(folder);
    let took = begun.elapsed();
    if took > SLOW {
        let message = Message::new("server-log-disk-slow").text("folder", folder.display().to_string());
        log::warn(&message.quantity("time", took.as_secs_f64(), Unit::S, 1));
    }
    let wrote = written.is_ok().then_some(took);
    let trouble = written.and_then(|()| library(folder, data)).err().map(|e| e.message());
    Look { room: disk_room(folder).ok().flatten(), wrote, trouble }
}

/// Checks that the library can be written. It stays open.
fn library(folder: &Path, data: &mut Option<DataFolder>) -> Result<(), seamwright_record::Error> {
    let open = match data.take() {
        Some(open) => open,
        None => DataFolder::open(folder)?,
    };
    open.library().check_writable()?;
    *data = Some(open);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn looked(probe: &DiskProbe) -> Look {
        let begun = Instant::now();
        loop {
            if let Some(look) = probe.last().0 {
                return look;
            }
            assert!(begun.elapsed() < Duration::from_secs(60), "it does not look");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    #[test]
    fn a_disk_that_takes_data_has_no_trouble() {
        let folder = tempfile::tempdir().unwrap();
        let probe = DiskProbe::start(folder.path());
        let look = looked(&probe);
        assert!(look.trouble.is_none() && look.wrote.is_some(), "{look:?}");
        assert!(probe.close());
        let view = probe.view();
        assert!(view.write_s.is_some() && view.free_bytes <= view.total_bytes, "{view:?}");
    }

    #[test]
    fn a_folder_that_is_gone_is_trouble() {
        let folder = tempfile::tempdir().unwrap();
        let probe = DiskProbe::start(&folder.path().join("missing"));
        assert!(looked(&probe).trouble.is_some());
        assert!(probe.close());
    }
}
