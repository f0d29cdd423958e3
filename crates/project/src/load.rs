//! From files to a planned weld.

use crate::examples::{EXAMPLES, example};
use crate::failure::{Failure, with_hint};
use crate::file_scope::FileScope;
use crate::file_store::FileStore;
use crate::files::{self, io_error};
use crate::outside_data::Beside;
use crate::planning::{Clocked, Planning};
use crate::torch_angles::{SearchedTorch, is_stopped};
use seamwright_document::{Document, closest};
use seamwright_executive::Error;
use seamwright_machine::{Clamped, Machine, MachineFile, Role, SHIPPED, Surroundings, Word, shipped};
use seamwright_message::{Message, Unit};
use seamwright_motion::{MetalByPass, PassMotion, Terms, WeldMotion, redundancy};
use seamwright_program::{Finding, Pass, TorchPath};
use seamwright_simulation::check_drives;
use seamwright_weld::{SeamCurve, WeldPath, Welding};
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A job or program with its machine.
pub struct Loaded {
    /// The job as a program with its seam.
    pub welding: Welding,
    /// Its machine.
    pub machine: Machine,
    /// Part and fixtures.
    pub clamped: Clamped,
    /// The machine file, if it is not one that ships.
    pub machine_file: Option<PathBuf>,
    /// Findings of the search of torch angles: passes without any that keep them clear, and warnings.
    pub(crate) angle_findings: Vec<Finding>,
    /// Torches whose angles were searched.
    pub(crate) searched_torches: Vec<SearchedTorch>,
    /// Time of that search.
    pub(crate) searching: Duration,
    /// STL files that job and machine file name: the name, and where the file is.
    pub stl_files: Vec<(String, PathBuf)>,
    /// Source of its files.
    pub(crate) store: FileStore,
}

/// Reads a job or program file and its machine; without such a file the name may be that of an example. A folder is no
/// file: it may be the output of an example's plan.
pub fn load(path: &Path) -> Result<Loaded, Failure> {
    let (found, example) = (std::fs::metadata(path), path.to_str().and_then(example));
    let missing = found.as_ref().is_err_and(|e| e.kind() == std::io::ErrorKind::NotFound);
    if missing && example.is_none() {
        return Err(no_such_job(path));
    }
    if let Some(example) = example.filter(|_| missing || found.is_ok_and(|found| found.is_dir())) {
        // A shipped example uses the shipped machine: a machine file in this folder may be another machine.
        let (name, here) = (format!("{}.toml", example.name), FileScope::open(Path::new(".")));
        return load_within(&name, example.text, &here, Own::Never);
    }
    load_text(&path.display().to_string(), &files::read(path)?, path.parent().unwrap_or(Path::new(".")))
}

/// A job that is neither a file nor an example.
fn no_such_job(path: &Path) -> Failure {
    let names: Vec<&str> = EXAMPLES.iter().map(|example| example.name).collect();
    let stem = path.file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
    let message = Message::new("project-no-such-file").text("file", path.display().to_string());
    let message = match closest(stem, &names) {
        Some(name) => with_hint(message, Message::new("project-copy-example").text("name", name)),
        None => message,
    };
    Failure::refused(message, Message::new("project-job-or-example").text("names", names.join(", ")))
}

/// The same from text; machine files are looked for from `folder`.
pub fn load_text(name: &str, text: &str, folder: &Path) -> Result<Loaded, Failure> {
    load_within(name, text, &FileScope::open(folder), Own::First)
}

/// The same with files of `store`.
///
/// # Errors
/// As [`load_text`].
pub fn load_text_from(name: &str, text: &str, folder: &Path, store: &FileStore) -> Result<Loaded, Failure> {
    load_within(name, text, &FileScope::of(folder, store.clone()), Own::First)
}

/// The same for a text whose author may not read all files: only plain files in `folder` and below are read.
pub fn load_foreign(name: &str, text: &str, folder: &Path) -> Result<Loaded, Failure> {
    load_within(name, text, &FileScope::fenced(folder), Own::First)
}

fn load_within(name: &str, text: &str, within: &FileScope<'_>, own: Own) -> Result<Loaded, Failure> {
    let welding = Welding::read_with(name, text, &Beside::new(within.clone()))?;
    let wanted = &welding.program.value.machine;
    let stl = StlFiles::default();
    let (machine, machine_file) = match described(wanted, within, &stl, own)? {
        Some(Described { machine, file, .. }) => (machine, file),
        None => {
            let file = within.folder().join(wanted).display().to_string();
            let message = Message::new("project-no-machine-or-file").text("file", file);
            let mut error = welding.program.error_at("machine", message, machine_names());
            error.help = machine_meant(wanted);
            return Err(error.into());
        }
    };
    finished(welding, MachineFound { machine, file: machine_file }, within, stl)
}

/// A machine that is read already, with its file if it does not ship.
#[derive(Debug, Clone)]
pub struct MachineFound {
    /// The machine.
    pub machine: Machine,
    /// Its file.
    pub file: Option<PathBuf>,
}

/// The job of a text on a machine that is read already: that of the job, perhaps with errors. Files are looked for from
/// `folder`.
///
/// # Errors
/// Faults of the job.
pub fn load_text_on(name: &str, text: &str, folder: &Path, machine: MachineFound) -> Result<Loaded, Failure> {
    load_text_on_from(name, text, folder, machine, &FileStore::Disk)
}

/// The same with files of `store`.
///
/// # Errors
/// As [`load_text_on`].
pub fn load_text_on_from(
    name: &str,
    text: &str,
    folder: &Path,
    machine: MachineFound,
    store: &FileStore,
) -> Result<Loaded, Failure> {
    let within = FileScope::of(folder, store.clone());
    let welding = Welding::read_with(name, text, &Beside::new(within.clone()))?;
    finished(welding, machine, &within, StlFiles::default())
}

/// Checks a job against its machine, and reads what is clamped.
fn finished(
    welding: Welding,
    MachineFound { machine, file: machine_file }: MachineFound,
    within: &FileScope<'_>,
    stl: StlFiles,
) -> Result<Loaded, Failure> {
    let process = welding.program.value.passes.iter().flat_map(|p| &p.spans).flat_map(|s| s.process.keys());
    if let Some(clash) = process.into_iter().find(|name| machine.axis(name).is_some()) {
        let message = Message::new("project-process-value-is-axis").axis("name", clash);
        return Err(welding.program.error_at("machine", message, Message::new("document-own-names")).into());
    }
    check_held(&welding, &machine)?;
    check_registers(&welding, &machine)?;
    let clamped = welding.clamped(&|name| stl.read(within, name))?;
    Ok(Loaded {
        welding,
        machine,
        machine_file,
        clamped,
        angle_findings: Vec::new(),
        searched_torches: Vec::new(),
        searching: Duration::ZERO,
        stl_files: stl.0.into_inner(),
        store: within.store().clone(),
    })
}

/// Refuses held axes that torch poses need, or outside their ranges.
fn check_held(welding: &Welding, machine: &Machine) -> Result<(), Failure> {
    let program = &welding.program;
    for (i, pass) in program.value.passes.iter().enumerate() {
        if let Err(error) = redundancy::holding(machine, &pass.spare_axes) {
            let path = welding.keys(i).of(&format!("spare_axes.hold.{}", error.axis));
            return Err(program.error_at(&path, error.message, error.allowed).into());
        }
    }
    Ok(())
}

/// Refuses process values that the registers of the machine's process source cannot hold: they would be cut off while welding.
fn check_registers(welding: &Welding, machine: &Machine) -> Result<(), Failure> {
    let program = &welding.program;
    for device in &machine.devices.modbus {
        for register in &device.registers {
            let (Role::Set(name), Word::Number(number)) = (&register.role, register.place.word) else { continue };
            let (low, high) = number.range();
            for (i, pass) in program.value.passes.iter().enumerate() {
                let Some((least, most)) = pass.process_range(name) else { continue };
                let outside = [least, most].into_iter().find(|value| !(low..=high).contains(value));
                let Some(value) = outside else { continue };
                let message = Message::new("project-register-too-small").pass("pass", i + 1).key("name", name);
                let message = message.value("value", value, Unit::One).text("register", register.place.to_string());
                let message = message.text("device", &device.name);
                let allowed = Message::new("project-register-range").value("min", low, Unit::One);
                let allowed = allowed.value("max", high, Unit::One);
                return Err(program.error_at(&welding.keys(i).process(name), message, allowed).into());
            }
        }
    }
    Ok(())
}

/// STL files read so far: the name by which a file names them, and where they are.
#[derive(Default)]
struct StlFiles(RefCell<Vec<(String, PathBuf)>>);

impl StlFiles {
    fn read(&self, within: &FileScope<'_>, name: &str) -> std::io::Result<Vec<u8>> {
        let path = within.file(name)?;
        let bytes = within.store().bytes(&path)?;
        self.0.borrow_mut().push((name.to_owned(), path));
        Ok(bytes)
    }
}

/// The shipped machine whose name is closest to the unknown `name`.
fn machine_meant(name: &str) -> Option<Message> {
    let known: Vec<&str> = SHIPPED.iter().map(|shipped| shipped.name).collect();
    let stem = Path::new(name).file_stem().and_then(|stem| stem.to_str()).unwrap_or_default();
    closest(stem, &known).map(|meant| Message::new("document-suggestion").key("name", meant))
}

fn machine_names() -> Message {
    let names: Vec<&str> = SHIPPED.iter().map(|s| s.name).collect();
    Message::new("project-machine-names").text("names", names.join(", "))
}

/// The machine that a job names; `None` if it is missing.
pub(crate) fn machine_beside(name: &str, within: &FileScope<'_>) -> Result<Option<Machine>, Failure> {
    Ok(described(name, within, &StlFiles::default(), Own::First)?.map(|found| found.machine))
}

/// The machine that a job among those in `folder` names; `None` if it is missing.
///
/// # Errors
/// An unreadable machine file, or one outside the folder.
pub fn machine_among(name: &str, folder: &Path) -> Result<Option<Machine>, Failure> {
    machine_beside(name, &FileScope::fenced(folder))
}

/// A cell's own copy of a shipped machine, relative to its jobs: it holds the results of calibration and tuning.
pub(crate) fn own_copy(name: &str) -> String {
    format!("machines/{name}.toml")
}

/// Whether a cell's own copy of a machine that ships goes before it.
#[derive(Clone, Copy, PartialEq)]
enum Own {
    First,
    Never,
}

/// A machine with its file.
struct Described {
    machine: Machine,
    document: Document<MachineFile>,
    /// Path of the file, if it does not ship.
    file: Option<PathBuf>,
}

/// The machine called `name`, or in the file `name`; `None` without either.
fn described(name: &str, within: &FileScope<'_>, stl: &StlFiles, own: Own) -> Result<Option<Described>, Failure> {
    let mut wanted = name.to_owned();
    if let Some(shipped) = shipped(name) {
        wanted = own_copy(shipped.name);
        if own == Own::Never || !within.store().has(&within.folder().join(&wanted)) {
            let (machine, document) = checked(shipped.name, shipped.text, within, stl)?;
            return Ok(Some(Described { machine, document, file: None }));
        }
    }
    let name = wanted.as_str();
    let path = match within.file(name) {
        Ok(path) if within.store().has(&path) => path,
        Err(e) if e.kind() == std::io::ErrorKind::PermissionDenied => {
            let message = Message::new("project-machine-refused").text("name", name).message("why", io_error(&e));
            return Err(Failure::refused(message, Message::new("project-machine-among-jobs")));
        }
        _ => return Ok(None),
    };
    let (machine, document) =
        checked(&path.display().to_string(), &within.store().text(&path)?, &within.beside(&path), stl)?;
    Ok(Some(Described { machine, document, file: Some(path) }))
}

/// The machine of a text, treated as a file in `folder`; files outside that folder are refused.
///
/// # Errors
/// Any fault of the text.
pub fn machine_foreign(name: &str, text: &str, folder: &Path) -> Result<Machine, Failure> {
    checked(name, text, &FileScope::fenced(folder), &StlFiles::default()).map(|(machine, _)| machine)
}

/// The machine of a text, treated as a file in `folder`.
///
/// # Errors
/// Any fault of the text.
pub fn machine_text(name: &str, text: &str, folder: &Path) -> Result<Machine, Failure> {
    checked(name, text, &FileScope::open(folder), &StlFiles::default()).map(|(machine, _)| machine)
}

/// The same with files of `store`.
///
/// # Errors
/// Any fault of the text.
pub fn machine_text_from(name: &str, text: &str, folder: &Path, store: &FileStore) -> Result<Machine, Failure> {
    checked(name, text, &FileScope::of(folder, store.clone()), &StlFiles::default()).map(|(machine, _)| machine)
}

/// A machine file with its drives checked too, so that no later step is the first to stumble over them.
fn checked(
    file: &str,
    text: &str,
    within: &FileScope<'_>,
    stl: &StlFiles,
) -> Result<(Machine, Document<MachineFile>), Failure> {
    let machine = Machine::read_with(file, text, &|name| stl.read(within, name))?;
    let document = MachineFile::read(file, text)?;
    match check_drives(&machine) {
        Err(Error::Drive { axis, reason }) => Err(document.error_at(&format!("drives.{axis}"), reason, "").into()),
        _ => Ok((machine, document)),
    }
}

/// The machine that a command line names.
pub fn machine(name: &str) -> Result<Machine, Failure> {
    machine_and_file(name).map(|(machine, _)| machine)
}

/// The machine that a command line names, with its file.
pub fn machine_and_file(name: &str) -> Result<(Machine, Document<MachineFile>), Failure> {
    let found = described(name, &FileScope::open(Path::new(".")), &StlFiles::default(), Own::Never)?;
    found.map(|found| (found.machine, found.document)).ok_or_else(|| {
        let message = Message::new("project-no-such-machine").text("name", name);
        let message = match machine_meant(name) {
            Some(meant) => with_hint(message, meant),
            None => message,
        };
        Failure::refused(message, machine_names())
    })
}

/// Maximum number of set-points of one motion: more are a mistake in a period or a speed. A day of every millisecond is
/// a tenth of them.
const MAX_SET_POINTS: f64 = 1e9;

impl Loaded {
    /// Folder of the machine file: files that it names are relative to it.
    pub fn folder(&self) -> &Path {
        self.machine_file.as_ref().and_then(|file| file.parent()).unwrap_or(Path::new("."))
    }

    /// The text of the machine file, or of the supplied machine.
    ///
    /// # Errors
    /// A machine file that has become unreadable.
    pub fn machine_text(&self) -> Result<String, Failure> {
        match &self.machine_file {
            Some(path) => self.store.text(path),
            None => Ok(shipped(&self.welding.program.value.machine).map_or_else(String::new, |s| s.text.to_owned())),
        }
    }

    /// Refuses motions with more set-points than any weld has, and periods that step over a whole pass.
    pub fn check_count(&self, motion: &WeldMotion, period_s: f64) -> Result<(), Failure> {
        let total: f64 = motion.passes.iter().map(PassMotion::total_s).sum();
        let count = total / period_s;
        let short = motion.passes.iter().position(|p| p.profile.duration() < period_s);
        if let Some(i) = short {
            let travel = motion.passes[i].profile.duration();
            let message = Message::new("project-period-too-long").pass("pass", i + 1);
            let allowed = Message::new("project-period-within-travel").quantity("max", travel * 1e3, Unit::Ms, 3);
            return Err(Failure::refused(message.value("period", period_s * 1e3, Unit::Ms), allowed));
        }
        if count <= MAX_SET_POINTS {
            return Ok(());
        }
        let message = Message::new("project-too-many-set-points").quantity("time", total, Unit::S, 0);
        let message = message.number("set-points", count, 0).value("period", period_s * 1e3, Unit::Ms);
        let allowed = Message::new("project-up-to-set-points").number("max", MAX_SET_POINTS, 0);
        Err(Failure::refused(message, allowed))
    }

    /// Reports the parts that the collision check does not cover, so that every plan mentions them.
    fn part_not_watched(&self) -> Option<Finding> {
        let (code, cure) = if self.clamped.part.is_empty() {
            ("project-part-not-checked", Some(Message::new("project-cure-describe-part")))
        } else if self.welding.program.value.part.replace {
            ("project-part-replaced", None)
        } else {
            return None;
        };
        Some(Finding {
            kind: "unchecked".into(),
            message: Message::new(code),
            pass: 1,
            from_mm: 0.0,
            to_mm: 0.0,
            cure,
            allowed: true,
        })
    }

    /// The seam.
    ///
    /// # Errors
    /// A program whose passes all go through points, without a seam.
    pub fn seam(&self) -> Result<&SeamCurve, Failure> {
        let program = &self.welding.program;
        let wrong = || {
            let allowed = Message::new("project-job-or-seam");
            program.error_at("", Message::new("project-program-without-seam"), allowed).into()
        };
        self.welding.seam.as_ref().ok_or_else(wrong)
    }

    /// Obstacles of the machine: itself and what is clamped on it.
    ///
    /// # Errors
    /// Solids whose clearance cannot be checked.
    pub fn surroundings(&self) -> Result<Surroundings<'_>, Failure> {
        Surroundings::new(&self.machine, &self.clamped).map_err(|e| self.fault(e.message()))
    }

    /// A fault of the job or program file.
    pub(crate) fn fault(&self, why: Message) -> Failure {
        let file = self.welding.program.file();
        Failure::Input(Message::new("project-in-file").text("file", file).message("why", why))
    }

    /// The paths of all passes.
    pub fn paths(&self) -> Vec<WeldPath<'_>> {
        (0..self.welding.program.value.passes.len()).map(|pass| self.welding.path(pass)).collect()
    }

    /// The passes with their paths, those of [`Loaded::paths`].
    pub fn passes<'a>(&'a self, paths: &'a [WeldPath<'a>]) -> Vec<(&'a dyn TorchPath, &'a Pass)> {
        let passes = &self.welding.program.value.passes;
        paths.iter().zip(passes).map(|(path, pass)| (path as &dyn TorchPath, pass)).collect()
    }

    /// Plans a weld that can be made as asked.
    pub fn plan(&self) -> Result<WeldMotion, Failure> {
        self.plan_on(&self.machine)
    }

    /// Plans the same on `machine`: this one, perhaps with a reserve.
    pub fn plan_on(&self, machine: &Machine) -> Result<WeldMotion, Failure> {
        self.plan_under(machine, &Planning::default())
    }

    /// Plans a weld that can be made as asked on `machine`, within the limits of `planning`.
    pub fn plan_under(&self, machine: &Machine, planning: &Planning) -> Result<WeldMotion, Failure> {
        match self.try_plan_under(machine, planning)? {
            Ok(motion) if motion.findings.iter().all(|f| f.allowed) => Ok(motion),
            Ok(motion) => Err(Failure::Findings(motion.findings)),
            Err(findings) => Err(Failure::Findings(findings)),
        }
    }

    /// Plans the weld, or returns the reasons why the machine cannot make it. Findings against the procedure are among
    /// those of the motion: the weld can be made, but violates the procedure.
    pub fn try_plan(&self) -> Result<Result<WeldMotion, Vec<Finding>>, Failure> {
        self.try_plan_under(&self.machine, &Planning::default())
    }

    /// Plans the weld on `machine` as [`Loaded::try_plan`] does, within the limits of `planning`.
    ///
    /// # Errors
    /// Also [`Failure::Cancelled`]. If the time is over, one of the findings is of kind `search`.
    pub fn try_plan_under(
        &self,
        machine: &Machine,
        planning: &Planning,
    ) -> Result<Result<WeldMotion, Vec<Finding>>, Failure> {
        let program = &self.welding.program.value;
        let around = Surroundings::new(machine, &self.clamped).map_err(|e| self.fault(e.message()))?;
        let paths = self.paths();
        let passes = self.passes(&paths);
        let mut findings = self.welding.findings();
        debug_assert!(!self.asks_for_angles(), "torch angles are searched before a plan");
        findings.extend(self.angle_findings.iter().cloned());
        if is_stopped(&self.angle_findings) {
            return Ok(Err(findings));
        }
        if self.welding.seam.as_ref().is_some_and(SeamCurve::is_double) && machine.heads.len() < 2 {
            let path = "seam.t_joint.fillet";
            let message = Message::new("project-one-head").text("machine", &machine.name);
            return Err(self.welding.program.error_at(path, message, "left, right").into());
        }
        let clocked = Clocked::new(planning, self.searching);
        let metal = self.welding.metal();
        let metal = metal.as_ref().map(|metal| -> MetalByPass { Box::new(metal.by_pass()) });
        let terms = Terms { procedure: program.procedure.as_ref(), watch: Some(&clocked), metal };
        let planned = WeldMotion::plan_under(machine, &around, &passes, program.air.retract_mm.get(), terms);
        if planned.is_err() && clocked.is_cancelled() {
            return Err(Failure::Cancelled);
        }
        let planned = planned.map(|mut motion| {
            if let Some(procedure) = &program.procedure {
                motion.hold_to(procedure, machine, &passes);
            }
            let in_position = motion.procedure.iter().zip(self.welding.bead_numbers()).enumerate();
            let toes: Vec<Finding> = in_position
                .filter_map(|(i, (held, beads))| self.welding.toe_finding_in_position(i, beads, &held.inclinations))
                .collect();
            motion.findings.extend(toes);
            let seam = self.welding.seam.as_ref();
            let period = seam.filter(|seam| seam.all_round()).map(SeamCurve::length);
            motion.check_pools(program.procedure.as_ref(), machine, &passes, period);
            motion.cool(program, period);
            if !around.is_empty() {
                motion.findings.extend(self.part_not_watched());
            }
            motion
        });
        Ok(match planned {
            Ok(mut motion) if findings.iter().all(|f| f.allowed) => {
                motion.findings.splice(0..0, findings);
                Ok(motion)
            }
            Ok(motion) => {
                findings.extend(motion.findings);
                Err(findings)
            }
            Err(more) => {
                // A corner at which the torch jumps is found by weld and motion, with one function. Of a pass without clear
                // angles their search knows more than the collisions of those given.
                let is_known = |f: &Finding| {
                    let blocked = findings.iter().any(|known| known.kind == "clearance" && known.pass == f.pass);
                    findings.contains(f) || (f.kind == "clearance" && blocked)
                };
                let new: Vec<Finding> = more.into_iter().filter(|f| !is_known(f)).collect();
                findings.extend(new);
                Err(findings)
            }
        })
    }
}
