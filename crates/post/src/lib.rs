//! Weld programs as part programs of real controls.
