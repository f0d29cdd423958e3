//! Every frame that the follower gets wrong, and the gates: `cargo run --release -p seamwright-cell --example joint_gates 50`.

#![allow(missing_docs)]
use seamwright_cell::eyes::{gates::*, scene::*};
use seamwright_vision::joint::*;
fn main() {
    let n: u64 = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(50);
    let mut f = Follower::new(Options::default());
    for kind in Kind::ALL {
        let (mut t, mut bad) = (vec![], String::new());
        for seed in 0..n {
            let s = scene(kind, seed, 512);
            let t0 = std::time::Instant::now();
            let _ = f.follow(&s.image.frame().unwrap(), &s.start);
            t.push(t0.elapsed().as_secs_f64() * 1e3);
            let o = follow(&mut f, &s);
            let wrong = o.errors.iter().filter(|e| e.1 && e.0 > 2.0).count() + o.phantom;
            if wrong > 0 || (!s.truth.midline.is_empty() && o.reach < 0.95) {
                bad += &format!(
                    "  {seed}: wrong {wrong} reach {:.2} {:?} w {:.1} cnr {:.1} tacks {:?}\n",
                    o.reach,
                    o.end,
                    s.truth.width,
                    s.truth.cnr,
                    s.truth.tacks.iter().map(|t| t.1 as i32).collect::<Vec<_>>()
                );
            }
        }
        t.sort_by(f64::total_cmp);
        println!("{} median {:.3} ms max {:.3} ms\n{bad}", kind.name(), t[t.len() / 2], t[t.len() - 1]);
    }
    for g in joint_gates(n, || {}).rows {
        println!(
            "{} | {} | {:.3} | {:?} {} | {}",
            g.frames,
            g.what,
            g.value,
            g.limit,
            g.unit,
            if g.is_kept() { "" } else { "FAIL" }
        );
    }
}
