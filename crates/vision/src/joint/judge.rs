use super::{End, Joint, Row, State};

/// A confident row has this many rows in sight before and after it, or the rim of the frame.
const RUN: usize = 14;
/// Rows of a run are at least this sure.
const SURE: f32 = 0.35;
/// Headings are those of chords this long, pixels, or as many widths.
const CHORD: (f32, f32) = (12.0, 1.2);
/// Two chords that meet make no greater angle than this, rad: a sharper turn is another joint's.
const CORNER: f32 = 0.4;
/// A line shorter than this may be a scratch, pixels.
const SHORT: f32 = 130.0;

/// Takes away the confidence that rows have by themselves but not as parts of the whole line.
pub(super) fn judge(joint: &mut Joint) {
    let way = match joint.end {
        End::Closed => joint.rows.len(),
        _ if length(&joint.rows) < SHORT => 0,
        _ => corner(&joint.rows).unwrap_or(joint.rows.len()),
    };
    for row in &mut joint.rows[way..] {
        row.confidence = row.confidence.min(0.4);
    }
    runs(joint);
}

/// Length of what was seen, pixels.
fn length(rows: &[Row]) -> f32 {
    let seen = |pair: &&[Row]| pair.iter().all(|r| r.state == State::Seen);
    rows.windows(2).filter(seen).map(|p| (p[1].x - p[0].x).hypot(p[1].y - p[0].y)).sum()
}

/// The row where the line turns more sharply than a joint, less the chord before it; chords reach over gaps.
fn corner(rows: &[Row]) -> Option<usize> {
    let first = rows.first()?;
    let pitch = (first.width / 12.0).max(1.0);
    let reach = ((CHORD.0.max(CHORD.1 * first.width)) / pitch).ceil() as usize;
    let seen: Vec<usize> = (0..rows.len()).filter(|i| rows[*i].state == State::Seen).collect();
    let heading = |a: usize, b: usize| (rows[b].y - rows[a].y).atan2(rows[b].x - rows[a].x);
    (reach..seen.len().saturating_sub(reach)).find_map(|k| {
        let (a, b, c) = (seen[k - reach], seen[k], seen[k + reach]);
        let turn = heading(b, c) - heading(a, b);
        (turn.sin().abs() > CORNER.sin() || turn.cos() < 0.0).then_some(a)
    })
}

/// Rows without a long enough run on both sides lose their confidence.
fn runs(joint: &mut Joint) {
    let Joint { rows, end } = joint;
    let open = matches!(end, End::LeftImage | End::Closed);
    let (count, mut last_gap) = (rows.len(), None::<usize>);
    let good = |row: &Row| row.state == State::Seen && row.confidence >= SURE;
    let mut cut = 0;
    for i in 0..count {
        if !good(&rows[i]) {
            let from = i.saturating_sub(RUN).max(cut);
            rows[from..i].iter_mut().for_each(|r| r.confidence = r.confidence.min(0.4));
            (last_gap, cut) = (Some(i), i);
        } else if last_gap.is_some_and(|gap| i - gap <= RUN) {
            rows[i].confidence = rows[i].confidence.min(0.4);
        }
    }
    if !open {
        rows[count.saturating_sub(RUN)..].iter_mut().for_each(|r| r.confidence = r.confidence.min(0.4));
    }
}
