use crate::curves::{Saddle, Spline};
use seamwright_motion::law::{Channels, SpeedLaw};
use std::time::Instant;

/// Greatest use of speeds, accelerations, jerks at many instants.
pub fn use_of_limits(path: &dyn Channels, law: &SpeedLaw, count: usize) -> [f64; 3] {
    let mut worst = [0.0f64; 3];
    let mut d = vec![[0.0; 3]; path.limits().len()];
    let mut cursor = 0;
    for i in 0..=count {
        let p = law.at(law.duration() * i as f64 / count as f64, &mut cursor);
        path.derivatives(p.s, false, &mut d);
        for ([q1, q2, q3], l) in d.iter().zip(path.limits()) {
            let used = [
                q1 * p.v / l.speed,
                (q2 * p.v * p.v + q1 * p.a) / l.acceleration,
                (q3 * p.v.powi(3) + 3.0 * q2 * p.v * p.a + q1 * p.j) / l.jerk,
            ];
            (0..3).for_each(|k| worst[k] = worst[k].max(used[k].abs()));
        }
    }
    worst
}

#[test]
fn try_it() {
    for jerk in [10.0, 1.5] {
        let saddle = Saddle::new(jerk);
        let t = Instant::now();
        let law = SpeedLaw::new(&saddle);
        println!("saddle {} {:?} {:?}", law.duration(), t.elapsed(), use_of_limits(&saddle, &law, 200_000));
        for (spline, t0) in Spline::reference(jerk) {
            let t = Instant::now();
            let law = SpeedLaw::new(&spline);
            println!(
                "{} {} {t0} {:?} {:?}",
                spline.limits.len(),
                law.duration(),
                t.elapsed(),
                use_of_limits(&spline, &law, 200_000)
            );
        }
    }
}
