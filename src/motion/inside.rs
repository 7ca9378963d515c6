//! Bodies that start in the solid: a door closed on them, or the game put them there.

use super::Stuck;
use super::body::{Body, kernel::Kernel};
use super::cast::cast_in;
use super::run::check_inside;
use crate::num::{DOMAIN, Fx, Raw, UnitVec2, mul_div};
use crate::shape::Circle;
use crate::world::{Inside, OneWay, Pushable, World, WorldContact, contacts_of};

/// How a [`Mover`](super::Mover) treats a body that already overlaps the level. To push it out
/// first, see [`escape`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum StartInside {
    /// Nothing moves: the call returns [`Stuck`].
    #[default]
    Report,
    /// The surfaces that the body overlaps do not stop it, so it can always leave, in any
    /// direction. All other surfaces stop it. Until the body has reached a free position, the
    /// motion may end inside the solid; after that it never does. The next call tests again.
    ///
    /// **No gravity while it is inside.** If a door of tiles has closed on a body, the floor below
    /// the door has no face any more (solid lies on solid). A body that falls there passes through
    /// the floor, and leaves the world. Test `overlaps` of the level before each call. While that
    /// is true, give the body only a velocity across "up". [Doors](crate::motion#doors) shows how
    /// to avoid this.
    ///
    /// ```text
    ///        | door |
    ///        | [B]  |          B leaves to the left or right; and down as well,
    ///   _____|......|_____     for there is no face on the dotted line, nor below it
    /// ```
    Ignore,
}

/// The most pushes of one [`escape`], and the most contacts that it tries one by one.
const PUSHES: usize = 4;

/// Pushes a body out of the solid, at most four times, and returns it at the free position. If that
/// fails, it tries one push out of each of its first four contacts, and takes the shortest that
/// frees it. So a crusher over the edge of a body on a floor pushes it aside at once. A free body
/// is returned unchanged.
///
/// Each push leads out of the first feature of its [contacts](crate::TileMap::contacts), which is
/// the nearest. It is the depth, rounded up to raw units, and at most 4 raw more. If it would lead
/// back into a surface that the body has left, it goes on along its own surface. It ends where the
/// body is out of both, so a nook of two walls takes two pushes. That way along a surface is at
/// most the longer side of the box around the body. There is no way out deep inside the solid,
/// where the body reaches no surface, and in gaps narrower than the body. One-way faces do not
/// count.
///
/// **It finds no way out of a door that is wider than the body** once the body is between both
/// sides: it reaches neither. Take a body 10 wide in a door of one tile, from x = 32 to 48. At x =
/// 31 it is pushed 9 to the left, at 39 it is pushed 9 to the right. From 32 to 38 the result is
/// [`Stuck`]. [Doors](crate::motion#doors) shows how to avoid this.
///
/// If several features hold a compound, each push moves all its parts out of one of them.
///
/// Cost: an exact overlap test. If the body overlaps, the [contacts](crate::TileMap::contacts) of
/// one body and another test, at most four times. If these fail, the same again. Only a game that
/// calls it links the code for contacts.
///
/// ```
/// use tilesat::motion::escape;
/// use tilesat::{Aabb, TileKind, TileKinds, TileMap, Vec2};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let map = TileMap::from_ascii("#...\n####", &KINDS)?;
/// let inside = Aabb::new(Vec2::from_ints(14, 9), Vec2::from_ints(24, 19)).unwrap(); // 2 in the wall, 3 in the floor
/// assert_eq!(escape(&map, &inside).unwrap().min(), Vec2::from_ints(16, 6));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Stuck`] if no push within the domain frees the body.
pub fn escape<W: World, B: Body + Pushable>(world: &W, body: &B) -> Result<B, Stuck> {
    let mut contacts = heapless::Vec::<_, PUSHES>::new();
    let mut left = heapless::Vec::<LeftSurface, PUSHES>::new();
    let (mut pushed, mut made) = (*body, Raw::ZERO);
    let bounds = Kernel::bounds(body);
    let size = bounds.hi().sub(bounds.lo());
    let most = size.x.max(size.y).unsigned_abs();
    loop {
        if !pushed.overlaps_world(world) {
            return Ok(pushed);
        }
        // More contacts than fit are no error here.
        let _ = contacts_of(world, &pushed, OneWay::Ignore, &mut contacts);
        let Some(contact) = contacts.first() else { break };
        let here = LeftSurface { normal: contact.axis().unit(), at: made.add(Raw::of(contact.push_out())) };
        let back = left.iter().find_map(|earlier| here.way_out_of(earlier)).unwrap_or(0);
        // Surfaces that are nearly parallel meet far away.
        if back.unsigned_abs() > most {
            break;
        }
        let to = here.at.add(here.along(back));
        if left.push(here).is_err() || check_inside(&bounds, to).is_err() {
            break;
        }
        (pushed, made) = (body.shifted(to), to);
    }
    let _ = contacts_of(world, body, OneWay::Ignore, &mut contacts);
    let mut free: Option<Raw> = None;
    for push in contacts.iter().filter_map(|contact| push_of(body, contact)) {
        let shorter = free.is_none_or(|free| push.dot(push) < free.dot(free));
        if shorter && !body.shifted(push).overlaps_world(world) {
            free = Some(push);
        }
    }
    free.map(|push| body.shifted(push)).ok_or(Stuck { at: body.position().raw() })
}

/// A surface that a body has left, and the displacement with which it lay on it.
struct LeftSurface {
    normal: UnitVec2,
    at: Raw,
}

impl LeftSurface {
    /// How far along this surface the body is out of an earlier one, if it is not.
    fn way_out_of(&self, earlier: &Self) -> Option<i32> {
        let of = |unit: UnitVec2| Raw { x: unit.raw().0, y: unit.raw().1 };
        let (n, m) = (of(self.normal), of(earlier.normal));
        // Unit vectors are in parts of 2^30, displacements below 2^30.
        let behind = m.dot(earlier.at.sub(self.at)) >> 30;
        if behind <= 0 {
            return None;
        }
        let sine = n.cross(m) >> 30;
        let length = mul_div(behind as u32 + 2, 1 << 30, sine.unsigned_abs() as u32).min(DOMAIN as u32) as i32;
        Some(if sine < 0 { -length } else { length })
    }

    /// The vector of a length along this surface.
    fn along(&self, length: i32) -> Raw {
        let (x, y) = self.normal.raw();
        Raw::of(UnitVec2::from_raw(y.wrapping_neg(), x).scaled(Fx::from_bits(length)))
    }
}

/// The push out of one feature, unless it leaves the domain.
fn push_of<B: Body>(body: &B, contact: &WorldContact) -> Option<Raw> {
    let push = Raw::of(contact.push_out());
    check_inside(&Kernel::bounds(body), push).is_ok().then_some(push)
}

/// Turns a body in a level: replaces it by `turned`, which has another direction or size, and
/// pushes that out of the solid if necessary. The result is never inside.
///
/// The body must be free. If `turned` is free too, that is the result. Otherwise it is pushed as by
/// [`escape`]. The straight line from the middle of `body` to the middle of the result must be free
/// for a point. So a thin wall is never between the two. One-way faces do not count. For a
/// compound, this applies to the middle of each part. Both compounds must have equally many parts,
/// in the same order.
///
/// It looks only at the start and at the end, not at the positions between them. Turn by small
/// steps if something thin could fit into the angle.
///
/// Cost: that of `escape`, and one cast of a point if something was pushed.
///
/// ```
/// use tilesat::motion::turn;
/// use tilesat::{Axis, OrientedBox, TileKind, TileKinds, TileMap, Vec2};
/// static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// let map = TileMap::from_ascii("....\n....\n####", &KINDS)?; // the floor is at y = 32
/// let plank = |y, direction| OrientedBox::new(Vec2::from_ints(32, y), Vec2::from_ints(10, 2), direction);
/// let lying = plank(30, Axis::X)?;
/// let standing = turn(&map, &lying, &plank(30, Axis::Y)?).unwrap();
/// assert_eq!(standing, plank(22, Axis::Y)?); // pushed up by 8
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Stuck`] if the body is not free, or no push frees `turned` on its side of the walls.
pub fn turn<W: World, B: Body + Pushable>(world: &W, body: &B, turned: &B) -> Result<B, Stuck> {
    let stuck = Stuck { at: body.position().raw() };
    if body.overlaps_world(world) {
        return Err(stuck);
    }
    if !turned.overlaps_world(world) {
        return Ok(*turned);
    }
    let free = escape(world, turned)?;
    let mut part = 0;
    while let (Some(from), Some(to)) = (body.centre(part), free.centre(part)) {
        let point = Circle::from_raw_unchecked(from, 0);
        if !matches!(cast_in(world, &point, to.sub(from).vec2(), Inside::Hit.into()), Ok(None)) {
            return Err(stuck);
        }
        part += 1;
    }
    Ok(free)
}
