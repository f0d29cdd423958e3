use crate::disturbance::uniform;
use crate::drives::DriveSet;
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use seamwright_executive::devices::{
    DeviceSet, Drives, InputBits, Inputs, LATE_PERIODS, PowerState, Source, UNREFERENCED_ERROR,
};
use seamwright_executive::{
    DriveReport, Error, Interlocks, Orders, ProcessOrders, Slack, SourceReport, VALUES, Watchdog,
};
use seamwright_machine::{Joints, Machine};

/// All drives of a machine in simulation: position loops, motors, friction, cogging, encoders; brakes that close
/// without power.
#[derive(Debug, Clone)]
pub struct SimulatedDrives {
    drives: DriveSet,
    axes: usize,
    period: f64,
    /// True positions.
    q: Joints,
    power: PowerState,
    holds: bool,
}

impl SimulatedDrives {
    /// Places the axes without power at the machine's home positions, references unknown; `seed` sets friction and
    /// noise.
    ///
    /// # Errors
    /// Invalid drive values in the machine file.
    pub fn new(machine: &Machine, seed: u64) -> Result<Self, Error> {
        Ok(Self {
            drives: DriveSet::new(machine, seed)?,
            axes: machine.axes.len(),
            period: machine.servo_period_s,
            q: machine.home(),
            power: PowerState::new(machine.servo_period_s),
            holds: false,
        })
    }

    /// Places the axes at these positions instead of home.
    #[must_use]
    pub fn standing_at(self, q: &Joints) -> Self {
        Self { q: *q, ..self }
    }
}

impl Drives for SimulatedDrives {
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
        let (powered, follows) = self.power.step(orders);
        let referenced = self.power.is_referenced();
        if follows && !self.holds {
            self.drives.settle_at(&self.q[..self.axes]);
        }
        self.holds = follows;
        for i in 0..self.axes {
            if follows {
                let mut set = orders.set[i];
                if !referenced {
                    set.position -= UNREFERENCED_ERROR;
                }
                let state = self.drives.step(i, set);
                self.q[i] = state.position;
                report.position[i] = state.measured;
                report.following_error[i] = state.following_error;
                report.current[i] = state.current;
            } else {
                (report.position[i], report.following_error[i], report.current[i]) = (self.q[i], 0.0, 0.0);
            }
            if !referenced {
                report.position[i] += UNREFERENCED_ERROR;
            }
        }
        report.powered = powered;
        report.referenced = if referenced { (1 << self.axes) - 1 } else { 0 };
        (report.fault, report.limit_switch, report.age_s) = (0, 0, 0.0);
        report.starts = report.starts.max(1);
    }

    /// Simulated time stands still between exchanges.
    fn rides_out(&self) -> Slack {
        Slack::standing(self.period)
    }

    fn late_s(&self) -> f64 {
        LATE_PERIODS * self.period
    }

    fn truth(&self) -> Option<&Joints> {
        Some(&self.q)
    }
}

/// Simulated devices of `machine` with all interlocks met; `seed` sets friction, noise and ignition.
///
/// # Errors
/// Invalid drive values in the machine file.
pub fn simulated_devices(
    machine: &Machine,
    seed: u64,
) -> Result<DeviceSet<SimulatedDrives, SimulatedSource, SimulatedInputs>, Error> {
    Ok(DeviceSet {
        drives: SimulatedDrives::new(machine, seed)?,
        source: SimulatedSource::new(seed, machine.servo_period_s),
        inputs: SimulatedInputs::all_met(machine),
    })
}

/// Time constant of process values, s.
const FOLLOWS_S: f64 = 0.03;
/// Noise of measured process values, relative.
const NOISE: f64 = 0.01;
/// Time from off until arc or beam is extinguished, s.
const GOES_OUT_S: f64 = 0.01;

/// A process source in simulation: an arc that takes a moment to ignite, values that follow with noise.
#[derive(Debug, Clone)]
pub struct SimulatedSource {
    random: Pcg64Mcg,
    period: f64,
    on_for: f64,
    off_for: f64,
    /// Ignition time, s.
    strikes_s: f64,
    burning: bool,
    values: [f64; VALUES],
}

impl SimulatedSource {
    /// Creates the source with random numbers from `seed`; `period_s` is the cycle's period.
    pub fn new(seed: u64, period_s: f64) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(seed ^ 0x5eed_50c3);
        let strikes_s = 0.05 + 0.1 * uniform(&mut random);
        Self { random, period: period_s, on_for: 0.0, off_for: 1.0, strikes_s, burning: false, values: [0.0; VALUES] }
    }

    /// Returns the true arc or beam state.
    pub fn burns(&self) -> bool {
        self.burning
    }
}

impl Source for SimulatedSource {
    fn exchange(&mut self, orders: &ProcessOrders, _watchdog: Watchdog, report: &mut SourceReport) {
        if orders.on {
            (self.on_for, self.off_for) = (self.on_for + self.period, 0.0);
            self.burning |= self.on_for >= self.strikes_s;
        } else {
            (self.on_for, self.off_for) = (0.0, self.off_for + self.period);
            if self.off_for >= GOES_OUT_S && self.burning {
                self.burning = false;
                self.strikes_s = 0.05 + 0.1 * uniform(&mut self.random);
            }
        }
        for ((value, wanted), shown) in self.values.iter_mut().zip(orders.values).zip(&mut report.values) {
            let wanted = if self.burning && wanted.is_finite() { wanted } else { 0.0 };
            *value += (wanted - *value) * (self.period / FOLLOWS_S).min(1.0);
            *shown = *value * (1.0 + NOISE * (2.0 * uniform(&mut self.random) - 1.0));
        }
        (report.ready, report.burning, report.stuck, report.fault, report.age_s) = (true, self.burning, false, 0, 0.0);
        report.starts = report.starts.max(1);
    }
}

/// Simulated inputs with constant bits.
#[derive(Debug, Clone)]
pub struct SimulatedInputs {
    bits: u64,
}

impl SimulatedInputs {
    /// Creates inputs with which all interlocks of `machine` are met.
    pub fn all_met(machine: &Machine) -> Self {
        Self::new(Interlocks::new(&machine.interlocks).all_met())
    }

    /// Creates inputs that always read `bits`.
    pub fn new(bits: u64) -> Self {
        Self { bits }
    }
}

impl Inputs for SimulatedInputs {
    fn exchange(&mut self, _watchdog: Watchdog, inputs: &mut InputBits) {
        *inputs = InputBits { bits: self.bits, starts: inputs.starts.max(1), age_s: 0.0 };
    }
}
