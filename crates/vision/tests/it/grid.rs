//! Maps identified from rendered pictures of grids, compared with the maps they were rendered with.

use glam::DVec2;
use seamwright_testkit::{Random, cases};
use seamwright_vision::camera::{Grid, GridError, MapParameters, PlaneMap, identify};
use seamwright_vision::{Frame, Pixels};

const SIZE: (usize, usize) = (480, 400);

/// A plate with dark dots every `pitch` mm, whose grid has its origin at `origin`.
struct Plate {
    map: PlaneMap,
    pitch: f64,
    radius: f64,
    origin: DVec2,
    noise: f64,
    ramp: f64,
}

impl Plate {
    fn picture(&self, random: &mut Random) -> Vec<u8> {
        let mut pixels = Vec::with_capacity(SIZE.0 * SIZE.1);
        for y in 0..SIZE.1 {
            for x in 0..SIZE.0 {
                let mut covered = 0.0;
                for k in 0..16 {
                    let part = DVec2::new(f64::from(k % 4), f64::from(k / 4)) / 4.0 - 0.375;
                    let mm = self.map.to_mm(DVec2::new(x as f64, y as f64) + part).unwrap() - self.origin;
                    let off = mm - self.pitch * (mm / self.pitch).round();
                    covered += f64::from(u8::from(off.length() < self.radius)) / 16.0;
                }
                let light = 170.0 + self.ramp * (x as f64 / SIZE.0 as f64 - 0.5);
                pixels.push((light * (1.0 - 0.6 * covered) + self.noise * random.normal()).clamp(0.0, 255.0) as u8);
            }
        }
        pixels
    }
}

fn plate(random: &mut Random) -> Plate {
    let scale = 0.05 * 10f64.powf(random.within(0.0, 1.0));
    let map = PlaneMap::new(MapParameters {
        size_px: SIZE,
        centre_px: DVec2::new(random.within(200.0, 280.0), random.within(160.0, 240.0)),
        mm_per_px: DVec2::new(scale, scale * random.within(0.9, 1.1)),
        rotation: random.within(-0.6, 0.6),
        shear: random.within(-0.08, 0.08),
        barrel: random.within(-0.05, 0.05),
    })
    .unwrap();
    let pitch = scale * random.within(28.0, 45.0);
    let origin = DVec2::new(random.within(0.0, pitch), random.within(0.0, pitch));
    Plate { map, pitch, radius: 0.22 * pitch, origin, noise: random.within(0.0, 6.0), ramp: random.within(-80.0, 80.0) }
}

#[test]
fn rendered_grids_give_their_maps_back() {
    let mut worst: f64 = 0.0;
    for seed in 0..cases(12) {
        let mut random = Random::of_case(seed);
        let plate = plate(&mut random);
        let pixels = plate.picture(&mut random);
        let frame = Frame::new(SIZE.0, SIZE.1, Pixels::U8(&pixels)).unwrap();
        let truth = plate.map.parameters();
        let grid = Grid { pitch_mm: plate.pitch, centre_px: Some(truth.centre_px), limit_px: 0.3 };
        let found = identify(&frame, &grid).unwrap_or_else(|e| panic!("seed {seed}: {e}"));
        assert!(found.dots.len() >= 50 && found.rms_px < 0.15 && found.max_px < 0.6, "seed {seed}: {found:?}");
        // The dots' own offsets agree with the maximum.
        let most = found.dots.iter().map(|dot| dot.off_px.length()).fold(0.0, f64::max);
        assert!((most - found.max_px).abs() < 1e-9, "seed {seed}");
        for dot in &found.dots {
            let mm = plate.map.to_mm(dot.px).unwrap() - plate.origin;
            let off = mm - plate.pitch * (mm / plate.pitch).round();
            assert!(off.length() < 0.6 * truth.mm_per_px.x, "seed {seed}: {dot:?} is no dot");
        }
        // Error of the position on the plate, in pixels.
        for corner in [DVec2::ZERO, DVec2::new(479.0, 0.0), DVec2::new(100.0, 300.0), DVec2::new(479.0, 399.0)] {
            let off = (found.map.to_mm(corner).unwrap() - plate.map.to_mm(corner).unwrap()).length();
            worst = worst.max(off / truth.mm_per_px.x);
        }
    }
    assert!(worst < 0.25, "{worst} px");
    println!("worst place: {worst:.3} px");
}

#[test]
fn pictures_of_no_grid_are_refused() {
    let mut random = Random::new(7);
    let grid = Grid { pitch_mm: 2.0, centre_px: None, limit_px: 0.3 };
    let refused =
        |pixels: &[u8]| identify(&Frame::new(SIZE.0, SIZE.1, Pixels::U8(pixels)).unwrap(), &grid).unwrap_err();
    let count = SIZE.0 * SIZE.1;
    assert!(matches!(refused(&vec![128; count]), GridError::Plain(_)));
    assert!(matches!(refused(&vec![0; count]), GridError::Plain(_)));
    let noisy: Vec<u8> = (0..count).map(|_| (120.0 + 8.0 * random.normal()) as u8).collect();
    refused(&noisy);
    let wild: Vec<u8> = (0..count).map(|_| random.within(0.0, 255.9) as u8).collect();
    refused(&wild);
    // Randomly placed dots.
    let mut dots = vec![200u8; count];
    for _ in 0..150 {
        let at = DVec2::new(random.within(8.0, 471.0), random.within(8.0, 391.0));
        for y in 0..SIZE.1 {
            for x in 0..SIZE.0 {
                if at.distance(DVec2::new(x as f64, y as f64)) < 5.0 {
                    dots[y * SIZE.0 + x] = 60;
                }
            }
        }
    }
    refused(&dots);
    // A grid in a corner only, and one bent more than any lens does.
    let mut plate = plate(&mut random);
    (plate.noise, plate.ramp) = (1.0, 0.0);
    let mut corner = plate.picture(&mut random);
    for (i, v) in corner.iter_mut().enumerate() {
        if i % SIZE.0 > 180 {
            *v = 170;
        }
    }
    assert!(matches!(refused(&corner), GridError::Corner(_) | GridError::Few { .. }), "{}", refused(&corner));
    let straight = plate.picture(&mut random);
    let bent: Vec<u8> = (0..count)
        .map(|i| {
            let (x, y) = (i % SIZE.0, i / SIZE.0);
            let from = y as f64 + 6.0 * (x as f64 / 60.0).sin();
            straight[(from.clamp(0.0, 399.0) as usize) * SIZE.0 + x]
        })
        .collect();
    assert!(matches!(refused(&bent), GridError::Residual { .. } | GridError::Tangled { .. }), "{}", refused(&bent));
    let frame = Frame::new(SIZE.0, SIZE.1, Pixels::U8(&straight)).unwrap();
    assert!(matches!(identify(&frame, &Grid { pitch_mm: f64::NAN, ..grid }), Err(GridError::Pitch(_))));
}
