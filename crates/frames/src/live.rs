use crate::error::FrameError;
use crate::stream::FrameStream;
use crate::{FrameSource as _, TimedFrame};
use seamwright_message::Message;
use seamwright_vision::Image;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// A camera that sends frames over a stream at its own rate: the newest counts. A thread reads all of them, so that
/// none waits in the connection and comes late.
#[derive(Debug)]
pub struct LiveFrames {
    shared: Arc<Shared>,
    address: String,
    patience: Duration,
}

#[derive(Debug, Default)]
struct Shared {
    state: Mutex<State>,
    came: Condvar,
    closed: AtomicBool,
}

#[derive(Debug, Default)]
struct State {
    /// The newest frame and its time of arrival.
    newest: Option<(Instant, TimedFrame)>,
    ended: Option<FrameError>,
}

impl Shared {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl LiveFrames {
    /// Connects to `address` (host:port). A frame with a size other than `size_px` (columns, rows) is an error; so is a
    /// gap longer than `patience`.
    ///
    /// # Errors
    /// Unknown address, or no connection.
    pub fn connect(address: &str, size_px: [usize; 2], patience: Duration) -> Result<Self, FrameError> {
        let mut stream = FrameStream::connect(address, patience)?;
        let what = address.to_owned();
        let shared = Arc::new(Shared::default());
        let reads = Arc::clone(&shared);
        std::thread::spawn(move || {
            while !reads.closed.load(Ordering::Relaxed) {
                let next = stream.next().and_then(|frame| sized(frame, size_px, &what));
                let mut state = reads.state();
                match next {
                    Ok(Some(frame)) => state.newest = Some((Instant::now(), frame)),
                    Ok(None) => {
                        let why = Message::new("cell-camera-closed");
                        state.ended = Some(FrameError::Io { what: what.clone(), why });
                    }
                    Err(e) => state.ended = Some(e),
                }
                let over = state.ended.is_some();
                drop(state);
                reads.came.notify_all();
                if over {
                    return;
                }
            }
        });
        Ok(Self { shared, address: address.to_owned(), patience })
    }

    /// Returns the first frame that was certainly exposed after this call, if a frame arrives at most `latency` after
    /// its exposure.
    ///
    /// # Errors
    /// A fault or the end of the stream; no frame in time.
    pub fn next(&mut self, latency: Duration) -> Result<TimedFrame, FrameError> {
        let asked = Instant::now();
        let mut state = self.shared.state();
        loop {
            if let Some((_, frame)) = state.newest.take_if(|(came, _)| *came >= asked + latency) {
                return Ok(frame);
            }
            if let Some(ended) = &state.ended {
                return Err(ended.clone());
            }
            let left = (asked + latency + self.patience).saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Err(FrameError::Io { what: self.address.clone(), why: Message::new("cell-no-frame-in-time") });
            }
            state = self.shared.came.wait_timeout(state, left).unwrap_or_else(PoisonError::into_inner).0;
        }
    }
}

/// Passes a frame of this size on; other sizes are an error.
fn sized(frame: Option<TimedFrame>, [columns, rows]: [usize; 2], what: &str) -> Result<Option<TimedFrame>, FrameError> {
    match frame.as_ref().map(|frame| &frame.image) {
        Some(Image::U8 { width, height, .. } | Image::U16 { width, height, .. })
            if [*width, *height] != [columns, rows] =>
        {
            let size = |width: usize, height: usize| format!("{width} x {height}");
            let why = Message::new("cell-frame-size").text("size", size(*width, *height));
            let why = why.text("allowed", size(columns, rows));
            Err(FrameError::Io { what: what.to_owned(), why })
        }
        _ => Ok(frame),
    }
}

impl Drop for LiveFrames {
    /// The thread ends with the next frame, or when the stream fails.
    fn drop(&mut self) {
        self.shared.closed.store(true, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stream::write_frame;
    use std::net::{TcpListener, TcpStream};

    fn frame(t_s: f64, width: usize) -> TimedFrame {
        let image = Image::U8 { width, height: 4, pixels: vec![100; width * 4] };
        TimedFrame { t_s, image, axes: None, height_mm: None }
    }

    fn camera(patience: Duration) -> (LiveFrames, TcpStream) {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap().to_string();
        let live = LiveFrames::connect(&address, [6, 4], patience).unwrap();
        (live, listener.accept().unwrap().0)
    }

    /// Frames that arrive before the call plus the latency are never taken, however many wait in the connection.
    #[test]
    fn old_frames_do_not_count() {
        let (mut live, mut sends) = camera(Duration::from_secs(20));
        for k in 0..50 {
            write_frame(&frame(f64::from(k), 6), &mut sends).unwrap();
        }
        std::thread::sleep(Duration::from_millis(100));
        let stop = Arc::new(AtomicBool::new(false));
        let stops = Arc::clone(&stop);
        let sender = std::thread::spawn(move || {
            for k in (50..).take_while(|_| !stops.load(Ordering::Relaxed)) {
                std::thread::sleep(Duration::from_millis(10));
                write_frame(&frame(f64::from(k), 6), &mut sends).unwrap();
            }
        });
        let (asked, latency) = (Instant::now(), Duration::from_millis(100));
        let first = live.next(latency).unwrap();
        assert!(first.t_s >= 50.0 && asked.elapsed() >= latency, "{}", first.t_s);
        let second = live.next(Duration::ZERO).unwrap();
        assert!(second.t_s > first.t_s);
        stop.store(true, Ordering::Relaxed);
        sender.join().unwrap();
        // The last one may still come; then the end of the stream is reported.
        let told = std::iter::repeat_with(|| live.next(Duration::ZERO)).find_map(Result::err);
        assert!(told.unwrap().to_string().contains("closed the connection"));
    }

    #[test]
    fn what_is_wrong_is_told() {
        let (mut live, mut sends) = camera(Duration::from_secs(20));
        write_frame(&frame(0.0, 7), &mut sends).unwrap();
        let told = live.next(Duration::ZERO).unwrap_err().to_string();
        assert!(told.contains("7 x 4") && told.contains("6 x 4"), "{told}");
        let (mut live, _silent) = camera(Duration::from_millis(100));
        let told = live.next(Duration::ZERO).unwrap_err().to_string();
        assert!(told.contains("in time"), "{told}");
    }
}
