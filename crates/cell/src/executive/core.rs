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
use seamwright_motion::jog;
use seamwright_motion::pace::RunPhase;
use seamwright_servo::SetPoint;

/// How long an arming holds, s.
const ARMED_S: f64 = 60.0;
/// Most commands taken in a cycle.
const COMMANDS: usize = 8;
/// Why [`Executive::serve`] came back.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// Everything is off.
    Quit,
    /// It wants to serve another program at once: nothing moves, but drives may have power and want to hear.
    Load,
}

/// What the program is doing in a cycle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Doing {
    /// Arc or beam is asked for.
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
/// Guarantees, tested by a campaign of faults at any moment in every mode: the process is off in the cycle after the one that
/// reports what takes it away; set-points are always on the planned path or at rest, within every axis' limits, until power
/// goes; nothing moves and no process comes on without a command for it after whatever stopped it.
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
    /// What a program that runs or is held is: with or without process.
    pub(super) welds: bool,
    /// Until when the process may be started, s.
    armed_until: f64,
    pub(super) pace: f64,
    /// The program shall go back, or stand still where it does.
    pub(super) reverse: bool,
    pub(super) halt: bool,
    /// The axis that goes home alone, if the others do not.
    pub(super) homes_one: Option<usize>,
    /// What the hand on the keys wants, fresh in this cycle.
    pub(super) jog: Option<jog::Command>,
    pub(super) end: Option<End>,
    /// When the outside asked for the end, s.
    pub(super) shuts_down_since: Option<f64>,
    cycles: u64,
    pub(super) orders: Orders,
    pub(super) reports: Reports,
    pub(super) doing: Doing,
    /// Where a program was left.
    left: Option<Place>,
    /// What corrects passes.
    pub(super) guide: Option<&'a mut (dyn Guide + 'a)>,
    /// It corrects the pass that is run.
    pub(super) guided: bool,
    /// Greatest part of the planned speed that it allows.
    pub(super) guide_pace: f64,
    /// What it has told last.
    pub(super) guide_trouble: Option<Trouble>,
    /// Planned positions of the pass in the last cycle.
    pub(super) planned_q: Joints,
}

impl<'a, D: Devices, P: Port> Executive<'a, D, P> {
    /// An executive that is off.
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
            pace: 1.0,
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
            guide_pace: 1.0,
            guide_trouble: None,
            planned_q: Joints::default(),
        }
    }

    /// Passes are corrected by `guide` from now on.
    #[must_use]
    pub fn with_guide(mut self, guide: Option<&'a mut (dyn Guide + 'a)>) -> Self {
        self.guide = guide;
        self
    }

    /// Its devices, at its end.
    pub fn into_devices(self) -> D {
        self.devices
    }

    /// Its devices; between two calls of [`Executive::serve`] parts of them can be changed.
    pub fn devices_mut(&mut self) -> &mut D {
        &mut self.devices
    }

    /// Runs cycle after cycle until [`Ask::Quit`] or [`Ask::Load`]; `work` is what dry runs and welds
    /// run, and what jogging keeps clear of: without it there is neither.
    pub fn serve(&mut self, work: Option<&Work<'_>>) -> End {
        self.end = None;
        while self.end.is_none() {
            match (self.mode, work) {
                (Mode::Homing, _) => self.home(work),
                (Mode::Jog | Mode::Teach, _) => self.jog_on(work),
                (Mode::DryRun | Mode::Weld, Some(work)) => self.run(work),
                _ => {
                    // What tripped has come to rest.
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
        // Whoever ends leaves nothing on.
        self.power = false;
        self.process.kill();
        self.orders = Orders { set: self.orders.set, watchdog: !self.orders.watchdog, ..Orders::default() };
        self.devices.exchange(&self.orders, &mut self.reports);
        End::Quit
    }

    /// All axes, a bit each.
    pub(super) fn all_axes(&self) -> u16 {
        (1u16 << self.machine.axes.len()) - 1
    }

    /// Axes whose reference is not known, a bit each.
    pub(super) fn unreferenced(&self) -> u16 {
        !self.reports.drives.referenced & self.all_axes()
    }

    /// Time since it began, s.
    pub fn now(&self) -> f64 {
        self.cycles as f64 * self.machine.servo_period_s
    }

    /// Where a program was left by a stop or a fault and can be gone on with.
    pub fn left(&self) -> Option<Place> {
        self.left
    }

    pub(super) fn is_armed(&self) -> bool {
        self.now() < self.armed_until
    }

    pub(super) fn disarm(&mut self) {
        self.armed_until = f64::NEG_INFINITY;
    }

    /// Goes where `event` leads; false if it leads nowhere.
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

    /// The program was left at a place with the weld unfinished.
    pub(super) fn leave(&mut self, place: Option<Place>) {
        self.left = place;
        if let Some(place) = place {
            self.port.note(self.now(), Note::Left(place));
        }
    }

    /// Set-points where the axes are.
    pub(super) fn take_actual(&mut self) {
        for (set, position) in self.orders.set.iter_mut().zip(self.reports.drives.position) {
            *set = SetPoint { position, velocity: 0.0, acceleration: 0.0 };
        }
    }

    /// Set-points of axes that nobody moves: where they are held, or where they are if they are not.
    pub(super) fn rest_at_actual(&mut self) {
        let held = self.power && self.reports.drives.powered && self.mode != Mode::Homing;
        if !held {
            return self.take_actual();
        }
        for set in &mut self.orders.set {
            *set = SetPoint { position: set.position, velocity: 0.0, acceleration: 0.0 };
        }
    }

    /// One cycle: orders out, reports in, judged; commands; shown.
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
            pace: self.pace,
            tracked: self.guide.as_ref().filter(|_| self.guided).map_or([None; 2], |guide| guide.tracked()),
        };
        let cycle = Cycle { status, orders: &self.orders, reports: &self.reports, alarms: &self.alarms };
        self.port.show(&cycle);
    }

    /// Takes a command, or says what is missing.
    fn take(&mut self, command: Command, work: Option<&Work<'_>>) {
        if let Ask::Why(event) = command.ask {
            for missing in self.missing(event, work) {
                self.port.note(self.now(), Note::Lacks(command, missing));
            }
        }
        let refused = self.obey(command.ask, work).err();
        // The hand on the keys speaks twenty times a second.
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
        let event = match ask {
            Ask::SwitchOn => Event::SwitchOn,
            Ask::SwitchOff => Event::SwitchOff,
            Ask::Home | Ask::HomeAxis(_) => Event::Home,
            Ask::StartJog => Event::Jog,
            Ask::StartTeach => Event::Teach,
            Ask::StartDryRun => Event::DryRun,
            Ask::StartWeld => Event::Weld,
            Ask::Reset => Event::Reset,
            Ask::Resume if self.welds => Event::Weld,
            Ask::Resume => Event::DryRun,
            _ => return self.adjust(ask, work),
        };
        // What is held goes on as what it is.
        let starts = matches!(ask, Ask::StartDryRun | Ask::StartWeld);
        if self.mode == Mode::Hold && starts || self.mode != Mode::Hold && ask == Ask::Resume {
            return Err(Missing::Mode(super::Refused { mode: self.mode, event }));
        }
        if let Some(missing) = self.missing(event, work).first() {
            return Err(*missing);
        }
        let one = if let Ask::HomeAxis(axis) = ask { Some(self.home_one(axis)?) } else { None };
        if starts {
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

    /// Commands that change no mode.
    fn adjust(&mut self, ask: Ask, work: Option<&Work<'_>>) -> Result<(), Missing> {
        match ask {
            Ask::Override(value) if (0.0..=1.0).contains(&value) => self.pace = value,
            Ask::Override(_) => return Err(Missing::Value),
            Ask::Acknowledge => drop(self.alarms.acknowledge()),
            Ask::AcknowledgeOne(alarm, detail) => drop(self.alarms.acknowledge_one(alarm, detail)),
            Ask::Arm => {
                let missing = self.missing(Event::Weld, work);
                if let Some(missing) = missing.iter().find(|m| **m != Missing::Arming) {
                    return Err(*missing);
                }
                if self.mode == Mode::Hold && !self.welds {
                    return Err(Missing::Motion);
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
                // What was left belonged to the program before.
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

    /// Axes of a set-point that moves.
    pub(super) fn set(&mut self, positions: &[f64; MAX_AXES], speeds: &[f64], accelerations: &[f64]) {
        for (i, set) in self.orders.set.iter_mut().enumerate() {
            *set = SetPoint { position: positions[i], velocity: speeds[i], acceleration: accelerations[i] };
        }
    }
}
