//! Part programs that are proven before anybody sees them.

use crate::failure::Failure;
use crate::load::Loaded;
use seamwright_machine::Machine;
use seamwright_message::{Message, Unit, display_by_message};
use seamwright_motion::WeldMotion;
use seamwright_post::robot::{
    PlannedRobot, RobotArm, RobotLanguage, RobotOptions, RobotText, read_robot, robot_program, verify_robot,
    write_robot,
};
use seamwright_post::{
    Control, Dialect, Error, Feed, Level, Options, PartProgram, Planned, ReadOptions, Verification, WriteOptions,
    part_program, read, verify, write,
};
use seamwright_program::TorchPath;

/// Reason why there is no part program.
#[derive(Debug)]
pub enum Unproven {
    /// It cannot be made.
    Failure(Failure),
    /// Differences of the text read back from the plan: a line each.
    Wrong(Vec<Message>),
}

impl Unproven {
    /// Description of the reason; differences are separate lines.
    pub fn message(&self) -> Message {
        match self {
            Self::Failure(failure) => failure.message(),
            Self::Wrong(lines) => Message::lines(lines.clone()),
        }
    }
}

display_by_message!(Unproven);

impl From<Failure> for Unproven {
    fn from(failure: Failure) -> Self {
        Self::Failure(failure)
    }
}

/// A control for which a weld is posted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PostTarget {
    /// A control of machine axes, in its language.
    Machine(Dialect),
    /// A robot control.
    Robot(RobotLanguage),
}

impl PostTarget {
    /// All targets, those of machines first.
    pub fn all() -> impl Iterator<Item = Self> {
        Dialect::ALL.into_iter().map(Self::Machine).chain(RobotLanguage::ALL.into_iter().map(Self::Robot))
    }

    /// The target called `name` in interfaces.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|target| target.name() == name)
    }

    /// Its name in interfaces.
    pub fn name(self) -> &'static str {
        match self {
            Self::Machine(dialect) => dialect.name(),
            Self::Robot(language) => language.name(),
        }
    }

    /// Usual name of a file for it.
    pub fn file_name(self) -> &'static str {
        match self {
            Self::Machine(Dialect::Sinumerik) => "sinumerik.mpf",
            Self::Machine(Dialect::Linuxcnc) => "linuxcnc.ngc",
            Self::Machine(Dialect::Grblhal) => "grblhal.nc",
            Self::Machine(Dialect::Pmac) => "pmac.pmc",
            Self::Robot(language) => language.file_name(),
        }
    }

    /// Default maximum distance from the planned path, mm.
    pub fn tolerance_mm(self) -> f64 {
        match self {
            Self::Machine(_) => Options::default().tolerance_mm,
            Self::Robot(_) => RobotOptions::default().tolerance_mm,
        }
    }

    /// The program of a planned weld with default options, with its proof in the header.
    ///
    /// # Errors
    /// As [`proven`] and [`proven_robot`].
    pub fn proven(self, loaded: &Loaded, motion: &WeldMotion) -> Result<(String, Verification), Unproven> {
        match self {
            Self::Machine(dialect) => {
                let control = Control::new(&loaded.machine, dialect).map_err(|e| Failure::Input(e.message()))?;
                proven(loaded, motion, &control, &Options::default(), Feed::InverseTime)
            }
            Self::Robot(language) => proven_robot(loaded, motion, language, &RobotOptions::default()),
        }
    }
}

/// The robot program of a planned weld, with its proof in the header.
///
/// # Errors
/// A machine or motion without a program in `language`, or a program that deviates when it is read back.
pub fn proven_robot(
    loaded: &Loaded,
    motion: &WeldMotion,
    language: RobotLanguage,
    options: &RobotOptions,
) -> Result<(String, Verification), Unproven> {
    let first = match proven_within(loaded, motion, language, options, options.tolerance_mm) {
        Err(Unproven::Wrong(lines)) => lines,
        result => return result,
    };
    let finer = PARTS
        .into_iter()
        .find_map(|part| proven_within(loaded, motion, language, options, part * options.tolerance_mm).ok());
    finer.ok_or(Unproven::Wrong(first))
}

/// Parts of the tolerance for lines and arcs that are tried if the proof with all of it fails: beside a tight bend a line and
/// the rounded corner at its end may leave the path to the same side.
const PARTS: [f64; 2] = [0.7, 0.5];

/// The robot program whose lines and arcs keep within `used_mm` of the path, proven against the tolerance of `options`.
fn proven_within(
    loaded: &Loaded,
    motion: &WeldMotion,
    language: RobotLanguage,
    options: &RobotOptions,
    used_mm: f64,
) -> Result<(String, Verification), Unproven> {
    let machine = &loaded.machine;
    let program = &loaded.welding.program.value;
    let paths = loaded.paths();
    let paths: Vec<&dyn TorchPath> = paths.iter().map(|p| p as &dyn TorchPath).collect();
    let refused = |e: Error| Failure::Input(e.message());
    let arm = RobotArm::new(machine, language).map_err(refused)?;
    let used = RobotOptions { tolerance_mm: used_mm, ..*options };
    let asked = robot_program(machine, language, program, &paths, motion, &used)
        .map_err(|e| Failure::Input(located(&e, options.tolerance_mm)))?;
    let text = |remarks: &[String]| write_robot(language, &asked, &RobotText { machine, arm: &arm, remarks });
    let planned = PlannedRobot {
        machine,
        language,
        program,
        motion,
        tolerance_mm: options.tolerance_mm,
        speed_percent: options.speed_percent,
    };
    let back = read_robot(language, "the robot program", &text(&[])).map_err(|e| Unproven::Wrong(vec![e.located()]))?;
    let proof = verify_robot(&asked, &back, planned).map_err(Unproven::Wrong)?;
    Ok((text(&proof.lines()), proof))
}

/// Description of an error; a tolerance that is too small names its option.
fn located(error: &Error, tolerance_mm: f64) -> Message {
    match error {
        Error::TooFine { .. } | Error::BriefBlocks { .. } => {
            let message = Message::new("project-option-tolerance").value("value", tolerance_mm, Unit::One);
            message.message("why", error.message())
        }
        _ => error.message(),
    }
}

/// The part program of a planned weld, with its proof in the header.
///
/// # Errors
/// A motion without a part program, or a program that deviates when it is read back.
pub fn proven(
    loaded: &Loaded,
    motion: &WeldMotion,
    control: &Control,
    options: &Options,
    feed: Feed,
) -> Result<(String, Verification), Unproven> {
    let paths = loaded.paths();
    let paths: Vec<&dyn TorchPath> = paths.iter().map(|p| p as &dyn TorchPath).collect();
    let program = &loaded.welding.program.value;
    let part = part_program(&loaded.machine, control, program, &paths, motion, options);
    let part = part.map_err(|e| Failure::Input(located(&e, options.tolerance_mm)))?;
    let mut write_options = WriteOptions {
        machine: loaded.machine.title.clone(),
        feed,
        rounding_mm: options.rounding_mm(),
        remarks: Vec::new(),
    };
    let text = |options: &WriteOptions| write(control, &part, options).map_err(|e| Failure::Input(e.message()));
    let planned = Planned {
        machine: &loaded.machine,
        control,
        program,
        motion,
        tolerance_mm: options.tolerance_mm,
        speed_percent: options.speed_percent,
    };
    let proof = prove(&part, &text(&write_options)?, options.level, planned)?;
    write_options.remarks = proof.lines();
    Ok((text(&write_options)?, proof))
}

/// Reads `text` back and verifies it against its source and the plan: unproven text is not written.
fn prove(part: &PartProgram, text: &str, level: Level, planned: Planned) -> Result<Verification, Unproven> {
    let start = start(planned.machine, planned.control);
    let options = ReadOptions { lenient: false, level, start: Some(start.clone()) };
    let back =
        read(planned.control, "the part program", text, &options).map_err(|e| Unproven::Wrong(vec![e.located()]))?;
    verify(part, &back.program, &start, planned).map_err(Unproven::Wrong)
}

/// The row before the first block: all axes at home, all outputs off.
pub fn start(machine: &Machine, control: &Control) -> Vec<f64> {
    let home = machine.home();
    let mut row = vec![0.0; control.channels.len()];
    for (i, axis) in machine.axes.iter().enumerate() {
        row[i] = axis.to_file(home[i]);
    }
    row
}
