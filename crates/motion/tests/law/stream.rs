//! Laws from a sliding window against the law of the whole path.

use crate::curves::{Saddle, Spline};
use seamwright_motion::law::{Channels, Feed, LawStream, Limits, SpeedLaw};

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
    fn limits(&self) -> &[Limits] {
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

#[test]
fn try_stream() {
    let saddle = Saddle::new(10.0);
    let whole = SpeedLaw::new(&saddle).duration();
    for horizon in [1.5, 3.0] {
        let mut stream = LawStream::new(Window::new(Saddle::new(10.0)), horizon);
        let mut t = 0.0;
        while stream.at(t).is_some() {
            t += 1e-3;
        }
        println!("saddle {horizon}: {:?} {whole} stops {}", stream.duration(), stream.stops());
    }
    for (spline, _) in Spline::reference(10.0) {
        let whole = SpeedLaw::new(&spline).duration();
        for horizon in [12.0, 3.0, 6.0] {
            let copy =
                Spline { knots: spline.knots.clone(), pieces: spline.pieces.clone(), limits: spline.limits.clone() };
            let mut stream = LawStream::new(Window::new(copy), horizon);
            let mut t = 0.0;
            while stream.at(t).is_some() {
                t += 1e-3;
            }
            println!("{horizon}: {:?} {whole} stops {}", stream.duration(), stream.stops());
        }
    }
}
