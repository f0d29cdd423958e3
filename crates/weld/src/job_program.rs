//! The program of a job.

use crate::allowed::{by_key, more_than, on_weld};
use crate::job::{Job, Station};
use crate::order;
use crate::seam::SeamCurve;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive, Transform};
use seamwright_message::{Message, Unit};
use seamwright_program::{
    Consumables, Pass, Program, Ramp, Span, SpanValue, check_process_name, check_process_value, is_beyond,
    is_same_position,
};

impl Job {
    /// The program that welds `job` along its `seam`, in one pass; without its procedure, which is a file of its own.
    ///
    /// # Errors
    /// With the key's address: a weld without length, stations that are wrong.
    pub fn program(job: &Document<Self>, seam: &SeamCurve) -> Result<Program, DocumentError> {
        let j = &job.value;
        let pass = Pass {
            name: "pass 1".to_owned(),
            on_limit: j.weld.on_limit,
            least_speed_mm_s: j.weld.least_speed_mm_s,
            corner: j.weld.corner,
            sequence: j.sequence.clone(),
            torch: j.torch.clone(),
            tolerance: j.tolerance,
            spare_axes: j.spare_axes.clone(),
            weave: j.weld.weave.clone(),
            oscillation: j.weld.oscillation,
            spans: spans(job, seam)?,
            ..Pass::default()
        };
        let copies = order::copies(job)?;
        Ok(Program {
            title: j.title.clone(),
            machine: j.machine.clone(),
            offset: j.offset.clone(),
            offsets: j.offsets.clone(),
            placement: if copies.is_empty() { j.placement } else { Transform::default() },
            copies,
            seam: Some(j.seam.clone()),
            start: j.start,
            joint: j.joint.clone(),
            taught: j.taught.clone(),
            part: j.part.clone(),
            fixtures: j.fixtures.clone(),
            clearance: j.clearance,
            air: j.air,
            materials: j.materials.clone(),
            interpass: j.interpass.clone(),
            consumables: consumables(j),
            costs: j.costs.clone(),
            passes: vec![pass],
            ..Program::default()
        })
    }
}

/// The consumables of a job, with the wire of its beads.
fn consumables(job: &Job) -> Consumables {
    let of_beads = job.beads.as_ref();
    let given = &job.consumables;
    Consumables {
        wire_mm: given.wire_mm.or(of_beads.and_then(|beads| beads.wire_mm)),
        deposition: given.deposition.or(of_beads.map(|beads| beads.deposition)),
        ..given.clone()
    }
}

/// The spans of the one pass of `job` over all of its weld: from station to station. Fails with the key's address: a
/// weld without length, stations that do not increase or are not on the weld. Also values that the weld does not have
/// or that ramp over all of it.
pub(crate) fn spans(job: &Document<Job>, seam: &SeamCurve) -> Result<Vec<Span>, DocumentError> {
    let (weld, length) = (&job.value.weld, seam.weld_length());
    let whole = Positive::new(length).ok_or_else(|| {
        job.error_at("seam", Message::new("weld-without-length"), Message::new("weld-allowed-seam-with-length"))
    })?;
    check(job, length)?;
    let stations = &weld.at;
    let mut places: Vec<f64> = stations.iter().map(|at| at.s_mm.get()).collect();
    places.insert(0, 0.0);
    places.push(length);
    places.dedup_by(|later, earlier| is_same_position(*later, *earlier));
    let speeds: Vec<_> = stations.iter().filter_map(|at| Some((at.s_mm.get(), at.speed_mm_s?.get()))).collect();
    let span = |ends: &[f64]| {
        let mut span = Span {
            from_mm: NonNegative::new(ends[0]).unwrap_or_default(),
            to_mm: Positive::new(ends[1]).unwrap_or(whole),
            speed_mm_s: weld.speed_mm_s.into(),
            process: weld.process.clone(),
        };
        if !speeds.is_empty()
            && let [Some(from), Some(to)] = [0, 1].map(|i| Positive::new(linear(&speeds, ends[i])))
        {
            span.speed_mm_s = between(from, to);
        }
        for (name, value) in &mut span.process {
            let given = |at: &Station| Some((at.s_mm.get(), at.process.get(name)?.get()));
            let rows: Vec<_> = stations.iter().filter_map(given).collect();
            if !rows.is_empty() {
                let [from, to] = [0, 1].map(|i| Finite::new(linear(&rows, ends[i])).unwrap_or_default());
                *value = between(from, to);
            }
        }
        span
    };
    Ok(places.windows(2).map(span).collect())
}

pub(crate) fn check(job: &Document<Job>, length: f64) -> Result<(), DocumentError> {
    let weld = &job.value.weld;
    let mut last = None;
    for (i, at) in weld.at.iter().enumerate() {
        let (s, key) = (at.s_mm.get(), |key: &str| format!("weld.at[{i}].{key}"));
        if is_beyond(s, length) {
            return Err(job.error_at(&key("s_mm"), Message::new("weld-position-beside-weld"), on_weld(length, false)));
        }
        if let Some(last) = last.filter(|last| !is_beyond(s, *last)) {
            let message = Message::new("weld-positions-must-increase");
            return Err(job.error_at(&key("s_mm"), message, more_than(last, Unit::Mm)));
        }
        last = Some(s);
        if let (Some(least), Some(speed)) = (weld.least_speed_mm_s, at.speed_mm_s)
            && speed <= least
        {
            let allowed = by_key("weld-allowed-more-than-key", "least_speed_mm_s", least.get());
            return Err(job.error_at(&key("speed_mm_s"), Message::new("weld-speed-below-min"), allowed));
        }
        for (name, value) in &at.process {
            let path = key(&format!("process.{name}"));
            check_process_name(job, &path, name)?;
            match weld.process.get(name) {
                None => {
                    let known: Vec<&str> = weld.process.keys().map(String::as_str).collect();
                    return Err(job.unknown_name(&path, name, &known));
                }
                Some(whole) if whole.is_ramp() => {
                    let message = Message::new("weld-value-ramps-already");
                    return Err(job.error_at(&path, message, Message::new("weld-allowed-number-or-no-value")));
                }
                Some(_) => check_process_value(job, &path, name, value.get(), weld.process.keys())?,
            }
        }
    }
    Ok(())
}

/// Linear between rows (position, value), constant beyond the first and the last.
fn linear(rows: &[(f64, f64)], s: f64) -> f64 {
    let i = rows.partition_point(|row| row.0 <= s);
    match (i.checked_sub(1).map(|k| rows[k]), rows.get(i)) {
        (Some((a, v)), Some((b, w))) => v + (w - v) * (s - a) / (b - a),
        (Some((_, v)), None) => v,
        (None, Some((_, w))) => *w,
        (None, None) => f64::NAN,
    }
}

pub(crate) fn between<T: Into<f64> + Copy>(from: T, to: T) -> SpanValue<T> {
    let (a, b): (f64, f64) = (from.into(), to.into());
    if (a - b).abs() > 0.0 { SpanValue::Ramp(Ramp { from, to }) } else { SpanValue::Steady(from) }
}
