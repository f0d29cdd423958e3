use schemars::JsonSchema;
use serde::Serialize;
use ts_rs::TS;

/// `GET /api/choices`: what a job can name, those that ship first.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ChoicesView {
    /// For `machine`.
    pub machines: Vec<Choice>,
    /// For `procedure`.
    pub procedures: Vec<Choice>,
}

/// One of them.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct Choice {
    /// As jobs name it: that of a file among the jobs ends in `.toml`.
    pub name: String,
    /// Its title.
    pub title: String,
    /// It is a file among the jobs, which can be changed.
    pub own: bool,
    /// Its text, of a procedure.
    pub text: Option<String>,
}
