//! Browsers in which a user has logged in before. Wrong passwords from elsewhere do not lock them out.

use super::sessions::secret;
use crate::limits::{MAX_BROWSERS, MAX_BROWSERS_OF_USER};
use seamwright_log as log;
use seamwright_message::Message;
use seamwright_project::files;
use seamwright_record::{Moment, sha256};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// File name in the data folder.
const FILE: &str = "devices.json";
/// Maximum size of the file, bytes; larger than [`MAX_BROWSERS`] entries.
const MAX_FILE: u64 = 1 << 20;

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Device {
    /// SHA-256 of its cookie.
    id: String,
    user: String,
    /// Time of last use, ms since 1970 UTC.
    used: i64,
}

/// All remembered browsers, including those of earlier runs.
pub(crate) struct Devices {
    file: PathBuf,
    /// Devices by SHA-256 of their cookie.
    known: Mutex<HashMap<String, Device>>,
    /// One thread writes at a time, and at most one waits.
    writing: Mutex<()>,
    is_due: AtomicBool,
}

impl Devices {
    /// Reads the devices of a data folder. An unreadable file counts as empty; the next login writes a new one.
    pub(crate) fn open(folder: &Path) -> Self {
        let file = folder.join(FILE);
        let known = read(&file).unwrap_or_else(|why| {
            let message = Message::new("server-log-browsers-unknown").text("file", file.display().to_string());
            log::warn(&message.text("reason", why.to_string()));
            Vec::new()
        });
        let known = known.into_iter().take(MAX_BROWSERS).map(|device| (device.id.clone(), device)).collect();
        Self { file, known: Mutex::new(known), writing: Mutex::default(), is_due: AtomicBool::new(false) }
    }

    fn known(&self) -> MutexGuard<'_, HashMap<String, Device>> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns the identifier of the device with this cookie, if `user` has logged in on it.
    pub(crate) fn of(&self, cookie: &str, user: &str) -> Option<String> {
        let id = sha256(cookie.as_bytes());
        let mut known = self.known();
        let device = known.get_mut(&id).filter(|device| device.user == user)?;
        device.used = Moment::now().0;
        Some(id)
    }

    /// Remembers a new device of `user` and returns its cookie. [`Devices::save`] stores it for the next start.
    pub(crate) fn remember(&self, user: &str) -> Result<String, Message> {
        let cookie = secret()?;
        let mut known = self.known();
        let own = known.values().filter(|device| device.user == user).count();
        if own >= MAX_BROWSERS_OF_USER || known.len() >= MAX_BROWSERS {
            let candidates = known.iter().filter(|(_, device)| own < MAX_BROWSERS_OF_USER || device.user == user);
            let oldest = candidates.min_by_key(|(_, device)| device.used).map(|(id, _)| id.clone());
            oldest.map(|id| known.remove(&id));
        }
        let id = sha256(cookie.as_bytes());
        known.insert(id.clone(), Device { id, user: user.to_owned(), used: Moment::now().0 });
        Ok(cookie)
    }

    /// Forgets all devices of a user whose password or role changed.
    pub(crate) fn forget(&self, user: &str) {
        self.known().retain(|_, device| device.user != user);
    }

    /// Writes all devices. If the disk fails, they stay known until the program ends.
    pub(crate) fn save(&self) {
        // A thread that already waits to write includes this change.
        if self.is_due.swap(true, Ordering::SeqCst) {
            return;
        }
        let _writing = self.writing.lock().unwrap_or_else(PoisonError::into_inner);
        self.is_due.store(false, Ordering::SeqCst);
        let mut all: Vec<Device> = self.known().values().cloned().collect();
        all.sort_by(|a, b| a.id.cmp(&b.id));
        let text = serde_json::to_string(&all).map_err(|e| e.to_string());
        let written = text.and_then(|text| files::write_secret(&self.file, &text).map_err(|e| e.text()));
        if let Err(why) = written {
            log::warn(&Message::new("server-log-browsers-not-kept").text("reason", why));
        }
    }
}

fn read(file: &Path) -> Result<Vec<Device>, String> {
    match std::fs::metadata(file) {
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        Ok(there) if there.len() > MAX_FILE => return Err(format!("of {} bytes; allowed: {MAX_FILE}", there.len())),
        _ => {}
    }
    let text = std::fs::read_to_string(file).map_err(|e| e.to_string())?;
    serde_json::from_str(&text).map_err(|e| e.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn devices_are_of_one_user_and_bounded() {
        let folder = tempfile::tempdir().unwrap();
        let devices = Devices::open(folder.path());
        let ada = devices.remember("ada").unwrap();
        assert!(devices.of(&ada, "ada").is_some() && devices.of(&ada, "eve").is_none());
        assert!(devices.of("guess", "ada").is_none());
        (0..3 * MAX_BROWSERS_OF_USER).for_each(|_| drop(devices.remember("eve").unwrap()));
        assert_eq!(devices.known().len(), MAX_BROWSERS_OF_USER + 1);
        assert!(devices.of(&ada, "ada").is_some());
        devices.forget("ada");
        assert!(devices.of(&ada, "ada").is_none());
    }

    /// Devices survive a restart. The file contains no cookie, and only its owner can read it.
    #[test]
    fn devices_outlive_the_program() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join(FILE);
        let devices = Devices::open(folder.path());
        let (ada, eve) = (devices.remember("ada").unwrap(), devices.remember("eve").unwrap());
        devices.forget("eve");
        devices.save();
        let text = std::fs::read_to_string(&file).unwrap();
        assert!(!text.contains(&ada) && text.contains("ada"));
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt as _;
            assert_eq!(std::fs::metadata(&file).unwrap().permissions().mode() & 0o077, 0);
        }
        let devices = Devices::open(folder.path());
        assert!(devices.of(&ada, "ada").is_some() && devices.of(&eve, "eve").is_none());
        for broken in ["", "[{}]"] {
            std::fs::write(&file, broken).unwrap();
            assert!(Devices::open(folder.path()).of(&ada, "ada").is_none());
        }
    }
}
