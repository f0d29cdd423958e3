//! Distance that a torch can go back before a pass so that its sensors see the start.

use seamwright_clearance::Limits;
use seamwright_machine::{Course, Joints, MAX_AXES, Surroundings};
use seamwright_message::Message;

/// Distance between checked positions of the way, mm.
pub(super) const STEP_MM: f64 = 0.5;

/// The way back from the start of a pass: equidistant positions of the axes, from the start on.
pub(super) struct Retreat {
    pub(super) step_mm: f64,
    /// Positions of the axes, at least that of the start.
    pub(super) places: Vec<Joints>,
}

impl Retreat {
    /// Returns its length, mm.
    pub(super) fn way_mm(&self) -> f64 {
        self.step_mm * (self.places.len() - 1) as f64
    }

    /// Returns the length of the way without collisions, mm, and the pair that comes too near beyond it.
    pub(super) fn clear_mm(&self, around: &Surroundings<'_>) -> (f64, Option<Message>) {
        let whole = self.way_mm();
        if around.is_empty() || whole <= 0.0 {
            return (whole, None);
        }
        let limits =
            Limits { cutoff_mm: around.greatest_least_mm() + 1.0, precision_mm: 0.2, smallest: 1e-3 * self.step_mm };
        let stretches = match around.along(self, self.places.len(), &limits) {
            Ok(profile) => profile.stretches,
            // A failed check counts as not clear.
            Err(error) => return (0.0, Some(error.message())),
        };
        stretches.into_iter().min_by(|a, b| a.from.total_cmp(&b.from)).map_or((whole, None), |stretch| {
            let (a, b) = around.nearest_bodies(stretch.watch, &stretch.nearest);
            (stretch.from.max(0.0), Some(Message::new("cell-too-close").message("a", a).message("b", b)))
        })
    }

    fn between(&self, s: f64) -> (usize, f64) {
        let place = (s / self.step_mm).clamp(0.0, (self.places.len() - 1) as f64);
        let i = (place as usize).min(self.places.len().saturating_sub(2));
        (i, place - i as f64)
    }
}

impl Course for Retreat {
    fn range(&self) -> (f64, f64) {
        (0.0, self.way_mm())
    }

    fn at(&self, s: f64) -> Joints {
        let (i, part) = self.between(s);
        let (a, b) = (&self.places[i], &self.places[(i + 1).min(self.places.len() - 1)]);
        std::array::from_fn(|k| a[k] + part * (b[k] - a[k]))
    }

    fn greatest_rates(&self, from: f64, to: f64) -> Joints {
        let (first, last) = (self.between(from).0, self.between(to).0);
        let mut most = [0.0; MAX_AXES];
        for pair in self.places[first..].windows(2).take(last - first + 1) {
            for k in 0..MAX_AXES {
                most[k] = f64::max(most[k], (pair[1][k] - pair[0][k]).abs() / self.step_mm);
            }
        }
        most
    }
}
