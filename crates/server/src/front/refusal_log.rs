//! Refused clients in the log: summed up, so that a flood of them makes few lines.

use crate::diagnostics::Counts;
use seamwright_log as log;
use seamwright_message::{Message, Unit};
use std::collections::BTreeMap;
use std::time::Duration;

/// Period of the sums.
const PERIOD: Duration = Duration::from_secs(60);

/// Logs what was refused in each period, by kind.
pub(super) async fn sum_up(counts: &Counts) {
    let mut before = counts.refused();
    loop {
        tokio::time::sleep(PERIOD).await;
        let now = counts.refused();
        lines(&before, &now).iter().for_each(log::warn);
        before = now;
    }
}

/// Returns a message for each kind that has grown.
fn lines(before: &BTreeMap<String, u64>, now: &BTreeMap<String, u64>) -> Vec<Message> {
    let grown = now.iter().filter_map(|(kind, count)| {
        let more = count.saturating_sub(before.get(kind).copied().unwrap_or(0));
        (more > 0).then(|| {
            let message = Message::new("server-log-refused").text("kind", kind).count("n", more as usize);
            message.quantity("time", PERIOD.as_secs_f64(), Unit::S, 0)
        })
    });
    grown.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_flood_becomes_one_line() {
        let of = |rows: &[(&str, u64)]| rows.iter().map(|(kind, n)| ((*kind).to_owned(), *n)).collect();
        let (before, now) = (of(&[("401", 3), ("login", 1)]), of(&[("401", 3), ("429", 50_000), ("login", 2)]));
        let words: Vec<String> = lines(&before, &now).iter().map(ToString::to_string).collect();
        assert_eq!(words, ["refused in 60 s: 429: 50000", "refused in 60 s: login: 1"]);
    }
}
