use seamwright_record::Moment;

/// Date and time now, in UTC, like `2026-11-21 14:05 UTC`.
pub(crate) fn now() -> String {
    let mut text = Moment::now().to_string();
    // Without seconds.
    text.replace_range(16..19, "");
    text
}

#[cfg(test)]
mod tests {
    #[test]
    fn to_the_minute() {
        let now = super::now();
        assert!(now.len() == 20 && now.ends_with(" UTC") && now.matches(':').count() == 1, "{now}");
    }
}
