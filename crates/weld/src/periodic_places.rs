use seamwright_program::PathRange;

/// All of `places` inside `range`, and again every `period`, increasing. Those nearer than `near` to each other are
/// merged, those so near to an end are left out.
pub(crate) fn repeated(
    places: impl Iterator<Item = f64>,
    period: Option<f64>,
    range: PathRange,
    near: f64,
) -> Vec<f64> {
    let PathRange { from_mm: from, to_mm: to } = range;
    let mut all = Vec::new();
    for place in places {
        match period {
            None => all.push(place),
            Some(period) => {
                let (first, last) = (((from - place) / period).floor() as i64, ((to - place) / period).ceil() as i64);
                all.extend((first..=last).map(|turn| place + turn as f64 * period));
            }
        }
    }
    all.retain(|place| *place > from + near && *place < to - near);
    all.sort_by(f64::total_cmp);
    all.dedup_by(|a, b| *a - *b < near);
    all
}
