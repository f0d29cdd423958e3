//! Tracking with images of stripes instead of offsets.

use seamwright_machine::{Machine, shipped};
use seamwright_simulation::tracking::acceptance::stripe_rows;

#[test]
fn from_the_pixel_to_the_slide() {
    let machine = Machine::read("m", shipped("dual-laser-10axis").unwrap().text).unwrap();
    let rows = stripe_rows(&machine).unwrap();
    assert_eq!(rows.len(), 8);
    for row in &rows {
        println!("{}: {} {:.4} {}", row.frames, row.what, row.value, row.unit);
    }
    assert!(rows.iter().all(seamwright_simulation::acceptance::Gate::is_kept));
}
