//! The sockets of a cell, in a private folder.

use seamwright_message::Message;
use std::io;
use std::os::unix::fs::PermissionsExt as _;
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::{Path, PathBuf};

/// Name of the panel's socket.
const PANEL: &str = "panel.sock";
/// Name of the socket of STOP.
const STOP: &str = "stop.sock";

/// The listening sockets of a cell: one for its panel, one for STOP.
#[derive(Debug)]
pub struct Listeners {
    pub(crate) panel: UnixListener,
    pub(crate) stop: UnixListener,
}

impl Listeners {
    /// Listens in `folder`, which is created if missing, for this user alone. Sockets left by a cell that has died are
    /// replaced.
    ///
    /// # Errors
    /// If another cell listens there, or the system refuses.
    pub fn bind(folder: &Path) -> Result<Self, Message> {
        let failed = |e: &io::Error| {
            let message = Message::new("cell-socket").text("folder", folder.display().to_string());
            message.message("why", Message::outside(e))
        };
        std::fs::create_dir_all(folder).map_err(|e| failed(&e))?;
        std::fs::set_permissions(folder, std::fs::Permissions::from_mode(0o700)).map_err(|e| failed(&e))?;
        let listen = |path: PathBuf| {
            if UnixStream::connect(&path).is_ok() {
                return Err(Message::new("cell-already-runs").text("folder", folder.display().to_string()));
            }
            match std::fs::remove_file(&path) {
                Err(e) if e.kind() != io::ErrorKind::NotFound => return Err(failed(&e)),
                _ => {}
            }
            UnixListener::bind(&path).map_err(|e| failed(&e))
        };
        let (panel, stop) = (listen(panel(folder))?, listen(self::stop(folder))?);
        panel.set_nonblocking(true).map_err(|e| failed(&e))?;
        Ok(Self { panel, stop })
    }
}

/// Path of the panel's socket.
pub(crate) fn panel(folder: &Path) -> PathBuf {
    folder.join(PANEL)
}

/// Path of the socket of STOP.
pub(crate) fn stop(folder: &Path) -> PathBuf {
    folder.join(STOP)
}
