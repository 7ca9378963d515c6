//! Convex solids that move and turn: what they do to bodies, rays at them, the points nearest to
//! one, and bodies that move among them.

use tilesat::shape::AnyShape;
use tilesat::world::{ConvexSolid, ConvexSolids, Joined, OneWay};
use tilesat::{
    Aabb, Axis, Capsule, Character, Circle, ConvexPolygon, Feel, Fx, Input, Mover, OrientedBox, TileMap, Vec2, fx,
};

use super::VECTORS;
use super::family::Run;
use super::hash::Hash;
use super::levels::{SIZE, shapes};
use super::random::{Random, UNIT};
use super::world::Vector;

type Any = AnyShape<4>;
type Solid = ConvexSolid<Any>;

const QUERIES: [&str; 6] = ["ride_convex", "cast_ray", "cast_ray_all", "closest_point", "move_and_slide", "step_on"];

/// A plank as a polygon, which may turn.
fn plank(at: Vec2, half: Vec2, direction: Axis) -> Option<Any> {
    Some(ConvexPolygon::new(&OrientedBox::new(at, half, direction).ok()?.corners()).ok()?.into())
}

/// One of all shapes, somewhere in the level.
fn solid(r: &mut Random, at: Vec2, key: u16) -> Option<Solid> {
    let (ox, oy) = at.raw();
    let p = Vec2::from_raw(ox + r.below(40) as i32 * 8 * UNIT, oy + r.below(28) as i32 * 8 * UNIT);
    let size = 4 * UNIT + r.signed(20).abs();
    let half = Vec2::from_raw(size, 2 * UNIT + r.signed(18).abs());
    let direction = Axis::new(64, r.small(40));
    let motion = Vec2::from_raw(r.signed(18), r.signed(18));
    let radius = Fx::from_bits(size / 2);
    let shape: Any = match r.below(6) {
        0 => Circle::new(p, radius).ok()?.into(),
        1 => Capsule::new(p, p + Vec2::new(half.x, fx!(0)), radius).ok()?.into(),
        2 => Aabb::new(p, p + half).ok()?.into(),
        _ => plank(p, half, direction)?,
    };
    let solid = ConvexSolid::new(shape, key).ok()?.with_flags(1 << key);
    if r.below(2) == 0 {
        let turned = plank(p + motion, half, Axis::new(64, direction.y + r.small(20)));
        if let Some(solid) = turned.and_then(|next| solid.with_turn(next).ok()) {
            return Some(solid);
        }
    }
    solid.with_motion(motion).ok()
}

/// What one vector asks.
fn ask(
    map: &TileMap<'static, tilesat::AllShapes>,
    list: &[Solid; 4],
    v: &Vector,
    r: &mut Random,
    hashes: &mut [Hash; 6],
) {
    let [rides, ray, rays, near, slides, steps] = hashes;
    let (mover, follow) = (Mover::platformer(Axis::NEG_Y), Fx::from_bits(r.signed(17).abs()));
    let p = v.ball.centre();
    let solids = ConvexSolids::new(list);
    ray.add(solids.cast_ray(p, v.motion, v.rules));
    if let Ok(all) = solids.cast_ray_all(p, v.motion, v.rules) {
        all.for_each(|hit| rays.add(hit));
    }
    near.add(solids.closest_point(p, v.within, OneWay::Ignore));
    let by = Vec2::from_raw(r.signed(19), r.signed(19));
    // Half of the bodies come down on a solid.
    let over = list.first().map(|s| s.shape().aabb()).filter(|_| r.below(2) == 0);
    let level = Joined::new(map, &solids);
    let input = Input { run: Fx::from_bits(by.raw().0), jump: by.raw().1 < 0, drop: false };
    if v.round {
        let ball = over.and_then(|b| Circle::new(Vec2::new(p.x, b.min().y - v.ball.radius()), v.ball.radius()).ok());
        let ball = ball.unwrap_or(v.ball);
        rides.add(mover.ride_convex(map, solids.list(), &ball, follow));
        slides.add(mover.move_and_slide(&level, &ball, by));
        let mut copy = *list;
        let mut hero = Character::new(ball, map.bounds(), Feel::DEFAULT);
        for _ in 0..2 {
            steps.add(hero.step_on(map, &mut copy, input).is_ok());
        }
        steps.add(*hero.body());
        steps.add(hero.ridden().is_some());
    } else {
        let block = over.and_then(|b| v.block.translated(Vec2::new(fx!(0), b.min().y - v.block.max().y)).ok());
        let block = block.unwrap_or(v.block);
        rides.add(mover.ride_convex(map, solids.list(), &block, follow));
        slides.add(mover.move_and_slide(&level, &block, by));
    }
}

pub(crate) fn run(run: &mut Run<'_>) {
    let mut list: Option<[Solid; 4]> = None;
    run.family("convex", VECTORS, QUERIES, |number, r, hashes| {
        let Some(map) = shapes(number % 24) else { return };
        if number.is_multiple_of(8) {
            let drawn = [0, 1, 2, 3].map(|key| solid(r, map.origin(), key));
            list = if let [Some(a), Some(b), Some(c), Some(d)] = drawn { Some([a, b, c, d]) } else { list };
        } else if let Some(list) = &mut list {
            ConvexSolid::move_all(list);
        }
        let Some(list) = &list else { return };
        let vector = Vector::draw(number, r, map.origin(), SIZE);
        ask(&map, list, &vector, r, hashes);
    });
}
