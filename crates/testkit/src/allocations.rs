use assert_no_alloc::{AllocDisabler, assert_no_alloc, violation_count};

/// The allocator of every test program that uses this crate. It counts by thread.
#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// Runs `action`.
///
/// # Panics
/// If it allocates or frees memory.
#[track_caller]
pub fn no_alloc<T>(action: impl FnOnce() -> T) -> T {
    let before = violation_count();
    let result = assert_no_alloc(action);
    assert_eq!(violation_count() - before, 0, "allocations");
    result
}

#[cfg(test)]
mod tests {
    use super::no_alloc;

    #[test]
    #[should_panic(expected = "allocations")]
    fn an_allocation_is_a_failure() {
        no_alloc(|| std::hint::black_box(vec![1]));
    }

    #[test]
    fn the_result_is_passed_on() {
        assert_eq!(no_alloc(|| 2), 2);
    }
}
