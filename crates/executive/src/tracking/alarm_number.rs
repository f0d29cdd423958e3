use seamwright_message::Message;
use seamwright_tracking::actuator::Alarm;

/// Number of alarm codes reserved per head.
const ROOM: u8 = 16;

/// Encodes an alarm of a head as a number.
pub(super) fn detail(head: usize, alarm: Alarm) -> u8 {
    ROOM * head as u8 + alarm as u8
}

/// Returns the message of the number of an alarm no. 24 ([`crate::executive::Alarm::Tracking`]), with the head if it is
/// not the first.
#[must_use]
pub fn trouble(detail: u8) -> Option<Message> {
    let alarm = Alarm::ALL.into_iter().find(|alarm| *alarm as u8 == detail % ROOM)?;
    Some(match usize::from(detail / ROOM) {
        0 => alarm.message(),
        head => Message::new("cell-alarm-of-head").message("alarm", alarm.message()).pass("head", head + 1),
    })
}
