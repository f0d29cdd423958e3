use crate::acceptance::Gate;
use crate::conditions::Conditions;
use crate::error::Error;
use crate::sample::Sample;
use crate::simulate::simulate;
use crate::tracking::distortion::Distortion;
use glam::DVec2;
use seamwright_machine::Machine;
use seamwright_message::Message;
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, TorchPath};

/// Displacement of the first fillet, mm: to and fro, so far that the carrier of both heads has to move a little.
const SIZE_MM: f64 = 7.5;
const LENGTH_MM: f64 = 1500.0;

/// Measures the share of one head's correction that appears in the other head's weld. A pass with two heads is welded
/// with the first fillet displaced, and without displacement. `motion` must leave the axes their [`seamwright_executive::tracking::RESERVE`].
///
/// # Errors
/// Those of [`simulate`].
pub fn cross_talk(
    machine: &Machine,
    passes: &[(&dyn TorchPath, &Pass)],
    motion: &WeldMotion,
    seed: u64,
) -> Result<Gate, Error> {
    let displaced = format!(
        "schema = 1\n[[displacement]]\nhead = 1\nwave = {{ length_mm = {LENGTH_MM}, by = {{ lateral_mm = {SIZE_MM} }} }}\n"
    );
    let other = |text: &str| -> Result<Vec<DVec2>, Error> {
        let distortion = Distortion::read("displaced", text).map_err(|e| Error::Distortion(Message::outside(&e)))?;
        let conditions = Conditions { seed, distortion: Some(&distortion), tracking: true, ..Conditions::default() };
        let mut misses = Vec::new();
        simulate(machine, passes, motion, conditions, |sample: &Sample| {
            misses.extend(sample.heads[1].filter(|_| sample.travels()).map(|head| head.miss));
            Ok::<(), Error>(())
        })?;
        Ok(misses)
    };
    let (with, without) = (other(&displaced)?, other("schema = 1\n")?);
    let apart = with.iter().zip(&without).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    let part = if with.len() == without.len() { 100.0 * apart / SIZE_MM } else { f64::INFINITY };
    let frames = format!("two heads, the first displaced by {SIZE_MM} mm");
    Ok(Gate::at_most(&frames, "of that in the other's weld", part, 1.0, "%"))
}
