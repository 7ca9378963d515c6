//! How two boxes in any direction overlap, by floats: for 64-bit processors.

use super::across::normal;
use super::box_pair::BoxPair;
use super::float_margins::{self, FloatMargins, SHORT};
use super::nearness::Unsure;
use super::two_floats::TwoFloats as Two;
use crate::num::{Axis, Raw};
use crate::query::contact::Contact;
use crate::shape::Convex;

/// The contact of two sharp boxes.
///
/// [`Unsure`] for other shapes, and for a box without area. Also for boxes so large that floats are
/// not exact, and if two sides are equally near, or nearly so.
#[inline(always)]
#[expect(clippy::float_arithmetic, reason = "exact for short vectors")]
pub(super) fn contact(a: &impl Convex, b: &impl Convex) -> Result<Option<Contact>, Unsure> {
    let pair = BoxPair::of(a, b).ok_or(Unsure)?;
    let sides = pair.sides();
    let margins = FloatMargins::of(sides);
    let least = margins.least();
    if least < -float_margins::OFF {
        return Ok(None);
    }
    let [u, v, s, t, way] = sides.map(Two::of);
    let lengths = [Two([u.dot(u), v.dot(v)]), Two([s.dot(s), t.dot(t)])];
    let Two([p, q]) = lengths[0].add(lengths[1]);
    if margins.areas.least() <= 0.0 || !float_margins::are_short(p + q + way.dot(way)) {
        return Err(Unsure);
    }
    if least <= 0.0 {
        return Ok(None);
    }
    across(&pair, &nearest(&margins, lengths)?).map(Some)
}

/// The side that is nearest to apart.
struct NearestSide {
    of_a: bool,
    /// Whether it is the first of the box's two.
    is_first: bool,
    margin: f64,
}

/// The side across which the boxes have least in common, with its length divided out.
#[inline(always)]
#[expect(clippy::float_arithmetic, reason = "an error where the rounding could matter")]
fn nearest(margins: &FloatMargins, lengths: [Two; 2]) -> Result<NearestSide, Unsure> {
    let squares = |m: Two, len2: Two| m.times(m).over(len2);
    let [own, others] = margins.areas.0.map(Two::both);
    let (of_both, [p, q]) = ([margins.of_a.add(own), margins.of_b.add(others)], lengths);
    let (a, b) = (squares(of_both[0], p), squares(of_both[1], q));
    let of_a = a.least() < b.least();
    let (Two([first, second]), others, Two(both)) =
        if of_a { (a, b.least(), of_both[0]) } else { (b, a.least(), of_both[1]) };
    let is_first = first < second;
    let (least, next) = if is_first { (first, second) } else { (second, first) };
    if least < next * SHORT && least < others * SHORT {
        Ok(NearestSide { of_a, is_first, margin: if is_first { both[0] } else { both[1] } })
    } else {
        Err(Unsure)
    }
}

/// The contact across a side that is not parallel to another one.
#[inline(always)]
#[expect(clippy::float_arithmetic, reason = "exact for short vectors")]
fn across(pair: &BoxPair, nearest: &NearestSide) -> Result<Contact, Unsure> {
    let ([u, v, p], [s, t, q]) = (pair.a, pair.b);
    let ([e, f], [s, t, at]) = if nearest.of_a { ([u, v], [s, t, q]) } else { ([s, t], [u, v, p]) };
    let e = if nearest.is_first { e } else { f };
    let toward = e.cross(q.sub(p));
    if toward == 0 {
        return Err(Unsure);
    }
    // With B on its right.
    let e = if toward < 0 { e } else { e.reversed() };
    // The deepest corner of B is the one most on the left, and of A the one most on the right.
    let plus = |side: Raw| (e.cross(side) > 0) == nearest.of_a;
    let toward = |at: Raw, side: Raw| if plus(side) { at.add(side) } else { at.sub(side) };
    let corner = toward(toward(at, s), t);
    let (e, corner) = if pair.is_half { (e.add(e), corner) } else { (e, Raw { x: corner.x >> 1, y: corner.y >> 1 }) };
    // A margin is the height of the side of the sum times its length: half of it for half sides.
    let height = nearest.margin * if pair.is_half { 2.0 } else { 0.5 };
    let (axis, overlap) = if e.y == 0 {
        (Axis::new(0, e.x.signum().wrapping_neg()), height / f64::from(e.x).abs())
    } else if e.x == 0 {
        (Axis::new(e.y.signum(), 0), height / f64::from(e.y).abs())
    } else {
        let n = normal(e);
        (Axis::new(n.x, n.y), height)
    };
    let contact = Contact::new(axis, overlap as i64, corner);
    Ok(if nearest.of_a { contact.on_b() } else { contact })
}
