use super::error::Read;
use super::lexer::Cursor;
use super::modal_state::State;
use super::programs::Programs;

/// Flow of control after a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Flow {
    Next,
    /// The sub-program with this index, so many times; then the next one.
    Call(usize, u32),
    /// Behind the sub-program with this index, which is only written down here.
    Over(usize),
    /// The caller.
    Return,
    End,
}

/// A dialect: the meaning of its lines.
pub(super) trait Lines {
    fn line(&mut self, state: &mut State, c: &mut Cursor, programs: &Programs) -> Read<Flow>;
}
