use super::following::Following;
use super::limits::SlideLimits;
use super::preview::softened;
use super::slide::Slide;
use crate::lead::{Error, Estimate, Measurement, Moment, OwnCurve, Refusal, Settings, Sight, Tracker, Verdict};
use glam::DVec2;
use seamwright_message::{Message, named_enum};
use std::collections::VecDeque;

/// Fraction of a slide's speed and stroke that is used before the torch slows down with a warning.
const RESERVE: f64 = 0.8;
/// Number of periods without a usable measurement before a warning, if the torch travels farther than tacks explain.
const BLIND_PERIODS: f64 = 10.0;
/// Minimum feed override while a correction fades out or nears the end of its stroke, as a fraction.
const FADING_SPEED: f64 = 0.25;

/// Maximum lag of a torch behind its orders that is followed, s; a longer one counts as this.
pub const MAX_LAG_S: f64 = 0.25;

/// Torch that lags behind its orders, as that of a robot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lag {
    /// Path length of the torch at the time of the cycle, mm.
    pub torch_mm: f64,
    /// Age of the order that the torch follows at that time, s.
    pub follows_s: f64,
    /// Age of the order that the reported positions show, s.
    pub shows_s: f64,
}

impl Lag {
    /// A torch at `torch_mm` that follows its orders at once.
    #[must_use]
    pub fn none(torch_mm: f64) -> Self {
        Self { torch_mm, follows_s: 0.0, shows_s: 0.0 }
    }
}

named_enum! {
    /// Tracking alarm; from [`Alarm::Blind`] on each is more severe than the previous one.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Alarm {
        /// The seam, here or ahead, needs more than 80 % of the stroke of a slide or of the axes that carry the gun.
        NearStroke: "tracking-near-stroke-end",
        /// The seam is beyond the beam's deflection range: the axes that carry the gun correct the rest.
        AxesCarry: "tracking-axes-carry",
        /// The seam ahead leaves the taught path faster than a slide can follow: the torch slows down.
        Slowed: "tracking-slowed",
        /// No usable measurement for several periods. The weld still follows earlier measurements.
        Blind: "tracking-blind",
        /// The torch is beyond the last measurement and follows the last slope.
        Coasting: "tracking-coasting",
        /// The torch has reversed beyond the stored range: the slide stays in place.
        Unknown: "tracking-beyond-history",
        /// The correction fades out to the taught path.
        FadingOut: "tracking-fading-out",
        /// A slide is at the end of its stroke: the weld misses the joint.
        StrokeEnd: "tracking-stroke-end",
        /// The correction has faded out: stop.
        Lost: "tracking-joint-lost",
        /// A slide does not follow its set-point: stop.
        SlideStuck: "tracking-slide-stuck",
        /// The stored deviation no longer fits the part: stop.
        Misfit: "tracking-stored-deviation-misfit",
    }
}

/// Cause of a lack of usable measurements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// The sensor is silent.
    Silent,
    /// The measurements contradict each other.
    Wild,
    /// The measurements are rejected.
    Refused(Refusal),
}

impl Cause {
    /// Returns the description.
    #[must_use]
    pub fn message(self) -> Message {
        Message::new(match self {
            Self::Silent => "tracking-sensor-silent",
            Self::Wild => "tracking-sensor-contradictory",
            Self::Refused(Refusal::Confidence) => "tracking-sensor-confidence",
            Self::Refused(Refusal::Faint) => "tracking-sensor-faint",
            Self::Refused(Refusal::OutOfField) => "tracking-sensor-out-of-field",
            Self::Refused(Refusal::Clock) => "tracking-sensor-clock",
            Self::Refused(Refusal::Late) => "tracking-sensor-late",
            Self::Refused(Refusal::Frozen) => "tracking-sensor-frozen",
        })
    }
}

/// Commands for the next cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Orders {
    /// Set-points of the slide, lateral and height, mm.
    pub slide: DVec2,
    /// Maximum feed override as a fraction; 0: stop.
    pub feed_override: f64,
    /// Most severe alarm.
    pub alarm: Option<Alarm>,
    /// Alarm that is independent of the sensor: [`Alarm::Slowed`] or [`Alarm::NearStroke`].
    pub carried: Option<Alarm>,
    /// Cause of a lack of usable measurements, after several periods without one.
    pub cause: Option<Cause>,
    /// Estimate of the seam at the torch.
    pub estimate: Estimate,
}

/// Tracking of one head: its tracker and its cross slide.
#[derive(Debug, Clone)]
pub struct HeadTracking {
    tracker: Tracker,
    slides: [Slide; 2],
    /// Last set-points of the slides, the newest first.
    ordered: VecDeque<DVec2>,
    target: DVec2,
    /// Time (s) and torch position (mm) of the last usable measurement.
    taken: Option<(f64, f64)>,
    /// Time (s) and position (mm) at which the torch entered the seam.
    begun: Option<(f64, f64)>,
    /// Torch position, mm.
    here_mm: f64,
    /// Arrival time (s) and verdict of the last unusable measurement since.
    unused: Option<(f64, Verdict)>,
    following: Following,
    stuck: bool,
}

impl HeadTracking {
    /// Creates the tracking of a head on the seam described by `own`, its cross slide centred.
    ///
    /// # Errors
    /// Those of [`Settings::check`] and [`SlideLimits::check`]; a notice shorter than the slides' lag.
    pub fn new(settings: Settings, own: OwnCurve, limits: [SlideLimits; 2]) -> Result<Self, Error> {
        let [x, y] = limits.map(|limits| Slide::new(limits, settings.cycle_s));
        let slides = [x?, y?];
        if slides.iter().any(|slide| slide.lag_s() >= settings.notice_s) {
            let (key, value) = ("notice_s", settings.notice_s);
            return Err(Error::Value { key, value, allowed: Message::new("tracking-notice-allowed") });
        }
        let tracker = Tracker::new(settings, own)?;
        let mut ordered = VecDeque::with_capacity((MAX_LAG_S / settings.cycle_s).ceil() as usize + 2);
        ordered.push_front(DVec2::ZERO);
        let target = DVec2::ZERO;
        Ok(Self {
            tracker,
            slides,
            ordered,
            target,
            taken: None,
            begun: None,
            here_mm: 0.0,
            unused: None,
            following: Following::default(),
            stuck: false,
        })
    }

    /// Returns the settings of the sensor.
    #[must_use]
    pub fn settings(&self) -> &Settings {
        self.tracker.settings()
    }

    /// Returns the limits of corrections, lateral and height.
    #[must_use]
    pub fn limits(&self) -> [SlideLimits; 2] {
        [*self.slides[0].limits(), *self.slides[1].limits()]
    }

    /// Processes a measurement that arrived at time `now_s`.
    pub fn take(&mut self, measured: &Measurement, now_s: f64) -> Verdict {
        let verdict = self.tracker.take(measured, now_s);
        match verdict {
            Verdict::Taken | Verdict::Restarted => (self.taken, self.unused) = (Some((now_s, self.here_mm)), None),
            Verdict::Gated | Verdict::Refused(_) => self.unused = Some((now_s, verdict)),
        }
        verdict
    }

    /// Runs one cycle with the actual positions of torch and slide, and the torch's speed along the seam, mm/s.
    pub fn cycle(&mut self, now: Moment, speed: f64) -> Orders {
        self.cycle_woven(now, speed, DVec2::ZERO)
    }

    /// Runs one cycle of a weaving torch; `swing` (lateral and height, mm) is the weave's part of the slide position.
    pub fn cycle_woven(&mut self, now: Moment, speed: f64, swing: DVec2) -> Orders {
        self.cycle_lagging(Moment { slide: now.slide - swing, ..now }, speed, swing, Lag::none(now.s_mm))
    }

    /// Runs one cycle of a torch that lags behind its orders: `now` has the path length of its set-point, and the slide
    /// position that the reports show, without the weave; `swing` is the weave's part where the torch is.
    ///
    /// The slide's position at the time of the cycle is the reported one, plus the change that was ordered between the
    /// order that the report shows and the one that the torch follows. So measurements are matched with the position of
    /// their exposure, however late reports are.
    pub fn cycle_lagging(&mut self, now: Moment, speed: f64, swing: DVec2, lag: Lag) -> Orders {
        let settings = *self.tracker.settings();
        let way = speed.abs() * settings.notice_s;
        self.here_mm = now.s_mm;
        if now.s_mm > 0.0 {
            self.begun.get_or_insert((now.t_s, now.s_mm));
        }
        let (shown, followed) = (self.ordered(lag.shows_s), self.ordered(lag.follows_s));
        let slide = now.slide + (followed - shown) + swing;
        let torch = Moment { t_s: now.t_s, s_mm: lag.torch_mm, slide };
        self.tracker.advance_from(torch, now.s_mm, now.s_mm + way);
        self.stuck = self.following.is_stuck(now.t_s, now.slide.distance(shown));
        let estimate = self.tracker.at(now.s_mm);
        // A stuck slide's set-points come to rest, within its limits.
        if !self.stuck {
            self.aim(&now, speed, &settings);
        }
        let ordered = DVec2::from_array([self.slides[0].step(self.target.x), self.slides[1].step(self.target.y)]);
        if self.ordered.len() == self.ordered.capacity() {
            self.ordered.pop_back();
        }
        self.ordered.push_front(ordered);
        let (feed_override, alarm, carried) = self.judge(&now, speed, &estimate);
        Orders { slide: ordered, feed_override, alarm, carried, cause: self.cause(&now), estimate }
    }

    /// Returns the slides' set-point of `age_s` before the last one, interpolated; the oldest known one at most.
    fn ordered(&self, age_s: f64) -> DVec2 {
        let age = (age_s / self.tracker.settings().cycle_s).clamp(0.0, (self.ordered.len() - 1) as f64);
        let newer = age.floor() as usize;
        let older = (newer + 1).min(self.ordered.len() - 1);
        self.ordered[newer].lerp(self.ordered[older], age - newer as f64)
    }

    /// Returns the cause after several periods without a usable measurement, over more distance than tacks explain.
    fn cause(&self, now: &Moment) -> Option<Cause> {
        let settings = self.tracker.settings();
        let long_ago = |since: f64| now.t_s - since > BLIND_PERIODS * settings.period_s;
        let blind = |(t, s): (f64, f64)| long_ago(t) && (now.s_mm - s).abs() > settings.coast_mm();
        // Before the first measurement both count from the start of the seam.
        if !self.taken.or(self.begun).is_some_and(blind) {
            return None;
        }
        Some(match self.unused {
            Some((at, Verdict::Refused(refusal))) if !long_ago(at) => Cause::Refused(refusal),
            Some((at, _)) if !long_ago(at) => Cause::Wild,
            _ => Cause::Silent,
        })
    }

    /// Sets the slides' target: the deviation that the torch meets after the slides' lag.
    fn aim(&mut self, now: &Moment, speed: f64, settings: &Settings) {
        let [x, y] = &self.slides;
        // The lags of both slides are nearly equal.
        let lag = x.lag_s().max(y.lag_s());
        let there = now.s_mm + speed * (lag + settings.cycle_s);
        // At an unknown seam, as after a long reverse, the slide stays.
        if self.tracker.at(there).sight != Sight::Unseen {
            let limit = |f: fn(&Slide) -> f64| DVec2::new(f(x), f(y));
            self.target = softened(
                |t| self.tracker.at(there + speed * t).value,
                settings.notice_s - lag,
                limit(|slide| slide.limits().motion.speed),
                limit(Slide::acceleration),
            );
        }
    }

    /// Returns the feed override, the most severe alarm, and the one independent of the sensor.
    fn judge(&self, now: &Moment, speed: f64, here: &Estimate) -> (f64, Option<Alarm>, Option<Alarm>) {
        let settings = self.tracker.settings();
        if self.stuck {
            return (0.0, Some(Alarm::SlideStuck), None);
        }
        let stroke = DVec2::new(self.slides[0].limits().stroke_mm, self.slides[1].limits().stroke_mm);
        let fastest = RESERVE * DVec2::new(self.slides[0].limits().motion.speed, self.slides[1].limits().motion.speed);
        let ahead = self.tracker.ahead(now.s_mm);
        let needed = (ahead.slope * settings.speed_mm_s.max(speed.abs()) / fastest).max_element();
        let mut feed_override = if needed > 1.0 { 1.0 / needed } else { 1.0 };
        let reach = (ahead.value / stroke).max_element();
        let blind = self.cause(now).is_some();
        let never = self.begun.filter(|_| self.taken.is_none());
        let lost = settings.coast_mm() + settings.fade_mm;
        let carried = if needed > 1.0 { Some(Alarm::Slowed) } else { (reach > RESERVE).then_some(Alarm::NearStroke) };
        let alarm = match here.sight {
            Sight::Lost => Alarm::Lost,
            _ if never.is_some_and(|(_, from)| now.s_mm - from > lost) => Alarm::Lost,
            _ if here.value.abs().cmpgt(stroke).any() => Alarm::StrokeEnd,
            Sight::Fading => Alarm::FadingOut,
            Sight::Unseen if self.taken.is_some() => Alarm::Unknown,
            Sight::Coasted => Alarm::Coasting,
            _ if blind => Alarm::Blind,
            _ => match carried {
                Some(alarm) => alarm,
                None => return (feed_override, None, None),
            },
        };
        // Slows down towards the end of the stroke, to give the operator time.
        feed_override =
            feed_override.min(1.0 - (1.0 - FADING_SPEED) * ((reach - RESERVE) / (1.0 - RESERVE)).clamp(0.0, 1.0));
        match alarm {
            Alarm::Lost | Alarm::StrokeEnd => feed_override = 0.0,
            Alarm::FadingOut => feed_override = feed_override.min(FADING_SPEED),
            _ => {}
        }
        (feed_override, Some(alarm), carried)
    }
}
