//! Events of a pass whose ways are reordered: outputs stay on over the same ways.

use super::draft::EventDraft;
use crate::points::PointEvent;

/// Output that an event switches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Switch {
    Gas,
    Wire,
    Output(u16),
}

/// Output that an event switches, and whether to on.
fn switched(event: &PointEvent) -> Option<(Switch, bool)> {
    let gas = event.gas.map(|on| (Switch::Gas, on));
    let wire = event.wire.map(|on| (Switch::Wire, on));
    gas.or(wire).or(event.output.zip(event.on).map(|(number, on)| (Switch::Output(number), on)))
}

fn event(switch: Switch, after: usize, on: bool) -> PointEvent {
    let event = PointEvent { after, gas: None, wire: None, output: None, on: None, message: None, call: None };
    match switch {
        Switch::Gas => PointEvent { gas: Some(on), ..event },
        Switch::Wire => PointEvent { wire: Some(on), ..event },
        Switch::Output(number) => PointEvent { output: Some(number), on: Some(on), ..event },
    }
}

/// The events when way `i` of the new order (from 0) is way `old_way(i)` of the `count` old ones and point `after`
/// becomes `new_point(after)`. Outputs count as off until they are switched; those that were off at the end are off in
/// the new order.
pub(super) fn reordered(
    events: &[EventDraft],
    count: usize,
    old_way: impl Fn(usize) -> usize,
    new_point: impl Fn(usize) -> usize,
) -> Vec<EventDraft> {
    let turns_round = new_point(0) > new_point(count);
    let mut switches: Vec<Switch> = Vec::new();
    let mut out: Vec<EventDraft> = Vec::new();
    for draft in events {
        match switched(&draft.event) {
            Some((switch, _)) if !switches.contains(&switch) => switches.push(switch),
            Some(_) => {}
            None => {
                let event = PointEvent { after: new_point(draft.event.after), ..draft.event.clone() };
                out.push(EventDraft { event, from: draft.from });
            }
        }
    }
    if turns_round {
        out.reverse();
    }
    for switch in switches {
        let mut own: Vec<(&EventDraft, bool)> =
            events.iter().filter_map(|e| Some((e, switched(&e.event).filter(|(s, _)| *s == switch)?.1))).collect();
        own.sort_by_key(|(draft, _)| draft.event.after);
        let steps: Vec<(usize, bool)> = own.iter().map(|(draft, on)| (draft.event.after, *on)).collect();
        let mut origins: Vec<Option<usize>> = own.iter().map(|(draft, _)| draft.from).collect();
        if turns_round {
            origins.reverse();
        }
        let new = new_steps(&steps, count, &old_way);
        let origins = origins.into_iter().chain(std::iter::repeat(None));
        out.extend(
            new.into_iter().zip(origins).map(|((at, on), from)| EventDraft { event: event(switch, at, on), from }),
        );
    }
    out.sort_by_key(|draft| draft.event.after);
    out
}

/// Numbers of points after which an output goes on and off in the new order, from those of the old one; in order of
/// points.
fn new_steps(steps: &[(usize, bool)], count: usize, old_way: impl Fn(usize) -> usize) -> Vec<(usize, bool)> {
    let state = |way: usize| steps.iter().rev().find(|(after, _)| *after <= way).is_some_and(|(_, on)| *on);
    let said_at_start = steps.first().is_some_and(|(after, _)| *after == 0);
    let last = steps.last().filter(|(after, on)| *after == count || !on).map(|(_, on)| *on);
    let (mut out, mut now) = (Vec::new(), false);
    for i in 0..count {
        let on = state(old_way(i));
        if on != now || (i == 0 && said_at_start) {
            out.push((i, on));
            now = on;
        }
    }
    out.extend(last.filter(|on| *on != now).map(|on| (count, on)));
    out
}
