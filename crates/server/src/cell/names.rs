use super::standstill::Stillness;
use crate::refusal::{Lack, lack};
use crate::wire::{Ages, AlarmView, AxisStatus, LeftView, ProcessStatus, RealtimeView, Status};
use seamwright_executive::realtime::{RealtimeRights, Shown};
use seamwright_executive::{Alarm, AlarmState, Event, Interlocks, Missing, Mode, ProcessState, Raised};
use seamwright_machine::{AxisKind, Joints, Level, Machine};
use seamwright_message::Message;

/// The machine's names for the executive's indices, and its kinematic chain.
pub(super) struct Names {
    pub(super) machine: Machine,
    /// See [`seamwright_cell::fingerprint`].
    pub(super) fingerprint: String,
    /// Number of process values of the program.
    pub(super) values: usize,
    /// Number of tracked heads.
    pub(super) heads: usize,
}

impl Names {
    fn axes(&self) -> Vec<&str> {
        self.machine.axes.iter().map(|a| a.name.as_str()).collect()
    }

    fn conditions(&self) -> Vec<&str> {
        self.machine.interlocks.iter().map(|i| i.name.as_str()).collect()
    }

    pub(super) fn watch(&self, stillness: &mut Stillness, c: &Shown) {
        let axes = self.machine.axes.len();
        let rests = c.orders.set[..axes].iter().all(|set| set.velocity == 0.0);
        let rotary = std::array::from_fn(|i| self.machine.axes.get(i).is_some_and(|a| a.kind == AxisKind::Rotary));
        stillness.cycle(c.t, rests, &c.reports.drives.position, &rotary);
    }

    pub(super) fn about(&self, alarm: Alarm, detail: u8) -> Option<Message> {
        alarm.about(detail, &self.axes(), &self.conditions())
    }

    /// Returns what a raised alarm is about, the length of its gap included.
    pub(super) fn about_raised(&self, raised: &Raised) -> Option<Message> {
        raised.about(&self.axes(), &self.conditions())
    }

    pub(super) fn alarm(&self, raised: &Raised) -> AlarmView {
        let entry = raised.alarm.entry();
        AlarmView {
            number: raised.alarm.number() as u8,
            name: entry.name.to_owned(),
            of: self.about_raised(raised).map(Into::into),
            cause: raised.cause().to_string(),
            consequence: entry.consequence.to_string(),
            action: entry.action.to_string(),
            reaction: raised.reaction.name().to_owned(),
            state: match raised.state {
                AlarmState::Unacknowledged => "unacknowledged",
                AlarmState::Acknowledged => "acknowledged",
                AlarmState::Returned => "returned",
            }
            .to_owned(),
            detail: raised.detail,
            first_out: raised.first_out,
            t: raised.t,
            at: String::new(),
            acknowledged: None,
            shelved: None,
            chattering: false,
            tells: raised.alarm.is_shelvable(raised.reaction),
            priority: raised.alarm.priority(raised.reaction).name().to_owned(),
            pass: raised.place.pass as u32,
            s_mm: raised.place.s_mm,
        }
    }

    pub(super) fn lack(&self, missing: Missing) -> Lack {
        let message = missing.message(&self.axes(), &self.conditions());
        lack(
            match missing {
                Missing::Mode(_) => "mode",
                Missing::Moving => "moving",
                Missing::References(_) => "references",
                Missing::HomesFirst(_) => "homes_first",
                Missing::Power => "power",
                Missing::Silent(_) => "silent",
                Missing::Condition(_) => "condition",
                Missing::Alarm(..) => "alarm",
                Missing::Arming => "arming",
                Missing::Source => "source",
                Missing::NotAtStart(_) => "not_at_start",
                Missing::Work => "work",
                Missing::Value => "value",
                Missing::Motion => "motion",
            },
            message,
        )
    }

    pub(super) fn status(&self, c: &Shown, extra: Extra<'_>) -> Status {
        let machine = &self.machine;
        let drives = &c.reports.drives;
        let bit = |bits: u16, i: usize| bits >> i & 1 == 1;
        let axes = machine.axes.iter().enumerate().map(|(i, axis)| AxisStatus {
            position: axis.to_file(drives.position[i]),
            set: axis.to_file(c.orders.set[i].position),
            error: axis.to_file(drives.following_error[i]),
            current: drives.current[i],
            referenced: bit(drives.referenced, i),
            fault: bit(drives.fault, i),
            limit_switch: bit(drives.limit_switch, i),
        });
        let q: Joints = drives.position;
        let tip = machine.forward(&q);
        let count = machine.links.count();
        let conditions = machine.interlocks.len();
        let unmet = Interlocks::new(&machine.interlocks).unmet(Level::Process, c.reports.inputs);
        let number = |v: f64| v.is_finite().then_some(v);
        Status {
            t: c.t,
            mode: mode(c.mode).to_owned(),
            pass: c.place.pass as u32,
            s_mm: c.place.s_mm,
            welded_mm: c.welded_mm,
            speed_mm_s: c.speed,
            override_part: c.feed_override,
            armed: c.armed,
            powered: c.orders.power && drives.powered,
            process: ProcessStatus {
                state: match c.process {
                    ProcessState::Off => "off",
                    ProcessState::Strikes => "strikes",
                    ProcessState::Pauses => "pauses",
                    ProcessState::Burns => "burns",
                    ProcessState::Failed => "failed",
                }
                .to_owned(),
                on: c.orders.process.on,
                burning: c.reports.source.burning,
                gas: c.orders.process.gas,
                ready: c.reports.source.ready,
                stuck: c.reports.source.stuck,
                fault: c.reports.source.fault,
                phase: c.phase.map(|p| p.name().to_owned()),
                set: c.orders.process.values[..self.values].iter().map(|v| number(*v)).collect(),
                measured: c.reports.source.values[..self.values].iter().map(|v| number(*v)).collect(),
            },
            axes: axes.collect(),
            tip: [tip.point.x, tip.point.y, tip.point.z, -tip.direction.x, -tip.direction.y, -tip.direction.z],
            tool: crate::view::rows(&machine.tool_frame(&q)),
            arm: crate::view::arm_view(machine, &q),
            links: machine.link_frames(&q)[..count].iter().map(crate::view::rows).collect(),
            conditions: (0..conditions).map(|i| unmet >> i & 1 == 0).collect(),
            inputs: (0..conditions).map(|i| c.reports.inputs >> i & 1 == 1).collect(),
            tracking: crate::view::tracking(&c.tracked),
            near: None,
            ages: Ages {
                drives: number(drives.age_s),
                source: number(c.reports.source.age_s),
                inputs: number(c.reports.inputs_age_s),
            },
            missed: extra.missed,
            longest_gap_ms: 1e3 * f64::from(extra.longest) * machine.servo_period_s,
            realtime: RealtimeView {
                missing: extra.footing.into_iter().flat_map(RealtimeRights::missing).map(str::to_owned).collect(),
                text: extra.footing.map_or_else(String::new, ToString::to_string),
            },
            lost: c.lost,
            left: extra.left,
            start: extra.start,
            part: extra.part,
            recording: extra.recording,
            stands: extra.stands,
        }
    }
}

/// Commands whose missing conditions can be queried.
pub(crate) const WHY: [(&str, Event); 7] = [
    ("switch_on", Event::SwitchOn),
    ("home", Event::Home),
    ("start_jog", Event::Jog),
    ("start_dry_run", Event::DryRun),
    ("start_weld", Event::Weld),
    ("resume", Event::Weld),
    ("reset", Event::Reset),
];

/// Status data that the desk adds to that of the cycle.
pub(super) struct Extra<'a> {
    pub(super) missed: u32,
    /// Maximum number of cycles missed at once.
    pub(super) longest: u32,
    pub(super) footing: Option<&'a RealtimeRights>,
    pub(super) left: Option<LeftView>,
    pub(super) start: Option<(u32, f64)>,
    pub(super) part: String,
    pub(super) recording: Option<i64>,
    pub(super) stands: bool,
}

pub(crate) fn mode(mode: Mode) -> &'static str {
    match mode {
        Mode::DryRun => "dry_run",
        other => other.name(),
    }
}
