#![allow(missing_docs, clippy::unwrap_used, clippy::print_stdout)]
use seamwright_report::*;
use std::f64::consts::TAU;

fn saddle(a: f64) -> [f64; 3] {
    let (r, big) = (250.0, 800.0);
    let (x, y) = (r * a.cos(), r * a.sin());
    [x, y, (big * big - y * y).sqrt() - 600.0]
}
fn deriv(v: &[(f64, f64)], f: f64) -> Vec<(f64, f64)> {
    v.windows(2).map(|w| (w[1].0, (w[1].1 - w[0].1) / (w[1].0 - w[0].0) * f)).collect()
}
fn main() {
    let n = 2400;
    let len = 1600.0;
    let ang = |s: f64| s / len * TAU * 1.02;
    let mut seed = 7u64;
    let mut rnd = move || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let s: Vec<f64> = (0..n).map(|i| -30.0 + (len + 60.0) * f64::from(i) / f64::from(n)).collect();
    let speed = |s: f64| {
        if s < 0.0 {
            10.0 * ((s + 30.0) / 30.0).clamp(0.0, 1.0).sqrt()
        } else if s > len {
            10.0 * ((len + 30.0 - s) / 30.0).clamp(0.0, 1.0).sqrt()
        } else {
            10.0
        }
    };
    let tip = Chart {
        title: "Tip speed over the seam".into(),
        x: Axis::new("s", "mm"),
        y: Axis::new("tip speed", "mm/s"),
        series: vec![
            Series::line("planned", s.iter().map(|s| (*s, speed(*s))).collect()),
            Series::line("simulated", s.iter().map(|s| (*s, speed(*s) + 0.15 * rnd())).collect()).styled(Style::Dashed),
        ],
        limits: vec![LimitLine::new("limit", 12.0), LimitLine::new("rapid", 200.0)],
        bands: vec![
            Band { label: "run-up".into(), from: -30.0, to: 0.0 },
            Band { label: "run-out".into(), from: len, to: len + 30.0 },
        ],
        ..Chart::default()
    };
    let mut rnd2 = {
        let mut q = 3u64;
        move || {
            q = q.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (q >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        }
    };
    let err = Chart {
        title: "Following error".into(),
        x: Axis::new("s", "mm"),
        y: Axis::new("following error", "mm"),
        series: vec![Series::line(
            "following error",
            (0..1_000_000)
                .map(|i| {
                    let s = len * f64::from(i) / 1e6;
                    (s, 0.02 * (s / 80.0).sin() + 0.02 * rnd2() + if i == 400_000 { 0.09 } else { 0.0 })
                })
                .collect(),
        )],
        limits: vec![LimitLine::new("limit", 0.1), LimitLine::new("limit", -0.1)],
        height: Some(160.0),
        ..Chart::default()
    };
    let angles = Chart {
        title: "Torch angles".into(),
        x: Axis::new("s", "mm"),
        y: Axis::new("angle", "deg"),
        series: vec![
            Series::line("work angle", s.iter().map(|s| (*s, 45.0 + 9.0 * (2.0 * ang(*s)).cos())).collect()),
            Series::line(
                "travel angle",
                s.iter()
                    .map(|s| {
                        (*s, if (700.0..760.0).contains(s) { f64::NAN } else { 10.0 + 2.0 * (2.0 * ang(*s)).sin() })
                    })
                    .collect(),
            ),
            Series::line("inclination", s.iter().map(|s| (*s, 20.0 * ang(*s).sin())).collect()).styled(Style::Steps),
            Series::line(
                "taught",
                (0..30)
                    .map(|i| (f64::from(i) * 55.0, 45.0 + 9.0 * (2.0 * ang(f64::from(i) * 55.0)).cos() + 1.0))
                    .collect(),
            )
            .styled(Style::Points),
        ],
        ..Chart::default()
    };
    let path = |k: f64| {
        (0..=600)
            .map(|i| {
                let a = f64::from(i) / 600.0 * TAU;
                (250.0 * a.cos() * (1.0 + k * (9.0 * a).sin()), 250.0 * a.sin() * (1.0 + k * (9.0 * a).sin()))
            })
            .collect::<Vec<_>>()
    };
    let inter = Chart {
        title: "Path of the interpolator".into(),
        x: Axis::new("x", "mm"),
        y: Axis::new("y", "mm"),
        equal_aspect: true,
        series: vec![
            Series::line("commanded", path(0.0)),
            Series::line("deviation × 100", path(0.03)).styled(Style::Dashed),
        ],
        ..Chart::default()
    };
    let mut charts = vec![];
    for (k, (name, u)) in [("X", "mm"), ("Y", "mm"), ("Z", "mm"), ("C", "deg")].into_iter().enumerate() {
        let pos: Vec<(f64, f64)> = s
            .iter()
            .map(|s| {
                let a = ang(*s);
                let p = saddle(a);
                (*s, if k < 3 { p[k] } else { a.to_degrees() })
            })
            .collect();
        let vel = deriv(&pos, 10.0);
        let acc = deriv(&vel, 10.0);
        let b = vec![Band { label: "run-up".into(), from: -30.0, to: 0.0 }];
        let y = |q: &str, d: &str| Axis::new(q, format!("{u}{d}"));
        let x = Axis::new("s", "mm");
        charts.push(Chart {
            title: format!("{name} position"),
            x: x.clone(),
            y: y("position", ""),
            series: vec![Series::line("position", pos)],
            limits: vec![LimitLine::new("min", -400.0), LimitLine::new("max", 400.0)],
            bands: b.clone(),
            ..Chart::default()
        });
        charts.push(Chart {
            title: format!("{name} speed"),
            x: x.clone(),
            y: y("speed", "/s"),
            series: vec![Series::line("speed", vel)],
            limits: vec![LimitLine::new("limit", 30.0), LimitLine::new("limit", -30.0)],
            bands: b.clone(),
            ..Chart::default()
        });
        charts.push(Chart {
            title: format!("{name} acceleration"),
            x,
            y: y("acceleration", "/s²"),
            series: vec![Series::line("acceleration", acc)],
            limits: vec![LimitLine::new("limit", 500.0), LimitLine::new("limit", -500.0)],
            bands: b,
            ..Chart::default()
        });
    }
    let grid = ChartGrid { title: "Axes against their limits".into(), columns: 3, charts: charts.clone() };
    let tall = ChartGrid {
        title: "Axis speed".into(),
        columns: 1,
        charts: charts
            .into_iter()
            .skip(1)
            .step_by(3)
            .map(|mut c| {
                let p = c.series[0].points.iter().map(|p| (p.0, p.1 * 0.95 + 0.3)).collect();
                c.series.push(Series::line("actual", p).styled(Style::Dashed));
                c.series[0].name = "commanded".into();
                c
            })
            .collect(),
    };
    let end = 1.02 * TAU;
    let views = ThreeViews {
        title: "Seam and torch".into(),
        path: (0..=800).map(|i| saddle(f64::from(i) / 800.0 * TAU)).collect(),
        closed: true,
        path_name: "seam".into(),
        vectors_name: "torch axis".into(),
        outlines_name: "branch and main pipe".into(),
        vectors: (0..72)
            .map(|i| {
                let a = f64::from(i) / 72.0 * TAU;
                let p = saddle(a);
                (p, [p[0] + 60.0 * a.cos(), p[1] + 60.0 * a.sin(), p[2] + 70.0])
            })
            .collect(),
        outlines: vec![
            (0..=100)
                .map(|i| {
                    let a = f64::from(i) / 100.0 * TAU;
                    [250.0 * a.cos(), 250.0 * a.sin(), 330.0]
                })
                .collect(),
            (0..=60)
                .map(|i| {
                    let y = -330.0 + 11.0 * f64::from(i);
                    [-350.0, y, (640000.0 - y * y).sqrt() - 600.0]
                })
                .collect(),
            (0..=60)
                .map(|i| {
                    let y = -330.0 + 11.0 * f64::from(i);
                    [350.0, y, (640000.0 - y * y).sqrt() - 600.0]
                })
                .collect(),
        ],
        marks: vec![
            Mark { label: "start".into(), at: saddle(0.0) },
            Mark { label: "end of overlap".into(), at: saddle(end) },
        ],
    };
    let flat = ThreeViews {
        title: "Straight seam".into(),
        path: vec![[0.0, 0.0, 0.0], [1200.0, 0.0, 0.0]],
        vectors: (0..13).map(|i| ([100.0 * f64::from(i), 0.0, 0.0], [100.0 * f64::from(i), -40.0, 40.0])).collect(),
        vectors_name: "torch axis".into(),
        path_name: "seam".into(),
        marks: vec![Mark { label: "start".into(), at: [0.0; 3] }, Mark { label: "end".into(), at: [1200.0, 0.0, 0.0] }],
        ..ThreeViews::default()
    };
    let empty = Chart {
        title: "Nothing recorded".into(),
        x: Axis::new("s", "mm"),
        y: Axis::new("error", "mm"),
        limits: vec![LimitLine::new("limit", 0.1)],
        height: Some(100.0),
        ..Chart::default()
    };
    std::fs::create_dir_all("/tmp/demo").unwrap();
    std::fs::write("/tmp/demo/tip.svg", tip.to_svg_standalone()).unwrap();
    std::fs::write("/tmp/demo/views.svg", views.to_svg_standalone()).unwrap();
    std::fs::write("/tmp/demo/grid.svg", grid.to_svg_standalone()).unwrap();
    std::fs::write("/tmp/demo/err.svg", err.to_svg_standalone()).unwrap();
    let tile = |l: &str, v: &str, u: &str, n: &str| Tile {
        label: l.into(),
        value: v.into(),
        unit: u.into(),
        note: n.into(),
        severity: None,
    };
    let bad = std::env::args().nth(1).is_some();
    let row = |r: [&str; 6]| r.map(String::from).to_vec();
    let page = Page {
        title: "Saddle seam 500 on 1600, pass 1 of 3".into(),
        subtitle: "Weld plan, checked against machine “gantry-5”".into(),
        meta: [("Job", "saddle-500.toml"), ("Machine", "gantry-5"), ("Process", "135 (MAG)"), ("Procedure", "WPS 0417-2"), ("Material", "S355J2+N, 12 mm"), ("Planned", "2026-11-20 14:02"), ("Seamwright", "0.1.0"), ("Checksum", "9f2c 11ab 03de")].map(|(a, b)| (a.into(), b.into())).to_vec(),
        verdict: Some(if bad { Verdict { ok: false, text: "1 error: axis Z would exceed its speed limit at s = 412 mm.".into() } } else { Verdict { ok: true, text: "All set-points are within the limits of the machine and of the procedure.".into() } }),
        blocks: vec![
            Block::Tiles(vec![tile("Seam length", "1600.4", "mm", "closed, overlap 32 mm"), tile("Arc time", "160", "s", "of 184 s cycle"), tile("Tip speed", "10.00", "mm/s", "±0.4 % over the seam"), tile("Heat input", "0.86", "kJ/mm", "0.7 to 1.0 allowed"), tile("Largest path error", "0.012", "mm", "at s = 412 mm"),
                Tile { severity: bad.then_some(Severity::Error), ..tile("Axis use", if bad { "104" } else { "71" }, "%", "Z speed, s = 412 mm") }, Tile { severity: bad.then_some(Severity::Warning), ..tile("Lowest work angle", "-36.1", "deg", "35 to 55 preferred") }]),
            Block::Heading("Findings".into()),
            Block::Findings(if bad { vec![
                Finding { severity: Severity::Error, text: "Axis Z needs 31.2 mm/s, 30 mm/s are allowed.".into(), place: "pass 1, s = 412 mm".into(), cure: "weld slower than 9.6 mm/s there, or tilt the work-piece by 10°.".into() },
                Finding { severity: Severity::Warning, text: "Work angle leaves its preferred range for 38 mm.".into(), place: "pass 1, s = 380 to 418 mm; job.toml line 14, key torch.work_angle".into(), cure: "allow 34°, or turn the start by 20°.".into() },
                Finding { severity: Severity::Note, text: "Torch cable turns by 367°; unwound on the way back.".into(), place: String::new(), cure: String::new() }] } else { vec![] }),
            Block::Heading("Seam".into()),
            Block::Paragraph("Intersection of a branch pipe of 500 mm with a main pipe of 1600 mm diameter. The torch stands in the bisector of the joint, drawn every 5° as it is planned.".into()),
            Block::Figure { svg: views.to_svg(), caption: "Seam with torch axis, mm. First-angle projection.".into() },
            Block::Figure { svg: angles.to_svg(), caption: "Torch angles over path length.".into() },
            Block::Heading("Motion".into()),
            Block::Figure { svg: tip.to_svg(), caption: "Speed of the wire tip. Arc on from s = 0.".into() },
            Block::Figure { svg: grid.to_svg(), caption: "Every axis over the seam.".into() },
            Block::Table(Table { caption: "Axes: largest values and what is allowed.".into(), head: row(["Axis", "Speed", "Allowed", "Use, %", "At s, mm", "Remark"]), rows: vec![row(["X", "9.87", "30", "33", "812", ""]), row(["Y", "-10.02", "30", "33", "404", "reverses twice"]), row(["Z", "3.12", "30", "10", "-12", "lead-in"]), row(["C", "2.3", "30", "8", "1611", "continuous; wraps at 720°"])], numeric: vec![false, true, true, true, true, false] }),
            Block::Figure { svg: tall.to_svg(), caption: "Axis speed, commanded and actual.".into() },
            Block::Figure { svg: err.to_svg(), caption: "Following error, 1 000 000 samples.".into() },
            Block::Figure { svg: inter.to_svg(), caption: "Interpolated path.".into() },
            Block::Figure { svg: flat.to_svg(), caption: "Edge case.".into() },
            Block::Figure { svg: empty.to_svg(), caption: "Edge case.".into() },
            Block::Heading("Job file".into()),
            Block::Code { caption: "saddle-500.toml".into(), text: "[seam]\nkind = \"saddle\"   # <branch> & main\nbranch_radius = 250.0\nmain_radius = 800.0\n\n[torch]\nwork_angle = 45.0\ntravel_angle = 10.0\n\n[procedure]\nwps = \"0417-2\"\nspeed = 10.0\n".repeat(6) },
        ],
    };
    let html = page.render();
    println!("{} KB", html.len() / 1024);
    std::fs::write("/tmp/demo/page.html", html).unwrap();
}
