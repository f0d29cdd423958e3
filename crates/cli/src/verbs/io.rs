//! The registers of a machine's devices by name: once, or live.

use super::positive;
use crate::args::io::IoArgs;
use crate::rows::{Cell, Rows};
use seamwright_executive::devices::modbus::{InspectedRegister, ModbusError, RegisterInspector};
use seamwright_message::{Language, Message};
use seamwright_project::failure::Failure;
use seamwright_project::load::machine;
use std::time::{Duration, Instant};

const HEADER: &str = "t_s,device,register,place,raw,value,unit,age_s,trouble";

pub(crate) fn run(args: &IoArgs) -> Result<(), Failure> {
    let every_s = args.every_s.map(|s| positive("--every-s", s)).transpose()?;
    let machine = machine(&args.machine)?;
    let mut devices: Vec<(&str, RegisterInspector)> =
        machine.devices.modbus.iter().map(|d| (d.name.as_str(), RegisterInspector::new(d))).collect();
    if devices.is_empty() {
        let message = Message::new("cli-io-no-device").text("machine", &machine.name);
        return Err(Failure::refused(message, Message::new("cli-io-machine")));
    }
    let begun = Instant::now();
    // An unreachable device is an error at the start; one that is lost later shows by its ages.
    for (_, inspector) in &mut devices {
        inspector.look().map_err(|e| Failure::environment(&e))?;
    }
    let mut rows = Rows::with_header(HEADER, args.json);
    let mut troubles: Vec<Option<ModbusError>> = devices.iter().map(|_| None).collect();
    let mut left = args.times.or(every_s.is_none().then_some(1));
    while left != Some(0) {
        let t = begun.elapsed().as_secs_f64();
        for ((name, inspector), trouble) in devices.iter().zip(&troubles) {
            let trouble = trouble.as_ref().map(|e| e.message().in_language(Language::English));
            for looked in inspector.rows() {
                row(&mut rows, t, name, &looked, trouble.as_deref())?;
            }
        }
        rows.flush()?;
        left = left.map(|n| n - 1);
        if let (Some(every_s), true) = (every_s, left != Some(0)) {
            std::thread::sleep(Duration::from_secs_f64(every_s));
            for ((_, inspector), trouble) in devices.iter_mut().zip(&mut troubles) {
                *trouble = inspector.look().err();
            }
        }
    }
    rows.finish()
}

fn row(
    rows: &mut Rows,
    t: f64,
    device: &str,
    looked: &InspectedRegister<'_>,
    lost: Option<&str>,
) -> Result<(), Failure> {
    let number = |value: Option<f64>| value.map_or(Cell::Empty, Cell::Number);
    let register = looked.register;
    let place = register.place.to_string();
    let trouble = looked.trouble.map(|trouble| trouble.in_language(Language::English));
    let age = Some(looked.age_s).filter(|age| age.is_finite());
    rows.row(&[
        Cell::Number(t),
        Cell::Text(device),
        Cell::Text(&register.name),
        Cell::Text(&place),
        number(looked.raw),
        number(looked.value),
        Cell::Text(&register.unit),
        number(age),
        lost.or(trouble.as_deref()).map_or(Cell::Empty, Cell::Text),
    ])
}
