//! The output of the crate is well-formed, escaped and contains the given data.

#![allow(clippy::unwrap_used)] // helpers of tests

use roxmltree::{Document, Node, ParsingOptions};
use seamwright_machine::check::{Check, CheckOptions};
use seamwright_machine::{Machine, SHIPPED};
use seamwright_report::{
    Axis, Band, Block, Chart, ChartGrid, Drawing as _, Finding, Language, LimitLine, MachineDrawing, Mark, Page,
    Series, Severity, Style, Table, ThreeViews, Tile, Verdict, check_page,
};

const EVIL: &str = "</text></style><script>alert('x')</script> \"a\" & <b> ]]> \u{0}\u{7}";

/// Parses an inline drawing, whose name space is that of the page.
fn check(svg: &str) -> usize {
    let document = Document::parse(svg).unwrap_or_else(|e| panic!("{e}\n{svg}"));
    for node in document.descendants().filter(Node::is_element) {
        assert_ne!(node.tag_name().name(), "script");
        for a in node.attributes() {
            assert!(!["NaN", "inf"].iter().any(|bad| a.value().contains(bad)), "{}: {}", a.name(), a.value());
            assert!(!a.name().starts_with("on"));
        }
    }
    svg.len()
}

fn check_chart(chart: &Chart) -> String {
    check(&chart.to_svg_standalone());
    let svg = chart.to_svg();
    check(&svg);
    svg
}

fn points(svg: &str, class: &str) -> Vec<(f64, f64)> {
    let document = Document::parse(svg).unwrap();
    let paths = document.descendants().filter(|n| n.attribute("class") == Some(class));
    let numbers = |d: &str| -> Vec<f64> {
        let spaced = d.replace(['M', 'H', 'V', ',', 'h'], " ");
        spaced.split_whitespace().map(|n| n.parse().unwrap()).collect()
    };
    let all = paths
        .filter_map(|p| p.attribute("d"))
        .flat_map(|d| numbers(d).chunks(2).map(|c| (c[0], c[1])).collect::<Vec<_>>());
    all.collect()
}

fn chart(series: Vec<Series>) -> Chart {
    Chart { title: "t".into(), x: Axis::new("s", "mm"), y: Axis::new("v", "mm/s"), series, ..Chart::default() }
}

#[test]
fn a_million_points_stay_small_and_keep_their_peaks() {
    let spike = |i: u32| match i {
        333_333 => 1000.0,
        666_666 => -1000.0,
        _ => f64::from(i % 1009 * 7919 % 1000) / 100.0,
    };
    let data: Vec<_> = (0..1_000_000).map(|i| (f64::from(i), spike(i))).collect();
    for style in [Style::Line, Style::Dashed, Style::Points] {
        let svg = check_chart(&chart(vec![Series::line("v", data.clone()).styled(style)]));
        assert!(svg.len() < 100_000, "{style:?}: {} bytes", svg.len());
        if style == Style::Line {
            let y: Vec<f64> = points(&svg, "line c1").iter().map(|p| p.1).collect();
            let (top, bottom) = (y.iter().fold(f64::MAX, |a, b| a.min(*b)), y.iter().fold(0.0f64, |a, b| a.max(*b)));
            // 2000 units and 6 % of padding at either end are 220 px.
            assert!((bottom - top - 220.0 / 1.12).abs() < 0.3, "{top} to {bottom}");
        }
    }
}

#[test]
fn odd_data_are_drawn_without_harm() {
    let n = f64::NAN;
    for data in [
        vec![],
        vec![(n, n)],
        vec![(1.0, 5.0)],
        vec![(0.0, 0.0)],
        vec![(0.0, 3.0), (1.0, 3.0), (2.0, 3.0)],
        vec![(4.0, 1.0), (4.0, 2.0)],
        vec![(0.0, f64::INFINITY), (1.0, 2.0), (2.0, f64::NEG_INFINITY)],
        vec![(f64::INFINITY, 1.0), (-1e300, 2.0), (0.0, 1e308), (0.0, -1e308)],
        vec![(0.0, 1e-300), (1e-300, 3e-300)],
        vec![(0.0, 1e99), (1.0, -1e99)],
        vec![(0.0, 1e9), (1.0, 1e9 + 1e-6)],
        vec![(0.0, 1.0), (1.0, n), (2.0, 1.0), (3.0, n), (4.0, 2.0), (5.0, 2.0)],
    ] {
        for style in [Style::Line, Style::Dashed, Style::Points] {
            for equal_aspect in [false, true] {
                let mut c = chart(vec![Series::line("a", data.clone()).styled(style), Series::default()]);
                c.equal_aspect = equal_aspect;
                check_chart(&c);
                c.limits = [n, f64::INFINITY, 0.0, -1e6, 1e200].map(|v| LimitLine::new("limit", v)).to_vec();
                c.bands = [(n, 1.0), (2.0, 1.0), (-1e300, 1e300), (f64::NEG_INFINITY, 0.0)]
                    .map(|(from, to)| Band { label: "b".into(), from, to })
                    .to_vec();
                c.height = Some(n);
                check_chart(&c);
                c.y_range = Some((5.0, -5.0));
                check_chart(&c);
                c.y_range = Some((0.5, 1.5));
                check_chart(&c);
                let grid = ChartGrid { title: String::new(), columns: 2, charts: vec![c.clone(), c.clone(), c] };
                check(&grid.to_svg());
                check(&grid.to_svg_standalone());
            }
        }
    }
    assert!(check_chart(&chart(vec![])).contains("no data"));
    check(&ChartGrid::default().to_svg());
    check(&ThreeViews::default().to_svg());
}

#[test]
fn gaps_break_the_line_and_lone_points_are_dots() {
    let n = f64::NAN;
    let data = vec![(0.0, 1.0), (1.0, 2.0), (2.0, n), (3.0, 1.5), (4.0, n), (5.0, 2.0), (6.0, 1.0)];
    let svg = check_chart(&chart(vec![Series::line("v", data)]));
    let path = svg.split("class=\"line c1\" d=\"").nth(1).unwrap().split('"').next().unwrap();
    assert_eq!(path.matches('M').count(), 2, "{path}");
    assert!(svg.contains("class=\"dots c1\""));
}

#[test]
fn far_limits_are_named_and_do_not_squash() {
    let mut c = chart(vec![Series::line("v", (0..100).map(|i| (f64::from(i), f64::from(i) * 0.01)).collect())]);
    let alone = points(&check_chart(&c), "line c1");
    c.limits = vec![LimitLine::new("limit", 30.0)];
    let svg = check_chart(&c);
    assert!(svg.contains("limit 30 mm/s, above"));
    assert_eq!(points(&svg, "line c1").last(), alone.last());
    c.limits = vec![LimitLine::new("limit", 1.5)];
    let svg = check_chart(&c);
    assert!(svg.contains(">limit 1.5</text>") && !svg.contains("above"));
}

#[test]
fn equal_aspect_keeps_circles_round() {
    let circle = |r: f64| (0..=360).map(|i| f64::from(i).to_radians()).map(|a| (r * a.cos(), r * a.sin())).collect();
    let mut c = chart(vec![Series::line("v", circle(25.0))]);
    c.equal_aspect = true;
    for height in [None, Some(100.0), Some(600.0)] {
        c.height = height;
        let p = points(&check_chart(&c), "line c1");
        let span = |f: fn(&(f64, f64)) -> f64| {
            p.iter().map(f).fold(f64::MIN, f64::max) - p.iter().map(f).fold(f64::MAX, f64::min)
        };
        assert!((span(|p| p.0) - span(|p| p.1)).abs() < 0.3, "{height:?}");
    }
}

#[test]
fn views_share_scale_and_alignment() {
    let odd = [f64::NAN, 0.0, f64::INFINITY];
    let views = ThreeViews {
        title: EVIL.into(),
        path: vec![[0.0, 0.0, 0.0], [300.0, 0.0, 0.0], [300.0, 200.0, 100.0], odd, [0.0; 3]],
        vectors: vec![([0.0; 3], odd), ([0.0; 3], [0.0, 0.0, 100.0])],
        marks: vec![Mark { label: EVIL.into(), at: [0.0; 3] }, Mark { label: "lost".into(), at: odd }],
        path_name: EVIL.into(),
        ..ThreeViews::default()
    };
    check(&views.to_svg_standalone());
    let svg = views.to_svg();
    check(&svg);
    assert!(!svg.contains("lost"));
    let document = Document::parse(&svg).unwrap();
    let paths: Vec<&str> = document
        .descendants()
        .filter(|n| n.attribute("class") == Some("line fat c1"))
        .filter_map(|n| n.attribute("d"))
        .filter(|d| d.matches(' ').count() == 2)
        .collect();
    let [front, side, top, _] = paths.as_slice() else { panic!("{paths:?}") };
    let read = |d: &str| -> Vec<f64> { d[1..].split([' ', ',']).map(|n| n.parse().unwrap()).collect() };
    let (front, side, top) = (read(front), read(side), read(top));
    let near = |a: f64, b: f64| assert!((a - b).abs() < 0.3, "{a} {b}");
    for i in 0..3 {
        near(front[2 * i], top[2 * i]);
        near(front[2 * i + 1], side[2 * i + 1]);
    }
    let scale = (front[2] - front[0]) / 300.0;
    near((front[1] - front[5]) / scale, 100.0);
    near((top[1] - top[5]) / scale, 200.0);
    near((side[0] - side[4]) / scale, 200.0);
    assert!(top[1] > front[1] && side[0] > front[4], "top below front, side to the right");
}

fn page() -> Page {
    let text = || EVIL.to_string();
    Page {
        language: Language::English,
        title: text(),
        subtitle: text(),
        meta: vec![(text(), text())],
        verdict: Some(Verdict { ok: false, text: text() }),
        blocks: vec![
            Block::Tiles(vec![
                Tile { label: text(), value: "-1.5".into(), unit: text(), note: text(), severity: None },
                Tile { severity: Some(Severity::Error), ..Tile::default() },
            ]),
            Block::Heading(text()),
            Block::Paragraph(text()),
            Block::Table(Table {
                caption: text(),
                head: vec![text(), "n".into()],
                rows: vec![vec![text(), "-2".into(), "too many".into()], vec![]],
                numeric: vec![false, true],
                sortable: false,
            }),
            Block::Figure {
                svg: chart(vec![Series::line(EVIL, vec![(0.0, 1.0), (1.0, 2.0)])]).to_svg(),
                caption: text(),
            },
            Block::Findings(vec![Finding { severity: Severity::Warning, text: text(), place: text(), cure: text() }]),
            Block::Findings(vec![]),
            Block::Code { caption: text(), text: format!("a\n\n{EVIL}\n") },
        ],
    }
}

#[test]
fn a_page_is_well_formed_and_escaped() {
    for page in [page(), Page::default()] {
        let html = page.render();
        let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
        let document = Document::parse_with_options(&html, options).unwrap_or_else(|e| panic!("{e}\n{html}"));
        assert!(document.descendants().all(|n| !n.has_tag_name("script")));
        assert!(!html.contains("<script"));
        assert_eq!(html.matches("</style>").count(), 1);
        for reference in ["http", "url(", "@import", "src=", "href="] {
            assert!(!html.contains(reference), "a page refers to nothing outside: {reference}");
        }
    }
}

#[test]
fn a_page_holds_what_it_was_given() {
    let html = page().render();
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let document = Document::parse_with_options(&html, options).unwrap();
    let all = |tag: &str| document.descendants().filter(|n| n.has_tag_name(tag)).collect::<Vec<_>>();
    let seen = EVIL.replace(['\u{0}', '\u{7}'], "\u{fffd}");
    assert_eq!(all("h1")[0].text(), Some(seen.as_str()));
    assert_eq!(all("td").len(), 4, "rows are cut off or filled up");
    assert_eq!(all("td")[1].text(), Some("−2"));
    assert_eq!(all("td")[1].attribute("class"), Some("number"));
    let rows = document.descendants().filter(|n| n.attribute("class") == Some("row"));
    assert_eq!(
        rows.map(|n| n.text().unwrap_or("").to_string()).collect::<Vec<_>>(),
        ["a\n", "\n", &format!("{seen}\n")]
    );
    for text in ["Not in order", "Table 1.", "Figure 1.", "No findings.", "Warning:"] {
        assert!(html.contains(text), "{text}");
    }
}

/// Returns estimated boxes of the names in a drawing's views, only those in the clipped frames.
fn names_in_views(svg: &str) -> Vec<Vec<(f64, f64, f64, f64)>> {
    let document = Document::parse(svg).unwrap();
    let views = document.root_element().children().filter(|n| n.tag_name().name() == "svg");
    let boxes = |view: Node| -> Vec<(f64, f64, f64, f64)> {
        let names = view.descendants().filter(|n| n.attribute("class") == Some("halo"));
        let number = |n: &Node, a: &str| n.attribute(a).unwrap().parse::<f64>().unwrap();
        let one = |n: Node| {
            let half = 0.26 * 12.0 * n.text().unwrap().chars().count() as f64;
            let (x, y) = (number(&n, "x"), number(&n, "y"));
            (x - half, y - 9.0, x + half, y + 2.0)
        };
        names.map(one).collect()
    };
    views.map(boxes).collect()
}

#[test]
fn machines_are_drawn_with_every_axis_and_no_name_on_another() {
    for s in SHIPPED {
        let machine = Machine::read(s.name, s.text).unwrap();
        let drawing = MachineDrawing::new(&machine, Language::English);
        check(&drawing.to_svg_standalone());
        let svg = drawing.to_svg();
        check(&svg);
        let views = names_in_views(&svg);
        assert_eq!(views.len(), 4, "{}", s.name);
        for names in views {
            // Axes, heads, base and work.
            assert!(names.len() > machine.axes.len() + machine.heads.len(), "{}", s.name);
            for (i, a) in names.iter().enumerate() {
                for b in &names[..i] {
                    let apart = a.2 <= b.0 || b.2 <= a.0 || a.3 <= b.1 || b.3 <= a.1;
                    assert!(apart, "{}: {a:?} {b:?}", s.name);
                }
            }
        }
    }
}

/// Arrow heads of bars point in the axis' direction of motion, as measured in the page's coordinates.
#[test]
fn arrows_of_a_machine_point_the_positive_way() {
    let file = |moved: &str, branch: &str| {
        format!(
            "schema = 1\nname = \"m\"\ntitle = \"m\"\n[[{branch}]]\naxis = \"x\"\nmove = {moved}\nrange_mm = [-100, 200]\n\
             max_speed_mm_s = 50\nmax_acceleration_mm_s2 = 500\n[torch]\ndirection = [0, 0, -1]\n"
        )
    };
    for (moved, branch, class, sense) in
        [("[1, 0, 0]", "tool", "f1", 1.0), ("[1, 0, 0]", "work", "f2", 1.0), ("[-1, 0, 0]", "work", "f2", -1.0)]
    {
        let machine = Machine::read("m", &file(moved, branch)).unwrap();
        let svg = MachineDrawing::new(&machine, Language::English).to_svg();
        let front = Document::parse(&svg).unwrap();
        let front = front.root_element().children().find(|n| n.tag_name().name() == "svg").unwrap();
        let head = front.descendants().find(|n| n.attribute("class") == Some(class)).unwrap();
        let d = head.attribute("d").unwrap().replace(['M', 'z', ','], " ");
        let x: Vec<f64> = d.split_whitespace().step_by(2).map(|n| n.parse().unwrap()).collect();
        // The tip first, then the two corners of the foot.
        assert!(sense * (x[0] - x[1]) > 5.0 && sense * (x[0] - x[2]) > 5.0, "{moved} {branch}: {x:?}");
    }
}

#[test]
fn a_check_makes_a_page_that_is_well_formed_whatever_the_file_says() {
    let text = SHIPPED[5].text.replacen("title = \"", "title = \"</title><script>&", 1);
    let file = seamwright_machine::MachineFile::read("m", &text).unwrap();
    let machine = Machine::read("m", &text).unwrap();
    let options = CheckOptions { seed: 1, poses: 50 };
    let result = Check::run(&file, &machine, &options, &mut || ());
    let page =
        check_page(&result, &MachineDrawing::new(&machine, Language::English), EVIL, &text, "now", Language::English);
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(&page, options).unwrap();
    assert!(!page.contains("<script>") && page.contains("the torch lies along axis c"));
}
