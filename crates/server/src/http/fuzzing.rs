//! Readers of requests and sockets, without a cell behind them. For the fuzz targets; no part of the interface.

use super::client::number;
use super::edit::{Edit, edited};
use super::placement::found_place;
use super::setup::touched_tool;
use crate::cell::executive_command;
use crate::form;
use crate::planner::Question;
use crate::wire::{
    FormText, JobKept, JobText, Load, Login, OwnPassword, ParameterChange, PlaceText, PostText, SensorChange, Shelving,
    TeachProgram, ToCell, ToolTip, ToolTouches, UserChange,
};
use axum::Json;
use seamwright_machine::{Machine, shipped};
use serde::de::DeserializeOwned;
use std::path::Path;
use std::sync::LazyLock;

/// Draws a text, as the panel asks for it while the user types.
pub fn draft(text: &str, jobs: &Path) {
    drop(Question::Draft { text: text.to_owned() }.answer(jobs, &|_| {}));
}

/// Reads a message of a page.
pub fn socket_message(text: &str) {
    match serde_json::from_str::<ToCell>(text) {
        Ok(ToCell::Command { ask, .. }) => drop(executive_command(&ask)),
        Ok(ToCell::Teach { order, .. }) => drop(order.message().to_string()),
        Ok(_) => {}
        Err(_) => drop(number(text)),
    }
}

/// A type of body, by a name of its own, and its reader.
type Body = (&'static str, fn(&[u8], &Path));

/// Every type of body that a request has.
pub const BODIES: [Body; 16] = [
    ("edit", |body, _| read::<Edit>(body, |edit| drop(edited(&edit)))),
    ("form", |body, _| read::<FormText>(body, |form| drop(form::answer(form)))),
    ("place", |body, jobs| read::<PlaceText>(body, |asked| drop(found_place(&asked, jobs)))),
    ("tool_touches", |body, _| read::<ToolTouches>(body, |asked| drop(touched_tool(&MACHINE, &asked)))),
    ("login", |body, _| read::<Login>(body, drop)),
    ("job_kept", |body, _| read::<JobKept>(body, drop)),
    ("job_text", |body, _| read::<JobText>(body, drop)),
    ("load", |body, _| read::<Load>(body, drop)),
    ("post", |body, _| read::<PostText>(body, drop)),
    ("teach_program", |body, _| read::<TeachProgram>(body, drop)),
    ("parameters", |body, _| read::<ParameterChange>(body, drop)),
    ("tool_tip", |body, _| read::<ToolTip>(body, drop)),
    ("sensor", |body, _| read::<SensorChange>(body, drop)),
    ("shelving", |body, _| read::<Shelving>(body, drop)),
    ("user", |body, _| read::<UserChange>(body, drop)),
    ("own_password", |body, _| read::<OwnPassword>(body, drop)),
];

/// A machine whose tool is touched.
static MACHINE: LazyLock<Machine> = LazyLock::new(|| {
    let machine = shipped("torch-5axis").and_then(|file| Machine::read(file.name, file.text).ok());
    machine.unwrap_or_else(|| unreachable!("shipped machines are read in tests"))
});

/// Reads a body as its handler does, and does the part of its work that needs no cell. Other names are ignored.
pub fn request_body(name: &str, body: &[u8], jobs: &Path) {
    if let Some((_, read)) = BODIES.iter().find(|(known, _)| *known == name) {
        read(body, jobs);
    }
}

fn read<T: DeserializeOwned>(body: &[u8], then: impl FnOnce(T)) {
    if let Ok(Json(value)) = Json::<T>::from_bytes(body) {
        then(value);
    }
}
