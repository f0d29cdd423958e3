use seamwright_executive::{Ask, Mode};
use seamwright_message::{Message, Unit};

#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::verbs) enum Line {
    /// Something that the cell is asked.
    Ask(Ask),
    /// Waits until the cell is in this mode.
    Mode(Mode),
    /// Waits for this time, s.
    Seconds(f64),
    /// Waits until the torch is there, mm along the pass.
    Place(f64),
    /// Position and mode of the cell.
    State,
}

/// Words of orders.
const WORDS: [(&str, Ask); 15] = [
    ("on", Ask::SwitchOn),
    ("off", Ask::SwitchOff),
    ("home", Ask::Home),
    ("arm", Ask::Arm),
    ("weld", Ask::StartWeld),
    ("dry", Ask::StartDryRun),
    ("hold", Ask::Hold),
    ("resume", Ask::Resume),
    ("reverse", Ask::Reverse),
    ("stop", Ask::Stop),
    ("acknowledge", Ask::Acknowledge),
    ("ack", Ask::Acknowledge),
    ("reset", Ask::Reset),
    ("quit", Ask::Quit),
    ("jog", Ask::StartJog),
];

impl Line {
    /// Reads a line; `None` for an empty one and one that starts with #.
    pub(in crate::verbs) fn read(text: &str) -> Result<Option<Self>, Message> {
        let words: Vec<&str> = text.split_whitespace().collect();
        let number = |word: &str, low: f64, high: f64| {
            let number = word.parse::<f64>().ok().filter(|n| (low..=high).contains(n));
            number.ok_or_else(|| {
                let fault = Message::new("cli-order-number").text("word", word).text("line", text);
                fault.value("min", low, Unit::One).value("max", high, Unit::One)
            })
        };
        Ok(Some(match words[..] {
            [] => return Ok(None),
            [first, ..] if first.starts_with('#') => return Ok(None),
            ["?"] => Self::State,
            ["override", percent] => Self::Ask(Ask::Override(number(percent, 0.0, 100.0)? / 100.0)),
            ["wait", n, "s"] => Self::Seconds(number(n, 0.0, 86_400.0)?),
            ["wait", n, "mm"] => Self::Place(number(n, 0.0, 1e9)?),
            ["wait", ref mode @ ..] if !mode.is_empty() => {
                let name = mode.join(" ");
                let found = Mode::ALL.into_iter().find(|m| m.name() == name);
                let names = || Mode::ALL.map(Mode::name).join(", ");
                let fault = || Message::new("cli-order-mode").text("mode", &name).text("modes", names());
                Self::Mode(found.ok_or_else(fault)?)
            }
            [word] if WORDS.iter().any(|(known, _)| *known == word) => {
                let found = WORDS.iter().find(|(known, _)| *known == word);
                return Ok(found.map(|(_, ask)| Self::Ask(*ask)));
            }
            _ => {
                let words: Vec<&str> = WORDS.iter().map(|(word, _)| *word).collect();
                return Err(Message::new("cli-order-unknown").text("line", text).text("orders", words.join(", ")));
            }
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read() {
        for (word, ask) in WORDS {
            assert_eq!(Line::read(&format!("  {word} ")), Ok(Some(Line::Ask(ask))));
        }
        for mode in Mode::ALL {
            assert_eq!(Line::read(&format!("wait {}", mode.name())), Ok(Some(Line::Mode(mode))));
        }
        assert_eq!(Line::read("override 50"), Ok(Some(Line::Ask(Ask::Override(0.5)))));
        assert_eq!(Line::read("wait 2.5 s"), Ok(Some(Line::Seconds(2.5))));
        assert_eq!(Line::read("wait 12 mm"), Ok(Some(Line::Place(12.0))));
        assert_eq!(Line::read("?"), Ok(Some(Line::State)));
        assert_eq!((Line::read(""), Line::read("# a remark")), (Ok(None), Ok(None)));
        for bad in ["go", "wait", "wait for it", "override", "override 120", "override fast", "wait -1 s", "on off"] {
            let error = Line::read(bad).unwrap_err();
            assert!(error.to_string().contains("allowed"), "{bad}: {error}");
        }
    }
}
