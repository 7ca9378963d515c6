//! The level for a body of a scene: responses by flags, a level per body, and the speed of a hit.

use super::steps::step_in;
use super::swept::{ball, body_of, boxed, scene, vec2};
use tilesat::motion::{Response, Responses};
use tilesat::scene::{SceneBody, SceneEvent, Shape};
use tilesat::world::Trail;
use tilesat::{Axis, Fx, Ratio, Surface, TileKind, TileKinds, TileMap, Vec2};
use tilesat_judge::{Random, cases};

const GLUE: u8 = 1;
const GRASS: u8 = 2;
const CURTAIN: u8 = 4;

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'g', TileKind::FULL.with_flags(GLUE))
    .with(b'~', TileKind::FULL.with_flags(GRASS))
    .with(b'c', TileKind::FULL.with_flags(CURTAIN));
static GHOSTS: TileKinds = KINDS.passing(CURTAIN);

/// The approach speed against its definition, `-(v . n) / |n|` to nearest, in 128 bits. First small
/// normals and velocities exhaustively, then those at the ends of the ranges.
#[test]
fn approach_is_the_nearest() {
    let check = |n: (i32, i32), v: (i32, i32)| {
        let s = Axis::new(n.0, n.1).approach(Vec2::from_raw(v.0, v.1)).to_bits();
        let d = -(i128::from(n.0) * i128::from(v.0) + i128::from(n.1) * i128::from(v.1));
        let square = i128::from(n.0).pow(2) + i128::from(n.1).pow(2);
        if d <= 0 {
            assert_eq!(s, 0, "{n:?} {v:?}");
        } else if s == i32::MAX && 4 * d * d >= ((1_i128 << 31) - 1).pow(2) * square {
            // It rounds to 2^30 raw or more. No motion is that large.
        } else {
            let s = i128::from(s);
            let (below, above) = ((2 * s - 1).max(0), 2 * s + 1);
            assert!(below * below * square <= 4 * d * d && 4 * d * d < above * above * square, "{n:?} {v:?}: {s}");
        }
    };
    for k in 0..15_i32.pow(4) {
        let c = |k: i32| k % 15 - 7;
        check((c(k), c(k / 15)), (c(k / 225), c(k / 3375)));
    }
    let ends = [0, 1, -1, 2, 3, -5, (1 << 28) - 1, 1 - (1 << 28), (1 << 30) - 1, 1 - (1 << 30), 46341, -65536];
    for k in 0..12_usize.pow(4) {
        check((ends[k % 12], ends[k / 12 % 12]), (ends[k / 144 % 12], ends[k / 1728]));
    }
    let mut r = Random::new(7);
    for _ in 0..cases(200_000) {
        // Nearly along the surface, where the rounding error is greatest.
        let v = (r.around(1 << 28) as i32, r.around(1 << 28) as i32);
        check((v.1 + r.around(3) as i32, -v.0 + r.around(3) as i32), v);
    }
    assert_eq!(Axis::new(0, 0).approach(Vec2::from_ints(1, 1)), Fx::ZERO);
    assert_eq!(Axis::new(0, -1).approach(Vec2::from_raw(0, i32::MAX)), Fx::MAX);
}

/// A body that does not move, two units to the left of one: a fast body sweeps only in company.
fn neighbour(of: &SceneBody) -> SceneBody {
    let at = of.shape.aabb().min();
    let (x, y) = at.raw();
    SceneBody::fixed(ball(i64::from(x) - (3 << 16), i64::from(y), 1 << 16), 100)
}

/// A rubber ball over floors of four kinds, slow and fast. All land at one speed.
#[test]
fn a_body_has_its_own_responses() {
    let map = TileMap::from_ascii("................\n................\n####gggg~~~~####", &KINDS).unwrap();
    let rubber = Surface::new(Ratio::ONE, Ratio::ZERO);
    for (fast, speed) in [(false, 3), (true, 3), (false, 40), (true, 40)] {
        let body = |at: i64, responses| SceneBody {
            velocity: Vec2::from_ints(1, speed),
            surface: rubber,
            floats: true,
            fast,
            responses,
            ..SceneBody::new(ball((at * 64 + 30) << 16, 27 << 16, 4 << 16), at as u32)
        };
        let own = Responses::NONE.touching(GLUE).sliding(GRASS);
        let bodies = [body(0, own), body(1, own), body(2, own), body(1, Responses::NONE), body(2, Responses::NONE)];
        let expected = [(1, -speed), (0, 0), (1, 0), (1, -speed), (1, -speed)];
        for (body, (x, y)) in bodies.iter().zip(expected) {
            let mut scene = scene(&[*body, neighbour(body)]);
            let mut told = Vec::new();
            let stepped = scene.step(&map, Vec2::ZERO, |event| {
                if let SceneEvent::Level { hits, velocity, .. } = event {
                    told.extend(hits.iter().map(|hit| (velocity, hit.approach(velocity))));
                }
            });
            assert_eq!(stepped.unwrap().held, 0);
            assert_eq!(told, [(body.velocity, Fx::from_num(speed))], "{body:?}");
            assert_eq!(body_of(&scene, body.key).velocity, Vec2::from_ints(x, y), "{body:?}");
        }
    }
}

/// A bullet hits the floor before an enemy behind it. It reaches the enemy only if it slides.
#[test]
fn a_bullet_that_touches_stops_at_a_wall() {
    let map = TileMap::from_ascii("........\n........\n########", &KINDS).unwrap();
    for (responses, is_met) in [(Responses::NONE, true), (Responses::NONE.otherwise(Response::Touch), false)] {
        let enemy = SceneBody::fixed(ball(74 << 16, 27 << 16, 5 << 16), 2);
        let bullet = SceneBody {
            velocity: Vec2::from_ints(20, 8),
            floats: true,
            responses,
            ..SceneBody::new(ball(52 << 16, 28 << 16, 3 << 15), 1)
        };
        let (mut scene, mut hits, mut met) = (scene(&[bullet, enemy]), 0, false);
        let stepped = scene.step(&map, Vec2::ZERO, |event| match event {
            SceneEvent::Level { .. } => hits += 1,
            SceneEvent::Meet { .. } => met = true,
            _ => {}
        });
        assert_eq!((stepped.unwrap().held, hits > 0, met), (0, true, is_met));
        assert!(is_met || hits == 1, "{hits}");
        assert_eq!(body_of(&scene, 1).velocity == Vec2::ZERO, !is_met);
    }
}

/// The gravity of a step is part of the speed with which a body hits.
#[test]
fn a_hit_has_the_speed_of_the_step() {
    let map = TileMap::from_ascii("....\n....\n####", &KINDS).unwrap();
    for fast in [false, true] {
        let body = SceneBody { fast, ..SceneBody::new(boxed(8 << 16, 22 << 16, 8 << 16, 8 << 16), 1) };
        let mut scene = scene(&[SceneBody { velocity: vec2(0, 5 << 16), ..body }, neighbour(&body)]);
        let mut told = Vec::new();
        let gravity = vec2(0, 1 << 14);
        scene
            .step(&map, gravity, |event| {
                if let SceneEvent::Level { velocity, .. } = event {
                    told.push(velocity);
                }
            })
            .unwrap();
        assert_eq!(told, [vec2(0, (5 << 16) + (1 << 14))]);
    }
}

/// Through a curtain or up to it, slow and fast.
#[test]
fn ghosts_pass_curtains() {
    let rows = "......c.\n......c.";
    let (level, ghosts) = (TileMap::from_ascii(rows, &KINDS).unwrap(), TileMap::from_ascii(rows, &GHOSTS).unwrap());
    for (speed, fast) in [(3, false), (3, true), (30, false), (60, true)] {
        for (key, x) in [(1, 92 + speed), (2, 92)] {
            let body = SceneBody { fast, ..SceneBody::new(ball(92 << 16, 16 << 16, 4 << 16), key) };
            let body = SceneBody { velocity: Vec2::from_ints(speed, 0), ..body };
            let mut scene = scene(&[body, neighbour(&body)]);
            let level_of = |body: &SceneBody| if body.key == 1 { &ghosts } else { &level };
            step_in(&mut scene, &level_of, Vec2::ZERO, true);
            let at = body_of(&scene, key).shape.position();
            assert_eq!(at, Vec2::from_ints(x, 16), "{speed} {fast} {key}");
        }
    }
}

/// With one level for all, `step_in` is `step`. With two, each body moves as it does alone in its
/// own level.
#[test]
fn each_body_sees_its_level() {
    let rows = "################\n#.....c....c...#\n#.....c....c...#\n#..ccc.........#\n################";
    let (level, ghosts) = (TileMap::from_ascii(rows, &KINDS).unwrap(), TileMap::from_ascii(rows, &GHOSTS).unwrap());
    let gravity = vec2(0, 1 << 14);
    let mut r = Random::new(22);
    let (mut same, mut parted) = (0, 0);
    for _ in 0..cases(300) {
        let bodies: Vec<_> = (0..4)
            .map(|key| {
                let at = (r.within(20, 60) + 44 * i64::from(key), r.within(20, 40));
                let shape = ball(at.0 << 16, at.1 << 16, r.within(2, 4) << 16);
                let velocity = vec2(r.around(20 << 16), r.around(20 << 16));
                SceneBody { velocity, fast: r.one_in(2), ..SceneBody::new(shape, key) }
            })
            .filter(|body| matches!(body.shape, Shape::Circle(c) if !level.overlaps(&c)))
            .collect();
        let (mut a, mut b) = (scene(&bodies), scene(&bodies));
        for _ in 0..20 {
            let one = a.step(&level, gravity, |_| ()).unwrap();
            assert_eq!(one, step_in(&mut b, &|_| &level, gravity, true));
            assert_eq!(a.snapshot(), b.snapshot());
            same += 1;
        }
        let is_ghost = |body: &SceneBody| body.key % 2 == 1;
        let level_of = |body: &SceneBody| if is_ghost(body) { &ghosts } else { &level };
        let mut both = scene(&bodies);
        let mut alone: Vec<_> = bodies.iter().map(|body| scene(std::slice::from_ref(body))).collect();
        for _ in 0..20 {
            // Bodies that meet nobody: no pair counts.
            step_in(&mut both, &level_of, gravity, false);
            for (alone, body) in alone.iter_mut().zip(&bodies) {
                alone.step(level_of(body), gravity, |_| ()).unwrap();
                assert_eq!(body_of(alone, body.key), body_of(&both, body.key));
            }
        }
        parted += bodies.iter().filter(|body| is_ghost(body)).count();
    }
    assert!(same > 1000 && parted > 100);
}

/// `step_along` is `step_in`, and its ways lead each body from where it was to where it is, one
/// after another, through nothing solid. The tiles on them are those that a body touches at close
/// range along the way.
#[test]
fn each_way_is_told() {
    let rows = "################\n#.....c....c...#\n#.....c....c...#\n#..ccc.........#\n################";
    let (level, ghosts) = (TileMap::from_ascii(rows, &KINDS).unwrap(), TileMap::from_ascii(rows, &GHOSTS).unwrap());
    let mut r = Random::new(23);
    let (mut ways, mut bent, mut several, mut crossed) = (0, 0, 0, 0);
    for case in 0..cases(300) {
        let rubber = Surface::new(Ratio::HALF, Ratio::ZERO);
        let bodies: Vec<_> = (0..6)
            .map(|key| {
                let (x, y, size) = (r.within(20, 210) << 16, r.within(18, 44) << 16, r.within(2, 4) << 16);
                let shape: Shape =
                    if r.one_in(2) { ball(x, y, size).into() } else { boxed(x, y, 2 * size, size).into() };
                let velocity = vec2(r.around(30 << 16), r.around(20 << 16));
                let mass = (!r.one_in(8)).then_some(core::num::NonZeroU8::MIN);
                SceneBody { velocity, mass, surface: rubber, fast: r.one_in(3), ..SceneBody::new(shape, key) }
            })
            .filter(|body| !body.shape.overlaps_level(&level))
            .collect();
        let gravity = if case % 3 == 0 { Vec2::ZERO } else { vec2(0, 1 << 14) };
        let level_of = |body: &SceneBody| if body.key % 2 == 1 { &ghosts } else { &level };
        let (mut plain, mut told) = (scene(&bodies), scene(&bodies));
        for _ in 0..40 {
            let mut at: Vec<_> = told.bodies().map(|(handle, body)| (handle, *body, 0)).collect();
            let stepped = step_in(&mut plain, &level_of, gravity, true);
            let passed = |handle, shape: &Shape, trail: &Trail| {
                let it = at.iter_mut().find(|(other, ..)| *other == handle).unwrap();
                assert_eq!(*shape, it.1.shape, "a way begins elsewhere");
                (it.2, ways) = (it.2 + 1, ways + 1);
                bent += usize::from(trail.parts().count() > 1);
                let of = level_of(&it.1);
                let listed: Vec<_> = of.tiles_on(shape, trail).unwrap().map(|tile| tile.cell).collect();
                crossed += of.tiles_on(shape, trail).unwrap().filter(|tile| tile.kind.flag(CURTAIN)).count();
                for (from, by) in trail.parts() {
                    for part in 0..=8 {
                        let (x, y) = by.raw();
                        let on_it = from + Vec2::from_raw(x / 8 * part, y / 8 * part);
                        let here: Shape = match shape {
                            Shape::Aabb(it) => it.translated(on_it).unwrap().into(),
                            Shape::Circle(it) => it.translated(on_it).unwrap().into(),
                        };
                        // Beside a surface a rounded point may be a raw unit in it.
                        let near = of.tiles_in(&here.aabb());
                        let inner = near.filter(|tile| {
                            let cell = (i32::from(tile.cell.x) << 20, i32::from(tile.cell.y) << 20);
                            let (lo, hi) = (here.aabb().min().raw(), here.aabb().max().raw());
                            let covers = |lo: i32, hi: i32, cell: i32| lo < cell + (1 << 20) - 8 && cell + 8 < hi;
                            matches!(here, Shape::Aabb(_)) && covers(lo.0, hi.0, cell.0) && covers(lo.1, hi.1, cell.1)
                        });
                        assert!(inner.map(|tile| tile.cell).all(|cell| listed.contains(&cell)), "a tile is left out");
                    }
                }
                let end = trail.parts().fold(Vec2::ZERO, |_, (from, by)| from + by);
                it.1.shape = match it.1.shape {
                    Shape::Aabb(it) => it.translated(end).unwrap().into(),
                    Shape::Circle(it) => it.translated(end).unwrap().into(),
                };
            };
            assert_eq!(told.step_along(level_of, gravity, |_| true, |_| (), passed).unwrap(), stepped);
            assert_eq!(told.snapshot(), plain.snapshot());
            for (handle, body, count) in at {
                assert_eq!(told.body(handle).unwrap().shape, body.shape, "a way is left out");
                several += usize::from(count > 1);
            }
        }
    }
    println!("{ways} ways, {bent} bent, {several} of several, {crossed} curtains");
    assert!(ways > 10_000 && bent > 500 && several > 500 && crossed > 500, "{ways} {bent} {several} {crossed}");
}
