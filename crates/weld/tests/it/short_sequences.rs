//! Tacks and cosmetic passes have times of their own before and after the travel, not the weld's.

use crate::jobs::{read, refusal};
use seamwright_program::{Pass, Role};

const GIRTH: &str = include_str!("../../../../tests/data/field-trial/j8.toml");

fn passes(text: &str) -> Vec<Pass> {
    read(text).program.value.passes.clone()
}

fn of(passes: &[Pass], role: Option<Role>) -> &Pass {
    passes.iter().find(|pass| pass.role == role).unwrap()
}

/// Time with the beam on of a pass at its asked speed, s.
fn beam_s(pass: &Pass) -> f64 {
    let sequence = &pass.sequence;
    sequence.travel_delay_s.get() + pass.length() / pass.speed_at(0.0) + sequence.crater_s.get()
}

#[test]
fn a_tack_of_a_second_does_not_take_the_welds_crater_fill_of_two() {
    let all = passes(GIRTH);
    let (tack, weld, cosmetic) = (of(&all, Some(Role::Tack)), of(&all, None), of(&all, Some(Role::Cosmetic)));
    // 15 mm at 15 mm/s, and at most 0.3 s more.
    assert!((1.0..=1.3 + 1e-9).contains(&beam_s(tack)), "{}", beam_s(tack));
    for short in [tack, cosmetic] {
        assert!(short.sequence.upslope.is_none() && short.sequence.downslope.is_none(), "{}", short.name);
        assert!(short.sequence.crater_s.get() <= 0.2 && short.sequence.travel_delay_s.get() <= 0.1, "{}", short.name);
    }
    assert!((weld.sequence.crater_s.get() - 2.0).abs() < 1e-12 && weld.sequence.downslope.is_some());
}

#[test]
fn gas_flows_as_in_the_weld_unless_it_is_given() {
    let gas = GIRTH.replace("[sequence]\n", "[sequence]\npreflow_s = 0.7\npostflow_s = 4\n");
    let all = passes(&gas);
    let tack = &of(&all, Some(Role::Tack)).sequence;
    assert!((tack.preflow_s.get() - 0.7).abs() < 1e-12 && (tack.postflow_s.get() - 4.0).abs() < 1e-12);
    let own = gas.replace("[start]", "[tacks.sequence]\npostflow_s = 1\ncrater_s = 0.4\n[start]");
    let all = passes(&own);
    let tack = &of(&all, Some(Role::Tack)).sequence;
    assert!((tack.preflow_s.get() - 0.7).abs() < 1e-12 && (tack.postflow_s.get() - 1.0).abs() < 1e-12);
    assert!((tack.crater_s.get() - 0.4).abs() < 1e-12);
}

#[test]
fn slopes_of_their_own_take_their_own_time() {
    let slope = "[cosmetic]\nsequence = { downslope = { time_s = 0.8, process = { beam_ma = 1 } } }";
    let all = passes(&GIRTH.replace("[cosmetic]", slope));
    let cosmetic = &of(&all, Some(Role::Cosmetic)).sequence;
    assert!((cosmetic.crater_s.get() - 0.8).abs() < 1e-12 && cosmetic.downslope.is_some());
    let key = |change: &str| refusal(&GIRTH.replace("[cosmetic]", change)).key;
    let long = slope.replace("{ downslope", "{ crater_s = 0.3, downslope");
    assert_eq!(key(&long), "cosmetic.sequence.downslope.time_s");
    assert_eq!(key(&slope.replace("beam_ma", "wire_ma")), "cosmetic.sequence.downslope.process.wire_ma");
}
