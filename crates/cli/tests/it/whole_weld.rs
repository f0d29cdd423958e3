//! The report of a weld of many passes covers all of them: totals, a table by pass, and each finding once.

use crate::common::{example, good, json_file, run, write};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The example of many passes, planned: standard output, report.json, report.html.
fn planned(folder: &Path) -> (String, Value, String) {
    let out = folder.join("weld");
    let summary = good(&["plan", &example("thick-saddle"), "-o", &out.display().to_string()]);
    let json = serde_json::from_str(&fs::read_to_string(out.join("report.json")).unwrap()).unwrap();
    (summary, json, fs::read_to_string(out.join("report.html")).unwrap())
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn tile(page: &str, label: &str) -> f64 {
    let tile = page.split("<dl class=\"tile").find(|tile| tile.contains(&format!("<dt>{label}</dt>"))).unwrap();
    let value = tile.split("<dd class=\"value\">").nth(1).unwrap().split('<').next().unwrap();
    value.replace('\u{2212}', "-").parse().unwrap()
}

/// The cells of the rows of the table whose caption contains `caption`.
fn table(page: &str, caption: &str) -> Vec<Vec<String>> {
    let table =
        page.split("<table>").find(|table| table.split("</caption>").next().unwrap().contains(caption)).unwrap();
    let rows = table.split("</table>").next().unwrap().split("<tr>").skip(1);
    let cells = |row: &str| {
        let cells =
            row.split("</t").filter_map(|cell| cell.rsplit_once('>').map(|(_, text)| text.replace('\u{2060}', "")));
        cells.collect::<Vec<_>>()
    };
    rows.map(cells).collect()
}

#[test]
fn a_weld_of_many_passes_is_reported_as_a_whole() {
    let folder = tempfile::tempdir().unwrap();
    let planned = planned(folder.path());
    figures_of_many_passes_are_those_of_the_whole_weld(&planned);
    each_pass_has_its_row_and_none_stands_for_the_weld(&planned);
    what_is_found_in_many_passes_is_said_once(&planned);
}

fn figures_of_many_passes_are_those_of_the_whole_weld((summary, report, page): &(String, Value, String)) {
    let (totals, passes) = (&report["totals"], report["passes"].as_array().unwrap());
    assert!(passes.len() > 10 && totals["passes"] == passes.len(), "{totals}");
    // Each pass has a steady current, voltage and wire feed: energy and wire are these times the arc's time.
    let [mut energy, mut wire, mut arc, mut travel, mut length] = [0.0; 5];
    for pass in passes {
        let steady = |name: &str| {
            let ends = &pass["process_range"][name];
            assert_eq!(ends[0], ends[1], "{name}");
            number(&ends[0])
        };
        let arc_on = number(&pass["plan"]["arc_on_s"]);
        let kj = steady("current_a") * steady("voltage_v") * arc_on / 1000.0;
        assert!((number(&pass["arc_energy_kj"]) / kj - 1.0).abs() < 1e-9, "{}", pass["name"]);
        let metres = steady("wire_feed_m_min") * arc_on / 60.0;
        assert!((number(&pass["wire_m"]) / metres - 1.0).abs() < 1e-9, "{}", pass["name"]);
        (energy, wire, arc) = (energy + kj, wire + metres, arc + arc_on);
        travel += number(&pass["plan"]["weld_s"]);
        length += number(&pass["plan"]["length_mm"]);
    }
    let same = |key: &str, sum: f64| assert!((number(&totals[key]) / sum - 1.0).abs() < 1e-9, "{key}: {totals}");
    same("arc_energy_kj", energy);
    same("wire_m", wire);
    same("arc_on_s", arc);
    same("weld_s", travel);
    same("length_mm", length);
    assert_eq!(totals["total_s"], report["total_s"]);
    // A tack alone is welded in seconds.
    assert!(travel > 100.0 * number(&report["plan"]["weld_s"]));
    // The page and the command line agree, to the digits that they have.
    assert!((tile(page, "Weld time") / travel - 1.0).abs() < 1e-3, "{}", tile(page, "Weld time"));
    assert!((tile(page, "Arc-on time") / arc - 1.0).abs() < 1e-3);
    // Steel wire of 1.2 mm has 8.878 g/m, of which 95 % become weld metal.
    assert!((tile(page, "Wire") / (8.878e-3 * wire) - 1.0).abs() < 1e-3, "{}", tile(page, "Wire"));
    assert!((tile(page, "Weld metal") / (0.95 * 8.878e-3 * wire) - 1.0).abs() < 1e-3);
    assert!(summary.contains(&format!("{travel:.2} s travel, {arc:.2} s arc on")), "{summary}");
    assert!(summary.contains(&format!("{wire:.2} m of wire")), "{summary}");
}

fn each_pass_has_its_row_and_none_stands_for_the_weld((_, report, page): &(String, Value, String)) {
    let passes = report["passes"].as_array().unwrap();
    let rows = table(page, "Values of each pass");
    let column = |name: &str| rows[0].iter().position(|head| head == name).unwrap_or_else(|| panic!("{:?}", rows[0]));
    let (feed, current) = (column("Wire feed, m/min"), column("Current, A"));
    // Passes that are alike share a row.
    let numbers = |text: &str| {
        let ends: Vec<usize> = text.split(" to ").map(|n| n.parse().unwrap()).collect();
        ends[0]..=*ends.last().unwrap()
    };
    let (last, by_pass) = rows[1..].split_last().unwrap();
    let covered: Vec<usize> = by_pass.iter().flat_map(|row| numbers(&row[0])).collect();
    assert_eq!(covered, (1..=passes.len()).collect::<Vec<_>>());
    for row in by_pass {
        for pass in numbers(&row[0]).map(|n| &passes[n - 1]["process_range"]) {
            assert!((row[current].parse::<f64>().unwrap() - number(&pass["current_a"][0])).abs() < 1e-9);
            assert!((row[feed].parse::<f64>().unwrap() - number(&pass["wire_feed_m_min"][0])).abs() < 1e-9);
        }
    }
    let wire: f64 = last[column("Wire, m")].parse().unwrap();
    assert!((wire / number(&report["totals"]["wire_m"]) - 1.0).abs() < 1e-3);
    // The job's table has no values of a single pass.
    assert!(!table(page, "Times and values before and after").iter().flatten().any(|cell| cell == "Current"));
}

fn what_is_found_in_many_passes_is_said_once((summary, report, page): &(String, Value, String)) {
    let messages: Vec<&str> =
        report["findings"].as_array().unwrap().iter().map(|f| f["message"].as_str().unwrap()).collect();
    let all = messages.len();
    // Sentences that differ in numbers alone count as the same: here their first words distinguish them.
    let start = |message: &&str| message.split_whitespace().take(3).collect::<Vec<_>>().join(" ");
    let mut starts: Vec<String> = messages.iter().map(start).collect();
    starts.sort_unstable();
    starts.dedup();
    assert!(2 * starts.len() < all, "the example finds nothing twice: {messages:?}");
    for start in &starts {
        assert_eq!(summary.matches(start.as_str()).count(), 1, "{start}: {summary}");
    }
    assert_eq!(page.matches("<li>").count(), starts.len(), "{starts:?}");
    for text in [summary, page] {
        assert!(!text.to_lowercase().contains("none needed"));
    }
    // One line lists the files, and the page is short enough to read.
    assert_eq!(summary.matches("wrote").count(), 1, "{summary}");
    assert!(page.matches("<figure").count() < 8, "{}", page.matches("<figure").count());
    assert!(page.len() < 400_000, "{}", page.len());
    // The map has a row for each bead and one for the tacks.
    let rows = report["passes"].as_array().unwrap().iter().filter(|pass| pass["role"] != "tack").count() + 1;
    let map = page.split("<svg").find(|svg| svg.contains("aria-label=\"Weld map")).unwrap();
    assert_eq!(map.matches("text-anchor=\"end\"").count(), rows + 1, "names of rows, and the unit");
}

/// On a girth a bead is a circle about the shell's axis: its length is that of the arc at its own radius.
#[test]
fn the_length_of_a_pass_is_that_of_its_bead() {
    let folder = tempfile::tempdir().unwrap();
    let mut text = fs::read_to_string(example("narrow-gap-girth")).unwrap();
    for (from, to) in [
        ("procedure = \"121-girth\"\n", ""),
        ("radius_mm = 1200", "radius_mm = 500"),
        ("thickness_mm = 60", "thickness_mm = 16"),
        ("step_over_mm = 80", "tie_in_mm = 0"),
    ] {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    let out = folder.path().join("weld").display().to_string();
    run(&["plan", &write(folder.path(), "girth.toml", text), "-o", &out]);
    let report = json_file(format!("{out}/report.json"));
    let program: toml_edit::DocumentMut = fs::read_to_string(format!("{out}/program.toml")).unwrap().parse().unwrap();
    let passes = report["passes"].as_array().unwrap();
    assert!(passes.len() >= 4);
    for (pass, asked) in passes.iter().zip(program["passes"].as_array_of_tables().unwrap()) {
        let out = asked["bead"]["out_mm"][0].as_value().unwrap();
        let out: f64 = out.to_string().trim().parse().unwrap();
        let expected = (std::f64::consts::TAU + 40.0 / 500.0) * (500.0 + out);
        assert!((number(&pass["plan"]["length_mm"]) / expected - 1.0).abs() < 1e-6, "{out} {pass}");
    }
}
