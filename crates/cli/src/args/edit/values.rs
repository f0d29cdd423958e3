//! Numbers and ranges of the command line.

use glam::DVec3;
use seamwright_document::{Direction, Finite, NonNegative, Point, Positive};
use seamwright_program::Ramp;
use serde::{Serialize as _, Serializer};

fn number<T>(text: &str, new: fn(f64) -> Option<T>, allowed: &str) -> Result<T, String> {
    text.trim().parse().ok().and_then(new).ok_or_else(|| allowed.to_owned())
}

pub(super) fn finite(text: &str) -> Result<Finite, String> {
    number(text, Finite::new, "a finite number")
}

pub(super) fn positive(text: &str) -> Result<Positive, String> {
    number(text, Positive::new, "a finite number greater than 0")
}

pub(super) fn non_negative(text: &str) -> Result<NonNegative, String> {
    number(text, NonNegative::new, "a finite number, 0 or greater")
}

pub(super) fn named(text: &str) -> Result<(String, Finite), String> {
    let (name, value) = text.split_once('=').ok_or("NAME=NUMBER")?;
    Ok((name.trim().to_owned(), finite(value)?))
}

fn vector(text: &str) -> Option<DVec3> {
    let numbers: Vec<f64> = text.split(',').map(|n| n.trim().parse().ok()).collect::<Option<_>>()?;
    <[f64; 3]>::try_from(numbers).ok().map(DVec3::from_array)
}

pub(super) fn place(text: &str) -> Result<Point, String> {
    vector(text).and_then(Point::new).ok_or_else(|| "three finite numbers X,Y,Z".to_owned())
}

pub(super) fn direction(text: &str) -> Result<Direction, String> {
    vector(text).and_then(Direction::new).ok_or_else(|| "three finite numbers X,Y,Z, not all 0".to_owned())
}

pub(super) fn whole_range(text: &str) -> Result<[usize; 2], String> {
    let parse = |n: &str| n.trim().parse().map_err(|_| "two whole numbers FROM,TO".to_owned());
    let (from, to) = text.split_once(',').ok_or("two whole numbers FROM,TO")?;
    Ok([parse(from)?, parse(to)?])
}

pub(super) fn length_range(text: &str) -> Result<[NonNegative; 2], String> {
    let (from, to) = text.split_once(',').ok_or("two lengths FROM,TO in mm")?;
    Ok([non_negative(from)?, non_negative(to)?])
}

pub(super) fn by_name<S: Serializer>(pairs: &[(String, Finite)], out: S) -> Result<S::Ok, S::Error> {
    out.collect_map(pairs.iter().map(|(name, value)| (name, value)))
}

pub(super) fn steady_or_ramp<S: Serializer>(values: &[Finite], out: S) -> Result<S::Ok, S::Error> {
    if let [from, to] = *values { Ramp { from, to }.serialize(out) } else { values.first().serialize(out) }
}
