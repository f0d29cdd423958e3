#![allow(missing_docs)]
use seamwright_cell::eyes::stripe::{StripeDisturbances, StripeErrors};
use seamwright_vision::stripe::JointKind;
fn main() {
    for kind in JointKind::ALL {
        let e = StripeErrors::measure(kind, &StripeDisturbances::USUAL, 0..20, || ());
        let rms = (e.centre.iter().map(|v| v * v).sum::<f64>() / e.centre.len() as f64).sqrt();
        let mean = e.centre.iter().sum::<f64>() / e.centre.len() as f64;
        println!("{kind:?} {} rms {rms:.4} mean {mean:.4}", e.centre.len());
    }
}
