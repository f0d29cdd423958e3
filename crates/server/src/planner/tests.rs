use super::*;
use std::path::Path;
use std::sync::OnceLock;
use std::time::Duration;

/// A program that acts according to the text of its question instead of answering it. It is written once, before any
/// process starts: a file being written cannot be executed.
pub(crate) fn program() -> PathBuf {
    static PROGRAM: OnceLock<(tempfile::TempDir, PathBuf)> = OnceLock::new();
    let (_, path) = PROGRAM.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("answers");
        std::fs::write(&path, SCRIPT).unwrap();
        std::fs::set_permissions(&path, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
        (folder, path)
    });
    path.clone()
}

const SCRIPT: &str = r#"#!/bin/sh
case "$(cat)" in
*long*) echo $$ > "$3/pid.new"; mv "$3/pid.new" "$3/pid"; exec sleep 600;;
*memory*) echo 'memory allocation of 13 bytes failed' >&2; kill -ABRT $$;;
*panic*) echo 'thread main panicked at x.rs:1' >&2; exit 101;;
*refused*) echo '{"refused":{"status":422,"key":"input","message":{"code":"text","arguments":[["text",{"type":"text","value":"no"}]]}}}';;
*large*) printf '{"answer":{"bytes":134217728}}\n'; head -c 134217728 /dev/zero;;
*cut*) printf '{"answer":{"bytes":5}}\n{';;
*) printf '{"answer":{"bytes":2}}\n{}';;
esac
"#;

fn page(session: &str) -> Page {
    Page { user: session.to_owned(), session: session.to_owned(), page: String::new() }
}

fn draft(text: &str) -> Question {
    Question::Draft { text: text.to_owned() }
}

fn alive(folder: &Path) -> bool {
    let Ok(pid) = std::fs::read_to_string(folder.join("pid")) else { return false };
    Path::new("/proc").join(pid.trim()).exists()
}

/// A newer draft of a page ends the process of the older one, and so does a page that closes.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn a_newer_draft_ends_the_older_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().to_owned();
    let planner = Arc::new(Planner::new(Some(program())));
    for ends in ["newer", "cancelled", "gone"] {
        let (asked, jobs) = (Arc::clone(&planner), path.clone());
        let older = tokio::spawn(async move { asked.ask(page("ada"), draft("long"), jobs).await });
        while !alive(&path) {
            tokio::time::sleep(Duration::from_millis(10)).await;
        }
        assert_eq!(planner.asked(&page("ada"))[0].name, "draft");
        assert!(planner.asked(&page("eve")).is_empty());
        match ends {
            "newer" => {
                let newer = planner.ask(page("ada"), draft("short"), path.clone()).await;
                assert_eq!(newer.unwrap(), b"{}");
            }
            "cancelled" => {
                assert_eq!(planner.cancel(&page("ada"), Some("reach")), 0, "another kind");
                assert_eq!(planner.cancel(&page("ada"), None), 1);
            }
            _ => older.abort(),
        }
        if ends != "gone" {
            assert_eq!(older.await.unwrap().unwrap_err().key, "superseded", "{ends}");
        }
        while alive(&path) {
            tokio::time::sleep(Duration::from_millis(10)).await;
        }
        std::fs::remove_file(path.join("pid")).unwrap();
        assert!(planner.asked(&page("ada")).is_empty());
    }
}

/// A user with many pages and sessions does not block others.
#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn one_user_does_not_take_all_places() {
    let folder = tempfile::tempdir().unwrap();
    let planner = Arc::new(Planner::new(Some(program())));
    let report = |text: &str| Question::Report {
        name: String::new(),
        text: text.to_owned(),
        language: String::new(),
        appendix: false,
    };
    let mut asked = Vec::new();
    for i in 0..20 {
        let page = Page { user: "eve".to_owned(), session: format!("session {i}"), page: format!("{i}") };
        let (planner, jobs, question) = (Arc::clone(&planner), folder.path().to_owned(), report("long"));
        asked.push(tokio::spawn(async move { planner.ask(page, question, jobs).await }));
    }
    while asked.iter().filter(|asked| asked.is_finished()).count() < 20 - MAX_PLANS_OF_USER {
        tokio::time::sleep(Duration::from_millis(10)).await;
    }
    let (planner, jobs, question) = (Arc::clone(&planner), folder.path().to_owned(), report("short"));
    let other = tokio::spawn(async move { planner.ask(page("ada"), question, jobs).await });
    for asked in asked {
        if !asked.is_finished() {
            asked.abort();
        } else {
            assert_eq!(asked.await.unwrap().unwrap_err().key, "slow_down");
        }
    }
    assert_eq!(other.await.unwrap().unwrap(), b"{}");
}

/// A process's error output becomes the answer; its failure affects no other.
#[test]
fn failures_of_the_process_are_answers() {
    let folder = tempfile::tempdir().unwrap();
    let counts = WorkerCounts::default();
    let ask = |text: &str, patience: Duration| {
        child::ask(&program(), &draft(text), folder.path(), &Arc::default(), patience, &counts)
    };
    let (long, short) = (Duration::from_secs(120), Duration::from_millis(200));
    let memory = ask("memory", long).unwrap_err();
    assert!(
        memory.status == StatusCode::UNPROCESSABLE_ENTITY && memory.message.to_string().contains("2 GiB"),
        "{}",
        memory.message
    );
    let panic = ask("panic", long).unwrap_err();
    assert!(
        panic.status == StatusCode::INTERNAL_SERVER_ERROR && panic.message.to_string().contains("x.rs:1"),
        "{}",
        panic.message
    );
    let late = ask("long", short).unwrap_err();
    assert!(late.message.to_string().contains("longer than"), "{}", late.message);
    let refused = ask("refused", long).unwrap_err();
    assert_eq!((refused.status.as_u16(), refused.key, refused.message.to_string()), (422, "input", "no".to_owned()));
    // An answer larger than its limit is not read to its end.
    assert_eq!(crate::limits::MAX_PLAN_BYTES, 134_217_728);
    let large = ask("large", long).unwrap_err();
    assert!(
        large.status == StatusCode::UNPROCESSABLE_ENTITY && large.message.to_string().contains("128 MiB"),
        "{}",
        large.message
    );
    // A truncated answer is an error.
    assert!(ask("cut", long).is_err());
    ask("short", long).unwrap();
    let view = counts.view();
    let ended: Vec<(&str, u64)> = view.ended.iter().map(|row| (row.name.as_str(), row.count)).collect();
    let wanted = [("answered", 1), ("refused", 2), ("superseded", 0), ("late", 1), ("memory", 1), ("failed", 2)];
    assert!(ended == wanted && view.running.is_empty(), "{view:?}");
}

#[tokio::test(flavor = "multi_thread", worker_threads = 2)]
async fn without_a_program_a_thread_answers() {
    let folder = tempfile::tempdir().unwrap();
    let planner = Planner::new(None);
    let answer = planner.ask(page("ada"), draft("title = 5"), folder.path().to_owned()).await.unwrap();
    let answer: serde_json::Value = serde_json::from_slice(&answer).unwrap();
    assert_eq!(answer["kind"], "wrong", "{answer}");
}
