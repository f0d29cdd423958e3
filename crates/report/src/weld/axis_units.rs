use seamwright_message::Unit;

/// Returns the units of position, speed, acceleration and jerk of an axis whose positions are in `unit`.
pub(super) fn units(unit: &str) -> [Unit; 4] {
    match unit {
        "deg" => [Unit::Deg, Unit::DegPerS, Unit::DegPerS2, Unit::DegPerS3],
        _ => [Unit::Mm, Unit::MmPerS, Unit::MmPerS2, Unit::MmPerS3],
    }
}
