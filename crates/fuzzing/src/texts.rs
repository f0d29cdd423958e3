//! Files in TOML.

use crate::corpora::files;
use crate::scratch::empty_folder;
use crate::target::{Target, USUAL};
use crate::words;
use seamwright_machine::{ImportOptions, ImportedArm, Machine, MachineFile};
use seamwright_post::{Control, Dialect};
use seamwright_program::{Procedure, Program};
use seamwright_project::load::machine_foreign;
use seamwright_simulation::tracking::Distortion;
use seamwright_weld::{Job, Welding};

/// Job files, read and drawn as the panel does while the user types.
pub const JOB: Target = Target {
    name: "job",
    read: |bytes| with_text(bytes, |text| seamwright_server::fuzzing::draft(text, empty_folder())),
    seeds: || [files("examples", "toml"), files("tests/data/field-trial", "toml")].concat(),
    words: words::toml::<Job>,
    max_memory: 256 << 20,
    cases: 60,
    ..USUAL
};

/// Machine files.
pub const MACHINE: Target = Target {
    name: "machine",
    read: |bytes| with_text(bytes, machine),
    seeds: || [files("machines", "toml"), files("crates/post/tests/data", "toml")].concat(),
    words: words::toml::<MachineFile>,
    max_length: 8192,
    max_memory: 256 << 20,
    ..USUAL
};

/// Descriptions of robots, and the machine files that come of them.
pub const URDF: Target = Target {
    name: "urdf",
    read: |bytes| with_text(bytes, urdf),
    seeds: || files("crates/machine/tests/data", "urdf"),
    words: || URDF_WORDS.split(' ').map(str::to_owned).collect(),
    max_length: 8192,
    ..USUAL
};

/// Elements, attributes and types of URDF.
const URDF_WORDS: &str = "robot link joint origin axis limit mimic parent child collision geometry box cylinder sphere \
                          mesh name type xyz rpy lower upper velocity effort radius length size filename scale \
                          revolute continuous prismatic fixed floating tool0 base_link 1.5708 1e308 -0 nan &amp; <!--";

fn urdf(text: &str) {
    let find_mesh = &|name: &str| Err(vec![name.to_owned()]);
    let options = ImportOptions { base: None, tip: None, scale: 1.0, with_shapes: true, find_mesh };
    match ImportedArm::from_urdf("robot.urdf", text, &options) {
        // Sizes beyond those of machine files have an error of their own.
        Ok(arm) => describe(Machine::read("machine.toml", &arm.to_toml())),
        error => describe(error),
    }
}

/// Program files.
pub const PROGRAM: Target = Target {
    name: "program",
    read: |bytes| with_text(bytes, program),
    seeds: || {
        let mut texts = [files("examples", "toml"), files("tests/data", "toml")].concat();
        texts.retain(|text| text.windows(6).any(|word| word == b"passes"));
        texts
    },
    words: words::toml::<Program>,
    max_memory: 256 << 20,
    ..USUAL
};

/// Welding procedure files.
pub const PROCEDURE: Target = Target {
    name: "procedure",
    read: |bytes| with_text(bytes, |text| describe(Procedure::read("procedure.toml", text))),
    seeds: || files("examples/procedures", "toml"),
    words: words::toml::<Procedure>,
    ..USUAL
};

/// Distortion files of simulated parts.
pub const DISTORTION: Target = Target {
    name: "distortion",
    read: |bytes| with_text(bytes, |text| describe(Distortion::read("distortion.toml", text))),
    seeds: || files("examples/distortions", "toml"),
    words: || {
        ["displacement", "shift_mm", "wave", "out_of_round", "bend", "sag", "gap", "heat", "ramp"]
            .map(str::to_owned)
            .to_vec()
    },
    ..USUAL
};

/// Passes on bytes that are text; files that are not are refused when they are opened.
pub(crate) fn with_text(bytes: &[u8], read: impl FnOnce(&str)) {
    if let Ok(text) = std::str::from_utf8(bytes) {
        read(text);
    }
}

/// Forms the words of an error, as for the user.
pub(crate) fn describe<T, E: std::fmt::Display>(result: Result<T, E>) {
    if let Err(error) = result {
        assert!(!error.to_string().is_empty(), "an error without words");
    }
}

fn machine(text: &str) {
    match machine_foreign("machine.toml", text, empty_folder()) {
        Ok(machine) => {
            let home = machine.forward(&machine.home());
            assert!(home.point.is_finite() && home.direction.is_finite(), "a machine without a position: {home:?}");
            Dialect::ALL.into_iter().for_each(|dialect| drop(Control::new(&machine, dialect)));
        }
        Err(failure) => describe::<(), _>(Err(failure)),
    }
}

fn program(text: &str) {
    match Program::read("program.toml", text) {
        Ok(_) => describe(Welding::read("program.toml", text)),
        Err(error) => describe::<(), _>(Err(error)),
    }
}
