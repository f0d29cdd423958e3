//! All tests in one program, which is compiled and linked once.

use seamwright_document::Positive;
use seamwright_message::{Argument, Message};

mod arc_limits;
mod asked_speed;
mod corners;
mod examples;
mod feed_override;
mod fine;
mod held_axes;
mod jog;
mod no_alloc;
mod override_profile;
mod override_run;
mod override_start;
mod override_weld;
mod passes;
mod planning;
mod pools;
mod positions;
mod procedure;
mod pulses;
mod ranges;
mod reach;
mod redundancy;
mod run_up;
mod searches;
mod speed_profile;
mod taught;
mod tip_limits;
mod transfer;
mod waits;
mod weave;
mod weld_motion;

fn number(message: &Message, name: &str) -> f64 {
    match message.argument(name) {
        Some(Argument::Quantity(quantity)) => quantity.value,
        other => panic!("{name} of {}: {other:?}", message.as_data()),
    }
}

fn inner<'m>(message: &'m Message, name: &str) -> &'m Message {
    match message.argument(name) {
        Some(Argument::Message(inner)) => inner,
        other => panic!("{name} of {}: {other:?}", message.as_data()),
    }
}

fn positive(value: f64) -> Positive {
    Positive::new(value).unwrap()
}
