//! Icons whose shape carries the same meaning as their colour.

use crate::Severity;
use maud::PreEscaped;

/// A tick in a circle: in order.
pub(crate) const OK: PreEscaped<&str> = PreEscaped(
    "<svg class=\"icon\" viewBox=\"0 0 24 24\" aria-hidden=\"true\">\
    <circle cx=\"12\" cy=\"12\" r=\"10.5\"/><path d=\"M7 12.5l3.5 3.5 6.5-7.5\"/></svg>",
);

/// A cross in an octagon: error.
pub(crate) const ERROR: PreEscaped<&str> = PreEscaped(
    "<svg class=\"icon error\" viewBox=\"0 0 24 24\" aria-hidden=\"true\">\
    <path class=\"solid\" d=\"M8 1.5h8L22.5 8v8L16 22.5H8L1.5 16V8z\"/>\
    <path class=\"sign\" d=\"M8 8l8 8M16 8l-8 8\"/></svg>",
);

/// An exclamation mark in a triangle: warning.
const WARNING: PreEscaped<&str> = PreEscaped(
    "<svg class=\"icon warning\" viewBox=\"0 0 24 24\" aria-hidden=\"true\">\
    <path class=\"solid\" d=\"M12 2.5L23 21.5H1z\"/>\
    <path class=\"sign\" d=\"M12 9.5v5.5M12 18.2v.1\"/></svg>",
);

/// An i in a square: remark.
const NOTE: PreEscaped<&str> = PreEscaped(
    "<svg class=\"icon note\" viewBox=\"0 0 24 24\" aria-hidden=\"true\">\
    <path d=\"M3 3h18v18H3zM12 11v6M12 7v.1\"/></svg>",
);

pub(crate) fn of(severity: Severity) -> PreEscaped<&'static str> {
    match severity {
        Severity::Error => ERROR,
        Severity::Warning => WARNING,
        Severity::Note => NOTE,
    }
}
