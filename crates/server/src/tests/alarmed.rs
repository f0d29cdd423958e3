//! Alarms that stay until acknowledged, and alarms that clear by themselves.

use super::lived::{Page, Served};
use axum::http::StatusCode;
use serde_json::{Value, json};
use std::time::Duration;

fn state<'a>(list: &'a Value, name: &str) -> Option<&'a str> {
    list["list"].as_array()?.iter().find(|alarm| alarm["name"] == name)?["state"].as_str()
}

async fn until(page: &mut Page, name: &str, wanted: Option<&str>) {
    page.until(name, |v| v["kind"] == "alarms" && state(v, name) == wanted).await;
}

/// An unacknowledged alarm is listed again after a restart, until acknowledged.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn what_nobody_acknowledged_is_there_after_a_restart() {
    let (served, owner) = Served::with_owner().await;
    let mut page = served.page_up(&owner).await;
    page.order("start_jog").await;
    page.mode("jog").await;
    page.jog([0.1, 0.0]).await;
    // The page goes silent while jogging.
    page.until("the alarm", |v| v["kind"] == "alarms" && state(v, "panel silent").is_some()).await;
    drop(page);
    let served = Served::on(served.bench.end()).await;
    let mut page = served.page(&served.bench.owner().await).await;
    until(&mut page, "panel silent", Some("returned")).await;
    // Loading another program does not clear it; acknowledging does.
    let owner = served.bench.owner().await;
    assert!(served.bench.load(&owner, "ellipse.toml", None).await.0.is_success());
    let mut other = served.page(&owner).await;
    until(&mut other, "panel silent", Some("returned")).await;
    page.say(&json!({ "kind": "take_control", "over": false })).await;
    page.order("acknowledge").await;
    until(&mut other, "panel silent", None).await;
    drop((page, other));
    let folder = served.bench.end();
    let data = seamwright_record::DataFolder::open_to_read(folder.path()).unwrap();
    assert!(data.library().listed_alarms().unwrap().is_empty());
    let served = Served::on(folder).await;
    let mut page = served.page(&served.bench.owner().await).await;
    until(&mut page, "panel silent", None).await;
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn the_next_record_ends_the_alarm_of_the_last() {
    let served = Served::new().await;
    let bench = &served.bench;
    let mut page = served.page_up(&bench.owner().await).await;
    let (welds, away) = (bench.path().join("welds"), bench.path().join("away"));
    std::fs::rename(&welds, &away).unwrap();
    std::fs::write(&welds, "no folder").unwrap();
    page.weld().await;
    until(&mut page, "record failing", Some("unacknowledged")).await;
    page.order("stop").await;
    page.mode("ready").await;
    page.order("acknowledge").await;
    std::fs::remove_file(&welds).unwrap();
    std::fs::rename(&away, &welds).unwrap();
    let owner = bench.owner().await;
    // Gas flows on for a while.
    while bench.load(&owner, "ellipse.toml", None).await.0 == StatusCode::CONFLICT {
        tokio::time::sleep(Duration::from_millis(50)).await;
    }
    page.weld().await;
    until(&mut page, "record failing", None).await;
    page.order("stop").await;
    page.until("the record", |v| v["kind"] == "event" && v["what"] == "record").await;
}
