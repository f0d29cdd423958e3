//! Waits between passes: for a time, and until the weld has cooled.

use crate::planning::{read, shipped_machine};
use seamwright_machine::{Clamped, Surroundings};
use seamwright_motion::{Phase, WeldMotion};
use seamwright_program::{Pass, Procedure, Program, TorchPath};
use seamwright_weld::Welding;

/// A V groove round a tube, in several passes.
const GIRTH: &str = "schema = 1\ntitle = \"t\"\nmachine = \"ebw-7axis\"\n[placement]\nmove_mm = [0, 0, 160]\n\
    [seam.girth]\nradius_mm = 100\ndirection = [0, 0, 1]\n[part]\nwatched = false\n[start]\nphi_deg = 30\n\
    overlap_mm = 20\n[joint.preparation.single_v]\nthickness_mm = 10\nangle_deg = 60\nroot_gap_mm = 2\n\
    root_face_mm = 1\n[beads]\nwire_mm = 1.2\ndeposition = 0.95\nstagger_mm = 30\nroot = { layer_mm = 3 }\n\
    fill = { layer_mm = 3 }\n[weld]\nspeed_mm_s = 8\non_limit = \"slow\"\n[weld.process]\ncurrent_a = 250\nvoltage_v = 26\n\
    wire_feed_m_min = 8\n";
const WPS: &str =
    "schema = 1\nnumber = \"W\"\ntitle = \"t\"\nprocess = 135\nwire_diameter_mm = 1.2\n[[runs]]\npasses = \"1-20\"\n";

fn planned(rest: &str) -> (Welding, Program, WeldMotion) {
    let welding = read(&format!("{GIRTH}{rest}"));
    let mut program = welding.program.value.clone();
    program.procedure = Some(Procedure::read("wps.toml", WPS).unwrap().value);
    let machine = shipped_machine("ebw-7axis");
    let clamped = Clamped::default();
    let around = Surroundings::new(&machine, &clamped).unwrap();
    let paths: Vec<_> = (0..program.passes.len()).map(|i| welding.path(i)).collect();
    let passes: Vec<(&dyn TorchPath, &Pass)> =
        paths.iter().zip(&program.passes).map(|(path, pass)| (path as &dyn TorchPath, pass)).collect();
    let mut motion = WeldMotion::plan(&machine, &around, &passes, 30.0).unwrap_or_else(|f| panic!("{f:#?}"));
    motion.hold_to(program.procedure.as_ref().unwrap(), &machine, &passes);
    motion.cool(&program, welding.seam.as_ref().map(seamwright_weld::SeamCurve::length));
    (welding, program, motion)
}

/// Start and end of each pass from home on, s.
fn times(motion: &WeldMotion) -> Vec<(f64, f64)> {
    let mut now = 0.0;
    let pass = |(transfer, pass): (&seamwright_motion::transfer::TransferMove, &seamwright_motion::PassMotion)| {
        let start = now + transfer.duration();
        now = start + pass.total_s();
        (start, now)
    };
    motion.transfers.iter().zip(&motion.passes).map(pass).collect()
}

#[test]
fn passes_wait_for_a_time_and_all_times_have_it() {
    let (_, program, motion) = planned("[interpass]\nwait_s = 300\n");
    let (_, _, at_once) = planned("");
    assert!(program.passes.len() > 2);
    let times = times(&motion);
    for pair in times.windows(2) {
        let gap = pair[1].0 - pair[0].1;
        assert!((300.0..302.0).contains(&gap), "{gap}");
    }
    assert!((motion.total_s() - at_once.total_s() - motion.wait_s()).abs() < 1e-6);
    assert!((motion.air_s() - at_once.air_s()).abs() < 1e-6 && at_once.wait_s() < 1e-9);
    // The axes rest in the wait, and the motion that is played has it.
    let (mut played, mut resting, mut last) = (0_u32, 0_u32, None);
    let period = 0.05;
    motion
        .play(period, true, |_, set, _| {
            resting += u32::from(set.phase == Phase::Transfer && last == Some(set.q));
            last = Some(set.q);
            played += 1;
            Ok::<(), ()>(())
        })
        .unwrap();
    assert!((f64::from(played) * period - motion.total_s()).abs() < 1.0 + 2.0 * period * times.len() as f64);
    assert!(f64::from(resting) * period > 0.98 * motion.wait_s(), "{resting}");
}

/// The temperature of every place when an arc comes over it, from the motion as it is played.
#[test]
fn every_place_has_cooled_when_the_next_pass_comes() {
    let below = 180.0;
    let (welding, program, motion) = planned(&format!("[interpass]\nbelow_c = {below}\n"));
    let interpass = program.interpass.as_ref().unwrap();
    let length = welding.seam.as_ref().unwrap().length();
    let heat = 0.8 * 250.0 * 26.0 / 1000.0;
    let places: Vec<f64> = (0..24).map(|i| length * (f64::from(i) + 0.5) / 24.0).collect();
    let mut passages: Vec<Vec<(usize, f64, f64)>> = vec![Vec::new(); places.len()];
    let mut hottest: f64 = 0.0;
    let (mut before, mut pass_before) = (f64::NAN, 0);
    motion
        .play(0.02, true, |pass, set, _| {
            if pass > 0 && set.phase == Phase::Travel {
                let on_seam = program.passes[pass - 1].seam_s(set.profile.s);
                for (place, over) in places.iter().zip(&mut passages) {
                    let turns = ((on_seam - place) / length).floor();
                    if pass == pass_before && ((before - place) / length).floor() < turns {
                        let earlier = over.iter().filter(|(k, ..)| *k < pass);
                        let rise: f64 = earlier.map(|(_, t, q)| interpass.rise_k(*q, 10.0, set.t - t)).sum();
                        hottest = hottest.max(20.0 + rise);
                        assert!(20.0 + rise < below + 2.0, "pass {pass} at {place}: {}", 20.0 + rise);
                        over.push((pass, set.t, heat / set.profile.v));
                    }
                }
                (before, pass_before) = (on_seam, pass);
            }
            Ok::<(), ()>(())
        })
        .unwrap();
    // No longer than needed.
    assert!(motion.wait_s() > 60.0 && hottest > below - 8.0, "{} {hottest}", motion.wait_s());
    assert!(motion.findings.iter().any(|f| f.kind == "interpass" && f.allowed));
}

#[test]
fn tacks_and_other_places_need_no_wait() {
    let (_, program, motion) =
        planned("[interpass]\nwait_s = 100\n[tacks]\ncount = 4\nlength_mm = 20\n[order]\nparts = \"quadrants\"\n");
    let roots = program.passes.iter().filter(|pass| pass.name.starts_with("root")).count();
    assert_eq!(roots, 4);
    // The quarters of the root lie beside each other.
    let quarter = |i: usize| motion.transfers[i].rest_s();
    assert!((0..8).all(|i| quarter(i) < 1e-9));
    assert!((8..program.passes.len()).any(|i| quarter(i) > 0.0));
}
