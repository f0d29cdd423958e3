use super::*;
use crate::said;
use seamwright_cell::executive::Alarm;
use seamwright_cell::tracking;
use seamwright_program::WeldingProcess;
use std::collections::BTreeSet;

fn holes_of(text: &str) -> BTreeSet<char> {
    text.split('{').skip(1).filter_map(|piece| piece.chars().next()).collect()
}

fn has_letters(text: &str, count: usize) -> bool {
    let bare: String = text.split(['{', '}']).step_by(2).collect();
    bare.split(|c: char| !c.is_alphabetic()).any(|word| word.chars().count() >= count)
}

/// Words that German shares with English.
const SAME: [&str; 8] = ["Name", "Position", "Version", "Text", "Bytes", "Gas", "Alarm", "Override {0} %"];

#[test]
fn every_phrase_has_words_in_all_languages_with_the_same_holes() {
    assert!(WORDS.phrases.len() > 100 && WORDS.sentences.len() > 20 && WORDS.units.len() > 20);
    let shared: Vec<Row> = WORDS.tongues[0]
        .words
        .keys()
        .map(|key| WORDS.tongues.each_ref().map(|tongue| tongue.words.get(key).cloned().unwrap_or_default()))
        .collect();
    assert!(shared.len() > 50);
    for row in WORDS.phrases.values().chain(&WORDS.sentences).chain(&shared) {
        for (language, text) in Language::ALL.into_iter().zip(row) {
            assert!(!text.is_empty(), "{language:?}: {row:?}");
            assert_eq!(holes_of(text), holes_of(&row[0]), "{language:?}: {row:?}");
            let cyrillic = |c: char| ('\u{400}'..='\u{4ff}').contains(&c);
            let translated = match language {
                Language::English => true,
                Language::Ukrainian | Language::Russian => text.chars().any(cyrillic),
                Language::Chinese => text.chars().any(|c| ('\u{4e00}'..='\u{9fff}').contains(&c)),
                Language::German => *text != row[0] || SAME.contains(&text.as_str()),
            };
            let unit = WORDS.units.values().any(|unit| *unit == row[0]);
            // A sign, like that of degrees, needs no words.
            let sign = !has_letters(text, 2);
            assert!(translated || unit || sign || !has_letters(&row[0], 3), "{language:?}: {row:?}");
        }
    }
}

#[test]
fn a_phrase_is_no_key_and_stands_once() {
    let mut seen = BTreeSet::new();
    let texts = [
        include_str!("../../../../words/report.json"),
        include_str!("../../../../words/plan.json"),
        include_str!("../../../../words/notes.json"),
    ];
    for text in texts {
        let rows: Vec<Row> = serde_json::from_str(text).unwrap();
        for [english, ..] in rows {
            assert!(!WORDS.tongues[0].words.contains_key(&english), "{english}");
            assert!(seen.insert(english.clone()), "{english}");
        }
    }
    for tongue in &WORDS.tongues {
        assert_eq!(tongue.words.len(), WORDS.tongues[0].words.len());
    }
}

#[test]
fn alarms_are_those_of_the_catalogue_and_what_they_are_about_has_words() {
    for language in &Language::ALL[1..] {
        let names: BTreeSet<&str> = WORDS.tongues[*language as usize].alarms.keys().map(String::as_str).collect();
        assert_eq!(names, Alarm::ALL.into_iter().map(|alarm| alarm.entry().name).collect(), "{language:?}");
        for trouble in (0..=u8::MAX).filter_map(tracking::trouble) {
            let name = trouble.to_string();
            let said = language.sentence(&name, str::to_owned);
            assert!(said.is_some_and(|said| said != name), "{language:?}: {name}");
        }
    }
}

#[test]
fn sentences_are_found_again_with_what_stands_in_them() {
    let say = |text: &str| Language::German.sentence(text, str::to_owned);
    let left = "pass 2 was left, welded up to 12.50 mm";
    assert_eq!(say(left).unwrap(), "Lage 2 wurde verlassen, geschweißt bis 12.50 mm");
    assert_eq!(say("override 50 %").unwrap(), "Override 50 %");
    let lost = "recovered 2026-11-23, 7 bytes at the end of the trace were no whole rows";
    assert!(say(lost).unwrap().contains("7 Bytes am Ende"));
    assert_eq!(say("stopped by: {0}").unwrap(), "gestoppt durch: {0}");
    for odd in ["", "what nobody says", "override", "pass 2 was left", "override 50 % more"] {
        assert_eq!(say(odd), None, "{odd}");
    }
}

#[test]
fn every_sentence_is_found_again_with_names_in_its_holes() {
    let names = ["qa", "qb", "qc", "qd", "qe", "qf", "qg"];
    for row in &WORDS.sentences {
        for language in &Language::ALL[1..] {
            let said = language.sentence(&filled(&row[0], &names), str::to_owned);
            assert_eq!(said, Some(filled(&row[*language as usize], &names)), "{language:?}: {row:?}");
        }
    }
}

#[test]
fn findings_are_told_with_what_stands_in_them() {
    let german = |text: &str| said::sentence(Language::German, text);
    let slow = "axis theta cannot keep 10.000 mm/s: its acceleration limit of 20.000 deg/s^2 allows 9.412 mm/s";
    assert_eq!(said::sentence(Language::English, slow), slow);
    assert!(german(slow).starts_with("Achse theta kann 10.000 mm/s nicht halten: ihre Grenze für Beschleunigung"));
    let corners = "set corner = { blend_mm = 0.2 } to go round corners within that distance of the seam";
    assert_eq!(german(corners), "mit corner = { blend_mm = 0.2 } höchstens so weit neben der Naht um Ecken gehen");
    let far = "saddle: the axes cannot reach the point; it is 3.0000 mm off";
    assert_eq!(german(far), "saddle: die Achsen erreichen den Punkt nicht: es fehlen 3.0000 mm");
    assert_eq!(
        german("nothing seen by the sensor: the sensor is silent"),
        "der Sensor sieht nichts: der Sensor schweigt"
    );
    for typed in ["what nobody has said", "pass {0}: odd", ""] {
        assert_eq!(german(typed), typed);
    }
}

#[test]
fn what_files_may_name_has_words() {
    let processes = WeldingProcess::all().iter().map(|process| process.name);
    let source = include_str!("../../../program/src/seam.rs");
    let kinds = source.split_once("fn kind").unwrap().1.split_once("    }\n}").unwrap().0;
    let kinds: Vec<&str> = kinds.split("=> \"").skip(1).map(|kind| kind.split('"').next().unwrap()).collect();
    assert!(kinds.len() > 10);
    for name in processes.chain(kinds) {
        assert!(Language::German.known(name).is_some(), "{name}");
    }
    let windows = ["speed_mm_s", "heat_input_kj_mm", "travel_angle_deg", "work_angle_deg", "preheat_c", "interpass_c"];
    for value in windows.into_iter().chain(["current_a", "voltage_v", "laser_w", "beam_ma", "accelerating_kv"]) {
        let (title, unit) = value_name(value);
        assert!(unit.is_some() && Language::German.named("value", title).is_some(), "{value}");
    }
}

#[test]
fn the_unit_of_a_value_is_the_longest_that_its_name_ends_in() {
    for (name, parts) in [
        ("current_a", ("current", Some("A"))),
        ("tip_speed_mm_s", ("tip_speed", Some("mm/s"))),
        ("heat_input_kj_mm", ("heat_input", Some("kJ/mm"))),
        ("wire_feed_m_min", ("wire_feed", Some("m/min"))),
        ("odd", ("odd", None)),
        ("a", ("a", None)),
    ] {
        assert_eq!(value_name(name), parts);
    }
}

#[test]
fn codes_are_read_and_others_refused() {
    for language in Language::ALL {
        assert_eq!(language.code().parse(), Ok(language));
    }
    for wrong in ["", "EN", "fr", "de-AT", "english"] {
        assert_eq!(wrong.parse::<Language>(), Err("allowed: en, uk, zh, de, ru".to_owned()));
    }
}
