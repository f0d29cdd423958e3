use crate::cell::{Cell, Change, happening};
use crate::error::Error;
use crate::front::answer;
use crate::http::Panel;
use crate::planner::Planner;
use crate::service_manager;
use crate::syslog::{Syslog, SyslogReceiver};
use crate::teaching::Cameras;
use crate::tls::{self, Tls};
use crate::users::{Accounts, secret};
use seamwright_cell::{CellStart, MachineSource};
use seamwright_executive::realtime::{Shutdown, ShutdownCause};
use seamwright_log as log;
use seamwright_message::Message;
use seamwright_project::failure::with_allowed;
use seamwright_project::files;
use seamwright_record::{discard_checked, finish_replacing, replace_by_checked};
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;
use tokio::net::TcpListener;
use tokio::runtime::{Handle, Runtime};

/// Maximum time for threads to stop reading data before the data is replaced.
const PATIENCE: Duration = Duration::from_secs(30);
/// Delay between the answer to a restore request and the end of connections.
const LAST_WORDS: Duration = Duration::from_millis(200);

/// Settings of a panel.
#[derive(Debug, Clone)]
pub struct Settings {
    /// Listening address.
    pub bind: SocketAddr,
    /// Names under which other computers reach the panel.
    pub names: Vec<String>,
    /// Encryption; required if the panel listens to more than this computer.
    pub tls: Option<Tls>,
    /// Folder of records, jobs and users; created if missing.
    pub data: PathBuf,
    /// The machine of the cell.
    pub machine: MachineSource,
    /// Process values of programs to come, for devices that are not simulated.
    pub values: Vec<String>,
    /// Addresses, `HOST` or `HOST:PORT`, allowed as source of camera frames beside this computer.
    pub cameras: Vec<String>,
    /// This program, started as child processes: one for the cell, and one for each plan and draft, with limits of memory
    /// and time. `None`: all of it in this process.
    pub program: Option<PathBuf>,
    /// Token with which monitoring tools on other computers read `/metrics` and `/readyz` without a session.
    pub monitor_token: Option<String>,
    /// Name of a job in `data`, or of an example, loaded at the start.
    pub job: Option<String>,
    /// Receiver of audit log and alarms beside the library.
    pub syslog: Option<SyslogReceiver>,
}

/// Polling period for a signal or a fault.
const LOOK: Duration = Duration::from_millis(20);

/// Serves the panel until a signal (SIGINT, SIGTERM, SIGHUP and similar) or a fault of the program.
/// Then the process is off within a cycle, axes stop, power is switched off, and records are closed before it returns.
/// Calls `ready` with the address once the panel answers.
///
/// # Errors
/// See [`Error`]; also [`Error::System`] if a device does not confirm that its outputs are safe.
pub fn serve(settings: &Settings, ready: impl FnOnce(&str)) -> Result<(), Error> {
    let shutdown = Shutdown::default();
    shutdown.on_signals().map_err(|e| Error::system(&e))?;
    shutdown.on_panic();
    until(settings, ready, &shutdown)
}

/// Serves until `shutdown`: one life of the cell after another, with restored data between them.
pub(crate) fn until(settings: &Settings, ready: impl FnOnce(&str), shutdown: &Shutdown) -> Result<(), Error> {
    let data = &settings.data;
    let jobs = data.join("jobs");
    let record = |e: seamwright_record::Error| Error::System(e.message());
    finish_replacing(data).map_err(record)?;
    // An archive that was checked before the last end must be checked again.
    discard_checked(data).map_err(record)?;
    let mut ready = Some(ready);
    let mut lives =
        Lives { settings, shutdown, key: secret().map_err(|e| Error::system(&e))?, listener: None, restored: None };
    loop {
        files::make_private(&jobs).map_err(|e| Error::System(files::not_writable(&jobs, &e).message()))?;
        // One runtime for stops, sockets and signals, one for the work of handlers: see `front`.
        let (runtime, work) = (threads("panel-front")?, threads("panel-routes")?);
        let tell = |address: &str| {
            if let Some(ready) = ready.take() {
                ready(address);
            }
        };
        let restores = runtime.block_on(lives.live(tell, work.handle()));
        // Ends pages and all other readers of the data.
        work.shutdown_timeout(PATIENCE);
        runtime.shutdown_timeout(PATIENCE);
        let restores = restores?;
        if shutdown.cause() == Some(ShutdownCause::Panic) {
            return Err(Error::System(Message::new("server-panicked")));
        }
        let Some(user) = restores else { return Ok(()) };
        let kept = replace_by_checked(data).map_err(record)?;
        lives.restored = Some((user, kept.file_name().unwrap_or_default().to_string_lossy().into_owned()));
    }
}

fn threads(name: &str) -> Result<Runtime, Error> {
    let runtime = tokio::runtime::Builder::new_multi_thread().thread_name(name).worker_threads(2).enable_all().build();
    runtime.map_err(|e| Error::system(&e))
}

/// State that outlives a restore.
struct Lives<'a> {
    settings: &'a Settings,
    /// Ends all lives.
    shutdown: &'a Shutdown,
    /// Key that opens the panel while there is no administrator.
    key: String,
    /// Clients that connect while the cell restarts wait here.
    listener: Option<std::net::TcpListener>,
    /// The user who restored the data of this life, and the folder of the old data.
    restored: Option<(String, String)>,
}

impl Lives<'_> {
    /// Runs the cell from its start to its end. Returns the user who restores data for the next life, if any.
    async fn live(&mut self, ready: impl FnOnce(&str), work: &Handle) -> Result<Option<String>, Error> {
        let settings = self.settings;
        let accounts = Accounts::open(&settings.data).map_err(|e| Error::Settings(e.0))?;
        let names = names(settings, &accounts)?;
        let tls = match &settings.tls {
            Some(tls) => Some(tls::encryption(tls, &settings.data, &names).await?),
            None => None,
        };
        let listener = self.listen()?;
        let port = listener.local_addr().map_err(|e| Error::system(&e))?.port();
        let start = CellStart { machine: settings.machine.clone(), values: settings.values.clone() };
        let cell = Cell::start(&start, &settings.data, settings.program.as_deref(), self.shutdown);
        let cell = cell.map_err(Error::Settings)?;
        if let Some(receiver) = &settings.syslog {
            cell.archive.send_to(Syslog::start(receiver.clone(), &cell.hub));
        }
        let has_admin = accounts.has_admin();
        let mut panel = Panel::new(cell, accounts, self.key.clone(), settings.data.clone(), hosts(&names, port));
        panel.tls = tls.is_some();
        panel.cameras = Cameras::new(settings.cameras.clone());
        panel.planner = Planner::new(settings.program.clone());
        panel.diagnostics.token.clone_from(&settings.monitor_token);
        panel.diagnostics.watch_disk(&settings.data);
        let panel = Arc::new(panel);
        self.say_restored(&panel);
        if let Some(job) = settings.job.as_ref().filter(|_| !panel.cell.has_program)
            && let Err(e) = crate::http::begin_with(&panel, job).await
        {
            if self.restored.is_none() {
                return Err(Error::Settings(e));
            }
            // The restored data may lack this job.
            panel.cell.hub.event(0.0, happening(Message::new("server-event-not-loaded").message("reason", e)));
        }
        let renewed = tls.clone().filter(|_| matches!(settings.tls, Some(Tls::Own)));
        let renews = renewed.map(|config| tokio::spawn(tls::renew(config, settings.data.clone(), names.clone())));
        let scheme = if tls.is_some() { "https" } else { "http" };
        let host = written(names.last().map_or("127.0.0.1", String::as_str));
        let fragment = if has_admin { String::new() } else { format!("#key={}", self.key) };
        let starts = Message::new("server-log-starts").text("version", env!("CARGO_PKG_VERSION"));
        log::info(&starts.text("address", format!("{scheme}://{host}:{port}/")));
        ready(&format!("{scheme}://{host}:{port}/{fragment}"));
        service_manager::ready();
        let mut restores = panel.restores.subscribe();
        let user = tokio::select! {
            () = answer(listener, tls, Arc::clone(&panel), work.clone()) => None,
            () = requested(self.shutdown) => None,
            wanted = restores.wait_for(Option::is_some) => wanted.ok().and_then(|w| w.as_ref().map(|w| w.0.clone())),
        };
        if let Some(task) = renews {
            task.abort();
        }
        if user.is_none() {
            service_manager::stopping();
        }
        log::info(&Message::new(if user.is_some() { "server-log-restores" } else { "server-log-ends" }));
        if user.is_some() {
            // The client that asked for it gets its answer first.
            tokio::time::sleep(LAST_WORDS).await;
        }
        // Connections stay open meanwhile, so that they see the end.
        let closes = user.is_some();
        let end = move || (panel.cell.end(), !closes || (panel.cell.archive.close() && panel.diagnostics.close()));
        let (unconfirmed, closed) = tokio::task::spawn_blocking(end).await.map_err(|e| Error::system(&e))?;
        if !closed {
            return Err(Error::System(Message::new("server-library-open")));
        }
        // A restarted cell connects the same devices, which makes their outputs safe, or ends.
        if user.is_none() && !unconfirmed.is_empty() {
            let unsafe_outputs = Message::new("project-with-hint").message("message", unconfirmed.join("\n").into());
            return Err(Error::System(unsafe_outputs.message("hint", Message::new("server-look-at-once"))));
        }
        Ok(user)
    }

    fn listen(&mut self) -> Result<TcpListener, Error> {
        let bind = self.settings.bind;
        let failed = |e| {
            let message = Message::new("server-bind").text("option", format!("--bind {bind}"));
            let message = message.message("why", Message::outside(&e));
            Error::System(with_allowed(message, Message::new("server-bind-free")))
        };
        if self.listener.is_none() {
            let listener = std::net::TcpListener::bind(bind).map_err(failed)?;
            listener.set_nonblocking(true).map_err(failed)?;
            self.listener = Some(listener);
        }
        let known = self.listener.as_ref().map(std::net::TcpListener::try_clone).transpose().map_err(failed)?;
        known.map_or_else(
            || Err(failed(std::io::ErrorKind::NotConnected.into())),
            |l| TcpListener::from_std(l).map_err(failed),
        )
    }

    fn say_restored(&self, panel: &Panel) {
        if let Some((user, kept)) = &self.restored {
            let (station, command) = (Message::new("server-audit-panel"), Message::new("server-audit-restore"));
            let result = Message::new("server-event-restored").text("folder", kept);
            panel.cell.archive.audit(user, station, command, Change::default(), result.clone());
            panel.cell.hub.event(0.0, happening(result).by(Some(user.clone())));
        }
    }
}

/// Returns names and addresses of the panel; the last one is printed.
fn names(settings: &Settings, accounts: &Accounts) -> Result<Vec<String>, Error> {
    let ip = settings.bind.ip();
    let mut names: Vec<String> = ["localhost", "::1", "127.0.0.1"].map(str::to_owned).to_vec();
    if ip.is_loopback() {
        names.retain(|name| *name != ip.to_string());
        names.extend(settings.names.iter().cloned());
        names.push(ip.to_string());
        return Ok(names);
    }
    let wrong = |why, allowed| {
        let message = Message::new("server-bind").text("option", format!("--bind {}", settings.bind));
        Err(Error::Settings(with_allowed(message.message("why", why), allowed)))
    };
    if settings.tls.is_none() {
        return wrong(Message::new("server-bind-plain"), Message::new("server-bind-encrypted"));
    }
    if !accounts.has_admin() {
        return wrong(Message::new("server-bind-no-admin"), Message::new("server-bind-local-first"));
    }
    if ip.is_unspecified() && settings.names.is_empty() {
        return wrong(Message::new("server-bind-no-name"), Message::new("server-bind-named"));
    }
    if !ip.is_unspecified() {
        names.push(ip.to_string());
    }
    names.extend(settings.names.iter().cloned());
    Ok(names)
}

/// Formats a name for use in a URL.
fn written(name: &str) -> String {
    if name.contains(':') { format!("[{name}]") } else { name.to_owned() }
}

/// Returns the valid values of header `host` for these names; without the port also valid if it is a default port.
fn hosts(names: &[String], port: u16) -> Vec<String> {
    let usual = matches!(port, 80 | 443);
    let written = names.iter().map(|name| written(name));
    written.flat_map(|name| [Some(format!("{name}:{port}")), usual.then_some(name)]).flatten().collect()
}

/// Waits for a shutdown. The cycle reads the flag itself and does not wait for this task.
async fn requested(shutdown: &Shutdown) {
    while !shutdown.is_requested() {
        tokio::time::sleep(LOOK).await;
    }
}
