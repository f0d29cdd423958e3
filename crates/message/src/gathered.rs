use crate::argument::{Argument, Quantity};
use crate::message::Message;
use crate::unit::Unit;

impl Message {
    /// True if the messages are the same but for the values of their quantities, counts and passes.
    pub fn is_alike(&self, other: &Self) -> bool {
        self.code == other.code
            && self.arguments.len() == other.arguments.len()
            && self.arguments.iter().zip(&other.arguments).all(|((a, x), (b, y))| a == b && is_alike(x, y))
    }

    /// Returns the message of several that are [alike](Self::is_alike), with ranges where their values differ; an empty
    /// text for none.
    pub fn gathered(messages: &[&Self]) -> Self {
        let Some((first, others)) = messages.split_first() else { return Self::verbatim("") };
        let mut gathered = (*first).clone();
        for (i, (_, argument)) in gathered.arguments.iter_mut().enumerate() {
            let all = others.iter().filter_map(|other| other.arguments.get(i).map(|(_, own)| own));
            *argument = all.fold(argument.clone(), |a, b| joined(&a, b));
        }
        gathered
    }
}

fn is_alike(a: &Argument, b: &Argument) -> bool {
    match (a, b) {
        (Argument::Quantity(a), Argument::Quantity(b)) => a.unit == b.unit,
        (Argument::Count(_), Argument::Count(_)) | (Argument::Pass(_), Argument::Pass(_)) => true,
        (Argument::Message(a), Argument::Message(b)) => a.is_alike(b),
        (Argument::List(a), Argument::List(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| is_alike(a, b)),
        _ => a == b,
    }
}

/// Joins two arguments that are alike; `a` may be a range already. Numbers that are printed alike are one number.
fn joined(a: &Argument, b: &Argument) -> Argument {
    if a.to_string() == b.to_string() {
        return a.clone();
    }
    match (a, b) {
        (Argument::Message(a), Argument::Message(b)) => Argument::Message(Box::new(Message::gathered(&[a, b]))),
        (Argument::List(a), Argument::List(b)) => Argument::List(a.iter().zip(b).map(|(a, b)| joined(a, b)).collect()),
        _ => match (ends(a), ends(b)) {
            (Some([low, high]), Some([lower, higher])) => Argument::Range(
                if lower.value < low.value { lower } else { low },
                if higher.value > high.value { higher } else { high },
            ),
            _ => a.clone(),
        },
    }
}

/// Smallest and largest value of a number or range.
fn ends(argument: &Argument) -> Option<[Quantity; 2]> {
    let whole = |value: u64| [Quantity { value: value as f64, unit: Unit::One, decimals: 0 }; 2];
    match argument {
        Argument::Quantity(quantity) => Some([*quantity; 2]),
        Argument::Range(low, high) => Some([*low, *high]),
        Argument::Count(count) => Some(whole(*count)),
        Argument::Pass(pass) => Some(whole(*pass as u64)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_that_differ_are_ranges() {
        let turn = |by: f64, pass: usize| {
            Message::new("axis-unwinds").axis("axis", "j1").quantity("by", by, Unit::Deg, 1).pass("pass", pass)
        };
        let all = [turn(318.2, 4), turn(711.0, 5), turn(35.1, 9)];
        assert!(all[0].is_alike(&all[2]));
        let gathered = Message::gathered(&all.iter().collect::<Vec<_>>());
        assert_eq!(gathered.as_data(), "axis-unwinds: axis = j1, by = 35.1 deg to 711.0 deg, pass = 4 to 9");
        assert_eq!(Message::gathered(&[&all[1]]), all[1]);
        assert_eq!(Message::gathered(&[&all[1], &turn(711.0000001, 5)]), all[1], "the difference is not shown");
        let other = Message::new("axis-unwinds").axis("axis", "j2").quantity("by", 318.2, Unit::Deg, 1).pass("pass", 4);
        assert!(!all[0].is_alike(&other), "another axis is another message");
    }
}
