use crate::SpanValue;
use seamwright_document::{Document, DocumentError, Finite};
use std::collections::BTreeMap;

/// Process values by name; the name ends in the unit, like `current_a`, `voltage_v`, `wire_feed_m_min`.
pub type ProcessValues = BTreeMap<String, ProcessValue>;

/// A process value over a span.
pub type ProcessValue = SpanValue<Finite>;

/// Checks a name of a process value, at `path` of a file: it becomes a column and ends in a unit.
///
/// # Errors
/// With the key's address.
pub fn check_process_name<T>(file: &Document<T>, path: &str, name: &str) -> Result<(), DocumentError> {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    if !name.chars().all(plain) || !name.contains('_') {
        let allowed = "lower-case letters, digits and _, ending in the unit, like current_a";
        return Err(file.error_at(path, "this is no name of a process value", allowed));
    }
    if seamwright_document::RESERVED_COLUMNS.contains(&name) {
        return Err(file.error_at(path, "another column has this name", "a name of its own"));
    }
    Ok(())
}

/// Checks the process values at `path` of a file: their names, and that no value is negative.
///
/// # Errors
/// With the key's address.
pub fn check_process<T>(file: &Document<T>, path: &str, values: &ProcessValues) -> Result<(), DocumentError> {
    for (name, value) in values {
        let key = format!("{path}.{name}");
        check_process_name(file, &key, name)?;
        let (from, to) = value.ends();
        for (end, found) in [("from", from), ("to", to)] {
            if found < 0.0 {
                let key = if value.is_ramp() { format!("{key}.{end}") } else { key };
                return Err(file.error_at(&key, "a process value is not negative", "0 or greater"));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::Program;

    const TEXT: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 250\n\
        [seam.nozzle.body.cylinder]\nradius_mm = 800\n[[passes]]\nname = \"root\"\n[passes.sequence]\n\
        travel_delay_s = 0.5\nupslope = { time_s = 0.4, process = { beam_ma = 10 } }\n\
        crater_s = 1\ndownslope = { time_s = 0.5, process = { beam_ma = 5 } }\n\
        [[passes.spans]]\nfrom_mm = 0\nto_mm = 10\nspeed_mm_s = 5\n\
        process = { beam_ma = { from = 20, to = 60 }, lens_ma = 700 }\n\
        [[passes.spans]]\nfrom_mm = 10\nto_mm = 20\nspeed_mm_s = 8\nprocess = { beam_ma = 60, lens_ma = 700 }\n";

    #[test]
    fn ramps_and_slopes_have_their_values() {
        let program = Program::read("p.toml", TEXT).unwrap().value;
        assert_eq!(Program::read("p.toml", &program.to_toml().unwrap()).unwrap().value, program);
        let pass = &program.passes[0];
        let at = |s: f64, since: f64, until: f64| pass.process_at("beam_ma", s, (since, until)).unwrap();
        let far = f64::INFINITY;
        for (s, value) in [(0.0, 20.0), (2.5, 30.0), (10.0 - 1e-12, 60.0), (10.0, 60.0), (15.0, 60.0), (20.0, 60.0)] {
            assert!((at(s, far, far) - value).abs() < 1e-9, "{s}");
        }
        // Upslope: from 10 when the arc goes on to the 20 that the weld begins with, after 0.4 s.
        for (since, value) in [(0.0, 10.0), (0.1, 12.5), (0.4, 20.0), (0.5, 20.0)] {
            assert!((at(0.0, since, far) - value).abs() < 1e-12);
        }
        // Downslope: the last half second down to 5.
        for (until, value) in [(1.0, 60.0), (0.5, 60.0), (0.25, 32.5), (0.0, 5.0)] {
            assert!((at(20.0, far, until) - value).abs() < 1e-12);
        }
        assert_eq!(pass.process_at("lens_ma", 3.0, (0.0, 0.0)), Some(700.0));
        assert_eq!(pass.process_at("voltage_v", 3.0, (0.0, 0.0)), None);
    }

    #[test]
    fn wrong_ramps_have_an_address() {
        let wrong = |from: &str, to: &str| {
            assert!(TEXT.contains(from));
            let e = Program::read("p.toml", &TEXT.replacen(from, to, 1)).unwrap_err();
            println!("{e}");
            (e.key, e.allowed.unwrap_or_default())
        };
        let key = |from: &str, to: &str| wrong(from, to).0;
        assert_eq!(key("from = 20, to", "from = -20, to"), "passes[0].spans[0].process.beam_ma.from");
        assert_eq!(key("to = 60 }", "to = -60 }"), "passes[0].spans[0].process.beam_ma.to");
        assert_eq!(key("beam_ma = 60,", "beam_ma = -60,"), "passes[0].spans[1].process.beam_ma");
        let (at, allowed) = wrong("{ from = 20, to = 60 }", "\"20\"");
        assert!(at.ends_with("beam_ma") && allowed.contains("{ from = .., to = .. }"), "{at} {allowed}");
        assert!(key("to = 60 }", "to = nan }").ends_with("beam_ma.to"));
        assert!(key("to = 60 }", "too = 60 }").contains("beam_ma"));
        assert!(key(", to = 60 }", " }").contains("beam_ma"));
        assert_eq!(key("time_s = 0.4", "time_s = 0.6"), "passes[0].sequence.upslope.time_s");
        assert_eq!(key("time_s = 0.5", "time_s = 1.1"), "passes[0].sequence.downslope.time_s");
        assert_eq!(key("time_s = 0.4", "time_s = 0"), "passes[0].sequence.upslope.time_s");
        let (at, allowed) = wrong("process = { beam_ma = 5 }", "process = { current_a = 5 }");
        assert_eq!(
            (at.as_str(), allowed.as_str()),
            ("passes[0].sequence.downslope.process.current_a", "beam_ma, lens_ma")
        );
        assert!(key("beam_ma = 10 }", "beam_ma = -10 }").contains("upslope"));
    }
}
