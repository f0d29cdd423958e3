//! For any text the reader gives a program or an error with its position, and never panics: random garbage, and
//! programs with parts changed, doubled, cut and mixed. `SEAMWRIGHT_FUZZ_S` is the number of seconds; texts that once
//! failed are in `tests/data/read`.

use crate::reading;
use seamwright_post::{Control, Dialect, Path, ReadOptions, What, read};
use seamwright_testkit::{Random, cases};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

const CORPUS: [&str; 6] = [
    include_str!("../../../../examples/ebw-fig1.mpf"),
    "%_N_WELD_MPF\n;$PATH=/_N_WKS_DIR/_N_SEAMWRIGHT_WPD\nDEF REAL LEN=5.5\nG90 G71 G17 G40 G500 G64\nFGROUP(X,Y,Z,C1)\nG93\n\
     R1=2*(LEN+1) R2=SIN(R1)+ATAN2(1,2)\nMSG(\"go\")\nPASS_1 P=2 ; root\nG94 F600 G0 X0 Y0\nG2 X10 Y0 I5 J0 TURN=1\nG3 X0 CR=-6.5 C1=DC(30)\n\
     CIP X10 Y5 I1=3 J1=4 K1=1\nTRAORI\nG0 X=AC(1) Y=2 Z=3 CW=0.5\nG3 AR=90 I5 J0\nM30\n%_N_PASS_1_SPF\nWHEN TRUE DO $A_OUT[1]=1\n\
     $A_OUTA[2]=22.5\nG60 G1 X=R1 F=30 CW=.5\nG4 F0.5\nPRESETON(CW,0,CW,1)\nM17\n",
    "%\n(title)\no101 sub (root)\nG93 G1 X[1+#1**2] Y#<len> F60\nG91 G2 X5 I2.5 P2 F2\nG90 M67 E0 Q120\nG18 G3 X0 Z3 R-9 F5\no101 endsub\n\
     #1=2 #<len>=[ATAN[1]/[2] MOD 3]\nG21 G17 G90 G40 G49 G80 G94\nG64 P0.1 Q0\nG0 X0 Y0 Z0 B0 C0\nM64 P0\no101 call\nM68 E3 Q1\nM66 E0 L0\n\
     G53 G0 X1 Y2 Z3\nM62 P1\nG4 P0.5\nM3 S100\nG20 G94 G1 X1 F5\nM2\n%\n",
    "N1000 (root)\nG21 G17 G90 G94\nS5 M3\nG93 G1 X1 Y2 S7 F60\nG4 P0\nG2 X5 Y5 R9 F20\nG3 I5 F2\nM62 P1\nM67 E1 Q2\nM8\nM5\nM2\n",
    "; title\n&1\n#1->X\n#2->1000Y\nI190=1000\nOPEN PROG 1 CLEAR\nN1000 ; root\nABS TA0 TS0\nRAPID X1 Y2 Z3 B4 C5\nM1==1 M101=120\n\
     PVT(100)\nX2:10 Y3:-5 Z3:0 B4:0 C5:0.5\nSPLINE1 TA50\nX3\nINC(X,R) LINEAR TM12.5\nP1=2*(3-1) X(P1) Y1\nDWELL0\n\
     NORMAL K-1 CIRCLE2 X5 I2.5\nFRAX(X,Y) F20 CIRCLE1 X1 Y1 R50\nSEND\"a\"\nM120=5\nDELAY20\nCLOSE\n",
    "G54 X\u{e9}\u{a7}\u{feff}\n\t\r\n(\u{1f525})\n",
];

/// Words and characters that mutations put in.
#[rustfmt::skip]
const BITS: [&str; 48] = [
    "G0", "G1 ", "G2", "G3 ", "G4", "G91\n", "X", "Y=", "Z-", "I", "J", "K", "F", "R", "P", "CR=", "AR=", "TURN=",
    "CIP", "(", ")", "[", "]", "#", "<", ">", "o101 ", "call\n", "%", "%_N_", "_MPF\n", "_SPF\n", ";", "//", "\"", ",",
    ".", "-", "=", "**", "9999999999", "0", "\n", "\r", "\u{e9}", "1e308", "$A_OUT[", "TRAORI\n",
];

/// Reads with every dialect, strictly and leniently, and checks the result.
fn survives(controls: &[Control; 4], text: &str) -> Result<(), String> {
    for control in controls {
        for lenient in [false, true] {
            let options = ReadOptions { lenient, ..ReadOptions::default() };
            let reading = catch_unwind(AssertUnwindSafe(|| read(control, "fuzz", text, &options)));
            let dialect = control.dialect;
            match reading.map_err(|_| format!("{dialect:?} panics"))? {
                Err(error) => {
                    let line = text.split('\n').nth(error.line.wrapping_sub(1));
                    let line = line.ok_or_else(|| format!("{dialect:?}: no line {}", error.line))?;
                    if error.column < 1 || error.column > line.chars().count() + 1 || error.to_string().is_empty() {
                        return Err(format!("{dialect:?}: column {} of {line:?}", error.column));
                    }
                }
                Ok(reading) => {
                    let program = &reading.program;
                    for step in &program.steps {
                        let What::Move(m) = &step.what else { continue };
                        let fine = m.seconds >= 0.0
                            && m.seconds.is_finite()
                            && program.row(m.row).iter().all(|v| v.is_finite());
                        let arc =
                            |a: &seamwright_post::Arc| a.sweep.is_finite() && (a.normal.length() - 1.0).abs() < 1e-9;
                        let arc = !matches!(m.path, Path::Arc(i) if !arc(&program.arcs[i as usize]));
                        if !fine || !arc {
                            return Err(format!("{dialect:?}: {m:?} in line {}", step.line));
                        }
                    }
                    let lines = text.split('\n').count();
                    let placed = |l: &seamwright_post::LeftOut| l.line >= 1 && l.line <= lines && l.column >= 1;
                    if (!lenient && !reading.left_out.is_empty()) || !reading.left_out.iter().all(placed) {
                        return Err(format!("{dialect:?}: {:?}", reading.left_out));
                    }
                }
            }
        }
    }
    Ok(())
}

/// A position between two characters.
fn place(random: &mut Random, text: &str) -> usize {
    let mut at = random.below(text.len() + 1);
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

fn mutate(random: &mut Random, text: &mut String) {
    let (a, b) = (place(random, text), place(random, text));
    let (a, b) = (a.min(b), a.max(b));
    let short = (a..=b.min(a + 12)).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(a);
    match random.below(7) {
        0 => text.insert_str(a, BITS[random.below(BITS.len())]),
        1 => text.replace_range(a..short, ""),
        2 => text.replace_range(a..short, BITS[random.below(BITS.len())]),
        3 => {
            let part = text[a..b].to_owned();
            let to = place(random, text);
            if text.len() < 20_000 {
                text.insert_str(to, &part);
            }
        }
        4 => {
            let other = CORPUS[random.below(CORPUS.len())];
            let from = place(random, other);
            let to = place(random, other);
            text.insert_str(a, &other[from.min(to)..from.max(to)]);
        }
        5 => text.insert(a, char::from_u32(random.below(0x3000) as u32).unwrap_or(' ')),
        _ => text.truncate(a),
    }
}

fn try_text(controls: &[Control; 4], text: &str) {
    if let Err(why) = survives(controls, text) {
        // Kept where the next run finds it.
        let name = text.bytes().fold(7u64, |h, b| h.wrapping_mul(31).wrapping_add(u64::from(b)));
        let file = format!("{}/tests/data/read/found-{name:016x}.txt", env!("CARGO_MANIFEST_DIR"));
        let _ = std::fs::write(&file, text);
        panic!("{why}; the text is kept in {file}\n{text}");
    }
}

#[test]
fn what_once_failed_does_not_any_more() {
    let controls = Dialect::ALL.map(reading::control);
    let folder = format!("{}/tests/data/read", env!("CARGO_MANIFEST_DIR"));
    let files: Vec<_> = std::fs::read_dir(folder).unwrap().collect();
    assert!(!files.is_empty());
    for file in files {
        let text = std::fs::read_to_string(file.unwrap().path()).unwrap();
        survives(&controls, &text).unwrap_or_else(|e| panic!("{e}\n{text}"));
    }
}

#[test]
fn the_corpus_is_good() {
    let good = [Dialect::Sinumerik, Dialect::Linuxcnc, Dialect::Grblhal, Dialect::Pmac];
    for (dialect, text) in good.into_iter().zip(&CORPUS[1..]) {
        read(&reading::control(dialect), "corpus", text, &ReadOptions::default()).unwrap_or_else(|e| panic!("{e}"));
    }
}

#[test]
fn garbage_and_mutations_never_panic() {
    let controls = Dialect::ALL.map(reading::control);
    let seconds = std::env::var("SEAMWRIGHT_FUZZ_S").ok().and_then(|v| v.parse().ok());
    // Long runs start with another seed each day; a failing text is kept, so the seed need not be.
    let seed = seconds.and_then(|_: u64| std::time::UNIX_EPOCH.elapsed().ok()).map_or(1, |t| t.as_secs() as u32);
    let mut random = Random::of_case(seed);
    let (begin, mut tried) = (Instant::now(), 0);
    let enough = |tried: usize| match seconds {
        Some(s) => begin.elapsed() >= Duration::from_secs(s),
        None => tried >= cases(4000),
    };
    while !enough(tried) {
        let mut text = if random.chance(0.1) {
            (0..random.below(200)).map(|_| BITS[random.below(BITS.len())]).collect()
        } else {
            CORPUS[random.below(CORPUS.len())].to_owned()
        };
        for _ in 0..=random.below(6) {
            mutate(&mut random, &mut text);
        }
        try_text(&controls, &text);
        tried += 1;
    }
    println!("{tried} texts, each in four dialects, strictly and leniently");
}
