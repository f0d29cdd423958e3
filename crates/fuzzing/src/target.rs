use cap::Cap;
use std::alloc::System;

/// The allocator of every program that uses this crate.
#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// Bytes that a reader may allocate for each byte of its input, beside [`Target::max_memory`].
const MEMORY_A_BYTE: usize = 64;

/// An input of the program.
#[derive(Debug, Clone, Copy)]
pub struct Target {
    /// Its name, in `snake_case`.
    pub name: &'static str,
    /// Reads an input; panics if a guarantee of the reader is broken.
    pub read: fn(&[u8]),
    /// Makes first inputs from the files of the repository.
    pub seeds: fn() -> Vec<Vec<u8>>,
    /// Lists words of the format.
    pub words: fn() -> Vec<String>,
    /// True if inputs are text, which is changed by lines, words and numbers too.
    pub is_text: bool,
    /// Maximum length of an input that the fuzzer makes, bytes.
    pub max_length: usize,
    /// Memory that a short input may need at a time, bytes.
    pub max_memory: usize,
    /// Number of random inputs that a test makes.
    pub cases: u32,
}

impl Target {
    /// Reads an input. A reader that allocates more than its limit ends the process.
    ///
    /// # Panics
    /// If the reader panics, or breaks one of its guarantees.
    pub fn run(&self, input: &[u8]) {
        let limit = ALLOCATOR.allocated() + self.max_memory + MEMORY_A_BYTE * input.len();
        // The limit is above what is allocated.
        let _ = ALLOCATOR.set_limit(limit);
        (self.read)(input);
        let _ = ALLOCATOR.set_limit(usize::MAX);
    }
}

/// Defaults of a target: short text, 64 MiB.
pub(crate) const USUAL: Target = Target {
    name: "",
    read: |_| {},
    seeds: Vec::new,
    words: Vec::new,
    is_text: true,
    max_length: 4096,
    max_memory: 64 << 20,
    cases: 300,
};
