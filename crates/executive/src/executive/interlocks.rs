use seamwright_machine::{InterlockFile, Level};

/// Maximum number of inputs.
pub const MAX_INPUTS: usize = 64;

/// Interlock conditions checked in every cycle, as masks over the inputs.
#[derive(Debug, Clone)]
pub struct Interlocks {
    conditions: Vec<InterlockFile>,
    /// Inputs of each level, and their required states.
    masks: [(u64, u64); 3],
}

impl Interlocks {
    /// Creates the interlocks of a machine file; condition `i` uses input `i`.
    pub fn new(conditions: &[InterlockFile]) -> Self {
        let mut masks = [(0, 0); 3];
        for (i, one) in conditions.iter().enumerate().take(MAX_INPUTS) {
            let (mask, wanted) = &mut masks[one.level as usize];
            *mask |= 1 << i;
            *wanted |= u64::from(one.is) << i;
        }
        Self { conditions: conditions.to_vec(), masks }
    }

    /// Returns the conditions, in the order of the inputs.
    pub fn conditions(&self) -> &[InterlockFile] {
        &self.conditions
    }

    /// Returns the conditions of `level` that `inputs` violate, one bit each.
    pub fn unmet_of(&self, level: Level, inputs: u64) -> u64 {
        let (mask, wanted) = self.masks[level as usize];
        (inputs ^ wanted) & mask
    }

    /// Returns the conditions up to `level` that `inputs` violate, one bit each.
    pub fn unmet(&self, level: Level, inputs: u64) -> u64 {
        let levels = [Level::Power, Level::Motion, Level::Process].into_iter().filter(|l| *l <= level);
        levels.fold(0, |unmet, l| unmet | self.unmet_of(l, inputs))
    }

    /// Returns inputs that meet every condition.
    pub fn all_met(&self) -> u64 {
        self.masks.iter().fold(0, |all, (_, wanted)| all | wanted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares the masks with the conditions for all states of five inputs.
    #[test]
    fn masks_say_what_the_file_says() {
        let levels = [Level::Power, Level::Process, Level::Motion, Level::Process, Level::Motion];
        let conditions: Vec<InterlockFile> = (levels.into_iter().enumerate())
            .map(|(i, level)| InterlockFile { name: format!("c{i}"), input: format!("i{i}"), is: i % 2 == 0, level })
            .collect();
        let interlocks = Interlocks::new(&conditions);
        for inputs in 0..32u64 {
            for level in [Level::Power, Level::Motion, Level::Process] {
                let unmet = interlocks.unmet(level, inputs);
                for (i, one) in conditions.iter().enumerate() {
                    let met = (inputs >> i & 1 == 1) == one.is;
                    assert_eq!(unmet >> i & 1 == 1, one.level <= level && !met);
                }
            }
        }
        assert_eq!(interlocks.unmet(Level::Process, interlocks.all_met()), 0);
    }
}
