//! Check of a motion that comes from another process, before an executive plays it.

use crate::feed_override::{Rates, Timed};
use crate::pass_motion::PassMotion;
use crate::transfer::Leg;
use crate::weld_motion::WeldMotion;
use seamwright_machine::Machine;
use seamwright_message::Message;

/// Set-points of each pass that are compared with the limits.
const SAMPLES: usize = 2000;
/// Relative excess over a limit that is rounding: planning itself keeps a reserve.
const ROUNDING: f64 = 1e-6;
/// Excess over the end of a range that is rounding, mm or rad.
const POSITION: f64 = 1e-6;

impl WeldMotion {
    /// Checks that `machine` can play this motion: its structure is whole, all numbers are finite, transfers lead from one
    /// pass to the next, and positions, speeds and accelerations at 2,000 instants of each pass and 100 of each leg are
    /// within the axes' limits. It costs some milliseconds a pass.
    ///
    /// # Errors
    /// The first fault, with its pass.
    pub fn verify(&self, machine: &Machine) -> Result<(), Message> {
        let fault = |pass: usize, why: &str| {
            Message::new("motion-not-verified").pass("pass", pass).message("why", Message::verbatim(why))
        };
        if self.transfers.len() != self.passes.len() + 1 {
            return Err(fault(0, "transfers"));
        }
        for (i, pass) in self.passes.iter().enumerate() {
            verify_pass(pass, machine).map_err(|why| fault(i + 1, why))?;
        }
        for (i, leg) in
            self.transfers.iter().enumerate().flat_map(|(i, move_)| move_.legs.iter().map(move |leg| (i, leg)))
        {
            verify_leg(leg, machine).map_err(|why| fault(i + 1, why))?;
        }
        Ok(())
    }
}

fn verify_pass(pass: &PassMotion, machine: &Machine) -> Result<(), &'static str> {
    if !pass.path.is_whole(machine.axes.len()) {
        return Err("path");
    }
    if !pass.profile.is_whole(pass.path.length()) {
        return Err("profile");
    }
    let timed = pass.timed(machine);
    let duration = timed.duration();
    (0..=SAMPLES).try_for_each(|k| within(machine, &timed.at(duration * k as f64 / SAMPLES as f64, true)))
}

fn verify_leg(leg: &Leg, machine: &Machine) -> Result<(), &'static str> {
    let duration = Timed::duration(leg);
    if !(0.0..=f64::MAX).contains(&duration) {
        return Err("transfer");
    }
    (0..=100).try_for_each(|k| within(machine, &Timed::at(leg, duration * f64::from(k) / 100.0, true)))
}

fn within(machine: &Machine, rates: &Rates) -> Result<(), &'static str> {
    for (i, axis) in machine.axes.iter().enumerate() {
        let limits = axis.limits();
        let exceeds = |value: f64, limit: f64| value.is_nan() || value.abs() > limit * (1.0 + ROUNDING);
        if !rates.q[i].is_finite()
            || axis.outside(rates.q[i]).is_some_and(|limit| (rates.q[i] - limit).abs() > POSITION)
        {
            return Err("range");
        }
        if exceeds(rates.v[i], limits.speed) {
            return Err("speed");
        }
        if exceeds(rates.a[i], limits.acceleration) {
            return Err("acceleration");
        }
    }
    Ok(())
}
