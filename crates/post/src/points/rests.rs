use seamwright_document::{NonNegative, Positive};
use seamwright_program::{PointEvent, Sequence, Slope};

/// Something between two moves.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Gap {
    /// Rest without motion: whether the arc is on, the duration, s, and the process values.
    Rest(bool, f64, Vec<f64>),
    Event(PointEvent),
}

/// Gaps between two moves, in order.
#[derive(Debug, Clone, Default)]
pub(super) struct Rests(Vec<Gap>);

/// Gaps at the end of a pass.
#[derive(Debug, Clone, Default)]
pub(super) struct End {
    burning: Vec<(f64, Vec<f64>)>,
    after_s: f64,
    /// Events after its end.
    pub(super) events: Vec<PointEvent>,
}

impl Rests {
    pub(super) fn add(&mut self, gap: Gap) {
        self.0.push(gap);
    }

    pub(super) fn is_rest(&self) -> bool {
        self.0.iter().any(|gap| matches!(gap, Gap::Rest(..)))
    }

    /// Takes the rests with the arc as in the pass whose values are neither those of `stays` nor make a slope from or
    /// to `weld`: a sequence cannot express them. `back` if they end a pass: then only those before anything else.
    pub(super) fn take_odd(&mut self, arc: bool, stays: &[f64], weld: &[f64], back: bool) -> Vec<Gap> {
        let is_on = |gap: &Gap| matches!(gap, Gap::Rest(on, ..) if *on == arc);
        let from = if back { 0 } else { self.0.iter().position(is_on).unwrap_or(self.0.len()) };
        let count = self.0[from..].iter().take_while(|gap| is_on(gap)).count();
        let mut rests: Vec<(f64, Vec<f64>)> = Vec::new();
        for gap in &self.0[from..from + count] {
            if let Gap::Rest(_, seconds, values) = gap {
                rests.push((*seconds, values.clone()));
            }
        }
        if back {
            rests.reverse();
        }
        let changes = rests.iter().any(|(_, values)| values != stays);
        let odd = changes && (!arc || slope(&[], &rests, weld).is_none());
        if odd { self.0.drain(from..from + count).collect() } else { Vec::new() }
    }

    /// Takes the gaps that belong to the pass before: with the arc on, the time that it burns on, the time after it,
    /// and the events then. Takes everything if no pass follows.
    pub(super) fn take_end(&mut self, arc: bool, last: bool) -> End {
        let mut end = End::default();
        let goes_on = |end: &End, gap: &Gap| match gap {
            Gap::Event(_) => true,
            Gap::Rest(true, ..) => arc && end.after_s <= 0.0 && end.events.is_empty(),
            Gap::Rest(false, ..) => arc && end.events.is_empty(),
        };
        let mut taken = 0;
        for gap in &self.0 {
            if !last && !goes_on(&end, gap) {
                break;
            }
            taken += 1;
            match gap {
                Gap::Event(event) => end.events.push(event.clone()),
                Gap::Rest(true, seconds, values) => end.burning.push((*seconds, values.clone())),
                Gap::Rest(false, seconds, _) => end.after_s += seconds,
            }
        }
        self.0.drain(..taken);
        end
    }

    /// Everything, in order.
    pub(super) fn take_all(&mut self) -> Vec<Gap> {
        std::mem::take(&mut self.0)
    }

    /// Takes the events before the next pass out of the gaps.
    pub(super) fn take_events(&mut self) -> Vec<PointEvent> {
        let mut events = Vec::new();
        self.0.retain(|gap| match gap {
            Gap::Event(event) => {
                events.push(event.clone());
                false
            }
            Gap::Rest(..) => true,
        });
        events
    }

    /// The sequence of a pass that starts with these rests and ends with `end`; `names` are those of the process
    /// values, `first` and `last` their values at the start and the end of its travel.
    pub(super) fn sequence(&self, names: &[String], first: &[f64], last: &[f64], end: &End) -> Sequence {
        let of = |on: bool| {
            self.0.iter().filter_map(move |gap| match gap {
                Gap::Rest(arc, seconds, values) if *arc == on => Some((*seconds, values.clone())),
                _ => None,
            })
        };
        let burning: Vec<(f64, Vec<f64>)> = of(true).collect();
        let sum = |rests: &[(f64, Vec<f64>)]| seconds(rests.iter().map(|rest| rest.0).sum());
        let preflow_s = seconds(of(false).map(|rest| rest.0).sum());
        let (travel_delay_s, crater_s) = (sum(&burning), sum(&end.burning));
        let upslope = slope(names, &burning, first);
        // From its end back a downslope is an upslope.
        let backwards: Vec<(f64, Vec<f64>)> = end.burning.iter().rev().cloned().collect();
        let downslope = slope(names, &backwards, last);
        let postflow_s = seconds(end.after_s);
        Sequence { preflow_s, travel_delay_s, crater_s, postflow_s, upslope, downslope, ..Sequence::default() }
    }
}

fn seconds(value: f64) -> NonNegative {
    NonNegative::new(value).unwrap_or_default()
}

/// Maximum deviation of a step from an even slope, as a part of that slope's range.
const EVEN: f64 = 1e-3;

/// The slope whose steps these rests are: from the outer end to the weld, where values are `weld`. Steps have the values
/// of their middles.
fn slope(names: &[String], rests: &[(f64, Vec<f64>)], weld: &[f64]) -> Option<Slope> {
    let differs = |values: &[f64]| values.iter().zip(weld).any(|(a, b)| (a - b).abs() > 1e-9);
    let last = rests.iter().rposition(|(_, values)| differs(values))?;
    // Constant values are no slope: they jump when the torch starts to travel.
    if last == 0 || rests[..=last].windows(2).all(|w| w[0].1 == w[1].1) {
        return None;
    }
    let time: f64 = rests[..=last].iter().map(|rest| rest.0).sum();
    let part = 0.5 * rests[0].0 / time;
    let outer = |(value, weld): (&f64, &f64)| if part < 0.5 { (value - part * weld) / (1.0 - part) } else { *value };
    let values: Vec<f64> = rests[0].1.iter().zip(weld).map(outer).collect();
    let mut begun = 0.0;
    for (seconds, steps) in &rests[..=last] {
        let part = (begun + 0.5 * seconds) / time;
        begun += seconds;
        let off = |(i, step): (usize, &f64)| {
            (step - values[i] - part * (weld[i] - values[i])).abs() > EVEN * (1.0 + (weld[i] - values[i]).abs())
        };
        if steps.iter().enumerate().any(off) {
            return None;
        }
    }
    let values = values.into_iter();
    let process = names.iter().zip(values).filter_map(|(name, v)| Some((name.clone(), NonNegative::new(v.max(0.0))?)));
    Some(Slope { time_s: Positive::new(time)?, process: process.collect() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_of_a_slope_give_it_back() {
        let names = ["current_a".to_owned()];
        for (from, weld, time, steps) in [(20.0, 200.0, 0.5, 10), (150.0, 100.0, 2.0, 50), (0.0, 80.0, 1.0, 3)] {
            let mut rests = Rests::default();
            rests.add(Gap::Rest(false, 0.7, vec![0.0]));
            let step = time / f64::from(steps);
            for i in 0..steps {
                let part = (f64::from(i) + 0.5) / f64::from(steps);
                rests.add(Gap::Rest(true, step, vec![from + part * (weld - from)]));
            }
            rests.add(Gap::Rest(true, 0.3, vec![weld]));
            let sequence = rests.sequence(&names, &[weld], &[weld], &End::default());
            let slope = sequence.upslope.unwrap();
            assert!((sequence.preflow_s.get() - 0.7).abs() < 1e-12);
            assert!((sequence.travel_delay_s.get() - time - 0.3).abs() < 1e-12);
            assert!((slope.time_s.get() - time).abs() < 1e-12);
            assert!((slope.process["current_a"].get() - from).abs() < 1e-9);
        }
    }
}
