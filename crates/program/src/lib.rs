//! The weld program as data: passes, spans, process values.
