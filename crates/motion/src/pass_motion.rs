use crate::arc_limits::{least_speed_findings, stop_findings};
use crate::corners::rounded;
use crate::cures::Trial;
use crate::effort::{Effort, SearchStage};
use crate::feed_override::PassTimed;
use crate::follower::Follower;
use crate::joint_path::JointPath;
use crate::pass_channels::PassChannels;
use crate::pass_time::{too_long, travels_too_long};
use crate::planned::Planned;
use crate::redundancy::{Aim, AllowedPositions, Clearance, FreeAxes, hold_finding, holding, resolve_within};
use crate::singular;
use crate::speed_findings::{never_reached, speed_findings};
use crate::speed_profile::{Certificate, ProfilePoint, SpeedProfile, SpeedProfileError};
use crate::survey::{Survey, range_between, range_on_path, survey};
use crate::weave_limits::Woven;
use seamwright_machine::{AxisSet, Joints, Machine};
use seamwright_message::Message;
use seamwright_program::{ArcTime, Finding, Pass, PathRange, Procedure, Sequence, TorchPath, torch_jumps};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// Number of samples of the tip's travel by path length before the axes are known.
const RATES: u32 = 60;

/// One pass as motion: the axes' path, the speed profile and the process sequence.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct PassMotion {
    /// The axes' positions by path length.
    pub path: JointPath,
    /// The speed profile along it.
    pub profile: SpeedProfile,
    /// Reached speeds and binding limits of the profile; channels are the machine's axes.
    pub certificate: Certificate,
    /// Times before and after the travel.
    pub sequence: Sequence,
    /// True if arc or beam is on.
    pub arc: bool,
    /// Maximum angle (rad) between requested and reached torch attitude, and its path length (mm).
    pub attitude_error: (f64, f64),
    /// Notes on a feasible weld.
    #[serde(with = "seamwright_program::finding_data")]
    pub findings: Vec<Finding>,
}

/// A pass to be planned, with what is known of its weld.
#[derive(Clone, Copy)]
pub(crate) struct Request<'a> {
    pub(crate) path: &'a dyn TorchPath,
    pub(crate) pass: &'a Pass,
    /// From 1.
    pub(crate) number: usize,
    pub(crate) effort: &'a Effort<'a>,
    /// Procedure whose welding positions take precedence over the preferred ones.
    pub(crate) procedure: Option<&'a Procedure>,
    /// Positions at the end of the previous pass: rotary axes start on the turn nearest to it in their range.
    pub(crate) last: Option<&'a Joints>,
    /// False if only a plan is of interest, not the reason for its failure.
    pub(crate) explains: bool,
    /// All passes of the weld in order, including this one; empty if no others are known.
    pub(crate) weld: &'a [(&'a dyn TorchPath, &'a Pass)],
    pub(crate) clearance: Option<Clearance<'a>>,
    /// True if the search of free axes may miss a path, in a small part of the time.
    pub(crate) is_quick: bool,
}

impl PassMotion {
    /// Plans `pass` (the `number`-th, from 1) along `path` on `machine`.
    ///
    /// Clearance and other passes are not regarded: for these see [`WeldMotion::plan`](crate::WeldMotion::plan). The
    /// [crate](crate#examples) has an example.
    ///
    /// # Errors
    /// Every finding against it:
    ///
    /// - out of reach, or out of an axis' range;
    /// - too fast for an axis, if the pass refuses to slow down;
    /// - not smooth.
    pub fn plan(machine: &Machine, path: &dyn TorchPath, pass: &Pass, number: usize) -> Result<Self, Vec<Finding>> {
        let effort = Effort::new(None);
        let known = Request {
            path,
            pass,
            number,
            effort: &effort,
            procedure: None,
            last: None,
            explains: true,
            weld: &[],
            clearance: None,
            is_quick: false,
        };
        Self::of(machine, known)
    }

    /// Plans a pass as [`PassMotion::plan`], after another pass or with obstacles.
    pub(crate) fn of(machine: &Machine, request: Request) -> Result<Self, Vec<Finding>> {
        let long = too_long(request.pass, request.number);
        if !long.is_empty() {
            return Err(long);
        }
        let mut all = match Self::plan_once(machine, request) {
            Err(all) => all,
            planned => return planned,
        };
        request.effort.check(request.number, request.path.length())?;
        if let Ok(held) = holding(machine, &request.pass.spare_axes) {
            Trial { machine, held: &held, request }.cure_ranges(&mut all);
        }
        Err(all)
    }

    /// Plans it without trying cures.
    pub(crate) fn plan_once(machine: &Machine, request: Request) -> Result<Self, Vec<Finding>> {
        let Request { path, pass, number, effort, .. } = request;
        let held = holding(machine, &pass.spare_axes).map_err(|e| vec![hold_finding(e, path.length(), number)])?;
        let jumps = if path.axes(0.0).is_some() { Vec::new() } else { torch_jumps(path, number) };
        if !jumps.is_empty() && held.is_redundant() {
            return Err(jumps);
        }
        let Chosen { machine, free, survey } = with_best_freedom(held, request).map_err(|found| with(&jumps, found))?;
        let machine = &*machine;
        let (_, fastest) = pass.speeds();
        let follower = Follower { machine, path, free: &free };
        let mut findings = with(&jumps, survey.findings);
        if !jumps.is_empty() {
            // No axes follow a jump of the torch: other findings there would be its consequences.
            return Err(findings);
        }
        effort.begin(SearchStage::Weave);
        let woven = Woven::new(follower, &survey.start, pass, effort);
        if let Some(too_fast) = woven.as_ref().and_then(|woven| woven.too_fast(number)) {
            findings.push(too_fast);
            return Err(findings);
        }
        let mut joints = match JointPath::new(follower, &survey.start) {
            Ok(joints) => joints,
            Err(at) => {
                findings.push(not_smooth(machine, at.s, number));
                return Err(findings);
            }
        };
        if !follower.is_given() {
            joints.turn_to_start(machine, &request);
            // The survey checked the path before it was turned.
            findings.retain(|f| f.kind != "range");
            findings.extend(range_on_path(machine, &joints, number));
        }
        effort.begin(SearchStage::Speed);
        effort.check(number, path.length())?;
        let (joints, left, notes) = rounded(follower, joints, pass, number);
        findings.extend(notes);
        let asked = |s: f64| pass.speed_at(s);
        let channels = PassChannels::new(machine, &joints, pass, 1.0);
        let profile = match SpeedProfile::new(&channels) {
            Ok(profile) => profile,
            Err(error) => {
                findings.push(no_profile(machine, path.length(), error, number));
                return Err(findings);
            }
        };
        findings.extend(travels_too_long(&profile, path.length(), number));
        let certificate = Certificate::new(&channels, &profile);
        let legs = profile.legs();
        let planned = Planned { machine, joints: &joints, profile: &profile, certificate: &certificate, legs: &legs };
        findings.extend(speed_findings(planned, pass, number));
        woven.iter().for_each(|woven| woven.explain(&mut findings));
        findings.extend(stop_findings(machine, &left, pass, number));
        findings.extend(least_speed_findings(planned, pass, number));
        findings.extend(never_reached(planned, fastest, pass.on_limit, number));
        let decided: AxisSet = (0..machine.axes.len()).filter(|&i| !free.has(i)).collect();
        findings.extend(singular::margins(machine, &joints, decided, &asked, number));
        findings.extend(range_between(machine, &joints, number));
        if findings.iter().any(|f| !f.allowed) {
            return Err(findings);
        }
        Ok(Self {
            path: joints,
            profile,
            certificate,
            sequence: pass.sequence.clone(),
            arc: pass.has_arc(),
            attitude_error: survey.attitude_error,
            findings,
        })
    }

    /// Time before the torch travels, s.
    pub fn before_s(&self) -> f64 {
        self.sequence.preflow_s.get() + self.sequence.travel_delay_s.get()
    }

    /// Time from the first to the last set-point, s.
    pub fn total_s(&self) -> f64 {
        self.before_s() + self.profile.duration() + self.sequence.crater_s.get() + self.sequence.postflow_s.get()
    }

    /// Time the arc (or beam) is on, s.
    pub fn arc_on_s(&self) -> f64 {
        if !self.arc {
            return 0.0;
        }
        self.sequence.travel_delay_s.get() + self.profile.duration() + self.sequence.crater_s.get()
    }

    /// Speed of the torch tip of `machine`, whose motion this is, at the point `p` of the profile, mm/s: that of the
    /// path length, except beside the seam and in blends.
    pub fn tip_speed(&self, machine: &Machine, p: ProfilePoint) -> f64 {
        p.v * self.path.tip_rate(machine, p.s)
    }

    /// Minimum and maximum planned speed of the tip of `machine`, whose motion this is, between acceleration and
    /// deceleration phase, mm/s; if these meet, the speed at their border.
    pub fn tip_band(&self, machine: &Machine) -> (f64, f64) {
        self.certificate.band().unwrap_or_else(|| {
            let band = self.profile.report();
            let rate = self.path.speed_rate(machine, band.run_up_end);
            (rate * band.least, rate * band.greatest)
        })
    }

    /// The motion of `machine` in time, to be played with a feed override.
    pub fn timed<'a>(&'a self, machine: &'a Machine) -> PassTimed<'a> {
        PassTimed::new(machine, &self.path, &self.profile)
    }

    /// Plans the profile along the same path for `factor` times the speeds of `pass`, slower where `machine` cannot
    /// keep them. Overrides above 1 play it.
    ///
    /// # Errors
    /// A factor that is not finite and above zero; no others, since the path already has a profile.
    pub fn faster(&self, machine: &Machine, pass: &Pass, factor: f64) -> Result<SpeedProfile, SpeedProfileError> {
        SpeedProfile::new(&PassChannels::new(machine, &self.path, pass, factor))
    }

    /// Times since arc start and until arc end at `t` s after the first set-point.
    pub fn arc_clock(&self, t: f64) -> ArcTime {
        let since_on_s = t - self.sequence.preflow_s.get();
        ArcTime { since_on_s, until_off_s: self.arc_on_s() - since_on_s }
    }
}

fn with(first: &[Finding], others: Vec<Finding>) -> Vec<Finding> {
    first.iter().cloned().chain(others).collect()
}

struct Chosen<'m> {
    machine: Cow<'m, Machine>,
    free: FreeAxes,
    survey: Survey,
}

/// The free axes along `path` and a survey of it, with the machine that has these axes free.
///
/// If the axes determined by the pose are singular at some path length of a six-axis arm, another choice of the free
/// axis may be regular. Without a closed form each choice is tried until one leads along the path.
fn with_best_freedom<'m>(machine: Cow<'m, Machine>, request: Request) -> Result<Chosen<'m>, Vec<Finding>> {
    let Request { path, pass, number, effort, .. } = request;
    let is_good = |found: &(FreeAxes, Survey)| found.1.findings.iter().all(|f| f.allowed);
    let first = along_axes(&machine, request);
    let head = &machine.heads[0];
    let redundant = machine.is_redundant() && path.axes(0.0).is_none() && path.second(0.0).is_none();
    if first.as_ref().is_ok_and(is_good) || !head.is_numeric() || !redundant {
        return first.map(|(free, survey)| Chosen { machine, free, survey });
    }
    let held: AxisSet = pass.spare_axes.hold.keys().filter_map(|name| machine.axis(name)).collect();
    let others = head.chain.axes().iter().filter(|&axis| !machine.free().has(axis));
    for other in others.filter_map(|axis| machine.freeing(held.with(axis))) {
        effort.check(number, path.length())?;
        if let Some(found) = along_axes(&other, Request { explains: false, ..request }).ok().filter(is_good) {
            return Ok(Chosen { machine: Cow::Owned(other), free: found.0, survey: found.1 });
        }
    }
    first.map(|(free, survey)| Chosen { machine, free, survey })
}

/// The free axes along `path`, and a survey of it; `machine` has the axes that `pass` holds free.
pub(crate) fn along_axes(machine: &Machine, request: Request) -> Result<(FreeAxes, Survey), Vec<Finding>> {
    let Request { path, pass, number, effort, .. } = request;
    let (_, fastest) = pass.speeds();
    // Redundant axes do not weave.
    let line = path.weave().map(|weave| weave.slower(0.0));
    let line = line.as_deref().unwrap_or(path);
    let aim = Aim {
        speed: fastest / least_rate(line),
        wishes: &pass.spare_axes,
        clearance: request.clearance,
        positions: request.procedure.and_then(|p| AllowedPositions::of(p, line, pass, number)),
        explains: request.explains,
        is_quick: request.is_quick,
    };
    let free = resolve_within(effort, machine, line, aim, number)?;
    effort.begin(SearchStage::Reach);
    let survey = survey(Follower { machine, path, free: &free }, &pass.tolerance, number, effort)?;
    Ok((free, survey))
}

fn least_rate(path: &dyn TorchPath) -> f64 {
    let places = (0..=RATES).map(|i| path.length() * f64::from(i) / f64::from(RATES));
    places.map(|s| path.rate(s)).fold(f64::INFINITY, f64::min)
}

fn no_profile(machine: &Machine, length: f64, error: SpeedProfileError, pass: usize) -> Finding {
    let range = match error {
        SpeedProfileError::NotSmooth { at, .. } | SpeedProfileError::Asked { at, .. } => PathRange::at(at),
        _ => PathRange::up_to(length),
    };
    let message = Message::new("motion-no-speed-profile").text("machine", machine.name.as_str());
    let message = message.message("reason", error.message());
    Finding::error("speed", message, pass, range, Message::new("motion-cure-limits"))
}

fn not_smooth(machine: &Machine, s: f64, pass: usize) -> Finding {
    let message = Message::new("motion-not-smooth").text("machine", machine.name.as_str());
    Finding::error("singular", message, pass, PathRange::at(s), Message::new("motion-cure-not-tried"))
}
