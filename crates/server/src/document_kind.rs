//! The kind of a text among the jobs, by keys at its root that only such a file has.

/// Kind of a file; its reader validates it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Job,
    Program,
    /// A procedure file, which jobs name.
    Procedure,
    /// A machine file, which jobs name.
    Machine,
}

pub(crate) fn kind_of(has: impl Fn(&str) -> bool) -> Kind {
    let kinds =
        [("passes", Kind::Program), ("runs", Kind::Procedure), ("tool", Kind::Machine), ("work", Kind::Machine)];
    kinds.into_iter().find(|(key, _)| has(key)).map_or(Kind::Job, |(_, kind)| kind)
}

/// Returns the kind of a text of which only the start may be known.
pub(crate) fn kind_of_head(head: &str) -> Kind {
    let mut at_root = true;
    let root_key = |line: &str| {
        let is_header = line.starts_with('[');
        at_root &= !is_header;
        let key = line.trim_start_matches('[').split(['.', ']', '=', ' ']).next()?;
        (is_header || at_root).then(|| key.to_owned())
    };
    let keys: Vec<String> = head.lines().map(str::trim).filter_map(root_key).collect();
    kind_of(|wanted| keys.iter().any(|key| key == wanted))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_told_apart_by_their_start() {
        for machine in seamwright_machine::SHIPPED {
            assert_eq!(kind_of_head(machine.text), Kind::Machine, "{}", machine.name);
        }
        for procedure in seamwright_program::PROCEDURES {
            assert_eq!(kind_of_head(procedure.text), Kind::Procedure, "{}", procedure.name);
        }
        for example in seamwright_project::examples::EXAMPLES {
            assert!(matches!(kind_of_head(example.text), Kind::Job | Kind::Program), "{}", example.name);
        }
        assert_eq!(kind_of_head("title = \"work\"\n[weld]\nwork = 3\n"), Kind::Job);
    }
}
