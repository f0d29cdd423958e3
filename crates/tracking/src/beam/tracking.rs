use super::beam_authority::{BeamAuthority, SOON_S, Shares};
use super::picture::{Course, PLACES, Place, located, on_one_line};
use super::{Beam, Error, Picture, Schedule, Settings, Taken, Zone};
use crate::actuator::{Alarm, DeflectionLimits, Following, SlideLimits};
use crate::lead::{Estimate, Moment, OwnCurve, Refusal, Sight, Tracker};
use arrayvec::ArrayVec;
use glam::DVec2;

/// Slowest that the torch goes while a correction fades out, as a part of its speed.
const FADING_SPEED: f64 = 0.25;
/// As many periods without a picture of use are worth a warning.
const BLIND_PERIODS: f64 = 2.5;

/// A seam that is seen so much beside where it is known to be, mm, is another line, or the part has moved.
const ELSEWHERE_MM: f64 = 0.3;

/// What is to be done in the next cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orders {
    /// What the beam does.
    pub beam: Beam,
    /// By how much the beam is deflected sideways while it welds, mm.
    pub deflection_mm: f64,
    /// By how much the axes carry the gun sideways, mm: a set-point in the torch's frame.
    pub carried_mm: f64,
    /// Greatest part of its speed that the torch may have; 0: stop.
    pub pace: f64,
    /// The worst that is wrong.
    pub alarm: Option<Alarm>,
    /// What is known of the seam at the torch.
    pub estimate: Estimate,
}

/// Tracking with the beam that welds.
#[derive(Clone)]
pub struct BeamTracking<'a> {
    settings: Settings,
    seam: Course<'a>,
    schedule: Schedule,
    tracker: Tracker,
    authority: BeamAuthority,
    following: Following,
    zone: Zone,
    carried: f64,
    taken_s: Option<f64>,
    /// First and last point of the picture before.
    before: [DVec2; 2],
    /// By how much the picture before showed the seam elsewhere, mm.
    elsewhere: Option<f64>,
}

impl<'a> BeamTracking<'a> {
    /// On the nominal `seam`, corrected by the deflection and by `axes` that carry the gun.
    ///
    /// # Errors
    /// Those of [`Settings::check`]; limits that cannot be.
    pub fn new(
        settings: Settings,
        seam: Course<'a>,
        deflection: DeflectionLimits,
        axes: SlideLimits,
    ) -> Result<Self, Error> {
        let (schedule, lead) = settings.check()?;
        Ok(Self {
            tracker: Tracker::new(lead, OwnCurve::straight(lead.lead_mm))?,
            authority: BeamAuthority::new(deflection, axes, settings.cycle_s)?,
            following: Following::default(),
            zone: settings.zone(settings.speed_mm_s[1])?,
            carried: 0.0,
            taken_s: None,
            before: [DVec2::NAN; 2],
            elsewhere: None,
            settings,
            seam,
            schedule,
        })
    }

    /// Where frames are looked at now.
    #[must_use]
    pub fn zone(&self) -> Zone {
        self.zone
    }

    /// True once a picture was of use.
    #[must_use]
    pub fn has_seen(&self) -> bool {
        self.taken_s.is_some()
    }

    /// How far aside the seam is expected at `s_mm`, mm; none where nothing is known of it.
    #[must_use]
    pub fn expected(&self, s_mm: f64) -> Option<f64> {
        let known = self.tracker.at(s_mm);
        (known.sight != Sight::Unseen).then_some(known.value.x)
    }

    /// What was found in a frame has arrived at time `now_s`.
    pub fn take(&mut self, picture: &Picture<'_>, now_s: f64) -> Taken {
        let then = match self.moment(picture, now_s) {
            Ok(then) => then,
            Err(refusal) => return Taken { refused: Some(refusal), ..Taken::default() },
        };
        let mut taken = Taken::default();
        let Zone { from_mm, to_mm } = self.zone;
        let mut places: ArrayVec<Place, PLACES> = ArrayVec::new();
        for point in picture.points {
            let within =
                (from_mm..=to_mm).contains(&point.along_mm) && point.lateral_mm.abs() <= self.settings.reach_mm.y;
            let sure = (self.settings.least_confidence..=1.0).contains(&point.confidence);
            if !within || !sure || places.is_full() {
                taken.left_out += 1;
                continue;
            }
            let (s, deviation) = located(self.seam, &then, point, picture.height_mm);
            places.push((s, deviation, point.confidence));
        }
        let Some(lie) = on_one_line(&places, self.settings.noise_mm) else {
            taken.gated = places.len() as u32;
            return taken;
        };
        taken.used = lie.iter().filter(|lies| **lies).count() as u32;
        taken.gated = places.len() as u32 - taken.used;
        let mut on_line = lie.iter();
        places.retain(|_| on_line.next().is_some_and(|lies| *lies));
        if !self.is_believed(&places) {
            return Taken { used: 0, gated: taken.gated + taken.used, ..taken };
        }
        for (s, deviation, confidence) in places {
            self.tracker.see(s, deviation, confidence, picture.exposed_s);
        }
        self.taken_s = Some(now_s);
        taken
    }

    /// A picture that shows the seam elsewhere than it is known to be is believed if the one before showed it there too: then
    /// the part has moved, and what was known from there on is forgotten.
    fn is_believed(&mut self, places: &[Place]) -> bool {
        let off = |(s, deviation, _): &Place| {
            let known = self.tracker.at(*s);
            (known.sight <= Sight::Bridged).then_some(deviation.x - known.value.x)
        };
        let mut off: ArrayVec<f64, PLACES> = places.iter().filter_map(off).collect();
        off.sort_unstable_by(f64::total_cmp);
        let median = off.get(off.len() / 2).copied().unwrap_or(0.0);
        let before = self.elsewhere.take();
        if median.abs() <= ELSEWHERE_MM {
            return true;
        }
        let again = before.is_some_and(|before| (before - median).abs() <= ELSEWHERE_MM);
        if again {
            let first = places.iter().map(|place| place.0).fold(f64::INFINITY, f64::min);
            self.tracker.forget_from(first);
        } else {
            self.elsewhere = Some(median);
        }
        again
    }

    /// Where the torch was when a picture was taken, or why the picture is of no use.
    fn moment(&mut self, picture: &Picture<'_>, now_s: f64) -> Result<Moment, Refusal> {
        let [young, old] = self.settings.age_s;
        let slack = 0.5 * self.settings.cycle_s;
        let age = now_s - picture.exposed_s;
        if age > old + slack {
            return Err(Refusal::Late);
        }
        if age.is_nan() || age < young - slack {
            return Err(Refusal::Clock);
        }
        if picture.height_mm.is_nan() || picture.height_mm.abs() > self.settings.reach_mm.y {
            return Err(Refusal::OutOfField);
        }
        let (Some(first), Some(last)) = (picture.points.first(), picture.points.last()) else {
            return Err(Refusal::Faint);
        };
        let ends = [first, last].map(|p| DVec2::new(p.along_mm, p.lateral_mm));
        let same = ends == self.before;
        self.before = ends;
        if same {
            return Err(Refusal::Frozen);
        }
        self.tracker.moment(picture.exposed_s).ok_or(Refusal::Clock)
    }

    /// A cycle: where the torch is on the nominal seam and how far the axes truly carry the gun aside; how fast the torch
    /// goes, mm/s, and whether it welds: before, nothing is hot, and the joint is looked at from its start on.
    pub fn cycle(&mut self, now: Moment, speed: f64, welds: bool) -> Orders {
        let notice = self.authority.lag_s() + self.settings.cycle_s;
        let there = now.s_mm + speed * notice;
        self.tracker.advance(now, now.s_mm + speed.abs() * self.tracker.settings().notice_s);
        if let Ok(zone) = self.settings.zone(speed.abs()) {
            self.zone = if welds { zone } else { Zone { from_mm: -zone.from_mm, ..zone } };
        }
        let estimate = self.tracker.at(now.s_mm);
        // Where nothing is known the gun stays.
        let to = [there, there + speed * SOON_S].map(|s| self.expected(s).unwrap_or(f64::NAN));
        let stuck = self.following.is_stuck(now.t_s, (now.slide.x - self.carried).abs());
        let shares = self.authority.step(to, now.slide.x, now.t_s);
        self.carried = shares.carried;
        let blind = self.taken_s.is_some_and(|t| now.t_s - t > BLIND_PERIODS * self.settings.period_s);
        let unknown = welds && estimate.sight == Sight::Unseen;
        let (pace, alarm) = judge(stuck, &shares, &estimate, (unknown, blind));
        Orders {
            beam: self.schedule.at(now.t_s, true),
            deflection_mm: shares.deflection,
            carried_mm: shares.carried,
            pace,
            alarm,
            estimate,
        }
    }
}

/// The worst that is wrong, and the pace that it leaves.
pub(super) fn judge(
    stuck: bool,
    shares: &Shares,
    here: &Estimate,
    (unknown, blind): (bool, bool),
) -> (f64, Option<Alarm>) {
    let alarm = match here.sight {
        _ if stuck => Alarm::SlideStuck,
        Sight::Lost => Alarm::Lost,
        _ if shares.short => Alarm::StrokeEnd,
        Sight::Fading => return (FADING_SPEED, Some(Alarm::FadingOut)),
        _ if unknown => Alarm::Unknown,
        Sight::Coasted => Alarm::Coasting,
        _ if blind => Alarm::Blind,
        _ if shares.carries => {
            if shares.near_stroke {
                Alarm::NearStroke
            } else {
                Alarm::AxesCarry
            }
        }
        _ => return (1.0, None),
    };
    let stops = matches!(alarm, Alarm::SlideStuck | Alarm::Lost | Alarm::StrokeEnd);
    (if stops { 0.0 } else { 1.0 }, Some(alarm))
}
