//! Conformance of every source of frames, and its refusals.

use seamwright_frames::{
    Field, FrameError, FrameSource, FrameStream, HEADER_BYTES, LIST, Recorded, Recorder, TimedFrame, decode,
    decode_up_to, write_frame,
};
use seamwright_vision::Image;
use std::io::Write;
use std::net::TcpListener;
use std::path::Path;
use std::time::Duration;

const AXES: [&str; 2] = ["x", "w"];

fn frames() -> Vec<TimedFrame> {
    (0..4u16)
        .map(|i| {
            let (width, height) = (7 + usize::from(i), 5);
            let value = |k: usize| (k * 37 + usize::from(i) * 11) % 251;
            let image = if i % 2 == 0 {
                Image::U8 { width, height, pixels: (0..width * height).map(|k| value(k) as u8).collect() }
            } else {
                Image::U16 { width, height, pixels: (0..width * height).map(|k| (257 * value(k)) as u16).collect() }
            };
            TimedFrame {
                t_s: 0.3 * f64::from(i) + 1e-3,
                image,
                axes: Some(vec![10.0 / 3.0 * f64::from(i), -45.5]),
                height_mm: (i != 2).then_some(0.1 * f64::from(i)),
            }
        })
        .collect()
}

/// Checks a source that has `frames`: all of them, in order, to the last bit, then none for good.
fn conforms(source: &mut dyn FrameSource, frames: &[TimedFrame]) {
    for frame in frames {
        assert_eq!(source.next().unwrap().as_ref(), Some(frame));
    }
    for _ in 0..3 {
        assert_eq!(source.next().unwrap(), None);
    }
}

fn record(folder: &Path, frames: &[TimedFrame]) {
    let mut recorder = Recorder::create(folder, &AXES).unwrap();
    frames.iter().for_each(|f| recorder.add(f).unwrap());
    recorder.finish().unwrap();
}

fn stream(frames: &[TimedFrame]) -> Vec<u8> {
    let mut bytes = Vec::new();
    frames.iter().for_each(|f| write_frame(f, &mut bytes).unwrap());
    bytes
}

#[test]
fn a_folder_conforms() {
    let folder = tempfile::tempdir().unwrap();
    record(folder.path(), &frames());
    conforms(&mut Recorded::open(folder.path(), &AXES).unwrap(), &frames());
}

#[test]
fn a_socket_conforms() {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    let sender = std::thread::spawn(move || {
        let (mut socket, _) = listener.accept().unwrap();
        // Sends pieces, as networks do.
        for piece in stream(&frames()).chunks(13) {
            socket.write_all(piece).unwrap();
            socket.flush().unwrap();
        }
    });
    conforms(&mut FrameStream::connect(&address, Duration::from_secs(20)).unwrap(), &frames());
    sender.join().unwrap();
}

#[test]
fn a_socket_that_says_nothing_is_given_up() {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap().to_string();
    let mut source = FrameStream::connect(&address, Duration::from_millis(100)).unwrap();
    let e = source.next().unwrap_err();
    assert!(e.is_environment() && e.to_string().contains("did not come in time"), "{e}");
    assert_eq!(source.next(), Ok(None));
    drop(listener);
    assert!(FrameStream::connect("no-such-host.invalid:1", Duration::from_millis(100)).is_err());
}

fn refused(bytes: &[u8]) -> FrameError {
    let mut source = FrameStream::new(bytes, "test".to_owned());
    for _ in 0..100 {
        match source.next() {
            Ok(Some(_)) => {}
            Ok(None) => panic!("nothing wrong was found"),
            Err(e) => {
                assert_eq!(source.next(), Ok(None));
                return e;
            }
        }
    }
    panic!("no end");
}

#[test]
fn streams_that_are_none_are_refused() {
    let good = stream(&frames());
    // Cuts anywhere but between frames.
    let first = stream(&frames()[..1]).len();
    for cut in [1, HEADER_BYTES - 1, HEADER_BYTES, HEADER_BYTES + 9, first - 1, good.len() - 1] {
        assert!(matches!(refused(&good[..cut]), FrameError::Truncated { .. }), "{cut}");
    }
    let with = |at: usize, bytes: &[u8]| {
        let mut bad = good.clone();
        bad[at..at + bytes.len()].copy_from_slice(bytes);
        match refused(&bad) {
            FrameError::Header { field, frame: 0, .. } => field,
            e => panic!("{e}"),
        }
    };
    assert_eq!(with(0, b"PNG!"), Field::Magic);
    assert_eq!(with(4, &9u16.to_le_bytes()), Field::Version);
    assert_eq!(with(6, &12u16.to_le_bytes()), Field::Depth);
    assert_eq!(with(8, &u32::MAX.to_le_bytes()), Field::Width);
    assert_eq!(with(12, &0u32.to_le_bytes()), Field::Height);
    assert_eq!(with(16, &u16::MAX.to_le_bytes()), Field::Axes);
    assert_eq!(with(18, &[1]), Field::Reserved);
    assert_eq!(with(32, &f64::INFINITY.to_le_bytes()), Field::WorkHeight);
    assert_eq!(with(40, &f64::NAN.to_le_bytes()), Field::Position);
    let mut late = good.clone();
    late[24..32].copy_from_slice(&1e9f64.to_le_bytes());
    assert!(matches!(refused(&late), FrameError::Time { frame: 1, .. }));
    // An absurd picture gets no memory before its data arrive.
    let mut absurd = good[..HEADER_BYTES].to_vec();
    absurd[8..16].copy_from_slice(&[0, 64, 0, 0, 0, 64, 0, 0]);
    assert!(matches!(refused(&absurd), FrameError::Truncated { .. }));
}

#[test]
fn folders_that_are_none_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    // A missing folder or list is a wrong name, not a failure of the environment.
    for missing in [path.to_owned(), path.join("none")] {
        let e = Recorded::open(&missing, &AXES).unwrap_err();
        assert!(!e.is_environment() && e.to_string().contains("allowed: "), "{e}");
    }
    let line = |text: &str| {
        std::fs::write(path.join(LIST), text).unwrap();
        match Recorded::open(path, &AXES).unwrap_err() {
            FrameError::List { line, .. } => line,
            e => panic!("{e}"),
        }
    };
    let head = "file,t_s,x,w,height_mm\n";
    assert_eq!(line(""), 1);
    assert_eq!(line("file,t_s,x\n"), 1);
    assert_eq!(line("file,t_s,x,w,z\n"), 1);
    assert_eq!(line(head), 2);
    assert_eq!(line(&format!("{head}a.png,0,1,2,\nb.png,0,1,2,\n")), 3);
    assert_eq!(line(&format!("{head}a.png,0,1,nan,\n")), 2);
    assert_eq!(line(&format!("{head}a.png,0,1\n")), 2);
    assert_eq!(line(&format!("{head}../a.png,0,1,2,\n")), 2);
    assert_eq!(line(&format!("{head}/etc/a.png,0,1,2,\n")), 2);
    // Images are read in turn.
    record(path, &frames());
    let image = path.join("000001.png");
    let bytes = std::fs::read(&image).unwrap();
    for bad in [&bytes[..bytes.len() / 2], b"hello, this is no picture", b"P5 4000000000 4000000000 255\n", b""] {
        std::fs::write(&image, bad).unwrap();
        let mut source = Recorded::open(path, &AXES).unwrap();
        assert!(source.next().unwrap().is_some());
        assert!(matches!(source.next().unwrap_err(), FrameError::Image { .. }));
        assert_eq!(source.next(), Ok(None));
    }
}

/// A small file of a large picture is refused by its header.
#[test]
fn pictures_are_bounded_before_they_are_decoded() {
    let pgm = b"P5 3 2 255\n\x00\x10\x20\x30\x40\xff";
    assert!(decode_up_to(pgm, 6).is_ok() && decode_up_to(pgm, 5).is_err());
    // 16384 x 16384 pixels of 2 bytes are 512 MiB, and of 4 bytes 1 GiB. Only the first gets as far as its pixels.
    let why = |header: &[u8], max: usize| decode_up_to(header, max).unwrap_err().to_string();
    let all = 16384 * 16384;
    assert_ne!(why(b"P5 16384 16384 255\n\x00", all), why(b"P5 16384 16384 255\n\x00", all - 1));
    for large in [&b"P6 16384 16384 255\n\x00"[..], b"P5 16385 1 255\n\x00"] {
        let told = why(large, usize::MAX);
        assert!(told.contains("16384") || told.contains("16385"), "{told}");
    }
}

#[test]
fn kinds_of_images_are_read() {
    let pgm = b"P5 3 2 255\n\x00\x10\x20\x30\x40\xff";
    assert_eq!(decode(pgm).unwrap(), Image::U8 { width: 3, height: 2, pixels: vec![0, 16, 32, 48, 64, 255] });
    let deep = b"P5 2 1 65535\n\x01\x02\xff\xff";
    assert_eq!(decode(deep).unwrap(), Image::U16 { width: 2, height: 1, pixels: vec![0x0102, 0xffff] });
    // Greater values than 1 are scaled to white; black bits are 1; comments may stand anywhere.
    let few = b"P2\n# grey\n2 1 4\n0 2\n";
    assert_eq!(decode(few).unwrap(), Image::U8 { width: 2, height: 1, pixels: vec![0, 128] });
    for bits in [&b"P1 3 1\n1 0\n1"[..], b"P4 3 1\n\xbf"] {
        assert_eq!(decode(bits).unwrap(), Image::U8 { width: 3, height: 1, pixels: vec![0, 255, 0] });
    }
    let pam = b"P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 65535\nTUPLTYPE RGB_ALPHA\nENDHDR\n\x80\0\x80\0\x80\0\0\0";
    assert_eq!(decode(pam).unwrap(), Image::U16 { width: 1, height: 1, pixels: vec![0x8000] });
    assert!(decode(b"P5 3 2 255\n\x00").is_err());
    // Grey in colour images keeps its value.
    let ppm = b"P6 1 1 255\n\x50\x50\x50";
    assert_eq!(decode(ppm).unwrap(), Image::U8 { width: 1, height: 1, pixels: vec![0x50] });
}
