//! Reading of existing records.

use super::Bench;
use seamwright_record::library::{AuditEntry, WeldResult};
use seamwright_record::trace::{Column, Kind};
use seamwright_record::{DataFolder, Moment, Outcome, Plan};
use serde_json::Value;

const ROWS: u32 = 60_000;
const COLUMNS: [&str; 6] = ["t_s", "pass", "s_mm", "arc", "current_a", "path_error_mm"];

/// Records a weld of one minute in two parts, with one outlier in each of the last two columns.
fn record(bench: &Bench, at: u32) -> i64 {
    let mut data = DataFolder::open(bench.path()).unwrap();
    let text = |name: &str| (name.to_owned(), "schema = 1".to_owned());
    let plan = Plan {
        part: "L-1".to_owned(),
        title: "Long".to_owned(),
        simulated: true,
        program: text("a program"),
        machine: text("a machine"),
        columns: COLUMNS.map(|name| Column::new(name, "1", Kind::F64)).to_vec(),
        most_rows: u64::from(ROWS / 2),
        rows: u64::from(ROWS),
        ..Plan::default()
    };
    let mut recording = data.begin(&plan).unwrap();
    for i in 0..ROWS {
        let t = f64::from(i) * 1e-3;
        let current = if i == at { 400.0 } else { 200.0 };
        let error = if i == at + 3 { -5.0 } else { 0.01 };
        recording.row([t, 1.0, 5.0 * t, 1.0, current, error]);
    }
    let outcome = Outcome { result: WeldResult::Good, note: seamwright_message::Message::default(), files: Vec::new() };
    recording.finish(&mut data, &outcome).unwrap().id
}

fn numbers(column: &Value) -> Vec<f64> {
    column.as_array().unwrap().iter().map(|v| v.as_f64().unwrap_or(f64::NAN)).collect()
}

#[tokio::test(flavor = "multi_thread")]
async fn a_peak_of_one_row_is_sent_of_every_column() {
    let (bench, owner) = Bench::with_owner().await;
    for at in [0, 12_345, 29_998, 59_990] {
        let id = record(&bench, at);
        let path = format!("/api/records/{id}/trace?columns=pass,s_mm,arc,current_a,path_error_mm&most=400");
        let (status, trace) = bench.ask(owner.request("GET", &path, None)).await;
        assert!(status.is_success(), "{trace}");
        let columns: Vec<Vec<f64>> = trace["values"].as_array().unwrap().iter().map(numbers).collect();
        let (s, current, error) = (&columns[1], &columns[3], &columns[4]);
        assert!((200..=400).contains(&s.len()), "{}", s.len());
        assert!(s.is_sorted() && s[0].abs() < 1e-9 && (s[s.len() - 1] - 5.0 * 59.999).abs() < 1e-9);
        for (column, peak, row) in [(current, 400.0, at), (error, -5.0, at + 3)] {
            let place = column.iter().position(|v| (*v - peak).abs() < 1e-9).unwrap_or_else(|| panic!("{peak}"));
            assert!((s[place] - 5e-3 * f64::from(row)).abs() < 1e-9);
        }
    }
    // Fewer rows than the columns' peaks need are refused.
    let (status, refused) = bench.ask(owner.request("GET", "/api/records/1/trace?columns=s_mm,arc&most=5", None)).await;
    assert_eq!((status.as_u16(), &refused["text"]), (422, &Value::from("most=5; allowed: 6 to 20000")));
}

/// Pages from newest to oldest contain each entry once; a search covers all entries.
#[tokio::test(flavor = "multi_thread")]
async fn the_audit_log_is_read_page_by_page_and_searched_whole() {
    let (bench, owner) = Bench::with_owner().await;
    let entry = |n: i64| AuditEntry {
        at: Moment(n),
        user: "A. Welder".to_owned(),
        station: "panel".to_owned(),
        command: if n == 3 { "override 100%_of".to_owned() } else { format!("override {n}") },
        old: String::new(),
        new: String::new(),
        result: "taken".to_owned(),
    };
    // Entries of the login are written before the following ones.
    bench.panel.cell.archive.flush();
    let mut data = DataFolder::open(bench.path()).unwrap();
    (0..450).for_each(|n| drop(data.library_mut().audit(&entry(n)).unwrap()));
    let page = async |query: &str| {
        let list = bench.did(&owner, "GET", &format!("/api/audit?{query}"), Value::Null).await;
        let id = |row: &Value| row["id"].as_i64().unwrap();
        list.as_array().unwrap().iter().map(id).collect::<Vec<i64>>()
    };
    let mut all = page("most=200").await;
    assert_eq!(all.len(), 200);
    while all[all.len() - 1] > 1 {
        let older = page(&format!("most=200&before={}", all[all.len() - 1])).await;
        assert!(!older.is_empty());
        all.extend(older);
    }
    assert!(all.len() >= 450 && all.windows(2).all(|two| two[0] == two[1] + 1), "{all:?}");
    assert!(page("before=1").await.is_empty());
    // `after` returns all entries newer than a known one.
    assert_eq!(page(&format!("after={}", all[3])).await, all[..3]);
    // A search finds old entries, treats wildcards literally, and ignores case.
    let found = page("text=OVERRIDE%20100%25_").await;
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(page("text=welder&most=1000").await.len(), 450);
    // Words of a stored message are found in every language; its code and the keys of its JSON are not searched.
    let before = page("").await[0];
    let column = r#"{"code":"server-audit-load","arguments":[["job",{"type":"text","value":"ring.toml"}]]}"#;
    data.library_mut().audit(&AuditEntry { command: column.to_owned(), ..entry(500) }).unwrap();
    for text in [
        "LOAD%20ring",
        "ring.toml%20laden",
        "%D0%97%D0%90%D0%92%D0%90%D0%9D%D0%A2%D0%90%D0%96%D0%98%D0%A2%D0%98%20ring",
    ] {
        assert_eq!(page(&format!("text={text}")).await, [before + 1], "{text}");
    }
    for text in ["arguments", "server-audit-load", "%22value%22"] {
        assert!(page(&format!("text={text}")).await.is_empty(), "{text}");
    }
    assert!(page("text=100%25_x").await.is_empty());
}
