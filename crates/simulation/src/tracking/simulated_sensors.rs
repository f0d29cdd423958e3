//! Simulated devices that see the joint. They know its true position and that of the torch.

use super::beam::camera::{BeamCamera, Glance, Hidden, Noise, Shown};
use super::beam::picture_queue::PictureQueue;
use super::beam::recent_positions::{GunPosition, RecentPositions};
use super::sensor_model::{Sensor, SensorModel};
use super::world::World;
use crate::error::Error;
use arrayvec::ArrayVec;
use glam::{DVec3, Vec3Swizzles as _};
use seamwright_executive::devices::Sensors;
use seamwright_executive::tracking::LeadingSensor;
use seamwright_executive::{SeamOrders, SensorReport};
use seamwright_machine::{Joints, Machine};
use seamwright_tracking::beam::{Beam, Picture};
use seamwright_tracking::lead::SeamFrame;

/// Simulated device that sees the joint of one head in a pass.
pub(crate) struct SimulatedHead<'a> {
    number: usize,
    world: World<'a>,
    /// Distance of the machine's tip behind the arc, mm.
    drawn_back: f64,
    eye: SimulatedSensor,
}

/// Kind of device.
pub(super) enum SimulatedSensor {
    /// A sensor ahead, and its displacement in the last period: along the seam, lateral and height from the planned
    /// path, mm.
    Leading(Box<Sensor>, DVec3),
    /// The beam.
    Beam { noise: Noise, pictures: PictureQueue, recent: RecentPositions },
}

/// The simulated seam as the camera of a beam.
struct WorldSensor<'a, 'b>(&'a World<'b>, &'a mut Noise);

impl BeamCamera for WorldSensor<'_, '_> {
    fn glance(&mut self, glance: &Glance<'_>, shown: &mut Shown) -> Result<(), Error> {
        self.1.show(self.0 as &dyn Hidden, glance, shown);
        Ok(())
    }
}

impl SimulatedSensor {
    pub(super) fn leading(sensor: &LeadingSensor, seed: u64) -> Self {
        Self::Leading(Box::new(Sensor::new(SensorModel::of(sensor), seed)), DVec3::ZERO)
    }

    pub(super) fn beam(noise_mm: f64, latency_s: f64, seed: u64) -> Self {
        let (noise, pictures) = (Noise::new(noise_mm, seed), PictureQueue::new(latency_s, seed));
        Self::Beam { noise, pictures, recent: RecentPositions::new() }
    }
}

impl<'a> SimulatedHead<'a> {
    pub(super) fn new(number: usize, world: World<'a>, drawn_back: f64, eye: SimulatedSensor) -> Self {
        Self { number, world, drawn_back, eye }
    }

    /// Runs a period at whose end the axes are at `q`.
    fn step(&mut self, machine: &Machine, orders: &SeamOrders, q: &Joints, report: &mut SensorReport) {
        let (t, s) = (orders.t_s, orders.s_mm);
        let tip = machine.forward_of(self.number, q).ahead(self.drawn_back).point;
        match &mut self.eye {
            SimulatedSensor::Leading(sensor, carried) => {
                sensor.look(&self.world, t, s + carried.x, carried.yz());
                // The torch lags behind its set-point along the seam; the sensor swings with it.
                let set = (self.world.taught)(s);
                let along = set.components(tip - set.point).x;
                let frame = (self.world.taught)(s + along);
                *carried = DVec3 { x: along, ..frame.components(tip - frame.point) };
                report.measured[self.number] = sensor.arrived(t).flatten();
            }
            SimulatedSensor::Beam { noise, pictures, recent } => {
                if let Beam::Seen(exposed_s) = orders.beam
                    && let Some(at) = recent.at(exposed_s)
                {
                    let torch = SeamFrame { point: at.tip, ..(self.world.taught)(at.s) };
                    // A simulated seam is visible wherever the search starts.
                    let glance = Glance { t_s: exposed_s, axes: &at.axes, torch, s_mm: at.s, from: (0.0, None) };
                    let taken = pictures.look(&mut WorldSensor(&self.world, noise), &glance);
                    debug_assert!(taken.is_ok());
                }
                recent.add(GunPosition { t, s, axes: *q, tip });
                pictures.arrive(t);
            }
        }
    }
}

/// All simulated devices that see the joints of a program.
pub struct SimulatedSensors<'a> {
    machine: &'a Machine,
    /// Devices of each pass; empty for a pass that is not tracked.
    passes: Vec<ArrayVec<SimulatedHead<'a>, 2>>,
    /// Observed pass, counted from 0.
    now: Option<usize>,
}

impl<'a> SimulatedSensors<'a> {
    /// Creates an instance without sensors.
    #[must_use]
    pub fn none(machine: &'a Machine) -> Self {
        Self::new(machine, Vec::new())
    }

    pub(crate) fn new(machine: &'a Machine, passes: Vec<ArrayVec<SimulatedHead<'a>, 2>>) -> Self {
        Self { machine, passes, now: None }
    }
}

impl Sensors for SimulatedSensors<'_> {
    fn exchange(&mut self, orders: &SeamOrders, truth: Option<&Joints>, report: &mut SensorReport) {
        report.measured = [None; 2];
        report.starts = report.starts.max(1);
        report.age_s = 0.0;
        self.now = orders.pass.checked_sub(1).filter(|i| *i < self.passes.len());
        let (Some(pass), Some(q)) = (self.now, truth) else { return };
        for head in &mut self.passes[pass] {
            head.step(self.machine, orders, q, report);
        }
    }

    fn picture(&self) -> Option<Picture<'_>> {
        // A beam has one head.
        let SimulatedSensor::Beam { pictures, .. } = &self.passes[self.now?].first()?.eye else { return None };
        pictures.picture()
    }
}
