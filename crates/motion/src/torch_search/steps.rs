//! Steps of a change along the pass, chosen by dynamic programming.

use super::STEP_DEG;

/// Maximum turn over the usual distance of stations, degrees.
pub(super) const MAX_TURN_DEG: f64 = 10.0;
/// Cost of turning beside that of the change itself: ten stations take up a change of 25 degrees at equal costs.
const TURNING: f64 = 8.0;
/// Part of a step by which a limit lies on one.
const SAME_STEP: f64 = 1e-6;

/// Multiples of a step from 0 up to `limit`, and the limit itself.
pub(super) fn multiples(step: f64, limit: f64) -> Vec<f64> {
    let count = (limit / step + SAME_STEP).floor();
    let rest = (limit - count * step > SAME_STEP * step).then_some(limit);
    (0..=count as u32).map(|k| f64::from(k) * step).chain(rest).collect()
}

/// Changes in both senses, increasing, of those from 0 on.
pub(super) fn both_senses(changes: &[f64]) -> Vec<f64> {
    changes.iter().skip(1).rev().map(|change| -change).chain(changes.iter().copied()).collect()
}

/// Stations and the changes among which one is chosen at each of them.
pub(super) struct Walk<'a> {
    /// Path lengths of the stations, mm.
    pub(super) places: &'a [f64],
    /// Length after which the walk ends in the change with which it began, mm.
    pub(super) turn: Option<f64>,
    /// Usual distance of stations, mm.
    pub(super) spacing: f64,
    /// The changes, rad.
    pub(super) works: &'a [f64],
}

impl Walk<'_> {
    /// Changes by station whose margins are at least `more`: small ones that turn slowly.
    ///
    /// Errors: the index of a station to which no open change leads.
    pub(super) fn cheapest(&self, margins: &[Vec<f64>], more: f64) -> Result<Vec<f64>, usize> {
        let order: Vec<usize> = (0..self.places.len()).collect();
        let open = self.through(margins, more, &order, None)?;
        if self.turn.is_none() {
            return Ok(open.into_iter().map(|k| self.works[k]).collect());
        }
        // All round: from the middle of the open solution once round, and back to the same change.
        let half = order.len() / 2;
        let round: Vec<usize> = (0..=order.len()).map(|i| (half + i) % order.len()).collect();
        let closed = self.through(margins, more, &round, Some(open[half]))?;
        let mut works = vec![0.0; order.len()];
        round.iter().zip(closed).for_each(|(i, k)| works[*i] = self.works[k]);
        Ok(works)
    }

    /// The way from one station to the next, as a multiple of the usual one.
    fn way(&self, from: usize, to: usize) -> f64 {
        let way = self.places[to] - self.places[from];
        let way = if way <= 0.0 { way + self.turn.unwrap_or(0.0) } else { way };
        (way / self.spacing).max(SAME_STEP)
    }

    /// The cheapest steps through the stations in `order`; with `end` it starts and ends there.
    fn through(
        &self,
        margins: &[Vec<f64>],
        more: f64,
        order: &[usize],
        end: Option<usize>,
    ) -> Result<Vec<usize>, usize> {
        let count = self.works.len();
        let own = |place: usize, at: usize, k: usize| {
            let is_end = place == 0 || place + 1 == order.len();
            let open = margins[at][k] >= more && end.is_none_or(|end| !is_end || end == k);
            if open { self.works[k] * self.works[k] } else { f64::INFINITY }
        };
        let mut costs: Vec<f64> = (0..count).map(|k| own(0, order[0], k)).collect();
        let mut from: Vec<Vec<usize>> = Vec::with_capacity(order.len());
        for (place, &at) in order.iter().enumerate().skip(1) {
            let way = self.way(order[place - 1], at);
            let reach = (MAX_TURN_DEG / STEP_DEG * way + SAME_STEP) as usize;
            let mut next = vec![f64::INFINITY; count];
            let mut came = vec![0; count];
            for k in 0..count {
                let first = k.saturating_sub(reach);
                for (j, before) in costs.iter().enumerate().take(k + reach + 1).skip(first) {
                    let turn = self.works[k] - self.works[j];
                    let cost = before + TURNING * turn * turn / way + own(place, at, k);
                    if cost < next[k] {
                        (next[k], came[k]) = (cost, j);
                    }
                }
            }
            if next.iter().all(|cost| cost.is_infinite()) {
                return Err(at);
            }
            costs = next;
            from.push(came);
        }
        let last = (0..count).min_by(|a, b| costs[*a].total_cmp(&costs[*b])).unwrap_or(0);
        if costs[last].is_infinite() {
            return Err(order[0]);
        }
        let mut steps = vec![last];
        for came in from.iter().rev() {
            steps.push(came[steps[steps.len() - 1]]);
        }
        steps.reverse();
        Ok(steps)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::{Random, cases};

    #[test]
    fn limits_are_tried_too() {
        let near = |found: Vec<f64>, wanted: &[f64]| {
            assert!(found.len() == wanted.len() && found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-12));
        };
        near(multiples(2.5, 0.0), &[0.0]);
        near(multiples(2.5, 2.0), &[0.0, 2.0]);
        near(multiples(2.5, 5.0), &[0.0, 2.5, 5.0]);
        near(both_senses(&multiples(2.5, 6.0)), &[-6.0, -5.0, -2.5, 0.0, 2.5, 5.0, 6.0]);
    }

    /// All ways through few stations, and the cheapest of them.
    #[test]
    fn the_walk_is_the_cheapest_of_all() {
        let mut random = Random::new(19);
        let works = both_senses(&multiples(STEP_DEG, 10.0));
        for _ in 0..cases(60) {
            let count = 5;
            let mut places: Vec<f64> = (0..count).map(|_| random.within(0.0, 40.0)).collect();
            places.sort_by(f64::total_cmp);
            let margins: Vec<Vec<f64>> =
                (0..count).map(|_| works.iter().map(|_| random.within(-1.0, 1.0)).collect()).collect();
            let walk = Walk { places: &places, turn: None, spacing: 8.0, works: &works };
            let found = walk.cheapest(&margins, 0.1);
            let cost = |way: &[usize]| -> f64 {
                let own = |i: usize| if margins[i][way[i]] >= 0.1 { works[way[i]].powi(2) } else { f64::INFINITY };
                let turn = |i: usize| {
                    let part = (places[i + 1] - places[i]) / 8.0;
                    let steps = way[i + 1].abs_diff(way[i]) as f64;
                    let by = works[way[i + 1]] - works[way[i]];
                    if steps > (4.0 * part + 1e-6).floor() { f64::INFINITY } else { TURNING * by * by / part }
                };
                (0..count).map(own).sum::<f64>() + (0..count - 1).map(turn).sum::<f64>()
            };
            let n = works.len();
            let all = (0..n.pow(5)).map(|code| [0u32, 1, 2, 3, 4].map(|i| code / n.pow(i) % n));
            let best = all.map(|way| cost(&way)).fold(f64::INFINITY, f64::min);
            match found {
                Err(_) => assert!(best.is_infinite(), "{best}"),
                Ok(found) => {
                    let way: Vec<usize> =
                        found.iter().map(|work| works.iter().position(|w| (w - work).abs() < 1e-12).unwrap()).collect();
                    assert!((cost(&way) - best).abs() < 1e-9, "{} {best}", cost(&way));
                }
            }
        }
    }
}
