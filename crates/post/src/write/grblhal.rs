use super::dialect::Tongue;
use super::rs274::{Rs274, STATE};
use super::writer::{Problem, Writer};
use crate::part_program::{Event, Move};

/// grblHAL: no sub-programs; a spindle's words may switch the arc.
#[derive(Default)]
pub(super) struct Grblhal {
    modal: Rs274,
}

impl Tongue for Grblhal {
    const SUBS: Option<bool> = None;

    fn head(&mut self, w: &mut Writer) {
        if w.passes() == 0 {
            w.text.line(STATE);
        }
    }

    fn begin(&mut self, w: &mut Writer, number: u32, name: &str, _sub: bool) {
        self.modal.forget();
        w.text.counted("N", 1000 * number);
        w.text.word(STATE);
        w.text.comment(name);
    }

    fn end(&mut self, w: &mut Writer, _number: u32, _sub: bool) {
        self.modal.end(w);
    }

    fn restart(&self, passes: u32) -> String {
        format!("to start again at pass N send the lines from N1000 times N on; the last pass is N{}", 1000 * passes)
    }

    fn go(&mut self, w: &mut Writer, step: &Move, to: &[f64]) -> Result<(), Problem> {
        self.modal.go(w, step, to)?;
        if step.exact_stop {
            w.text.word("G4 P0");
            w.text.comment("exact stop");
        }
        Ok(())
    }

    fn own(&mut self, w: &mut Writer, event: &Event, at_once: bool) -> bool {
        let Event::Arc(on) = event else { return false };
        if !w.control.has_spindle_arc() {
            return false;
        }
        let word = if *on { "M3" } else { "M5" };
        if at_once {
            w.text.word(word);
            w.text.comment(if *on { "arc on" } else { "arc off" });
        } else {
            w.with_next_move(word);
        }
        true
    }
}
