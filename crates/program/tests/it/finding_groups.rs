//! Equal findings as one, with all their places.

use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, FindingGroup, FindingPlace, PathRange, group_findings};

fn note(message: Message, pass: usize, from_mm: f64, to_mm: f64) -> Finding {
    Finding::note("process", message, pass, PathRange { from_mm, to_mm })
}

fn codes(groups: &[FindingGroup<'_>]) -> Vec<String> {
    groups.iter().map(|group| group.message.as_data()).collect()
}

#[test]
fn equal_findings_are_one_with_all_their_places() {
    let same = |pass, from, to| note(Message::new("same"), pass, from, to);
    let mut findings: Vec<Finding> = (2..=14).map(|pass| same(pass, 0.0, 0.0)).collect();
    findings.insert(3, same(2, 5.0, 7.0));
    findings.push(same(20, 0.0, 0.0));
    findings.push(note(Message::new("other"), 14, 0.0, 0.0));
    let groups = group_findings(&findings);
    assert_eq!(codes(&groups), ["same", "other"]);
    let place = |first_pass, last_pass, from_mm, to_mm| FindingPlace { first_pass, last_pass, from_mm, to_mm };
    assert_eq!(groups[0].places, [place(2, 14, 0.0, 0.0), place(2, 2, 5.0, 7.0), place(20, 20, 0.0, 0.0)]);
    assert!(groups[0].places[0].is_point() && !groups[0].places[1].is_point());
}

#[test]
fn numbers_that_differ_are_ranges() {
    let unwinds = |axis: &str, by: f64, pass: usize| {
        let message = Message::new("unwinds").axis("axis", axis).quantity("by", by, Unit::Deg, 1).pass("pass", pass);
        note(message, pass, 0.0, 0.0)
    };
    let findings = [unwinds("j1", 318.2, 4), unwinds("j1", 711.0, 5), unwinds("j1", 35.1, 9)];
    assert_eq!(codes(&group_findings(&findings)), ["unwinds: axis = j1, by = 35.1 deg to 711.0 deg, pass = 4 to 9"]);
    // Another axis is another matter.
    assert_eq!(group_findings(&[unwinds("j1", 1.0, 1), unwinds("j2", 1.0, 1)]).len(), 2);
    // One that stands alone stays as it is.
    assert_eq!(group_findings(&findings[..1])[0].message, findings[0].message);
}

#[test]
fn errors_keep_their_numbers() {
    let speed = |code, speed| Message::new(code).quantity("speed", speed, Unit::MmPerS, 1);
    let error =
        |v: f64| Finding { allowed: false, cure: Some(speed("set", v)), ..note(speed("allows", v), 1, 0.0, 1.0) };
    let groups = [error(4.1), error(3.9), error(4.1), error(4.1000001)];
    let groups = group_findings(&groups);
    let cures: Vec<&Message> = groups.iter().filter_map(|group| group.cure.as_ref()).collect();
    assert_eq!(cures, [&speed("set", 4.1), &speed("set", 3.9)]);
}

#[test]
fn what_stands_against_the_weld_comes_first() {
    let note = note(Message::new("note"), 1, 0.0, 1.0);
    let warning = Finding { cure: Some(Message::new("do")), message: Message::new("warning"), ..note.clone() };
    let error = Finding { allowed: false, message: Message::new("error"), ..note.clone() };
    let findings = [note.clone(), warning, error, note];
    assert_eq!(codes(&group_findings(&findings)), ["error", "warning", "note"]);
}

#[test]
fn another_cure_or_severity_is_another_finding() {
    let one = note(Message::new("same"), 1, 0.0, 1.0);
    let other = Finding { cure: Some(Message::new("do")), ..one.clone() };
    let against = Finding { allowed: false, ..one.clone() };
    assert_eq!(group_findings(&[one, other, against]).len(), 3);
}
