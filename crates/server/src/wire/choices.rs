use schemars::JsonSchema;
use serde::Serialize;
use ts_rs::TS;

/// `GET /api/choices`: machines and procedures for jobs, the supplied ones first.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ChoicesView {
    /// Values of `machine`.
    pub machines: Vec<Choice>,
    /// Values of `procedure`.
    pub procedures: Vec<Choice>,
}

/// One of them.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct Choice {
    /// Name in jobs; that of a file among the jobs ends in `.toml`.
    pub name: String,
    /// Its title.
    pub title: String,
    /// It is a file among the jobs, which can be changed.
    pub own: bool,
    /// Its text, of a procedure.
    pub text: Option<String>,
}
