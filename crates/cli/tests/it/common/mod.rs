//! Running the built command.

#![allow(dead_code, unreachable_pub, reason = "each test file uses its own part")]

pub mod checker;

use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The repository's root.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// An example job's path.
pub fn example(name: &str) -> String {
    root().join("examples").join(format!("{name}.toml")).display().to_string()
}

/// The example ellipse beside the home position of its machine, with little gas after the arc: what is waited for in real
/// time is short.
pub fn beside_home() -> String {
    let ellipse = std::fs::read_to_string(example("ellipse")).unwrap();
    let near = ellipse.replace("postflow_s = 5 ", "postflow_s = 0.2 ") + "\n[placement]\nmove_mm = [-500, -150, 0]\n";
    assert!(near.contains("postflow_s = 0.2"));
    near
}

/// An example job without its procedure, to be changed beyond it.
pub fn free_example(name: &str) -> String {
    let text = std::fs::read_to_string(example(name)).unwrap();
    text.lines().filter(|line| !line.starts_with("procedure = ")).map(|line| format!("{line}\n")).collect()
}

/// An example with part of its seam, as a job in `folder`: `whole` in its text becomes `part`.
pub fn part_of(folder: &Path, name: &str, whole: &str, part: &str) -> String {
    let text = std::fs::read_to_string(example(name)).unwrap();
    assert!(text.contains(whole), "{name}: {whole}");
    write(folder, &format!("{name}.toml"), text.replace(whole, part))
}

/// Starts `seamwright` with pipes for its input and outputs.
pub fn start(arguments: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_seamwright"));
    let piped = command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    piped.spawn().unwrap()
}

/// Runs `seamwright` with standard input.
pub fn run_with(arguments: &[&str], input: &str) -> Output {
    let mut child = start(arguments);
    // From a thread of its own: the child may answer before it has read everything, or not read at all.
    let mut stdin = child.stdin.take().unwrap();
    let input = input.to_owned();
    let writer = std::thread::spawn(move || stdin.write_all(input.as_bytes()).ok());
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    output
}

/// Runs `seamwright`.
pub fn run(arguments: &[&str]) -> Output {
    run_with(arguments, "")
}

/// Standard error of a run that must end with this code.
pub fn bad(code: i32, arguments: &[&str]) -> String {
    let output = run(arguments);
    let told = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {told}");
    told
}

/// Standard output of a run that must succeed.
pub fn good(arguments: &[&str]) -> String {
    let output = run(arguments);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {errors}");
    String::from_utf8(output.stdout).unwrap()
}

/// Standard output of a run that must succeed, as JSON.
pub fn json(arguments: &[&str]) -> Value {
    serde_json::from_str(&good(arguments)).unwrap()
}

pub fn json_file(path: impl AsRef<Path>) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Asserts that `text` contains all of `words`.
pub fn has_all(text: &str, words: &[&str]) {
    words.iter().for_each(|word| assert!(text.contains(word), "{word} in {text}"));
}

/// Writes a file; returns its path.
pub fn write(folder: &Path, name: &str, content: impl AsRef<[u8]>) -> String {
    let path = folder.join(name);
    std::fs::write(&path, content).unwrap();
    path.display().to_string()
}

/// A file in a folder of its own: tests run at the same time.
pub fn scratch_file(name: &str, bytes: &[u8]) -> String {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let count = COUNT.fetch_add(1, Ordering::Relaxed);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{}-{count}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    write(&folder, name, bytes)
}

/// Width, height and pixels of a PNG file in red, green and blue.
pub fn picture(path: &str) -> ((u32, u32), Vec<[u8; 3]>) {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    (reader.info().size(), bytes.as_chunks::<3>().0.to_vec())
}

/// A CSV table: header and rows of numbers (NaN where a cell is empty or text).
pub fn table(csv: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut lines = csv.lines();
    let header = lines.next().unwrap().split(',').map(str::to_owned).collect();
    let rows = lines.map(|l| l.split(',').map(|c| c.parse().unwrap_or(f64::NAN)).collect()).collect();
    (header, rows)
}

/// A column of a table.
pub fn column(table: &(Vec<String>, Vec<Vec<f64>>), name: &str) -> Vec<f64> {
    let i = table.0.iter().position(|c| c == name).unwrap_or_else(|| panic!("no column {name} in {:?}", table.0));
    table.1.iter().map(|row| row[i]).collect()
}
