use super::events::{Answer, Command, End, Event, EyePose, Seen};
use super::line::{GAP_MM, RawPoint, Source, TaughtLine};
use super::sight::{Aim, FrameEnd, Patch, Shape, Surface, View};
use super::{EyeNote, Settings, levelled};
use glam::DVec3;
use seamwright_vision::camera::{HeightError, HeightTable};

/// Points of this stretch to both sides tell the line's direction, mm.
const REACH_MM: f64 = 2.0;
/// Length without a gap on which a frame's midline may begin, mm.
const STRETCH_MM: f64 = 8.0;
/// The frame's midline begins at least so far from its rim, pixels.
const MARGIN_PX: f64 = 12.0;
/// Steps that turn by more say nothing of how the joint goes on, rad.
const MOST_TURN: f64 = 0.5;
/// Rows to both sides that tell the joint's direction in a frame.
const ABOUT: usize = 10;
/// Fewest rows on the overlap that say whether two frames agree.
const FEWEST: usize = 5;
/// An operator's point that the eye sees within this distance is replaced by what it sees, mm.
const REPLACED_MM: f64 = 1.5;
/// An operator's point at which nothing was seen is replaced by his next one within this distance, mm.
const INSTEAD_MM: f64 = 5.0;

/// The crawl along a joint.
pub struct Crawl<'a> {
    settings: Settings,
    table: &'a HeightTable,
    shape: &'a dyn Shape,
    line: TaughtLine,
    notes: Vec<EyeNote>,
    /// Where the eye is or goes, and how far along the line that is.
    target: EyePose,
    way: f64,
    /// How far along the line the eye was before.
    before: f64,
    /// The line does not lead here: the start, or a point of the operator's.
    fresh: bool,
    /// Direction at the start of the line.
    first: Option<DVec3>,
    again: u32,
    shortened: u32,
    done: Option<End>,
}

impl<'a> Crawl<'a> {
    /// A crawl from `start`, whose `along` need only be rough, of an eye with the map `table` over a surface of which
    /// `shape` is known.
    pub fn new(settings: Settings, table: &'a HeightTable, shape: &'a dyn Shape, start: EyePose) -> Self {
        Self {
            settings,
            table,
            shape,
            line: TaughtLine::default(),
            notes: Vec::new(),
            target: start,
            way: 0.0,
            before: 0.0,
            fresh: true,
            first: None,
            again: 0,
            shortened: 0,
            done: None,
        }
    }

    /// What was found so far.
    pub fn line(&self) -> &TaughtLine {
        &self.line
    }

    /// The same with its heights between frames as all frames together measured them.
    pub fn levelled(&self) -> TaughtLine {
        levelled(&self.line, &self.notes)
    }

    /// A note of each frame so far.
    pub fn notes(&self) -> &[EyeNote] {
        &self.notes
    }

    /// Where the eye is or goes.
    pub fn target(&self) -> &EyePose {
        &self.target
    }

    /// What to do after `event`. After [`Command::Done`] there is nothing else.
    pub fn next(&mut self, event: Event) -> Command {
        if let Some(end) = &self.done {
            return Command::Done(end.clone());
        }
        let command = match event {
            Event::Start => Command::Move(self.target),
            Event::Reached => Command::Look,
            Event::Refused(why) => self.refused(why),
            Event::Seen(seen) => self.seen(&seen),
            Event::Operator(Answer::Point(point, along)) => self.resumed(point, along),
            Event::Operator(Answer::End) => Command::Done(End::Operator),
        };
        if let Command::Done(end) = &command {
            self.done = Some(end.clone());
        }
        command
    }

    /// Where to look for the midline in a frame taken from `view`: a little behind the eye, on the line that is known.
    ///
    /// # Errors
    /// The work is not where the camera sees it: too near, too far, beyond the picture.
    pub fn aim(&self, view: &View) -> Result<Aim, HeightError> {
        let surface = self.surface(view);
        let (start, along) = self.begin(&surface);
        let px = surface.px(start)?;
        let ahead = surface.px(start + 0.5 * along)?;
        Ok(Aim { start: px, direction: (ahead - px).normalize_or_zero(), by_hand: self.fresh })
    }

    fn surface(&self, view: &View) -> Surface<'a> {
        let eye = view.height.map(|height| view.camera.transform_point3(DVec3::Z * height));
        let normal = eye.map_or(self.target.normal, |eye| self.carried(eye, 0.0));
        Surface::new(self.table, self.shape, view, Patch { point: self.target.point, normal })
    }

    /// The normal carried on to `eye` square to the joint, and `ahead` mm further: the joint's direction from where the eyes
    /// of the last frames met the work, since a single frame knows nothing of its tilt.
    fn carried(&self, eye: DVec3, ahead: f64) -> DVec3 {
        let mut eyes = vec![eye];
        for note in self.notes.iter().rev().filter(|note| note.agrees) {
            if eyes.len() < 3 && eyes[eyes.len() - 1].distance(note.eye) > self.settings.least_step_mm {
                eyes.push(note.eye);
            }
        }
        let step = |i: usize| eyes.get(i + 1).map(|before| eyes[i] - before);
        let Some(last) = step(0) else { return self.target.normal };
        let here = last.normalize();
        // A chord has the direction of its middle; what two of them turn by goes on.
        let turned = step(1).map(DVec3::normalize).filter(|before| before.dot(here) > MOST_TURN.cos());
        let along = turned.map_or(here, |before| here + (0.5 + ahead / last.length()) * (here - before)).normalize();
        self.target.normal.reject_from_normalized(along).try_normalize().unwrap_or(self.target.normal)
    }

    /// Where the midline begins: up to the overlap behind the eye, where the line was seen and is in the frame.
    fn begin(&self, surface: &Surface) -> (DVec3, DVec3) {
        let given = (self.target.point, self.target.along);
        if self.fresh {
            return given;
        }
        let ways = self.line.ways();
        let wanted = ways.partition_point(|w| *w <= self.way - self.settings.overlap_mm);
        // Onto a stretch with points, long enough to find the joint anew: back before a gap.
        let seen = |i: usize| {
            let (from, to) = (i.saturating_sub(FEWEST), ways.partition_point(|w| *w <= ways[i] + STRETCH_MM));
            ways.len() > i + FEWEST
                && ways[from..to].windows(2).all(|w| w[1] - w[0] <= GAP_MM)
                && surface.px(self.line.points()[i].point).is_ok_and(|px| surface.in_frame(px, MARGIN_PX))
        };
        let behind =
            (0..wanted.min(ways.len())).rev().take_while(|i| self.way - ways[*i] < 8.0 * self.settings.overlap_mm);
        let mut found = behind.filter(|&i| seen(i));
        let ahead = (wanted..ways.len()).find(|&i| seen(i));
        let Some(i) = found.next().or(ahead) else { return given };
        let along = self.line.direction(ways[i], REACH_MM).unwrap_or(self.target.along);
        (self.line.points()[i].point, along)
    }

    fn refused(&mut self, why: String) -> Command {
        // Half way there, and half of that; the line is known up to the target.
        self.shortened += 1;
        let step = self.way - self.before;
        if self.fresh && self.line.points().last().is_some_and(|p| p.source == Source::Operator) {
            // Another point of the operator's, then.
            self.line.pop();
            return Command::Ask(why);
        }
        if self.shortened > 3 || self.fresh || 0.5 * step < self.settings.least_step_mm {
            return Command::Done(End::Limit(why));
        }
        self.go_to(self.before + 0.5 * step)
    }

    /// The eye to the place `way` along the line.
    fn go_to(&mut self, way: f64) -> Command {
        let Some(point) = self.line.at(way) else { return Command::Done(End::Operator) };
        let along = self.line.direction(way, REACH_MM).unwrap_or(self.target.along);
        let ahead = way - self.way;
        let eye = self.notes.last().map_or(point, |note| note.eye);
        let normal = self.shape.near(point).map_or_else(|| self.carried(eye, ahead), |patch| patch.normal);
        (self.target, self.way, self.fresh) = (EyePose { point, normal, along }, way, false);
        Command::Move(self.target)
    }

    fn resumed(&mut self, point: DVec3, along: Option<DVec3>) -> Command {
        let corrects = |p: &RawPoint| p.source == Source::Operator && p.point.distance(point) < INSTEAD_MM;
        if self.fresh && self.line.points().last().is_some_and(corrects) {
            self.line.pop();
        }
        let last = self.line.points().last().map_or(self.target.point, |p| p.point);
        let chord = (point - last).try_normalize().unwrap_or(self.target.along);
        let along = along.and_then(DVec3::try_normalize).unwrap_or(chord);
        let normal = self.shape.near(point).map_or(self.target.normal, |patch| patch.normal);
        let frame = self.notes.len().saturating_sub(1);
        let ray = -normal;
        self.line.push(RawPoint { point, normal, ray, confidence: 1.0, frame, source: Source::Operator }, None);
        (self.way, self.before) = (self.line.length(), self.line.length());
        (self.target, self.fresh, self.again) = (EyePose { point, normal, along }, true, 0);
        Command::Move(self.target)
    }

    fn seen(&mut self, seen: &Seen) -> Command {
        self.shortened = 0;
        let surface = self.surface(&seen.view);
        let frame = self.notes.len();
        let confident = seen.rows.iter().filter(|r| r.seen && r.confidence >= self.settings.confidence);
        let points: Vec<RawPoint> = confident
            .filter_map(|row| {
                let (point, ray) = surface.point(row.px).ok()?;
                let normal = surface.normal(point);
                Some(RawPoint { point, normal, ray, confidence: row.confidence, frame, source: Source::Eye })
            })
            .collect();
        let overlap = self.overlap(&points);
        let mean = points.iter().map(|p| p.confidence).fold(0.0, |a, b| a + b) / points.len().max(1) as f64;
        // What begins on the known line and is nowhere near it is something else.
        let agrees = overlap.map_or(self.fresh || points.is_empty(), |off| off <= self.settings.agree_mm);
        self.notes.push(EyeNote {
            eye: surface.on_axis(),
            raised_mm: surface.raised(),
            measured: seen.view.height.is_some(),
            way: self.way,
            rows: points.len(),
            confidence: mean,
            overlap_mm: overlap,
            end: seen.end,
            agrees,
        });
        if !agrees {
            return self.look_again(overlap.map_or_else(
                || "what is seen does not join what was seen before".to_owned(),
                |off| format!("what two frames see of the joint is {off:.2} mm apart"),
            ));
        }
        if points.is_empty() {
            return self.look_again("the joint is not seen".to_owned());
        }
        self.take(&points);
        self.onward(seen.end, mean)
    }

    /// Median distance of what a frame sees from what the frames before saw of it, where they overlap.
    fn overlap(&self, points: &[RawPoint]) -> Option<f64> {
        let from = self.way - 2.0 * self.settings.overlap_mm;
        let mut off: Vec<f64> = points.iter().filter_map(|p| self.line.distance(p, from)).collect();
        if off.len() < FEWEST || self.fresh {
            return None;
        }
        let middle = off.len() / 2;
        Some(*off.select_nth_unstable_by(middle, f64::total_cmp).1)
    }

    /// Puts what a frame sees into the line: beyond the middle between this eye and the one before, this frame was nearer.
    fn take(&mut self, points: &[RawPoint]) {
        let replaces = |p: &RawPoint| {
            p.source == Source::Operator && points.iter().any(|q| q.point.distance(p.point) < REPLACED_MM)
        };
        let replaced = self.fresh && self.line.points().last().is_some_and(replaces);
        if replaced {
            let before = self.line.ways().iter().rev().nth(1).copied().unwrap_or(-1.0);
            self.line.cut(before);
        } else if !self.fresh {
            self.line.cut(0.5 * (self.before + self.way));
        }
        let after = self.line.points().last().map_or(0, |last| {
            let by = |i: &usize, j: &usize| {
                points[*i].point.distance(last.point).total_cmp(&points[*j].point.distance(last.point))
            };
            let nearest = (0..points.len()).min_by(by).unwrap_or(0);
            // Only what lies ahead of the last point, or all of it beyond a gap.
            let ahead = |i: usize| {
                let on = points.get(i + 1).map_or(DVec3::ZERO, |next| next.point - points[i].point);
                (points[i].point - last.point).dot(on) > 0.0
            };
            if ahead(nearest) { nearest } else { nearest + 1 }
        });
        for (i, point) in points.iter().enumerate().skip(after) {
            let (a, b) = (points[i.saturating_sub(ABOUT)], points[(i + ABOUT).min(points.len() - 1)]);
            self.line.push(*point, (b.point - a.point).try_normalize());
            if replaced && i == after {
                (self.way, self.before) = (self.line.length(), self.line.length());
            }
        }
        if self.first.is_none() {
            self.first = self.line.direction(0.0, 2.0 * REACH_MM);
        }
    }

    fn onward(&mut self, end: FrameEnd, confidence: f64) -> Command {
        // The eye is on the line that the frame has just shown, which may lie a little beside the one before.
        let closes = self.closes();
        let last = closes.map_or(self.line.length(), |(way, _)| way);
        let ahead = last - self.way;
        if ahead < self.settings.least_step_mm {
            match (closes, end) {
                (Some((way, gap_mm)), _) => {
                    self.line.cut(way);
                    return Command::Done(End::Closed { gap_mm });
                }
                (None, FrameEnd::JointEnd) if self.way >= self.settings.ends_after_mm => {
                    return Command::Done(End::JointEnd);
                }
                (None, FrameEnd::JointEnd) => {
                    let why = "the joint is seen no further: it ends here, or more than the longest tack hides it";
                    return self.look_again(why.to_owned());
                }
                _ => return self.look_again("the joint is not seen any further".to_owned()),
            }
        }
        self.again = 0;
        if self.way > self.settings.longest_mm {
            return Command::Done(End::TooLong);
        }
        let step = self.step(confidence).min(ahead);
        self.before = self.way;
        self.go_to(self.way + step)
    }

    /// The next step: shorter where the joint turns or is seen badly, mm.
    fn step(&self, confidence: f64) -> f64 {
        let Settings { step_mm, least_step_mm, turn, confidence: least, .. } = self.settings;
        let part = ((confidence - least) / (1.0 - least)).clamp(0.25, 1.0);
        let mut step = step_mm * part.sqrt();
        let Some(here) = self.line.direction(self.way, REACH_MM) else { return step };
        while step > 2.0 * least_step_mm
            && self.line.direction(self.way + step, REACH_MM).is_some_and(|there| here.dot(there) < turn.cos())
        {
            step *= 0.7;
        }
        step
    }

    /// Where the line passes its start again, if it does: the way, and how far beside it, mm.
    fn closes(&self) -> Option<(f64, f64)> {
        let Settings { close_mm, close_angle, close_after_mm, .. } = self.settings;
        let (first, along) = (self.line.points().first()?.point, self.first?);
        let ways = self.line.ways();
        let from = ways.partition_point(|w| *w < close_after_mm.max(self.before - 2.0 * close_mm));
        let passes = |i: &usize| {
            let (a, b) = (self.line.points()[i - 1].point - first, self.line.points()[*i].point - first);
            a.dot(along) < 0.0 && b.dot(along) >= 0.0 && b.length() < close_mm
        };
        let i = (from.max(1)..ways.len()).find(passes)?;
        let aligned = self.line.direction(ways[i], REACH_MM)?.dot(along) > close_angle.cos();
        let off = self.line.points()[i].point - first;
        aligned.then(|| (ways[i], (off - off.dot(along) * along).length()))
    }

    fn look_again(&mut self, why: String) -> Command {
        self.again += 1;
        if self.again <= self.settings.again { Command::Look } else { Command::Ask(why) }
    }
}
