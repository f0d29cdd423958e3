use seamwright_message::Message;

/// Error of an invalid hold of an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct HoldError {
    /// Requested name of the axis; of several the first.
    pub axis: String,
    /// Description.
    pub message: Message,
    /// Allowed axes, number or range.
    pub allowed: Message,
}
