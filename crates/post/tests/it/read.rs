//! Part programs read, dialect by dialect: modal state, words, expressions, sub-programs; the printed program of EBW-2004.

#![allow(clippy::float_cmp, reason = "numbers as written come back exactly")]

use crate::reading::{self, events, good, moves, near, rows, sets};
use seamwright_machine::{Machine, shipped};
use seamwright_post::Dialect::{Grblhal, Linuxcnc, Pmac, Sinumerik};
use seamwright_post::{Control, Event, Level, PartProgram, Path, ReadOptions, What, read};

const FIGURE: &str = include_str!("../../../../examples/ebw-fig1.mpf");

#[test]
fn the_printed_program_of_ebw_2004() {
    let machine = Machine::read("ebw", shipped("ebw-7axis").unwrap().text).unwrap();
    let control = Control::new(&machine, Sinumerik).unwrap();
    let reading = read(&control, "ebw-fig1.mpf", FIGURE, &ReadOptions::default()).unwrap_or_else(|e| panic!("{e}"));
    let program = &reading.program;
    let [z, w, cw, cf] = ["z", "w", "beam_a", "focus_a"].map(|name| control.channel(name).unwrap());
    let printed = [
        // Z, W, CW, CF, and the F that holds.
        (25.0, 0.0, 0.0, 0.0, None),
        (19.2, 20.89, 0.2, 6.0, Some(20.0)),
        (0.0, 90.0, 0.5, 6.0, Some(8.05)),
        (25.0, 180.0, 0.5, 6.0, Some(4.64)),
        (50.0, 270.0, 0.2, 5.0, Some(4.64)),
        (30.66, 339.64, 0.2, 5.0, Some(8.0)),
        (25.0, 360.0, 0.0, 5.0, Some(20.52)),
    ];
    let moves = moves(program);
    assert_eq!(moves.len(), printed.len());
    for (m, (pz, pw, pcw, pcf, f)) in moves.iter().zip(printed) {
        let row = program.row(m.row);
        assert_eq!([row[z], row[w], row[cw], row[cf]], [pz, pw, pcw, pcf]);
        assert!(row.iter().enumerate().all(|(i, v)| [z, w, cw, cf].contains(&i) || *v == 0.0));
        assert!((m.seconds - f.map_or(0.0, |f| 60.0 / f)).abs() < 1e-12);
        assert_eq!(m.path, if f.is_some() { Path::Line } else { Path::Rapid });
        // Z(W) is a triangle wave: from 25 down to 0 at 90 degrees, up to 50 at 270, back to 25.
        let triangle = (25.0 - row[w] * 25.0 / 90.0).max(row[w] * 25.0 / 90.0 - 25.0).min(125.0 - row[w] * 25.0 / 90.0);
        assert!((row[z] - triangle).abs() <= 0.01, "Z {} at W {}: {triangle}", row[z], row[w]);
    }
    assert_eq!(sets(program), [(cf as u16, 4.0, true), (cw as u16, 0.0, true)]);
    assert_eq!(events(program), vec![(Event::Call("m54".into()), true); 2]);
    assert!(program.steps.iter().any(|s| s.what == What::Dwell(0.5)));
    let numbers: Vec<_> = program.steps.iter().filter(|s| matches!(s.what, What::Move(_))).map(|s| s.number).collect();
    assert_eq!(numbers, [None, Some(3), Some(12), Some(22), Some(32), Some(42), Some(52)]);
    assert!(reading.notes.iter().any(|n| n.to_string().contains("offsets")), "{:?}", reading.notes);
}

#[test]
fn words_stay_in_force() {
    let program = good(Sinumerik, "G90 G71 G94\nG0 X1 Y2\nG1 Z=3 F=600\nX=4\nG91 X=1 Y=-1\nG90 Z=AC(7) Y=IC(2)\n");
    // x y z b c beam_ma current_a voltage_v
    let expected =
        [[1.0, 2.0, 0.0], [1.0, 2.0, 3.0], [4.0, 2.0, 3.0], [5.0, 1.0, 3.0], [5.0, 3.0, 7.0]].map(|r| r.to_vec());
    assert_eq!(rows(&program).iter().map(|r| r[..3].to_vec()).collect::<Vec<_>>(), expected);
    let seconds: Vec<f64> = moves(&program).iter().map(|m| m.seconds).collect();
    assert!(near(&seconds, &[0.0, 0.3, 0.3, 0.1 * 2f64.sqrt(), 0.1 * 20f64.sqrt()], 1e-12), "{seconds:?}");
}

#[test]
fn inches_and_millimetres() {
    let program = good(Linuxcnc, "G20 G90 G94\nG1 X1 B10 F10\nG21 X50.8 F508\n");
    assert!(near(&rows(&program)[0][..5], &[25.4, 0.0, 0.0, 10.0, 0.0], 1e-12));
    assert!(near(&rows(&program)[1][..5], &[50.8, 0.0, 0.0, 10.0, 0.0], 1e-12));
    let seconds: Vec<f64> = moves(&program).iter().map(|m| m.seconds).collect();
    assert!(near(&seconds, &[6.0, 3.0], 1e-12), "{seconds:?}");
    // Degrees alone are not in inches on LinuxCNC; on Siemens' G70 F stays mm.
    assert!((moves(&good(Linuxcnc, "G20 G94 G1 B10 F10"))[0].seconds - 60.0).abs() < 1e-12);
    assert!((moves(&good(Sinumerik, "G70 G94 G1 X1 F25.4"))[0].seconds - 60.0).abs() < 1e-12);
    assert!((moves(&good(Sinumerik, "G700 G94 G1 X1 F1"))[0].seconds - 60.0).abs() < 1e-12);
}

#[test]
fn feeds_by_each_controls_rule() {
    // G93: 60 / F. Siemens' F stays in force, the others need it in every block.
    assert!(moves(&good(Sinumerik, "G93 G1 X10 F6\nX20\nC1=90\n")).iter().all(|m| (m.seconds - 10.0).abs() < 1e-12));
    for dialect in [Linuxcnc, Grblhal] {
        assert!((moves(&good(dialect, "G93 G1 X10 F6\n"))[0].seconds - 10.0).abs() < 1e-12);
    }
    // LinuxCNC counts X Y Z, and never goes below 0.1 mm/min.
    assert!((moves(&good(Linuxcnc, "G93 G1 X0.01 F1\n"))[0].seconds - 6.0).abs() < 1e-9);
    assert!((moves(&good(Linuxcnc, "G94 G1 X10 C90 F60\n"))[0].seconds - 10.0).abs() < 1e-12);
    // grblHAL counts all, FGROUP those it names.
    assert!((moves(&good(Grblhal, "G94 G1 X30 C40 F60\n"))[0].seconds - 50.0).abs() < 1e-12);
    assert!((moves(&good(Sinumerik, "FGROUP(X,C1)\nG1 X30 Z1000 C1=40 F60\n"))[0].seconds - 50.0).abs() < 1e-12);
    assert!((moves(&good(Sinumerik, "FGROUP(X,C1)\nFGROUP()\nG1 X30 C1=40 F60\n"))[0].seconds - 30.0).abs() < 1e-12);
    // PMAC: F per second; TM in ms, at least TA and twice TS.
    let text = "FRAX(X,Y)\nF5\nLINEAR X30 Y40 Z100\nTM500 X0\nTA800 Y0\nTS450 X1\n";
    let seconds: Vec<f64> = moves(&good(Pmac, text)).iter().map(|m| m.seconds).collect();
    assert!(near(&seconds, &[10.0, 0.5, 0.8, 0.9], 1e-12), "{seconds:?}");
    assert!((moves(&good(Pmac, "I190=60000\nF60 LINEAR X10\n"))[0].seconds - 10.0).abs() < 1e-12);
    // A block without motion takes no time, except with PMAC's TM.
    assert_eq!(moves(&good(Sinumerik, "G93 G1 X0 F6\n"))[0].seconds, 0.0);
    assert_eq!(moves(&good(Pmac, "TM100 LINEAR X0\n"))[0].seconds, 0.1);
}

#[test]
fn a_process_value_alone_moves_too() {
    let program = good(Sinumerik, "G93 G1 X1 CW=0.5 F60\nCW=0.25 F=30\nPRESETON(CW, 2)\nX2 F10\n");
    let cw = reading::control(Sinumerik).channel("beam_ma").unwrap();
    let values: Vec<f64> = rows(&program).iter().map(|r| r[cw]).collect();
    assert_eq!(values, [0.5, 0.25, 2.0]);
    assert_eq!(moves(&program)[1].seconds, 2.0);
    assert_eq!(sets(&program), [(cw as u16, 2.0, true)]);
}

#[test]
fn rotary_axes_the_short_way() {
    let program = good(Sinumerik, "G0 C1=350\nC1=DC(10)\nC1=DC(350)\nC1=ACP(340)\nC1=ACN(350)\nC1=DC(350)\n");
    let c: Vec<f64> = rows(&program).iter().map(|r| r[4]).collect();
    assert_eq!(c, [350.0, 370.0, 350.0, 700.0, 350.0, 350.0]);
}

#[test]
fn outputs_are_arc_gas_wire_and_values() {
    let on = [(Event::Arc(true), true), (Event::Gas(true), false), (Event::Output(7, true), true)];
    let sinumerik =
        "$A_OUT[1]=1\nWHEN TRUE DO $A_OUT[2]=1\n$A_OUT[8]=1\n$A_OUTA[1]=120\nWHEN TRUE DO $A_OUTA[2]=22.5\n";
    let linuxcnc = "M64 P0\nM62 P1\nM64 P7\nM68 E0 Q120\nM67 E1 Q22.5\n";
    let pmac = "M1=1\nM2==1\nM8=1\nM101=120\nM102==22.5\n";
    for (dialect, text) in [(Sinumerik, sinumerik), (Linuxcnc, linuxcnc), (Grblhal, linuxcnc), (Pmac, pmac)] {
        let program = good(dialect, text);
        let control = reading::control(dialect);
        let [a, v] = ["current_a", "voltage_v"].map(|name| control.channel(name).unwrap() as u16);
        assert_eq!(events(&program), on, "{dialect:?}");
        assert_eq!(sets(&program), [(a, 120.0, true), (v, 22.5, false)], "{dialect:?}");
    }
    let program = good(Linuxcnc, "M65 P0\nM63 P1\nM65 P7\nM66 P3 L3 Q5\nM66 E0 L0\nM3 S100\nM101\n");
    let wait = Event::Message("wait for digital input 3".into());
    let off = [(Event::Arc(false), true), (Event::Gas(false), false), (Event::Output(7, false), true), (wait, true)];
    assert_eq!(events(&program), [&off[..], &[(Event::Call("m3".into()), true), (Event::Gas(true), true)]].concat());
}

#[test]
fn values_go_into_the_rows_behind_them() {
    let program = good(Linuxcnc, "G94 F60\nM67 E0 Q100\nG1 X1\nM67 E0 Q110\nG1 X2\nX3\n");
    let a = reading::control(Linuxcnc).channel("current_a").unwrap();
    assert_eq!(rows(&program).iter().map(|r| r[a]).collect::<Vec<_>>(), [100.0, 110.0, 110.0]);
    // grblHAL's S: with the move of its block, alone at once; M3 and M5 are then the arc.
    let program = good(Grblhal, "S5\nM3\nG93\nG1 X1 S7 F60\nM5\nM8\nM9\n");
    let s = reading::control(Grblhal).channel("power_w").unwrap();
    assert_eq!(sets(&program), [(s as u16, 5.0, true), (s as u16, 7.0, false)]);
    let expected = [Event::Arc(true), Event::Arc(false), Event::Gas(true), Event::Gas(false)];
    assert_eq!(events(&program), expected.map(|e| (e, true)));
    let program = good(Pmac, "M120=3\nM120==4\nTM100 LINEAR X1\n");
    let focus = reading::control(Pmac).channel("focus_a").unwrap();
    assert_eq!(sets(&program), [(focus as u16, 3.0, true), (focus as u16, 4.0, false)]);
    assert_eq!(rows(&program)[0][focus], 4.0);
}

#[test]
fn exact_stops() {
    let stops = |dialect, text| moves(&good(dialect, text)).iter().map(|m| m.exact_stop).collect::<Vec<_>>();
    assert_eq!(
        stops(Sinumerik, "F9 G1 X1\nG9 X2\nX3\nG60 X4\nX5\nG642 X6\nG184\nX7\nG164 X8\n"),
        [false, true, false, true, true, false, true, false]
    );
    assert_eq!(stops(Linuxcnc, "F9 G1 X1\nG61 X2\nG64 P0.1 Q0 X3\nG61.1 X4\nG4 P0\n"), [false, true, false, true]);
    assert_eq!(stops(Grblhal, "F9 G1 X1\nG4 P0 (exact stop)\nX2\nG4 P0.5\nG61 X3\n"), [true, false, false]);
    assert_eq!(stops(Pmac, "TM9 LINEAR X1\nDWELL0\nX2\nDELAY0\nX3 DWELL(100)\n"), [true, false, false]);
    let dwells: Vec<_> = good(Pmac, "TM9 X1\nDWELL0\nDELAY250\n")
        .steps
        .iter()
        .filter(|s| matches!(s.what, What::Dwell(_)))
        .cloned()
        .collect();
    assert_eq!(dwells.len(), 1);
    assert_eq!(dwells[0].what, What::Dwell(0.25));
}

#[test]
fn levels() {
    let levels = |dialect, text| moves(&good(dialect, text)).iter().map(|m| m.level).collect::<Vec<_>>();
    let (joint, tip) = (Level::Joint, Level::Tip);
    let text = "G0 X1\nTRAORI\nORIWKS\nG0 X1 Y2 Z3\nX2\nTRAFOOF\nG0 X0 Y0 Z0\n";
    assert_eq!(levels(Sinumerik, text), [joint, tip, tip, joint]);
    let text = "G0 X1\nM68 E3 Q1\nM66 E0 L0\nG0 X1 Y2 Z3\nM68 E3 Q0\nG0 X0 Y0 Z0\n";
    assert_eq!(levels(Linuxcnc, text), [joint, tip, joint]);
    let options = ReadOptions { level: tip, ..ReadOptions::default() };
    assert_eq!(moves(&read(&reading::control(Grblhal), "t", "G0 X1\n", &options).unwrap().program)[0].level, tip);
}

#[test]
fn a_start_is_where_the_first_block_begins() {
    let options = ReadOptions { start: Some(vec![1.0, 2.0, 3.0, 4.0, 5.0]), ..ReadOptions::default() };
    let reading = read(&reading::control(Sinumerik), "t", "G91 G1 X1 F60\nG90 Z0\n", &options).unwrap();
    assert_eq!(rows(&reading.program)[0][..5], [2.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(moves(&reading.program)[1].seconds, 3.0);
}

#[test]
fn remarks_messages_and_titles() {
    let program = good(Linuxcnc, "%\n(a weld)\n(second)\n(MSG, mind the gap)\nG0 X1 ; there\nM0\nM2\n%\n");
    assert_eq!(program.title, "a weld");
    let comments: Vec<_> =
        program.steps.iter().filter(|s| matches!(s.what, What::Comment(_))).map(|s| s.line).collect();
    assert_eq!(comments, [3, 5]);
    assert_eq!(events(&program), ["mind the gap", "stop"].map(|m| (Event::Message(m.into()), true)));
    assert_eq!(events(&good(Sinumerik, "MSG(\"a; b\") ; c\n")), [(Event::Message("a; b".into()), true)]);
    assert_eq!(events(&good(Pmac, "SEND\"a; b\" // c\n")), [(Event::Message("a; b".into()), true)]);
}

#[test]
fn expressions() {
    let x = |dialect, text: &str| rows(&good(dialect, text)).last().unwrap()[0];
    let all = [
        (Sinumerik, "R1=2 R2=R1*3+4\nG0 X=R2-(1+R1)*2", 4.0),
        (Sinumerik, "DEF REAL LONG_NAME=1.5, OTHER\nOTHER=SQRT(16)\nG0 X=LONG_NAME*OTHER", 6.0),
        (Sinumerik, "G0 X=SIN(30)+COS(60)+TAN(45)", 2.0),
        (Sinumerik, "G0 X=ATAN2(1,1)+ABS(-5)+ASIN(1)+ACOS(0)", 230.0),
        (Sinumerik, "G0 X=-2*-3+7 DIV 2 + 7 MOD 4", 12.0),
        (Linuxcnc, "#1=2 #<a name>=3\nG0 X[#1*#<aname>**2/[3-1.5]]", 12.0),
        (Linuxcnc, "#1=2\n#2=#1 #1=5\nG0 X#2", 2.0),
        (Linuxcnc, "#3=4\n#4=3\nG0 X##4", 4.0),
        (Linuxcnc, "G0 X[SIN[30] + ATAN[1]/[1] + -7 MOD 4 + FUP[0.2]]", 47.5),
        (Linuxcnc, "#1=2\nG0 X-#1", -2.0),
        (Pmac, "P1=3\nQ2=P1*2\nX(Q2-SQRT(P1*3)+7%4)", 6.0),
        (Pmac, "X(-ATAN(1)+INT(2.5)+1/2)", -42.5),
    ];
    for (dialect, text, value) in all {
        let text = if dialect == Pmac { format!("RAPID\n{text}\n") } else { format!("{text}\n") };
        assert!((x(dialect, &text) - value).abs() < 1e-9, "{text}: {}", x(dialect, &text));
    }
}

fn pass_names(program: &PartProgram) -> Vec<&str> {
    program.steps.iter().filter_map(|s| if let What::Pass(name) = &s.what { Some(&**name) } else { None }).collect()
}

#[test]
fn siemens_sub_programs() {
    let text = "%_N_WELD_MPF\n;$PATH=/_N_WKS_DIR/_N_SEAMWRIGHT_WPD\n;title\nG91 F60\nPASS_1 ; root\nN20 PASS_2 P=2 ; cap\nG0 X1\nM30\n\
                %_N_PASS_1_SPF\nG1 X10\nINNER\nM17\n%_N_PASS_2_SPF\nG1 Y10\n%_N_INNER_SPF\nZ3\nRET\n";
    let program = good(Sinumerik, text);
    assert_eq!(program.title, "title");
    assert_eq!(rows(&program).last().unwrap()[..3].to_vec(), [11.0, 20.0, 3.0]);
    let lines: Vec<u32> = program.steps.iter().filter(|s| matches!(s.what, What::Move(_))).map(|s| s.line).collect();
    assert_eq!(lines, [10, 16, 14, 14, 7]);
    assert_eq!(pass_names(&program), ["root", "cap"]);
}

#[test]
fn linuxcnc_sub_programs() {
    let text = "(title)\no101 sub (root)\nG1 X10\no<in> call\no101 endsub\no<in> sub\nZ3\no<in> endsub\nG91 G94 F60\no101 call\n\
                o101 call (again)\nM2\n";
    let program = good(Linuxcnc, text);
    assert_eq!(rows(&program).last().unwrap()[..3], [20.0, 0.0, 6.0]);
    assert_eq!(pass_names(&program), ["root", "again"]);
}

#[test]
fn labels_begin_passes_where_there_are_no_sub_programs() {
    for (dialect, text) in [(Grblhal, "N1000 (root)\nN1001 G0 X1\nN2000\n"), (Pmac, "N1000 ; root\nRAPID X1\nN2000\n")]
    {
        let program = good(dialect, text);
        let whats: Vec<&What> = program.steps.iter().map(|s| &s.what).collect();
        assert_eq!(*whats[0], What::Pass("root".into()));
        assert_eq!(*whats[2], What::Pass("N2000".into()));
        assert_eq!(program.steps[0].number, Some(1000));
    }
    // grblHAL also with a numbered line that has the whole modal state.
    let text = "(title)\nN10 G90 (no pass)\nN1000 G21 G17 G90 G94 (root)\nN1010 G0 X1\nN2000 G21 G17 G90\n";
    let passes: Vec<What> = good(Grblhal, text).steps.into_iter().map(|s| s.what).collect();
    assert_eq!(passes[1], What::Pass("root".into()));
    assert_eq!((&passes[3], passes.len()), (&What::Pass("N2000".into()), 4));
}

#[test]
fn pmac_paths() {
    let text = "; title\n&1\n#1->X\n#2->1000Y\n#3->Z\nI190=1000\nOPEN PROG 1 CLEAR\nABS TA0 TS0\nRAPID X1 Y2 Z3 B4 C5\n\
                PVT(100)\nX2:10 Y3:-5 Z3:0 B4:0 C5:0.5\nSPLINE1 TA(50)\nX3\nX4 Y5\nINC(X) LINEAR TM12.5\nX1 Y1\nCLOSE\n";
    let program = good(Pmac, text);
    let moves = moves(&program);
    let Path::Hermite(speeds) = moves[1].path else { panic!("{:?}", moves[1]) };
    assert_eq!(program.row(speeds)[..5], [10.0, -5.0, 0.0, 0.0, 0.5]);
    assert_eq!(program.row(moves[1].row)[..5], [2.0, 3.0, 3.0, 4.0, 5.0]);
    assert_eq!((moves[2].path, moves[3].path), (Path::Spline, Path::Spline));
    assert!((moves[1].seconds - 0.1).abs() < 1e-12 && (moves[2].seconds - 0.05).abs() < 1e-12);
    // TA holds for the line too.
    assert_eq!(program.row(moves[4].row)[..2], [5.0, 1.0]);
    assert!((moves[4].seconds - 0.05).abs() < 1e-12);
}

#[test]
fn what_is_not_understood_is_left_out_and_listed() {
    let options = ReadOptions { lenient: true, ..ReadOptions::default() };
    let text = "G90 G54 T1 D1 BRISK\nG0 X1 Q=5 Y2 FOO(1, 2) Z3\nG999 X2\n/X7\n§ X3\n";
    let reading = read(&reading::control(Sinumerik), "t", text, &options).unwrap();
    let left: Vec<_> = reading.left_out.iter().map(|l| (l.line, l.column, l.text.as_str())).collect();
    let expected = [
        (1, 9, "T1"),
        (1, 12, "D1"),
        (1, 15, "BRISK"),
        (2, 7, "Q=5"),
        (2, 14, "FOO(1, 2)"),
        (3, 1, "G999"),
        (4, 1, "/X7"),
    ];
    assert_eq!(left[..7], expected);
    assert_eq!((left[7], left.len()), ((5, 1, "§"), 8));
    let x: Vec<f64> = rows(&reading.program).iter().map(|r| r[0]).collect();
    assert_eq!(x, [1.0, 2.0, 3.0]);
    let reading = read(&reading::control(Linuxcnc), "t", "T1 M6 G43 H1\nG0 X1 U5\n", &options).unwrap();
    assert_eq!(reading.left_out.len(), 5);
    // Wrong numbers and missing feeds stay errors.
    for text in ["G0 X1..2\n", "G1 X5\n", "G0 X\n"] {
        assert!(read(&reading::control(Linuxcnc), "t", text, &options).is_err(), "{text}");
    }
}

#[test]
fn what_stands_behind_the_end_is_told() {
    let reading = reading::try_read(Linuxcnc, "G0 X1\nM2\n\nG0 X2\n").unwrap();
    assert_eq!(rows(&reading.program).len(), 1);
    assert!(reading.notes[0].to_string().starts_with("line 4: "), "{:?}", reading.notes);
    assert!(reading::try_read(Linuxcnc, "%\nG0 X1\nM2\n%\n").unwrap().notes.is_empty());
}
