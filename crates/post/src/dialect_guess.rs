use crate::control::Dialect;

impl Dialect {
    /// The most likely dialect of a part program, by its file's name and by words that only one dialect has.
    pub fn guess(file: &str, text: &str) -> Self {
        let ends = |endings: &[&str]| endings.iter().any(|ending| file.to_ascii_lowercase().ends_with(ending));
        if ends(&[".mpf", ".spf", ".arc"]) {
            return Self::Sinumerik;
        }
        if ends(&[".ngc"]) {
            return Self::Linuxcnc;
        }
        if ends(&[".pmc", ".pma"]) {
            return Self::Pmac;
        }
        let signs = [
            (Self::Pmac, ["OPEN PROG", "PVT", "SPLINE1", "->"]),
            (Self::Sinumerik, ["FGROUP", "X=", "%_N_", "TRAORI"]),
            (Self::Linuxcnc, ["G64", "M67", "O<", "LINUXCNC"]),
            (Self::Grblhal, ["GRBLHAL", "G4P0", "G4 P0", "M3 S"]),
        ];
        let begin: String = text.lines().take(200).collect::<Vec<_>>().join("\n").to_ascii_uppercase();
        // Our own texts name their control.
        let said = [
            ("FOR SINUMERIK", Self::Sinumerik),
            ("FOR LINUXCNC", Self::Linuxcnc),
            ("FOR GRBLHAL", Self::Grblhal),
            ("FOR PMAC", Self::Pmac),
        ];
        if begin.contains("SEAMWRIGHT")
            && let Some((_, dialect)) = said.iter().find(|(words, _)| begin.contains(words))
        {
            return *dialect;
        }
        let found = signs.iter().find(|(_, words)| words.iter().any(|word| begin.contains(word)));
        found.map_or(Self::Linuxcnc, |(dialect, _)| *dialect)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_tell_their_dialect() {
        for (file, text, dialect) in [
            ("a.mpf", "G1", Dialect::Sinumerik),
            ("A.NGC", "G1", Dialect::Linuxcnc),
            ("a.nc", "G84\nFGROUP(X,Y)", Dialect::Sinumerik),
            ("a.nc", "&1\n#1->X\nOPEN PROG 1 CLEAR", Dialect::Pmac),
            ("a.nc", "(Seamwright for grblHAL: t)\nG21", Dialect::Grblhal),
            ("a.nc", "(Seamwright 0.1.0 for grblHAL: t)\n(G64 of LinuxCNC)\nG21", Dialect::Grblhal),
            ("a.nc", "G21\nG64 P0.1\nG1 X1 F10", Dialect::Linuxcnc),
            ("a.nc", "G1 X1 F10", Dialect::Linuxcnc),
        ] {
            assert_eq!(Dialect::guess(file, text), dialect, "{file} {text}");
        }
    }
}
