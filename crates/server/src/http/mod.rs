//! HTTP: permissions of requests, and their answers.

mod answer;
mod assets;
mod audit;
mod cell_views;
mod choices;
mod client;
mod declarations;
mod diagnostics;
mod edit;
mod frames;
#[doc(hidden)]
pub mod fuzzing;
mod guard;
mod health;
mod job_name;
mod jobs;
mod jog;
mod loading;
mod login;
mod monitor_access;
mod openapi;
mod panel;
mod placement;
mod plan;
mod records;
mod restore;
mod routes;
mod schedules;
mod sensors;
mod setup;
mod socket;
mod stop;
mod target;
mod teach;
mod transfer_rate;
mod typescript;
mod users;
mod work_limit;

pub(crate) use answer::Refused;
#[cfg(test)]
pub(crate) use assets::panel_files;
pub use assets::panel_packages;
#[cfg(test)]
pub(crate) use client::hears;
pub(crate) use guard::cookie;
pub(crate) use jobs::text as job_text;
pub(crate) use loading::{adopted, planned};
pub use openapi::openapi;
pub(crate) use panel::Panel;
pub(crate) use placement::found_place;
pub(crate) use plan::begin_with;
#[cfg(test)]
pub(crate) use routes::all_routes;
pub(crate) use routes::{URGENT, app, urgent_app};
pub use typescript::typescript;
pub(crate) use work_limit::{Turn, Turns};
