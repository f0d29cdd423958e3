use super::dialect::Tongue;
use super::rs274::{Rs274, STATE};
use super::writer::{Problem, Writer};
use crate::part_program::{Level, Move};

/// LinuxCNC, 2.8 or newer.
#[derive(Default)]
pub(super) struct Linuxcnc {
    modal: Rs274,
}

/// Lets the control round corners between blocks.
fn blends(w: &mut Writer) {
    if w.options.rounding_mm > 0.0 {
        w.text.valued("G64 P", w.options.rounding_mm);
        w.text.line("Q0");
    } else {
        w.text.line("G64");
    }
}

fn sub_number(pass: u32) -> u32 {
    100 + pass
}

impl Tongue for Linuxcnc {
    const SUBS: Option<bool> = Some(true);

    fn head(&mut self, w: &mut Writer) {
        w.text.line(STATE);
        blends(w);
    }

    fn begin(&mut self, w: &mut Writer, number: u32, name: &str, sub: bool) {
        self.modal.forget();
        if sub {
            w.text.counted("o", sub_number(number));
            w.text.word("sub");
            w.text.comment(name);
        }
    }

    fn end(&mut self, w: &mut Writer, number: u32, sub: bool) {
        self.modal.end(w);
        if sub {
            w.text.counted("o", sub_number(number));
            w.text.line("endsub");
        }
    }

    fn call(&mut self, w: &mut Writer, number: u32, name: &str) {
        w.text.counted("o", sub_number(number));
        w.text.word("call");
        w.text.comment(name);
    }

    fn restart(&self, passes: u32) -> String {
        let last = sub_number(passes);
        format!("to start again at pass N take out the calls before that of o[100 + N]; the last pass is o{last}")
    }

    fn level(&mut self, w: &mut Writer, level: Level) {
        let Some(output) = w.control.kinematics_output else { return };
        let (value, remark) = match level {
            Level::Tip => (1.0, "words are the tip from here"),
            Level::Joint => (0.0, "words are the axes from here"),
        };
        w.text.counted("M68 E", u32::from(output));
        w.text.valued("Q", value);
        w.text.comment(remark);
        w.text.line("M66 E0 L0");
    }

    fn go(&mut self, w: &mut Writer, step: &Move, to: &[f64]) -> Result<(), Problem> {
        if step.exact_stop {
            w.text.word("G61.1");
            w.text.comment("exact stop");
        }
        self.modal.go(w, step, to)?;
        if step.exact_stop {
            blends(w);
        }
        Ok(())
    }
}
