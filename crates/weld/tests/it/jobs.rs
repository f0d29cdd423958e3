//! Jobs as texts, and what they are read as.

use glam::DVec3;
use seamwright_document::DocumentError;
use seamwright_weld::{SeamCurve, Welding};

pub(crate) fn job(seam: &str) -> String {
    format!("schema = 1\ntitle = \"t\"\nmachine = \"m\"\n{seam}\n[weld]\nspeed_mm_s = 5\n")
}

pub(crate) fn read(text: &str) -> Welding {
    Welding::read("job.toml", text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

pub(crate) fn with_seam(seam: &str) -> Welding {
    read(&job(seam))
}

/// The key that a job with this seam is refused at.
pub(crate) fn refused_key(seam: &str) -> String {
    refusal(&job(seam)).key
}

/// The error of a job that is refused; it has an address and what is allowed.
pub(crate) fn refusal(text: &str) -> DocumentError {
    let error = Welding::read("job.toml", text).map(|_| ()).unwrap_err();
    println!("{error}");
    assert!(error.line > 0 && !error.key.is_empty() && error.allowed.is_some(), "{error}");
    error
}

/// The text with each `from`, which it contains, replaced once.
pub(crate) fn changed(text: &str, changes: &[(&str, &str)]) -> String {
    changes.iter().fold(text.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    })
}

/// A vector as TOML.
pub(crate) fn vector(v: DVec3) -> String {
    format!("{:?}", v.to_array())
}

/// Vectors as TOML.
pub(crate) fn vectors(all: &[DVec3]) -> String {
    let all: Vec<String> = all.iter().map(|v| vector(*v)).collect();
    format!("[{}]", all.join(", "))
}

pub(crate) trait WithSeam {
    /// The seam, which there is.
    fn seam(&self) -> &SeamCurve;
}

impl WithSeam for Welding {
    fn seam(&self) -> &SeamCurve {
        self.seam.as_ref().unwrap()
    }
}
