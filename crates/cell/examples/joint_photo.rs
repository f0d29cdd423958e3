#![allow(missing_docs)]
use seamwright_cell::frames::decode;
use seamwright_vision::joint::{Follower, Options, Start};
fn main() {
    let a: Vec<String> = std::env::args().collect();
    let image = decode(&std::fs::read(&a[1]).unwrap()).unwrap();
    let n = |i: usize| a[i].parse::<f32>().unwrap();
    let mut f = Follower::new(Options::default());
    let j = f.follow(&image.frame().unwrap(), &Start { x: n(2), y: n(3), direction: n(4).to_radians(), width: None });
    println!("{:?}", j.end);
    for r in &j.rows {
        println!("{} {} {} {} {:?}", r.x, r.y, r.confidence, r.width, r.state);
    }
}
