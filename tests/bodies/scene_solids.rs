//! Moving solids of a scene carry, push and squash bodies of all shapes. Bullets hit them, and so
//! oriented boxes and polygons that are bodies.
//!
//! The judge of positions is the exact sum of two convex shapes.

use tilesat::broad::{BroadPhase, SortSweep, SpatialHash};
use tilesat::motion::Ride;
use tilesat::scene::{BodyShape, SceneBody, SceneEvent, SceneTag, Shape, Sleep};
use tilesat::world::{ConvexSolid, ConvexSolids};
use tilesat::{
    Aabb, AllShapes, Capsule, ConvexPolygon, Fx, Joined, Ratio, Scene, Solid, Solids, Surface, TileMap, Vec2,
};
use tilesat_judge::convex::shape::MOST;
use tilesat_judge::scenes::BODIES;
use tilesat_judge::solids::convex::polygons;
use tilesat_judge::solids::shapes::{Any, Figure, Rider, Solid as Convex, plank, shape, show, steer};
use tilesat_judge::solids::ticks::{CELL, FOLLOW, MOVER, balls, boxes, capsules, grid, tiles};
use tilesat_judge::solids::twins::KINDS;
use tilesat_judge::solids::{P, disc, raw, rect, vec2};
use tilesat_judge::{Random, cases, frames};

const FILLED: u32 = 12;
type Sorted<S> = Scene<SortSweep<BODIES, SceneTag>, BODIES, 0, S>;
type Hashed<S> = Scene<SpatialHash<64, BODIES, SceneTag>, BODIES, 0, S>;

fn follow() -> Fx {
    Fx::from_bits(FOLLOW as i32)
}

fn open() -> TileMap<'static, AllShapes> {
    TileMap::<AllShapes>::of(&[0; 36], grid((0, 0)), &KINDS).unwrap()
}

/// A body of each kind.
fn any(r: &mut Random) -> Any {
    match r.below(4) {
        0 => boxes(r).any(),
        1 => balls(r).any(),
        2 => capsules(r).any(),
        _ => polygons(r).any(),
    }
}

/// All bodies by their keys.
fn all<B: BroadPhase<Tag = SceneTag>, S: BodyShape>(scene: &Scene<B, BODIES, 0, S>) -> Vec<SceneBody<S>> {
    let mut all: Vec<_> = scene.bodies().map(|(_, body)| *body).collect();
    all.sort_by_key(|body| body.key);
    all
}

#[derive(Debug, Default)]
struct Seen {
    carried: u32,
    pushed: u32,
    squashed: u32,
    /// Moved by what they lie on.
    taken: u32,
    pushed_along: u32,
    steps: u32,
}

fn play(kinds: i64, seed: u64, seen: &mut Seen) {
    let mut r = Random::new(seed);
    let gravity = vec2((0, CELL / 32));
    for _ in 0..cases(100) {
        let tiles = if kinds == 0 { vec![0; 36] } else { tiles(&mut r, kinds) };
        let level = TileMap::<AllShapes>::of(&tiles, grid((0, 0)), &KINDS).unwrap();
        let mut list: Vec<Convex> =
            (0..r.within(1, 4)).map(|key| Convex::new(shape(&mut r), (key * 7 % 6) as u16).unwrap()).collect();
        let mut one = Sorted::<Any>::new(SortSweep::new());
        let mut two = Hashed::<Any>::new(SpatialHash::new(Fx::from_bits(8 * CELL as i32)).unwrap());
        let mut bodies = Vec::new();
        for key in 0..FILLED {
            let body = any(&mut r);
            if !Joined::new(&level, &ConvexSolids::new(&list)).overlaps(&body) {
                bodies.push(SceneBody::<Any>::of(body, key));
            }
        }
        for body in &bodies {
            assert!(one.insert(body).is_ok());
        }
        r.shuffle(&mut bodies);
        for body in &bodies {
            assert!(two.insert(body).is_ok());
        }
        for _ in 0..30 {
            steer(&mut list, &mut r);
            let (before, mut told) = (all(&one), Vec::new());
            let mut other = list.clone();
            r.shuffle(&mut other);
            let solids = list.clone();
            one.ride(&level, &mut list, gravity, follow(), |body, ride| told.push((body, ride.unwrap()))).unwrap();
            two.ride(&level, &mut other, gravity, follow(), |_, ride| assert!(ride.is_ok())).unwrap();
            let told: Vec<_> = told.iter().map(|(at, ride)| (one.body(*at).unwrap().key, *ride)).collect();
            let after = all(&one);
            assert_eq!(after, all(&two), "shuffled");
            let moved = ConvexSolids::new(&list);
            let moved = Joined::new(&level, &moved);
            let rides = before.iter().map(|b| MOVER.ride_convex(&level, &solids, &b.shape, follow()).unwrap());
            let ways: Vec<_> = rides.filter(|it| it.ride == Ride::Carried).map(|it| it.motion).collect();
            for (from, to) in before.iter().zip(&after) {
                let case = || format!("{from:?}\n{to:?}\n{}", show(&solids));
                let ridden = MOVER.ride_convex(&level, &solids, &from.shape, follow()).unwrap();
                let ride = told.iter().find(|(key, _)| *key == from.key).map_or(Ride::Free, |(_, ride)| *ride);
                // A solid that stands carries a body nowhere.
                let stays = ridden.ride == Ride::Carried && ridden.motion == Vec2::ZERO;
                assert!(ride == ridden.ride || (ride == Ride::Free && stays), "{ridden:?}: {}", case());
                let squashed = matches!(ride, Ride::Squashed { .. });
                let figure = Figure::of(&to.shape);
                assert!(!level.overlaps(&to.shape), "in the level: {}", case());
                assert!(squashed || !list.iter().any(|s| figure.meets(&Figure::of(&s.shape()))), "in: {}", case());
                match ride {
                    Ride::Free => seen.taken += u32::from(from.shape != to.shape),
                    // After the push it goes with the one that it lies on, as far as it can.
                    Ride::Pushed { .. } if to.shape != ridden.body => {
                        let along = |way| MOVER.move_and_slide(&moved, &ridden.body, way - ridden.motion);
                        assert!(ways.iter().any(|way| along(*way).unwrap().body == to.shape), "{}", case());
                        seen.pushed_along += 1;
                    }
                    _ => assert_eq!(to.shape, ridden.body, "{}", case()),
                }
                seen.carried += u32::from(ride == Ride::Carried);
                seen.pushed += u32::from(matches!(ride, Ride::Pushed { .. }));
                if squashed {
                    seen.squashed += 1;
                    for handle in one.bodies().filter(|(_, b)| b.key == from.key).map(|b| b.0).collect::<Vec<_>>() {
                        one.remove(handle).unwrap();
                    }
                    for handle in two.bodies().filter(|(_, b)| b.key == from.key).map(|b| b.0).collect::<Vec<_>>() {
                        two.remove(handle).unwrap();
                    }
                }
            }
            let here = ConvexSolids::new(&list);
            let joined = Joined::new(&level, &here);
            let stepped =
                one.step(&joined, gravity, |event| assert!(!matches!(event, SceneEvent::Held { .. }))).unwrap();
            assert_eq!(two.step(&joined, gravity, |_| {}).unwrap().moved, stepped.moved);
            assert_eq!(all(&one), all(&two), "shuffled");
            for body in all(&one) {
                let figure = Figure::of(&body.shape);
                assert!(!joined.overlaps(&body.shape), "{body:?}\n{}", show(&list));
                assert!(!list.iter().any(|s| figure.meets(&Figure::of(&s.shape()))), "{body:?}\n{}", show(&list));
                seen.steps += 1;
            }
            let far: Vec<_> = one.bodies().filter(|(_, b)| raw(b.shape.aabb().min()).1 > 40 * CELL).collect();
            if !far.is_empty() {
                break;
            }
        }
    }
    println!("{seen:?}");
    assert!(
        seen.carried.min(seen.pushed) > 100 && seen.squashed.min(seen.taken).min(seen.pushed_along) > 0,
        "{seen:?}"
    );
}

#[test]
fn bodies_of_all_shapes_ride_in_the_open() {
    play(0, 491, &mut Seen::default());
}

#[test]
fn bodies_of_all_shapes_ride_among_tiles() {
    play(37, 492, &mut Seen::default());
}

/// Boxes as plain solids and as convex ones carry and push a scene of boxes to the same bits.
#[test]
fn plain_solids_are_convex_ones() {
    let (mut r, mut seen) = (Random::new(493), 0);
    let (level, gravity) = (open(), vec2((0, CELL / 32)));
    for _ in 0..cases(100) {
        let at: Vec<Aabb> = (0..r.within(1, 3)).map(|_| boxes(&mut r)).collect();
        let mut plain: Vec<_> = at.iter().zip(1..).map(|(b, key)| Solid::new(*b, key).unwrap()).collect();
        let mut convex: Vec<_> = at.iter().zip(1..).map(|(b, key)| ConvexSolid::new(*b, key).unwrap()).collect();
        let (mut one, mut two) = (Sorted::<Shape>::new(SortSweep::new()), Sorted::<Shape>::new(SortSweep::new()));
        for key in 0..FILLED {
            let body = SceneBody::new(boxes(&mut r), key);
            if !Joined::new(&level, &Solids::new(&plain)).overlaps(&body.shape.aabb()) {
                let _ = (one.insert(&body).unwrap(), two.insert(&body).unwrap());
            }
        }
        'ticks: for _ in 0..40 {
            for (a, b) in plain.iter_mut().zip(&mut convex) {
                let m = vec2((r.around(CELL / 8), r.around(CELL / 8)));
                (*a, *b) = (a.with_motion(m).unwrap(), b.with_motion(m).unwrap());
            }
            let mut squashed = false;
            let mut tell = |ride: Ride| {
                squashed |= matches!(ride, Ride::Squashed { .. });
                seen += u32::from(ride != Ride::Free);
            };
            one.ride(&level, &mut plain, gravity, follow(), |_, ride| tell(ride.unwrap())).unwrap();
            two.ride(&level, &mut convex, gravity, follow(), |_, ride| tell(ride.unwrap())).unwrap();
            if squashed {
                break 'ticks;
            }
            assert_eq!(all(&one), all(&two), "{plain:?}");
            one.step(&Joined::new(&level, &Solids::new(&plain)), gravity, |_| {}).unwrap();
            two.step(&Joined::new(&level, &ConvexSolids::new(&convex)), gravity, |_| {}).unwrap();
            assert_eq!(all(&one), all(&two), "{plain:?}");
        }
    }
    println!("{seen} rides");
    assert!(seen > 500);
}

/// A pile of boxes, an oriented box, a lying capsule and a polygon on a lift that moves and stops.
/// Each goes by exactly the motion of the lift. Asleep, they go with its first motion.
#[test]
fn a_pile_rests_on_a_lift() {
    let mut r = Random::new(494);
    let (level, gravity) = (open(), vec2((0, CELL / 40)));
    for sleeps in [false, true] {
        let mut lift = [Convex::new(rect((-8 * CELL, 0), (8 * CELL, CELL)).into(), 9).unwrap()];
        let sleep = if sleeps { Sleep::default() } else { Sleep::NEVER };
        let mut scene = Sorted::<Any>::with_sleep(SortSweep::new(), sleep);
        let middle = |y: i64| (0, -y * CELL);
        let wide = |y: i64| Any::from(rect((-2 * CELL, -(y + 1) * CELL), (2 * CELL, -y * CELL)));
        let lying = Capsule::new(vec2((-CELL, -3 * CELL)), vec2((CELL, -3 * CELL)), Fx::from_bits(CELL as i32 / 2));
        let house = [(-CELL, 0), (CELL, 0), (CELL, -CELL), (0, -2 * CELL), (-CELL, -CELL)];
        let house = ConvexPolygon::<MOST>::new(&house.map(|p| vec2((p.0, p.1 - 5 * CELL)))).unwrap();
        let bodies =
            [wide(0), plank(middle(2), (CELL / 2, CELL / 4), (3, 4)), lying.unwrap().into(), wide(4), house.into()];
        let handles: Vec<_> =
            bodies.iter().zip(0..).map(|(b, key)| scene.insert(&SceneBody::of(*b, key)).unwrap()).collect();
        let step = |scene: &mut Sorted<Any>, lift: &[Convex; 1]| {
            scene.step(&Joined::new(&level, &ConvexSolids::new(lift)), gravity, |_| {}).unwrap()
        };
        for _ in 0..400 {
            let _ = step(&mut scene, &lift);
        }
        assert_eq!(scene.awake().is_empty(), sleeps);
        let relative = |scene: &Sorted<Any>, at: P| -> Vec<_> {
            let back = |body: &SceneBody<Any>| (body.shape.translated(vec2((-at.0, -at.1))).unwrap(), body.velocity);
            handles.iter().map(|&handle| back(scene.body(handle).unwrap())).collect()
        };
        let (rest, mut at) = (relative(&scene, (0, 0)), (0, 0));
        let mut m = (CELL / 16, -CELL / 16);
        for frame in 0..frames(1_000) {
            if frame > 0 && r.one_in(20) {
                m = if r.one_in(3) { (0, 0) } else { (r.around(CELL / 4), r.around(CELL / 4)) };
                m = (if at.0 * m.0 > 0 { -m.0 } else { m.0 }, if at.1 * m.1 > 0 { -m.1 } else { m.1 });
            }
            lift[0] = lift[0].with_motion(vec2(m)).unwrap();
            scene
                .ride(&level, &mut lift, gravity, Fx::from_bits(CELL as i32), |_, ride| {
                    assert_eq!(ride, Ok(Ride::Carried));
                })
                .unwrap();
            at = (at.0 + m.0, at.1 + m.1);
            assert_eq!(relative(&scene, at), rest, "{frame}: carried by {m:?}");
            let _ = step(&mut scene, &lift);
            assert_eq!(relative(&scene, at), rest, "{frame}: stepped after {m:?}");
        }
    }
}

/// The walls of a room, turned by 3 : 4, a unit thick; 200 units wide inside.
fn walls(c: P) -> Vec<Any> {
    const PX: i64 = 1 << 16;
    let corner = |k: usize, size: i64| {
        // Of length 5.
        let (along, across) = ((3, 4), (-4, 3));
        let (a, b) = [(1, 1), (-1, 1), (-1, -1), (1, -1)][k % 4];
        vec2((c.0 + (a * along.0 + b * across.0) * size * PX / 5, c.1 + (a * along.1 + b * across.1) * size * PX / 5))
    };
    let wall = |k: usize| [corner(k, 100), corner(k + 1, 100), corner(k + 1, 105), corner(k, 105)];
    (0..4).map(|k| ConvexPolygon::hull(&wall(k)).unwrap().into()).collect()
}

fn is_in_room(c: P, body: &Any) -> bool {
    let Figure { points, radius } = Figure::of(body);
    points.iter().all(|p| {
        let (x, y) = (p.0 - c.0, p.1 - c.1);
        (3 * x + 4 * y).abs().max((4 * x - 3 * y).abs()) <= 5 * ((100 << 16) - radius)
    })
}

fn bullet(r: &mut Random, key: u32) -> SceneBody<Any> {
    let (c, size) = ((r.around(60 << 16), r.around(60 << 16)), r.within(1 << 14, 4 << 16));
    let shape = match r.below(3) {
        0 => Any::from(disc(c, size)),
        1 => rect(c, (c.0 + size, c.1 + size / 2 + 1)).into(),
        _ => plank(c, (size, size / 2 + 1), (r.around(9) | 1, r.around(9))),
    };
    let velocity = vec2((r.around(300 << 16), r.around(300 << 16)));
    let surface = Surface::new(Ratio::ONE, Ratio::ZERO);
    SceneBody { velocity, surface, floats: true, ..SceneBody::of(shape, key) }
}

/// Bullets bounce in a room whose walls are solids that move. None leaves it.
#[test]
fn bullets_hit_moving_walls() {
    let (mut r, mut hits) = (Random::new(495), 0);
    let level = open();
    for _ in 0..cases(tilesat_judge::thorough(6, 20)) {
        let mut scene = Sorted::<Any>::new(SortSweep::new());
        (0..8).for_each(|key| assert!(scene.insert(&bullet(&mut r, key)).is_ok()));
        let mut list: Vec<_> = walls((0, 0)).iter().zip(1..).map(|(s, key)| Convex::new(*s, key).unwrap()).collect();
        let mut at = (0, 0);
        for frame in 0..100 {
            let m = (r.around(6 << 16), r.around(6 << 16));
            for wall in &mut list {
                *wall = wall.with_motion(vec2(m)).unwrap();
            }
            scene
                .ride(&level, &mut list, Vec2::ZERO, Fx::ZERO, |_, ride| {
                    assert!(matches!(ride, Ok(Ride::Pushed { .. })), "{ride:?}");
                })
                .unwrap();
            at = (at.0 + m.0, at.1 + m.1);
            let joined = ConvexSolids::new(&list);
            scene
                .step(&Joined::new(&level, &joined), Vec2::ZERO, |event| match event {
                    SceneEvent::Level { hits: met, .. } => {
                        assert!(met.iter().all(|hit| matches!(hit.solid(), Some(1..=4))));
                        hits += 1;
                    }
                    SceneEvent::Held { fault, .. } => panic!("{fault}"),
                    _ => {}
                })
                .unwrap();
            for body in all(&scene) {
                assert!(is_in_room(at, &body.shape), "{frame}: {body:?} left {at:?}");
            }
        }
    }
    println!("{hits} hits");
    assert!(hits > 1000);
}

/// The same with walls that are fixed bodies of the scene.
#[test]
fn bullets_hit_turned_bodies() {
    let (mut r, mut met) = (Random::new(496), 0);
    let level = open();
    for _ in 0..cases(20) {
        let mut scene = Sorted::<Any>::new(SortSweep::new());
        for (wall, key) in walls((0, 0)).iter().zip(100..) {
            scene.insert(&SceneBody { mass: None, surface: Surface::ELASTIC, ..SceneBody::of(*wall, key) }).unwrap();
        }
        (0..8).for_each(|key| assert!(scene.insert(&bullet(&mut r, key)).is_ok()));
        for frame in 0..100 {
            scene.step(&level, Vec2::ZERO, |event| met += u32::from(matches!(event, SceneEvent::Meet { .. }))).unwrap();
            for body in all(&scene).iter().filter(|body| body.key < 100) {
                // A body that lies between two others may be pressed into a wall.
                let c = body.shape.aabb().centre();
                assert!(is_in_room((0, 0), &disc(raw(c), 0).into()), "{frame}: {body:?} left");
            }
        }
    }
    println!("{met} hits");
    assert!(met > 1000);
}
