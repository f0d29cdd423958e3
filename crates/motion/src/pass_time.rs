//! Limits of the time of a pass: set-points, blocks and rows of longer ones would exceed memory and acceptable run
//! time.

use crate::speed_profile::SpeedProfile;
use seamwright_message::{Message, Unit};
use seamwright_program::{Finding, Pass, PathRange};

/// Maximum time of a pass or of a part of its sequence, s: more than two days. Longer times come from a wrong unit or
/// exponent.
pub(crate) const MAX_PASS_S: f64 = 2e5;

pub(crate) fn too_long(pass: &Pass, number: usize) -> Vec<Finding> {
    let sequence = &pass.sequence;
    let times = [
        ("sequence.preflow_s", sequence.preflow_s.get(), 0.0),
        ("sequence.travel_delay_s", sequence.travel_delay_s.get(), 0.0),
        ("sequence.crater_s", sequence.crater_s.get(), pass.length()),
        ("sequence.postflow_s", sequence.postflow_s.get(), pass.length()),
    ];
    let mut all: Vec<Finding> = times
        .into_iter()
        .filter(|(_, time, _)| is_too_long(*time))
        .map(|(key, time, s)| {
            let message = Message::new("motion-time-too-long").key("key", key).value("time", time, Unit::S);
            let cure = Message::new("motion-cure-time").key("key", key);
            Finding::error("time", at_most(message), number, PathRange::at(s), at_most(cure))
        })
        .collect();
    let travel = pass.travel_s();
    if is_too_long(travel) {
        let message = Message::new("motion-travel-too-long").quantity("time", travel, Unit::S, 0);
        let (whole, cure) = (PathRange::up_to(pass.length()), Message::new("motion-cure-travel"));
        all.push(Finding::error("time", at_most(message), number, whole, cure));
    }
    all
}

/// Reports a travel of a pass, `length` mm long, that takes more than [`MAX_PASS_S`] within the limits of the axes.
pub(crate) fn travels_too_long(profile: &SpeedProfile, length: f64, pass: usize) -> Option<Finding> {
    let travel = profile.duration();
    is_too_long(travel).then(|| {
        let message = at_most(Message::new("motion-travel-too-long-axes").quantity("time", travel, Unit::S, 0));
        Finding::error("time", message, pass, PathRange::up_to(length), Message::new("motion-cure-travel-axes"))
    })
}

pub(crate) fn at_most(message: Message) -> Message {
    message.value("limit", MAX_PASS_S, Unit::S)
}

fn is_too_long(s: f64) -> bool {
    s.is_nan() || s > MAX_PASS_S
}
