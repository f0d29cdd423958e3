use seamwright_message::{Argument, Message, Unit};

/// Error of an invalid hold of an axis.
#[derive(Debug, Clone, PartialEq)]
pub enum HoldError {
    /// The machine has no such axis, or it does not carry the torch.
    Unknown {
        /// Requested name.
        axis: String,
        /// Names of the axes that carry the torch.
        axes: Vec<String>,
    },
    /// A torch pose needs every axis.
    Decided {
        /// Requested name.
        axis: String,
    },
    /// The other axes cannot reach every torch pose.
    TooFew {
        /// The first of the axes to hold.
        axis: String,
        /// All axes to hold.
        held: Vec<String>,
        /// Number of axes that can be held.
        redundant: usize,
    },
    /// The position lies outside the axis' range.
    Range {
        /// Requested name.
        axis: String,
        /// The position, in the file's unit.
        value: f64,
        /// The range, in the file's unit.
        range: (f64, f64),
        /// The file's unit.
        unit: Unit,
    },
}

impl HoldError {
    /// Name of the axis.
    pub fn axis(&self) -> &str {
        match self {
            Self::Unknown { axis, .. }
            | Self::Decided { axis }
            | Self::TooFew { axis, .. }
            | Self::Range { axis, .. } => axis,
        }
    }

    /// Describes the error.
    pub fn message(&self) -> Message {
        match self {
            Self::Unknown { axis, .. } => Message::new("motion-hold-unknown").axis("axis", axis.as_str()),
            Self::Decided { axis } => Message::new("motion-hold-decided").axis("axis", axis.as_str()),
            Self::TooFew { held, .. } => {
                Message::new("motion-hold-too-few").list("held", held.iter().cloned().map(Argument::Axis))
            }
            Self::Range { axis, value, unit, .. } => {
                Message::new("motion-hold-range").axis("axis", axis.as_str()).value("value", *value, *unit)
            }
        }
    }

    /// Allowed axes, number or range.
    pub fn allowed(&self) -> Message {
        match self {
            Self::Unknown { axes, .. } => Message::verbatim(axes.join(", ")),
            Self::Decided { .. } => Message::new("motion-hold-allowed-none"),
            Self::TooFew { redundant, .. } => Message::new("motion-hold-allowed-count").count("axes", *redundant),
            Self::Range { range: (low, high), unit, .. } => {
                Message::new("document-between").quantity("min", *low, *unit, 3).quantity("max", *high, *unit, 3)
            }
        }
    }
}

seamwright_message::display_by_message!(HoldError);
