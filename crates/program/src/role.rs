use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What a pass of several is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// The first one, at the root.
    Root,
    /// Between root and cap.
    Fill,
    /// The last layer.
    Cap,
}

impl Role {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Root => "root",
            Self::Fill => "fill",
            Self::Cap => "cap",
        }
    }
}
