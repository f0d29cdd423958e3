use super::judge::judge;
use super::midline::{full_width, line, midline, odd};
use super::path::Paths;
use super::strip::{Axis, EVIDENCE_FROM, HALF, ROWS, Strip};
use super::{CONFIDENT, End, Joint, Options, Row, Start, State, Zone};
use crate::Frame;

/// Widths tried at a start of unknown width, pixels.
const WIDTHS: [f32; 6] = [2.0, 3.5, 6.0, 10.0, 18.0, 32.0];
/// Rows taken from a strip; those after them look ahead ...
const TAKEN: usize = 32;
/// ... and these before them look back.
const BACK: usize = 10;
/// A row is supported if half of the rows within this many of it stand out of the noise ...
const NEIGHBOURS: usize = 6;
/// ... by this many standard deviations.
const STANDS_OUT: f32 = 3.3;
/// Rows before and after that confidence is a mean over.
const AROUND: usize = 12;
/// Contrast may differ from what it was by this factor either way.
const CONTRAST_FACTOR: f32 = 2.5;
/// The path is closed within this distance, pixels, and angle, rad, of its start.
const CLOSED: (f32, f32) = (2.0, 0.26);
/// Joints bend no more sharply than this, rad/px.
const MOST_BENT: f32 = 0.025;
/// The midline's standard error in a row that is sure, pixels.
const KNOWN_TO: f32 = 0.35;
/// A profile's odd part in a row that is sure, of its depth.
const ODD: f32 = 0.15;
/// A frame without this part of the first rows supported shows no joint at the start.
const START_SUPPORT: f32 = 0.6;

/// Follows joints; keeps its buffers from frame to frame.
#[derive(Debug, Clone)]
pub struct Follower {
    options: Options,
    strip: Strip,
    paths: Paths,
    joint: Joint,
    /// Depth of each row alone, to find where a joint ends.
    depths: Vec<f32>,
}

/// What is known of the joint as it is followed.
struct Track {
    axis: Axis,
    width: f32,
    contrast: f32,
    /// Rows since the last supported one.
    gap: usize,
    /// Rows up to and including the last supported one.
    seen: usize,
}

/// What a strip shows.
struct View {
    supported: [bool; ROWS],
    middle: [f32; ROWS],
    confidence: [f32; ROWS],
    contrast: f32,
    /// Mean depth by the root of the width: the greatest for the right width.
    strength: f32,
}

impl Follower {
    /// A follower with its buffers.
    #[must_use]
    pub fn new(options: Options) -> Self {
        let joint = Joint { rows: Vec::new(), end: End::Lost };
        Self { options, strip: Strip::new(), paths: Paths::new(), joint, depths: Vec::new() }
    }

    /// The joint in `frame` from `start`. A start outside the frame or zone, or not finite, gives no rows and
    /// [`End::LeftImage`]; a start where no joint is to be seen gives no rows and [`End::Lost`].
    pub fn follow(&mut self, frame: &Frame, start: &Start) -> &Joint {
        let Options { length, zone, .. } = self.options;
        let size = (frame.width() + frame.height()) as f32;
        let zone = zone.unwrap_or(Zone { left: 0.0, top: 0.0, right: f32::MAX, bottom: f32::MAX });
        let inside = Inside { zone, right: (frame.width() - 1) as f32, bottom: (frame.height() - 1) as f32 };
        let longest = length.unwrap_or(2.0 * size).clamp(0.0, 16.0 * size);
        self.joint.rows.clear();
        self.depths.clear();
        let most = longest as usize + ROWS;
        self.joint.rows.reserve(most);
        self.depths.reserve(most);
        let finite = start.x.is_finite() && start.y.is_finite() && start.direction.is_finite();
        if !finite || !inside.holds([start.x, start.y]) {
            self.joint.end = End::LeftImage;
            return &self.joint;
        }
        self.joint.end = match self.begin(frame, start) {
            None => End::Lost,
            Some(track) => self.go_on(frame, track, &inside, longest),
        };
        judge(&mut self.joint);
        &self.joint
    }

    /// Width, heading and contrast at the start, if a joint is there.
    fn begin(&mut self, frame: &Frame, start: &Start) -> Option<Track> {
        let known = start.width.filter(|w| w.is_finite() && *w > 0.0).map(|w| w.clamp(1.0, 400.0));
        let mut best: Option<(f32, f32, Axis)> = None;
        let widths = known.as_ref().map_or(&WIDTHS[..], std::slice::from_ref);
        for &width in widths {
            let axis = Axis {
                x: start.x,
                y: start.y,
                heading: start.direction,
                curvature: 0.0,
                along: 1.0,
                across: 1.0,
                origin: 0,
            };
            let axis = axis.for_width(width);
            let view = self.look(frame, &axis, width, None, 1.0);
            let support = view.supported.iter().filter(|s| **s).count() as f32;
            let strength = view.strength * support / ROWS as f32;
            if best.is_none_or(|(s, _, _)| strength > s) {
                let rows = (0..ROWS).filter(|i| view.supported[*i]);
                let (_, slope) = line(rows.map(|i| (i as f32, view.middle[i], 1.0))).unwrap_or_default();
                best = Some((
                    strength,
                    width,
                    Axis { heading: axis.heading + (slope * axis.across / axis.along).atan(), ..axis },
                ));
            }
        }
        let (_, mut width, axis) = best?;
        // Once more along the line itself.
        let view = self.look(frame, &axis, width, None, 1.5);
        let support = view.supported.iter().filter(|s| **s).count() as f32;
        if support < START_SUPPORT * ROWS as f32 {
            return None;
        }
        if known.is_none() {
            let found = full_width(&self.strip, &view.middle, &view.supported, width / axis.across);
            width = found.map_or(width, |w| (w * axis.across).clamp(0.6 * width, 1.8 * width));
        }
        Some(Track { axis: axis.for_width(width), width, contrast: view.contrast, gap: 0, seen: 0 })
    }

    fn go_on(&mut self, frame: &Frame, mut track: Track, inside: &Inside, longest: f32) -> End {
        let mut gone = 0.0;
        loop {
            let free = 1.5 + 0.08 * track.gap as f32;
            let view = self.look(frame, &track.axis, track.width, Some(track.contrast), free);
            let drift = drift(&view);
            for i in track.axis.origin..track.axis.origin + TAKEN {
                let supported = view.supported[i];
                let across = if supported { view.middle[i] } else { drift.at(i as f32) };
                let place = track.axis.beside(i as f32, across);
                if !inside.holds(place) {
                    self.joint.rows.truncate(track.seen.max(self.joint.rows.len().saturating_sub(track.gap)));
                    // What was coasted over up to the rim was not seen to end.
                    return self.finish(&track, End::LeftImage);
                }
                if gone > longest {
                    return self.finish(&track, End::LeftImage);
                }
                gone += track.axis.along;
                let column = (across + HALF as f32).round().max(0.0) as usize;
                self.depths.push(self.strip.row_depth(i, column, track.width / track.axis.across));
                let state = if supported { State::Seen } else { State::Coasted };
                let confidence = if supported { view.confidence[i] } else { 0.0 };
                self.joint.rows.push(Row { x: place[0], y: place[1], confidence, width: track.width, state });
                track.gap = if supported { 0 } else { track.gap + 1 };
                if supported {
                    track.seen = self.joint.rows.len();
                    if self.is_closed(gone, track.axis.along) {
                        return End::Closed;
                    }
                }
                if track.gap as f32 * track.axis.along > self.options.gap {
                    return self.finish(&track, End::Lost);
                }
            }
            track.advance(&view, &drift, &self.strip);
        }
    }

    /// The strip along `axis`, the joint in it and how sure that is. `contrast` as it was before, if it is known.
    fn look(&mut self, frame: &Frame, axis: &Axis, width: f32, contrast: Option<f32>, free: f32) -> View {
        let columns = width / axis.across;
        self.strip.fill(frame, axis, columns);
        let apart = (2.0 * columns).ceil().max(4.0) as usize;
        self.paths.find(&self.strip, free, apart);
        let (strip, best, rival) = (&self.strip, &self.paths.best, &self.paths.rival);
        let depth = |i: usize, j: usize| strip.depth[i][j];
        let alike = |d: f32| contrast.is_none_or(|c| d > c / CONTRAST_FACTOR && d < c * CONTRAST_FACTOR);
        let mut supported = [false; ROWS];
        for (i, supported) in supported.iter_mut().enumerate() {
            let near = around(i, NEIGHBOURS);
            let out = near.clone().filter(|k| depth(*k, best[*k]) > STANDS_OUT * strip.noise).count();
            let mean = near.clone().map(|k| depth(k, best[k])).sum::<f32>() / near.len() as f32;
            *supported = 2 * out >= near.len() && alike(mean);
        }
        let (middle, error) = midline(strip, best, &supported, columns);
        let (right, bottom) = ((frame.width() - 1) as f32, (frame.height() - 1) as f32);
        let inside_frame = |x: f32, y: f32| (0.0..=right).contains(&x) && (0.0..=bottom).contains(&y);
        let mut confidence = [0.0; ROWS];
        for (i, confidence) in confidence.iter_mut().enumerate() {
            let near = around(i, AROUND);
            let mean = |path: &[usize; ROWS]| {
                near.clone().map(|k| (depth(k, path[k]) / strip.noise - EVIDENCE_FROM).max(0.0)).sum::<f32>()
                    / near.len() as f32
            };
            let (ours, theirs) = (mean(best), mean(rival));
            let part = near.clone().filter(|k| supported[*k]).count() as f32 / near.len() as f32;
            let margin = ((ours - theirs) / ours.max(1e-6) / 0.5).clamp(0.0, 1.0);
            // A midline away from its path is on something else.
            let off = (middle[i] + HALF as f32 - best[i] as f32).abs() / (0.5 * columns + 1.0);
            // Where one side is much darker than the other it may be a shadow's rim; at the frame's rim a side is missing.
            let (even, least) = (strip.even[i][best[i]], depth(i, best[i]));
            let alike = (1.5 - (even - least) / least.max(1e-3)).clamp(0.0, 1.0);
            let rims = [-1.0, 1.0].map(|side| axis.beside(i as f32, middle[i] + side * 1.5 * columns));
            let whole = if rims.iter().all(|[x, y]| inside_frame(*x, *y)) { 1.0 } else { 0.0 };
            let sure = (ours / 3.5).clamp(0.0, 1.0) * margin * part * (2.0 - off).clamp(0.0, 1.0);
            let exact = (2.0 - error[i] * axis.across / KNOWN_TO).clamp(0.0, 1.0);
            let lone = (2.0 - odd(strip, &middle, i, columns) / (ODD * least.max(1e-3))).clamp(0.0, 1.0);
            *confidence = sure * alike * whole * exact * lone;
        }
        let count = supported.iter().filter(|s| **s).count().max(1) as f32;
        let contrast = (0..ROWS).filter(|i| supported[*i]).map(|i| depth(i, best[i])).sum::<f32>() / count;
        View { supported, middle, confidence, contrast, strength: contrast * width.sqrt() }
    }

    fn is_closed(&self, gone: f32, step: f32) -> bool {
        let rows = &self.joint.rows;
        let away = |a: &Row, b: &Row| (a.x - b.x).hypot(a.y - b.y);
        let (Some(first), Some(second)) = (rows.first(), rows.get(NEIGHBOURS)) else { return false };
        let [.., before, last] = &rows[rows.len().saturating_sub(NEIGHBOURS)..] else { return false };
        if gone < 60.0 * step || away(first, last) > CLOSED.0 * step {
            return false;
        }
        let heading = |a: &Row, b: &Row| (b.y - a.y).atan2(b.x - a.x);
        let back = rows.len().saturating_sub(NEIGHBOURS + 1);
        let turn = heading(first, second) - heading(rows.get(back).unwrap_or(before), last);
        turn.sin().abs() < CLOSED.1.sin() && turn.cos() > 0.0
    }

    /// Cuts off what was coasted over last, and tells an end of the joint from its loss.
    fn finish(&mut self, track: &Track, end: End) -> End {
        let seen = track.seen;
        let rows = &mut self.joint.rows;
        if seen == 0 {
            rows.clear();
            return End::Lost;
        }
        if end != End::Lost {
            rows.truncate(seen);
            return end;
        }
        // Where depths fall from the joint's to none: most above half of it before and most below it after.
        let from = seen.saturating_sub(ROWS / 2);
        let to = (seen + ROWS / 2).min(rows.len());
        let (mut sum, mut greatest, mut at) = (0.0, f32::MIN, seen);
        for (i, depth) in self.depths[from..to].iter().enumerate() {
            sum += depth - 0.5 * track.contrast;
            if sum > greatest {
                (greatest, at) = (sum, from + i + 1);
            }
        }
        let last = rows[seen - 1];
        let sure = rows[seen.saturating_sub(TAKEN)..seen].iter().filter(|r| r.confidence >= CONFIDENT).count();
        for row in &mut rows[seen..at.max(seen)] {
            (row.state, row.confidence) = (State::Seen, last.confidence.min(0.9 * CONFIDENT));
        }
        let after = &self.depths[at..];
        let mean = after.iter().sum::<f32>() / after.len().max(1) as f32;
        let scatter = after.iter().map(|d| (d - mean).powi(2)).sum::<f32>() / after.len().max(1) as f32;
        let error = (scatter / after.len().max(1) as f32).sqrt();
        rows.truncate(at);
        let clear = mean.abs() + 3.0 * error < 0.4 * track.contrast;
        if clear && 4 * sure >= 3 * TAKEN.min(seen) { End::JointEnd } else { End::Lost }
    }
}

fn around(i: usize, reach: usize) -> std::ops::Range<usize> {
    i.saturating_sub(reach)..(i + reach + 1).min(ROWS)
}

/// Frame and zone.
struct Inside {
    zone: Zone,
    right: f32,
    bottom: f32,
}

impl Inside {
    fn holds(&self, [x, y]: [f32; 2]) -> bool {
        let Zone { left, top, right, bottom } = self.zone;
        x >= left.max(0.0) && x <= right.min(self.right) && y >= top.max(0.0) && y <= bottom.min(self.bottom)
    }
}

/// Where the joint goes beside the axis: a parabola through its supported rows.
struct Drift {
    offset: f32,
    slope: f32,
    bend: f32,
    /// Enough rows were supported.
    known: bool,
}

impl Drift {
    fn at(&self, i: f32) -> f32 {
        let v = i - MID;
        self.offset + self.slope * v + self.bend * v * v
    }
}

/// Rows the way on is fitted to: what comes late in a strip may be another joint that comes near.
const FITTED: usize = 48;
const MID: f32 = (FITTED / 2) as f32;

fn drift(view: &View) -> Drift {
    let rows = (0..FITTED).filter(|i| view.supported[*i]).map(|i| (i as f32 - MID, view.middle[i], 1.0));
    let count = rows.clone().count();
    let none = Drift { offset: 0.0, slope: 0.0, bend: 0.0, known: false };
    let Some((offset, slope)) = line(rows.clone()).filter(|_| count >= FITTED / 4) else { return none };
    if count < 3 * FITTED / 4 {
        return Drift { offset, slope, bend: 0.0, known: true };
    }
    // The bend from what is left of the line, against the even polynomial that is orthogonal to it over all rows.
    let square = |v: f32| v * v - MID * MID / 3.0;
    let (mut product, mut norm) = (0.0, 0.0);
    for (v, x, _) in rows {
        product += square(v) * (x - offset - slope * v);
        norm += square(v) * square(v);
    }
    let bend = product / norm;
    Drift { offset: offset - bend * MID * MID / 3.0, slope, bend, known: true }
}

impl Track {
    /// On to the next strip; heading, curvature, width and contrast from supported rows only.
    fn advance(&mut self, view: &View, drift: &Drift, strip: &Strip) {
        let at = (self.axis.origin + TAKEN) as f32;
        let across = drift.at(at);
        let [x, y] = self.axis.beside(at, across);
        let Axis { along, across: pitch, .. } = self.axis;
        let turn = TAKEN as f32 * along * self.axis.curvature;
        let slope = (drift.slope + 2.0 * drift.bend * (at - MID)) * pitch / along;
        let heading = self.axis.heading + turn + if drift.known { slope.atan() } else { 0.0 };
        let bent = (self.axis.curvature + 2.0 * drift.bend * pitch / (along * along)).clamp(-MOST_BENT, MOST_BENT);
        let curvature = if drift.known { bent } else { 0.7 * self.axis.curvature };
        self.axis = Axis { x, y, heading, curvature, origin: BACK, ..self.axis };
        if !drift.known {
            return;
        }
        self.contrast += 0.4 * (view.contrast - self.contrast);
        if let Some(found) = full_width(strip, &view.middle, &view.supported, self.width / pitch) {
            let found = (found * pitch).clamp(self.width / 1.5, 1.5 * self.width);
            self.width = (self.width + 0.3 * (found - self.width)).clamp(1.0, 400.0);
            self.axis = self.axis.for_width(self.width);
        }
    }
}
