//! The ground below a body, and the floor that it stands on.

use crate::error::RangeError;
use crate::motion::body::{Body, Entry};
use crate::motion::order::First;
use crate::motion::plane::{NEAR, into, may_be_askew, way};
use crate::motion::run::{Run, check_inside};
use crate::motion::search::{Around, check_cells};
use crate::motion::slope_limit::SurfaceRole;
use crate::motion::ways::Ways;
use crate::motion::{Hit, Moved, Mover};
use crate::num::{Axis, DOMAIN, Fx, Raw, Toi, Vec2, mul_div, umul};
use crate::shape::Aabb;
use crate::world::{Cell, Feature, World};

/// The floor on which a body stands.
///
/// Plain data. If a body stands on several tiles at the same height, their flags are or-ed, and the
/// cell is that of one of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
// As a `Hit`.
#[repr(C)]
pub struct Support {
    /// The exact normal of the floor.
    pub axis: Axis,
    /// The cell of the level. Of a moving solid it holds the key: see [`solid`](Self::solid).
    pub cell: Cell,
    /// Which feature of the cell, as [`Feature::index`].
    pub index: u16,
    /// The user flags of the tiles or segments.
    pub flags: u8,
    /// Whether it is a one-way face.
    pub one_way: bool,
    /// Which level, as [`Feature::source`].
    pub source: u8,
}

impl Support {
    /// The key of the moving solid that the body stands on. `None` for a tile or a segment.
    ///
    /// In a [joined](crate::Joined) level, [`source`](Self::source) distinguishes two lists.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Mover, Solid, Solids, Vec2};
    /// let boxed = |x, y, w, h| Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h));
    /// let lift = [Solid::new(boxed(0, 24, 48, 4)?, 7)?];
    /// let floor = Mover::platformer(Axis::NEG_Y).supported(&Solids::new(&lift), &boxed(20, 10, 10, 14)?)?;
    /// assert_eq!(floor.map(|floor| floor.solid()), Some(Some(7)));
    /// # Ok::<(), tilesat::RangeError>(())
    /// ```
    #[must_use]
    pub const fn solid(&self) -> Option<u16> {
        self.cell.solid()
    }

    pub(super) fn of(axis: Axis, f: &Feature) -> Self {
        Self { axis, cell: f.cell, index: f.index, flags: f.flags, one_way: f.one_way, source: f.source }
    }
}

impl From<Hit> for Support {
    fn from(h: Hit) -> Self {
        Self { axis: h.axis, cell: h.cell, index: h.index, flags: h.flags, one_way: h.one_way, source: h.source }
    }
}

/// How far below a body a floor still carries it, raw. Bodies rest up to 2 raw early on each axis
/// at slopes and corners.
pub(in crate::motion) const CONTACT: i32 = 8;

/// A body is wedged if no free direction leads down by this much, raw. A way slower than the
/// rounding distance leads nowhere. Ground flatter than 1 in 256 therefore holds every body, as it
/// does under a gravity of 1/64 unit.
const DROP: i32 = 1 << 10;

impl Mover {
    /// The floor that carries a body at rest: less than 8 raw units below it, against "up".
    ///
    /// The mover's slope limit decides which surfaces are floor. One-way faces carry a body that is
    /// entirely above them, unless the mover drops through. A mover without an "up" has no floor.
    ///
    /// A body that gravity wedges between walls, with no free direction that leads down, is
    /// supported too. Its axis is then "up", and the feature is the first one below.
    ///
    /// Cost: one sweep over the cells that the body touches.
    ///
    /// ```
    /// use tilesat::{Aabb, Axis, Mover, TileKind, TileKinds, TileMap, Vec2};
    /// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    /// let level = TileMap::from_ascii("..\n##", &KINDS)?; // the floor is at y = 16
    /// let mover = Mover::platformer(Axis::NEG_Y);
    /// let crate_ = Aabb::new(Vec2::from_ints(4, 6), Vec2::from_ints(14, 16))?;
    /// assert_eq!(mover.supported(&level, &crate_)?.map(|floor| floor.axis), Some(Axis::NEG_Y));
    /// let lifted = crate_.translated(Vec2::from_ints(0, -1))?;
    /// assert_eq!(mover.supported(&level, &lifted)?, None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RangeError`] if a half extent or radius is not below 2^28 raw, or the body covers more
    /// than [`Mover::CELLS`] cells.
    pub fn supported<W: World, B: Body>(&self, world: &W, body: &B) -> Result<Option<Support>, RangeError> {
        body.check_size()?;
        let around = 2 * (CONTACT + 1);
        check_cells(world, body.extent(), Raw { x: around, y: around })?;
        let Some(up) = self.up else { return Ok(None) };
        let mut moved = Moved::freely(*body, Vec2::ZERO, 0);
        let mut around = Around::nothing();
        let mut run = Run::new(&mut moved, &mut around);
        run.pass_one_way = self.passes_one_way();
        Ok(run.floor_near(world, self, up))
    }
}

/// The hit of a look down.
#[derive(Clone, Copy)]
pub(super) struct Ground {
    /// The look.
    pub(super) d: Raw,
    pub(super) entry: Entry,
    pub(super) feature: Feature,
}

impl Ground {
    /// The way down to it.
    pub(super) fn drop(&self) -> Raw {
        self.entry.displacement(self.d)
    }
}

pub(super) trait Look {
    /// The first hit of a motion that the body does not make, on the part of it [`within`] the
    /// domain.
    fn look<W: World>(&mut self, world: &W, d: Raw) -> Option<Ground>;

    /// [`look`](Self::look) from another position, whatever is between the two and at it. If the
    /// body is inside the solid, leaving it is no hit.
    fn look_from<W: World>(&mut self, world: &W, to: Raw, d: Raw) -> Option<Ground>;

    /// The floor that carries the body: within [`CONTACT`] below, also beside a wall that leans on
    /// the body from below. Otherwise the surfaces that [wedge](Self::wedge) it.
    fn floor_near<W: World>(&mut self, world: &W, mover: &Mover, up: Axis) -> Option<Support>;

    /// A support that is not floor: the first feature below the body, if no free direction at its
    /// position leads down.
    fn wedge<W: World>(&mut self, world: &W, up: Axis) -> Option<Support>;
}

impl<B: Body> Look for Run<'_, B> {
    #[inline(never)]
    fn look<W: World>(&mut self, world: &W, d: Raw) -> Option<Ground> {
        let d = within(&self.moved.body.bounds(), d);
        if d.is_zero() {
            return None;
        }
        self.moved.work.iterations += 1;
        let (entry, feature) = self.first_hit(world, d)?;
        Some(Ground { d, entry, feature })
    }

    fn look_from<W: World>(&mut self, world: &W, to: Raw, d: Raw) -> Option<Ground> {
        let here = self.here();
        let to = within(&self.moved.body.bounds(), to);
        self.moved.body = self.moved.body.shifted(to);
        let ground = self.look(world, d);
        self.put_back(here);
        ground
    }

    #[inline(never)]
    fn floor_near<W: World>(&mut self, world: &W, mover: &Mover, up: Axis) -> Option<Support> {
        let (body, d) = (self.moved.body, along(up, -CONTACT));
        let (lo, hi) = (body.bounds().lo(), body.bounds().hi());
        let far = Raw { x: CONTACT + 1, y: CONTACT + 1 };
        let mut first = First::none();
        for feature in world.features(&Aabb::from_raw_unchecked(lo.sub(far), hi.add(far))) {
            self.moved.work.features += 1;
            if feature.one_way && self.pass_one_way {
                continue;
            }
            match body.sweep_in::<W>(d, &feature) {
                Some(entry) if mover.side(entry.normal) == SurfaceRole::Floor => first.add::<B, W>(&entry, &feature, d),
                _ => {}
            }
        }
        let floor = first.hit::<B, W>(&body, d).map(|(entry, feature)| Support::of(entry.normal, feature));
        floor.or_else(|| self.wedge(world, up))
    }

    #[inline(never)]
    fn wedge<W: World>(&mut self, world: &W, up: Axis) -> Option<Support> {
        if !may_be_askew::<B, W>() {
            return None;
        }
        let down = along(up, -DROP);
        let passes = self.pass_one_way;
        let mut ways = Ways::none();
        ways.read::<W, B>(world, &self.moved.body, (down, Toi::ONE), None, passes);
        ways.settle_all(world, &self.moved.body, passes);
        // A way that ends before it leads down by a raw unit leads nowhere. Between a corner and a
        // slope over it, a ball may have room to the side only.
        let mut leads = |d| self.look(world, d).is_none_or(|ground| into(ground.drop(), up) < 0);
        if ways.iter().any(|way| way.is_free() && (way.along.is_none() || leads(way.probe()))) {
            return None;
        }
        self.look(world, down).map(|ground| Support::of(up, &ground.feature))
    }
}

impl Mover {
    /// The ground as a support, if it is floor.
    pub(super) fn support(&self, ground: &Ground) -> Option<Support> {
        let normal = ground.entry.normal;
        (self.side(normal) == SurfaceRole::Floor).then(|| Support::of(normal, &ground.feature))
    }
}

/// The part of a way that stays in the domain, to the last raw unit along x and y. Zero if the
/// bounds leave the domain already.
#[inline(never)]
pub(super) fn within(bounds: &Aabb, d: Raw) -> Raw {
    if check_inside(bounds, d).is_ok() {
        return d;
    }
    if check_inside(bounds, Raw::ZERO).is_err() {
        return Raw::ZERO;
    }
    let (lo, hi) = (bounds.lo(), bounds.hi());
    let room = |c: i32, lo: i32, hi: i32| (if c < 0 { DOMAIN - 1 + lo } else { DOMAIN - 1 - hi }) as u32;
    let cut = |d: Raw, c: i32, room: u32| {
        let long = c.unsigned_abs();
        if long <= room {
            return d;
        }
        // Rounded toward zero, so a component that fits still fits. The component that is cut
        // becomes the room itself.
        let part = |c: i32| (mul_div(c.unsigned_abs(), room, long) as i32).wrapping_mul(c.signum());
        Raw { x: part(d.x), y: part(d.y) }
    };
    let d = cut(d, d.x, room(d.x, lo.x, hi.x));
    cut(d, d.y, room(d.y, lo.y, hi.y))
}

/// A length along an axis, or against it if negative. Exact along x and y; elsewhere each component
/// is rounded toward zero.
pub(super) fn along(axis: Axis, length: i32) -> Raw {
    if axis.x == 0 || axis.y == 0 {
        return Raw { x: axis.x.signum().wrapping_mul(length), y: axis.y.signum().wrapping_mul(length) };
    }
    let part = |unit: i32| {
        let size = (umul(unit.unsigned_abs(), length.unsigned_abs()) >> 30) as i32;
        if (unit < 0) == (length < 0) { size } else { size.wrapping_neg() }
    };
    let (x, y) = axis.unit().raw();
    Raw { x: part(x), y: part(y) }
}

/// Whether a velocity leads away along an axis, by more than roundings.
pub(super) fn leads(v: Raw, axis: Axis) -> bool {
    let size = u64::from(axis.x.unsigned_abs()) + u64::from(axis.y.unsigned_abs());
    axis.dot(Axis::new(v.x, v.y)) > (size * u64::from(NEAR)) as i64
}

/// The longer component, as a length.
pub(super) fn length(d: Raw) -> Fx {
    Fx::from_bits(way(d) as i32)
}

#[cfg(test)]
mod tests {
    use super::{Aabb, DOMAIN, Raw, within};

    /// Beside each border of the domain there is room for five raw units.
    #[test]
    fn a_way_ends_at_the_border_of_the_domain() {
        for (x, y) in [(1, 0), (-1, 0), (0, 1), (0, -1)] {
            let at = |n: i32| Raw { x: x * n, y: y * n };
            let (one, two) = (at(DOMAIN - 6), at(DOMAIN - 9).add(Raw { x: 2 * y, y: 2 * x }));
            let (lo, hi) =
                (Raw { x: one.x.min(two.x), y: one.y.min(two.y) }, Raw { x: one.x.max(two.x), y: one.y.max(two.y) });
            let bounds = Aabb::from_raw_unchecked(lo, hi);
            assert_eq!(within(&bounds, at(9)), at(5));
            assert_eq!(within(&bounds, at(5)), at(5));
            assert_eq!(within(&bounds, at(-9)), at(-9));
        }
    }
}
