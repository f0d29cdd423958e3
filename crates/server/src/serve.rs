use crate::cell::Cell;
use crate::connections::answer;
use crate::http::{Panel, app};
use crate::tls::{self, Tls};
use crate::users::{Accounts, secret};
use seamwright_machine::Machine;
use seamwright_project::files;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use tokio::net::TcpListener;

/// What a panel is started with.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Where it listens.
    pub bind: SocketAddr,
    /// Names under which it is asked for from elsewhere.
    pub names: Vec<String>,
    /// Encrypted; always, if it listens to more than this computer.
    pub tls: Option<Tls>,
    /// Where records, jobs and users are; made if missing.
    pub data: PathBuf,
    /// The machine of the cell.
    pub machine: Machine,
    /// Where files that the machine file names are seen from.
    pub folder: PathBuf,
    /// Process values of the programs that come, for devices that are not simulated.
    pub values: Vec<String>,
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
    let system = |e: &dyn std::fmt::Display| Error::System(e.to_string());
    let jobs = settings.data.join("jobs");
    files::make_private(&jobs).map_err(|e| Error::System(format!("{}: cannot be made: {e}", jobs.display())))?;
    let accounts = Accounts::open(&settings.data).map_err(|e| Error::Settings(e.0))?;
    let names = names(settings, &accounts)?;
    let key = secret().map_err(Error::System)?;
    let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build();
    let runtime = runtime.map_err(|e| system(&e))?;
    runtime.block_on(async {
        let tls = match &settings.tls {
            Some(tls) => Some(tls::config(tls, &settings.data, &names).await?),
            None => None,
        };
        let listener = TcpListener::bind(settings.bind).await.map_err(|e| {
            Error::System(format!("--bind {}: {e}\n   allowed: an address and a port that is free", settings.bind))
        })?;
        let port = listener.local_addr().map_err(|e| system(&e))?.port();
        let cell = Cell::start(&settings.machine, &settings.folder, &settings.values, &settings.data)
            .map_err(Error::Settings)?;
        let has_admin = accounts.has_admin();
        let mut panel = Panel::new(cell, accounts, key.clone(), settings.data.clone(), hosts(&names, port));
        panel.tls = tls.is_some();
        let panel = Arc::new(panel);
        if let Some(job) = &settings.job {
            crate::http::begin_with(&panel, job).await.map_err(Error::Settings)?;
        }
        let scheme = if tls.is_some() { "https" } else { "http" };
        let host = written(names.last().map_or("127.0.0.1", String::as_str));
        let fragment = if has_admin { String::new() } else { format!("#key={key}") };
        ready(&format!("{scheme}://{host}:{port}/{fragment}"));
        tokio::select! {
            () = answer(listener, tls, app(&panel)) => {}
            () = asked_to_end() => {}
        }
        // Connections go on meanwhile: they see the end.
        let ends = Arc::clone(&panel);
        let ended = tokio::task::spawn_blocking(move || ends.cell.end()).await;
        ended.map_err(|e| system(&e))
    })
}

/// Names and addresses under which the panel is asked for, the one that is printed last.
fn names(settings: &Settings, accounts: &Accounts) -> Result<Vec<String>, Error> {
    let ip = settings.bind.ip();
    let mut names: Vec<String> = ["localhost", "::1", "127.0.0.1"].map(str::to_owned).to_vec();
    if ip.is_loopback() {
        names.retain(|name| *name != ip.to_string());
        names.extend(settings.names.iter().cloned());
        names.push(ip.to_string());
        return Ok(names);
    }
    let wrong = |why: &str, allowed: &str| {
        Err(Error::Settings(format!("--bind {}: {why}\n   allowed: {allowed}", settings.bind)))
    };
    if settings.tls.is_none() {
        return wrong(
            "is not this computer alone, and nothing is encrypted",
            "with --tls, or --cert and --key; 127.0.0.1, [::1]",
        );
    }
    if !accounts.has_admin() {
        let first = "127.0.0.1 or [::1], where you make an administrator with a password first";
        return wrong("is not this computer alone, and nobody has a password yet", first);
    }
    if ip.is_unspecified() && settings.names.is_empty() {
        return wrong("says no name under which it is asked for", "with --host NAME, or one address");
    }
    if !ip.is_unspecified() {
        names.push(ip.to_string());
    }
    names.extend(settings.names.iter().cloned());
    Ok(names)
}

/// A name as it stands in an address.
fn written(name: &str) -> String {
    if name.contains(':') { format!("[{name}]") } else { name.to_owned() }
}

/// What stands in the header `host` for these names; without the port where it is the usual one.
fn hosts(names: &[String], port: u16) -> Vec<String> {
    let usual = matches!(port, 80 | 443);
    let written = names.iter().map(|name| written(name));
    written.flat_map(|name| [Some(format!("{name}:{port}")), usual.then_some(name)]).flatten().collect()
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
