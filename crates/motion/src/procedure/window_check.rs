//! Comparison of values along a planned pass with their windows.

use super::inclination::{self, Lie};
use super::planned_pass::{PlannedPass, Quantity};
use seamwright_document::Finite;
use seamwright_program::{ArcTime, Outside, Pass, Procedure, Run, Span, SpanValue, Window};

/// A stretch over which every value is continuous: samples in it, and its span.
struct Piece<'a> {
    span: &'a Span,
    places: Vec<f64>,
}

/// The pass between acceleration and deceleration phase, span by span, sampled at the profile's cells.
fn steady(planned: PlannedPass<'_>) -> Vec<Piece<'_>> {
    let PlannedPass { pass, motion, .. } = planned;
    let legs = motion.profile.legs();
    let (Some(first), Some(last)) = (legs.first(), legs.last()) else { return Vec::new() };
    let (from, to) = (first.run_up_end, last.run_down_start);
    let cells =
        (0..motion.profile.cells()).flat_map(|i| [0.0, 0.25, 0.5, 0.75].map(|part| motion.profile.in_cell(i, part).s));
    let places: Vec<f64> = cells.collect();
    let pieces = pass.spans.iter().filter_map(|span| {
        let (from, to) = (from.max(span.from_mm.get()), to.min(span.to_mm.get()));
        let inside = places.iter().copied().filter(|s| *s > from && *s < to);
        let mut places: Vec<f64> = std::iter::once(from).chain(inside).chain([to]).collect();
        places.dedup();
        (from <= to).then_some(Piece { span, places })
    });
    pieces.collect()
}

fn speed(planned: PlannedPass, s: f64) -> f64 {
    let PlannedPass { machine, motion, .. } = planned;
    motion.profile.speed(s) * motion.path.tip_rate(machine, s)
}

/// Power at path length `s` of a span of `pass`, W; includes the values at the sides of a weave.
fn power(procedure: &Procedure, pass: &Pass, span: &Span, s: f64) -> Option<f64> {
    if pass.weave.as_ref().is_none_or(|weave| weave.at_sides.is_empty()) {
        return procedure.power_w(&span.process, span.part(s));
    }
    let there = |name: &String| {
        Some((name.clone(), SpanValue::Steady(Finite::new(pass.process_at(name, s, ArcTime::TRAVEL)?)?)))
    };
    procedure.power_w(&span.process.keys().filter_map(there).collect(), 0.0)
}

/// Heat input at path length `s` of a span of the pass, kJ/mm; none if the power is unknown.
fn heat_input_at(procedure: &Procedure, planned: PlannedPass, span: &Span, s: f64) -> Option<f64> {
    Some(procedure.heat_input_kj_mm(power(procedure, planned.pass, span, s)?, speed(planned, s)))
}

/// Heat input between acceleration and deceleration phase, by path length.
pub(super) fn heat_input(procedure: &Procedure, planned: PlannedPass) -> Vec<(f64, f64)> {
    let mut curve = Vec::new();
    for Piece { span, places } in steady(planned) {
        let heat = |s: f64| heat_input_at(procedure, planned, span, s);
        curve.extend(places.iter().filter_map(|&s| Some((s, heat(s)?))));
    }
    curve
}

/// All quantities of the pass with a value, a window, or both.
pub(super) fn quantities(
    procedure: &Procedure,
    run: Option<&Run>,
    planned: PlannedPass,
    lies: &[Lie],
) -> Vec<Quantity> {
    let mut all = process_values(run, planned.pass);
    let window = |of: fn(&Run) -> Option<Window>| run.and_then(of);
    let steady = steady(planned);
    all.push(quantity("speed_mm_s", window(|r| r.speed_mm_s), &steady, |_, s| Some(speed(planned, s))));
    all.push(quantity("heat_input_kj_mm", window(|r| r.heat_input_kj_mm), &steady, |span, s| {
        heat_input_at(procedure, planned, span, s)
    }));
    let Some(span) = planned.pass.spans.first() else { return all };
    let whole = [Piece { span, places: lies.iter().map(|lie| lie.s).collect() }];
    let at = |s: f64| inclination::at(planned, s);
    all.push(quantity("travel_angle_deg", window(|r| r.travel_angle_deg), &whole, |_, s| Some(at(s).travel)));
    all.push(quantity("work_angle_deg", window(|r| r.work_angle_deg), &whole, |_, s| at(s).work));
    let stick_out = planned.pass.torch.stick_out_or(planned.machine.stick_out_mm);
    let allowed = window(|r| r.stick_out_mm);
    if stick_out.is_some() || allowed.is_some() {
        all.push(quantity("stick_out_mm", allowed, &whole, |_, _| stick_out));
    }
    for (key, allowed) in [("preheat_c", window(|r| r.preheat_c)), ("interpass_c", window(|r| r.interpass_c))] {
        let measured =
            |allowed| Quantity { key: key.to_owned(), found: None, allowed: Some(allowed), outside: Vec::new() };
        all.extend(allowed.map(measured));
    }
    all
}

/// The pass's process values, and those that only the procedure has. They are linear in each span, so its ends suffice.
fn process_values(run: Option<&Run>, pass: &Pass) -> Vec<Quantity> {
    let pieces: Vec<Piece> =
        pass.spans.iter().map(|span| Piece { span, places: vec![span.from_mm.get(), span.to_mm.get()] }).collect();
    let window = |name: &String| run.and_then(|r| r.ranges.get(name)).copied();
    let has = |name: &String| pass.spans.first().is_some_and(|span| span.process.contains_key(name));
    let lacking = run.iter().flat_map(|r| r.ranges.keys()).filter(|name| !has(name));
    let names = pass.spans.first().into_iter().flat_map(|span| span.process.keys()).chain(lacking);
    names
        .map(|name| {
            let middle = quantity(name, window(name), &pieces, |span, s| {
                let (from, to) = (span.from_mm.get(), span.to_mm.get());
                span.process.get(name).map(|value| value.at((s - from) / (to - from)))
            });
            // Values between the middle of a weave and its sides lie between those of both.
            match pass.weave.as_ref().and_then(|weave| weave.at_sides.get(name)) {
                Some(side) => {
                    both(middle, quantity(name, window(name), &pieces, |span, s| Some(side.at(span.part(s)))))
                }
                None => middle,
            }
        })
        .collect()
}

fn both(a: Quantity, b: Quantity) -> Quantity {
    let found = a.found.zip(b.found).map(|(a, b)| (a.0.min(b.0), a.1.max(b.1)));
    Quantity { found, outside: joined(a.outside.into_iter().chain(b.outside).collect()), ..a }
}

/// A quantity over `pieces`, whose value in a span at a path length is `value`.
fn quantity(
    key: &str,
    allowed: Option<Window>,
    pieces: &[Piece],
    value: impl Fn(&Span, f64) -> Option<f64>,
) -> Quantity {
    let mut found: Option<(f64, f64)> = None;
    let mut outside = Vec::new();
    for Piece { span, places } in pieces {
        let values: Option<Vec<f64>> = places.iter().map(|&s| value(span, s)).collect();
        let Some(values) = values else {
            return Quantity { key: key.to_owned(), found: None, allowed, outside: Vec::new() };
        };
        for v in values {
            found = Some(found.map_or((v, v), |(least, greatest)| (v.min(least), v.max(greatest))));
        }
        // A value known at the samples is also known between them.
        outside.extend(allowed.into_iter().flat_map(|w| w.outside(places, |s| value(span, s).unwrap_or(f64::NAN))));
    }
    Quantity { key: key.to_owned(), found, allowed, outside: joined(outside) }
}

/// Joins stretches on the same side that continue from one span into the next; in the order of path length.
fn joined(mut stretches: Vec<Outside>) -> Vec<Outside> {
    stretches.sort_by(|a, b| a.above.cmp(&b.above).then(a.from_mm.total_cmp(&b.from_mm)));
    let mut all: Vec<Outside> = Vec::new();
    for next in stretches {
        match all.last_mut().filter(|last| last.above == next.above && next.from_mm <= last.to_mm) {
            Some(last) => {
                last.to_mm = next.to_mm;
                if (next.found > last.found) == last.above {
                    (last.found, last.at_mm) = (next.found, next.at_mm);
                }
            }
            None => all.push(next),
        }
    }
    all.sort_by(|a, b| a.from_mm.total_cmp(&b.from_mm));
    all
}
