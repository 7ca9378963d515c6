//! The one or two points that two shapes rest on.

use super::across::over;
use super::exit::Exit;
use super::face::{End, Facing, face, precedes};
use super::walk::{Core, PolygonSide};
use crate::num::{Axis, Raw, cmp_squares, scaled};
use crate::query::contact::Contact;

/// A part of a shape's border, by its index.
///
/// The index stays the same while the shape moves, and while a box turns. A side has the index of
/// the corner at which it begins, counter-clockwise (y up). Corners are counted from these:
///
/// - the `min` of a box, or [`corners`](crate::OrientedBox::corners)`()[0]`;
/// - the lexicographically first end of a segment;
/// - the first vertex of a polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Part {
    /// A corner, or the arc around it.
    Corner(u16),
    /// A side.
    Side(u16),
}

/// One point of a [`Manifold`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ManifoldPoint {
    /// How deep the shapes overlap here, along the axis that all points share.
    pub contact: Contact,
    /// The part of A that meets `part_b` here. Both together identify the point from frame to
    /// frame.
    pub part_a: Part,
    /// The part of B.
    pub part_b: Part,
}

/// How two shapes rest on each other: the shortest way out, and one or two points that share it.
///
/// The axis is that of [`contact`](crate::query::Contacts::contact). Between boxes, circles and
/// segments it may have another length, and be another shortest way out if there are several.
///
/// The first point is the deepest one, and is exact. There is a second one if a side of one shape
/// leans on a side of the other. It is the other end of the part where they face each other. It is
/// within a raw unit of the exact point, and has its own depth, rounded up. If the two sides beside
/// the deepest corner are equally steep, neither leans, and there is one point.
///
/// ```text
///      +-------+
///      |   A   |             two points: the ends of what the sides share
///  +---1-------2------+
///  |         B        |
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("contact manifold", "clipping"))]
pub struct Manifold {
    first: ManifoldPoint,
    second: Option<ManifoldPoint>,
}

impl Manifold {
    /// From A to B, exact and not zero, as [`Contact::axis`].
    #[must_use]
    pub const fn axis(&self) -> Axis {
        self.first.contact.axis()
    }

    /// The one or two points, the deeper one first.
    ///
    /// On a tie, the one with the smaller x comes first, then the one with the smaller y. Depths
    /// are rounded, so that of the second one may be a raw unit more.
    pub fn points(&self) -> impl Iterator<Item = &ManifoldPoint> {
        core::iter::once(&self.first).chain(&self.second)
    }

    /// The deepest point.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, OrientedBox, Vec2, fx, prelude::*};
    /// let floor = Aabb::new(Vec2::from_ints(0, 8), Vec2::from_ints(64, 16))?;
    /// let crate_ = OrientedBox::new(Vec2::from_ints(32, 5), Vec2::from_ints(4, 4), Axis::X)?;
    /// let manifold = crate_.manifold(&floor).unwrap();
    /// assert_eq!((manifold.points().count(), manifold.deepest().contact.depth()), (2, fx!(1)));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn deepest(&self) -> &ManifoldPoint {
        &self.first
    }
}

pub(super) fn manifold(a: Core<'_>, b: Core<'_>) -> Option<Manifold> {
    let exit = Exit::of(a, b)?;
    let Some(side) = exit.side else {
        let (i, j) = exit.corners;
        let first = ManifoldPoint { contact: exit.contact, part_a: corner(i), part_b: corner(j) };
        return Some(Manifold { first, second: None });
    };
    let made = if side.of_a && side.of_b { both } else { one };
    Some(made(&exit.contact, &side, a, b))
}

/// The contact of `contact`'s shapes and axis at another point of a core.
const fn at(contact: &Contact, overlap: i64, core: Raw, on_a: bool) -> Contact {
    let made = Contact::new(contact.axis, overlap, core)
        .with_radii(contact.radius_a, contact.radius_b)
        .with_degenerate(contact.is_degenerate());
    if on_a { made } else { made.on_b() }
}

const fn corner(index: usize) -> Part {
    Part::Corner(index as u16)
}

const fn line(index: usize) -> Part {
    Part::Side(index as u16)
}

/// For two parallel sides: the ends of their common part, equally deep.
fn both(contact: &Contact, side: &PolygonSide, a: Core<'_>, b: Core<'_>) -> Manifold {
    let Facing { ends: (from, to), .. } = Facing::of(side, a, b);
    let point = |end: End, on_a: usize, on_b: usize| ManifoldPoint {
        contact: at(contact, contact.overlap, end.at, end.on_a),
        part_a: if end.on_a || end.paired { corner(on_a) } else { line(side.a) },
        part_b: if !end.on_a || end.paired { corner(on_b) } else { line(side.b) },
    };
    let (p, q) = (point(from, side.a, b.after(side.b)), point(to, a.after(side.a), side.b));
    let (first, second) = if precedes(to.at, from.at) { (q, p) } else { (p, q) };
    let apart = side.edge.dot(to.at.sub(from.at)) != 0;
    Manifold { first, second: apart.then_some(second) }
}

/// The manifold for a side and the deepest corner behind it. The second point is the end of the
/// flatter side beside that corner, cut to the part that faces the side.
fn one(contact: &Contact, side: &PolygonSide, a: Core<'_>, b: Core<'_>) -> Manifold {
    // Whether A is the one that leans on a side of B.
    let on_a = side.of_b;
    let (reference, index, core, deepest) = if on_a { (b, side.b, a, side.a) } else { (a, side.a, b, side.b) };
    let (p, q) = face(reference, index);
    // Along the side of the sum, B's side runs back.
    let (p, q) = if on_a { (q, p) } else { (p, q) };
    let point = |contact: Contact, of_side: Part, of_other: Part| {
        let (part_a, part_b) = if on_a { (of_other, of_side) } else { (of_side, of_other) };
        ManifoldPoint { contact, part_a, part_b }
    };
    let first = point(*contact, line(index), corner(deepest));
    let e = side.edge;
    let second = leaning(core, deepest, if on_a { e } else { e.reversed() }).and_then(|lean| {
        let start = core.corner(deepest);
        let v = core.corner(lean.end).sub(start);
        // The deepest corner faces the side; beyond its ends the other one does not. Products are
        // below 2^62.
        let (from, to, room) = (e.dot(start.sub(p)), e.dot(start.add(v).sub(p)), e.dot(q.sub(p)));
        let cut = |bound: i64| {
            let (share, whole) = (bound.wrapping_sub(from).wrapping_abs(), to.wrapping_sub(from).unsigned_abs());
            start.add(Raw { x: scaled(v.x, share, whole), y: scaled(v.y, share, whole) })
        };
        // Along the sum, a side of A begins at its own corner, and a side of B ends there.
        let (end, of_side, of_other) = if to < 0 {
            (cut(0), corner(if on_a { reference.after(index) } else { index }), line(lean.side))
        } else if to > room {
            (cut(room), corner(if on_a { index } else { reference.after(index) }), line(lean.side))
        } else {
            (start.add(v), line(index), corner(lean.end))
        };
        let (_, overlap) = over(e, if on_a { end.sub(p) } else { p.sub(end) });
        let contact = at(contact, overlap, end, on_a);
        let counts = contact.depth() > 0 && end != start;
        counts.then(|| point(contact, of_side, of_other))
    });
    Manifold { first, second }
}

/// A side of a shape beside its deepest corner: its index and its other end.
struct Lean {
    side: usize,
    end: usize,
}

/// The side beside a corner that is more parallel to `way`, the direction in which the next one
/// leads away. `None` if both lead in the other direction, or are equally parallel: no choice
/// between two mirror images would be that of a mirrored scene.
fn leaning(core: Core<'_>, at: usize, way: Raw) -> Option<Lean> {
    if core.corners.len() < 2 {
        return None;
    }
    let here = core.corner(at);
    let toward = |end: usize, way: Raw| {
        let v = core.corner(end).sub(here);
        (way.dot(v), v.len2())
    };
    let (next, last) = (core.after(at), core.before(at));
    let (forth, back) = (toward(next, way), toward(last, way.reversed()));
    let (forth_leads, back_leads) = (forth.0 > 0, back.0 > 0);
    let order = cmp_squares((forth.0.unsigned_abs(), back.1), (back.0.unsigned_abs(), forth.1));
    let takes_next = match (forth_leads, back_leads) {
        (false, false) => return None,
        (true, true) if order.is_eq() => return None,
        (true, true) => order.is_gt(),
        (forth, _) => forth,
    };
    Some(if takes_next { Lean { side: at, end: next } } else { Lean { side: last, end: last } })
}
