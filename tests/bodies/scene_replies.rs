//! What the game replies for a pair: crossing and ignoring change no way, the others are what
//! surfaces would do, and all that is crossed is reported.

use super::steps::{Swept, step_with};
use super::swept::{NOWHERE, PX, ball, body_of, boxed, launch, level, scene, vec2};
use core::num::NonZeroU8;
use tilesat::prelude::*;
use tilesat::scene::{Reply, SceneBody, SceneEvent, Shape};
use tilesat::{Filter, LayerMask, Ratio, Surface, TileMap, Vec2};
use tilesat_judge::{Random, cases};

/// Boxes and circles near each other, slow and fast; some of them do not move.
fn crowd(r: &mut Random, surface: &dyn Fn(&mut Random) -> Surface) -> Vec<SceneBody> {
    (0..r.within(2, 14) as u32)
        .map(|key| {
            let (x, y, size) = (r.within(0, 60 * PX), r.within(0, 40 * PX), r.within(PX, 9 * PX) & !1);
            let shape: Shape = if r.one_in(2) { boxed(x, y, size, size).into() } else { ball(x, y, size / 2).into() };
            let body = SceneBody {
                mass: NonZeroU8::new(r.within(1, 9) as u8),
                surface: surface(r),
                floats: r.one_in(3),
                fast: r.one_in(4),
                ..SceneBody::new(shape, key)
            };
            if r.one_in(6) { SceneBody { mass: None, ..body } } else { SceneBody { velocity: launch(r, size), ..body } }
        })
        .collect()
}

fn any_surface(r: &mut Random) -> Surface {
    Surface::new(Ratio::percent(r.below(101) as u8).unwrap(), Ratio::percent(r.below(101) as u8).unwrap())
}

type Seen = Vec<(SceneBody, bool)>;

/// All that is there after a step, by key.
fn seen(scene: &Swept) -> Seen {
    let mut seen: Seen = scene.bodies().map(|(handle, body)| (*body, scene.is_awake(handle).unwrap())).collect();
    seen.sort_by_key(|body| body.0.key);
    seen
}

fn play(
    bodies: &[SceneBody],
    map: &TileMap<'_>,
    gravity: Vec2,
    reply: Reply,
    mut each: impl FnMut(&Seen, &[(u32, u32, bool)]),
) -> Vec<Seen> {
    let mut scene = scene(bodies);
    (0..40)
        .map(|_| {
            let mut events = Vec::new();
            let before = seen(&scene);
            let key = |handle: tilesat::broad::Handle| bodies[handle.slot()].key;
            step_with(&mut scene, map, gravity, &mut |_| reply, &mut |event| match event {
                SceneEvent::Touch { pair, .. } => events.push((key(pair.a), key(pair.b), true)),
                SceneEvent::Meet { pair, .. } => events.push((key(pair.a), key(pair.b), false)),
                _ => {}
            })
            .unwrap();
            events.sort_unstable();
            each(&before, &events);
            seen(&scene)
        })
        .collect()
}

/// Without other bodies all motions are straight, and so are those of bodies that cross. A step
/// reports what touches at its start, and every body that each fast body meets during its motion.
/// The judge looks at places along both ways, in 128 bits.
#[test]
fn crossing_changes_no_way_and_reports_all() {
    let map = level(NOWHERE);
    let (mut touched, mut met, mut near) = (0, 0, 0);
    for case in 0..cases(300) {
        let mut r = Random::new(31_000 + case);
        let bodies = crowd(&mut r, &any_surface);
        let gravity = vec2(0, [0, 6554][r.below(2) as usize]);
        let alone = LayerMask::NONE;
        let apart: Vec<_> =
            bodies.iter().map(|body| SceneBody { filter: Filter::new(LayerMask::ALL, alone), ..*body }).collect();
        let strip = |all: Vec<Seen>| -> Vec<Seen> {
            let strip = |(body, awake): (SceneBody, bool)| (SceneBody { filter: Filter::default(), ..body }, awake);
            all.into_iter().map(|seen| seen.into_iter().map(strip).collect()).collect()
        };
        let free = strip(play(&apart, &map, gravity, Reply::Meet, |_, events| assert!(events.is_empty())));
        let ignored = play(&bodies, &map, gravity, Reply::Ignore, |_, events| assert!(events.is_empty()));
        assert_eq!(strip(ignored), free, "{case}: ignored");
        let crossed = play(&bodies, &map, gravity, Reply::Cross, |before, events| {
            for (k, (a, awake_a)) in before.iter().enumerate() {
                for (b, awake_b) in &before[k + 1..] {
                    let moves = [(a, awake_a), (b, awake_b)].iter().any(|(_, awake)| **awake);
                    let due = moves && a.shape.touches(&b.shape);
                    assert_eq!(events.contains(&(a.key, b.key, true)), due, "{case}: {a:?} {b:?}");
                    touched += u32::from(due);
                    let told = events.iter().filter(|event| **event == (a.key, b.key, false)).count();
                    match meets(a, *awake_a, b, *awake_b, gravity) {
                        Some(due) => {
                            assert_eq!(told, usize::from(due), "{case}: {a:?} {b:?}");
                            met += u32::from(due);
                        }
                        None => near += 1,
                    }
                }
            }
        });
        assert_eq!(strip(crossed), free, "{case}: crossed");
    }
    println!("{touched} touched, {met} met, {near} too near to tell");
    assert!(touched > 500 && met > 200 && near < met, "{touched} {met} {near}");
}

/// Whether two bodies on straight ways meet on the way of a fast one. `None` where a raw unit
/// decides.
fn meets(a: &SceneBody, awake_a: bool, b: &SceneBody, awake_b: bool, gravity: Vec2) -> Option<bool> {
    let way = |body: &SceneBody, awake: bool| -> (i128, i128) {
        let weight = if body.floats { Vec2::ZERO } else { gravity };
        let (x, y) = if awake && body.mass.is_some() { (body.velocity + weight).raw() } else { (0, 0) };
        (x.into(), y.into())
    };
    let fast = |body: &SceneBody, awake: bool| {
        let ((x, y), (w, h)) = (way(body, awake), body.shape.aabb().size().raw());
        let size = i128::from(w.min(h));
        awake && body.mass.is_some() && (body.fast || 2 * x.abs().max(y.abs()) > size)
    };
    if !fast(a, awake_a) && !fast(b, awake_b) {
        return Some(false);
    }
    if a.shape.overlaps(&b.shape) {
        // It began before.
        return Some(false);
    }
    let (va, vb) = (way(a, awake_a), way(b, awake_b));
    let d = (va.0 - vb.0, va.1 - vb.1);
    // A minus B: a box with round corners, around the origin's way.
    let half = |shape: &Shape| match shape {
        Shape::Aabb(aabb) => {
            let ((x0, y0), (x1, y1)) = (aabb.min().raw(), aabb.max().raw());
            ((i128::from(x0) + i128::from(x1), i128::from(y0) + i128::from(y1)), (x1 - x0, y1 - y0), 0)
        }
        Shape::Circle(circle) => {
            let (x, y) = circle.centre().raw();
            ((2 * i128::from(x), 2 * i128::from(y)), (0, 0), 2 * circle.radius().to_bits())
        }
    };
    let ((p, s, r), (q, t, u)) = (half(&a.shape), half(&b.shape));
    let from = (p.0 - q.0, p.1 - q.1);
    let to = (from.0 + 2 * d.0, from.1 + 2 * d.1);
    let (wide, high, round) = (i128::from(s.0 + t.0), i128::from(s.1 + t.1), i128::from(r) + i128::from(u));
    // In doubled raw units; more or less by two raw units.
    let within = |by: i128| passes(from, to, (wide, high), round + by);
    let (surely, perhaps) = (within(-4), within(4));
    (surely == perhaps).then_some(surely)
}

/// Whether a way comes nearer than `r` to a box around the origin: its ends, the corners' feet, and
/// whether it crosses the box.
fn passes(a: (i128, i128), b: (i128, i128), (w, h): (i128, i128), r: i128) -> bool {
    let (w, h, r) = if r < 0 { (w + r, h + r, 0) } else { (w, h, r) };
    if w < 0 || h < 0 {
        return false;
    }
    let square = |v: (i128, i128)| v.0 * v.0 + v.1 * v.1;
    let off = |q: (i128, i128)| (q.0 - q.0.clamp(-w, w), q.1 - q.1.clamp(-h, h));
    if square(off(a)) < r * r || square(off(b)) < r * r {
        return true;
    }
    let d = (b.0 - a.0, b.1 - a.1);
    let corners = [(-w, -h), (w, -h), (w, h), (-w, h)];
    let foot = |c: &(i128, i128)| {
        let m = (c.0 - a.0, c.1 - a.1);
        let (dot, cross) = (m.0 * d.0 + m.1 * d.1, m.0 * d.1 - m.1 * d.0);
        dot >= 0 && dot <= square(d) && cross * cross < r * r * square(d)
    };
    // Slabs: the part of the way within |x| < w and |y| < h, as fractions.
    let slab = |p: i128, d: i128, w: i128| -> Option<((i128, i128), (i128, i128))> {
        if d == 0 {
            return (p.abs() < w).then_some(((0, 1), (1, 1)));
        }
        let (s, d) = (d.signum(), d.abs());
        Some(((-w - s * p, d), (w - s * p, d)))
    };
    let less = |x: (i128, i128), y: (i128, i128)| x.0 * y.1 < y.0 * x.1;
    let crosses = match (slab(a.0, d.0, w), slab(a.1, d.1, h)) {
        (Some(x), Some(y)) => {
            let from = [x.0, y.0, (0, 1)].into_iter().reduce(|p, q| if less(p, q) { q } else { p }).unwrap();
            let to = [x.1, y.1, (1, 1)].into_iter().reduce(|p, q| if less(p, q) { p } else { q }).unwrap();
            less(from, to)
        }
        _ => false,
    };
    corners.iter().any(foot) || crosses
}

/// A reply is a surface that all have.
#[test]
fn replies_are_surfaces() {
    let map = level(NOWHERE);
    let mut hits = 0;
    for case in 0..cases(300) {
        let seed = 32_000 + case;
        let slick = |r: &mut Random| {
            let _ = any_surface(r);
            Surface::new(Ratio::ZERO, Ratio::ZERO)
        };
        let elastic = |r: &mut Random| {
            let _ = any_surface(r);
            Surface::ELASTIC
        };
        let smooth = |r: &mut Random| Surface::new(any_surface(r).restitution(), Ratio::ZERO);
        for (reply, given, same) in [
            (Reply::Slide, &smooth as &dyn Fn(&mut Random) -> Surface, &slick as &dyn Fn(&mut Random) -> Surface),
            (Reply::Bounce, &any_surface, &elastic),
            (Reply::Meet, &any_surface, &any_surface),
        ] {
            let gravity = vec2(0, [0, 6554][(case % 2) as usize]);
            let (one, other) = (crowd(&mut Random::new(seed), given), crowd(&mut Random::new(seed), same));
            let strip = |all: Vec<Seen>| -> Vec<Seen> {
                let strip = |(body, awake): (SceneBody, bool)| (SceneBody { surface: Surface::SLICK, ..body }, awake);
                all.into_iter().map(|seen| seen.into_iter().map(strip).collect()).collect()
            };
            let by_reply = strip(play(&one, &map, gravity, reply, |_, events| hits += events.len()));
            let by_surface = strip(play(&other, &map, gravity, Reply::Meet, |_, _| {}));
            assert_eq!(by_reply, by_surface, "{case}: {reply:?}");
        }
    }
    assert!(hits > 3_000, "{hits}");
}

/// Two that touch continue as one, and keep their momentum, but for the rounding to whole steps.
#[test]
fn touching_makes_two_one() {
    let map = level(NOWHERE);
    for case in 0..cases(3000) {
        let mut r = Random::new(33_000 + case);
        let masses = [r.within(1, 9), r.within(1, 9)];
        let shapes: [Shape; 2] = if r.one_in(2) {
            [boxed(0, 0, 8 * PX, 8 * PX).into(), ball(12 * PX, r.within(0, 8 * PX), 5 * PX).into()]
        } else {
            [ball(0, 0, 8 * PX).into(), ball(9 * PX, r.around(8 * PX), 5 * PX).into()]
        };
        let velocities = [vec2(r.within(PX / 2, PX), r.around(PX)), vec2(r.around(PX / 4), r.around(PX))];
        let bodies: Vec<_> = (0..2)
            .map(|k| SceneBody {
                velocity: velocities[k],
                mass: NonZeroU8::new(masses[k] as u8),
                floats: true,
                ..SceneBody::new(shapes[k], k as u32)
            })
            .collect();
        let mut pair = scene(&bodies);
        let mut touches = false;
        step_with(&mut pair, &map, Vec2::ZERO, &mut |_| Reply::Touch, &mut |event| {
            if let SceneEvent::Touch { contact: Some(contact), .. } = event {
                touches = contact.axis().dot_vec(velocities[0] - velocities[1]) > 0;
            }
        })
        .unwrap();
        let after = [body_of(&pair, 0).velocity.raw(), body_of(&pair, 1).velocity.raw()];
        if !touches {
            assert_eq!(after, [velocities[0].raw(), velocities[1].raw()], "{case}");
            continue;
        }
        let rest = (after[0].0 - after[1].0).abs().max((after[0].1 - after[1].1).abs());
        assert!(i64::from(rest) <= 2 * (masses[0] + masses[1]), "{case}: {after:?}");
        for axis in 0..2 {
            let of = |v: (i32, i32)| i64::from([v.0, v.1][axis]);
            let momentum = |v: [(i32, i32); 2]| masses[0] * of(v[0]) + masses[1] * of(v[1]);
            assert_eq!(momentum(after), momentum(velocities.map(Vec2::raw)), "{case}");
        }
    }
}
