use super::device_interface::{Devices, Orders, ProcessOrders, Reports, SeamOrders};
use seamwright_machine::{Joints, MAX_AXES};
use seamwright_servo::SetPoint;

/// The devices, the orders to them and their last reports.
pub(super) struct DeviceIo<D> {
    pub(super) devices: D,
    pub(super) orders: Orders,
    pub(super) reports: Reports,
    /// The drives are to have power.
    pub(super) power: bool,
    /// All axes, one bit each.
    axes: u16,
}

impl<D: Devices> DeviceIo<D> {
    pub(super) fn new(devices: D, axes: usize) -> Self {
        let axes = (1u16 << axes) - 1;
        Self { devices, orders: Orders::default(), reports: Reports::default(), power: false, axes }
    }

    /// Gives the orders of this cycle, waits for its start and reads the reports. `late` stops the watchdog outputs.
    pub(super) fn exchange(&mut self, process: ProcessOrders, seam: SeamOrders, late: bool) {
        let watchdog = self.orders.watchdog.next(late);
        self.orders = Orders { power: self.power, process, seam, watchdog, ..self.orders };
        self.devices.exchange(&self.orders, &mut self.reports);
        // After a gap that was too long the devices got the process off: it is shown and recorded so.
        self.orders.process.on &= !self.reports.late;
        self.orders.watchdog.late |= self.reports.late;
    }

    /// Switches all outputs off.
    pub(super) fn switch_off(&mut self) {
        self.power = false;
        let watchdog = self.orders.watchdog.next(self.orders.watchdog.late);
        self.orders = Orders { set: self.orders.set, watchdog, ..Orders::default() };
        self.devices.exchange(&self.orders, &mut self.reports);
    }

    /// Returns true if the drives are to have power and report it.
    pub(super) fn is_powered(&self) -> bool {
        self.power && self.reports.drives.powered
    }

    /// Returns the axes with unknown references, one bit each.
    pub(super) fn unreferenced(&self) -> u16 {
        !self.reports.drives.referenced & self.axes
    }

    pub(super) fn positions(&self) -> Joints {
        self.orders.set.map(|set| set.position)
    }

    /// Sets the set-points of moving axes.
    pub(super) fn set(&mut self, positions: &[f64; MAX_AXES], speeds: &[f64], accelerations: &[f64]) {
        for (i, set) in self.orders.set.iter_mut().enumerate() {
            *set = SetPoint { position: positions[i], velocity: speeds[i], acceleration: accelerations[i] };
        }
    }

    /// Sets resting set-points at the last ones.
    pub(super) fn rest(&mut self) {
        for set in &mut self.orders.set {
            *set = SetPoint { position: set.position, velocity: 0.0, acceleration: 0.0 };
        }
    }

    /// Sets resting set-points at the actual positions.
    pub(super) fn take_actual(&mut self) {
        for (set, position) in self.orders.set.iter_mut().zip(self.reports.drives.position) {
            *set = SetPoint { position, velocity: 0.0, acceleration: 0.0 };
        }
    }
}
