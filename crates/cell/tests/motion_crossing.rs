//! Motions of all supplied examples cross unchanged, and damaged ones are refused without a panic.

use seamwright_cell::{decode_plan, encode_plan};
use seamwright_motion::WeldMotion;
use seamwright_program::TorchPath;
use seamwright_project::examples::EXAMPLES;
use seamwright_project::load::{Loaded, load_text};
use seamwright_project::planning::Planning;
use seamwright_testkit::Random;
use std::path::Path;

fn loaded(name: &str) -> Loaded {
    let example = EXAMPLES.iter().find(|example| example.name == name).unwrap();
    load_text(&format!("{name}.toml"), example.text, Path::new(".")).unwrap()
}

#[test]
fn motions_of_all_examples_cross_bit_for_bit() {
    let mut crossed = 0;
    for example in EXAMPLES {
        let loaded = loaded(example.name);
        let Ok(motion) = loaded.plan() else { continue };
        let bytes = encode_plan(&loaded, &motion).unwrap();
        let back = decode_plan(&bytes, &loaded).unwrap_or_else(|e| panic!("{}: {e}", example.name));
        // `Debug` prints every digit, and infinities too.
        assert_eq!(format!("{:?}", back.motion), format!("{motion:?}"), "{}", example.name);
        crossed += 1;
    }
    assert!(crossed >= 10, "{crossed}");
}

/// Every byte may be wrong: the result is an error, or a motion that is whole and within the limits.
#[test]
fn damaged_motions_are_refused_or_harmless() {
    let loaded = loaded("ellipse");
    let motion = loaded.plan().unwrap();
    let bytes = encode_plan(&loaded, &motion).unwrap();
    let mut random = Random::new(45);
    let mut refused = 0;
    for _ in 0..2000 {
        let mut bytes = bytes.clone();
        for _ in 0..=random.below(3) {
            let at = random.below(bytes.len());
            bytes[at] = random.below(256) as u8;
        }
        match decode_plan(&bytes, &loaded) {
            Ok(plan) => plan.motion.verify(&loaded.machine).unwrap(),
            Err(_) => refused += 1,
        }
    }
    // Most bytes are low digits of coefficients.
    assert!(refused > 20, "{refused}");
    for length in 0..bytes.len().min(3000) {
        assert!(decode_plan(&bytes[..length], &loaded).is_err(), "{length}");
    }
}

/// A motion of another machine, or beyond a limit, is refused with the pass.
#[test]
fn motions_that_the_machine_cannot_play_are_refused() {
    let ellipse = loaded("ellipse");
    let motion = ellipse.plan().unwrap();
    assert!(motion.verify(&ellipse.machine).is_ok());
    let slower = |change: &dyn Fn(&mut seamwright_machine::Axis)| {
        let mut machine = ellipse.machine.clone();
        machine.axes.iter_mut().for_each(change);
        motion.verify(&machine).unwrap_err().to_string()
    };
    assert!(slower(&|axis| axis.max_speed *= 0.01).contains("speed"));
    assert!(slower(&|axis| axis.max_acceleration *= 0.01).contains("acceleration"));
    assert!(slower(&|axis| axis.range = Some((-1e-3, 1e-3))).contains("range"));
    let mut short = motion.clone();
    short.transfers.pop();
    assert!(short.verify(&ellipse.machine).unwrap_err().to_string().contains("transfers"));
    assert!(WeldMotion::default().verify(&ellipse.machine).is_err());
    let other = loaded("head-nozzle");
    assert!(decode_plan(&encode_plan(&ellipse, &motion).unwrap(), &other).is_err());
}

/// Searched torch angles cross with the motion: the other process has the same torch path without a search.
#[test]
fn searched_angles_cross_with_the_motion() {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/vessel-shop/hillside.toml"))
            .unwrap();
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/vessel-shop"));
    let read = || load_text("hillside.toml", &text, folder).unwrap();
    let searched = read().with_torch_angles(&Planning::default()).unwrap();
    assert!(!searched.searched_torches().is_empty());
    let bytes = encode_plan(&searched, &searched.plan().unwrap()).unwrap();
    let torches = decode_plan(&bytes, &read()).unwrap().torches;
    let mut one_less = torches.clone();
    one_less.pop();
    assert!(read().with_searched_torches(one_less).is_err());
    let there = read().with_searched_torches(torches.clone()).unwrap();
    for pass in 0..searched.welding.program.value.passes.len() {
        let [a, b] = [&searched, &there].map(|loaded| {
            let path = loaded.welding.path(pass);
            (0..100).map(|i| format!("{:?}", path.pose(0.01 * f64::from(i) * path.length()))).collect::<Vec<_>>()
        });
        assert_eq!(a, b, "{pass}");
    }
    assert!(loaded("ellipse").with_searched_torches(torches).is_err());
}
