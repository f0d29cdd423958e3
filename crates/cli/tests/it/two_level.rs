//! `seamwright tools motion` with two levels: fine set-points by way of coarse ones, and the output for other controls.

use crate::common::{column, example, good, run, table};

const AXES: [&str; 4] = ["theta", "s", "h", "beta"];

#[test]
fn fine_set_points_pass_through_the_coarse_ones() {
    let job = example("saddle");
    let fine = table(&good(&["tools", "motion", &job, "--period-ms", "5", "--coarse-ms", "20"]));
    let coarse = table(&good(&["tools", "motion", &job, "--period-ms", "20"]));
    let exact = table(&good(&["tools", "motion", &job, "--period-ms", "5"]));
    assert_eq!(fine.0, exact.0);
    assert_eq!(fine.1.len(), 4 * (coarse.1.len() - 1) + 1);
    let t = column(&fine, "t_s");
    assert!(t.iter().zip(column(&exact, "t_s")).all(|(a, b)| (a - b).abs() < 1e-12));
    for name in AXES.iter().chain(&["s_mm"]) {
        let (fine, coarse, exact) = (column(&fine, name), column(&coarse, name), column(&exact, name));
        // To the last bit at the coarse points.
        assert!(coarse.iter().enumerate().all(|(k, q)| fine[4 * k].to_bits() == q.to_bits()), "{name}");
        let off = fine.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        println!("{name}: {off:e}");
        // The speed profile jumps in acceleration at its start and stop; there is no other difference.
        assert!(off < 2e-2, "{name}: {off:e}");
        let middle = fine.len() / 3..fine.len() / 2;
        let off = middle.map(|k| (fine[k] - exact[k]).abs()).fold(0.0, f64::max);
        assert!(off < 1e-7, "{name}: {off:e} in full travel");
    }
}

/// A control sums the basis functions of the uniform cubic B-spline: it comes through the exact set-points.
#[test]
fn spline1_passes_through_the_set_points() {
    for (name, air) in [("saddle", false), ("ellipse", true)] {
        let job = example(name);
        let arguments = ["tools", "motion", &job, "--period-ms", "10", "--air"];
        let arguments = if air { &arguments[..] } else { &arguments[..5] };
        let control = table(&good(&[arguments, &["--export", "spline1"]].concat()));
        let exact = table(&good(arguments));
        assert_eq!((control.1.len(), &control.0), (exact.1.len() + 48, &exact.0));
        let times = column(&control, "t_s");
        assert!((times[0] + 0.24).abs() < 1e-12 && times[24].abs() < 1e-15);
        let arc = column(&control, "arc");
        assert!(arc[..24].iter().chain(&arc[arc.len() - 24..]).all(|a| a.abs() < 1e-15));
        for axis in &exact.0[3..exact.0.iter().position(|c| c == "speed_mm_s").unwrap()] {
            let (c, q) = (column(&control, axis), column(&exact, axis));
            let worst = q.iter().enumerate().map(|(k, q)| ((c[k + 23] + 4.0 * c[k + 24] + c[k + 25]) / 6.0 - q).abs());
            let worst = worst.fold(0.0, f64::max);
            assert!(worst < 1e-9, "{axis}: {worst:e}");
            // It starts and ends at rest at the first and last set-point.
            let n = c.len();
            let ends = [c[0] - q[0], c[1] - c[0], c[n - 1] - q[q.len() - 1], c[n - 2] - c[n - 1]];
            assert!(ends.iter().all(|d| d.abs() < 1e-9), "{axis}: {ends:?}");
        }
    }
}

/// Positions and speeds are those of one curve without jumps in acceleration.
#[test]
fn pvt_has_continuous_accelerations() {
    let exact = table(&good(&["tools", "motion", &example("saddle"), "--period-ms", "10"]));
    let pvt = table(&good(&["tools", "motion", &example("saddle"), "--period-ms", "10", "--export", "pvt"]));
    let h = 0.01;
    for (name, speed) in AXES.iter().zip(["theta_deg_s", "s_mm_s", "h_mm_s", "beta_deg_s"]) {
        let (q, v) = (column(&pvt, name), column(&pvt, speed));
        assert!(q.iter().zip(column(&exact, name)).all(|(a, b)| a.to_bits() == b.to_bits()));
        assert!(v[0].abs() < 1e-12 && v[v.len() - 1].abs() < 1e-12);
        let mut worst = 0.0f64;
        for k in 2..q.len() - 2 {
            // Of the cubics before and after, each from positions and speeds alone.
            let before = (-6.0 * (q[k] - q[k - 1]) + h * (2.0 * v[k - 1] + 4.0 * v[k])) / (h * h);
            let after = (6.0 * (q[k + 1] - q[k]) - h * (4.0 * v[k] + 2.0 * v[k + 1])) / (h * h);
            worst = worst.max((before - after).abs());
        }
        // Positions near 400 have 6e-14 of rounding, of which the difference quotient makes this much.
        assert!(worst < 1e-7, "{name}: {worst:e}");
    }
}

#[test]
fn bad_input() {
    let job = example("ellipse");
    let refused = |arguments: &[&str], word: &str| {
        let output = run(&[&["tools", "motion", &job], arguments].concat());
        let text = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(2) && output.stdout.is_empty() && text.contains(word), "{text}");
    };
    for bad in ["0", "-1", "nan", "inf", "3", "0.5", "1e9"] {
        refused(&["--period-ms", "2", &format!("--coarse-ms={bad}")], "--coarse-ms");
    }
    for bad in ["", "spline2", "SPLINE1"] {
        refused(&[&format!("--export={bad}")], "spline1");
    }
    refused(&["--export", "pvt", "--coarse-ms", "10"], "cannot be used with");
}
