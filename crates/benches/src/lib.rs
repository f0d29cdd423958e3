//! Benchmarks of all crates, one program: `benches/speed/`. They are apart so that tests need not compile what only
//! benchmarks use.
