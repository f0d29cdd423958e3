//! Positions along a path, within rounding.

use seamwright_program::{is_before, is_beyond, is_same_position, part_start, parts_of};

#[test]
fn equal_parts_end_where_the_whole_ends() {
    let mut beyond = 0;
    for count in 1..2000 {
        let length = 37.123_456_789 * count as f64 / 7.0;
        assert!(part_start(length, count, count) <= length && part_start(length, count, count) >= length);
        beyond += usize::from(length * count as f64 / count as f64 > length);
    }
    assert!(beyond > 0, "the product first is no hazard with these numbers");
}

#[test]
fn positions_are_the_same_within_rounding_and_differ_above_it() {
    assert!(!is_beyond(218.5 + 2e-13, 218.5) && is_beyond(218.500_01, 218.5));
    assert!(!is_before(-2e-13, 0.0) && is_before(-1e-5, 0.0));
    assert!(is_same_position(1e6, 1e6 + 1e-9) && !is_same_position(0.0, 1e-5));
    assert_eq!((parts_of(100.0, 10.0), parts_of(100.0 + 1e-9, 10.0), parts_of(100.1, 10.0)), (10, 10, 11));
    assert_eq!((parts_of(1e-9, 10.0), parts_of(1.0, 1e-300)), (1, usize::MAX));
}
