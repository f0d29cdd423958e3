//! The moving mass with viscous drag, Coulomb friction and standstill.

/// A load under a constant push, friction included, advanced in closed form.
///
/// All forces are divided by the inertia, so they are accelerations (u/s^2). While it moves,
/// `dv/dt = push - coulomb * sign(v) - viscous * v`. At rest it stays at rest as long as
/// `|push| <= coulomb`: static friction equals Coulomb friction, there is no Stribeck drop.
///
/// Guarantee: for a push that is constant over a call the result is exact up to rounding,
/// including the instant of stopping inside the call. After a stop the load either stays or
/// leaves in the direction of the push, so friction cannot make it chatter about zero speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// True position (u).
    pub position: f64,
    /// True speed (u/s).
    pub velocity: f64,
    coulomb: f64,
    viscous: f64,
}

/// Response of a [`Load`] to a push.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Mobility {
    /// 1 if the load moves, 0 if friction holds it.
    pub(crate) part: f64,
    /// Friction (u/s^2), with the sign of the speed.
    pub(crate) drag: f64,
}

impl Load {
    /// Creates a load at rest at 0 with Coulomb friction `coulomb` (u/s^2) and viscous rate `viscous` (1/s).
    ///
    /// A negative value or NaN counts as no friction.
    pub fn new(coulomb: f64, viscous: f64) -> Self {
        Self { position: 0.0, velocity: 0.0, coulomb: coulomb.max(0.0), viscous: viscous.max(0.0) }
    }

    /// Applies `push` (u/s^2) for `duration` (s).
    pub fn advance(&mut self, push: f64, duration: f64) {
        let mut left = duration;
        if self.velocity != 0.0 {
            let direction = self.velocity.signum();
            let net = push - direction * self.coulomb - self.viscous * self.velocity;
            match self.time_to_stop(net) {
                Some(stop) if stop <= left => {
                    self.position += self.velocity * stop + net * self.travel(stop);
                    self.velocity = 0.0;
                    left -= stop;
                }
                _ => {
                    self.position += self.velocity * left + net * self.travel(left);
                    self.velocity += net * self.gain(left);
                    return;
                }
            }
        }
        if push.abs() > self.coulomb {
            let net = push - push.signum() * self.coulomb;
            self.position += net * self.travel(left);
            self.velocity = net * self.gain(left);
        }
    }

    /// Returns the response to a push: `part * push - drag` (u/s^2). It is zero while friction holds the load, also for
    /// a push above the friction.
    pub(crate) fn mobility(&self) -> Mobility {
        if self.velocity == 0.0 {
            return Mobility { part: if self.coulomb > 0.0 { 0.0 } else { 1.0 }, drag: 0.0 };
        }
        Mobility { part: 1.0, drag: self.velocity.signum() * self.coulomb + self.viscous * self.velocity }
    }

    /// Returns the time until the speed is zero, from the present acceleration `net`; `None` if the load does not stop.
    fn time_to_stop(&self, net: f64) -> Option<f64> {
        if net * self.velocity >= 0.0 {
            return None;
        }
        let undamped = -self.velocity / net;
        let damped = self.viscous * undamped;
        if self.viscous == 0.0 {
            Some(undamped)
        } else if damped < 1.0 {
            Some(-(-damped).ln_1p() / self.viscous)
        } else {
            None
        }
    }

    /// Returns the speed gained per unit of acceleration after `t`: `(1 - exp(-c t)) / c`, or `t` without drag.
    fn gain(&self, t: f64) -> f64 {
        if self.viscous == 0.0 { t } else { -(-self.viscous * t).exp_m1() / self.viscous }
    }

    /// Returns the distance gained per unit of acceleration after `t`: the integral of [`Load::gain`].
    fn travel(&self, t: f64) -> f64 {
        let x = self.viscous * t;
        if x < 0.02 {
            // The closed form below cancels for small x; the first omitted term is 2e-15.
            let series = 0.5 - x / 6.0 * (1.0 - x / 4.0 * (1.0 - x / 5.0 * (1.0 - x / 6.0 * (1.0 - x / 7.0))));
            t * t * series
        } else {
            (t - self.gain(t)) / self.viscous
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moving(coulomb: f64, viscous: f64, velocity: f64) -> Load {
        Load { velocity, ..Load::new(coulomb, viscous) }
    }

    #[test]
    fn coasts_down_under_viscous_drag_as_an_exponential() {
        for viscous in [0.001, 0.3, 4.0, 60.0] {
            let mut load = moving(0.0, viscous, 80.0);
            for i in 1..=1000 {
                load.advance(0.0, 1e-3);
                let t = f64::from(i) * 1e-3;
                assert!((load.velocity - 80.0 * (-viscous * t).exp()).abs() < 1e-10);
                let way = -80.0 * (-viscous * t).exp_m1() / viscous;
                assert!((load.position - way).abs() < 1e-9, "{viscous} {t}");
            }
        }
    }

    #[test]
    fn coasts_down_under_coulomb_friction_in_v_squared_over_two_a() {
        for velocity in [37.0_f64, -37.0] {
            let mut load = moving(250.0, 0.0, velocity);
            for _ in 0..400 {
                load.advance(0.0, 1.3e-3);
            }
            assert!((load.position - velocity.signum() * 37.0 * 37.0 / 500.0).abs() < 1e-12);
            assert!(load.velocity == 0.0);
        }
    }

    #[test]
    fn coasts_down_under_both() {
        // t_stop = ln(1 + c v / F) / c, way = (v - F t_stop) / c.
        let (f, c, v) = (250.0_f64, 6.0_f64, 90.0_f64);
        let mut load = moving(f, c, v);
        for _ in 0..1000 {
            load.advance(0.0, 1e-3);
        }
        let stop = (c * v / f).ln_1p() / c;
        assert!((load.position - (v - f * stop) / c).abs() < 1e-11);
        assert!(load.velocity == 0.0);
    }

    #[test]
    fn stays_stopped_up_to_the_coulomb_level_and_leaves_beyond() {
        let mut load = Load::new(100.0, 2.0);
        for push in [100.0, -100.0, 99.9, 0.0, -50.0] {
            load.advance(push, 0.01);
            assert!(load == Load::new(100.0, 2.0));
        }
        load.advance(-101.0, 0.01);
        assert!(load.velocity < 0.0 && load.position < 0.0);
    }

    #[test]
    fn one_long_call_equals_many_short_ones_through_stop_and_reversal() {
        let mut long = moving(50.0, 3.0, 20.0);
        let mut short = long;
        long.advance(-300.0, 0.2);
        for _ in 0..200 {
            short.advance(-300.0, 1e-3);
        }
        assert!((long.position - short.position).abs() < 1e-12);
        assert!((long.velocity - short.velocity).abs() < 1e-11);
        assert!(long.velocity < 0.0);
    }

    #[test]
    fn the_series_meets_the_closed_form() {
        let load = Load::new(0.0, 1.0);
        let (below, above) = (load.travel(0.02 - 1e-12), load.travel(0.02));
        assert!((above - below).abs() < 1e-13 + 0.021 * 1e-12);
    }
}
