//! Catalogues: parsed without errors, complete in every language, with the same arguments.

mod catalogues;
