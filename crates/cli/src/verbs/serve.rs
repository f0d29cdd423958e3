use crate::args::serve::{QuestionArgs, ServeArgs};
use crate::refusals::{not_json, refused};
use crate::rows::print_text;
use seamwright_cell::MachineSource;
use seamwright_message::Message;
use seamwright_project::examples::EXAMPLES;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_project::load::{Loaded, load_text, machine_and_file};
use seamwright_server::{Error, Settings, Tls, serve};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

pub(crate) fn run(args: &ServeArgs) -> Result<(), Failure> {
    // Written to its end when everything else has ended.
    let _logging = seamwright_log::start(super::log_settings::of(args)?);
    let monitor_token = args.monitor_token.as_deref().map(token).transpose()?;
    let data = super::records::folder(args.data.as_deref())?;
    seamwright_record::finish_replacing(&data)?;
    let jobs = data.join("jobs");
    files::make_private(&jobs).map_err(|e| {
        let message = Message::new("cli-serve-data").text("folder", data.display().to_string());
        Failure::input(message.message("why", Message::outside(&e)))
    })?;
    let job = match (&args.job, &args.machine) {
        (Some(job), _) => Some(taken(job, &jobs)?),
        (None, None) => Some(format!("{}.toml", EXAMPLES[0].name)),
        (None, Some(_)) => None,
    };
    let loaded = match &job {
        Some(job) => {
            let example =
                EXAMPLES.iter().find(|e| job.strip_suffix(".toml") == Some(e.name)).map(|e| e.text.to_owned());
            let path = jobs.join(job);
            let text = if path.is_file() { files::read(&path)? } else { example.unwrap_or_default() };
            Some(load_text(job, &text, &jobs)?)
        }
        None => None,
    };
    let values = loaded.as_ref().map_or(Vec::new(), |l| l.welding.program.value.process_values());
    let machine = match (&args.machine, loaded) {
        (Some(name), _) => named_machine(name)?,
        (None, Some(loaded)) => machine_of(&loaded)?,
        // Without a job there is a machine.
        (None, None) => named_machine("saddle-4axis")?,
    };
    let tls = match (&args.cert, &args.key) {
        (Some(cert), Some(key)) => Some(Tls::Files { cert: cert.clone(), key: key.clone() }),
        _ => args.tls.then_some(Tls::Own),
    };
    let (names, cameras, program) = (args.host.clone(), args.camera.clone(), this_program());
    let syslog = args.syslog.clone();
    let settings =
        Settings { bind: args.bind, names, tls, data, machine, values, cameras, program, monitor_token, job, syslog };
    let ready = |url: &str| {
        // Errors are ignored: the server runs without a reader of its output, too.
        drop(print_text(&format!("{url}\n")));
        if args.open {
            open(url);
        }
    };
    serve(&settings, ready).map_err(|e| match e {
        Error::Settings(text) => Failure::input(text),
        Error::System(text) => Failure::environment(text),
    })
}

/// The machine file or supplied machine of this name.
pub(super) fn named_machine(name: &str) -> Result<MachineSource, Failure> {
    let (_, document) = machine_and_file(name)?;
    let folder = Path::new(name).parent().unwrap_or(Path::new(".")).to_owned();
    Ok(MachineSource { name: name.to_owned(), text: document.text().to_owned(), folder })
}

/// The machine of a job.
fn machine_of(loaded: &Loaded) -> Result<MachineSource, Failure> {
    let name =
        loaded.machine_file.as_ref().map_or_else(|| loaded.machine.name.clone(), |file| file.display().to_string());
    Ok(MachineSource { name, text: loaded.machine_text()?, folder: loaded.folder().to_owned() })
}

/// Minimum length of a token: shorter ones can be guessed.
const MIN_TOKEN: usize = 16;

/// The token in a file: its only line.
fn token(file: &Path) -> Result<String, Failure> {
    let text = files::read(file)?;
    let token = text.trim();
    if token.len() < MIN_TOKEN || !token.chars().all(|c| c.is_ascii_graphic()) {
        let allowed = Message::new("cli-serve-tokens").count("min", MIN_TOKEN);
        return Err(refused("--monitor-token", file.display(), Message::new("cli-serve-no-token"), allowed));
    }
    Ok(token.to_owned())
}

/// Path of this program, to start it once more. The file may have been replaced since, so the system's handle of the
/// running program is preferred.
fn this_program() -> Option<PathBuf> {
    let running = Path::new("/proc/self/exe");
    if running.exists() { Some(running.to_owned()) } else { std::env::current_exe().ok() }
}

/// Answers one question of the panel, which has started this process for it.
pub(crate) fn answer_one_question(args: &QuestionArgs) -> Result<(), Failure> {
    seamwright_server::answer_one_question(&args.jobs).map_err(not_json)
}

/// The name of a job in the data folder: a file is taken there first.
fn taken(job: &str, jobs: &Path) -> Result<String, Failure> {
    let file = Path::new(job);
    let name = file.file_name().and_then(|n| n.to_str()).unwrap_or(job);
    let name = if name.ends_with(".toml") { name.to_owned() } else { format!("{name}.toml") };
    if !file.is_file() {
        let known = jobs.join(&name).is_file() || EXAMPLES.iter().any(|e| name == format!("{}.toml", e.name));
        if known {
            return Ok(name);
        }
        let names: Vec<&str> = EXAMPLES.iter().map(|e| e.name).collect();
        let allowed = Message::new("cli-serve-jobs").text("folder", jobs.display().to_string());
        let allowed = allowed.text("examples", names.join(", "));
        return Err(refused("--job", job, Message::new("cli-serve-no-job"), allowed));
    }
    let text = files::read(file)?;
    let inside = jobs.join(&name);
    let there = if inside.is_file() { Some(files::read(&inside)?) } else { None };
    match there {
        Some(other) if other != text => {
            let allowed = Message::new("cli-serve-other-name").text("name", name);
            Err(refused("--job", job, Message::new("cli-serve-other-job"), allowed))
        }
        Some(_) => Ok(name),
        None if EXAMPLES.iter().any(|e| e.text == text && name == format!("{}.toml", e.name)) => Ok(name),
        None => {
            // An invalid job is refused.
            load_text(job, &text, jobs)?;
            files::write(&inside, &text).map(|()| name)
        }
    }
}

/// Opens an address in the browser, as the system does it.
fn open(url: &str) {
    let opener = if cfg!(target_os = "macos") { "open" } else { "xdg-open" };
    // Errors are ignored: without a browser the printed address remains.
    drop(Command::new(opener).arg(url).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).spawn());
}
