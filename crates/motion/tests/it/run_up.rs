//! Extent of the acceleration phase, and travels that are too short or too long for it.

use crate::planning::{plan, read, read_machine};
use crate::positive;
use seamwright_document::NonNegative;
use seamwright_machine::{Machine, shipped};
use seamwright_program::{OnLimit, Ramp, Severity, Span, SpanValue};
use seamwright_weld::Welding;

/// A line along X of `ellipse-xy` at the speed that `weld` asks for.
fn line(length: f64, weld: &str) -> Welding {
    let job = format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"ellipse-xy\"\n[seam.line]\nstart_mm = [{}, 0, 0]\nend_mm = [{}, 0, 0]\n\
         first_normal = [0, 1, 1]\nsecond_normal = [0, -1, 1]\n[weld]\n{weld}\n",
        -0.5 * length,
        0.5 * length
    );
    read(&job)
}

/// `ellipse-xy` with other limits: every `from` in its file becomes the `to` beside it.
fn machine(changes: &[(&str, &str)]) -> Machine {
    let text = changes.iter().fold(shipped("ellipse-xy").unwrap().text.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    read_machine(&text)
}

/// An axis that gains 3 mm/s^2 is at 24 mm/s after 100 mm, on which the speed shall rise to 50.
#[test]
fn a_rise_that_an_axis_cannot_follow_is_no_run_up() {
    let slow = machine(&[("max_acceleration_mm_s2 = 500", "max_acceleration_mm_s2 = 3"), ("= 5000", "= 30")]);
    let rising = |on_limit: OnLimit, steady: bool| {
        let mut welding = line(1100.0, "speed_mm_s = 50");
        let pass = &mut welding.program.value.passes[0];
        let span = pass.spans[0].clone();
        let ramp = SpanValue::Ramp(Ramp { from: positive(5.0), to: positive(50.0) });
        let begin = if steady { span.speed_mm_s } else { ramp };
        pass.spans = vec![
            Span { to_mm: positive(100.0), speed_mm_s: begin, ..span.clone() },
            Span { from_mm: NonNegative::new(100.0).unwrap(), ..span },
        ];
        pass.on_limit = on_limit;
        welding
    };
    let found = plan(&slow, &rising(OnLimit::Refuse, false)).unwrap_err();
    let speed = found.iter().find(|f| f.kind == "speed" && !f.allowed).unwrap_or_else(|| panic!("{found:#?}"));
    assert!(
        speed.message.to_string().contains("axis x") && speed.message.to_string().contains("acceleration"),
        "{}",
        speed.message
    );
    assert!(speed.from_mm < 60.0 && speed.to_mm > 350.0, "{speed:#?}");
    let motion = plan(&slow, &rising(OnLimit::Slow, false)).unwrap_or_else(|f| panic!("{f:#?}"));
    let leg = motion.profile.legs()[0];
    assert!(leg.run_up_end > 1.0 && leg.run_up_end < 60.0 && leg.run_down_start > 600.0, "{leg:?}");
    assert!(
        motion.findings.iter().any(|f| f.kind == "speed" && f.severity() == Severity::Note),
        "{:#?}",
        motion.findings
    );
    // From rest to a steady speed the time is the same, and all of it is the acceleration phase.
    let motion = plan(&slow, &rising(OnLimit::Refuse, true)).unwrap_or_else(|f| panic!("{f:#?}"));
    assert!(motion.profile.legs()[0].run_up_end > 400.0, "{:?}", motion.profile.legs());
    // If the axes can follow, the acceleration phase lasts up to the requested speed.
    let motion = plan(&machine(&[]), &rising(OnLimit::Refuse, false)).unwrap_or_else(|f| panic!("{f:#?}"));
    assert!(motion.profile.legs()[0].run_up_end < 10.0, "{:?}", motion.profile.legs());
}

#[test]
fn a_weld_too_short_for_its_speed_that_may_slow_down_has_a_note() {
    let refused = plan(&machine(&[]), &line(5.0, "speed_mm_s = 80")).unwrap_err();
    assert!(refused[0].message.to_string().contains("too short") && refused[0].cure.is_some(), "{refused:#?}");
    let slow = plan(&machine(&[]), &line(5.0, "speed_mm_s = 80\non_limit = \"slow\"")).unwrap();
    let short = slow.findings.iter().find(|f| f.message.to_string().contains("too short")).unwrap();
    assert!(short.severity() == Severity::Note && short.cure.is_none(), "{short:#?}");
}

#[test]
fn a_travel_that_slow_axes_draw_out_over_days_is_refused() {
    let slow = machine(&[("max_speed_mm_s = 100", "max_speed_mm_s = 0.001")]);
    let found = plan(&slow, &line(400.0, "speed_mm_s = 5\non_limit = \"slow\"")).unwrap_err();
    let time = found.iter().find(|f| f.kind == "time").unwrap_or_else(|| panic!("{found:#?}"));
    assert!(!time.allowed && time.message.to_string().contains("200000 s"), "{}", time.message);
}
