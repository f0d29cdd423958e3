//! Fuzzes the targets of `seamwright_fuzzing` with libFuzzer. Each program in `src/bin/` is one line:
//! `seamwright_fuzz::fuzz!(JOB);`.

pub use seamwright_fuzzing;

use libfuzzer_sys::fuzzer_mutate;
use seamwright_fuzzing::{Random, Target, mutate_text};
use std::sync::OnceLock;

/// Words of the target's format, and texts of which parts are put into others.
static MATERIAL: OnceLock<(Vec<String>, Vec<String>)> = OnceLock::new();

/// Changes an input: as libFuzzer does; half of the texts by lines, words and numbers.
pub fn mutated(target: &Target, data: &mut [u8], size: usize, max_size: usize, seed: u32) -> usize {
    let mut random = Random::new(seed.into());
    let text = std::str::from_utf8(&data[..size]).ok().filter(|_| target.is_text && random.one_in(2));
    let Some(mut text) = text.map(str::to_owned) else { return fuzzer_mutate(data, size, max_size) };
    let (words, others) = MATERIAL.get_or_init(|| {
        let texts = (target.seeds)().into_iter().filter_map(|seed| String::from_utf8(seed).ok());
        ((target.words)(), texts.collect())
    });
    for _ in 0..=random.below(4) {
        mutate_text(&mut random, &mut text, words, others, max_size);
    }
    let length = text.len().min(max_size);
    data[..length].copy_from_slice(&text.as_bytes()[..length]);
    length
}

/// Makes a program that fuzzes a target.
#[macro_export]
macro_rules! fuzz {
    ($target:ident) => {
        use $crate::seamwright_fuzzing::$target as TARGET;

        ::libfuzzer_sys::fuzz_target!(|bytes: &[u8]| TARGET.run(bytes));
        ::libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
            $crate::mutated(&TARGET, data, size, max_size, seed)
        });
    };
}
