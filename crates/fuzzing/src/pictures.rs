//! Pictures and frames of cameras, and the search in them.

use crate::corpora::files;
use crate::scratch::{folder, write};
use crate::target::{Target, USUAL};
use crate::texts::{describe, with_text};
use seamwright_frames::{
    FrameSource, FrameStream, HEADER_BYTES, LIST, MAX_FRAME_AXES, Recorded, TimedFrame, decode, write_frame,
};
use seamwright_vision::camera::{Grid, identify};
use seamwright_vision::stripe::{JointKind, StripeReader, StripeTask};
use seamwright_vision::{Frame, Image, Pixels};

const PICTURE: Target = Target {
    is_text: false,
    max_length: 4096,
    // A small file can decode to a picture of 512 MiB, which is then converted.
    max_memory: 2 << 30,
    ..USUAL
};

/// PNG files; checksums of chunks are set first.
pub const PNG: Target = Target {
    name: "png",
    read: |bytes| decoded(&with_checksums(bytes)),
    seeds: png_seeds,
    words: png_words,
    ..PICTURE
};

/// JPEG files.
pub const JPEG: Target = Target {
    name: "jpeg",
    read: decoded,
    seeds: || files("crates/fuzzing/seeds", "jpg"),
    words: jpeg_words,
    ..PICTURE
};

/// PNM files.
pub const PNM: Target = Target { name: "pnm", read: decoded, seeds: pnm_seeds, words: pnm_words, ..PICTURE };

/// Frames from a connection.
pub const FRAME_STREAM: Target =
    Target { name: "frame_stream", read: frame_stream, seeds: stream_seeds, max_memory: 64 << 20, ..PICTURE };

/// Lists of recorded frames.
pub const FRAME_LIST: Target = Target {
    name: "frame_list",
    read: |bytes| with_text(bytes, frame_list),
    seeds: || vec![b"file,t_s,x,w,height_mm\n000000.png,0.1,10.5,-45,1\n000001.png,0.2,11,-45,\n".to_vec()],
    words: || ["file", "t_s", "height_mm", ",", "\n", "../", "nan"].map(str::to_owned).to_vec(),
    ..USUAL
};

/// Search for joints, stripes and grids of dots in a small picture. The first two bytes are its sides.
pub const PICTURE_SEARCH: Target = Target {
    name: "picture_search",
    read: search,
    seeds: search_seeds,
    is_text: false,
    max_length: 2 + MAX_SEARCHED * MAX_SEARCHED,
    cases: 60,
    ..USUAL
};

/// Maximum side of a picture that is searched, pixels.
const MAX_SEARCHED: usize = 80;

fn decoded(bytes: &[u8]) {
    match decode(bytes) {
        Ok(image) => drop(image.frame().unwrap_or_else(|e| panic!("an invalid picture: {e:?}"))),
        Err(error) => describe::<(), _>(Err(error)),
    }
}

/// The same PNG with the checksum of every chunk set.
fn with_checksums(bytes: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let mut at = 8;
    while let Some(&[a, b, c, d]) = bytes.get(at..at + 4) {
        let from = at + 4;
        let to = from + 4 + u32::from_be_bytes([a, b, c, d]) as usize;
        let Some(chunk) = bytes.get(from..to) else { break };
        let checksum = crc32fast::hash(chunk).to_be_bytes();
        let Some(place) = bytes.get_mut(to..to + 4) else { break };
        place.copy_from_slice(&checksum);
        at = to + 4;
    }
    bytes
}

fn png_seeds() -> Vec<Vec<u8>> {
    use png::{BitDepth, ColorType};
    let kinds = [
        (ColorType::Grayscale, BitDepth::One, 1),
        (ColorType::Grayscale, BitDepth::Eight, 6),
        (ColorType::GrayscaleAlpha, BitDepth::Sixteen, 24),
        (ColorType::Indexed, BitDepth::Four, 3),
        (ColorType::Rgb, BitDepth::Sixteen, 36),
        (ColorType::Rgba, BitDepth::Eight, 24),
    ];
    let encoded = |(colour, depth, row): (ColorType, BitDepth, usize)| {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 6, 4);
        encoder.set_color(colour);
        encoder.set_depth(depth);
        if colour == ColorType::Indexed {
            encoder.set_palette((0..48u8).collect::<Vec<_>>());
            encoder.set_trns((0..16u8).collect::<Vec<_>>());
        }
        let values: Vec<u8> = (0..4 * row).map(|i| (i * 37) as u8).collect();
        let written = encoder.write_header().and_then(|mut png| {
            png.write_image_data(&values)?;
            png.finish()
        });
        written.unwrap_or_else(|e| panic!("{e}"));
        bytes
    };
    kinds.into_iter().map(encoded).collect()
}

fn png_words() -> Vec<String> {
    [
        "IHDR", "PLTE", "IDAT", "IEND", "tRNS", "gAMA", "sRGB", "acTL", "fcTL", "fdAT", "iCCP", "zTXt", "iTXt", "tEXt",
        "pHYs", "eXIf",
    ]
    .map(str::to_owned)
    .to_vec()
}

/// Markers; the dictionary writes characters below U+0100 as bytes.
fn jpeg_words() -> Vec<String> {
    (0xc0..=0xfeu8).map(|marker| format!("\u{ff}{}", char::from(marker))).collect()
}

fn pnm_seeds() -> Vec<Vec<u8>> {
    let texts = [
        "P1 3 2 1 0 1 0 1 0\n",
        "P2\n# grey\n3 2\n255\n1 2 3 4 5 255\n",
        "P3 1 2 65535 1 2 3 4 5 65535\n",
        "P4 9 1\n\u{7f}a",
        "P5 3 2 255\nabcdef",
        "P6 1 2 65535\nabcdefghijkl",
        "P7\nWIDTH 2\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\nabcdefgh",
    ];
    texts.map(|text| text.as_bytes().to_vec()).to_vec()
}

fn pnm_words() -> Vec<String> {
    ["WIDTH ", "HEIGHT ", "DEPTH ", "MAXVAL ", "TUPLTYPE ", "ENDHDR\n", "65535", "16384", "#", "P7\n"]
        .map(str::to_owned)
        .to_vec()
}

fn frame_stream(bytes: &[u8]) {
    let mut source = FrameStream::new(bytes, "fuzz".to_owned());
    let mut frames = 0;
    loop {
        match source.next() {
            Ok(Some(frame)) => {
                frame.image.frame().unwrap_or_else(|e| panic!("an invalid picture: {e:?}"));
                assert!(frame.axes.iter().flatten().all(|v| v.is_finite()));
                frames += 1;
            }
            Ok(None) => break,
            Err(error) => {
                describe::<(), _>(Err(error));
                assert!(matches!(source.next(), Ok(None)), "frames after an error");
                break;
            }
        }
    }
    assert!(frames * HEADER_BYTES <= bytes.len(), "frames from nothing");
}

fn stream_seeds() -> Vec<Vec<u8>> {
    let eight = Image::U8 { width: 3, height: 2, pixels: vec![7; 6] };
    let sixteen = Image::U16 { width: 2, height: 1, pixels: vec![500; 2] };
    let axes = vec![1.5; usize::from(MAX_FRAME_AXES)];
    let frames = [
        TimedFrame { t_s: 0.1, image: eight, axes: Some(vec![10.0, -45.0]), height_mm: Some(2.0) },
        TimedFrame { t_s: 0.2, image: sixteen, axes: Some(axes), height_mm: None },
    ];
    let write = |frames: &[TimedFrame]| {
        let mut bytes = Vec::new();
        frames.iter().for_each(|f| write_frame(f, &mut bytes).unwrap_or_else(|e| panic!("{e}")));
        bytes
    };
    vec![write(&frames[..1]), write(&frames)]
}

fn frame_list(text: &str) {
    let folder = folder("frames");
    write(&folder.join(LIST), text.as_bytes());
    match Recorded::open(&folder, &["x", "w"]) {
        // There are no pictures.
        Ok(mut frames) => assert!(!frames.is_empty() && frames.next().is_err()),
        Err(error) => describe::<(), _>(Err(error)),
    }
}

fn search(bytes: &[u8]) {
    let &[width, height, ref pixels @ ..] = bytes else { return };
    let [width, height] = [width, height].map(|side| usize::from(side).clamp(1, MAX_SEARCHED));
    let mut filled = pixels.to_vec();
    filled.resize(width * height, 0);
    let frame = Frame::new(width, height, Pixels::U8(&filled)).unwrap_or_else(|e| panic!("{e:?}"));
    let mut reader = StripeReader::new();
    for kind in JointKind::ALL {
        if let Ok(features) = reader.read_image(&frame, None, &StripeTask::in_pixels(kind)) {
            assert!(features.points.iter().all(|(_, point)| point.is_finite()), "{features:?}");
        }
    }
    if let Ok(found) = identify(&frame, &Grid { pitch_mm: 3.0, centre_px: None, limit_px: 0.5 }) {
        assert!(found.rms_px.is_finite(), "{found:?}");
    }
}

/// Dark pictures with a bright line with a step, and with a grid of dots.
fn search_seeds() -> Vec<Vec<u8>> {
    let side = 64usize;
    let painted = |value: &dyn Fn(usize, usize) -> u8| {
        let mut bytes = vec![side as u8; 2];
        bytes.extend((0..side * side).map(|i| value(i % side, i / side)));
        bytes
    };
    let line = |x: usize, y: usize| {
        let at = if x < side / 2 { 20 + x / 2 } else { 52 - x / 2 };
        [220, 120, 10][at.abs_diff(y).min(2)]
    };
    let dots = |x: usize, y: usize| if (x % 9).abs_diff(4) + (y % 9).abs_diff(4) < 3 { 20 } else { 200 };
    vec![painted(&line), painted(&dots)]
}
