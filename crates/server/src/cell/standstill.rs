use seamwright_machine::{Joints, MAX_AXES};

/// Time without motion until the axes count as still, s: an axis oscillates briefly after its set-point has come to
/// rest.
const FOR_S: f64 = 0.2;
/// Maximum displacement that counts as no motion: 0.02 mm, 0.02 degrees (rad).
const LINEAR_MM: f64 = 0.02;
const ROTARY: f64 = 3.5e-4;

/// Detects standstill: set-points at rest, and no measured motion for [`FOR_S`].
#[derive(Debug, Default)]
pub(super) struct Stillness {
    /// Start of the standstill, s, and the axis positions.
    since: Option<(f64, Joints)>,
    t: f64,
}

impl Stillness {
    /// Updates from a cycle: whether set-points are at rest, and measured axis positions.
    pub(super) fn cycle(&mut self, t: f64, rests: bool, at: &Joints, rotary: &[bool; MAX_AXES]) {
        self.t = t;
        let limit = |i: usize| if rotary[i] { ROTARY } else { LINEAR_MM };
        let stays = |was: &Joints| (0..MAX_AXES).all(|i| (at[i] - was[i]).abs() <= limit(i));
        let stood = self.since.as_ref().is_some_and(|(since, was)| *since <= t && stays(was));
        self.since = match self.since.take() {
            _ if !rests => None,
            since if stood => since,
            _ => Some((t, *at)),
        };
    }

    pub(super) fn stands(&self) -> bool {
        self.since.is_some_and(|(since, _)| self.t - since >= FOR_S)
    }
}

#[cfg(test)]
mod tests {
    use super::{Joints, MAX_AXES, Stillness};

    const LINEAR: [bool; MAX_AXES] = [false; MAX_AXES];

    fn at(x: f64) -> Joints {
        let mut at = [0.0; MAX_AXES];
        at[0] = x;
        at
    }

    /// Runs cycles of 1 ms from `t` on; returns the standstill after each.
    fn cycles(of: &mut Stillness, t: f64, count: u32, rests: bool, x: impl Fn(u32) -> f64) -> Vec<bool> {
        let cycle = |i: u32| {
            of.cycle(t + 1e-3 * f64::from(i), rests, &at(x(i)), &LINEAR);
            of.stands()
        };
        (0..count).map(cycle).collect()
    }

    #[test]
    fn it_stands_a_moment_after_the_last_motion() {
        let mut of = Stillness::default();
        assert!(!cycles(&mut of, 0.0, 300, false, |_| 5.0).contains(&true), "it is asked to move");
        let told = cycles(&mut of, 0.3, 400, true, |_| 5.0);
        assert!(!told[150] && told[399]);
        // After another motion it is not still at once.
        assert!(!cycles(&mut of, 0.7, 1, false, |_| 5.0)[0]);
    }

    #[test]
    fn an_axis_that_swings_or_is_pushed_does_not_stand() {
        let mut of = Stillness::default();
        // Motion of 10 mm/s without a command.
        assert!(!cycles(&mut of, 0.0, 1000, true, |i| 0.01 * f64::from(i)).contains(&true));
        // Encoder noise.
        let told = cycles(&mut of, 1.0, 500, true, |i| 10.0 + 0.005 * f64::from(i % 2));
        assert!(told[499]);
        // Slow continuous drift.
        let told = cycles(&mut of, 1.5, 2000, true, |i| 10.0 + 1e-4 * f64::from(i));
        assert!(told.contains(&false));
    }

    #[test]
    fn a_cell_that_begins_anew_does_not_stand_yet() {
        let mut of = Stillness::default();
        assert!(cycles(&mut of, 100.0, 400, true, |_| 0.0)[399]);
        assert!(!cycles(&mut of, 0.0, 10, true, |_| 0.0)[9]);
    }
}
