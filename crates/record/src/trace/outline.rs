/// A trace reduced to few rows: none is far from its neighbours, and every column keeps its peaks.
///
/// About half of the rows are evenly spaced, the first and the last among them. The trace is also cut into buckets of
/// rows. From each bucket the rows with the minimum and the maximum of every column are taken.
#[derive(Debug)]
pub struct Outline {
    rows: u64,
    evenly: u64,
    buckets: u64,
    /// Number of the row that comes next, how many were evenly taken, and the bucket that is being filled.
    number: u64,
    taken: u64,
    bucket: u64,
    /// Of the bucket: the row with the minimum of each column, then the row with the maximum of each.
    peaks: Vec<Option<Row>>,
    /// Of the bucket: rows that were evenly taken.
    due: Vec<Row>,
    columns: Vec<Vec<f64>>,
}

/// Its number and values.
type Row = (u64, Vec<f64>);

impl Outline {
    /// The minimum number of rows of an outline of so many columns: two, and two a column.
    pub fn least(columns: usize) -> usize {
        2 + 2 * columns
    }

    /// Of a trace of so many columns and rows, in `most` rows at most; never fewer than [`Outline::least`].
    pub fn new(columns: usize, rows: u64, most: usize) -> Self {
        let peaks = 2 * columns;
        let most = most.max(Self::least(columns)) as u64;
        let evenly = (most / 2).min(most - peaks as u64);
        Self {
            rows,
            evenly: if rows <= most { rows } else { evenly },
            buckets: (most - evenly) / peaks.max(1) as u64,
            number: 0,
            taken: 0,
            bucket: 0,
            peaks: vec![None; peaks],
            due: Vec::new(),
            columns: vec![Vec::new(); columns],
        }
    }

    /// Adds the next row, with one value a column. NaN is never a peak.
    pub fn row(&mut self, values: &[f64]) {
        let bucket = self.number.saturating_mul(self.buckets) / self.rows.max(1);
        if bucket != self.bucket {
            self.close();
            self.bucket = bucket;
        }
        let number = self.number;
        let (least, greatest) = self.peaks.split_at_mut(self.columns.len());
        for (i, (least, greatest)) in least.iter_mut().zip(greatest).enumerate() {
            let value = values[i];
            if value.is_finite() {
                let beyond = |peak: &Option<Row>, is: fn(&f64, &f64) -> bool| {
                    peak.as_ref().is_none_or(|(_, row)| is(&value, &row[i]))
                };
                if beyond(least, f64::lt) {
                    put(least, number, values);
                }
                if beyond(greatest, f64::gt) {
                    put(greatest, number, values);
                }
            }
        }
        let step = self.rows.saturating_sub(1) as f64 / self.evenly.saturating_sub(1).max(1) as f64;
        if number == (self.taken as f64 * step).round() as u64 || number + 1 == self.rows {
            self.taken += 1;
            self.due.push((number, values.to_vec()));
        }
        self.number += 1;
    }

    /// The rows of a bucket in their order, each once.
    fn close(&mut self) {
        let mut rows = std::mem::take(&mut self.due);
        rows.extend(self.peaks.iter_mut().filter_map(Option::take));
        rows.sort_by_key(|(number, _)| *number);
        rows.dedup_by_key(|(number, _)| *number);
        for (_, row) in &rows {
            self.columns.iter_mut().zip(row).for_each(|(column, value)| column.push(*value));
        }
    }

    /// The values of each column.
    pub fn finish(mut self) -> Vec<Vec<f64>> {
        self.close();
        self.columns
    }
}

/// Reuses the existing memory: a row costs no allocation.
fn put(peak: &mut Option<Row>, number: u64, values: &[f64]) {
    match peak {
        Some((of, row)) => {
            *of = number;
            row.copy_from_slice(values);
        }
        None => *peak = Some((number, values.to_vec())),
    }
}

#[cfg(test)]
mod tests {
    use super::Outline;

    fn outline(rows: u64, most: usize, row: impl Fn(u64) -> Vec<f64>) -> Vec<Vec<f64>> {
        let mut outline = Outline::new(row(0).len(), rows, most);
        (0..rows).for_each(|n| outline.row(&row(n)));
        outline.finish()
    }

    #[test]
    fn a_peak_of_one_row_is_kept_wherever_it_is() {
        let rows = 10_000;
        for at in (0..rows).step_by(37) {
            let up_and_down = |n: u64| vec![n as f64, f64::from(u8::from(n == at)), -f64::from(u8::from(n == at + 5))];
            let kept = outline(rows, 100, up_and_down);
            assert!(kept[0].len() <= 100, "{}", kept[0].len());
            assert!(kept[0].is_sorted_by(|a, b| a < b));
            let place = kept[1].iter().position(|v| *v > 0.5).unwrap();
            assert_eq!(kept[0][place] as u64, at);
            assert!(at + 5 >= rows || kept[2].contains(&-1.0), "{at}");
        }
    }

    #[test]
    fn its_rows_are_never_far_apart_and_have_both_ends() {
        let kept = outline(10_000, 100, |n| vec![n as f64, 1.0]);
        assert_eq!((kept[0][0], *kept[0].last().unwrap()), (0.0, 9_999.0));
        assert!(kept[0].windows(2).all(|w| w[1] - w[0] < 10_000.0 / 49.0 + 1.0));
    }

    #[test]
    fn a_short_trace_is_whole() {
        for rows in [0, 1, 2, 99, 100] {
            assert_eq!(outline(rows, 100, |n| vec![n as f64])[0].len() as u64, rows);
        }
    }

    #[test]
    fn what_is_no_number_is_no_peak_and_stays() {
        let kept = outline(1000, 20, |n| vec![if n < 500 { f64::NAN } else { n as f64 }]);
        assert!(kept[0][0].is_nan() && kept[0].contains(&500.0), "{kept:?}");
    }
}
