//! Frames on a socket: a length, then a message.

use serde::Serialize;
use serde::de::DeserializeOwned;
use std::io::{self, ErrorKind, Read, Write};

/// Bytes of the length.
const HEAD: usize = 4;
/// Bytes read at once.
const READ: usize = 1 << 16;

/// Appends `message` to `to` as one frame.
pub(crate) fn encode(message: &impl Serialize, to: &mut Vec<u8>) -> io::Result<()> {
    let begin = to.len();
    to.extend_from_slice(&[0; HEAD]);
    if let Err(error) = rmp_serde::encode::write_named(to, message) {
        to.truncate(begin);
        return Err(io::Error::other(error));
    }
    let length = u32::try_from(to.len() - begin - HEAD).map_err(io::Error::other)?;
    to[begin..begin + HEAD].copy_from_slice(&length.to_le_bytes());
    Ok(())
}

/// Received bytes, up to the next whole frame.
#[derive(Debug)]
pub(crate) struct Inbox {
    bytes: Vec<u8>,
    /// Bytes that have been decoded.
    done: usize,
    /// Room for one read.
    chunk: Box<[u8]>,
}

impl Default for Inbox {
    fn default() -> Self {
        Self { bytes: Vec::new(), done: 0, chunk: vec![0; READ].into_boxed_slice() }
    }
}

impl Inbox {
    /// Reads what has come. Returns false at the end of the stream.
    pub(crate) fn read(&mut self, from: &mut impl Read) -> io::Result<bool> {
        match from.read(&mut self.chunk) {
            Ok(count) => {
                self.bytes.drain(..std::mem::take(&mut self.done));
                self.bytes.extend_from_slice(&self.chunk[..count]);
                Ok(count > 0)
            }
            Err(e) if matches!(e.kind(), ErrorKind::WouldBlock | ErrorKind::Interrupted | ErrorKind::TimedOut) => {
                Ok(true)
            }
            Err(e) => Err(e),
        }
    }

    /// Decodes the next frame; `None` if it is not whole yet.
    ///
    /// # Errors
    /// A frame longer than `max` bytes, or one that is no `T`.
    pub(crate) fn next<T: DeserializeOwned>(&mut self, max: usize) -> io::Result<Option<T>> {
        let rest = &self.bytes[self.done..];
        let Some((head, rest)) = rest.split_first_chunk::<HEAD>() else { return Ok(None) };
        let length = u32::from_le_bytes(*head) as usize;
        if length > max {
            return Err(io::Error::new(ErrorKind::InvalidData, "a frame is longer than allowed"));
        }
        let Some(frame) = rest.get(..length) else { return Ok(None) };
        let message = rmp_serde::from_slice(frame).map_err(|e| io::Error::new(ErrorKind::InvalidData, e))?;
        self.done += HEAD + length;
        Ok(Some(message))
    }
}

/// Bytes to be sent, as far as the other side reads them.
#[derive(Debug, Default)]
pub(crate) struct Outbox {
    bytes: Vec<u8>,
    sent: usize,
}

impl Outbox {
    /// Number of bytes that wait.
    pub(crate) fn waiting(&self) -> usize {
        self.bytes.len() - self.sent
    }

    /// Adds a message.
    pub(crate) fn push(&mut self, message: &impl Serialize) -> io::Result<()> {
        encode(message, &mut self.bytes)
    }

    /// Sends what the other side takes without a wait.
    pub(crate) fn flush(&mut self, to: &mut impl Write) -> io::Result<()> {
        while self.sent < self.bytes.len() {
            match to.write(&self.bytes[self.sent..]) {
                Ok(0) => return Err(ErrorKind::WriteZero.into()),
                Ok(count) => self.sent += count,
                Err(e) if e.kind() == ErrorKind::Interrupted => {}
                Err(e) if e.kind() == ErrorKind::WouldBlock => break,
                Err(e) => return Err(e),
            }
        }
        if self.sent == self.bytes.len() {
            self.bytes.clear();
            self.sent = 0;
        } else if self.sent > READ {
            self.bytes.drain(..std::mem::take(&mut self.sent));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::{MAX_REQUEST, Request, VERSION};
    use seamwright_executive::{Ask, Command};

    fn requests() -> Vec<Request> {
        let command = |ask| Request::Command(Command::of(ask));
        vec![
            Request::Hello { version: VERSION },
            Request::Beat,
            command(Ask::Override(0.25)),
            command(Ask::AcknowledgeOne(seamwright_executive::Alarm::ALL[3], 7)),
            Request::NoRecord { start: 3 },
            Request::Shutdown,
        ]
    }

    /// Frames are decoded whatever the pieces in which they arrive.
    #[test]
    fn frames_cross_in_any_pieces() {
        let mut bytes = Vec::new();
        requests().iter().for_each(|request| encode(request, &mut bytes).unwrap());
        for piece in [1, 2, 3, 5, 7, 64, 4096] {
            let (mut inbox, mut came) = (Inbox::default(), Vec::new());
            for mut part in bytes.chunks(piece) {
                assert!(inbox.read(&mut part).unwrap());
                while let Some(request) = inbox.next::<Request>(MAX_REQUEST).unwrap() {
                    came.push(request);
                }
            }
            assert_eq!(came, requests(), "{piece}");
        }
    }

    #[test]
    fn long_and_invalid_frames_are_refused() {
        let mut inbox = Inbox::default();
        inbox.read(&mut &u32::MAX.to_le_bytes()[..]).unwrap();
        assert_eq!(inbox.next::<Request>(MAX_REQUEST).unwrap_err().kind(), ErrorKind::InvalidData);
        let mut inbox = Inbox::default();
        inbox.read(&mut &[3, 0, 0, 0, 0xc1, 0xff, 0x00][..]).unwrap();
        assert_eq!(inbox.next::<Request>(MAX_REQUEST).unwrap_err().kind(), ErrorKind::InvalidData);
        assert!(!Inbox::default().read(&mut &[][..]).unwrap());
    }
}
