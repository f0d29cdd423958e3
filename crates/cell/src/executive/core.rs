use super::VALUES;
use super::alarm_list::{AlarmList, Place};
use super::bus::{Devices, Orders, Reports};
use super::command::{Ask, Command};
use super::guide::{Guide, SeamOrders, Trouble};
use super::interlocks::Interlocks;
use super::mode::{Event, Mode};
use super::process::Process;
use super::state::{Cycle, Missing, Note, Port, Status};
use super::supervision::Supervision;
use super::work::Work;
use seamwright_machine::{Joints, MAX_AXES, Machine};
use seamwright_motion::feed_override::RunPhase;
use seamwright_motion::jog;
use seamwright_servo::SetPoint;

/// Validity of an arming, s.
const ARMED_S: f64 = 60.0;
/// Maximum number of commands taken in a cycle.
const COMMANDS: usize = 8;
/// Reasons for the return of [`Executive::serve`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// Everything is off.
    Quit,
    /// The caller must serve another program at once: nothing moves, but drives may have power and need orders.
    Load,
}

/// State of the program in a cycle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Doing {
    /// Arc or beam is requested.
    pub(super) asked: bool,
    pub(super) gas: bool,
    pub(super) values: [f64; VALUES],
    pub(super) phase: Option<RunPhase>,
    pub(super) place: Place,
    pub(super) speed: f64,
    pub(super) steady: bool,
    pub(super) welded_mm: f64,
    pub(super) seam: SeamOrders,
}

/// The executive of a cell: see the module.
///
/// Guarantees, tested by fault injection at any moment in every mode: the process is off in the cycle after the report
/// of its cause. Set-points are always on the planned path or at rest, within every axis limit, until power goes. After
/// any stop, motion and process need a new command.
pub struct Executive<'a, D, P> {
    pub(super) machine: &'a Machine,
    pub(super) devices: D,
    pub(super) port: P,
    pub(super) interlocks: Interlocks,
    pub(super) alarms: AlarmList,
    pub(super) process: Process,
    pub(super) supervision: Supervision,
    pub(super) mode: Mode,
    /// The drives are to have power.
    pub(super) power: bool,
    /// A program or a jog has not come to rest.
    pub(super) busy: bool,
    /// The running or held program welds; false for a dry run.
    pub(super) welds: bool,
    /// End of the arming, s.
    armed_until: f64,
    pub(super) feed_override: f64,
    /// Orders of a held program: reverse along the path, or stop.
    pub(super) reverse: bool,
    pub(super) halt: bool,
    /// The axis that goes home alone; `None` for all axes.
    pub(super) homes_one: Option<usize>,
    /// The jog command of the enabling switch, received in this cycle.
    pub(super) jog: Option<jog::Command>,
    pub(super) end: Option<End>,
    /// Time of the shutdown request, s.
    pub(super) shuts_down_since: Option<f64>,
    cycles: u64,
    pub(super) orders: Orders,
    pub(super) reports: Reports,
    pub(super) doing: Doing,
    /// Position at which a program was left.
    left: Option<Place>,
    /// Corrects the passes.
    pub(super) guide: Option<&'a mut (dyn Guide + 'a)>,
    /// The guide corrects the current pass.
    pub(super) guided: bool,
    /// Maximum feed override of the guide.
    pub(super) guide_override: f64,
    /// Last trouble of the guide.
    pub(super) guide_trouble: Option<Trouble>,
    /// Time of the fault that stops the running program, s.
    pub(super) fault_since: Option<f64>,
    /// Planned positions of the pass in the last cycle.
    pub(super) planned_q: Joints,
}

impl<'a, D: Devices, P: Port> Executive<'a, D, P> {
    /// Creates an executive that is off.
    pub fn new(machine: &'a Machine, devices: D, port: P) -> Self {
        Self {
            machine,
            devices,
            port,
            interlocks: Interlocks::new(&machine.interlocks),
            alarms: AlarmList::default(),
            process: Process::new(machine.source, machine.servo_period_s),
            supervision: Supervision::new(machine),
            mode: Mode::Off,
            power: false,
            busy: false,
            welds: false,
            armed_until: f64::NEG_INFINITY,
            feed_override: 1.0,
            reverse: false,
            halt: false,
            homes_one: None,
            jog: None,
            end: None,
            shuts_down_since: None,
            cycles: 0,
            orders: Orders::default(),
            reports: Reports::default(),
            doing: Doing::default(),
            left: None,
            guide: None,
            guided: false,
            guide_override: 1.0,
            guide_trouble: None,
            fault_since: None,
            planned_q: Joints::default(),
        }
    }

    /// Sets the guide that corrects the passes.
    #[must_use]
    pub fn with_guide(mut self, guide: Option<&'a mut (dyn Guide + 'a)>) -> Self {
        self.guide = guide;
        self
    }

    /// Returns the devices, at its end.
    pub fn into_devices(self) -> D {
        self.devices
    }

    /// Returns the devices; between two calls of [`Executive::serve`] parts of them can be changed.
    pub fn devices_mut(&mut self) -> &mut D {
        &mut self.devices
    }

    /// Runs cycles until [`Ask::Quit`] or [`Ask::Load`]. `work` contains the program of dry runs and welds, and the
    /// surroundings for jogging: without it both are refused.
    pub fn serve(&mut self, work: Option<&Work<'_>>) -> End {
        self.end = None;
        while self.end.is_none() {
            match (self.mode, work) {
                (Mode::Homing, _) => self.home(work),
                (Mode::Jog | Mode::Teach, _) => self.jog_on(work),
                (Mode::DryRun | Mode::Weld, Some(work)) => self.run(work),
                _ => {
                    // A tripped cell is at rest here.
                    self.power &= self.mode.has_power();
                    self.rest_at_actual();
                    self.tick(Doing::default(), work);
                    if self.mode == Mode::Idle && self.reports.drives.powered && self.unreferenced() == 0 {
                        self.event(Event::Homed);
                    }
                }
            }
        }
        if self.end == Some(End::Load) {
            return End::Load;
        }
        // Switches all outputs off on exit.
        self.power = false;
        self.process.kill();
        self.orders = Orders { set: self.orders.set, watchdog: !self.orders.watchdog, ..Orders::default() };
        self.devices.exchange(&self.orders, &mut self.reports);
        End::Quit
    }

    /// Returns all axes, one bit each.
    pub(super) fn all_axes(&self) -> u16 {
        (1u16 << self.machine.axes.len()) - 1
    }

    /// Returns the axes with unknown references, one bit each.
    pub(super) fn unreferenced(&self) -> u16 {
        !self.reports.drives.referenced & self.all_axes()
    }

    /// Returns the time since the start, s.
    pub fn now(&self) -> f64 {
        self.cycles as f64 * self.machine.servo_period_s
    }

    /// Returns the position at which a stop or a fault left a program that can resume.
    pub fn left(&self) -> Option<Place> {
        self.left
    }

    pub(super) fn is_armed(&self) -> bool {
        self.now() < self.armed_until
    }

    pub(super) fn disarm(&mut self) {
        self.armed_until = f64::NEG_INFINITY;
    }

    /// Enters the mode after `event`; false if the mode does not accept it.
    pub(super) fn event(&mut self, event: Event) -> bool {
        let Ok(mode) = self.mode.after(event) else { return false };
        if mode != self.mode {
            self.port.note(self.now(), Note::Mode(self.mode, mode));
            if mode != Mode::Weld {
                self.disarm();
            }
            self.mode = mode;
        }
        true
    }

    /// Stores the position at which the program was left with the weld unfinished.
    pub(super) fn leave(&mut self, place: Option<Place>) {
        self.left = place;
        if let Some(place) = place {
            self.port.note(self.now(), Note::Left(place));
        }
    }

    /// Sets the set-points to the actual positions.
    pub(super) fn take_actual(&mut self) {
        for (set, position) in self.orders.set.iter_mut().zip(self.reports.drives.position) {
            *set = SetPoint { position, velocity: 0.0, acceleration: 0.0 };
        }
    }

    /// Sets resting set-points: the last ones if the drives hold them, else the actual positions.
    pub(super) fn rest_at_actual(&mut self) {
        let held = self.power && self.reports.drives.powered && self.mode != Mode::Homing;
        if !held {
            return self.take_actual();
        }
        for set in &mut self.orders.set {
            *set = SetPoint { position: set.position, velocity: 0.0, acceleration: 0.0 };
        }
    }

    /// Runs one cycle: orders out, reports in, supervision, commands, display.
    pub(super) fn tick(&mut self, mut doing: Doing, work: Option<&Work<'_>>) {
        if self.port.shuts_down() {
            self.shut_down(&mut doing);
        }
        self.doing = doing;
        let alarm = self.process.step(doing.asked, &self.reports.source);
        self.orders.power = self.power;
        self.orders.watchdog = !self.orders.watchdog;
        self.orders.process.on = self.process.on();
        self.orders.process.gas = doing.gas;
        self.orders.process.values = doing.values;
        self.orders.seam = SeamOrders { t_s: self.now(), ..doing.seam };
        self.devices.exchange(&self.orders, &mut self.reports);
        self.cycles += 1 + u64::from(self.reports.missed);
        if let Some(alarm) = alarm {
            self.happened(alarm, 0);
        }
        self.supervise();
        self.jog = None;
        for _ in 0..COMMANDS {
            if self.shuts_down_since.is_some() {
                break;
            }
            let Some(command) = self.port.command(self.now()) else { break };
            self.take(command, work);
        }
        let status = Status {
            t: self.now(),
            mode: self.mode,
            place: doing.place,
            phase: doing.phase,
            speed: doing.speed,
            steady: doing.steady,
            welded_mm: doing.welded_mm,
            process: self.process.state(),
            armed: self.is_armed(),
            feed_override: self.feed_override,
            tracked: self.guide.as_ref().filter(|_| self.guided).map_or([None; 2], |guide| guide.tracked()),
        };
        let cycle = Cycle { status, orders: &self.orders, reports: &self.reports, alarms: &self.alarms };
        self.port.show(&cycle);
    }

    /// Executes a command, or notes the reason for its refusal.
    fn take(&mut self, command: Command, work: Option<&Work<'_>>) {
        if let Ask::Why(event) = command.ask {
            for missing in self.missing(event, work) {
                self.port.note(self.now(), Note::Lacks(command, missing));
            }
        }
        let refused = self.obey(command.ask, work).err();
        // Jog commands come twenty times a second: note only refusals.
        let told = !matches!(command.ask, Ask::Jog(_)) || refused.is_some();
        if told {
            self.port.note(self.now(), refused.map_or(Note::Taken(command), |m| Note::Refused(command, m)));
        }
    }

    fn obey(&mut self, ask: Ask, work: Option<&Work<'_>>) -> Result<(), Missing> {
        if ask.stops() {
            if ask == Ask::Stop {
                self.stop();
            } else {
                self.halt = true;
                self.event(Event::Hold);
            }
            return Ok(());
        }
        let Some(event) = ask.event(self.welds) else { return self.adjust(ask, work) };
        // The drives' power is one of the conditions of `missing`.
        if let Some(refused) = ask.refused_in(self.mode, self.welds, true) {
            return Err(refused);
        }
        if let Some(missing) = self.missing(event, work).first() {
            return Err(*missing);
        }
        let one = if let Ask::HomeAxis(axis) = ask { Some(self.home_one(axis)?) } else { None };
        if matches!(ask, Ask::StartDryRun | Ask::StartWeld) {
            self.welds = event == Event::Weld;
        }
        self.homes_one = one;
        (self.reverse, self.halt) = (false, false);
        self.event(event);
        self.disarm();
        match event {
            Event::SwitchOn => {
                self.power = true;
                self.supervision.switched_on();
            }
            Event::SwitchOff => self.power = false,
            _ => {}
        }
        Ok(())
    }

    /// Executes commands that do not change the mode.
    fn adjust(&mut self, ask: Ask, work: Option<&Work<'_>>) -> Result<(), Missing> {
        match ask {
            Ask::Override(value) if (0.0..=1.0).contains(&value) => self.feed_override = value,
            Ask::Override(_) => return Err(Missing::Value),
            Ask::Acknowledge => drop(self.alarms.acknowledge()),
            Ask::AcknowledgeOne(alarm, detail) => drop(self.alarms.acknowledge_one(alarm, detail)),
            Ask::Arm => {
                let missing = self.missing(Event::Weld, work);
                if let Some(missing) = missing.iter().find(|m| **m != Missing::Arming) {
                    return Err(*missing);
                }
                if let Some(refused) = ask.refused_in(self.mode, self.welds, true) {
                    return Err(refused);
                }
                self.armed_until = self.now() + ARMED_S;
            }
            Ask::Jog(command) if matches!(self.mode, Mode::Jog | Mode::Teach) => self.jog = Some(command),
            Ask::Jog(_) => return Err(Missing::Mode(super::Refused { mode: self.mode, event: Event::Jog })),
            Ask::Reverse if self.mode == Mode::Hold => {
                if let Some(missing) = self.missing(Event::DryRun, work).first() {
                    return Err(*missing);
                }
                (self.reverse, self.halt) = (true, false);
            }
            Ask::Reverse => return Err(Missing::Motion),
            Ask::Why(_) => {}
            Ask::Load if self.busy || self.mode.moves() || self.mode == Mode::Hold => return Err(Missing::Moving),
            Ask::Load => {
                // The position belonged to the previous program.
                self.left = None;
                self.disarm();
                self.end = Some(End::Load);
            }
            Ask::Quit if self.busy || self.power => return Err(Missing::Moving),
            Ask::Quit => self.end = Some(End::Quit),
            _ => return Err(Missing::Motion),
        }
        Ok(())
    }

    /// Sets the set-points of moving axes.
    pub(super) fn set(&mut self, positions: &[f64; MAX_AXES], speeds: &[f64], accelerations: &[f64]) {
        for (i, set) in self.orders.set.iter_mut().enumerate() {
            *set = SetPoint { position: positions[i], velocity: speeds[i], acceleration: accelerations[i] };
        }
    }
}
