//! Refused texts, each with its line and column, and the message.

use crate::reading::{self, MACHINE, bad, good, refused, try_read};
use seamwright_machine::Machine;
use seamwright_post::Dialect::{Grblhal, Linuxcnc, Pmac, Sinumerik};
use seamwright_post::{Control, Dialect, ReadOptions, read};

#[test]
fn an_error_shows_its_place() {
    let error = try_read(Sinumerik, "G90 F60\nG1 X=5 Q=3 Y=2\n").unwrap_err().to_string();
    let expected = "test:2:8: Q is neither an address of this machine nor a known word\n   |\n 2 | G1 X=5 Q=3 Y=2\n   |        ^^\n";
    assert!(error.starts_with(expected), "{error}");
    assert!(error.contains("allowed: X Y Z B C1 CW and the words of sinumerik"), "{error}");
    assert!(error.contains("help: "), "{error}");
    // Columns are characters.
    refused(Sinumerik, "MSG(\"é\") Q=5\n", 1, 10, "neither an address");
    refused(Linuxcnc, "(é) T1\r\nG0 X1\r\n", 1, 5, "neither an address");
}

#[test]
fn feeds() {
    for dialect in [Linuxcnc, Grblhal] {
        refused(dialect, "G93 G1 X1 F5\nX2\n", 2, 1, "F is missing");
        refused(dialect, "G93 F5\nG1 X2\n", 2, 4, "F is missing");
        refused(dialect, "G94 G1 X1\n", 1, 8, "F is missing");
        refused(dialect, "G94 G1 X1 F5\nG93 F1 X2\nG94 X3\n", 3, 5, "F is missing");
        refused(dialect, "G1 X1 F0\n", 1, 7, "greater than 0");
        refused(dialect, "G1 X1 F-5\n", 1, 7, "greater than 0");
    }
    refused(Sinumerik, "G93\nG1 X1\n", 2, 4, "F is missing");
    refused(Sinumerik, "F5 G1 X1\nG93 X2\n", 2, 5, "F is missing");
    refused(Sinumerik, "G1 X=1 F=0\n", 1, 8, "greater than 0");
    refused(Sinumerik, "G1 X=1 F=99999999999\n", 1, 8, "out of range");
    refused(Sinumerik, "G95 F0.1\n", 1, 1, "G95");
    refused(Pmac, "LINEAR X1\n", 1, 8, "speed is missing");
    refused(Pmac, "PVT(0)\n", 1, 4, "invalid time");
    refused(Pmac, "SPLINE1 X1\n", 1, 9, "speed is missing");
    refused(Pmac, "F-1\n", 1, 1, "greater than 0");
}

#[test]
fn the_same_word_twice() {
    for dialect in [Sinumerik, Linuxcnc, Grblhal] {
        refused(dialect, "G0 X1 Y2 X3\n", 1, 10, "twice");
        refused(dialect, "F60 G3 X1 I1 I2\n", 1, 14, "twice");
        refused(dialect, "G1 X1 F60 F60\n", 1, 11, "twice");
        refused(dialect, "N1 N2 G0\n", 1, 4, "twice");
    }
    refused(Sinumerik, "G2 X1 CR=5 CR=6\n", 1, 12, "twice");
    refused(Sinumerik, "G0 C1=5 C1=6\n", 1, 9, "twice");
    refused(Sinumerik, "CIP I1=5 I1=6\n", 1, 10, "twice");
    refused(Pmac, "RAPID X1 X2\n", 1, 10, "twice");
    refused(Pmac, "CIRCLE1 X1 R1 R2\n", 1, 15, "twice");
}

#[test]
fn two_codes_of_a_group() {
    for dialect in [Sinumerik, Linuxcnc, Grblhal] {
        for (a, b) in [("G0", "G1"), ("G2", "G3"), ("G17", "G18"), ("G90", "G91"), ("G93", "G94"), ("M0", "M30")] {
            refused(dialect, &format!("{a} {b}\n"), 1, a.len() + 2, "one modal group");
            good(dialect, &format!("{a}\n"));
        }
    }
    refused(Sinumerik, "G1 CIP\n", 1, 4, "one modal group");
    refused(Sinumerik, "G60 G64\n", 1, 5, "one modal group");
    refused(Sinumerik, "G70 G710\n", 1, 5, "one modal group");
    refused(Linuxcnc, "G20 G21\n", 1, 5, "one modal group");
    refused(Linuxcnc, "G61 G64\n", 1, 5, "one modal group");
    refused(Linuxcnc, "M62 P1 M64 P2\n", 1, 8, "one modal group");
    refused(Linuxcnc, "G4 P1 G53\n", 1, 7, "one modal group");
}

#[test]
fn words_that_are_not_known() {
    refused(Sinumerik, "G0 X1 U5\n", 1, 7, "U is neither an address");
    refused(Sinumerik, "G0 X1 QG=5\n", 1, 7, "QG is neither an address");
    refused(Sinumerik, "BRISK\n", 1, 1, "BRISK is neither an address");
    refused(Sinumerik, "G999\n", 1, 1, "not known");
    refused(Sinumerik, "M77\n", 1, 1, "not known");
    refused(Sinumerik, "G1.5\n", 1, 1, "not known");
    refused(Sinumerik, "FGREF[C1]=5\n", 1, 1, "FGREF");
    refused(Sinumerik, "FGROUP(X,QG)\n", 1, 10, "QG is neither an address");
    refused(Sinumerik, "CYCLE81(1,2)\n", 1, 1, "not known");
    refused(Sinumerik, "$AA_IM[X]=5\n", 1, 1, "$AA_IM");
    refused(Linuxcnc, "G0 X1 A5\n", 1, 7, "A is neither an address");
    refused(Linuxcnc, "G33 X1\n", 1, 1, "not known");
    refused(Linuxcnc, "G92 X1\n", 1, 1, "G92");
    refused(Grblhal, "M7\n", 1, 1, "coolant");
    refused(Grblhal, "G0 X[1+1]\n", 1, 5, "not for grblHAL");
    refused(Pmac, "RAPID A5\n", 1, 7, "A is neither an address");
    refused(Pmac, "CMD\"#1J/\"\n", 1, 1, "CMD");
    refused(Pmac, "M300=1\n", 1, 1, "M300");
    refused(Pmac, "I15=1\n", 1, 1, "I15");
    refused(Pmac, "M3\n", 1, 1, "calls a program");
    refused(Pmac, "#1->A\n", 1, 5, "A is neither an address");
    refused(Sinumerik, "G0 X1 @\n", 1, 7, "no word starts");
}

#[test]
fn numbers() {
    for dialect in [Sinumerik, Linuxcnc, Grblhal] {
        refused(dialect, "G0 X\n", 1, 5, "missing");
        refused(dialect, "G0 X-\n", 1, if dialect == Grblhal { 5 } else { 6 }, "missing");
        refused(dialect, "G0 X1..2\n", 1, 7, "part of a number");
        refused(dialect, "G0 X1,5\n", 1, 6, "comma");
        refused(dialect, "G0 X99999999\n", 1, 4, "too large");
        refused(dialect, "N1234567890 G0\n", 1, 2, "too many digits");
    }
    refused(Sinumerik, "G0 X=5/0\n", 1, 6, "no value");
    refused(Sinumerik, "G0 X=SQRT(-1)\n", 1, 6, "no value");
    refused(Sinumerik, "G0 X=R5\n", 1, 6, "no value here");
    refused(Sinumerik, "G0 X=(5\n", 1, 8, ") is missing");
    refused(Sinumerik, "G0 X=SINH(5)\n", 1, 6, "unknown function");
    refused(Linuxcnc, "G0 X#5\n", 1, 6, "no value here");
    refused(Linuxcnc, "G0 X[5\n", 1, 7, "] is missing");
    refused(Pmac, "RAPID X(P5)\n", 1, 9, "no value here");
    refused(Sinumerik, &format!("G0 X={}5{}\n", "(".repeat(60), ")".repeat(60)), 1, 47, "brackets");
}

#[test]
fn words_that_belong_to_nothing() {
    refused(Linuxcnc, "G0 X1 P5\n", 1, 7, "belongs to nothing");
    refused(Linuxcnc, "F9 G1 X1 R5\n", 1, 10, "belongs to nothing");
    refused(Linuxcnc, "F9 G1 X1 I5\n", 1, 10, "only arcs");
    refused(Sinumerik, "F9 G1 X1 CR=5\n", 1, 10, "only arcs");
    refused(Linuxcnc, "G4\n", 1, 1, "G4 needs P");
    refused(Linuxcnc, "G4 P-1\n", 1, 4, "dwell time");
    refused(Linuxcnc, "G0 X1\nG4 P1 X2\n", 2, 7, "nothing moves");
    refused(Sinumerik, "G4 S5\n", 1, 4, "S is neither an address");
    refused(Sinumerik, "G4\n", 1, 1, "G4 needs F");
    refused(Linuxcnc, "M62\n", 1, 1, "P is missing");
    refused(Linuxcnc, "M62 P0.5\n", 1, 5, "invalid output number");
    refused(Linuxcnc, "M67 E0\n", 1, 1, "Q is missing");
    refused(Linuxcnc, "M67 E9 Q1\n", 1, 1, "analogue output 9");
    refused(Linuxcnc, "M67 E3 Q1\n", 1, 8, "switches the kinematics");
    refused(Linuxcnc, "X1\n", 1, 1, "no G0, G1, G2 or G3");
    refused(Linuxcnc, "G80\nX1\n", 2, 1, "no G0, G1, G2 or G3");
    refused(Sinumerik, "$A_OUT[1]=2\n", 1, 11, "on or off");
    refused(Sinumerik, "$A_OUT[0]=1\n", 1, 8, "no such output");
    refused(Sinumerik, "PRESETON(X, 5)\n", 1, 10, "PRESETON of an axis");
    refused(Sinumerik, "G0 X=DC(5)\n", 1, 4, "only rotary axes");
    refused(Pmac, "RAPID X1:5\n", 1, 10, "only PVT");
    refused(Pmac, "PVT100 X1:5 Y1:5 Z1:5 B1:5\n", 1, 1, "C is missing");
    refused(Pmac, "PVT100 X1:5 Y1:5 Z1:5 B1:5 C1\n", 1, 28, "speed after");
    refused(Pmac, "NORMAL I0\n", 1, 1, "no direction");
    refused(Pmac, "CIRCLE3\n", 1, 1, "no such mode");
    refused(Pmac, "CLOSE\nRAPID X1\n", 2, 1, "after CLOSE");
}

#[test]
fn steering_is_not_read() {
    let all = [(Sinumerik, "IF R1==1 GOTOF END\n"), (Sinumerik, "FOR R1=1 TO 5\n"), (Sinumerik, "GOTOB A\n")];
    for (dialect, text) in
        all.into_iter().chain([(Pmac, "WHILE(P1<5)\n"), (Pmac, "GOTO 5\n"), (Linuxcnc, "o1 if [1]\n")])
    {
        refused(dialect, text, 1, 1, "not read");
        let options = ReadOptions { lenient: true, ..ReadOptions::default() };
        assert!(read(&reading::control(dialect), "t", text, &options).is_err(), "{text}");
    }
    refused(Linuxcnc, "o1 call\n", 1, 1, "no sub-program");
    refused(Linuxcnc, "o1 sub\no1 endsub\no1 call [5]\n", 3, 9, "no arguments");
    refused(Linuxcnc, "o1 sub\no1 call\no1 endsub\no1 call\n", 2, 1, "nested calls");
    refused(Linuxcnc, "o1 sub\nG0 X1\n", 1, 7, "no endsub");
    refused(Linuxcnc, "o1 endsub\n", 1, 1, "without its sub");
    refused(Sinumerik, "%_N_A_MPF\nG0 X1 B_1\n%_N_B_1_SPF\nM17\n", 2, 7, "alone in its line");
    refused(Sinumerik, "%_N_A_MPF\nB_1 P0\n%_N_B_1_SPF\nM17\n", 2, 6, "repeats");
    refused(Sinumerik, "%_N_A_MPF\nA\n", 2, 1, "nested calls");
    refused(Sinumerik, "%_N_A_MPF\n%_N_A_SPF\n", 2, 1, "two programs");
    refused(Sinumerik, "G0 X1\n%_N_A_MPF\n", 1, 1, "before the first program");
}

/// Sub-programs that call each other many times over end in an error, not in a day's work.
#[test]
fn calls_that_multiply_are_refused() {
    let mut text = "%_N_M_MPF\nSUB0 P9999\n".to_owned();
    for k in 0..4 {
        text += &format!("%_N_SUB{k}_SPF\nSUB{} P9999\nM17\n", k + 1);
    }
    text += "%_N_SUB4_SPF\n;\nM17\n";
    assert!(bad(Sinumerik, &text).2.contains("lines of sub-programs"));
}

#[test]
fn where_the_axes_are_must_be_known() {
    refused(Sinumerik, "TRAORI\nG0 X1 Y2\n", 2, 4, "is not known");
    refused(Sinumerik, "TRAORI\nG94 F60 G1 X1 Y2 Z3\n", 2, 12, "is not known");
    refused(Sinumerik, "TRAORI\nG91 G0 X1 Y2 Z3\n", 2, 8, "is not known");
    good(Sinumerik, "TRAORI\nG93 F60 G1 X1 Y2 Z3\n");
}

#[test]
fn grblhal_limits() {
    let line = |length: usize| format!("G0 X1 ({})\n", "a".repeat(length - 8));
    good(Grblhal, &line(256));
    refused(Grblhal, &line(257), 1, 257, "too long");
    good(Linuxcnc, &line(257));
    let mut control: Control = reading::control(Grblhal);
    for name in ["d1", "d2", "d3", "d4"] {
        let channel = seamwright_post::Channel { name: name.into(), kind: seamwright_post::ChannelKind::Linear };
        control.channels.insert(0, channel);
        control.addresses.insert(0, String::new());
        control.outputs.insert(0, None);
    }
    let error = read(&control, "t", "G0 X1\n", &ReadOptions::default()).unwrap_err();
    assert!(error.message.code == "post-grblhal-axes" && (error.line, error.column) == (1, 1), "{error}");
}

/// A machine without X, Y and Z has no arcs and no tip level.
#[test]
fn arcs_want_their_axes() {
    let machine = MACHINE.replace("axis = \"y\"", "axis = \"q\"\nletter = \"Y\"");
    let machine = Machine::read("m", &machine).unwrap_or_else(|e| panic!("{e}"));
    for dialect in Dialect::ALL {
        let control = Control::new(&machine, dialect).unwrap();
        let text = match dialect {
            Sinumerik => "F60 G3 X1 Q=1 I1\n",
            Pmac => "TM10 CIRCLE1 X1 Y1 I1\n",
            _ => "F60 G3 X1 Y1 I1\n",
        };
        let error = read(&control, "t", text, &ReadOptions::default()).unwrap_err();
        assert!(error.message.to_string().contains("an axis called y"), "{error}");
    }
    let control = Control::new(&machine, Sinumerik).unwrap();
    let error = read(&control, "t", "G0 X1\nTRAORI\n", &ReadOptions::default()).unwrap_err();
    assert!(error.message.code == "post-no-tip-axes" && error.line == 2, "{error}");
}
