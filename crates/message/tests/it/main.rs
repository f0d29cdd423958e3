//! Catalogues: parsed without errors, complete in every language, with the same arguments, and named by the sources.

mod catalogues;
mod reference;
mod sources;
