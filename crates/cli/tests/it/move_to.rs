//! `seamwright machine move`: set-points that start and end where they should, within limits; mistakes by name.

use crate::common::{column, good, run, table};

#[test]
fn goes_from_rest_to_rest_within_limits() {
    let arguments =
        ["machine", "move", "torch-5axis", "--from=x=-100,z=150", "--to", "x=200,b=-15", "--period-ms", "1"];
    let t = table(&good(&arguments));
    assert_eq!(t.0.first().map(String::as_str), Some("t_s"));
    let (x, b, z) = (column(&t, "x"), column(&t, "b"), column(&t, "z"));
    let last = x.len() - 1;
    assert!((x[0] + 100.0).abs() < 1e-6 && (x[last] - 200.0).abs() < 1e-6 && (b[last] + 15.0).abs() < 1e-5);
    assert!(z.iter().all(|z| (z - 150.0).abs() < 1e-6));
    // 100 mm/s, 500 mm/s^2 and 5000 mm/s^3 by differences, and they are used.
    let slope = |v: &[f64]| -> Vec<f64> { v.windows(2).map(|w| (w[1] - w[0]) / 1e-3).collect() };
    let most = |v: &[f64]| v.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    let v = slope(&x);
    let (a, j) = (slope(&v), slope(&slope(&v)));
    let limits = [(most(&v), 100.0, 1e-6), (most(&a), 500.0, 1e-4), (most(&j), 5000.0, 1e-2)];
    assert!(limits.iter().all(|(m, l, e)| *m <= l * (1.0 + e) && *m > 0.99 * l), "{limits:?}");
    let speed = column(&t, "speed_mm_s");
    assert!(speed[last].abs() < 1e-6 && most(&speed) >= 99.9);
    // Half the speed takes longer.
    let slow = table(&good(&[&arguments[..], &["--override-percent", "50"]].concat()));
    assert!(most(&slope(&column(&slow, "x"))) <= 50.0 * (1.0 + 1e-6) && slow.1.len() > t.1.len());
}

#[test]
fn what_would_collide_is_refused_and_mistakes_are_named() {
    // The torch through the cradle of the tilting table.
    let output = run(&["machine", "move", "table-tilting-xyzac", "--to", "z=-290"]);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.code() == Some(1) && output.stdout.is_empty(), "{told}");
    assert!(told.contains("finding (clearance)") && told.contains("torch") && told.contains("where: t ="), "{told}");
    for (arguments, words) in [
        (vec!["--to", "x=9000"], vec!["--to x=9000", "outside the range of axis x", "allowed: -800 to 800 mm"]),
        (vec!["--to", "q=1"], vec!["no such axis", "y, z, a, b, x"]),
        (vec!["--to", "x"], vec!["axis x is not a number", "-800 to 800 mm"]),
        (vec!["--to", "x=nan"], vec!["axis x is not a number"]),
        (vec!["--to", "x=1,x=2"], vec!["given twice"]),
        (vec!["--to", "x=1", "--from", "b=-91"], vec!["--from b=-91", "allowed: -80 to 80°"]),
        (vec!["--to", "x=1", "--override-percent", "120"], vec!["--override-percent 120", "up to 100"]),
        (vec!["--to", "x=1", "--override-percent", "1e-9"], vec!["two hours"]),
        (vec!["--to", "x=1", "--period-ms", "0"], vec!["--period-ms 0"]),
        (vec!["--to", "x=1", "--period-ms", "1e-9"], vec!["set-points", "a longer period"]),
    ] {
        let output = run(&[&["machine", "move", "torch-5axis"], &arguments[..]].concat());
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && output.stdout.is_empty(), "{arguments:?}: {told}");
        assert!(words.iter().all(|w| told.contains(w)), "{arguments:?}: {told}");
    }
}
