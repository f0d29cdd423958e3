//! Metrics in the text format of Prometheus, version 0.0.4.
//! <https://prometheus.io/docs/instrumenting/exposition_formats/>

use crate::wire::{CountView, DiagnosticsView, LatencyView, LineView};
use seamwright_executive::Mode;
use std::fmt::Write as _;

/// A value, with the value of the metric's label; without a label empty.
struct Sample {
    label: String,
    value: f64,
}

enum Values {
    Gauge(fn(&DiagnosticsView) -> Vec<Sample>),
    Counter(fn(&DiagnosticsView) -> Vec<Sample>),
    Histogram(fn(&DiagnosticsView) -> &LatencyView),
}

/// A metric: the single definition of its text, its values and its row in the reference.
struct Metric {
    name: &'static str,
    /// Name of its label; empty for none.
    label: &'static str,
    help: &'static str,
    values: Values,
}

impl Values {
    fn kind(&self) -> &'static str {
        match self {
            Self::Gauge(_) => "gauge",
            Self::Counter(_) => "counter",
            Self::Histogram(_) => "histogram",
        }
    }
}

fn one(value: f64) -> Vec<Sample> {
    vec![Sample { label: String::new(), value }]
}

fn any(value: Option<f64>) -> Vec<Sample> {
    value.map_or_else(Vec::new, one)
}

fn sample(label: impl Into<String>, value: f64) -> Sample {
    Sample { label: label.into(), value }
}

fn counts(rows: &[CountView]) -> Vec<Sample> {
    rows.iter().map(|row| sample(&row.name, row.count as f64)).collect()
}

fn lines(view: &DiagnosticsView, value: fn(&LineView) -> f64) -> Vec<Sample> {
    view.lines.iter().map(|line| sample(&line.name, value(line))).collect()
}

fn flag(is: bool) -> f64 {
    f64::from(u8::from(is))
}

/// Makes the table of metrics. A row has name, label (empty: none), kind, values and help.
macro_rules! metrics {
    ($($name:literal $label:literal $kind:ident $values:expr, $help:literal;)*) => {
        [$(Metric { name: $name, label: $label, help: $help, values: Values::$kind($values) }),*]
    };
}

/// All metrics, in their order on the page.
static METRICS: [Metric; 39] = metrics! {
    "seamwright_build_info" "version" Gauge |v| vec![sample(&v.version, 1.0)],
        "Version of the program; the value is 1.";
    "seamwright_uptime_seconds" "" Gauge |v| one(v.uptime_s), "Time since the start of the server.";
    "seamwright_ready" "" Gauge |v| one(flag(v.not_ready.is_empty())), "1 if /readyz answers 200, else 0.";
    "seamwright_cell_mode" "mode" Gauge modes, "1 for the mode of the cell, 0 for all others.";
    "seamwright_cycle_period_seconds" "" Gauge |v| one(v.cycle.period_s), "Period of the control cycle.";
    "seamwright_cycle_age_seconds" "" Gauge |v| any(v.cycle.age_s),
        "Time since the last status of the cycle; missing before the first one.";
    "seamwright_cycle_lateness_seconds" "le" Histogram |v| &v.cycle.latency,
        "How late cycles started, by the monotonic clock.";
    "seamwright_cycle_lateness_max_seconds" "" Gauge |v| one(v.cycle.latency.most_us * 1e-6),
        "Maximum lateness of a cycle since the start.";
    "seamwright_cycle_longest_gap_seconds" "" Gauge |v| one(v.cycle.longest_gap_ms * 1e-3),
        "Longest time without a cycle since the start.";
    "seamwright_cycles_missed_total" "" Counter |v| one(v.cycle.missed as f64), "Missed cycles.";
    "seamwright_cycles_unrecorded_total" "" Counter |v| one(v.cycle.lost as f64),
        "Cycles lost on the full queue of the cycle: their rows are not in a record.";
    "seamwright_realtime_right" "right" Gauge rights,
        "1 if the cycle has this right: priority (real-time scheduling), memory (locked). 0 if it is missing.";
    "seamwright_queue_items" "queue" Gauge |v| v.queues.iter().map(|q| sample(&q.name, q.waiting as f64)).collect(),
        "Items that wait in a queue: cycles, notes and commands of the cycle; audit: alarms and orders for the disk.";
    "seamwright_queue_items_max" "queue" Gauge |v| {
        v.queues.iter().filter_map(|q| Some(sample(&q.name, q.most? as f64))).collect()
    }, "Maximum number of items that waited in a queue of the cycle since the start.";
    "seamwright_queue_capacity" "queue" Gauge |v| v.queues.iter().map(|q| sample(&q.name, q.capacity as f64)).collect(),
        "Room of a queue.";
    "seamwright_report_age_seconds" "device" Gauge |v| {
        v.reports.iter().map(|r| sample(&r.device, r.age_s.unwrap_or(f64::INFINITY))).collect()
    }, "Age of the last report of drives, source and inputs; +Inf without a report.";
    "seamwright_device_polls_total" "device" Counter |v| lines(v, |line| line.polls as f64),
        "Polls of a device on a line (Modbus TCP) that were answered.";
    "seamwright_device_polls_missed_total" "device" Counter |v| lines(v, |line| line.missed as f64),
        "Polls left out, because the one before took too long.";
    "seamwright_device_polls_failed_total" "device" Counter |v| lines(v, |line| line.failed as f64),
        "Polls that were refused or not answered.";
    "seamwright_device_connections_total" "device" Counter |v| lines(v, |line| f64::from(line.connections)),
        "Connections made to a device.";
    "seamwright_device_away_seconds_total" "device" Counter |v| lines(v, |line| line.away_s),
        "Time without a connection to a device.";
    "seamwright_disk_free_bytes" "" Gauge |v| any(v.disk.free_bytes.map(|n| n as f64)),
        "Bytes free on the disk of the data folder.";
    "seamwright_disk_size_bytes" "" Gauge |v| any(v.disk.total_bytes.map(|n| n as f64)), "Size of that disk.";
    "seamwright_disk_write_seconds" "" Gauge |v| any(v.disk.write_s),
        "Duration of the last small write until it was on the disk.";
    "seamwright_disk_look_age_seconds" "" Gauge |v| any(v.disk.age_s),
        "Time since the disk was looked at, every 5 s; it grows while the disk hangs.";
    "process_resident_memory_bytes" "" Gauge |v| any(v.memory.map(|m| m.resident_bytes as f64)),
        "Memory of the server's process in use.";
    "seamwright_cell_resident_memory_bytes" "" Gauge |v| any(v.cell_memory.as_ref().map(|m| m.resident_bytes as f64)),
        "Memory of the cell's process in use.";
    "seamwright_cell_memory_locked_bytes" "" Gauge |v| any(v.cell_memory.as_ref().map(|m| m.locked_bytes as f64)),
        "Memory of the cell's process that is locked against paging.";
    "seamwright_alarms_active" "priority" Gauge |v| {
        v.alarms.iter().map(|row| sample(&row.priority, f64::from(row.active))).collect()
    }, "Listed alarms whose cause is present.";
    "seamwright_alarms_unacknowledged" "priority" Gauge |v| {
        v.alarms.iter().map(|row| sample(&row.priority, f64::from(row.unacknowledged))).collect()
    }, "Listed alarms that were not acknowledged.";
    "seamwright_welds_total" "result" Counter |v| counts(&v.welds),
        "Recorded welds: good, deviating, stopped; interrupted: found at the start.";
    "seamwright_workers_running" "" Gauge |v| one(v.workers.running.len() as f64),
        "Running processes that answer questions of pages.";
    "seamwright_workers_ended_total" "result" Counter |v| counts(&v.workers.ended),
        "Ended ones: answered, refused (invalid text); killed: superseded, late; memory (asked for too much), failed.";
    "seamwright_connections" "" Gauge |v| one(v.clients.connections as f64), "Open connections.";
    "seamwright_connections_ended_total" "result" Counter |v| counts(&v.clients.ended),
        "Ended connections: ended, displaced (by a newcomer), handshake (encryption failed).";
    "seamwright_pages" "" Gauge |v| one(v.clients.pages as f64), "Open pages of the panel.";
    "seamwright_sessions" "" Gauge |v| one(v.clients.sessions as f64), "Sessions of users.";
    "seamwright_logins_total" "result" Counter |v| counts(&v.clients.logins), "Logins: accepted, refused.";
    "seamwright_http_answers_total" "status" Counter |v| counts(&v.clients.answers), "Answers by HTTP status.";
};

fn modes(view: &DiagnosticsView) -> Vec<Sample> {
    let names = Mode::ALL.map(crate::cell::mode_name);
    names.iter().map(|name| sample(*name, flag(view.mode == *name))).collect()
}

fn rights(view: &DiagnosticsView) -> Vec<Sample> {
    // Unknown before the first status of the cycle.
    if view.mode.is_empty() {
        return Vec::new();
    }
    let has = |right: &&str| !view.realtime.missing.iter().any(|missing| missing == right);
    ["priority", "memory"].iter().map(|right| sample(*right, flag(has(right)))).collect()
}

/// Returns all metrics as text.
pub(crate) fn text(view: &DiagnosticsView) -> String {
    let mut page = String::new();
    for metric in &METRICS {
        // Writing to a string cannot fail.
        let _ = write!(page, "# HELP {0} {1}\n# TYPE {0} {2}\n", metric.name, metric.help, metric.values.kind());
        match &metric.values {
            Values::Gauge(values) | Values::Counter(values) => {
                for Sample { label, value } in values(view) {
                    line(&mut page, metric.name, metric.label, &label, value);
                }
            }
            Values::Histogram(of) => histogram(&mut page, metric.name, of(view)),
        }
    }
    page
}

fn histogram(page: &mut String, name: &str, latency: &LatencyView) {
    let limits = latency.limits_us.iter().map(|us| number(us * 1e-6)).chain(["+Inf".to_owned()]);
    let mut count = 0;
    for (limit, own) in limits.zip(&latency.counts) {
        count += own;
        line(page, &format!("{name}_bucket"), "le", &limit, count as f64);
    }
    line(page, &format!("{name}_sum"), "", "", latency.sum_s);
    line(page, &format!("{name}_count"), "", "", count as f64);
}

/// Adds a sample; `label` is the name of its label or empty, `of` the value of the label.
fn line(page: &mut String, name: &str, label: &str, of: &str, value: f64) {
    page.push_str(name);
    if !label.is_empty() {
        let escaped = of.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n");
        let _ = write!(page, "{{{label}=\"{escaped}\"}}");
    }
    let _ = writeln!(page, " {}", number(value));
}

/// Formats a number with at most nine decimals: sums of floating-point numbers have longer ones.
fn number(value: f64) -> String {
    if value == f64::INFINITY {
        return "+Inf".to_owned();
    }
    let text = format!("{value:.9}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::diagnostics::view::PRIORITIES;
    use std::collections::BTreeMap;

    /// A family of the text: its type, and its samples by name and labels.
    #[derive(Debug, Default)]
    pub(crate) struct Family {
        pub(crate) kind: String,
        pub(crate) samples: BTreeMap<String, f64>,
    }

    fn is_name(text: &str) -> bool {
        !text.is_empty()
            && !text.starts_with(|c: char| c.is_ascii_digit())
            && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == ':')
    }

    /// Splits `name{label="value"}` and checks both.
    fn checked(metric: &str) -> (&str, Option<(&str, String)>) {
        let Some((name, rest)) = metric.split_once('{') else {
            assert!(is_name(metric), "{metric}");
            return (metric, None);
        };
        let (label, value) = rest.strip_suffix('}').unwrap().split_once('=').unwrap();
        assert!(is_name(name) && is_name(label) && !label.contains(':'), "{metric}");
        let value = value.strip_prefix('"').unwrap().strip_suffix('"').unwrap();
        let (mut plain, mut chars) = (String::new(), value.chars());
        while let Some(c) = chars.next() {
            match c {
                '\\' => plain.push(match chars.next() {
                    Some('n') => '\n',
                    Some(c @ ('\\' | '"')) => c,
                    other => panic!("{metric}: escape {other:?}"),
                }),
                '"' | '\n' => panic!("{metric}: not escaped"),
                c => plain.push(c),
            }
        }
        (name, Some((label, plain)))
    }

    /// Reads the text by the rules of the format; panics where it breaks one.
    pub(crate) fn parse(text: &str) -> BTreeMap<String, Family> {
        let mut families = BTreeMap::<String, Family>::new();
        let mut current = String::new();
        assert!(text.ends_with('\n'), "the last line must end");
        for line in text.lines() {
            if let Some(help) = line.strip_prefix("# HELP ") {
                let (name, help) = help.split_once(' ').unwrap();
                assert!(is_name(name) && !help.is_empty(), "{line}");
                assert!(families.insert(name.to_owned(), Family::default()).is_none(), "{name} twice");
                current = name.to_owned();
            } else if let Some(kind) = line.strip_prefix("# TYPE ") {
                let (name, kind) = kind.split_once(' ').unwrap();
                let family = families.get_mut(name).unwrap();
                assert!(name == current && family.samples.is_empty() && family.kind.is_empty(), "{line}");
                assert!(["gauge", "counter", "histogram"].contains(&kind), "{line}");
                assert_eq!(name.ends_with("_total"), kind == "counter", "{line}");
                family.kind = kind.to_owned();
            } else {
                let (metric, value) = line.rsplit_once(' ').unwrap();
                let (name, _) = checked(metric);
                let family = families.get_mut(&current).unwrap();
                let suffix = name.strip_prefix(current.as_str()).unwrap_or_else(|| panic!("{line} in {current}"));
                let allowed: &[&str] = if family.kind == "histogram" { &["_bucket", "_sum", "_count"] } else { &[""] };
                assert!(allowed.contains(&suffix), "{line}");
                let value = if value == "+Inf" { f64::INFINITY } else { value.parse().unwrap() };
                assert!(family.samples.insert(metric.to_owned(), value).is_none(), "{metric} twice");
            }
        }
        families
            .iter()
            .filter(|(_, family)| family.kind == "histogram")
            .for_each(|(name, of)| check_histogram(name, of));
        families
    }

    fn check_histogram(name: &str, family: &Family) {
        let buckets = family.samples.iter().filter(|(metric, _)| metric.contains("_bucket"));
        let mut buckets: Vec<(f64, f64)> = buckets
            .map(|(metric, count)| {
                let (_, label) = checked(metric);
                let (label, limit) = label.unwrap();
                assert_eq!(label, "le");
                (if limit == "+Inf" { f64::INFINITY } else { limit.parse().unwrap() }, *count)
            })
            .collect();
        buckets.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert!(buckets.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 <= pair[1].1), "{buckets:?}");
        let last = buckets.last().unwrap();
        let [count, sum] = ["_count", "_sum"].map(|of| family.samples[&format!("{name}{of}")]);
        assert!(last.0.is_infinite() && last.1.to_bits() == count.to_bits() && sum >= 0.0, "{last:?} {count}");
    }

    #[test]
    fn labels_are_escaped_and_numbers_plain() {
        let mut page = String::new();
        line(&mut page, "x_total", "device", "a\\b\"c\nd", 1e-6);
        assert_eq!(page, "x_total{device=\"a\\\\b\\\"c\\nd\"} 0.000001\n");
        let text = format!("# HELP x_total x\n# TYPE x_total counter\n{page}");
        let families = parse(&text);
        let (_, label) = checked(families["x_total"].samples.keys().next().unwrap());
        assert_eq!(label.unwrap().1, "a\\b\"c\nd");
        assert_eq!([0.0, 12.5, 3e12, f64::INFINITY].map(number), ["0", "12.5", "3000000000000", "+Inf"]);
    }

    /// Rows of the reference.
    fn reference() -> String {
        let mut rows = String::from("| metric | type | label | meaning |\n|---|---|---|---|\n");
        for metric in &METRICS {
            let label = if metric.label.is_empty() { "–".to_owned() } else { format!("`{}`", metric.label) };
            let _ = writeln!(rows, "| `{}` | {} | {label} | {} |", metric.name, metric.values.kind(), metric.help);
        }
        rows
    }

    /// `SEAMWRIGHT_BLESS=1` writes the table.
    #[test]
    fn the_reference_has_all_metrics() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/reference/metrics.md");
        let page = std::fs::read_to_string(path).unwrap();
        let (begin, end) = ("<!-- metrics -->\n\n", "\n<!-- end -->");
        let (head, rest) = page.split_once(begin).unwrap();
        let (table, tail) = rest.split_once(end).unwrap();
        if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
            std::fs::write(path, format!("{head}{begin}{}{end}{tail}", reference())).unwrap();
            return;
        }
        assert!(table == reference(), "{path}: SEAMWRIGHT_BLESS=1 writes the table:\n{}", reference());
        assert!(PRIORITIES.iter().all(|priority| page.contains(&format!("`{priority}`"))));
    }
}
