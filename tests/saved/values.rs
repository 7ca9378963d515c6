//! Values of every kind of state, including unusual ones.

use core::num::NonZeroU8;
use tilesat::broad::{BroadPhase, Exceptions, Ignore, LooseGrid, PairEvents, SortSweep, SpatialHash};
use tilesat::motion::response::{Link, Masses, Particle, Quiet, Stick};
use tilesat::motion::{Acceleration, ByFlags, Carry, Energy, Responses, Speed};
use tilesat::scene::{SceneBody, SceneTag};
use tilesat::shape::AnyShape;
use tilesat::world::ConvexSolid;
use tilesat::{
    Aabb, Axis, Capsule, Character, Circle, ConvexPolygon, Feel, Filter, Fx, Input, LayerMask, Mover, OrientedBox,
    Ratio, Response, Scene, Segment, Side, Solid, Surface, TileKind, TileKinds, TileMap, Toi, Vec2, Walker, fx,
};
use tilesat_judge::Random;
use tilesat_judge::scenes::{BODIES, room};

pub(crate) const EDGE: i32 = (1 << 29) - 1;

/// Some of each kind.
type Shapes = (Vec<Aabb>, Vec<Circle>, Vec<Segment>, Vec<Capsule>, Vec<OrientedBox>, Vec<ConvexPolygon<5>>);

pub(crate) fn shapes() -> Shapes {
    let corner = |x, y| Vec2::from_raw(x, y);
    let aabbs = [(0, 0, 0, 0), (-EDGE, -EDGE, EDGE, EDGE), (-7, 3, -7, 9)];
    let circles = [(0, 0, 0), (0, 0, EDGE), (EDGE, -EDGE, 0), (5, -9, 77_777)];
    let turned = [(0, 0, 0, 0, 1, 0), (9, -9, 60_000, 1, 3, -4), (0, 0, 0, 99_999, -1, 7), (0, 0, 1 << 28, 3, 1, 1)];
    let points = [(0, 0), (90_000, 1), (99_999, 50_000), (40_000, 99_000), (-3, 70_001)].map(|(x, y)| corner(x, y));
    let polygon =
        |n: usize, radius| ConvexPolygon::new(&points[..n]).unwrap().with_radius(Fx::from_bits(radius)).unwrap();
    (
        aabbs.map(|(x, y, u, v)| Aabb::new(corner(x, y), corner(u, v)).unwrap()).into(),
        circles.map(|(x, y, r)| Circle::new(corner(x, y), Fx::from_bits(r)).unwrap()).into(),
        [((3, 4), (3, 4)), ((EDGE, 0), (-EDGE, 1))]
            .map(|(a, b)| Segment::new(corner(a.0, a.1), corner(b.0, b.1)).unwrap())
            .into(),
        vec![Capsule::new(corner(3, 4), corner(-90_000, 4), fx!(0.5)).unwrap()],
        turned.map(|(x, y, w, h, u, v)| OrientedBox::new(corner(x, y), corner(w, h), Axis::new(u, v)).unwrap()).into(),
        vec![polygon(3, 0), polygon(4, 1), polygon(5, 99_999)],
    )
}

/// A hero in the middle of a jump, on a floor, and at a wall.
pub(crate) fn heroes() -> Vec<Character> {
    static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    let level = TileMap::from_ascii("#......#\n#......#\n#......#\n########\n", &KINDS).unwrap();
    let body = Aabb::new(Vec2::from_ints(20, 20), Vec2::from_ints(28, 32)).unwrap();
    let mut hero = Character::new(body, level.bounds(), Feel { wall_jump: Some(fx!(2)), ..Feel::DEFAULT });
    let mut all = vec![hero];
    for frame in 0..90 {
        let run = if frame < 60 { fx!(-1.5) } else { fx!(2) };
        let _ = hero.step(&level, Input { run, jump: frame % 30 > 24, drop: false }).unwrap();
        all.push(hero);
    }
    all
}

pub(crate) fn walker() -> Walker {
    Walker::new(Mover::platformer(Axis::NEG_Y)).with_snap(fx!(3)).unwrap().with_step(fx!(4)).unwrap()
}

pub(crate) fn bouncer() -> Mover<Surface> {
    Mover::platformer(Axis::new(3, -4)).with_response(Response::Bounce).with_slope_limit(2, 1).with_surface(rubber())
}

pub(crate) fn springs() -> Mover<ByFlags> {
    Mover::new().with_responses(Responses::NONE.bouncing(2).touching(4))
}

pub(crate) fn rubber() -> Surface {
    Surface::new(Ratio::HALF, Ratio::percent(30).unwrap())
        .resting_below(fx!(0.5))
        .with_speed(Speed::of(Vec2::from_ints(3, 4)))
}

pub(crate) fn solids() -> Vec<Solid> {
    let shape = Aabb::new(Vec2::from_ints(0, 0), Vec2::from_ints(32, 8)).unwrap();
    let still = Solid::new(shape, 7).unwrap();
    let belt = still.with_one_way(Side::Up).with_flags(9).with_conveyor(Vec2::from_ints(1, 0)).unwrap();
    vec![still, belt.with_motion(Vec2::from_ints(-2, 5)).unwrap()]
}

/// At rest, moving and turning.
pub(crate) fn convex_solids() -> Vec<ConvexSolid<AnyShape<5>>> {
    let bumper = Circle::new(Vec2::from_ints(40, 8), fx!(6)).unwrap();
    let plank = |rise| OrientedBox::new(Vec2::from_ints(9, 40), Vec2::from_ints(20, 2), Axis::new(90, rise)).unwrap();
    let still = |shape: AnyShape<5>, key| ConvexSolid::new(shape, key).unwrap();
    let turns = still(plank(0).into(), 65_535).with_turn(plank(3).into()).unwrap();
    let moves = still(bumper.into(), 7).with_motion(Vec2::from_ints(-2, 5)).unwrap();
    vec![still(bumper.into(), 0), moves.with_flags(9), turns]
}

pub(crate) type Rope = ([Particle; 2], Link, Masses, Acceleration, Carry, Energy, Quiet, Filter, Toi, Ratio);

pub(crate) fn rope() -> Rope {
    let stick = Stick::rope(fx!(8)).unwrap().with_share_of_a(Ratio::ZERO);
    let particle = Particle::moving(Vec2::from_ints(3, 4), Vec2::from_raw(-7, i32::MAX));
    let gravity = Acceleration::new(Vec2::from_raw(-100_003, 77), 60).unwrap();
    let (_, carry) = gravity.act(Vec2::ZERO, Carry::ZERO);
    let filter = Filter::new(LayerMask::layer(3), LayerMask::ALL).with_group(-5).with_sensor(true);
    let energy = Energy::of(Vec2::from_ints(5, 6), Vec2::from_ints(-7, 8), Vec2::from_ints(0, 1));
    (
        [particle, Particle::default()],
        Link { a: 0, b: 1, stick },
        Masses::new(12, 8).unwrap(),
        gravity,
        carry,
        energy,
        Quiet::NOT.watch(&[], fx!(1)),
        filter,
        Toi::ONE,
        Ratio::percent(33).unwrap(),
    )
}

pub(crate) fn lists() -> (PairEvents<8>, Exceptions<4>) {
    let (mut events, mut exceptions) = (PairEvents::new(), Exceptions::new());
    let mut near = SortSweep::<8>::new();
    let at = |x| Aabb::new(Vec2::from_ints(x, 0), Vec2::from_ints(x + 8, 8)).unwrap();
    let all = [0, 4, 8, 30].map(|x| near.insert(&at(x), ()).unwrap());
    for _ in 0..2 {
        near.pairs(|pair| events.feed(pair));
        events.finish(|_| false).unwrap();
        near.move_to(all[3], &at(12)).unwrap();
    }
    exceptions.ignore(all[2], all[0], Ignore::UntilApart).unwrap();
    exceptions.ignore(all[1], all[3], Ignore::Once).unwrap();
    (events, exceptions)
}

pub(crate) type Near = SortSweep<BODIES, SceneTag>;
pub(crate) type Grid = LooseGrid<8, BODIES, SceneTag, true>;
pub(crate) type Hash = SpatialHash<64, BODIES, SceneTag, true>;

pub(crate) fn grid() -> Grid {
    Grid::new(Vec2::ZERO, fx!(16), 16).unwrap()
}

pub(crate) fn hash() -> Hash {
    Hash::new(fx!(16)).unwrap()
}

/// A scene in which some bodies sleep, some fly and some are fixed, with slots that were freed and
/// reused.
pub(crate) fn scene<B: BroadPhase<Tag = SceneTag>>(near: B, seed: u64, frames: u32) -> Scene<B, BODIES> {
    let mut random = Random::new(seed);
    let mut scene = Scene::new(near);
    let mut all = Vec::new();
    for key in 0..BODIES as u32 {
        let at = Vec2::from_ints(18 + random.below(140) as i16, random.below(50) as i16);
        let (size, mass) = (2 + random.below(5) as i16, NonZeroU8::new(random.below(4) as u8));
        let body = match key % 3 {
            0 => SceneBody::new(Circle::new(at, Fx::from_num(size)).unwrap(), key),
            _ => SceneBody::new(Aabb::new(at, at + Vec2::from_ints(size, 3)).unwrap(), key),
        };
        let velocity = Vec2::from_raw(random.within(-99_999, 99_999) as i32, 0);
        all.push(scene.insert(&SceneBody { mass, velocity, surface: rubber(), floats: key % 7 == 0, ..body }).unwrap());
    }
    let map = room();
    for frame in 0..frames {
        scene.step(&map, Vec2::from_raw(0, 6554), |_| {}).unwrap();
        if frame % 5 == 0 && frame < 30 {
            let handle = all.swap_remove(random.below(all.len() as i64) as usize);
            let body = scene.remove(handle).unwrap();
            if frame % 2 == 0 {
                all.push(scene.insert(&body).unwrap());
            }
        }
    }
    scene
}
