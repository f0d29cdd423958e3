use crate::wire::{ArmAt, ArmView};
use seamwright_machine::{Elbow, Joints, Machine, Shoulder, WristSide};

/// Configuration of the arm at positions `q`; none for other machines.
pub(crate) fn arm_view(machine: &Machine, q: &Joints) -> Option<ArmView> {
    let (of, margins) = machine.arm_configuration(q).zip(machine.arm_margins(q))?;
    let all = [("shoulder", margins.shoulder), ("elbow", margins.elbow), ("wrist", margins.wrist)];
    let (nearest, margin) = all.into_iter().min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some(ArmView {
        shoulder: if of.shoulder == Shoulder::Front { "front" } else { "back" }.to_owned(),
        elbow: if of.elbow == Elbow::Up { "up" } else { "down" }.to_owned(),
        wrist: if of.wrist == WristSide::NoFlip { "no_flip" } else { "flip" }.to_owned(),
        turns: of.turns.to_vec(),
        margin,
        nearest: nearest.to_owned(),
    })
}

/// Configurations along a pass, given its samples (path length in mm, positions): at the start and at every change.
pub(super) fn along<'a>(machine: &Machine, samples: impl Iterator<Item = (f64, &'a Joints)>) -> Vec<ArmAt> {
    let mut all: Vec<ArmAt> = Vec::new();
    for (s_mm, q) in samples {
        let Some(arm) = arm_view(machine, q) else { return Vec::new() };
        let is_same = |last: &ArmView| {
            (&last.shoulder, &last.elbow, &last.wrist, &last.turns)
                == (&arm.shoulder, &arm.elbow, &arm.wrist, &arm.turns)
        };
        match all.last_mut() {
            Some(last) if is_same(&last.arm) => {
                if arm.margin < last.arm.margin {
                    last.arm = arm;
                }
            }
            _ => all.push(ArmAt { s_mm, arm }),
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::shipped;

    /// The sixth axis of an arm that turns on: its number of turns changes at 180 degrees.
    #[test]
    fn changes_along_a_pass_are_listed_with_their_places() {
        let machine = Machine::read("m", shipped("irb-2600").unwrap().text).unwrap();
        let turned = |deg: f64| {
            let mut q = machine.home();
            q[5] = deg.to_radians();
            q
        };
        let all: Vec<Joints> = (0..=200).map(|deg| turned(f64::from(deg))).collect();
        let found = along(&machine, all.iter().enumerate().map(|(s, q)| (s as f64, q)));
        assert_eq!(found.iter().map(|at| (at.s_mm, at.arm.turns[5])).collect::<Vec<_>>(), [(0.0, 0), (181.0, 1)]);
        let ArmView { shoulder, elbow, wrist, margin, nearest, .. } = &found[0].arm;
        assert_eq!([shoulder, elbow, wrist, nearest], ["front", "up", "no_flip", "wrist"]);
        // The fifth axis stands at 30 degrees.
        assert!((margin - 0.5).abs() < 1e-9, "{margin}");
        let saddle = Machine::read("m", shipped("saddle-4axis").unwrap().text).unwrap();
        assert_eq!(along(&saddle, std::iter::once((0.0, &saddle.home()))), []);
    }
}
