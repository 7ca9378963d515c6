//! Bounds of a displacement as half-planes, and the nearest displacement within all of them.

use crate::motion::plane::way;
use crate::num::{Axis, MOTION, Raw, mul_div_wide, mul64};
use crate::query::cast::moment::along;
use crate::world::{Feature, Geometry};

/// The displacements `d` with `normal . (d - at) >= 0`.
///
/// Normals and displacements are below 2^30: heights are below 2^61.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct HalfPlane {
    pub(super) normal: Axis,
    pub(super) at: Raw,
}

impl HalfPlane {
    fn height(&self, d: Raw) -> i64 {
        along(self.normal, d.sub(self.at))
    }

    /// The nearest displacement in it, each component rounded away from the border.
    fn nearest(&self, d: Raw) -> Option<Raw> {
        let (below, n) = (self.height(d).wrapping_neg(), self.normal);
        if below <= 0 {
            return Some(d);
        }
        let by = scaled(Raw { x: n.x, y: n.y }, below as u64, n.length_squared())?;
        Some(d.add(by))
    }

    /// A displacement on the border of this half-plane that is also in the other one, nearest to
    /// `d`.
    fn corner(&self, other: &Self, d: Raw) -> Option<Raw> {
        let on = self.nearest(d)?;
        let below = other.height(on).wrapping_neg();
        if below <= 0 {
            return Some(on);
        }
        let tangent = Raw { x: self.normal.x, y: self.normal.y }.perp();
        let gain = along(other.normal, tangent);
        let tangent = if gain < 0 { tangent.reversed() } else { tangent };
        // Rounding may leave the other one by a few raw units: then a few more along the border.
        let unit = u64::from(other.normal.x.unsigned_abs()).wrapping_add(other.normal.y.unsigned_abs().into());
        [0, 1, 2, 4, 8].into_iter().find_map(|units| {
            let more = (below as u64).wrapping_add(unit.wrapping_mul(units));
            let at = self.nearest(on.add(scaled(tangent, more, gain.unsigned_abs())?))?;
            (other.height(at) >= 0).then_some(at)
        })
    }
}

impl Raw {
    const fn perp(self) -> Self {
        Self { x: self.y.wrapping_neg(), y: self.x }
    }
}

/// `v a / n`, each component rounded away from zero; none if that is not a motion.
fn scaled(v: Raw, a: u64, n: u64) -> Option<Raw> {
    let part = |c: i32| {
        if n == 0 {
            return None;
        }
        let size = mul_div_wide(a, c.unsigned_abs(), n);
        let is_exact = mul64(size.into(), n) == mul64(a, c.unsigned_abs().into());
        let size = size.saturating_add(u32::from(!is_exact));
        let size = (size < MOTION as u32).then_some(size as i32)?;
        Some(if c < 0 { size.wrapping_neg() } else { size })
    };
    Some(Raw { x: part(v.x)?, y: part(v.y)? })
}

/// The most bounds.
const BOUNDS: usize = 12;

/// The source of a bound: a kind of piece of the level or of one of the solids, and its position.
/// The arcs around one centre count as one.
type Source = (Option<u16>, u8, (i32, i32));

/// Up to twelve bounds. A further bound closes the room.
pub(super) struct RoomToMove {
    wanted: Raw,
    /// How far a displacement may be from the wanted one, along x or y.
    far: u32,
    bounds: heapless::Vec<(Source, HalfPlane), BOUNDS>,
    closed: bool,
}

impl RoomToMove {
    /// The room around a displacement, of pushes of up to `push`.
    pub(super) fn new(wanted: Raw, push: u32) -> Self {
        let far = push.saturating_mul(8).saturating_add(16);
        Self { wanted, far, bounds: heapless::Vec::new(), closed: false }
    }

    pub(super) fn close(&mut self) {
        self.closed = true;
    }

    /// Adds a bound of a piece of the level, or of the solid with that number. It replaces the last
    /// one of the same piece, because a nearer tangent of a corner or an arc is better. In a pipe,
    /// all tangents count.
    pub(super) fn add(&mut self, solid: Option<u16>, feature: &Feature, plane: HalfPlane) {
        let (kind, place, is_pipe) = match feature.geometry {
            Geometry::Face { a, .. } => (0, a, false),
            Geometry::Vertex { p, .. } => (1, p, false),
            Geometry::Arc { centre, convex, .. } => (2, centre, !convex),
        };
        // A solid has one border along x or y on each side: of a face, and of the arcs at its ends.
        let Axis { x, y } = plane.normal;
        let is_flat = solid.is_some() && (x == 0 || y == 0);
        let source = if is_flat { (solid, 3, (x.signum(), y.signum())) } else { (solid, kind, place.raw()) };
        match self.bounds.iter_mut().find(|(s, _)| *s == source && !is_pipe) {
            Some((_, kept)) => *kept = plane,
            None => self.closed |= self.bounds.push((source, plane)).is_err(),
        }
    }

    /// Leaves out the bounds of the level. Returns whether there were any.
    pub(super) fn forget_level(&mut self) -> bool {
        let before = self.bounds.len();
        self.bounds.retain(|((solid, ..), _)| solid.is_some());
        self.bounds.len() < before
    }

    /// The axes along which a face of a solid determines the displacement.
    pub(super) fn held(&self) -> (bool, bool) {
        let mut solids = self.bounds.iter().filter(|((solid, ..), _)| solid.is_some());
        let along_x = solids.clone().any(|(_, plane)| plane.normal.y == 0);
        (along_x, solids.any(|(_, plane)| plane.normal.x == 0))
    }

    fn holds(&self, d: Raw) -> bool {
        way(d) < MOTION as u32
            && way(d.sub(self.wanted)) <= self.far
            && self.bounds.iter().all(|(_, plane)| plane.height(d) >= 0)
    }

    /// The displacement within all bounds that is nearest to the wanted one; none without room.
    ///
    /// It is the wanted one, or on the border of one bound, or where two borders cross.
    pub(super) fn nearest(&self) -> Option<Raw> {
        if self.closed {
            return None;
        }
        let mut best: Option<Raw> = self.holds(self.wanted).then_some(self.wanted);
        let key = |d: &Raw| {
            let by = d.sub(self.wanted);
            (by.len2(), by.x.unsigned_abs(), by.y.unsigned_abs(), by.x, by.y)
        };
        let mut consider = |d: Option<Raw>| {
            let Some(d) = d.filter(|d| self.holds(*d)) else { return };
            if best.is_none_or(|kept| key(&d) < key(&kept)) {
                best = Some(d);
            }
        };
        for (i, (_, plane)) in self.bounds.iter().enumerate() {
            consider(plane.nearest(self.wanted));
            for (_, other) in self.bounds.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, b)| b) {
                consider(plane.corner(other, self.wanted));
            }
        }
        best
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "a test")]
mod tests {
    use super::{Axis, HalfPlane, Raw, RoomToMove};
    use crate::world::{Cell, Feature, Geometry};

    fn room(planes: &[(i32, i32, i32, i32)], wanted: (i32, i32)) -> RoomToMove {
        let mut room = RoomToMove::new(Raw { x: wanted.0, y: wanted.1 }, 1000);
        for (i, &(nx, ny, x, y)) in planes.iter().enumerate() {
            let geometry = Geometry::Vertex { p: crate::num::Vec2::ZERO, e_in: Axis::X, e_out: Axis::Y };
            let feature = Feature { geometry, cell: Cell::default(), index: 0, flags: 0, one_way: false, source: 0 };
            room.add(Some(i as u16), &feature, HalfPlane { normal: Axis::new(nx, ny), at: Raw { x, y } });
        }
        room
    }

    /// A face holds the axis of its normal, and a slanted side none.
    #[test]
    fn faces_hold_the_axis_of_their_normal() {
        for (x, y, held) in
            [(1, 0, (true, false)), (-1, 0, (true, false)), (0, 1, (false, true)), (2, 1, (false, false))]
        {
            assert_eq!(room(&[(x, y, 0, 0)], (0, 0)).held(), held, "{x} {y}");
        }
        assert_eq!(room(&[(0, -1, 0, 0), (1, 0, 0, 0)], (0, 0)).held(), (true, true));
    }

    /// No lattice point within the bounds is nearer than the answer, but for its roundings.
    #[test]
    fn the_nearest_displacement() {
        let mut random = tilesat_judge::Random::new(71);
        let (mut some, mut none) = (0, 0);
        for _ in 0..tilesat_judge::cases(tilesat_judge::thorough(5_000, 20_000)) {
            let mut number = |most: i64| random.around(most) as i32;
            let wanted = (number(12), number(12));
            let planes: [_; 3] = core::array::from_fn(|_| (number(5), number(5), number(9), number(9)));
            let planes = planes.map(|(x, y, a, b)| if (x, y) == (0, 0) { (1, 0, a, b) } else { (x, y, a, b) });
            let holds = |x: i32, y: i32, slack: i32| {
                planes.iter().all(|&(nx, ny, a, b)| nx * (x - a) + ny * (y - b) >= slack * (nx.abs() + ny.abs()))
            };
            let nearest = |slack: i32| {
                let all = (-60..=60).flat_map(|x| (-60..=60).map(move |y| (x, y)));
                let far = |(x, y): (i32, i32)| (x - wanted.0).pow(2) + (y - wanted.1).pow(2);
                all.filter(|p| holds(p.0, p.1, slack)).map(far).min()
            };
            if let Some(d) = room(&planes, wanted).nearest() {
                assert!(holds(d.x, d.y, 0), "{planes:?}");
                let by = (d.x - wanted.0).pow(2) + (d.y - wanted.1).pow(2);
                // Not farther than the nearest point two raw inside, and its roundings.
                if let Some(far) = nearest(2) {
                    // A raw unit across is more along two borders that are nearly parallel.
                    let more = |(a, b): (usize, usize)| {
                        let ((ax, ay, ..), (bx, by, ..)) = (planes[a], planes[b]);
                        let sizes = f64::from((ax * ax + ay * ay) * (bx * bx + by * by)).sqrt();
                        sizes / f64::from((ax * by - ay * bx).abs()).max(0.1)
                    };
                    let most =
                        [(0, 1), (0, 2), (1, 2)].map(more).into_iter().filter(|m| *m < 100.0).fold(1.0, f64::max);
                    let root = f64::from(by).sqrt() - f64::from(far).sqrt();
                    assert!(root < 3.0 * most, "{planes:?} {wanted:?} {d:?} {far}");
                }
                some += 1;
            } else {
                assert!(nearest(3).is_none_or(|far| far > 3000), "{planes:?} {wanted:?}");
                none += 1;
            }
        }
        assert!(tilesat_judge::enough(some > 1000 && none > 100), "{some} {none}");
    }
}
