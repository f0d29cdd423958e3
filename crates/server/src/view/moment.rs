use seamwright_record::Moment;

/// Formats a time as RFC 3339, UTC, with a resolution of 1 s.
pub(crate) fn written(moment: Moment) -> String {
    moment.to_string().replacen(' ', "T", 1).replace(" UTC", "Z")
}

#[cfg(test)]
mod tests {
    #[test]
    fn browsers_read_it() {
        assert_eq!(super::written(seamwright_record::Moment(1_763_733_909_000)), "2025-11-21T14:05:09Z");
    }
}
