use super::error::{Fault, Read, Span};

/// Interpretation of a word's value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum How {
    /// By the modal state.
    Modal,
    /// From zero.
    Absolute,
    /// From where the axis is.
    Increment,
    /// A rotary axis the shortest way to this angle.
    Nearest,
    /// A rotary axis to this angle in positive direction.
    Upwards,
    /// A rotary axis to this angle in negative direction.
    Downwards,
}

/// Words of a block for the channels. Used for all blocks; a stamp marks those of the current one.
#[derive(Debug)]
pub(super) struct Target {
    words: Vec<Word>,
    now: u32,
    /// Number of channels that the block names.
    pub(super) count: u32,
}

/// A channel's word.
#[derive(Debug, Clone, Copy)]
pub(super) struct Word {
    pub(super) value: f64,
    pub(super) how: How,
    pub(super) span: Span,
    /// Speed behind `:`, for PVT.
    pub(super) speed: Option<f64>,
    stamp: u32,
}

/// Positions beyond this are a mistake, mm or degrees.
pub(super) const FARTHEST: f64 = 1e7;

impl Target {
    pub(super) fn new(width: usize) -> Self {
        let none = Word { value: 0.0, how: How::Modal, span: Span::default(), speed: None, stamp: 0 };
        Self { words: vec![none; width], now: 1, count: 0 }
    }

    /// Starts a new block.
    #[inline]
    pub(super) fn clear(&mut self) {
        self.now = self.now.wrapping_add(1);
        self.count = 0;
    }

    #[inline]
    pub(super) fn put(&mut self, channel: usize, value: f64, how: How, speed: Option<f64>, span: Span) -> Read {
        if self.words[channel].stamp == self.now {
            return Err(twice(span));
        }
        if value.abs() > FARTHEST {
            return Err(Fault::new(span, "post-position-too-large").allowed("post-position-allowed"));
        }
        self.words[channel] = Word { value, how, span, speed, stamp: self.now };
        self.count += 1;
        Ok(())
    }

    #[inline]
    pub(super) fn get(&self, channel: usize) -> Option<&Word> {
        let word = &self.words[channel];
        if word.stamp == self.now { Some(word) } else { None }
    }

    /// Position of the first word.
    pub(super) fn span(&self) -> Option<Span> {
        self.words.iter().filter(|w| w.stamp == self.now).map(|w| w.span).min_by_key(|s| s.from)
    }
}

/// Puts a word where none may be yet.
pub(super) fn put_once<T>(place: &mut Option<T>, word: T, span: Span) -> Read {
    if place.replace(word).is_some() { Err(twice(span)) } else { Ok(()) }
}

/// The same word twice in a block.
pub(super) fn twice(span: Span) -> Box<Fault> {
    Fault::new(span, "post-word-twice").cure("post-omit-one")
}
