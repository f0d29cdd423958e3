use super::activity::Activity;
use super::alarm_list::{AlarmList, Place};
use super::clock::{Clock, StopTimer};
use super::device_interface::Devices;
use super::device_io::DeviceIo;
use super::guide::Guide;
use super::guide_state::GuideState;
use super::mode::Mode;
use super::process::Process;
use super::requests::Requests;
use super::supervision::Supervision;
use seamwright_machine::Machine;

/// The executive of a cell: see the module.
///
/// Guarantees, tested by fault injection at any moment in every mode: the process is off in the cycle after the report
/// of its cause. Set-points are always on the planned path or at rest, within every axis limit, until power goes. After
/// any stop, motion and process need a new command.
pub struct Executive<'a, D, P> {
    pub(super) machine: &'a Machine,
    pub(super) port: P,
    pub(super) io: DeviceIo<D>,
    pub(super) clock: Clock,
    pub(super) mode: Mode,
    pub(super) alarms: AlarmList,
    pub(super) supervision: Supervision,
    pub(super) process: Process,
    pub(super) activity: Activity,
    pub(super) requests: Requests,
    pub(super) guide: GuideState<'a>,
    /// Time since the shutdown request.
    pub(super) shutdown: StopTimer,
}

impl<'a, D: Devices, P> Executive<'a, D, P> {
    /// Creates an executive that is off.
    pub fn new(machine: &'a Machine, devices: D, port: P) -> Self {
        Self {
            machine,
            port,
            io: DeviceIo::new(devices, machine.axes.len()),
            clock: Clock::new(machine.servo_period_s),
            mode: Mode::Off,
            alarms: AlarmList::default(),
            supervision: Supervision::new(machine),
            process: Process::new(machine.source),
            activity: Activity::default(),
            requests: Requests::default(),
            guide: GuideState::new(),
            shutdown: StopTimer::default(),
        }
    }

    /// Sets the guide that corrects the passes.
    #[must_use]
    pub fn with_guide(mut self, guide: Option<&'a mut (dyn Guide + 'a)>) -> Self {
        self.guide.guide = guide;
        self
    }

    /// Returns the devices; between two calls of [`Executive::serve`] parts of them can be changed.
    pub fn devices_mut(&mut self) -> &mut D {
        &mut self.io.devices
    }

    /// Returns the time since the start, s.
    pub fn now(&self) -> f64 {
        self.clock.now()
    }

    /// Returns the position at which a stop or a fault left a program that can resume.
    pub fn left(&self) -> Option<Place> {
        self.activity.left
    }

    /// Sets resting set-points: the last ones if the drives hold them, else the actual positions.
    pub(super) fn rest(&mut self) {
        if self.io.is_powered() && self.mode != Mode::Homing {
            self.io.rest();
        } else {
            self.io.take_actual();
        }
    }
}
