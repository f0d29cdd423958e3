use seamwright_message::{Message, display_by_message};
use std::fmt;
use std::str::FromStr;
use std::time::{SystemTime, UNIX_EPOCH};

/// A date and time, in whole ms since 1970-01-01 UTC; written `2026-11-21 14:05:09 UTC`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Moment(pub i64);

const DAY_MS: i64 = 86_400_000;

impl Moment {
    /// By the system's clock.
    pub fn now() -> Self {
        let since = SystemTime::now().duration_since(UNIX_EPOCH);
        Self(since.map_or(0, |d| i64::try_from(d.as_millis()).unwrap_or(i64::MAX)))
    }

    /// Returns it as RFC 3339 writes it, with milliseconds: `2026-11-21T14:05:09.250Z`.
    pub fn rfc3339(self) -> String {
        let second = self.to_string().replacen(' ', "T", 1).replace(" UTC", "");
        format!("{second}.{:03}Z", self.0.rem_euclid(1000))
    }

    /// The time so many ms later.
    #[must_use]
    pub fn after_ms(self, ms: u64) -> Self {
        Self(self.0.saturating_add(i64::try_from(ms).unwrap_or(i64::MAX)))
    }

    /// The beginning of the next day.
    #[must_use]
    pub fn next_day(self) -> Self {
        Self((self.0.div_euclid(DAY_MS) + 1) * DAY_MS)
    }

    /// Year, month and day (H. Hinnant's civil_from_days).
    fn civil(self) -> (i64, i64, i64) {
        // Count from 0000-03-01, so that the leap day ends a year.
        let days = self.0.div_euclid(DAY_MS) + 719_468;
        let era = days.div_euclid(146_097);
        let of_era = days.rem_euclid(146_097);
        let year_of_era = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
        let of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
        let shifted = (5 * of_year + 2) / 153;
        let day = of_year - (153 * shifted + 2) / 5 + 1;
        let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
        (year_of_era + era * 400 + i64::from(month <= 2), month, day)
    }

    /// Midnight of a day, if there is such a day.
    fn of_civil(year: i64, month: i64, day: i64) -> Option<Self> {
        let (y, m) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
        let of_year = (153 * m + 2) / 5 + day - 1;
        let era = y.div_euclid(400);
        let of_era = y.rem_euclid(400) * 365 + y.rem_euclid(400) / 4 - y.rem_euclid(400) / 100 + of_year;
        let moment = Self((era * 146_097 + of_era - 719_468) * DAY_MS);
        (moment.civil() == (year, month, day)).then_some(moment)
    }
}

impl fmt::Display for Moment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (year, month, day) = self.civil();
        let s = self.0.rem_euclid(DAY_MS) / 1000;
        write!(f, "{year:04}-{month:02}-{day:02} {:02}:{:02}:{:02} UTC", s / 3600, s / 60 % 60, s % 60)
    }
}

impl FromStr for Moment {
    type Err = InvalidMoment;

    /// `2026-11-21`, which is its midnight, or `2026-11-21 14:05` with or without seconds; UTC.
    fn from_str(text: &str) -> Result<Self, InvalidMoment> {
        let refused = || InvalidMoment { text: text.to_owned() };
        let (date, time) = text.trim().split_once([' ', 'T']).unwrap_or((text.trim(), "00:00"));
        let numbers = |part: &str, by: char| -> Option<Vec<i64>> {
            let all = part.split(by).map(|n| n.bytes().all(|b| b.is_ascii_digit()).then(|| n.parse().ok())?);
            all.collect()
        };
        let time = time.trim_end_matches('Z').trim_end_matches(" UTC");
        let (date, time) = (numbers(date, '-').ok_or_else(refused)?, numbers(time, ':').ok_or_else(refused)?);
        let ([year @ 1..=9999, month @ 1..=12, day], [hour @ 0..24, minute @ 0..60, rest @ ..]) = (&*date, &*time)
        else {
            return Err(refused());
        };
        let second = match rest {
            [] => 0,
            [second @ 0..60] => *second,
            _ => return Err(refused()),
        };
        let midnight = Self::of_civil(*year, *month, *day).ok_or_else(refused)?;
        Ok(Self(midnight.0 + 1000 * (3600 * hour + 60 * minute + second)))
    }
}

/// A text is not a [`Moment`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InvalidMoment {
    /// The text.
    pub text: String,
}

impl InvalidMoment {
    /// Returns its message.
    pub fn message(&self) -> Message {
        Message::new("record-invalid-moment").text("text", &self.text)
    }
}

display_by_message!(InvalidMoment);

pub(crate) fn written<S: serde::Serializer>(moment: &Moment, out: S) -> Result<S::Ok, S::Error> {
    out.collect_str(moment)
}

pub(crate) fn written_option<S: serde::Serializer>(moment: &Option<Moment>, out: S) -> Result<S::Ok, S::Error> {
    match moment {
        Some(moment) => out.collect_str(moment),
        None => out.serialize_none(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dates_there_and_back() {
        assert_eq!(Moment(0).to_string(), "1970-01-01 00:00:00 UTC");
        assert_eq!(Moment(11_016 * DAY_MS).to_string(), "2000-02-29 00:00:00 UTC");
        assert_eq!(Moment(47_541 * DAY_MS - 1000).to_string(), "2100-02-28 23:59:59 UTC");
        assert_eq!("2026-11-21 14:05:09".parse(), Ok(Moment(1_795_269_909_000)));
        assert_eq!(Moment(1_795_269_909_007).rfc3339(), "2026-11-21T14:05:09.007Z");
        let mut day = Moment(-200 * 365 * DAY_MS);
        while day < Moment(200 * 365 * DAY_MS) {
            let text = day.to_string();
            assert_eq!(text.parse(), Ok(day), "{text}");
            assert_eq!(text[..10].parse(), Ok(day), "{text}");
            day = day.next_day();
        }
    }

    #[test]
    fn no_such_dates() {
        for bad in [
            "",
            "2026",
            "2026-13-01",
            "2026-02-29",
            "2026-00-10",
            "2026-11-31",
            "21.11.2026",
            "2026-11-21 25:00",
            "2026-11-21 10",
            "2026-11-21 10:60",
            "2026-11-21 10:00:00:00",
            "-1-1-1",
            "2026-1+1-1",
            "99999999999999999999-1-1",
        ] {
            let told = bad.parse::<Moment>().unwrap_err();
            assert!(told.to_string().contains("2026-11-21"), "{told}");
        }
    }
}
