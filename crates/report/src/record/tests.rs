use super::recorded_weld_page;
use crate::{Language, value_names};
use seamwright_executive::tracking;
use seamwright_executive::{Alarm as Catalogue, Mode};
use seamwright_message::Message;
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
        outside_along: (outside_s > 0.0).then_some((12.0, 14.5)),
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
            note: "".into(),
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
            name: "arc lost".into(),
            cause: "<script>".into(),
            priority: "low".to_owned(),
            place,
            raised: at,
            first_out: true,
            acknowledged: Some(("A. Welder".to_owned(), at)),
        }],
        events: vec![Event { at, text: "hold".into(), place }],
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
    let page = recorded_weld_page(&detail(), &figures(), "schema = 1\n", "2026-11-22", Language::English);
    for wanted in [
        "N-17 &lt;left&gt;",
        "Nozzle &amp; shell",
        "saddle-4axis",
        "WPS 135-01",
        "A. Welder",
        "Outside the procedure's windows: ",
        "in pass 2, s = 12 to 14.5 mm",
        "Heat input along the seam",
        "Deviation of the torch tip from the planned path",
        "Deviation of the weld from the joint",
        "arc lost",
        "31.25",
        "Inspector",
        "Signature",
        "Current, A",
        &"cd".repeat(32),
        &"ab".repeat(32),
        "schema = 1",
    ] {
        assert!(page.contains(wanted), "{wanted}");
    }
    assert!(!page.contains("<script"));
    // Well-formed, and without external references.
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
        !recorded_weld_page(&detail, &figures(), "", "", Language::English).contains("Not in order")
    };
    assert!(verdict(&|_| {}));
    assert!(!verdict(&|d| d.weld.result = WeldResult::Interrupted));
    assert!(!verdict(&|d| d.weld.note = "3 rows of the trace were lost".into()));
    assert!(!verdict(&|d| d.values[0].outside_s = 0.01));
    // A record without any data has a page too.
    let empty = WeldDetail { values: vec![], alarms: vec![], events: vec![], files: vec![], ..detail() };
    assert!(
        recorded_weld_page(&empty, &Figures::default(), "", "", Language::English).contains("No values are recorded")
    );
}

/// Returns pages with every text that a page can contain, and with invented names.
fn full(language: Language) -> String {
    let good = detail();
    let record = WeldRecord {
        part: "Q-1".to_owned(),
        title: "Zzyzx".to_owned(),
        job: Some(("zz.toml".to_owned(), 2)),
        program: ("Zz".to_owned(), 3, "0".repeat(64)),
        machine: ("zz-4".to_owned(), 1),
        procedure: Some(("135-01".to_owned(), 1)),
        welder: Some("Zoe".to_owned()),
        ..good.weld.clone()
    };
    let alarm = |title: Message, cause: Message, first_out| Alarm {
        name: title,
        cause,
        first_out,
        acknowledged: None,
        ..good.alarms[0].clone()
    };
    let of = |alarm: Catalogue, about: Option<Message>| (alarm.title_of(about), alarm.entry().cause);
    let alarms = [
        of(Catalogue::DriveFault, Some(Message::verbatim("x"))),
        of(Catalogue::ArcLost, None),
        of(Catalogue::Tracking, tracking::trouble(0)),
    ];
    let mut alarms: Vec<Alarm> = alarms.into_iter().map(|(title, cause)| alarm(title, cause, false)).collect();
    // Old records have text without a code.
    alarms.push(alarm("0".into(), "1".into(), true));
    let event = |text: Message| Event { text, ..good.events[0].clone() };
    let events: Vec<Event> = Mode::ALL.map(Mode::message).into_iter().chain(["2".into()]).map(event).collect();
    let value = |name: &str, allowed| Value { name: name.to_owned(), allowed, ..good.values[0].clone() };
    let values = vec![
        value("heat_input_kj_mm", Some((90.0, 900.0))),
        value("tip_speed_mm_s", None),
        value("wire_feed_m_min", Some((1.0, 9.0))),
        good.values[1].clone(),
    ];
    let curve = |pass, name: &str| Curve { pass, name: name.to_owned(), points: vec![(1.0, 0.5), (3.0, 0.54)] };
    let many = Figures {
        heat_input: (1..10).map(|pass| curve(pass, "heat_input_kj_mm")).collect(),
        deviations: vec![curve(1, "path_error_mm"), curve(2, "miss_lateral_mm_q"), curve(1, "miss_height_mm")],
        ..figures()
    };
    let results = [WeldResult::Good, WeldResult::Deviating, WeldResult::Stopped, WeldResult::Interrupted];
    let mut pages = String::new();
    for (i, result) in results.into_iter().chain([WeldResult::Running]).enumerate() {
        let weld = WeldRecord { result, simulated: i == 0, note: "0".into(), ..record.clone() };
        let detail = WeldDetail {
            weld: WeldRecord { ended: None, ..weld },
            values: values.clone(),
            alarms: alarms.clone(),
            events: events.clone(),
            files: vec![WeldFile { sha256: "0".repeat(64), ..good.files[0].clone() }],
        };
        pages += &recorded_weld_page(&detail, &many, "", "", language);
        // Texts for missing data, and for one or several items.
        let values = vec![good.values[1].clone(); i];
        let procedure = record.procedure.clone().filter(|_| i > 0);
        let weld = WeldRecord { procedure, ..detail.weld };
        let detail = WeldDetail { weld, values, alarms: vec![], events: vec![], files: vec![] };
        pages += &recorded_weld_page(&detail, &Figures::default(), "", "", language);
    }
    pages
}

/// Returns the visible words, without those of the styles.
fn words(page: &str) -> std::collections::BTreeSet<String> {
    let bare = page.split("<style>").flat_map(|part| part.split("</style>").skip(1).chain(["<"]));
    let mut text = String::new();
    for piece in bare.collect::<String>().split('<') {
        // The label for screen readers, and the text behind the tag.
        let (tag, rest) = piece.split_once('>').unwrap_or(("", piece));
        text += tag.split_once("aria-label=\"").map_or("", |(_, label)| label.split('"').next().unwrap());
        text += " ";
        text += rest;
        text += " ";
    }
    let text = text.to_lowercase();
    text.split(|c: char| !c.is_alphabetic()).filter(|word| word.chars().count() > 2).map(str::to_owned).collect()
}

#[test]
fn a_page_in_another_language_has_no_english_left() {
    let english = words(&full(Language::English));
    assert!(english.len() > 100 && english.contains("inspector"));
    for language in Language::ALL {
        let page = full(language);
        assert!(page.contains(&format!("<html lang=\"{}\">", language.code())));
        for document in page.split("<!DOCTYPE html>").skip(1) {
            roxmltree::Document::parse(document.trim()).unwrap();
        }
        if language == Language::English {
            continue;
        }
        let left: Vec<String> = words(&page).intersection(&english).cloned().collect();
        // Names, and words that are equal in both languages.
        let same: &[&str] = match language {
            Language::German => &["name", "version", "text", "bytes", "alarm", "override", "gas", "hand"],
            _ => &[],
        };
        let names = ["seamwright", "zzyzx", "toml", "zoe", "sha", "utc", "trace", "parquet", "wps", "min"];
        let left: Vec<&String> =
            left.iter().filter(|w| !names.contains(&w.as_str()) && !same.contains(&w.as_str())).collect();
        assert!(left.is_empty(), "{language:?}: {left:?}");
    }
}

#[test]
fn what_people_typed_and_what_has_no_words_stays() {
    for language in Language::ALL {
        let page = recorded_weld_page(&detail(), &figures(), "schema = 1\n", "2026-11-22", language);
        for wanted in ["N-17 &lt;left&gt;", "Nozzle &amp; shell", "A. Welder", "WPS 135-01", "arc lost", "2026-11-22"] {
            assert!(page.contains(wanted), "{language:?}: {wanted}");
        }
        let number = format!("31{}25", language.decimal_sign());
        assert!(page.contains(&number), "{language:?}: {number}");
        assert_eq!(value_names::value(language, "odd_thing_m_min").split(',').next(), Some("odd thing"));
    }
}
