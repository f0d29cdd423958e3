//! The task that workers get once, and its pieces of work.

use crate::job_text::Templates;
use crate::plan_row::{RowResult, RowTerms, plan_contained};
use crate::study::{DrawResult, DrawTerms, Overrides, Study};
use crate::table::{Row, Table};
use crate::threads::locked;
use seamwright_message::{Language, Message};
use seamwright_project::FileStore;
use seamwright_project::failure::Failure;
use seamwright_project::posting::PostTarget;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Mutex;
use std::time::Duration;

/// Everything that plans of a table or a study depend on, besides the pieces.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct Task {
    version: String,
    /// Code of the language of faults.
    language: String,
    limit: Duration,
    work: Work,
    files: BTreeMap<PathBuf, Vec<u8>>,
}

/// Kind of the pieces.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(crate) enum Work {
    /// Rows of this table, posted for the control of this name.
    Table { path: PathBuf, post: Option<String> },
    /// Draws of this study.
    Study { path: PathBuf, draws: Option<u64>, seed: Option<u64> },
}

/// A row to be planned.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct RowPiece {
    pub(crate) hash: String,
    pub(crate) row: Row,
}

/// A planned row.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct RowPlanned {
    pub(crate) hash: String,
    /// Name of the row.
    pub(crate) name: String,
    pub(crate) result: RowResult,
    pub(crate) program: Option<String>,
}

/// A draw to be planned.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct DrawPiece {
    pub(crate) hash: u64,
    pub(crate) values: Vec<f64>,
}

/// A planned draw.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct DrawPlanned {
    pub(crate) hash: u64,
    pub(crate) result: DrawResult,
}

impl Task {
    /// A task of this program, in the language of its process.
    pub(crate) fn new(work: Work, limit: Duration, files: BTreeMap<PathBuf, Vec<u8>>) -> Self {
        let language = Language::of_process().code().to_owned();
        Self { version: env!("CARGO_PKG_VERSION").to_owned(), language, limit, work, files }
    }

    /// The task as bytes, to be given to [`Worker::new`].
    ///
    /// # Errors
    /// A path that is no Unicode.
    pub(crate) fn bytes(&self) -> Result<Vec<u8>, Failure> {
        rmp_serde::to_vec_named(self).map_err(|e| Failure::environment(e.to_string()))
    }
}

/// The version that a task begins with: it can be read from tasks of all versions.
#[derive(Deserialize)]
struct Version {
    version: String,
}

/// Plans pieces of a task, on a computer that has none of its files.
pub struct Worker {
    limit: Duration,
    language: Language,
    opened: Opened,
}

/// Data read once.
enum Opened {
    Table(Box<OpenedTable>),
    Study(Box<Study>),
}

struct OpenedTable {
    table: Table,
    templates: Mutex<Templates>,
    post: Option<PostTarget>,
}

impl Worker {
    /// A worker of the task with these bytes.
    ///
    /// # Errors
    /// A task of another version of this program, or one that is damaged.
    pub fn new(task: &[u8]) -> Result<Self, Failure> {
        let own = env!("CARGO_PKG_VERSION");
        let damaged = |_| Failure::environment(Message::new("schedule-task-damaged"));
        let Version { version } = rmp_serde::from_slice(task).map_err(damaged)?;
        if version != own {
            let message = Message::new("schedule-worker-version").text("worker", own).text("program", version);
            return Err(Failure::Environment(message));
        }
        let task: Task = rmp_serde::from_slice(task).map_err(damaged)?;
        let store = FileStore::carrying(task.files);
        let opened = match task.work {
            Work::Table { path, post } => Opened::Table(Box::new(OpenedTable {
                table: Table::carried(path, store),
                templates: Mutex::default(),
                post: post.as_deref().and_then(PostTarget::named),
            })),
            Work::Study { path, draws, seed } => {
                Opened::Study(Box::new(Study::open_from(&path, Overrides { draws, seed }, store)?))
            }
        };
        Ok(Self { limit: task.limit, language: task.language.parse().unwrap_or_default(), opened })
    }

    /// Plans one piece, and returns its result.
    ///
    /// # Errors
    /// A piece that is damaged. A weld that is impossible is a result.
    pub fn plan(&self, piece: &str) -> Result<String, Failure> {
        match &self.opened {
            Opened::Table(opened) => {
                let OpenedTable { table, templates, post } = &**opened;
                let RowPiece { hash, row } = parsed(piece)?;
                let jobs = locked(templates).jobs(table, &row)?;
                let terms = RowTerms { limit: self.limit, post: *post, cancel: None, language: self.language };
                let (result, program) = plan_contained(table, &row, &jobs, terms)?;
                text(&RowPlanned { hash, name: row.name, result, program })
            }
            Opened::Study(study) => {
                let DrawPiece { hash, values } = parsed(piece)?;
                let terms = DrawTerms { limit: self.limit, cancel: None, language: self.language };
                text(&DrawPlanned { hash, result: study.plan(&values, terms)? })
            }
        }
    }
}

/// A piece or result of JSON.
///
/// # Errors
/// Invalid text.
pub(crate) fn parsed<T: DeserializeOwned>(text: &str) -> Result<T, Failure> {
    serde_json::from_str(text).map_err(|_| Failure::environment(Message::new("schedule-task-damaged")))
}

/// A piece or result as JSON in one line.
pub(crate) fn text(piece: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string(piece).map_err(|e| Failure::environment(e.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::{Rows, Schedule};
    use crate::study::StudyRun;
    use std::path::Path;

    /// A folder with a table, its template, and a machine of its own.
    fn shop(folder: &Path) -> PathBuf {
        let example = |name: &str| seamwright_project::examples::example(name).unwrap().text.to_owned();
        let write = |name: &str, text: String| {
            std::fs::create_dir_all(folder.join(name).parent().unwrap()).unwrap();
            std::fs::write(folder.join(name), text).unwrap();
        };
        let machine = seamwright_machine::shipped("saddle-4axis").unwrap().text;
        write("jobs/shop/turntable.toml", machine.replace("name = \"saddle-4axis\"", "name = \"turntable\""));
        write("jobs/nozzle.toml", example("saddle").replace("\"saddle-4axis\"", "\"shop/turntable.toml\""));
        let columns = "name,template,seam.nozzle.radius_mm,weld.speed_mm_s\n*,jobs/nozzle.toml,,\n";
        write("table.csv", format!("{columns}N1,,250,10\nN2,,900,10\nN3,,250,5000\n"));
        folder.join("table.csv")
    }

    #[test]
    fn workers_need_no_file_of_a_table() {
        let folder = tempfile::tempdir().unwrap();
        let table = shop(folder.path());
        let output = folder.path().join("out");
        let (opened, count) = Table::open(&table).unwrap();
        let schedule = Schedule {
            table: &opened,
            output: &output,
            threads: 1,
            spark: None,
            limit: Duration::from_secs(60),
            post: PostTarget::named("linuxcnc"),
            cancel: None,
        };
        let journal = Rows::open(&folder.path().join("rows.jsonl")).unwrap();
        let task = schedule.task(&journal).unwrap().unwrap().bytes().unwrap();
        let mut pieces = Vec::new();
        opened
            .each(&mut |row| {
                pieces.push(text(&RowPiece { hash: row.name.clone(), row }).unwrap());
                Ok(true)
            })
            .unwrap();
        schedule.run(&|_| {}).unwrap();
        let read = |name: &str| std::fs::read_to_string(output.join(name)).unwrap();
        let (journal, program) = (read("rows.jsonl"), read("programs/N1.ngc"));
        drop(opened);
        folder.close().unwrap();
        let worker = Worker::new(&task).unwrap();
        let mut weldable = 0;
        for piece in &pieces {
            let planned: RowPlanned = parsed(&worker.plan(piece).unwrap()).unwrap();
            let result = serde_json::to_string(&planned.result).unwrap();
            assert!(journal.contains(&format!("\"result\":{result}}}\n")), "{result}\n{journal}");
            assert!(planned.program.is_none_or(|text| text == program));
            weldable += usize::from(planned.result.status == crate::plan_row::Status::Weldable);
        }
        assert_eq!((pieces.len() as u64, weldable), (count, 1), "{journal}");
    }

    #[test]
    fn workers_need_no_file_of_a_study() {
        let folder = tempfile::tempdir().unwrap();
        shop(folder.path());
        let path = folder.path().join("study.toml");
        let quantities = "[[quantities]]\nname = \"z\"\nvary.work = \"z_mm\"\ndraw.normal = { deviation = 30 }\n\
            [[quantities]]\nname = \"lift\"\nvary.axis_error = \"h\"\ndraw.uniform = { within = 0.5 }\n";
        let file = format!("schema = 1\njob = \"jobs/nozzle.toml\"\ndraws = 3\n{quantities}");
        std::fs::write(&path, file).unwrap();
        let study = Study::open(&path, Overrides { draws: Some(2), seed: Some(7) }).unwrap();
        let limit = Duration::from_secs(60);
        let task = study.task(limit).unwrap().bytes().unwrap();
        let output = folder.path().join("out");
        StudyRun { study: &study, output: &output, threads: 1, spark: None, limit, cancel: None }.run(&|_| {}).unwrap();
        let journal = std::fs::read_to_string(output.join("draws.jsonl")).unwrap();
        let draws: Vec<Vec<f64>> = (0..study.rows()).map(|row| study.values(row)).collect();
        let hashes: Vec<u64> = draws.iter().map(|values| study.hash_of(values, limit)).collect();
        folder.close().unwrap();
        let worker = Worker::new(&task).unwrap();
        assert_eq!(draws.len(), 2);
        for (values, hash) in draws.into_iter().zip(hashes) {
            let planned = worker.plan(&text(&DrawPiece { hash, values }).unwrap()).unwrap();
            assert!(journal.contains(&(planned.clone() + "\n")), "{planned}\n{journal}");
        }
    }

    #[test]
    fn tasks_of_other_versions_and_damaged_ones_are_refused() {
        let mut task =
            Task::new(Work::Table { path: "t.csv".into(), post: None }, Duration::from_secs(1), BTreeMap::new());
        let worker = Worker::new(&task.bytes().unwrap()).unwrap();
        assert!(worker.plan("{}").unwrap_err().text().contains("damaged"));
        let whole = task.bytes().unwrap();
        for cut in 0..whole.len() {
            assert!(Worker::new(&whole[..cut]).is_err(), "cut at {cut}");
        }
        task.version = "0.0.1".into();
        let error = Worker::new(&task.bytes().unwrap()).err().unwrap();
        assert_eq!(error.code().as_deref(), Some("schedule-worker-version"));
    }
}
