//! Variables, expressions, repeated passes.

use seamwright_document::Bound;
use seamwright_document::DocumentError;
use seamwright_program::Program;
use seamwright_testkit::{Random, cases};

const TEXT: &str = "schema = 1\ntitle = \"= a title\"\nmachine = \"m\"\n[variables]\nstart_angle_deg = 30\ntimes = 3\n\
    [seam.nozzle]\nradius_mm = 250\n[seam.nozzle.body.cylinder]\nradius_mm = 800\n[start]\n\
    phi_deg = \"= start_angle_deg + 15\"\n[[passes]]\nname = \"root\"\nrepeat = \"= times\"\n[[passes.spans]]\n\
    from_mm = 0\nto_mm = '= 2 * (start_angle_deg - 5) / 4'\nspeed_mm_s = { from = \"=5\", to = 6 }\n\
    process = { current_a = 180 }\n[[passes]]\nname = \"cap\"\n[[passes.spans]]\nfrom_mm = 0\nto_mm = 9\nspeed_mm_s = 5\n";

#[test]
fn expressions_are_numbers_wherever_numbers_are() {
    let program = Program::read("p.toml", TEXT).unwrap_or_else(|e| panic!("{e}")).value;
    assert!((program.start.phi_deg.get() - 45.0).abs() < 1e-15);
    assert!((program.passes[0].length() - 12.5).abs() < 1e-15);
    assert_eq!((program.title.as_str(), program.passes[0].repeat.get()), ("= a title", 3));
    let written = program.to_toml().unwrap();
    assert!(written.contains("[variables]\nstart_angle_deg = 30\ntimes = 3\n"), "{written}");
    assert_eq!(Program::read("p.toml", &written).unwrap().value, program);
    let names: Vec<String> = program.expanded().passes.into_iter().map(|pass| pass.name).collect();
    assert_eq!(names, ["root 1", "root 2", "root 3", "cap"]);
    assert!(program.expanded().passes.iter().all(|pass| pass.repeat.get() == 1));
}

fn wrong(from: &str, to: &str) -> DocumentError {
    assert!(TEXT.contains(from));
    let e = Program::read("p.toml", &TEXT.replacen(from, to, 1)).unwrap_err();
    println!("{e}");
    e
}

#[test]
fn what_is_wrong_has_its_place() {
    let e = wrong("= start_angle_deg + 15", "= start_angel_deg + 15");
    assert_eq!((e.key.as_str(), e.line), ("start.phi_deg", 12));
    assert_eq!(e.help.as_ref().map(ToString::to_string).as_deref(), Some("did you mean `start_angle_deg`?"));
    let deep = "(".repeat(500);
    let syntax = [
        "= 1 +",
        "=",
        "= (1",
        "= 1)",
        "= 1 2",
        "= 1 $ 2",
        "= .",
        "= times times",
        "= * 2",
        "= 1e",
        "= 2..3",
        "= ()",
        &format!("= {deep}1"),
    ];
    for bad in syntax {
        let e = wrong("= start_angle_deg + 15", bad);
        assert_eq!((e.key.as_str(), e.line), ("start.phi_deg", 12), "{bad}");
    }
    for bad in ["= 1 / 0", "= 1e308 * 10", "= 0 / 0", "= 1 / (times - 3)"] {
        let e = wrong("= start_angle_deg + 15", bad);
        assert!(e.message.to_string().contains("not finite") && e.line == 12, "{bad}");
    }
    // Errors in the number itself keep their line and key; so do later lines.
    assert_eq!(wrong("= 2 * (start", "= -2 * (start").line, 18);
    assert_eq!(wrong("= times", "= times * 1000").line, 15);
    assert_eq!(wrong("= times", "= times / 2").key, "passes[0].repeat");
    assert_eq!(wrong("current_a = 180", "current_a = -1").line, 20);
    assert_eq!(wrong("times = 3", "\"a b\" = 3").key, "variables");
    assert_eq!(wrong("times = 3", "times = \"= 2\"").key, "variables.times");
    assert_eq!(wrong("times = 3", "times = inf").key, "variables.times");
    assert!(wrong("\"= times\"", "\"\"\"= \ntimes\"\"\"").message.to_string().contains("its line"));
    let none =
        Program::read("p.toml", &TEXT.replace("[variables]\nstart_angle_deg = 30\ntimes = 3\n", "")).unwrap_err();
    assert!(none.help.unwrap().to_string().contains("[variables]"));
    for bad in ["0", "1001", "1.5", "-1", "nan"] {
        assert_eq!(wrong("\"= times\"", bad).key, "passes[0].repeat", "{bad}");
    }
}

/// A random expression and its value, worked out while it is made.
fn expression(random: &mut Random, depth: usize) -> (String, f64) {
    if depth == 0 || random.below(4) == 0 {
        let value = random.number(0.0, 20.0);
        return match random.below(4) {
            0 => ("a".to_owned(), 1.5),
            1 => ("b_2".to_owned(), -7.25),
            2 => (format!("{value:e}"), value),
            _ => (format!("{value:?}"), value),
        };
    }
    let ((l, x), (r, y)) = (expression(random, depth - 1), expression(random, depth - 1));
    let gap = random.one(&["", " ", "  "]);
    match random.below(6) {
        0 => (format!("({l}{gap}+{gap}{r})"), x + y),
        1 => (format!("({l}-{gap}{r})"), x - y),
        2 => (format!("({l}){gap}*{gap}({r})"), x * y),
        3 => (format!("-({l}{gap})"), -x),
        // Without parentheses: from the left, products first.
        4 => (format!("({l} - {r} * {l} / 3 - {r})"), x - y * x / 3.0 - y),
        _ => (format!("({l} / ({r}){gap})"), x / y),
    }
}

#[test]
fn random_expressions_have_their_values() {
    let mut random = Random::new(5);
    let mut finite = 0;
    for _ in 0..cases(3000) {
        let (text, value) = expression(&mut random, 5);
        let program = TEXT
            .replace("= start_angle_deg + 15", &format!("= {text}"))
            .replace("times = 3", "times = 3\na = 1.5\nb_2 = -7.25");
        match Program::read("p.toml", &program) {
            Ok(read) => {
                assert!((read.value.start.phi_deg.get() - value).abs() <= 1e-12 * value.abs(), "{text} {value}");
                finite += 1;
            }
            // An angle is not finite, or beyond the bound of its unit.
            Err(e) => {
                let allowed = value.is_finite() && Bound::of("phi_deg").unwrap().allows(value);
                assert!(!allowed && e.key == "start.phi_deg", "{text} {value} {e}");
            }
        }
    }
    assert!(finite > 2000, "{finite}");
}
