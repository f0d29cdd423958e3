use super::file::Rule;
use super::tour::{Leg, Stop, tour};
use crate::welding::Welding;
use glam::DVec3;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use seamwright_program::{ArcTime, Pass, Program, Role, TorchPath};
use seamwright_testkit::cases;

const RADIATOR: &str = include_str!("../../../../examples/radiator.toml");

const LINE: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [100, 0, 0]\n\
    first_normal = [0, 0, 1]\nsecond_normal = [0, 1, 0]\n[weld]\nspeed_mm_s = 5\n\
    process = { current_a = { from = 100, to = 200 } }\n";

fn read(text: &str) -> Welding {
    Welding::read("job.toml", text).unwrap()
}

fn length(stops: &[Stop], legs: &[Leg], from: Option<DVec3>) -> f64 {
    let (mut at, mut sum) = (from, 0.0);
    for leg in legs {
        let (start, end) = stops[leg.0].ways[leg.1];
        sum += at.map_or(0.0, |at| at.distance(start));
        at = Some(end);
    }
    sum
}

/// The minimum length of all orders and ways, by trying all.
fn least(stops: &[Stop], from: Option<DVec3>) -> f64 {
    fn go(stops: &[Stop], left: &[usize], at: Option<DVec3>) -> f64 {
        let mut best = if left.is_empty() { 0.0 } else { f64::INFINITY };
        for stop in left {
            let rest: Vec<usize> = left.iter().copied().filter(|i| i != stop).collect();
            for (start, end) in &stops[*stop].ways {
                best = f64::min(best, at.map_or(0.0, |at| at.distance(*start)) + go(stops, &rest, Some(*end)));
            }
        }
        best
    }
    go(stops, &(0..stops.len()).collect::<Vec<_>>(), from)
}

fn stops(count: std::ops::RangeInclusive<usize>) -> impl Strategy<Value = Vec<Stop>> {
    let point = || (0.0..300.0f64, 0.0..300.0f64).prop_map(|(x, y)| DVec3::new(x, y, 0.0));
    let stop = (1..4u32, point(), point(), 0..3usize).prop_map(|(row, a, b, kind)| Stop {
        row,
        ways: match kind {
            0 => vec![(a, a)],
            1 => vec![(a, b)],
            _ => vec![(a, b), (b, a)],
        },
    });
    prop::collection::vec(stop, count)
}

fn once(legs: &[Leg], count: usize) -> bool {
    let mut all: Vec<usize> = legs.iter().map(|leg| leg.0).collect();
    all.sort_unstable();
    all.into_iter().eq(0..count)
}

#[test]
fn the_shortest_way_is_seldom_longer_than_the_best_of_all_and_never_much() {
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let (count, mut best, mut worst) = (cases(400), 0, 1.0_f64);
    for case in 0..count {
        let stops = stops(1..=6).new_tree(&mut runner).unwrap().current();
        let from = (case % 2 == 0).then_some(DVec3::ZERO);
        let legs = tour(&stops, Rule::Shortest, from);
        assert!(once(&legs, stops.len()));
        let (found, wanted) = (length(&stops, &legs, from), least(&stops, from));
        assert!(found <= length(&stops, &tour(&stops, Rule::InTurn, from), from) + 1e-9, "longer than the list");
        assert!(found >= wanted - 1e-9, "shorter than the best of all");
        worst = worst.max(found / wanted.max(1e-9));
        best += u32::from(found <= wanted + 1e-9);
    }
    assert!(best * 100 >= 95 * count, "{best} of {count} are best");
    println!("{best} of {count} are best, the worst is {worst} of it");
    assert!(worst <= 1.1, "{worst}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(60)))]

    #[test]
    fn every_stop_is_there_once_and_rows_change_as_often_as_they_can(stops in stops(1..=24), every in 2..6usize) {
        for rule in [Rule::InTurn, Rule::Skip(every), Rule::Shortest, Rule::BackAndForth] {
            prop_assert!(once(&tour(&stops, rule, None), stops.len()), "{rule:?}");
        }
        let legs = tour(&stops, Rule::BackAndForth, None);
        let within = legs.windows(2).filter(|w| stops[w[0].0].row == stops[w[1].0].row).count();
        let most = (1..4).map(|row| stops.iter().filter(|s| s.row == row).count()).max().unwrap_or(0);
        prop_assert_eq!(within, (2 * most).saturating_sub(stops.len() + 1));
        prop_assert!(tour(&stops, Rule::InTurn, None).iter().map(|l| l.0).eq(0..stops.len()));
    }

    #[test]
    fn a_skip_never_leads_to_the_neighbour(columns in 4..40usize, rows in 1..4u32, every in 2..8usize) {
        prop_assume!(2 * every <= columns);
        let stop = |row| Stop { row, ways: vec![(DVec3::ZERO, DVec3::ZERO)] };
        let stops: Vec<Stop> = (1..=rows).flat_map(|row| (0..columns).map(move |_| stop(row))).collect();
        let legs = tour(&stops, Rule::Skip(every), None);
        for w in legs.windows(2).filter(|w| stops[w[0].0].row == stops[w[1].0].row) {
            prop_assert!(w[0].0.abs_diff(w[1].0) > 1, "{legs:?}");
        }
    }
}

/// Range of a pass on the seam: from the smaller path length to the larger.
fn range(pass: &Pass) -> (f64, f64) {
    let ends = [pass.seam_s(0.0), pass.seam_s(pass.length())];
    (ends[0].min(ends[1]), ends[0].max(ends[1]))
}

#[test]
fn rows_become_copies_at_their_places() {
    let welding = read(RADIATOR);
    let program = &welding.program.value;
    assert_eq!((program.copies.len(), program.passes.len()), (12, 12));
    for (i, pass) in program.passes.iter().enumerate() {
        let (row, column) = (pass.copy / 6, pass.copy % 6);
        assert_eq!(pass.name, format!("row {}, {}", row + 1, column + 1));
        let wanted = DVec3::new(-125.0 + 50.0 * column as f64, -30.0 + 60.0 * row as f64 + 16.0, 0.0);
        assert!(welding.path(i).pose(0.0).point.distance(wanted) < 1e-9);
    }
    let rows: Vec<usize> = program.passes.iter().map(|pass| pass.copy / 6).collect();
    assert!(rows.windows(2).all(|w| w[0] != w[1]), "{rows:?}");
    let mut copies: Vec<usize> = program.passes.iter().map(|pass| pass.copy).collect();
    copies.sort_unstable();
    assert!(copies.into_iter().eq(0..12));
    let text = program.to_toml().unwrap();
    assert_eq!(Program::read("p.toml", &text).unwrap().value, *program);
    let e = Program::read("p.toml", &text.replacen("copy = ", "copy = 9", 1)).unwrap_err();
    assert!(
        e.key.ends_with(".copy")
            && e.allowed.as_ref().map(ToString::to_string).as_deref() == Some("0 to 11, the index in [[copies]]"),
        "{e}"
    );
    let solids = welding.clamped(&|_| Err(std::io::ErrorKind::NotFound.into())).unwrap().part;
    assert_eq!((solids.len(), solids[7].name()), (12, "plate of row 2, 2"));
    // A file of a seam without copies has none of the new keys.
    let plain = read(LINE).program.value.to_toml().unwrap();
    assert!(!plain.contains("cop") && !plain.contains("order"), "{plain}");
}

#[test]
fn opposite_quarters_follow_each_other_and_cover_the_seam() {
    for tie_in in [0.0, 5.0, 12.5] {
        let order = format!("rule = \"in_turn\"\nparts = \"quadrants\"\ntie_in_mm = {tie_in:?}");
        let welding = read(&RADIATOR.replace("rule = \"back_and_forth\"", &order));
        let quarter = 0.25 * welding.seam.as_ref().unwrap().length();
        let passes = &welding.program.value.passes;
        assert_eq!(passes.len(), 48);
        for (k, four) in passes.chunks(4).enumerate() {
            let begins: Vec<f64> = four.iter().map(|pass| pass.begin_mm.get() / quarter).collect();
            for (found, wanted) in begins.iter().zip([0.0, 2.0, 1.0, 3.0]) {
                assert!((found - wanted).abs() < 1e-9, "{begins:?}");
            }
            assert!(four.iter().all(|pass| pass.copy == k && (pass.length() - quarter - tie_in).abs() < 1e-9));
        }
        assert_eq!(passes[1].name, "row 1, 1, part 2");
    }
}

#[test]
fn back_steps_cover_the_weld_against_their_progress() {
    let order = "[order]\nparts = { back_step_mm = 30 }\ntie_in_mm = 3\n";
    let welding = read(&format!("{LINE}{order}"));
    let passes = &welding.program.value.passes;
    let ranges: Vec<(f64, f64)> = passes.iter().map(range).collect();
    let wanted = [(0.0, 25.0), (22.0, 50.0), (47.0, 75.0), (72.0, 100.0)];
    for (found, wanted) in ranges.iter().zip(wanted) {
        assert!((found.0 - wanted.0).abs() < 1e-9 && (found.1 - wanted.1).abs() < 1e-9, "{ranges:?}");
    }
    assert!(passes.len() == 4 && passes.iter().all(|pass| pass.reverse));
    // Everywhere with the values of the whole weld.
    for pass in passes {
        for s in [0.0, 1.0, 0.5 * pass.length(), pass.length()] {
            let current = pass.process_at("current_a", s, ArcTime::TRAVEL).unwrap();
            assert!((current - 100.0 - pass.seam_s(s)).abs() < 1e-9, "{current} at {s}");
        }
    }
}

/// A K-joint: where its branches overlap, the seam has two corners, at which the torch's direction jumps.
const K_JOINT: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.branch]\nradius_mm = 60\nchord_radius_mm = 120\n\
    angle_deg = 60\n[seam.branch.other]\nradius_mm = 60\nangle_deg = 60\ngap_mm = -30\n\
    [weld]\nspeed_mm_s = 5\nprocess = { current_a = { from = 100, to = 200 } }\n";

#[test]
fn from_corner_to_corner_no_direction_jumps() {
    let turns = |welding: &Welding| welding.findings().into_iter().filter(|f| f.kind == "turn").collect::<Vec<_>>();
    let whole = read(K_JOINT);
    let found = turns(&whole);
    assert!(found.len() == 2 && found[0].cure_text().contains("at_corners"), "{found:#?}");
    let length = whole.seam.as_ref().unwrap().length();
    let corner = found[0].from_mm;
    let [before, after] = [corner - 1e-3, corner + 1e-3].map(|s| whole.path(0).pose(s).direction);
    let e = Welding::read("j.toml", &format!("{K_JOINT}[start]\noverlap_mm = 15\n[order]\nparts = \"at_corners\"\n"));
    assert_eq!(e.unwrap_err().key, "start.overlap_mm");
    for start in ["", "[start]\nphi_deg = 70\ndirection = \"clockwise\"\n"] {
        let welding = read(&format!("{K_JOINT}{start}[order]\nparts = \"at_corners\"\n"));
        assert!(turns(&welding).is_empty(), "{:#?}", turns(&welding));
        let passes = &welding.program.value.passes;
        assert_eq!(passes.len(), 2);
        // Each starts at the end of the other.
        let sum: f64 = passes.iter().map(Pass::length).sum();
        assert!((sum + 4e-4 - length).abs() < 1e-6, "{sum} of {length}");
        for i in 0..2 {
            let (this, other) = (welding.path(i), welding.path(1 - i));
            assert!(this.pose(0.0).point.distance(other.pose(other.length()).point) < 3e-4);
            // Continuous up to the very ends.
            for s in [0.0, this.length()] {
                let near = this.pose((s - 1e-3).abs().min(this.length() - 1e-3));
                assert!(near.direction.distance(this.pose(s).direction) < 1e-4);
            }
        }
    }
    assert!(before.distance(after) > 0.1, "{before} {after}");
    // A start at a corner counts as one of the corners.
    assert!(Welding::read("p.toml", &whole.program.value.to_toml().unwrap()).is_ok());
}

#[test]
fn back_steps_round_a_ring_tie_in_with_each_other() {
    let steps = "[order]\nparts = { back_step_mm = 30 }\ntie_in_mm = 3\n";
    let text =
        RADIATOR.replace("overlap_mm = 5", "overlap_mm = 0").replace("[order]\nrule = \"back_and_forth\"", steps);
    let welding = read(&text);
    let turn = welding.seam.as_ref().unwrap().length();
    let passes: Vec<&Pass> = welding.program.value.passes.iter().filter(|pass| pass.copy == 0).collect();
    assert_eq!(passes.len(), 4);
    // All round, and with the tie-in at each of the joints.
    let sum: f64 = passes.iter().map(|pass| pass.length()).sum();
    assert!((sum - turn - 4.0 * 3.0).abs() < 1e-6, "{sum} of {turn}");
    assert!((passes[3].begin_mm.get() - 3.0).abs() < 1e-6 && passes.iter().all(|pass| pass.reverse));
}

/// Regular rows of very different lengths: many ways cost the same.
#[test]
fn large_regular_grids_come_to_an_end() {
    for (long, short, ways) in [(100, 10, 1), (24, 24, 2), (400, 400, 1)] {
        let stop = |row: u32, column: i32| {
            let place = DVec3::new(50.0 * f64::from(column), 60.0 * f64::from(row), 0.0);
            Stop { row, ways: [(place, place + 10.0 * DVec3::X), (place + 10.0 * DVec3::X, place)][..ways].to_vec() }
        };
        let stops: Vec<Stop> = (0..long).map(|i| stop(1, i)).chain((0..short).map(|i| stop(2, i))).collect();
        let legs = tour(&stops, Rule::BackAndForth, None);
        let within = legs.windows(2).filter(|w| stops[w[0].0].row == stops[w[1].0].row).count();
        assert!(once(&legs, stops.len()) && within == (long - short).saturating_sub(1).max(0) as usize, "{within}");
    }
}

#[test]
fn an_open_seam_is_welded_from_either_end_if_it_may_be() {
    let rows = "[rows]\nrows = 5\ncolumns = 1\nrow_step_mm = [0, 30, 0]\n[order]\n";
    let sum = |welding: &Welding| {
        let ends = |i| (welding.path(i).pose(0.0).point, welding.path(i).pose(welding.path(i).length()).point);
        (1..5).map(|i| ends(i - 1).1.distance(ends(i).0)).sum::<f64>()
    };
    assert!((sum(&read(&format!("{LINE}{rows}"))) - 4.0 * 100.0_f64.hypot(30.0)).abs() < 1e-9);
    let either = read(&format!("{LINE}{rows}either_end = true\n"));
    assert!((sum(&either) - 120.0).abs() < 1e-9);
    assert_eq!(either.program.value.passes.iter().filter(|pass| pass.reverse).count(), 2);
}

#[test]
fn tacks_come_first_in_opposite_pairs_and_stay_away_from_the_start() {
    let tacks = "[tacks]\nlength_mm = 8\ncount = 4\nclear_mm = 6\nspeed_mm_s = 3\nprocess = { current_a = 120 }\n";
    let welding = read(&format!("{RADIATOR}\n{tacks}"));
    let passes = &welding.program.value.passes;
    let quarter = 0.25 * welding.seam.as_ref().unwrap().length();
    assert_eq!(passes.len(), 60);
    assert!(passes[..48].iter().all(|pass| pass.role == Some(Role::Tack)));
    assert!(passes[48..].iter().all(|pass| pass.role.is_none()));
    for four in passes[..48].chunks(4) {
        let places: Vec<f64> = four.iter().map(|pass| (pass.begin_mm.get() + 4.0) / quarter).collect();
        for (found, wanted) in places.iter().zip([0.5, 2.5, 1.5, 3.5]) {
            assert!((found - wanted).abs() < 1e-9, "{places:?}");
        }
    }
    let span = &passes[0].spans[0];
    assert_eq!((span.to_mm.get(), span.speed_mm_s.ends().0, span.process["current_a"].ends().0), (8.0, 3.0, 120.0));
    assert_eq!(passes[0].name, format!("tack 1, {}", welding.program.value.copies[passes[0].copy].name));
    // With the speed that the weld has there.
    let at = "[[weld.at]]\ns_mm = 0\nspeed_mm_s = 3\n[[weld.at]]\ns_mm = 100\nspeed_mm_s = 6\n";
    let slower = read(&format!("{LINE}{at}[tacks]\nlength_mm = 10\npitch_mm = 40\n"));
    let speeds: Vec<(f64, f64)> = slower.program.value.passes[..3].iter().map(Pass::speeds).collect();
    for ((least, most), begin) in speeds.into_iter().zip([5.0, 85.0, 45.0]) {
        assert!((least - 3.0 - 0.03 * begin).abs() < 1e-9 && (most - least).abs() < 1e-12, "{least} {most}");
    }
    // In a groove where the root lies.
    let hillside = include_str!("../../../../examples/hillside.toml");
    let welding = read(&format!("{hillside}\n{tacks}"));
    let passes = &welding.program.value.passes;
    let root = passes.iter().find(|pass| pass.role == Some(Role::Root)).and_then(|pass| pass.bead.as_ref()).unwrap();
    for tack in &passes[..4] {
        let bead = tack.bead.as_ref().unwrap();
        assert!(tack.role == Some(Role::Tack) && bead.out_mm == root.out_mm && bead.across_mm == root.across_mm);
        assert!(bead.area_mm2.iter().all(|area| area.get() == 0.0) && bead.weave_part.is_empty());
    }
    // On a line from end to end, clear of both.
    let line = read(&format!("{LINE}[tacks]\nlength_mm = 10\npitch_mm = 40\n"));
    let ranges: Vec<(f64, f64)> = line.program.value.passes.iter().map(range).collect();
    assert_eq!(ranges, [(5.0, 15.0), (85.0, 95.0), (45.0, 55.0), (0.0, 100.0)]);
}

#[test]
fn a_cosmetic_pass_is_the_last_on_each_copy() {
    let cosmetic = "[cosmetic]\nfrom_mm = 10\nspeed_mm_s = 9\n";
    let line = read(&format!("{LINE}{cosmetic}"));
    let [weld, pass] = &line.program.value.passes[..] else { panic!() };
    assert_eq!((range(weld), range(pass), pass.role), ((0.0, 100.0), (10.0, 100.0), Some(Role::Cosmetic)));
    assert_eq!((pass.name.as_str(), pass.speeds()), ("cosmetic", (9.0, 9.0)));
    // Values without a setting of their own are those of the weld there.
    assert_eq!(pass.spans[0].process["current_a"].ends(), (110.0, 200.0));
    let own = read(&format!("{LINE}{cosmetic}process = {{ current_a = 30 }}\n"));
    assert_eq!(own.program.value.passes[1].spans[0].process["current_a"].ends(), (30.0, 30.0));
    let rows = read(&format!("{RADIATOR}\n[cosmetic]\n"));
    for two in rows.program.value.passes.chunks(2) {
        assert!(two[0].copy == two[1].copy && two[0].role.is_none() && two[1].role == Some(Role::Cosmetic));
        assert!(two[1].name.starts_with("cosmetic, "), "{}", two[1].name);
        assert_eq!(range(&two[0]), range(&two[1]));
    }
    let error = |more: &str| Welding::read("job.toml", &format!("{LINE}[cosmetic]\n{more}\n")).unwrap_err().key;
    assert_eq!(error("from_mm = 99.5"), "cosmetic.from_mm");
    assert_eq!(error("process = { amps = 3 }"), "cosmetic.process.amps");
    assert_eq!(error("process = { current_a = { from = 1, to = 2 } }"), "cosmetic.process.current_a");
}

#[test]
fn what_cannot_be_ordered_is_refused_with_its_key() {
    let error = |from: &str, to: &str| {
        assert!(RADIATOR.contains(from));
        let e = Welding::read("job.toml", &RADIATOR.replace(from, to)).unwrap_err();
        assert!(e.allowed.as_ref().map(ToString::to_string).as_deref().is_some_and(|a| !a.is_empty()), "{e}");
        e.key
    };
    let rule = "rule = \"back_and_forth\"";
    assert_eq!(error("\nrows = 2", "\nrows = 0"), "rows.rows");
    assert_eq!(error("columns = 6", "columns = 501"), "rows.columns");
    assert_eq!(error("\nstep_mm = [50, 0, 0]", "\nstep_mm = [0, 0, 0]"), "rows.step_mm");
    assert_eq!(error("row_step_mm = [0, 60, 0]", "row_step_mm = [100, 0, 0]"), "rows.row_step_mm");
    assert_eq!(error("\nrows = 2", "\nrows = 1"), "order.rule");
    assert_eq!(error(rule, "rule = { skip = 6 }"), "order.rule.skip");
    assert_eq!(error(rule, "rule = { skip = 1 }"), "order.rule.skip");
    assert_eq!(error(rule, "parts = { back_step_mm = 119 }"), "order.parts.back_step_mm");
    assert_eq!(error(rule, "parts = \"quadrants\"\ntie_in_mm = 29"), "order.tie_in_mm");
    assert_eq!(error(rule, "parts = \"at_corners\""), "order.parts");
    assert_eq!(error(rule, "either_end = true"), "order.either_end");
    assert_eq!(error(rule, "[[copies]]\nname = \"a\""), "rows");
    assert_eq!(error(rule, "[tacks]\nlength_mm = 20\npitch_mm = 15"), "tacks.length_mm");
    assert_eq!(error(rule, "[tacks]\nlength_mm = 20\ncount = 6"), "tacks.length_mm");
    assert_eq!(error(rule, "[tacks]\nlength_mm = 20\ncount = 1"), "tacks.count");
    assert_eq!(error(rule, "[tacks]\nlength_mm = 20\ncount = 3\nclear_mm = 10"), "tacks.clear_mm");
    assert_eq!(error(rule, "[tacks]\nlength_mm = 20"), "tacks");
    assert_eq!(error(rule, "[tacks]\nlength_mm = 5\ncount = 3\nprocess = { amps = 3 }"), "tacks.process.amps");
    let line = |more: &str| Welding::read("job.toml", &format!("{LINE}{more}")).unwrap_err().key;
    assert_eq!(line("[order]\nparts = \"quadrants\"\n"), "order.parts");
    assert_eq!(line("[order]\nparts = { back_step_mm = 0.001 }\ntie_in_mm = 0\n"), "order.parts.back_step_mm");
    let many = "[rows]\nrows = 100\ncolumns = 10\nstep_mm = [200, 0, 0]\nrow_step_mm = [0, 50, 0]\n";
    assert_eq!(line(&format!("{many}[order]\nparts = {{ back_step_mm = 1 }}\ntie_in_mm = 0\n")), "order");
    assert_eq!(line(&format!("{many}[tacks]\nlength_mm = 1\ncount = 30\n")), "tacks");
    assert_eq!(line("[[copies]]\nname = \"a\"\n[[copies]]\nname = \"b\"\n"), "copies[1].placement");
    assert_eq!(line("[placement]\nmove_mm = [1, 0, 0]\n[[copies]]\nname = \"a\"\n"), "placement");
    assert_eq!(line("[[copies]]\nname = \"a\"\n[[copies]]\nname = \"a\"\n"), "copies[1].name");
}
