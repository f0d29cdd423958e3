//! Writes what the fuzzer starts a target with: `material TARGET FOLDER` makes `FOLDER/seeds/`, `FOLDER/kept/` and
//! `FOLDER/words.dict`. `material` alone lists the targets; `material TARGET` prints the maximum length of an input.

use seamwright_fuzz::seamwright_fuzzing::{TARGETS, kept_inputs};
use std::fmt::Write as _;
use std::io::Result;
use std::path::Path;

fn main() -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some(name) = arguments.first() else {
        TARGETS.iter().for_each(|target| println!("{}", target.name));
        return Ok(());
    };
    let target = TARGETS.iter().find(|target| target.name == name);
    let target = target.ok_or_else(|| std::io::Error::other(format!("there is no target {name}")))?;
    let Some(folder) = arguments.get(1).map(Path::new) else {
        println!("{}", target.max_length);
        return Ok(());
    };
    let put = |folder: &Path, number: usize, bytes: &[u8]| std::fs::write(folder.join(format!("{number:05}")), bytes);
    let (seeds, kept) = (folder.join("seeds"), folder.join("kept"));
    std::fs::create_dir_all(&seeds)?;
    std::fs::create_dir_all(&kept)?;
    (target.seeds)().iter().enumerate().try_for_each(|(i, seed)| put(&seeds, i, seed))?;
    kept_inputs(target).iter().enumerate().try_for_each(|(i, input)| put(&kept, i, &input.bytes))?;
    std::fs::write(folder.join("words.dict"), dictionary(&(target.words)()))
}

/// Words in libFuzzer's form. Characters below U+0100 are single bytes.
fn dictionary(words: &[String]) -> String {
    let mut text = String::new();
    for word in words {
        text.push('"');
        for c in word.chars() {
            match u8::try_from(c) {
                Ok(byte @ (b'"' | b'\\')) => drop(write!(text, "\\{}", char::from(byte))),
                Ok(byte @ b' '..=b'~') => text.push(char::from(byte)),
                Ok(byte) => drop(write!(text, "\\x{byte:02x}")),
                Err(_) => {}
            }
        }
        text.push_str("\"\n");
    }
    text
}
