//! TOML documents with addresses: errors that name file, line, key, value and what is allowed.
