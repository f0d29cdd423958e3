use seamwright_machine::{InterlockFile, Level};

/// Most inputs.
pub const MOST_INPUTS: usize = 64;

/// Conditions that are watched in every cycle, as masks over the inputs.
#[derive(Debug, Clone)]
pub struct Interlocks {
    conditions: Vec<InterlockFile>,
    /// Inputs of each level, and what they must be.
    masks: [(u64, u64); 3],
}

impl Interlocks {
    /// The conditions of a machine file, each with the input of its own place: condition 0 is input 0.
    pub fn new(conditions: &[InterlockFile]) -> Self {
        let mut masks = [(0, 0); 3];
        for (i, one) in conditions.iter().enumerate().take(MOST_INPUTS) {
            let (mask, wanted) = &mut masks[one.level as usize];
            *mask |= 1 << i;
            *wanted |= u64::from(one.is) << i;
        }
        Self { conditions: conditions.to_vec(), masks }
    }

    /// The conditions, in the order of the inputs.
    pub fn conditions(&self) -> &[InterlockFile] {
        &self.conditions
    }

    /// Conditions of `level` that `inputs` do not meet, a bit each.
    pub fn unmet_of(&self, level: Level, inputs: u64) -> u64 {
        let (mask, wanted) = self.masks[level as usize];
        (inputs ^ wanted) & mask
    }

    /// Conditions up to `level` that `inputs` do not meet, a bit each.
    pub fn unmet(&self, level: Level, inputs: u64) -> u64 {
        let levels = [Level::Power, Level::Motion, Level::Process].into_iter().filter(|l| *l <= level);
        levels.fold(0, |unmet, l| unmet | self.unmet_of(l, inputs))
    }

    /// Inputs that meet every condition.
    pub fn all_met(&self) -> u64 {
        self.masks.iter().fold(0, |all, (_, wanted)| all | wanted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All inputs of five conditions against the words of the file.
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
