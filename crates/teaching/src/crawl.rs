use crate::events::{Answer, CameraPose, Command, End, Event, Seen};
use crate::frame_note::CameraNote;
use crate::height::levelled;
use crate::settings::Settings;
use crate::taught_line::{GAP_MM, RawPoint, Source, TaughtLine};
use crate::work_shape::{Aim, FrameEnd, Patch, Shape, Surface, View};
use glam::DVec3;
use seamwright_message::{Message, Unit};
use seamwright_vision::camera::{HeightError, HeightTable};

/// Reach to both sides for the line's direction, mm.
const REACH_MM: f64 = 2.0;
/// Length without a gap required at the start of a frame's midline, mm.
const STRETCH_MM: f64 = 8.0;
/// Minimum distance of the midline's start from the frame's edge, pixels.
const MARGIN_PX: f64 = 12.0;
/// Maximum turn between two steps that predicts the next direction of the joint, rad.
const MAX_TURN: f64 = 0.5;
/// Number of rows to both sides for the joint's direction in a frame.
const ABOUT: usize = 10;
/// Minimum number of overlapping rows to compare two frames.
const FEWEST: usize = 5;
/// Maximum distance at which a detected point replaces an operator's point, mm.
const REPLACED_MM: f64 = 1.5;
/// Maximum distance at which the operator's next point replaces one without a detection, mm.
const INSTEAD_MM: f64 = 5.0;

/// Follows a joint with the camera, frame by frame.
pub struct Crawl<'a> {
    settings: Settings,
    table: &'a HeightTable,
    shape: &'a dyn Shape,
    line: TaughtLine,
    notes: Vec<CameraNote>,
    /// Current or commanded camera pose, and its distance along the line, mm.
    target: CameraPose,
    way: f64,
    /// Previous distance of the camera along the line, mm.
    before: f64,
    /// The target is the start or an operator's point instead of a point of the line.
    fresh: bool,
    /// Direction at the start of the line.
    first: Option<DVec3>,
    again: u32,
    shortened: u32,
    done: Option<End>,
}

impl<'a> Crawl<'a> {
    /// Creates a crawl from `start`, whose `along` may be rough, for a camera with the map `table` over the known
    /// surface `shape`.
    pub fn new(settings: Settings, table: &'a HeightTable, shape: &'a dyn Shape, start: CameraPose) -> Self {
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

    /// Returns the line found so far.
    pub fn line(&self) -> &TaughtLine {
        &self.line
    }

    /// Returns the line with heights between frames fitted to the measurements of all frames.
    pub fn levelled(&self) -> TaughtLine {
        levelled(&self.line, &self.notes)
    }

    /// Returns a note of each frame so far.
    pub fn notes(&self) -> &[CameraNote] {
        &self.notes
    }

    /// Returns the current or commanded camera pose.
    pub fn target(&self) -> &CameraPose {
        &self.target
    }

    /// Returns the command after `event`; after [`Command::Done`] always the same one.
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

    /// Returns the start of the midline search in a frame taken from `view`: slightly behind the camera, on the known
    /// line.
    ///
    /// # Errors
    /// [`HeightError`] if the work is too near, too far, or beyond the picture.
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

    /// Returns the normal at `eye`, and `ahead` mm further, perpendicular to the joint. The joint's direction comes
    /// from the axis points of the last frames, because a single frame cannot measure its tilt.
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
        // A chord has the direction of its middle; the turn between two chords is extrapolated.
        let turned = step(1).map(DVec3::normalize).filter(|before| before.dot(here) > MAX_TURN.cos());
        let along = turned.map_or(here, |before| here + (0.5 + ahead / last.length()) * (here - before)).normalize();
        self.target.normal.reject_from_normalized(along).try_normalize().unwrap_or(self.target.normal)
    }

    /// Returns the midline's start: up to the overlap behind the camera, on a detected stretch inside the frame.
    fn begin(&self, surface: &Surface) -> (DVec3, DVec3) {
        let given = (self.target.point, self.target.along);
        if self.fresh {
            return given;
        }
        let ways = self.line.ways();
        let wanted = ways.partition_point(|w| *w <= self.way - self.settings.overlap_mm);
        // The stretch must be gap-free and long enough to find the joint again; before a gap the search goes back.
        let seen = |i: usize| {
            let (from, to) = (i.saturating_sub(FEWEST), ways.partition_point(|w| *w <= ways[i] + STRETCH_MM));
            ways.len() > i + FEWEST
                && ways[from..to].windows(2).all(|w| w[1] - w[0] <= GAP_MM)
                && surface.px(self.line.points()[i].point).is_ok_and(|px| surface.in_frame(px, MARGIN_PX))
        };
        let behind =
            (0..wanted.min(ways.len())).rev().take_while(|i| self.way - ways[*i] < 8.0 * self.settings.overlap_mm);
        let mut found = behind.filter(|&i| seen(i));
        let Some(i) = found.next().or((wanted..ways.len()).find(|&i| seen(i))) else { return given };
        (self.line.points()[i].point, self.line.direction(ways[i], REACH_MM).unwrap_or(self.target.along))
    }

    fn refused(&mut self, why: Message) -> Command {
        // Halves the step each time; the line is known up to the target.
        self.shortened += 1;
        let step = self.way - self.before;
        if self.fresh && self.line.points().last().is_some_and(|p| p.source == Source::Operator) {
            // The operator has to give another point.
            self.line.pop();
            return Command::Ask(why);
        }
        if self.shortened > 3 || self.fresh || 0.5 * step < self.settings.least_step_mm {
            return Command::Done(End::Limit(why));
        }
        self.go_to(self.before + 0.5 * step)
    }

    /// Commands the camera to `way` mm along the line.
    fn go_to(&mut self, way: f64) -> Command {
        let Some(point) = self.line.at(way) else { return Command::Done(End::Operator) };
        let along = self.line.direction(way, REACH_MM).unwrap_or(self.target.along);
        let ahead = way - self.way;
        let eye = self.notes.last().map_or(point, |note| note.eye);
        let normal = self.shape.near(point).map_or_else(|| self.carried(eye, ahead), |patch| patch.normal);
        (self.target, self.way, self.fresh) = (CameraPose { point, normal, along }, way, false);
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
        (self.target, self.fresh, self.again) = (CameraPose { point, normal, along }, true, 0);
        Command::Move(self.target)
    }

    fn seen(&mut self, seen: &Seen) -> Command {
        self.shortened = 0;
        let surface = self.surface(&seen.view);
        let frame = self.notes.len();
        let points: Vec<RawPoint> = seen
            .rows
            .iter()
            .filter(|r| r.seen && r.confidence >= self.settings.confidence)
            .filter_map(|row| {
                let (point, ray) = surface.point(row.px).ok()?;
                let normal = surface.normal(point);
                Some(RawPoint { point, normal, ray, confidence: row.confidence, frame, source: Source::Eye })
            })
            .collect();
        let overlap = self.overlap(&points);
        let mean = points.iter().map(|p| p.confidence).fold(0.0, |a, b| a + b) / points.len().max(1) as f64;
        // A midline that starts on the known line without any overlap belongs to another feature.
        let agrees = overlap.map_or(self.fresh || points.is_empty(), |off| off <= self.settings.agree_mm);
        self.notes.push(CameraNote {
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
                || Message::new("tracking-crawl-not-joined"),
                |off| Message::new("tracking-crawl-frames-apart").quantity("distance", off, Unit::Mm, 2),
            ));
        }
        if points.is_empty() {
            return self.look_again(Message::new("tracking-crawl-not-seen"));
        }
        self.take(&points);
        self.onward(seen.end, mean)
    }

    /// Returns the median distance of a frame's points from the known line in their overlap, mm.
    fn overlap(&self, points: &[RawPoint]) -> Option<f64> {
        let from = self.way - 2.0 * self.settings.overlap_mm;
        let mut off: Vec<f64> = points.iter().filter_map(|p| self.line.distance(p, from)).collect();
        if off.len() < FEWEST || self.fresh {
            return None;
        }
        let middle = off.len() / 2;
        Some(*off.select_nth_unstable_by(middle, f64::total_cmp).1)
    }

    /// Adds a frame's points to the line. They replace it beyond the middle of both camera positions, where this frame
    /// is nearer.
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
            // Only points ahead of the last one, or all of them beyond a gap.
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
        // Distances count along the line with this frame's points, which may lie slightly beside the previous line.
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
                    return self.look_again(Message::new("tracking-crawl-end-or-tack"));
                }
                _ => return self.look_again(Message::new("tracking-crawl-not-seen-further")),
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

    /// Returns the next step, mm: shorter where the joint turns or has low confidence.
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

    /// Returns the distance along the line at which it passes its start again, and the lateral gap there, mm.
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

    fn look_again(&mut self, why: Message) -> Command {
        self.again += 1;
        if self.again <= self.settings.again { Command::Look } else { Command::Ask(why) }
    }
}
