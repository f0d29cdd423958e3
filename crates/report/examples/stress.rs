#![allow(missing_docs, clippy::unwrap_used)]
use seamwright_report::*;
fn main() {
    let l = "A rather long name that somebody typed into a job file without thinking of the report";
    let s = (0..7)
        .map(|k| {
            Series::line(
                format!("series {k} with a longer name"),
                (0..200).map(|i| (f64::from(i) * 1e-5, 1e6 + f64::from(k) * (f64::from(i) * 0.05).sin())).collect(),
            )
            .styled([Style::Line, Style::Dashed, Style::Steps, Style::Points][k as usize % 4])
        })
        .collect::<Vec<_>>();
    let c = Chart {
        title: format!("{l}, {l}"),
        x: Axis::new("time since the arc was struck", "s"),
        y: Axis::new("voltage", "V"),
        series: s.clone(),
        limits: [
            ("upper alarm", 1e6 + 7.0),
            ("upper warning", 1e6 + 6.8),
            ("limit with a very long name indeed, too long", 1e6 - 6.0),
            ("far", -3e6),
            ("far too", 1e9),
        ]
        .map(|(l, v)| LimitLine::new(l, v))
        .to_vec(),
        bands: (0..6)
            .map(|k| Band {
                label: format!("band {k} named"),
                from: f64::from(k) * 2e-4,
                to: f64::from(k) * 2e-4 + 4e-5,
            })
            .collect(),
        ..Chart::default()
    };
    let g =
        ChartGrid { title: l.into(), columns: 4, charts: vec![c.clone(), c.clone(), c.clone(), c.clone(), c.clone()] };
    let v = ThreeViews {
        title: l.into(),
        path: (0..100).map(|i| [0.0, 0.0, f64::from(i) * 20.0]).collect(),
        path_name: "vertical up".into(),
        vectors: vec![([0.0; 3], [100.0, -100.0, 0.0])],
        marks: (0..6)
            .map(|i| Mark { label: format!("tack {i}, a longer name"), at: [0.0, 0.0, f64::from(i) * 40.0] })
            .collect(),
        ..ThreeViews::default()
    };
    let p = Page {
        title: format!("{l}_{l}").replace(' ', "_"),
        subtitle: l.into(),
        meta: vec![(l.into(), l.replace(' ', "_")), ("a".into(), "b".into())],
        verdict: Some(Verdict { ok: true, text: format!("{l}. {l}. {l}.") }),
        blocks: vec![
            Block::Tiles(vec![Tile {
                label: l.into(),
                value: "-123456789.123".into(),
                unit: "mm/s²".into(),
                note: l.into(),
                severity: Some(Severity::Note),
            }]),
            Block::Figure { svg: c.to_svg(), caption: l.into() },
            Block::Figure { svg: g.to_svg(), caption: l.into() },
            Block::Figure { svg: v.to_svg(), caption: l.into() },
            Block::Table(Table {
                caption: l.into(),
                head: (0..14).map(|i| format!("Column {i}")).collect(),
                rows: vec![(0..14).map(|i| format!("-{i}.25")).collect(); 3],
                numeric: vec![true; 14],
            }),
            Block::Code { caption: "x".into(), text: format!("{l} {l} {l}\n\tx") },
        ],
    };
    std::fs::write("/tmp/demo/stress.html", p.render()).unwrap();
}
