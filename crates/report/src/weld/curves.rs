use super::tracking::HeadCurves;
use seamwright_machine::Machine;
use seamwright_simulation::Sample;

/// Number of buckets along the weld; each keeps its minimum and maximum, so that all peaks remain.
const BUCKETS: usize = 1000;

/// Path length (mm) and value.
type Point = (f64, f64);

/// One curve over path length, thinned sample by sample.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Envelope {
    /// Lowest and highest point of each bucket.
    buckets: Vec<Option<(Point, Point)>>,
    length: f64,
}

impl Envelope {
    pub(super) fn new(length: f64) -> Self {
        Self { buckets: vec![None; BUCKETS], length }
    }

    pub(super) fn add(&mut self, s: f64, value: f64) {
        let i = ((s / self.length * BUCKETS as f64) as usize).min(BUCKETS - 1);
        let point = (s, value);
        let (low, high) = self.buckets[i].get_or_insert((point, point));
        if value < low.1 {
            *low = point;
        }
        if value > high.1 {
            *high = point;
        }
    }

    pub(super) fn points(&self) -> Vec<Point> {
        let pairs = self.buckets.iter().flatten();
        pairs.flat_map(|(low, high)| if low.0 <= high.0 { [*low, *high] } else { [*high, *low] }).collect()
    }
}

/// Curves of a simulated weld along the seam, gathered sample by sample in bounded memory; mm, deg, s.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulationCurves {
    /// Following error of each axis.
    pub(super) following: Vec<Envelope>,
    /// Distance of the actual torch tip from the seam.
    pub(super) path_error: Envelope,
    pub(super) tip_speed: Envelope,
    /// Attitude error of the actual torch.
    pub(super) attitude: Envelope,
    pub(super) heads: Vec<HeadCurves>,
    length: f64,
}

impl SimulationCurves {
    /// Creates empty curves for a weld of `length` mm on a machine with `axes` axes.
    pub fn new(axes: usize, length: f64) -> Self {
        let empty = Envelope::new(length);
        Self {
            following: vec![empty.clone(); axes],
            path_error: empty.clone(),
            tip_speed: empty.clone(),
            attitude: empty,
            heads: Vec::new(),
            length,
        }
    }

    /// Adds a sample; ignores samples without torch travel.
    pub fn add(&mut self, machine: &Machine, sample: &Sample) {
        if !sample.travels() {
            return;
        }
        let s = sample.set.profile.s;
        for (i, (curve, axis)) in self.following.iter_mut().zip(&machine.axes).enumerate() {
            curve.add(s, axis.to_file(sample.following_error[i]));
        }
        self.path_error.add(s, sample.path_error);
        self.tip_speed.add(s, sample.tip_speed);
        self.attitude.add(s, sample.attitude_error.to_degrees());
        for (i, head) in sample.heads.iter().enumerate() {
            let Some(head) = head else { continue };
            while self.heads.len() <= i {
                self.heads.push(HeadCurves::new(self.length));
            }
            self.heads[i].add(s, head);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_survive_in_order() {
        let mut e = Envelope::new(100.0);
        for i in 0..1_000_000 {
            let s = f64::from(i) * 1e-4;
            e.add(s, if i == 123_456 { 9.0 } else { (s * 3.0).sin() });
        }
        let points = e.points();
        assert!(points.len() <= 2 * BUCKETS && points.windows(2).all(|w| w[0].0 <= w[1].0));
        assert!(points.iter().any(|p| p.1 > 8.9 && (p.0 - 12.3456).abs() < 1e-9));
    }
}
