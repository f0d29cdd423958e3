//! Profiles from a sliding window against the profile of the whole path.

use super::curves::{Saddle, Spline};
use seamwright_machine::AxisLimits;
use seamwright_motion::speed_profile::{Channels, Feed, ProfilePoint, ProfileStream, SpeedProfile};

/// A path repeated, known only over a window.
struct Window<P> {
    path: P,
    whole: (f64, f64),
    loaded: (f64, f64),
}

impl<P: Channels> Window<P> {
    fn new(path: P) -> Self {
        let whole = path.range();
        Self { path, whole, loaded: (whole.0, whole.0) }
    }
}

impl<P: Channels> Channels for Window<P> {
    fn range(&self) -> (f64, f64) {
        self.loaded
    }
    fn limits(&self) -> &[AxisLimits] {
        self.path.limits()
    }
    fn derivatives(&self, u: f64, before: bool, out: &mut [[f64; 3]]) -> f64 {
        assert!(u >= self.loaded.0 - 1e-9 && u <= self.loaded.1 + 1e-9, "{u} is not in {:?}", self.loaded);
        self.path.derivatives(u, before, out)
    }
    fn asked(&self, u: f64) -> f64 {
        self.path.asked(u)
    }
    fn breaks(&self) -> Vec<f64> {
        self.path.breaks().into_iter().filter(|b| *b > self.loaded.0 && *b < self.loaded.1).collect()
    }
}

impl<P: Channels> Feed for Window<P> {
    fn load(&mut self, from: f64, beyond: f64, seconds: f64) {
        let step = (self.whole.1 - self.whole.0) / 2000.0;
        let mut out = vec![[0.0; 3]; self.path.limits().len()];
        let (mut end, mut time) = (beyond, 0.0);
        while end < self.whole.1 && time < seconds {
            let u = (end + 0.5 * step).min(self.whole.1);
            let tip = self.path.derivatives(u, false, &mut out);
            let rates = out.iter().zip(self.path.limits()).map(|(d, l)| d[0].abs() / l.speed);
            time += step * rates.fold(tip / self.path.asked(u), f64::max);
            end = (end + step).min(self.whole.1);
        }
        self.loaded = (from, end.max(self.loaded.1));
    }
    fn is_complete(&self) -> bool {
        self.loaded.1 >= self.whole.1
    }
}

/// Plays a stream to its end at a period; every point is within the limits, and the profile is smooth.
fn play<P: Channels>(path: P, horizon: f64) -> (f64, usize) {
    let mut stream = ProfileStream::new(Window::new(path), horizon).unwrap();
    let mut d = vec![[0.0; 3]; stream.path().limits().len()];
    let period = 1e-3;
    let mut last: Option<ProfilePoint> = None;
    for k in 0.. {
        let Some(p) = stream.at(f64::from(k) * period).unwrap() else { break };
        stream.path().derivatives(p.s, false, &mut d);
        for ([q1, q2, q3], l) in d.iter().zip(stream.path().limits()) {
            let used = [
                q1 * p.v / l.speed,
                (q2 * p.v * p.v + q1 * p.a) / l.acceleration,
                (q3 * p.v.powi(3) + 3.0 * q2 * p.v * p.a + q1 * p.j) / l.jerk,
            ];
            assert!(used.iter().all(|u| u.abs() <= 1.0 + 1e-9), "{k}: {used:?}");
        }
        if let Some(last) = last {
            // The speed is the mean over the period, by Simpson's rule with the accelerations at both ends.
            let mean = 0.5 * (last.v + p.v) + period / 12.0 * (last.a - p.a);
            let jerk = last.j.abs().max(p.j.abs()) + 1e-3;
            assert!((p.s - last.s - mean * period).abs() < 0.5 * period.powi(3) * jerk, "{k} {p:?} {last:?}");
        }
        last = Some(p);
    }
    let end = stream.end();
    assert!((end.s - stream.path().range().1).abs() < 1e-12);
    (stream.duration().unwrap(), stream.stops())
}

#[test]
fn a_sliding_window_gives_the_profile_of_the_whole_path() {
    let whole = SpeedProfile::new(&Saddle::new(10.0)).unwrap().duration();
    for horizon in [2.0, 4.0] {
        let (duration, stops) = play(Saddle::new(10.0), horizon);
        assert!((duration / whole - 1.0).abs() < 1e-3 && stops == 0, "{horizon}: {duration} {whole}");
    }
    for i in 0..6 {
        let path = || Spline::reference(10.0).swap_remove(i).0;
        let whole = SpeedProfile::new(&path()).unwrap().duration();
        let (duration, stops) = play(path(), 6.0);
        assert!((duration / whole - 1.0).abs() < 1e-3 && stops == 0, "{i}: {duration} {whole}");
    }
}

#[test]
fn a_window_too_short_stops_but_never_breaks_a_limit() {
    for i in 0..6 {
        let (duration, _) = play(Spline::reference(2.0).swap_remove(i).0, 0.8);
        assert!(duration.is_finite());
    }
}
