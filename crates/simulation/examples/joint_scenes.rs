//! Simulated frames with their truth and our detections, for `peers/vision.py`:
//! `cargo run --release -p seamwright-simulation --example joint_scenes DIRECTORY FRAMES`.

#![allow(missing_docs)]
use seamwright_simulation::camera_simulator::scene::{Kind, scene};
use seamwright_vision::Image;
use seamwright_vision::joint::{CONFIDENT, Follower, Options, State};
use seamwright_vision::region_growing::grow;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let usage = "arguments: DIRECTORY FRAMES";
    let directory = PathBuf::from(arguments.next().ok_or(usage)?);
    let frames: u64 = arguments.next().ok_or(usage)?.parse()?;
    let mut follower = Follower::new(Options::default());
    for kind in Kind::ALL.into_iter().filter(|k| !matches!(k, Kind::Blank | Kind::OnlyScratches)) {
        for seed in 0..frames {
            let scene = scene(kind, seed, 512);
            let frame = scene.image.frame()?;
            let begun = Instant::now();
            let joint = follower.follow(&frame, &scene.start);
            let ours_ms = begun.elapsed().as_secs_f64() * 1e3;
            let begun = Instant::now();
            let growth = grow(&frame, [scene.start.x, scene.start.y], scene.start.direction);
            let growth_ms = begun.elapsed().as_secs_f64() * 1e3;
            let mut text = format!("start {} {} {}\n", scene.start.x, scene.start.y, scene.start.direction);
            writeln!(text, "width {}\nms {ours_ms} {growth_ms}", scene.truth.width)?;
            for (at, radius) in &scene.truth.tacks {
                writeln!(text, "tack {} {} {radius}", at.x, at.y)?;
            }
            for p in &scene.truth.midline {
                writeln!(text, "truth {} {}", p.x, p.y)?;
            }
            for r in joint.rows.iter().filter(|r| r.state == State::Seen) {
                writeln!(text, "ours {} {} {}", r.x, r.y, u8::from(r.confidence >= CONFIDENT))?;
            }
            for [x, y] in growth.midline {
                writeln!(text, "growth {x} {y}")?;
            }
            let name = format!("{}-{seed}", kind.name());
            fs::write(directory.join(format!("{name}.txt")), text)?;
            if let Image::U8 { width, height, pixels } = &scene.image {
                let head = format!("P5 {width} {height} 255\n");
                fs::write(directory.join(format!("{name}.pgm")), [head.as_bytes(), pixels].concat())?;
            }
        }
    }
    Ok(())
}
