use crate::cell::Cell;
use crate::http::{Panel, app};
use crate::users::{Accounts, secret};
use seamwright_machine::Machine;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use tokio::net::TcpListener;

/// What a panel is started with.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Where it listens.
    pub bind: SocketAddr,
    /// Where records, jobs and users are; made if missing.
    pub data: PathBuf,
    /// The machine of the cell.
    pub machine: Machine,
    /// Name of a job in `data` or of an example to begin with.
    pub job: Option<String>,
}

/// What keeps a panel from being served.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// Settings that cannot be.
    #[error("{0}")]
    Settings(String),
    /// The system refuses.
    #[error("{0}")]
    System(String),
}

/// Serves the panel until it is told to end (SIGINT, SIGTERM): then everything stops, power goes, and it returns. `ready` is
/// told the address once it answers.
///
/// # Errors
/// See [`Error`].
pub fn serve(settings: &Settings, ready: impl FnOnce(&str)) -> Result<(), Error> {
    if !settings.bind.ip().is_loopback() {
        let why = "is not this computer alone: that needs an encrypted connection, which this version does not have";
        let cure = "allowed: 127.0.0.1 or [::1]; from elsewhere through an SSH tunnel";
        return Err(Error::Settings(format!("--bind {}: {why}\n   {cure}", settings.bind)));
    }
    let system = |e: &dyn std::fmt::Display| Error::System(e.to_string());
    let jobs = settings.data.join("jobs");
    std::fs::create_dir_all(&jobs).map_err(|e| Error::System(format!("{}: cannot be made: {e}", jobs.display())))?;
    let accounts = Accounts::open(&settings.data).map_err(|e| Error::Settings(e.0))?;
    let key = secret().map_err(Error::System)?;
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build();
    let runtime = runtime.map_err(|e| system(&e))?;
    runtime.block_on(async {
        let listener = TcpListener::bind(settings.bind).await.map_err(|e| {
            Error::System(format!("--bind {}: {e}\n   allowed: an address and a port that is free", settings.bind))
        })?;
        let port = listener.local_addr().map_err(|e| system(&e))?.port();
        let cell = Cell::start(&settings.machine, &settings.data).map_err(Error::Settings)?;
        let hosts = vec![format!("127.0.0.1:{port}"), format!("localhost:{port}"), format!("[::1]:{port}")];
        let has_admin = accounts.has_admin();
        let panel = Arc::new(Panel::new(cell, accounts, key.clone(), settings.data.clone(), hosts));
        if let Some(job) = &settings.job {
            crate::http::begin_with(&panel, job).await.map_err(Error::Settings)?;
        }
        let host = if settings.bind.is_ipv6() { "[::1]" } else { "127.0.0.1" };
        let fragment = if has_admin { String::new() } else { format!("#key={key}") };
        ready(&format!("http://{host}:{port}/{fragment}"));
        tokio::select! {
            served = axum::serve(listener, app(&panel)) => served.map_err(|e| system(&e))?,
            () = asked_to_end() => {}
        }
        // Connections go on meanwhile: they see the end.
        let ends = Arc::clone(&panel);
        let ended = tokio::task::spawn_blocking(move || ends.cell.end()).await;
        ended.map_err(|e| system(&e))
    })
}

async fn asked_to_end() {
    #[cfg(unix)]
    {
        use tokio::signal::unix::{SignalKind, signal};
        if let Ok(mut terminate) = signal(SignalKind::terminate()) {
            tokio::select! {
                _ = tokio::signal::ctrl_c() => {}
                _ = terminate.recv() => {}
            }
            return;
        }
    }
    // Without a handler it ends the hard way.
    drop(tokio::signal::ctrl_c().await);
}
