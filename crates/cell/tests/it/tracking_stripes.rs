//! Tracking with images of stripes instead of offsets.

use seamwright_cell::tracking::stripes::stripe_rows;
use seamwright_machine::{Machine, shipped};

#[test]
fn from_the_pixel_to_the_slide() {
    let machine = Machine::read("m", shipped("dual-laser-10axis").unwrap().text).unwrap();
    let rows = stripe_rows(&machine).unwrap();
    assert_eq!(rows.len(), 8);
    for row in &rows {
        println!("{}: {} {:.4} {}", row.frames, row.what, row.value, row.unit);
    }
    assert!(rows.iter().all(seamwright_cell::gate::Gate::is_kept));
}
