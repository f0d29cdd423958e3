use super::camera::{BeamCamera, Glance};
use super::picture_queue::PictureQueue;
use super::recent_positions::{GunPosition, RecentPositions};
use super::scene::BeamScene;
use crate::drives::DriveSet;
use crate::error::Error;
use crate::tracking::weld_statistics::MissDistribution;
use glam::{DVec2, DVec3, Vec3Swizzles as _};
use seamwright_executive::tracking::{BeamHead, BeamUse, END_MM, LOOK_S, STEP_MM};
use seamwright_machine::Joints;
use seamwright_servo::SetPoint;
use seamwright_tracking::actuator::Alarm;
use seamwright_tracking::beam::{Beam, DeviationRecord, Fit, Misfit, Orders, Recorder};
use seamwright_tracking::lead::{Moment, SeamFrame};

/// Result of a pass.
#[derive(Debug, Clone)]
pub struct BeamOutcome {
    /// 99 % of the weld lie within this distance of the seam, across, mm.
    pub p99_mm: f64,
    /// Maximum distance, across, mm.
    pub most_mm: f64,
    /// 99 % of the weld lie within this distance out of the surface, mm: the beam does not see it.
    pub height_p99_mm: f64,
    /// Welded distance, mm.
    pub welded_mm: f64,
    /// Share of the time that the beam was away from the weld, and the maximum duration, s.
    pub away: (f64, f64),
    /// Maximum deflection, and maximum distance by which the axes carried the gun, mm.
    pub used_mm: [f64; 2],
    /// Position at which the weld was stopped before its end, mm.
    pub stopped_mm: Option<f64>,
    /// Most severe alarm.
    pub alarm: Option<Alarm>,
    /// Deviations found of the seam.
    pub record: Option<DeviationRecord>,
    /// Lateral offset of the weld from the taught seam, by path length, mm.
    pub places: Vec<(f64, f64)>,
    /// Fit of a replay.
    pub fit: Option<Result<Fit, Misfit>>,
}

/// Usual time from an exposure to the arrival of its result, s.
const LATENCY_S: f64 = 0.045;
/// Cycles from one measurement of the weld to the next.
const MEASURED: u32 = 5;

/// Welds a pass on the machine's drives with the orders of `head` and the view of `camera`. The same seed gives the same
/// weld.
///
/// # Errors
/// Invalid drives, axes that cannot carry the gun, frames that are not available.
pub fn weld(
    scene: &BeamScene<'_>,
    camera: &mut dyn BeamCamera,
    mut head: BeamHead<'_>,
    noise_mm: f64,
    seed: u64,
) -> Result<BeamOutcome, Error> {
    let cycle_s = scene.machine.servo_period_s;
    let mut gun = Gun::new(scene, seed)?;
    let mut pictures = PictureQueue::new(LATENCY_S, seed);
    let mut recorder = Recorder::new(scene.taught.length_mm, STEP_MM, noise_mm);
    let mut beam_use = BeamUse::default();
    let (mut across, mut out) = (MissDistribution::default(), MissDistribution::default());
    let (mut places, mut alarm, mut stopped_mm) = (Vec::new(), None, None);
    let (mut t, mut clock, mut cursor, mut count) = (0.0, 0.0, 0, 0);
    let mut orders: Option<Orders> = None;
    while clock < scene.motion.profile.duration() {
        t += cycle_s;
        let welds = t > LOOK_S;
        let feed_override = orders.as_ref().map_or(1.0, |o| o.feed_override);
        if welds && feed_override <= 0.0 {
            stopped_mm = Some(gun.s);
            break;
        }
        clock += if welds { feed_override * cycle_s } else { 0.0 };
        let profile = scene.motion.profile.at(clock, &mut cursor);
        let speed = if welds { feed_override * profile.v } else { 0.0 };
        gun.go(profile.s, orders.as_ref().map_or(0.0, |o| o.carried_mm), t)?;
        pictures.deliver(&mut head, t);
        let now = Moment { t_s: t, s_mm: gun.along(), slide: gun.carried() };
        let next = head.cycle(now, speed, welds);
        if let Beam::Seen(exposed_s) = next.beam {
            let at = gun.recent.at(exposed_s).unwrap_or(gun.now);
            let taught = (scene.taught.frame)(at.s);
            let torch = SeamFrame { point: at.tip, ..taught };
            let (ahead, aside) = head.looks_for(at.s, speed);
            let carried = (at.tip - taught.point).dot(torch.lateral);
            let from = (ahead, aside.map(|aside| aside - carried));
            pictures.look(camera, &Glance { t_s: exposed_s, axes: &at.axes, torch, s_mm: at.s, from })?;
        }
        if welds {
            // At the very end no part of the seam lies ahead.
            if now.s_mm < scene.taught.length_mm - END_MM {
                alarm = alarm.max(next.alarm);
            }
            recorder.add(now.s_mm, &next.estimate);
            let on = !matches!(next.beam, Beam::Scan);
            beam_use.cycle(on, next.deflection_mm, gun.carried().x);
            if on && count % MEASURED == 0 {
                let weld = gun.carried().x + next.deflection_mm;
                places.push((now.s_mm, weld));
                if let Some(miss) = gun.miss(next.deflection_mm) {
                    let way = speed * cycle_s * f64::from(MEASURED);
                    across.add(miss.with_y(0.0), way);
                    out.add(miss.with_x(0.0), way);
                }
            }
            count += 1;
        }
        orders = Some(next);
    }
    let (part, longest) = beam_use.away();
    Ok(BeamOutcome {
        p99_mm: across.quantile(0.99),
        most_mm: across.quantile(1.0),
        height_p99_mm: out.quantile(0.99),
        welded_mm: across.way(),
        away: (part, f64::from(longest) * cycle_s),
        used_mm: beam_use.used,
        stopped_mm,
        alarm,
        record: recorder.finish(),
        places,
        fit: match &head {
            BeamHead::Tracking(_) => None,
            BeamHead::Replay(head) => head.judged(),
        },
    })
}

/// The machine's drives, which carry the gun.
struct Gun<'a> {
    scene: &'a BeamScene<'a>,
    drives: DriveSet,
    /// Position of the set-point, mm.
    s: f64,
    set: [Joints; 3],
    now: GunPosition,
    recent: RecentPositions,
}

impl<'a> Gun<'a> {
    fn new(scene: &'a BeamScene<'a>, seed: u64) -> Result<Self, Error> {
        let mut drives = DriveSet::new(scene.machine, seed)?;
        let start = scene.motion.path.at(0.0);
        drives.settle_at(&start);
        let tip = scene.machine.forward(&start).point;
        let (now, mut recent) = (GunPosition { t: 0.0, s: 0.0, axes: start, tip }, RecentPositions::new());
        recent.add(now);
        Ok(Self { scene, drives, s: 0.0, set: [start; 3], now, recent })
    }

    /// Runs one cycle: moves the axes to the planned torch at `s`, carried aside.
    fn go(&mut self, s: f64, carried: f64, t: f64) -> Result<(), Error> {
        let Self { scene, set, .. } = self;
        let machine = scene.machine;
        let mut axes = scene.motion.path.at(s);
        if carried != 0.0 {
            let mut pose = machine.forward(&axes);
            pose.point += carried * (scene.taught.frame)(s).lateral;
            axes = machine.inverse_near(pose, &axes).map_err(|e| Error::Carried(e.message()))?.joints;
        }
        let [last, before, _] = *set;
        *set = [axes, last, before];
        let dt = machine.servo_period_s;
        let mut q = axes;
        for i in 0..machine.axes.len() {
            let velocity = (axes[i] - last[i]) / dt;
            let acceleration = (axes[i] - 2.0 * last[i] + before[i]) / (dt * dt);
            q[i] = self.drives.step(i, SetPoint { position: axes[i], velocity, acceleration }).position;
        }
        self.s = s;
        self.now = GunPosition { t, s, axes: q, tip: machine.forward(&q).point };
        self.recent.add(self.now);
        Ok(())
    }

    /// Returns the offset of the tip from the taught torch, mm: along, lateral, height.
    fn off(&self) -> DVec3 {
        let frame = (self.scene.taught.frame)(self.s);
        frame.components(self.now.tip - frame.point)
    }

    /// Returns the true path length of the torch.
    fn along(&self) -> f64 {
        self.s + self.off().x
    }

    /// Returns the true offset of the gun, lateral and height.
    fn carried(&self) -> DVec2 {
        self.off().yz()
    }

    /// Returns the distance of the weld from the seam, across and out of the surface, mm. The beam continues to the
    /// true surface, at the angle to which it is deflected.
    fn miss(&self, deflection: f64) -> Option<DVec2> {
        let frame = (self.scene.taught.frame)(self.s);
        let tip = self.now.tip + deflection * frame.lateral;
        let up = frame.height - deflection / self.scene.deflection.pivot_mm * frame.lateral;
        let height = |at: DVec3| {
            let foot = self.scene.actual.foot(at)?;
            Some((at - foot.at.point).dot(foot.at.normal) / up.dot(foot.at.normal))
        };
        let above = height(tip)?;
        let hit = tip - (above + height(tip - above * up)?) * up;
        let foot = self.scene.actual.foot(hit)?;
        Some(DVec2::new((hit - foot.at.point).dot(foot.at.normal.cross(foot.along)), above))
    }
}
