use super::recorded_weld_page;
use seamwright_record::Moment;
use seamwright_record::figures::{Curve, Figures, Value};
use seamwright_record::library::{Alarm, Event, Place, WeldDetail, WeldFile, WeldRecord, WeldResult};

fn detail() -> WeldDetail {
    let value = |pass, outside_s| Value {
        pass,
        name: "current_a".to_owned(),
        least: 219.0,
        mean: 240.0,
        greatest: 251.5,
        allowed: Some((220.0, 260.0)),
        outside_s,
        outside_mm: 10.0 * outside_s,
    };
    let at = Moment(1_795_269_909_000);
    let place = Place { pass: Some(1), s_mm: Some(31.25), t_s: Some(4.0) };
    WeldDetail {
        weld: WeldRecord {
            id: 17,
            part: "N-17 <left>".to_owned(),
            title: "Nozzle & shell".to_owned(),
            simulated: true,
            begun: at,
            ended: Some(at),
            result: WeldResult::Good,
            note: String::new(),
            job: Some(("saddle.toml".to_owned(), 2)),
            program: ("Nozzle".to_owned(), 3, "ab".repeat(32)),
            machine: ("saddle-4axis".to_owned(), 1),
            procedure: Some(("WPS 135-01".to_owned(), 1)),
            welder: Some("A. Welder".to_owned()),
            heat_input_kj_mm: Some([0.5, 0.52, 0.54]),
            worst_deviation_mm: Some((0.123, 31.25)),
        },
        values: vec![value(1, 0.0), value(2, 0.25)],
        alarms: vec![Alarm {
            name: "arc lost".to_owned(),
            cause: "<script>".to_owned(),
            place,
            raised: at,
            first_out: true,
            acknowledged: Some(("A. Welder".to_owned(), at)),
        }],
        events: vec![Event { at, text: "hold".to_owned(), place }],
        files: vec![WeldFile {
            name: "trace.parquet".to_owned(),
            sha256: "cd".repeat(32),
            bytes: 1000,
            rows: Some(10),
        }],
    }
}

fn figures() -> Figures {
    let curve = |name: &str| Curve { pass: 1, name: name.to_owned(), points: vec![(1.0, 0.5), (3.0, 0.54)] };
    Figures {
        arc_on_s: 158.0,
        heat_input: vec![curve("heat_input_kj_mm")],
        deviations: vec![curve("path_error_mm"), curve("miss_lateral_mm")],
        ..Figures::default()
    }
}

#[test]
fn everything_stands_on_the_page() {
    let page = recorded_weld_page(&detail(), &figures(), "schema = 1\n", "2026-11-22");
    for wanted in [
        "N-17 &lt;left&gt;",
        "Nozzle &amp; shell",
        "saddle-4axis",
        "WPS 135-01",
        "A. Welder",
        "One value left its window",
        "Heat input along the seam",
        "Torch tip beside the planned path",
        "Weld beside the joint",
        "arc lost",
        "31.25",
        "Inspector",
        "Signature",
        &"cd".repeat(32),
        &"ab".repeat(32),
        "schema = 1",
    ] {
        assert!(page.contains(wanted), "{wanted}");
    }
    assert!(!page.contains("<script"));
    // Well-formed, and it reaches for nothing.
    let body = page.split_once("<!DOCTYPE html>").unwrap().1;
    roxmltree::Document::parse(body.trim()).unwrap();
    for outside in ["https://", "@import", "url("] {
        assert!(!page.contains(outside), "{outside}");
    }
}

#[test]
fn only_a_good_weld_is_in_order() {
    let verdict = |change: &dyn Fn(&mut WeldDetail)| {
        let mut detail = detail();
        detail.values.truncate(1);
        change(&mut detail);
        !recorded_weld_page(&detail, &figures(), "", "").contains("Not in order")
    };
    assert!(verdict(&|_| {}));
    assert!(!verdict(&|d| d.weld.result = WeldResult::Interrupted));
    assert!(!verdict(&|d| d.weld.note = "3 rows of the trace were lost".to_owned()));
    assert!(!verdict(&|d| d.values[0].outside_s = 0.01));
    // Nothing known at all is a page too.
    let empty = WeldDetail { values: vec![], alarms: vec![], events: vec![], files: vec![], ..detail() };
    assert!(recorded_weld_page(&empty, &Figures::default(), "", "").contains("Nothing of it is known"));
}
