//! Stick-out of a pass beside that of the machine's torch.

use crate::allowed::between;
use crate::outside_data::Outside;
use seamwright_document::{Document, DocumentError, Positive};
use seamwright_message::{Message, Unit};
use seamwright_program::{Program, Torch};

/// Range of stick-outs, mm: from micro-wires to submerged arcs with extended wire.
const RANGE_MM: [f64; 2] = [2.0, 150.0];

/// Stick-out of the machine of `program`, mm, if a pass needs it. Errors: no such machine.
pub(crate) fn of_machine(program: &Document<Program>, outside: &dyn Outside) -> Result<Option<f64>, DocumentError> {
    let is_named = |torch: &Torch| {
        torch.stick_out_mm.is_some() || torch.search.is_some_and(|search| search.max_stick_out_mm.is_some())
    };
    if !program.value.passes.iter().any(|pass| is_named(&pass.torch)) {
        return Ok(None);
    }
    let machine = outside.axes(&program.value.machine);
    Ok(machine.map_err(|w| program.error_at("machine", w.message, w.allowed))?.stick_out())
}

/// Distance of the machine's tip behind the arc with the stick-out of `torch`, at `path` in `file`, mm: that less the
/// `machine`'s own.
///
/// Errors with the key's address: a stick-out out of range, a machine without one.
pub(crate) fn drawn_back<T>(
    file: &Document<T>,
    path: &str,
    torch: &Torch,
    machine: Option<f64>,
) -> Result<f64, DocumentError> {
    let most = torch.search.and_then(|search| search.max_stick_out_mm).map(|most| ("search.max_stick_out_mm", most));
    let own = torch.stick_out_mm.map(|own| ("stick_out_mm", own));
    for (key, value) in own.into_iter().chain(most) {
        check(file, &format!("{path}.{key}"), value)?;
    }
    let Some((key, _)) = own.or(most) else { return Ok(0.0) };
    let Some(machine) = machine else {
        let message = Message::new("weld-stick-out-of-machine");
        return Err(file.error_at(&format!("{path}.{key}"), message, Message::new("weld-allowed-stick-out")));
    };
    let stick_out = torch.stick_out_mm.map_or(machine, Positive::get);
    if let Some((key, _)) = most.filter(|(_, most)| most.get() < stick_out) {
        let message = Message::new("weld-stick-out-above-search").value("own", stick_out, Unit::Mm);
        return Err(file.error_at(&format!("{path}.{key}"), message, between(stick_out, RANGE_MM[1], Unit::Mm)));
    }
    Ok(stick_out - machine)
}

/// Checks a stick-out at `key` of a file. Fails with the key's address.
pub(crate) fn check<T>(file: &Document<T>, key: &str, value: Positive) -> Result<(), DocumentError> {
    let [least, most] = RANGE_MM;
    if (least..=most).contains(&value.get()) {
        return Ok(());
    }
    Err(file.error_at(key, Message::new("weld-stick-out-range"), between(least, most, Unit::Mm)))
}
