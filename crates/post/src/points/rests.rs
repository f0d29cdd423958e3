use seamwright_document::{NonNegative, Positive};
use seamwright_program::{Sequence, Slope};

/// Times in which nothing moves, in order: whether the arc is on, how long, and the process values.
#[derive(Debug, Clone, Default)]
pub(super) struct Rests {
    all: Vec<(bool, f64, Vec<f64>)>,
    taken: bool,
}

/// The rests at the end of a pass.
#[derive(Debug, Clone, Default)]
pub(super) struct End {
    burning: Vec<(f64, Vec<f64>)>,
    after_s: f64,
}

impl Rests {
    pub(super) fn add(&mut self, arc: bool, seconds: f64, values: Vec<f64>) {
        self.all.push((arc, seconds, values));
    }

    pub(super) fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Whether the last pass took any.
    pub(super) fn was_taken(&self) -> bool {
        self.taken
    }

    /// Takes those that end a pass with the arc on: while it burns on, and after it has gone off. A pass without the arc
    /// leaves all to the next.
    pub(super) fn take_end(&mut self, arc: bool) -> End {
        self.taken = false;
        if !arc {
            return End::default();
        }
        let burning = self.all.iter().take_while(|rest| rest.0).count();
        let off = self.all[burning..].iter().take_while(|rest| !rest.0).count();
        let mut all = self.all.drain(..burning + off);
        let burning: Vec<(f64, Vec<f64>)> = all.by_ref().take(burning).map(|(_, s, values)| (s, values)).collect();
        let end = End { burning, after_s: all.map(|rest| rest.1).sum() };
        self.taken = !end.burning.is_empty() || end.after_s > 0.0;
        end
    }

    /// The sequence of a pass that begins with these rests and ends with `end`; `names` are those of the process values,
    /// `first` and `last` their values when it begins to travel and when it ends.
    pub(super) fn sequence(&self, names: &[String], (first, last): (&[f64], &[f64]), end: &End) -> Sequence {
        let burning: Vec<(f64, Vec<f64>)> =
            self.all.iter().filter(|rest| rest.0).map(|(_, seconds, values)| (*seconds, values.clone())).collect();
        let sum = |rests: &[(f64, Vec<f64>)]| seconds(rests.iter().map(|rest| rest.0).sum());
        let preflow_s = seconds(self.all.iter().filter(|rest| !rest.0).map(|rest| rest.1).sum());
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

/// The slope whose steps these rests are: from the outer end to the weld, where values are `weld`. Steps have the values
/// of their middles.
fn slope(names: &[String], rests: &[(f64, Vec<f64>)], weld: &[f64]) -> Option<Slope> {
    let differs = |values: &[f64]| values.iter().zip(weld).any(|(a, b)| (a - b).abs() > 1e-9);
    let last = rests.iter().rposition(|(_, values)| differs(values))?;
    let time: f64 = rests[..=last].iter().map(|rest| rest.0).sum();
    let part = 0.5 * rests[0].0 / time;
    let outer = |(value, weld): (&f64, &f64)| if part < 0.5 { (value - part * weld) / (1.0 - part) } else { *value };
    let values = rests[0].1.iter().zip(weld).map(outer);
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
            rests.add(false, 0.7, vec![0.0]);
            let step = time / f64::from(steps);
            for i in 0..steps {
                let part = (f64::from(i) + 0.5) / f64::from(steps);
                rests.add(true, step, vec![from + part * (weld - from)]);
            }
            rests.add(true, 0.3, vec![weld]);
            let sequence = rests.sequence(&names, (&[weld], &[weld]), &End::default());
            let slope = sequence.upslope.unwrap();
            assert!((sequence.preflow_s.get() - 0.7).abs() < 1e-12);
            assert!((sequence.travel_delay_s.get() - time - 0.3).abs() < 1e-12);
            assert!((slope.time_s.get() - time).abs() < 1e-12);
            assert!((slope.process["current_a"].get() - from).abs() < 1e-9);
        }
    }
}
