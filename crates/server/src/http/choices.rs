//! Machines and procedures that a job can name.

use super::answer::Answer;
use super::jobs::{head, own, title};
use super::panel::{Panel, Shared};
use crate::document_kind::{Kind, kind_of_head};
use crate::limits::MAX_JOB_BYTES;
use crate::wire::{Choice, ChoicesView};
use axum::Json;
use axum::extract::State;
use seamwright_machine::SHIPPED;
use seamwright_program::PROCEDURES;
use seamwright_project::files;
use std::sync::Arc;

pub(super) async fn choices(State(panel): Shared) -> Answer<ChoicesView> {
    let look = move |asked: &Arc<Panel>| {
        let shipped = |name: &str, text: &str| (name.to_owned(), title(text));
        let machine = |(name, title), own| Choice { name, title, own, text: None };
        let mut machines: Vec<Choice> = SHIPPED.iter().map(|s| machine(shipped(s.name, s.text), false)).collect();
        let procedure = |(name, title), own, text| Choice { name, title, own, text: Some(text) };
        let mut procedures: Vec<Choice> =
            PROCEDURES.iter().map(|p| procedure(shipped(p.name, p.text), false, p.text.to_owned())).collect();
        for name in own(asked)? {
            let path = asked.jobs().join(&name);
            // Unreadable files are reported in the list of jobs.
            let Ok(head) = head(&path) else { continue };
            let named = (name, title(&head));
            match kind_of_head(&head) {
                Kind::Job | Kind::Program => {}
                Kind::Machine => machines.push(machine(named, true)),
                Kind::Procedure => procedures.push(procedure(named, true, files::read_up_to(&path, MAX_JOB_BYTES)?)),
            }
        }
        Ok(ChoicesView { machines, procedures })
    };
    panel.run(|panel| &panel.reading, look).await.map(Json)
}
