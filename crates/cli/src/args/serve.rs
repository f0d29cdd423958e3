//! Arguments of `seamwright serve`.

use clap::{Args, ValueEnum};
use seamwright_server::SyslogReceiver;
use std::net::SocketAddr;
use std::path::PathBuf;

/// Help of the verb; without one the help of the whole program stands there.
pub(crate) const HELP: &str = "Example: seamwright serve --data cell --open

Open the printed address: until an administrator has a password, everybody with the address is an administrator. It runs
until Ctrl-C or SIGTERM: then everything stops and the power is switched off.
Access from other computers needs an administrator, a name and encryption:
  seamwright serve --bind 0.0.0.0:8443 --host cell.shop.example --tls
Log lines go to standard error. Monitoring tools read /healthz, /readyz and /metrics at the same address.
Without --data the folder is $SEAMWRIGHT_DATA, or else seamwright in $XDG_DATA_HOME (~/.local/share).";

#[derive(Debug, Args)]
pub(crate) struct ServeArgs {
    /// Address and port to listen on
    #[arg(long, value_name = "ADDRESS", default_value = "127.0.0.1:8080")]
    pub(crate) bind: SocketAddr,
    /// Name of this computer for access from other computers; may be repeated
    #[arg(long, value_name = "NAME")]
    pub(crate) host: Vec<String>,
    /// Encrypt, with a certificate from the cell's own authority (DIR/tls/ca.pem, to be installed in browsers)
    #[arg(long)]
    pub(crate) tls: bool,
    /// Encrypt, with this certificate (PEM)
    #[arg(long, value_name = "FILE", requires = "key", conflicts_with = "tls")]
    pub(crate) cert: Option<PathBuf>,
    /// The certificate's private key (PEM)
    #[arg(long, value_name = "FILE", requires = "cert")]
    pub(crate) key: Option<PathBuf>,
    /// Allowed source of camera frames beside this computer; may be repeated
    #[arg(long, value_name = "HOST[:PORT]")]
    pub(crate) camera: Vec<String>,
    /// Data folder: records, jobs, users
    #[arg(long, value_name = "DIR")]
    pub(crate) data: Option<PathBuf>,
    /// Shipped machine, or a machine file [default: that of the job]
    #[arg(long, value_name = "FILE")]
    pub(crate) machine: Option<String>,
    /// First job: a file, which is copied into the data folder, or the name of a job there or of an example [default: first-weld]
    #[arg(long, value_name = "FILE")]
    pub(crate) job: Option<String>,
    /// Send audit log and alarms to this syslog receiver too (RFC 5424): udp://HOST:514, tcp://HOST:514
    #[arg(long, value_name = "RECEIVER")]
    pub(crate) syslog: Option<SyslogReceiver>,
    /// Open the panel in the browser
    #[arg(long)]
    pub(crate) open: bool,
    /// Mildest level of log lines on standard error [default: $SEAMWRIGHT_LOG_LEVEL, or info]
    #[arg(long, value_enum, value_name = "LEVEL")]
    pub(crate) log_level: Option<LogLevelArg>,
    /// Format of log lines [default: $SEAMWRIGHT_LOG_FORMAT, or journal under systemd, else text]
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub(crate) log_format: Option<LogFormatArg>,
    /// File with the token of monitoring tools on other computers: they send it instead of a session
    #[arg(long, value_name = "FILE")]
    pub(crate) monitor_token: Option<PathBuf>,
}

/// Levels of log lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum LogLevelArg {
    Error,
    Warn,
    Info,
    Debug,
}

/// Formats of log lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum LogFormatArg {
    /// Time, level, words, code and arguments
    Text,
    /// A JSON object a line
    Json,
    /// For the journal of systemd: priority, words, code and arguments
    Journal,
}

/// Of STOP.
#[derive(Debug, Args)]
pub(crate) struct StopArgs {
    /// Data folder of the running panel
    #[arg(long, value_name = "DIR")]
    pub(crate) data: Option<PathBuf>,
}

/// Of the process of a cell.
#[derive(Debug, Args)]
pub(crate) struct CellArgs {
    /// Folder of the sockets of its panel and of STOP
    #[arg(long, value_name = "DIR")]
    pub(crate) sockets: PathBuf,
    /// Read the machine from standard input, as JSON
    #[arg(long, required = true)]
    pub(crate) start_on_input: bool,
}

/// Of the process that answers one question of the panel.
#[derive(Debug, Args)]
pub(crate) struct QuestionArgs {
    /// Folder of the jobs
    #[arg(long, value_name = "DIR")]
    pub(crate) jobs: PathBuf,
}
