//! Kept inputs, seeds and random changes of them are read by every target. Each target has a process of its own: too
//! much memory or a stack that overflows ends it.

use seamwright_fuzzing::{Random, TARGETS, Target, kept_inputs, mutate, mutate_text};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use std::{env, fs};
use tempfile::TempDir;

/// Names the target and the inputs for a process that reads them.
const TARGET: &str = "SEAMWRIGHT_FUZZ_TARGET";
const INPUTS: &str = "SEAMWRIGHT_FUZZ_INPUTS";
/// Maximum time of an input and of a process: far above what they need on a busy machine.
const INPUT_TIME: Duration = Duration::from_secs(60);
const PROCESS_TIME: Duration = Duration::from_secs(500);

#[test]
fn kept_inputs_are_read() {
    every_target("kept");
}

#[test]
fn random_changes_are_read() {
    every_target("changed");
}

fn every_target(inputs: &str) {
    let faults: Vec<String> = TARGETS.iter().filter_map(|target| fault(target, inputs)).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Factor of the number of cases. Not `testkit`'s: that crate has an allocator too.
fn soak() -> u32 {
    env::var("SEAMWRIGHT_SOAK").ok().map_or(1, |times| times.parse().unwrap())
}

/// Starts a process that reads inputs. Returns what was wrong; keeps a new input.
fn fault(target: &Target, inputs: &str) -> Option<String> {
    let folder = TempDir::with_prefix("fuzz-").unwrap();
    let output = fs::File::create(folder.path().join("output")).unwrap();
    let patience = PROCESS_TIME * soak();
    let mut reader = Command::new(env::current_exe().unwrap())
        .args(["--exact", "reads_inputs", "--include-ignored", "--nocapture"])
        .envs([(TARGET, target.name), (INPUTS, inputs)])
        .env("TMPDIR", folder.path())
        .stdout(Stdio::null())
        .stderr(output)
        .spawn()
        .unwrap();
    let start = Instant::now();
    let status = loop {
        match reader.try_wait().unwrap() {
            Some(status) => break status,
            None if start.elapsed() > patience => reader.kill().unwrap(),
            None => std::thread::sleep(Duration::from_millis(5)),
        }
    };
    if status.success() {
        return None;
    }
    let read = |name: &str| fs::read(folder.path().join(name)).unwrap_or_default();
    let (name, input) = (String::from_utf8_lossy(&read("name")).into_owned(), read("input"));
    let output = String::from_utf8_lossy(&read("output")).into_owned();
    if inputs == "kept" {
        return Some(format!("{} with {name}: {status}\n{output}", target.name));
    }
    // The next run finds it there.
    let kept = format!("{}/../../fuzz/regressions/{}", env!("CARGO_MANIFEST_DIR"), target.name);
    let hash = input.iter().fold(7u64, |hash, byte| hash.wrapping_mul(31).wrapping_add(u64::from(*byte)));
    let kept_as = format!("{kept}/found-{hash:016x}");
    fs::create_dir_all(&kept).and_then(|()| fs::write(&kept_as, &input)).unwrap();
    Some(format!("{} with {name}: {status}; the input is kept in {kept_as}\n{output}", target.name))
}

#[test]
#[ignore = "started by the other tests as a process of its own"]
fn reads_inputs() {
    let Ok(name) = env::var(TARGET) else { return };
    let target = TARGETS.iter().find(|target| target.name == name).unwrap();
    match env::var(INPUTS).as_deref() {
        Ok("kept") => {
            kept_inputs(target).iter().for_each(|input| read(target, &input.name, &input.bytes));
            (target.seeds)().iter().enumerate().for_each(|(i, seed)| read(target, &format!("seed {i}"), seed));
        }
        _ => changed(target),
    }
}

/// Reads random changes of seeds and kept inputs.
fn changed(target: &Target) {
    let mut inputs = (target.seeds)();
    inputs.extend(kept_inputs(target).into_iter().map(|input| input.bytes));
    let words = (target.words)();
    let texts: Vec<String> = inputs.iter().filter_map(|input| String::from_utf8(input.clone()).ok()).collect();
    for case in 0..target.cases * soak() {
        let mut random = Random::new(u64::from(case));
        let bytes = if target.is_text && !random.one_in(3) {
            let mut text = random.one(&texts).clone();
            (0..=random.below(6)).for_each(|_| mutate_text(&mut random, &mut text, &words, &texts, target.max_length));
            text.into_bytes()
        } else {
            let mut bytes = random.one(&inputs).clone();
            (0..=random.below(6)).for_each(|_| mutate(&mut random, &mut bytes, target.max_length));
            bytes
        };
        read(target, &format!("case {case}"), &bytes);
    }
}

/// Reads an input, which the other process finds if this one ends.
fn read(target: &Target, name: &str, input: &[u8]) {
    let folder = env::temp_dir();
    fs::write(folder.join("name"), name).and_then(|()| fs::write(folder.join("input"), input)).unwrap();
    let start = Instant::now();
    target.run(input);
    assert!(start.elapsed() < INPUT_TIME, "reading takes {:?}", start.elapsed());
}

/// Every target has a program, and every program, corpus and folder of regressions a target.
#[test]
fn targets_and_files_agree() {
    let fuzz = format!("{}/../../fuzz", env!("CARGO_MANIFEST_DIR"));
    let known = |name: &str| TARGETS.iter().any(|target| target.name == name);
    for target in TARGETS {
        assert!(fs::exists(format!("{fuzz}/src/bin/{}.rs", target.name)).unwrap(), "{} has no program", target.name);
    }
    for (folder, others) in [("src/bin", &["material"][..]), ("corpus", &[]), ("regressions", &[])] {
        for entry in fs::read_dir(format!("{fuzz}/{folder}")).into_iter().flatten() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            let name = name.split('.').next().unwrap_or_default().to_owned();
            assert!(known(&name) || others.contains(&name.as_str()), "{folder}/{name} is of no target");
        }
    }
}
