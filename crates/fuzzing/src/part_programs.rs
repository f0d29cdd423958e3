//! Part programs, each dialect strictly and leniently.

use crate::corpora::files;
use crate::target::{Target, USUAL};
use crate::texts::with_text;
use seamwright_machine::Machine;
use seamwright_post::{Arc, Control, Dialect, LeftOut, Path, ReadError, ReadOptions, Reading, What, read};
use std::sync::LazyLock;

/// Siemens Sinumerik 840D.
pub const SINUMERIK: Target =
    Target { name: "sinumerik", read: |bytes| read_with(&CONTROLS[0], bytes), seeds: || seeds("mpf"), ..PART_PROGRAM };

/// LinuxCNC.
pub const LINUXCNC: Target =
    Target { name: "linuxcnc", read: |bytes| read_with(&CONTROLS[1], bytes), seeds: || seeds("ngc"), ..PART_PROGRAM };

/// grblHAL.
pub const GRBLHAL: Target =
    Target { name: "grblhal", read: |bytes| read_with(&CONTROLS[2], bytes), seeds: || seeds("gcode"), ..PART_PROGRAM };

/// Delta Tau PMAC.
pub const PMAC: Target =
    Target { name: "pmac", read: |bytes| read_with(&CONTROLS[3], bytes), seeds: || seeds("pmc"), ..PART_PROGRAM };

const PART_PROGRAM: Target =
    Target { words: || WORDS.map(str::to_owned).to_vec(), max_length: 1024, cases: 1500, ..USUAL };

/// Controls of a machine with five axes, outputs for the process, and addresses that every dialect has its own way for.
static CONTROLS: LazyLock<[Control; 4]> = LazyLock::new(|| {
    let machine = Machine::read("test.toml", include_str!("../../post/tests/data/machine.toml"));
    let machine = machine.unwrap_or_else(|e| panic!("{e}"));
    [Dialect::Sinumerik, Dialect::Linuxcnc, Dialect::Grblhal, Dialect::Pmac]
        .map(|dialect| Control::new(&machine, dialect).unwrap_or_else(|e| panic!("{e}")))
});

fn seeds(ending: &str) -> Vec<Vec<u8>> {
    ["crates/fuzzing/seeds", "crates/post/tests/data", "examples"].map(|folder| files(folder, ending)).concat()
}

/// Words of all dialects, and characters that matter to the readers.
#[rustfmt::skip]
const WORDS: [&str; 118] = [
    "G0", "G1 ", "G2", "G3 ", "G4", "G17", "G18", "G19", "G20", "G21", "G53", "G54", "G60", "G61", "G64 P", "G70",
    "G71", "G90", "G91\n", "G93", "G94", "G95", "G500", "G602", "G641", "M0", "M2\n", "M3 S", "M5", "M17\n", "M30\n",
    "M62 P", "M63 P", "M64 P", "M65 P", "M66 E0 L0", "M67 E0 Q", "M68 E0 Q", "M101", "X", "Y=", "Z-", "A", "B", "C1=DC(",
    "I", "J", "K", "I1=", "F", "R", "P", "S", "T", "U", "CR=", "AR=", "TURN=", "CIP ", "AC(", "IC(", "ACP(", "ACN(",
    "POLY ", "PO[X]=(", "PL=", "DEF REAL ", "R1=", "SIN(", "COS(", "SQRT(", "ATAN2(", "MSG(\"", "FGROUP(", "FGREF[",
    "PRESETON(", "TRAORI\n", "TRAFOOF", "WHEN TRUE DO ", "$A_OUT[", "$A_OUTA[", "STOPRE", "RET\n", "o101 ", "sub\n",
    "endsub\n", "call\n", "repeat [", "#1=", "#<len>", "[", "]", "ATAN[", "MOD ", "**", "OPEN PROG 1 CLEAR\n", "CLOSE\n",
    "PVT(", "SPLINE1 ", "LINEAR ", "RAPID ", "CIRCLE1 ", "NORMAL K-1 ", "ABS ", "INC(", "FRAX(", "TA", "TM", "TS",
    "DWELL", "DELAY", "N1000 ", "%_N_WELD_MPF\n", "%_N_P_SPF\n", "%\n", ";", "(", "\r\n",
];

fn read_with(control: &Control, bytes: &[u8]) {
    with_text(bytes, |text| {
        for lenient in [false, true] {
            match read(control, "fuzz", text, &ReadOptions { lenient, ..ReadOptions::default() }) {
                Ok(reading) => check(&reading, text, lenient),
                Err(error) => check_position(&error, text),
            }
        }
    });
}

/// An error has a position in the text, and words.
fn check_position(error: &ReadError, text: &str) {
    let line = text.split('\n').nth(error.line.wrapping_sub(1));
    let line = line.unwrap_or_else(|| panic!("an error in line {}", error.line));
    let columns = 1..=line.chars().count() + 1;
    assert!(columns.contains(&error.column), "an error in column {} of {line:?}", error.column);
    assert!(!error.to_string().is_empty());
}

/// Numbers are finite, times not negative, and texts that were left out have a position.
fn check(reading: &Reading, text: &str, lenient: bool) {
    let program = &reading.program;
    for step in &program.steps {
        let What::Move(m) = &step.what else { continue };
        let is_finite = m.seconds >= 0.0 && m.seconds.is_finite() && program.row(m.row).iter().all(|v| v.is_finite());
        let is_arc = |arc: &Arc| arc.sweep.is_finite() && (arc.normal.length() - 1.0).abs() < 1e-9;
        let is_path = !matches!(m.path, Path::Arc(i) if !is_arc(&program.arcs[i as usize]));
        assert!(is_finite && is_path, "{m:?} in line {}", step.line);
    }
    let lines = text.split('\n').count();
    let has_position = |left_out: &LeftOut| (1..=lines).contains(&left_out.line) && left_out.column >= 1;
    assert!(lenient || reading.left_out.is_empty(), "left out: {:?}", reading.left_out);
    assert!(reading.left_out.iter().all(has_position), "left out: {:?}", reading.left_out);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seeds_of_every_dialect_are_programs() {
        for (control, ending) in CONTROLS.iter().zip(["mpf", "ngc", "gcode", "pmc"]) {
            let seeds = files("crates/fuzzing/seeds", ending);
            assert!(!seeds.is_empty());
            for seed in seeds {
                let text = String::from_utf8(seed).unwrap();
                read(control, "seed", &text, &ReadOptions::default()).unwrap_or_else(|e| panic!("{e}"));
            }
        }
    }
}
