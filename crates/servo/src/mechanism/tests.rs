use super::*;

const FREE: Friction = Friction { coulomb: 0.0, viscous: 0.0 };
const STIFF: Transmission = Transmission {
    resonance_hz: 40.0,
    damping: 0.02,
    load_ratio: 3.0,
    backlash: 0.0,
    motor_friction: 0.0,
    encoder_on: EncoderSide::Motor,
};

fn wound(m: &Mechanism) -> f64 {
    m.motor().position - m.load().position
}

/// The mechanism released with motor and load 0.01 u apart, the centre of mass at 0.
fn let_go(t: Transmission) -> Mechanism {
    let mut m = Mechanism::new(FREE, Some(t));
    let far = m.far.as_mut().unwrap();
    m.motor.position = 0.01 * far.load_part;
    far.load.position = -0.01 * far.motor_part;
    m
}

fn energy(m: &Mechanism) -> f64 {
    let far = m.far.unwrap();
    let z = wound(m);
    let pressed = z - z.clamp(-far.half_gap, far.half_gap);
    let moving = far.motor_part * m.motor.velocity.powi(2) + far.load_part * far.load.velocity.powi(2);
    0.5 * (moving + far.stiffness * pressed * pressed)
}

#[test]
fn free_swing_has_the_analytic_frequency_and_decay() {
    for load_ratio in [0.2, 1.0, 10.0] {
        for damping in [0.0, 0.005, 0.1] {
            let t = Transmission { load_ratio, damping, ..STIFF };
            let w = TAU * t.resonance_hz;
            let swing = w * (1.0 - damping * damping).sqrt();
            let mut m = let_go(t);
            let h = 1e-6;
            for k in 1..=100_000 {
                m.advance(0.0, 0.0, h);
                let time = h * f64::from(k);
                let decay = (-damping * w * time).exp();
                let sine = damping / (1.0 - damping * damping).sqrt() * (swing * time).sin();
                let exact = 0.01 * decay * ((swing * time).cos() + sine);
                assert!((wound(&m) - exact).abs() < 1e-7, "{load_ratio} {damping} {time}: {} {exact}", wound(&m));
            }
            // Without an outside force the centre of mass stays.
            let far = m.far.unwrap();
            let centre = far.motor_part * m.motor.position + far.load_part * far.load.position;
            assert!(centre.abs() < 1e-12);
        }
    }
}

#[test]
fn with_the_motor_held_the_load_swings_at_the_antiresonance() {
    let t = Transmission { load_ratio: 4.0, damping: 0.0, ..STIFF };
    // All friction at the motor, above the maximum force of the spring.
    let mut m =
        Mechanism::new(Friction { coulomb: 1e6, viscous: 0.0 }, Some(Transmission { motor_friction: 1.0, ..t }));
    m.far.as_mut().unwrap().load.position = 0.01;
    let w = TAU * 40.0 / 5.0_f64.sqrt();
    let h = 2e-6;
    for k in 1..=50_000 {
        m.advance(0.0, 0.0, h);
        assert!(m.motor().position == 0.0);
        assert!((m.load().position - 0.01 * (w * h * f64::from(k)).cos()).abs() < 1e-7);
    }
}

#[test]
fn halving_the_step_quarters_the_error() {
    let run = |steps: u32| {
        let mut m = Mechanism::new(FREE, Some(STIFF));
        for _ in 0..steps {
            m.advance(500.0, -100.0, 0.05 / f64::from(steps));
        }
        [m.motor().position, m.load().position, m.motor().velocity, m.load().velocity]
    };
    let exact = run(1 << 18);
    for steps in [256, 512, 1024] {
        let error = |n: u32| run(n).iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let ratio = error(steps) / error(2 * steps);
        assert!((3.6..4.4).contains(&ratio), "{steps}: {ratio}");
    }
    // The reference is also that of the rigid body plus the oscillation: the centre of mass falls under 400 u/s^2.
    let centre = 0.25 * exact[0] + 0.75 * exact[1];
    assert!((centre - 0.5 * 400.0 * 0.05 * 0.05).abs() < 1e-9);
}

#[test]
fn energy_neither_grows_nor_is_lost_without_damping() {
    for backlash in [0.0, 0.004] {
        let t = Transmission { damping: 0.0, backlash, ..STIFF };
        let mut m = let_go(t);
        let begin = energy(&m);
        // The longest step of a drive.
        let h = 0.1 / (TAU * t.resonance_hz);
        let (mut low, mut high) = (f64::MAX, 0.0_f64);
        for k in 0..400_000 {
            m.advance(0.0, 0.0, h);
            if k >= 399_000 {
                (low, high) = (low.min(energy(&m)), high.max(energy(&m)));
            }
        }
        let bound = if backlash == 0.0 { 0.01 } else { 0.1 };
        assert!(
            low > begin * (1.0 - bound) && high < begin * (1.0 + bound),
            "{backlash}: {} {}",
            low / begin,
            high / begin
        );
    }
}

#[test]
fn the_gap_is_as_wide_as_asked_and_carries_no_force() {
    let t = Transmission { backlash: 0.02, damping: 0.1, ..STIFF };
    // Friction on the load only: pushed slowly either way, the motor leads by half the gap and the wind-up.
    let friction = Friction { coulomb: 200.0, viscous: 50.0 };
    let mut m = Mechanism::new(friction, Some(t));
    let mut ends = [0.0; 2];
    for (end, push) in ends.iter_mut().zip([260.0, -260.0]) {
        for _ in 0..200_000 {
            m.advance(push, 0.0, 1e-5);
        }
        // Both at the steady speed (260 - 200) / 50: friction of the load balances the whole push.
        assert!((m.load().velocity - push.signum() * 1.2).abs() < 1e-9);
        *end = wound(&m);
    }
    let w = TAU * 40.0;
    let wind_up = 260.0 / (w * w * 0.25 * 0.75);
    assert!((ends[0] - 0.01 - wind_up).abs() < 1e-9 && (ends[1] + 0.01 + wind_up).abs() < 1e-9, "{ends:?}");
    // In the gap the motor moves alone.
    let mut m = Mechanism::new(FREE, Some(t));
    m.advance(100.0, 0.0, 5e-3);
    assert!((m.motor().position - 0.5 * 400.0 * 25e-6).abs() < 1e-12 && m.load().position == 0.0);
}

#[test]
fn a_load_held_by_friction_stays_while_the_motor_winds_up() {
    let mut m = Mechanism::new(Friction { coulomb: 100.0, viscous: 0.0 }, Some(Transmission { damping: 0.3, ..STIFF }));
    // A slow push: 99 u/s^2 at the end, still within the load's friction.
    for k in 0..150_000 {
        m.advance(99.0 * (f64::from(k) / 1e5).min(1.0), 0.0, 1e-5);
        assert!(m.load().position == 0.0);
    }
    let w = TAU * 40.0;
    assert!((m.motor().position - 99.0 / (w * w * 0.25 * 0.75)).abs() < 1e-9);
}

#[test]
fn settled_against_a_force_it_stays_at_rest() {
    for encoder_on in [EncoderSide::Motor, EncoderSide::Load] {
        for hold in [0.0, 80.0, -35.0] {
            let mut m = Mechanism::new(FREE, Some(Transmission { backlash: 0.01, encoder_on, ..STIFF }));
            m.settle_at(2.5, hold);
            let before = m;
            for _ in 0..1000 {
                m.advance(hold, -hold, 1e-4);
            }
            assert!((m.measured().position - 2.5).abs() < 1e-12);
            assert!((m.load().position - before.load().position).abs() < 1e-12 && m.load().velocity.abs() < 1e-9);
        }
    }
}

#[test]
fn a_stiff_transmission_moves_as_one_mass() {
    let friction = Friction { coulomb: 50.0, viscous: 3.0 };
    let mut one = Mechanism::new(friction, None);
    let mut two = Mechanism::new(friction, Some(Transmission { resonance_hz: 2000.0, damping: 0.5, ..STIFF }));
    for _ in 0..20_000 {
        one.advance(400.0, -100.0, 2e-6);
        two.advance(400.0, -100.0, 2e-6);
    }
    let (position, velocity) = (two.load().position / one.load().position, two.load().velocity / one.load().velocity);
    // At 40 ms, 80 oscillations: the remaining difference is the wind-up and the time until the load broke away.
    assert!((position - 1.0).abs() < 1e-3 && (velocity - 1.0).abs() < 1e-3, "{position} {velocity}");
}
