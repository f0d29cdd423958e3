//! debug
use glam::DVec2;
use seamwright_cell::eyes::stripe::*;
use seamwright_vision::Image;
use seamwright_vision::stripe::*;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let level = args.get(1).map_or("usual", String::as_str);
    let how = match level {
        "clean" => StripeDisturbances::CLEAN,
        "rough" => StripeDisturbances::ROUGH,
        "holed" => StripeDisturbances::HOLED,
        _ => StripeDisturbances::USUAL,
    };
    let n: u64 = args.get(2).map_or(10, |s| s.parse().unwrap());
    let verbose = args.get(3).is_some();
    let mut reader = StripeReader::new();
    if level == "nowhere" {
        for peak in [0.0, 420.0] {
            let scene = stripe_scene(Section::Plate, n);
            let h = StripeDisturbances { peak, ghosts: if peak > 0.0 { 3 } else { 0 }, ..StripeDisturbances::ROUGH };
            let image = scene.image(&h, n);
            let Image::U8 { width, height, pixels } = &image.image else { panic!() };
            std::fs::write(
                format!("/tmp/stripe_now_{peak}.pgm"),
                [format!("P5\n{width} {height}\n255\n").as_bytes(), pixels].concat(),
            )
            .unwrap();
            let r = reader.read_image(
                &image.image.frame().unwrap(),
                Some(&scene.to_mm),
                &StripeTask::in_mm(JointKind::Fillet),
            );
            println!(
                "{peak} {r:?} {:?} chain {}",
                reader
                    .segments()
                    .iter()
                    .map(|s| (
                        s.columns_dbg(),
                        s.line.along.y.atan2(s.line.along.x).to_degrees().round(),
                        (s.deviation * 1000.0).round()
                    ))
                    .collect::<Vec<_>>(),
                reader.chain().len()
            );
        }
        for (seed, section, f) in confident_nowhere(n) {
            println!("{seed} {:?} in {section:?}: {:.2} {:?} {:?}", f.kind, f.confidence, f.points, f.values);
        }
        return;
    }
    for kind in JointKind::ALL {
        let (mut sum, mut worst, mut count, mut conf, mut none, mut wrong) = (0.0, 0.0f64, 0.0, 0.0, 0, 0);
        let mut gaps: Vec<f64> = Vec::new();
        let mut centre = (0.0, 0.0);
        for seed in 0..n {
            let section = Section::random(kind, seed);
            let scene = stripe_scene(section, seed);
            let image = scene.image(&how, seed);
            if std::env::var("DUMP").is_ok() {
                if let Image::U8 { width, height, pixels } = &image.image {
                    let mut out = format!("P5\n{width} {height}\n255\n").into_bytes();
                    out.extend(pixels);
                    std::fs::write(
                        format!("/tmp/stripe_{}_{}_{}.pgm", level, format!("{kind:?}").to_lowercase(), seed),
                        out,
                    )
                    .unwrap();
                }
            }
            let frame = image.image.frame().unwrap();
            let t = std::time::Instant::now();
            let mut task = StripeTask::in_mm(kind);
            if let Section::Lap { thickness, .. } = section {
                task = task.with_thickness(thickness);
            }
            let r = reader.read_image(&frame, Some(&scene.to_mm), &task);
            let us = t.elapsed().as_micros();
            if std::env::var("ROWS").is_ok_and(|v| v == format!("{kind:?}{seed}")) {
                for c in 0..1024 {
                    let p = reader.chain().iter().find(|p| p.at.x as usize == c);
                    println!("{c} truth {:?} chain {:?}", image.rows[c], p.map(|p| (p.at.y, p.strength, p.width)));
                }
            }
            for p in reader.chain() {
                if let Some(row) = image.rows[p.at.x as usize] {
                    let d = p.at.y - row;
                    if d.abs() < 5.0 {
                        centre.0 += d * d;
                        centre.1 += 1.0;
                    }
                }
            }
            let truth = image.truth.joint().unwrap();
            match r {
                Ok(f) => {
                    let e = f.joint().distance(truth);
                    if f.is_confident() {
                        conf += 1.0;
                        sum += e * e;
                        worst = worst.max(e);
                        count += 1.0;
                        if e > 0.3 {
                            wrong += 1;
                        }
                    }
                    if let (Some(g), Some(t)) =
                        (f.value(Quantity::Gap), image.truth.values.iter().find(|v| v.0 == Quantity::Gap))
                    {
                        if f.is_confident() {
                            gaps.push((g - t.1).abs());
                        }
                    }
                    if verbose || (e > 0.1 && f.is_confident()) {
                        println!(
                            "SEGS {:?}",
                            reader
                                .segments()
                                .iter()
                                .map(|s| (
                                    s.columns_dbg(),
                                    s.line.along.y.atan2(s.line.along.x).to_degrees().round(),
                                    (s.deviation * 1000.0).round()
                                ))
                                .collect::<Vec<_>>()
                        );
                        println!(
                            "{kind:?} {seed} e={e:.3} conf={:.2} {us} us segs={} {:?}",
                            f.confidence,
                            reader.segments().len(),
                            section
                        );
                        for (q, v) in &f.values {
                            let t = image.truth.values.iter().find(|x| x.0 == *q);
                            print!("  {} {v:.3} ({:?})", q.name(), t.map(|t| (t.1 * 1000.0).round() / 1000.0));
                        }
                        println!();
                        for (q, v) in &f.points {
                            let t = image.truth.points.iter().find(|x| x.0 == *q);
                            print!("  {} {v:.3} ({:?})", q.name(), t.map(|t| (t.1 * 1000.0).round() / 1000.0));
                        }
                        println!();
                    }
                }
                Err(e) => {
                    none += 1;
                    if verbose {
                        println!(
                            "{kind:?} {seed} {e} {us} us segs {:?} {:?}",
                            reader
                                .segments()
                                .iter()
                                .map(|s| (
                                    s.columns_dbg(),
                                    s.line.along.y.atan2(s.line.along.x).to_degrees().round(),
                                    (s.deviation * 1000.0).round()
                                ))
                                .collect::<Vec<_>>(),
                            section
                        );
                    }
                }
            }
        }
        gaps.sort_by(f64::total_cmp);
        let g = |p: f64| gaps.get(((gaps.len() as f64 - 1.0) * p) as usize).copied().unwrap_or(0.0);
        println!(
            "{kind:?}: rms {:.4} worst {:.3} confident {}/{n} none {none} wrong {wrong}; gap p50 {:.3} p95 {:.3} max {:.3}; centre rms {:.3}",
            (sum / count as f64).sqrt(),
            worst,
            conf,
            g(0.5),
            g(0.95),
            g(1.0),
            (centre.0 / centre.1 as f64).sqrt()
        );
    }
}
