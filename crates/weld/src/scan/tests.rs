//! Estimates from profiles of true sections against the sections: without noise to the rounding of the sampling, with
//! noise against the stated uncertainties.

use super::{GrooveScan, GrooveScanner, Measured, NoScan, SensorView};
use crate::joint::{Groove, SeamJoint, Section};
use crate::seam::{SeamCurve, SeamPoint};
use glam::DVec2;
use seamwright_document::Document;
use seamwright_program::{Joint, Preparation, Seam, SeamStart};
use seamwright_testkit::{Random, cases};
use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    seam: Seam,
    joint: Joint,
}

/// A joint along a straight seam whose faces are at a dihedral angle, degrees.
fn joint(preparation: &str, dihedral_deg: f64) -> (SeamJoint, SeamPoint) {
    let a = dihedral_deg.to_radians();
    let normal = if dihedral_deg < 180.0 { format!("[0, {}, {}]", -a.sin(), -a.cos()) } else { "[0, 0, 1]".to_owned() };
    let text = format!(
        "[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [200, 0, 0]\nfirst_normal = {normal}\nsecond_normal = [0, 0, 1]\n\
         [joint]\ncap_mm = 1.5\npreparation.{preparation}\n"
    );
    let file = Document::<File>::read("f.toml", &text).unwrap_or_else(|e| panic!("{e}"));
    let seam = SeamCurve::new(&file, &file.value.seam, &SeamStart::default()).unwrap();
    let joint = SeamJoint::new(&file, &file.value.joint, &seam).unwrap_or_else(|e| panic!("{e}"));
    (joint, seam.at(50.0))
}

/// A true part under a sensor.
struct Part {
    joint: SeamJoint,
    at: SeamPoint,
    groove: Groove,
    section: Section,
    /// Depth of flat metal below the line from toe to toe, if any, and the height of waves on it, mm.
    metal: Option<(f64, f64)>,
    /// Pose of the sensor: where the seam is in its frame, and its rotation.
    seam_at: DVec2,
    turn: f64,
    mirrored: bool,
}

impl Part {
    fn random(random: &mut Random, welded: bool) -> Self {
        let t = random.within(8.0, 20.0);
        let gap = random.within(1.0, 3.0);
        let face = random.within(0.5, 2.0);
        let (text, dihedral) = match random.below(4) {
            0 => (
                format!(
                    "single_v = {{ thickness_mm = {t}, root_gap_mm = {gap}, root_face_mm = {face}, angle_deg = {} }}",
                    random.within(40.0, 70.0)
                ),
                180.0,
            ),
            1 => (
                format!(
                    "u = {{ thickness_mm = {}, root_gap_mm = {gap}, root_face_mm = {face}, angle_deg = {}, radius_mm = {} }}",
                    t + 8.0,
                    random.within(10.0, 20.0),
                    random.within(3.0, 6.0)
                ),
                180.0,
            ),
            _ => (
                format!(
                    "t_bevel = {{ thickness_mm = {t}, root_gap_mm = {gap}, root_face_mm = {face}, angle_deg = {}, \
                     leg_mm = {}, prepared = \"{}\" }}",
                    random.within(40.0, 60.0),
                    random.within(3.0, 8.0),
                    random.one(&["first", "second"])
                ),
                random.within(75.0, 120.0),
            ),
        };
        let (joint, at) = joint(&text, dihedral);
        let drawn = joint.groove(&at);
        loop {
            let butt = joint.joint().preparation.is_butt();
            let groove = Groove {
                dihedral: drawn.dihedral + random.within(-0.03, 0.03),
                gap: (drawn.gap + random.within(-1.0, 2.0)).max(0.2),
                mismatch: if butt { random.within(-1.5, 1.5) } else { 0.0 },
                angle: drawn.angle.map(|a| a + random.within(-0.06, 0.06)),
            };
            let Some(section) = joint.section_with(&groove) else { continue };
            let (low, high) = section.slices.heights();
            let metal = welded.then(|| (random.within(0.1, 0.8) * (high - low), random.within(0.0, 0.4)));
            let steep = if matches!(joint.joint().preparation, Preparation::U(_)) { 0.3 } else { 1.0 };
            return Self {
                joint,
                at,
                groove,
                section,
                metal,
                seam_at: DVec2::new(random.within(-6.0, 6.0), random.within(-15.0, 15.0)),
                // A wall of a U must not be seen edge-on.
                turn: steep * random.within(-0.12, 0.12),
                mirrored: random.yes(),
            };
        }
    }

    fn height(&self, x: f64) -> f64 {
        let (depth, wave) = self.metal.unwrap_or((f64::INFINITY, 0.0));
        self.section.toes()[0].dot(self.section.up) - depth + wave * (1.3 * x).sin()
    }

    /// Points of the surface in the section's frame, densely, from the second part to the first.
    fn lines(&self) -> Vec<Vec<DVec2>> {
        let s = &self.section;
        let (sin, cos) = (0.5 * s.dihedral).sin_cos();
        let [first, second] = s.toes();
        let line = |edge: &[DVec2], toe: DVec2, along: DVec2| {
            let below = edge[0] - 3.0 * s.up;
            std::iter::once(below).chain(edge.iter().copied()).chain([toe + 60.0 * along]).collect::<Vec<_>>()
        };
        let mut lines =
            vec![line(&s.second, second, DVec2::new(-sin, cos)), line(&s.first, first, DVec2::new(sin, cos))];
        if self.metal.is_some() {
            let (from, to) = (second.dot(s.across()) - 2.0, first.dot(s.across()) + 2.0);
            let at = |k: u32| from + (to - from) * f64::from(k) / 2000.0;
            lines.push((0..=2000).map(|k| s.place(at(k), self.height(at(k)))).collect());
        }
        lines
    }

    /// The profile: the highest point of the surface in each column.
    fn profile(&self, random: &mut Random, pitch: f64, noise: f64) -> Vec<DVec2> {
        let view = self.section.view();
        let square = self.turn - view.x.atan2(view.y);
        let to_sensor = DVec2::from_angle(-square);
        let lines: Vec<Vec<DVec2>> = self
            .lines()
            .into_iter()
            .map(|line| line.into_iter().map(|q| to_sensor.rotate(q) + self.seam_at).collect())
            .collect();
        let toes = self.section.toes().map(|q| (to_sensor.rotate(q) + self.seam_at).x);
        let (from, to) = (toes[1].min(toes[0]) - 9.0, toes[0].max(toes[1]) + 9.0);
        let count = ((to - from) / pitch) as u32;
        let column = |k: u32| {
            let y = from + pitch * f64::from(k);
            let hits = lines.iter().flat_map(|line| line.windows(2)).filter_map(|w| {
                let t = (y - w[0].x) / (w[1].x - w[0].x);
                (0.0..=1.0).contains(&t).then(|| w[0].y + t * (w[1].y - w[0].y))
            });
            Some(DVec2::new(y, hits.reduce(f64::max)?))
        };
        let side = if self.mirrored { -1.0 } else { 1.0 };
        let seen: Vec<DVec2> = (0..count).filter_map(column).collect();
        seen.into_iter().map(|p| DVec2::new(side * p.x, p.y + noise * random.normal())).collect()
    }

    fn scan(&self, points: &[DVec2]) -> Result<GrooveScan, NoScan> {
        let view = SensorView { mirrored: self.mirrored, turn: 0.0 };
        GrooveScanner::new(&self.joint, self.metal.is_some(), view).unwrap().measure(&self.at, points)
    }

    /// Area above the metal, by fine slices.
    fn remaining(&self) -> f64 {
        if self.metal.is_none() {
            return self.section.area();
        }
        // The edges' heights across the line from toe to toe, by brute force.
        let s = &self.section;
        let [first, second] = s.toes();
        let (from, to, top) = (second.dot(s.across()), first.dot(s.across()), first.dot(s.up));
        let edges: Vec<[f64; 4]> = [&s.first, &s.second]
            .into_iter()
            .flat_map(|edge| edge.windows(2))
            .map(|w| [w[0].dot(s.across()), w[0].dot(s.up), w[1].dot(s.across()), w[1].dot(s.up)])
            .collect();
        let n = 20_000;
        let slice = |k: u32| {
            let x = from + (to - from) * (f64::from(k) + 0.5) / f64::from(n);
            let at = |[x0, h0, x1, h1]: &[f64; 4]| {
                let t = (x - x0) / (x1 - x0);
                (0.0..=1.0).contains(&t).then(|| h0 + t * (h1 - h0))
            };
            top - edges.iter().filter_map(at).fold(self.height(x), f64::max)
        };
        (0..n).map(slice).sum::<f64>() * (to - from) / f64::from(n)
    }
}

#[test]
fn profiles_without_noise_give_the_true_groove() {
    let mut random = Random::new(91);
    let (mut worst, mut without, mut far) = ([0.0_f64; 6], 0, 0);
    let all: u32 = cases(250);
    for case in 0..all {
        let part = Part::random(&mut random, case % 2 == 1);
        let points = part.profile(&mut random, 0.1, 0.0);
        let Ok(found) = part.scan(&points) else {
            without += 1;
            continue;
        };
        let joint = part.joint.joint();
        if part.metal.is_none() {
            let errors = [
                found.gap.value - part.groove.gap,
                found.mismatch.value - part.groove.mismatch,
                found.angle.unwrap().value - part.groove.angle.unwrap(),
                found.dihedral.value - part.groove.dihedral,
                found.area.value / part.section.area() - 1.0,
            ];
            for (worst, error) in worst.iter_mut().zip(errors) {
                *worst = worst.max(error.abs());
            }
            assert!(errors.iter().all(|e| e.abs() < 1e-3), "{case}: {errors:?} {:?} {joint:?}", part.groove);
        } else {
            let error = (found.remaining.value - part.remaining()) / part.section.area();
            worst[5] += error * error;
            far += u32::from(error.abs() > 0.03);
        }
    }
    println!("{all} profiles, {without} without a groove; {far} open areas off by more than 3 % of the groove");
    println!("largest errors: gap {:.1e} mm, mismatch {:.1e} mm", worst[0], worst[1]);
    println!("angle {:.1e} rad, dihedral {:.1e} rad", worst[2], worst[3]);
    let rms = (2.0 * worst[5] / f64::from(all)).sqrt();
    println!("area {:.1e} of the groove; open area above metal, RMS, {rms:.1e}", worst[4]);
    assert!(30 * without <= all && 100 * far <= all && rms < 0.01);
}

/// Errors in their uncertainties: number, sum, sum of squares.
#[derive(Default, Clone, Copy)]
struct Sums {
    count: f64,
    sum: f64,
    squares: f64,
}

#[test]
fn errors_agree_with_their_uncertainties() {
    let mut random = Random::new(92);
    let mut sums = [Sums::default(); 6];
    let (mut without, mut far) = (0, 0);
    let all: u32 = cases(250);
    for case in 0..all {
        let part = Part::random(&mut random, case % 3 == 0);
        let noise = random.within(0.02, 0.12);
        let points = part.profile(&mut random, 0.1, noise);
        let Ok(found) = part.scan(&points) else {
            without += 1;
            continue;
        };
        let mut add = |i: usize, found: Measured, truth: f64| {
            let z = (found.value - truth) / found.uncertainty;
            if z.abs() > 5.0 {
                far += 1;
            } else {
                let Sums { count, sum, squares } = sums[i];
                sums[i] = Sums { count: count + 1.0, sum: sum + z, squares: squares + z * z };
            }
        };
        if part.metal.is_none() {
            add(0, found.gap, part.groove.gap);
            if part.joint.joint().preparation.is_butt() {
                add(1, found.mismatch, part.groove.mismatch);
            }
            add(2, found.angle.unwrap(), part.groove.angle.unwrap());
            add(3, found.dihedral, part.groove.dihedral);
            add(4, found.area, part.section.area());
        } else {
            add(5, found.remaining, part.remaining());
        }
    }
    println!("{all} profiles, {without} without a groove, {far} values farther off than five uncertainties");
    let names = ["gap", "mismatch", "angle", "dihedral", "area", "open area above metal"];
    let table = names.into_iter().zip(sums).map(|(name, Sums { count, sum, squares })| {
        let (mean, deviation) = (sum / count, (squares / count).sqrt());
        println!("{name}: {count} errors, mean {mean:.3}, standard deviation {deviation:.3} of the uncertainty");
        (name, mean, deviation)
    });
    for (name, mean, deviation) in table.collect::<Vec<_>>() {
        let most = if name == "open area above metal" { 1.6 } else { 1.2 };
        assert!(mean.abs() < 0.3 && (0.8..most).contains(&deviation), "{name}: {mean} {deviation}");
    }
    // Five sizes of two profiles out of three, and an area of each third one.
    assert!(30 * without <= all && 30 * far <= all);
}

#[test]
fn spatter_and_holes_do_not_move_the_estimate() {
    let mut random = Random::new(93);
    let (mut clean, mut dirty, mut without) = (Vec::new(), Vec::new(), 0);
    let all: usize = cases(200);
    for case in 0..all {
        let part = Part::random(&mut random, case % 2 == 0);
        let points = part.profile(&mut random, 0.1, 0.05);
        let hole = random.within(-8.0, 8.0);
        let mut spoiled = Vec::new();
        for p in points.iter().filter(|p| (p.x - hole).abs() > 0.4) {
            let spatter = if random.chance(0.1) { random.within(0.5, 15.0) } else { 0.0 };
            if !random.chance(0.2) {
                spoiled.push(DVec2::new(p.x, p.y + spatter));
            }
        }
        let mut add = |points: &[DVec2], errors: &mut Vec<f64>| match part.scan(points) {
            Ok(found) => errors.push(((found.remaining.value - part.remaining()) / part.section.area()).abs()),
            Err(_) => without += 1,
        };
        add(&points, &mut clean);
        add(&spoiled, &mut dirty);
    }
    let [clean, dirty] = [clean, dirty].map(|mut errors| {
        errors.sort_by(f64::total_cmp);
        [errors[errors.len() / 2], errors[errors.len() * 95 / 100]].map(|e| 100.0 * e)
    });
    println!("error of the open area, % of the groove, median and 95 %: {clean:.2?}, spoiled {dirty:.2?}");
    println!("{without} of {} without a groove", 2 * all);
    assert!(dirty[0] < 0.1 + 2.0 * clean[0] && dirty[1] < 5.0);
    assert!(without * 25 <= 2 * all);
}

#[test]
fn profiles_of_other_things_have_no_groove() {
    let mut random = Random::new(94);
    let part = Part::random(&mut random, false);
    let plate: Vec<DVec2> = (0..300).map(|k| DVec2::new(0.1 * f64::from(k), 0.03 * random.normal())).collect();
    assert!(part.scan(&plate).is_err());
    let wild: Vec<DVec2> = (0..300).map(|k| DVec2::new(0.1 * f64::from(k), random.within(-9.0, 9.0))).collect();
    assert!(part.scan(&wild).is_err());
    assert_eq!(part.scan(&plate[..20]), Err(NoScan::TooFewPoints(20)));
    assert!(
        GrooveScanner::new(
            &joint("square = { thickness_mm = 5, root_gap_mm = 1 }", 180.0).0,
            false,
            SensorView::default()
        )
        .is_none()
    );
}
