//! Tests against the plain definitions: every run checked by itself, every partition enumerated.

use super::feasible::{Care, Ends, Memory};
use super::fewest::fewest;
use super::reduction::{Span, Tolerances};
use super::track::Track;
use glam::{DQuat, DVec3};
use seamwright_testkit::{Random, cases};

const TOLERANCES: Tolerances = Tolerances { path_mm: 1.0, columns: 0.5 };

/// Points along curved paths, with noise up to about the tolerance 1: many runs are at the limit. Some points are
/// doubled, some paths turn back, some are closed.
fn points(random: &mut Random, count: usize) -> Vec<DVec3> {
    let (step, noise) = (random.within(0.3, 12.0), random.within(0.0, 1.2));
    let (mut at, mut way) = (10.0 * random.vector(1.0), DVec3::X);
    let mut turn = DQuat::IDENTITY;
    let mut points: Vec<DVec3> = Vec::new();
    for k in 0..count {
        if random.below(6) == 0 {
            turn = DQuat::from_axis_angle(random.vector(1.0).normalize(), random.within(0.0, 0.8));
        }
        way = match random.below(30) {
            0 => -way,
            1 => random.vector(1.0).normalize(),
            _ => turn * way,
        };
        at += step * random.within(0.5, 1.5) * way;
        points.push(match random.below(40) {
            0 if k > 0 => points[random.below(k)],
            _ => at + noise * random.vector(1.0) * 0.577,
        });
    }
    points
}

fn columns(random: &mut Random, count: usize) -> Vec<Vec<f64>> {
    if random.below(3) > 0 {
        return Vec::new();
    }
    let mut value = 0.0;
    let mut rate = 0.0;
    let next = |_| {
        if random.below(8) == 0 {
            rate = random.within(-2.0, 2.0);
        }
        value += rate * random.within(0.7, 1.3);
        value
    };
    vec![(0..count).map(next).collect()]
}

/// Flags the runs that have a span, each checked by itself.
fn table(track: &Track) -> Vec<Vec<bool>> {
    let n = track.points.len();
    let ask = |i: usize, j: usize| j > i && track.span(i, j, &mut Memory::default()).is_some();
    (0..n).map(|i| (0..n).map(|j| ask(i, j)).collect()).collect()
}

fn ends(spans: &[Span]) -> Vec<usize> {
    spans.iter().map(|s| s.last).collect()
}

/// As published: all ends from the last one down.
fn printed(table: &[Vec<bool>]) -> Vec<usize> {
    let end = table.len() - 1;
    let (mut at, mut ends) = (0, Vec::new());
    while at < end {
        at = (at + 1..=end).rev().find(|j| table[at][*j]).unwrap();
        ends.push(at);
    }
    ends
}

/// The fewest spans by enumerating every partition: bit k - 1 of a number is set if point k is an end.
fn fewest_of_all(table: &[Vec<bool>]) -> usize {
    let end = table.len() - 1;
    let count = |partition: u32| {
        let kept = (0..=end).filter(|k| *k == 0 || *k == end || partition >> (k - 1) & 1 == 1);
        let kept: Vec<usize> = kept.collect();
        if kept.windows(2).all(|run| table[run[0]][run[1]]) { kept.len() - 1 } else { usize::MAX }
    };
    (0..1u32 << (end - 1)).map(count).min().unwrap()
}

fn shortest_way(table: &[Vec<bool>]) -> usize {
    let mut least = vec![0];
    while least.len() < table.len() {
        let last = least.len();
        least.push((0..last).filter(|i| table[*i][last]).map(|i| least[i] + 1).min().unwrap());
    }
    least[table.len() - 1]
}

fn check(points: &[DVec3], axes: &[Vec<f64>], count_all: impl Fn(&[Vec<bool>]) -> usize) {
    let track = Track::new(points, axes, TOLERANCES);
    let table = table(&track);
    assert_eq!(ends(&track.greedy()), printed(&table), "greedy {points:?}");
    let turned: Vec<DVec3> = points.iter().rev().copied().collect();
    let turned_axes: Vec<Vec<f64>> = axes.iter().map(|c| c.iter().rev().copied().collect()).collect();
    let back = Track::new(&turned, &turned_axes, TOLERANCES);
    let (found, found_back) = (fewest(&track, &back), fewest(&back, &track));
    let least = count_all(&table);
    assert_eq!((found.spans.len(), found.at_least), (least, least), "{points:?}");
    assert_eq!(found_back.spans.len(), least);
    let mut at = 0;
    for span in &found.spans {
        assert!(span.first == at && table[at][span.last] && span.max_error <= 1.0 + 1e-12);
        at = span.last;
    }
    assert_eq!(at, track.end());
}

#[test]
fn small_paths_have_the_fewest_spans_of_all_partitions() {
    let mut random = Random::new(1);
    for _ in 0..cases(3000) {
        let count = 2 + random.below(11);
        check(&points(&mut random, count), &columns(&mut random, count), fewest_of_all);
    }
}

#[test]
fn longer_paths_have_the_fewest_spans_by_asking_every_run() {
    let mut random = Random::new(2);
    for _ in 0..cases(300) {
        let count = 13 + random.below(90);
        check(&points(&mut random, count), &columns(&mut random, count), shortest_way);
    }
}

#[test]
fn what_is_excluded_has_no_span() {
    let mut random = Random::new(3);
    let mut proofs = 0;
    for _ in 0..cases(150) {
        let count = 5 + random.below(60);
        let (points, axes) = (points(&mut random, count), columns(&mut random, count));
        let track = Track::new(&points, &axes, TOLERANCES);
        let table = table(&track);
        for i in 0..count {
            let mut memory = [Memory::default(); 2];
            for j in i + 1..count {
                let from_here = table[i][j..].iter().any(|yes| *yes);
                let from_before = table[..=i].iter().any(|row| row[j..].iter().any(|yes| *yes));
                for care in [Care::Glance, Care::Full] {
                    let fixed = track.excluded(i, j, Ends::FixedStart, care, &mut memory[0]);
                    let free = track.excluded(i, j, Ends::Free, care, &mut memory[1]);
                    assert!(!(fixed && from_here), "{i} {j} {points:?}");
                    assert!(!(free && from_before), "{i} {j} {points:?}");
                    proofs += u32::from(fixed) + u32::from(free);
                }
            }
        }
    }
    assert!(proofs > 10_000);
}

#[test]
fn a_run_backwards_has_the_same_span() {
    let mut random = Random::new(4);
    for _ in 0..cases(3000) {
        let count = 3 + random.below(30);
        let points = points(&mut random, count);
        let turned: Vec<DVec3> = points.iter().rev().copied().collect();
        let (track, back) = (Track::new(&points, &[], TOLERANCES), Track::new(&turned, &[], TOLERANCES));
        let there = track.span(0, count - 1, &mut Memory::default());
        let again = back.span(0, count - 1, &mut Memory::default());
        assert_eq!(there.map(|s| s.max_error), again.map(|s| s.max_error));
    }
}
