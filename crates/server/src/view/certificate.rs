use crate::wire::{BoundView, CertificateView, UseView};
use seamwright_machine::Machine;
use seamwright_motion::speed_profile::ProfilePoint;
use seamwright_motion::{Binding, PassMotion};
use seamwright_program::Pass;
use seamwright_report::CertificateFigures;

pub(super) fn certificate(machine: &Machine, pass: &Pass, planned: &PassMotion) -> CertificateView {
    let figures = CertificateFigures::new(machine, pass, planned);
    let bounds = planned.certificate.intervals.iter().map(|i| {
        let binding = Binding::new(machine, i.bound);
        BoundView {
            from_mm: i.from,
            to_mm: i.to,
            least_speed_mm_s: i.speed.0,
            between: i.between,
            what: binding.as_ref().map_or("asked", |b| b.kind.name()).to_owned(),
            axis: binding.as_ref().and_then(|b| b.axis.clone()),
            limit: binding.as_ref().map(|b| b.value),
            unit: binding.map(|b| b.unit.to_string()),
        }
    });
    let finite = |limit: f64| limit.is_finite().then_some(limit);
    let axes = figures.uses.into_iter().map(|used| UseView {
        axis: Some(used.axis),
        unit: used.unit.to_owned(),
        percent: [used.speed_percent, used.acceleration_percent, used.jerk_percent].map(Some),
        limit: [used.max_speed, used.max_acceleration, used.max_jerk].map(finite),
    });
    let tip = figures.tip.into_iter().map(|tip| UseView {
        axis: None,
        unit: "mm".to_owned(),
        percent: [tip.speed_percent, tip.acceleration_percent, tip.jerk_percent],
        limit: [tip.max_speed, tip.max_acceleration, tip.max_jerk],
    });
    CertificateView {
        at_asked_percent: figures.at_asked_percent,
        everywhere_mm_s: figures.everywhere_mm_s,
        bounds: bounds.collect(),
        uses: axes.chain(tip).collect(),
    }
}

/// Returns speed, acceleration and jerk of each axis at `profile`, in whole per cent of its limits.
pub(super) fn used(machine: &Machine, planned: &PassMotion, profile: ProfilePoint) -> Vec<[u8; 3]> {
    let p = planned.path.point(profile.s, false);
    let (v, a) = (profile.v, profile.a);
    let axes = machine.axes.iter().enumerate().map(|(i, axis)| {
        let (d1, d2, d3) = (p.d1[i], p.d2[i], p.d3[i]);
        let speed = d1 * v / axis.max_speed;
        let acceleration = (d2 * v * v + d1 * a) / axis.max_acceleration;
        let jerk = (d3 * v * v * v + 3.0 * d2 * v * a + d1 * profile.j) / axis.jerk();
        // A plan contains no values beyond 255 %.
        [speed, acceleration, jerk].map(|part| (100.0 * part.abs()).round().min(255.0) as u8)
    });
    axes.collect()
}
