//! The operator at the terminal, asked when the joint is lost.

use crate::args::teach::TeachArgs;
use crate::progress::Progress;
use crate::refusals::in_file;
use glam::DVec3;
use seamwright_message::{Message, Unit};
use seamwright_project::failure::{Failure, with_allowed};
use seamwright_project::files;
use seamwright_teaching::{Answer, Crawl, Operator, Picture, SeamLine};
use std::cell::RefCell;
use std::io::{self, BufRead as _, IsTerminal as _, Write as _};
use std::path::PathBuf;

/// Operator who answers on standard input, if there is one.
pub(super) struct Terminal<'a> {
    nominal: &'a SeamLine,
    progress: &'a Progress,
    /// The last frame.
    picture: &'a RefCell<Option<Picture>>,
    /// File of the picture for the operator.
    png: PathBuf,
    asks: bool,
    ended: bool,
}

enum Said {
    On(DVec3, Option<DVec3>),
    End,
    Stop,
}

impl<'a> Terminal<'a> {
    pub(super) fn new(
        args: &TeachArgs,
        nominal: &'a SeamLine,
        progress: &'a Progress,
        picture: &'a RefCell<Option<Picture>>,
    ) -> Self {
        let (asks, png) = (args.ask || io::stdin().is_terminal(), args.output.with_extension("png"));
        Self { nominal, progress, picture, png, asks, ended: false }
    }

    /// Whether the operator has ended the joint.
    pub(super) fn said_end(&self) -> bool {
        self.ended
    }

    fn ask(&self, why: &Message, crawl: &Crawl) -> Said {
        let mut err = io::stderr().lock();
        let at = crawl.line().points().last().map_or(crawl.target().point, |p| p.point);
        let (x, y, z, way) = (at.x, at.y, at.z, crawl.line().length());
        // If standard error is closed the operator answers without the question.
        let lost = Message::new("cli-teach-lost").quantity("way", way, Unit::Mm, 1);
        let lost = lost.text("point", format!("{x:.3},{y:.3},{z:.3}")).message("why", why.clone());
        let _ = writeln!(err, "{lost}");
        if self.draw().is_ok_and(|drawn| drawn) {
            let seen = Message::new("cli-teach-seen").text("file", self.png.display().to_string());
            let _ = writeln!(err, "   {seen}");
        }
        let answers = Message::new("cli-teach-answers");
        let _ = writeln!(err, "   {answers}");
        loop {
            let _ = write!(err, "> ").and_then(|()| err.flush());
            let mut line = String::new();
            match io::stdin().lock().read_line(&mut line) {
                Ok(read) if read > 0 => {}
                // Standard input has ended.
                _ => return Said::Stop,
            }
            match self.parse_answer(line.trim()) {
                Ok(said) => return said,
                Err(why) => {
                    let message = in_file(&format!("{:?}", line.trim()), why);
                    let _ = writeln!(err, "{}", with_allowed(message, answers.clone()));
                }
            }
        }
    }

    /// Draws the last frame. Returns whether there is one.
    fn draw(&self) -> Result<bool, Failure> {
        let picture = self.picture.borrow();
        let Some(picture) = picture.as_ref() else { return Ok(false) };
        let drawn = picture.png().map_err(Failure::Environment)?;
        files::write_with(&self.png, |out| Ok(out.write_all(&drawn)?))?;
        Ok(true)
    }

    fn parse_answer(&self, line: &str) -> Result<Said, Message> {
        match line {
            "end" => return Ok(Said::End),
            "stop" => return Ok(Said::Stop),
            _ => {}
        }
        let numbers: Option<Vec<f64>> =
            line.split(',').map(|v| v.trim().parse().ok().filter(|v: &f64| v.is_finite())).collect();
        let (point, along) = match numbers.as_deref() {
            Some([x, y, z]) => (DVec3::new(*x, *y, *z), None),
            Some([x, y, z, dx, dy, dz]) => (DVec3::new(*x, *y, *z), Some(DVec3::new(*dx, *dy, *dz))),
            _ => return Err(Message::new("cli-teach-bad-answer")),
        };
        if along.is_some_and(|along| along.try_normalize().is_none()) {
            return Err(Message::new("cli-direction-without-length"));
        }
        if self.nominal.foot(point).is_none() {
            return Err(Message::new("cli-teach-point-off-seam"));
        }
        Ok(Said::On(point, along))
    }
}

impl Operator for Terminal<'_> {
    fn answer(&mut self, why: &Message, crawl: &Crawl) -> Answer {
        if !self.asks {
            return Answer::End;
        }
        match self.progress.aside(|| self.ask(why, crawl)) {
            Said::On(point, along) => Answer::Point(point, along),
            Said::Stop => Answer::End,
            Said::End => {
                self.ended = true;
                Answer::End
            }
        }
    }
}
