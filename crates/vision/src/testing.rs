//! Helpers for the tests of several modules.

/// Uniform random numbers from 0 to 1, the same sequence every time.
pub(crate) fn random() -> impl FnMut() -> f32 {
    let mut state = 7u32;
    move || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / (1 << 24) as f32
    }
}
