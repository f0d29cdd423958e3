/// Returns the package URL, <https://github.com/package-url/purl-spec>: `@` of a scope of npm and `+` of a version are
/// written by their codes.
pub(crate) fn purl(kind: &str, name: &str, version: &str) -> String {
    format!("pkg:{kind}/{}@{}", name.replace('@', "%40"), version.replace('+', "%2B"))
}

#[cfg(test)]
mod tests {
    use super::purl;

    #[test]
    fn reserved_characters_are_written_by_their_codes() {
        assert_eq!(purl("npm", "@codemirror/state", "6.7.6"), "pkg:npm/%40codemirror/state@6.7.6");
        assert_eq!(purl("cargo", "toml", "1.2.1+spec-1.1.0"), "pkg:cargo/toml@1.2.1%2Bspec-1.1.0");
    }
}
