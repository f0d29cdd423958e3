use super::open;
use crate::args::records::ShowArgs;
use crate::failure::Failure;
use crate::rows::{print_json, print_text};
use seamwright_record::library::WeldDetail;
use seamwright_report::format_number;
use std::fmt::Write;

pub(super) fn run(args: &ShowArgs) -> Result<(), Failure> {
    let detail = open(args.data.data.as_deref())?.library().detail(args.id)?;
    if args.data.json { print_json(&detail) } else { print_text(&text(&detail)) }
}

fn text(detail: &WeldDetail) -> String {
    let weld = &detail.weld;
    let mut text = format!("weld {}: {}\n", weld.id, weld.title);
    // Writing to a String cannot fail.
    let mut line = |name: &str, value: &str| {
        let _ = writeln!(text, "  {name:<14} {value}");
    };
    let number = |v: f64| format_number(v, 5);
    line("part", &weld.part);
    line("result", &format!("{}{}", weld.result, if weld.simulated { ", simulated" } else { "" }));
    line("begun", &weld.begun.to_string());
    weld.ended.iter().for_each(|at| line("ended", &at.to_string()));
    weld.welder.iter().for_each(|name| line("welder", name));
    line("machine", &format!("{}, version {}", weld.machine.0, weld.machine.1));
    weld.procedure.iter().for_each(|(name, version)| line("procedure", &format!("{name}, version {version}")));
    weld.job.iter().for_each(|(name, version)| line("job", &format!("{name}, version {version}")));
    line("program", &format!("{}, version {}", weld.program.0, weld.program.1));
    if let Some(heat) = weld.heat_input_kj_mm {
        let [least, mean, greatest] = heat.map(number);
        line("heat input", &format!("{least} to {greatest} kJ/mm, mean {mean}"));
    }
    if let Some((worst, at)) = weld.worst_deviation_mm {
        line("deviation", &format!("{} mm at most, at s = {} mm", number(worst), number(at)));
    }
    if !weld.note.is_empty() {
        line("note", &weld.note.to_string());
    }
    for v in &detail.values {
        let allowed = v.allowed.map_or(String::new(), |(low, high)| {
            let outside =
                if v.outside_s > 0.0 { format!(", outside for {} s", number(v.outside_s)) } else { String::new() };
            format!(" ({} to {} allowed{outside})", number(low), number(high))
        });
        line(
            &format!("pass {}", v.pass),
            &format!("{} {} to {}{allowed}", v.name, number(v.least), number(v.greatest)),
        );
    }
    for alarm in &detail.alarms {
        let at = alarm.place.s_mm.map_or(String::new(), |s| format!(" at s = {} mm", number(s)));
        let cause = if alarm.cause.is_empty() { String::new() } else { format!(": {}", alarm.cause) };
        line("alarm", &format!("{}{cause}{at}", alarm.name));
    }
    detail.events.iter().for_each(|event| line("event", &format!("{}: {}", event.at, event.text)));
    for file in &detail.files {
        let rows = file.rows.map_or(String::new(), |n| format!(", {n} rows"));
        line("file", &format!("{}, {} bytes{rows}, SHA-256 {}", file.name, file.bytes, file.sha256));
    }
    text
}
