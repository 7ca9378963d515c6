//! All 34 tile shapes: torture scene 42, and P10 to P12, P16, P20 and P25 in rooms of all of them.
//!
//! `TILESAT_CASES` sets the number of motions per test (default 6 000).

use tilesat::{Aabb, AllShapes, Circle, Fx, Inside, Mover, Outside, Response, TileMap, world::RayRules};
use tilesat_judge::Random;
use tilesat_judge::drawing;
use tilesat_judge::drawing::{VIEWS, mover, place};
use tilesat_judge::rooms::body::{Body, point, vec2};
use tilesat_judge::rooms::room::{FINE, Room};
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX, len2, mosaic};
use tilesat_judge::shapes::level::Level;

fn cases() -> u64 {
    tilesat_judge::cases(6_000)
}

fn circle(body: Body) -> Circle {
    let Body::Disc(c, r) = body else { panic!("a circle is needed") };
    Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap()
}

fn overlaps(map: &TileMap<'_, AllShapes>, body: Body) -> bool {
    match body {
        Body::Disc(..) => map.overlaps(&circle(body)),
        Body::Pill(p, core, r) => map.overlaps(&Body::capsule(p, core, r)),
        Body::Rect(..) => map.overlaps(&Aabb::new(vec2(body.bounds().0), vec2(body.bounds().1)).unwrap()),
    }
}

/// Scene 42: each shape with each neighbour, beside and below (so above and to the left too), and
/// circles and boxes on a lattice of positions. The map's answer, also in a mirror, equals the
/// sets'.
#[test]
fn scene_42_all_shapes_all_neighbours() {
    let cell = 32 * 64;
    let (mut asked, mut yes) = (0, 0);
    for (a, b) in (0..34u8).flat_map(|a| (0..34).map(move |b| (a, b))) {
        for (width, height) in [(2, 1), (1, 2)] {
            // Solid all around at a distance of a cell.
            let tile = |k: i64| match (k % (width + 2) - 1, k / (width + 2) - 1) {
                (0, 0) => a,
                (x, y) if (x, y) == (width - 1, height - 1) => b,
                _ => 0,
            };
            let (w, h) = (width + 2, height + 2);
            let tiles = (0..w * h).map(tile).collect();
            let level = Level { tiles, width: w, height: h, cell, x: 0, y: 0, outside: Outside::Solid };
            let (room, turn) = (Room::new(&level), VIEWS[1 + (a as usize + b as usize) % 7]);
            let seen: Level = turn.iter().fold(level.clone(), |l, view| view.level(&l));
            let (map, mirror) = (level.all(), seen.all());
            for k in 0..81 {
                // Quarters of a cell around the common side's ends and middle, some a raw unit off.
                let at = |i: i64, n: i64| cell / 2 + i * (n + 1) * cell / 8 + (i + k) % 3 - 1;
                let p = (at(k % 9, width), at(k / 9, height));
                for r in [1, cell / 4] {
                    for body in [Body::Disc(p, r), Body::Rect((p.0 - r, p.1 - r), (2 * r, r))] {
                        let due = room.overlaps(body, (0, 0), 0);
                        assert_eq!(overlaps(&map, body), due, "{body:?} in {:?}", level.tiles);
                        assert_eq!(
                            overlaps(&mirror, place(turn, body)),
                            due,
                            "{turn:?}: {body:?} in {:?}",
                            level.tiles
                        );
                        asked += 1;
                        yes += u64::from(due);
                    }
                }
            }
        }
    }
    println!("{yes} of {asked} overlap");
    assert!(yes > asked / 5 && yes < asked / 2);
}

/// A free body in a random room of all shapes, and motions up to so many cells.
fn each(seed: u64, cells: i64, mut f: impl FnMut(&mut Random, &Level, &Room, Body, P)) {
    let (mut r, mut done) = (Random::new(seed), 0);
    while done < cases() {
        let cell = [16 * PX, 24 * PX, 2 * 7 * 64 * r.within(2, 900)][r.below(3) as usize];
        let dense = r.within(8, 45);
        let level = mosaic(&mut r, (22, 16), cell, dense, 0);
        let room = Room::new(&level);
        for _ in 0..24 {
            let p = (r.below(22 * cell), r.below(16 * cell));
            let (w, h) = (cell / 8 + r.below(cell), cell / 8 + r.below(cell));
            let body = if r.one_in(2) { Body::Disc(p, w / 2) } else { Body::Rect(p, (w, h)) };
            if room.overlaps(body, (0, 0), 0) {
                continue;
            }
            let most = cells * cell / FINE;
            let v = match r.below(4) {
                0 => (r.sign() * most * FINE, r.around(most) * FINE),
                1 => (r.around(most) * FINE, r.sign() * most * FINE),
                2 => (r.around(cell / 64), r.around(cell / 64)),
                _ => (r.around(most) * FINE, r.around(most) * FINE),
            };
            f(&mut r, &level, &room, body, v);
            done += 1;
        }
    }
}

/// P20: at up to 16 tiles per frame a body is in the solid at no part of its way, nor at its end.
/// Parts are less than a tenth of a cell.
#[test]
fn p20_sixteen_tiles_a_frame() {
    let (mut hits, mut free) = (0, 0);
    each(20, 16, |r, level, room, body, v| {
        let map = level.all();
        let case = || format!("{body:?} by {v:?} in {:?}, cell {}", level.tiles, level.cell);
        let touch = body.step(&mover(&[]).with_response(Response::Touch), &map, v).unwrap();
        let until = (touch.hits.first().map_or(1 << 30, |h| i64::from(h.toi.raw())) * FINE) >> 30;
        for num in (0..=until).step_by(2) {
            assert!(!room.overlaps(body, v, num), "{num}: {}", case());
        }
        let response = [Response::Slide, Response::Bounce][r.below(2) as usize];
        let out = body.step(&mover(&[]).with_response(response), &map, v).unwrap();
        assert!(!room.overlaps(out.body, (0, 0), 0) && len2(out.v) <= len2(v), "{}", case());
        hits += u64::from(!out.hits.is_empty());
        free += u64::from(out.hits.is_empty());
        // P16: without its velocity it stays, and nothing is reported.
        let again = out.body.step(&mover(&[]), &map, (0, 0)).unwrap();
        assert_eq!((again.body, again.v, again.hits.len()), (out.body, (0, 0), 0), "{}", case());
        // P25: the features of the cells under each piece of the way, at most ten per cell.
        let (lo, hi) = body.bounds();
        let across = |size: i64| (size + level.cell) / level.cell + 2;
        let pieces = v.0.abs().max(v.1.abs()) * 3 / 2 / level.cell + 2;
        let bound = across(hi.0 - lo.0) * across(hi.1 - lo.1) * 10 * pieces * i64::from(out.work.iterations);
        assert!(i64::from(out.work.features) <= bound && out.work.iterations <= Mover::ITERATIONS, "{}", case());
        assert!(out.work.checks <= 1 + 7 * out.work.iterations, "{}", case());
    });
    assert!(hits > free / 2 && free > 100, "{hits} hits, {free} free");
}

/// P10, P11, P12 for casts: 64 positions of a way without a hit are free. Longer ways hit no sooner
/// and no later. A way of no length hits nothing.
#[test]
fn p10_p11_p12_casts() {
    let rules = RayRules { inside: Inside::Hit, one_way: true };
    let mut hits = 0;
    each(10, 6, |_, level, room, body, v| {
        let map = level.all();
        let case = || format!("{body:?} by {v:?} in {:?}, cell {}", level.tiles, level.cell);
        let cast = |v: P| match body {
            Body::Disc(..) => map
                .cast_shape(&circle(body), vec2(v), rules)
                .unwrap()
                .map(|f| (f.hit.toi.raw(), point(f.body.centre()), f.inside)),
            Body::Pill(p, core, r) => map
                .cast_shape(&Body::capsule(p, core, r), vec2(v), rules)
                .unwrap()
                .map(|f| (f.hit.toi.raw(), point(f.body.a()), f.inside)),
            Body::Rect(..) => {
                let b = Aabb::new(vec2(body.bounds().0), vec2(body.bounds().1)).unwrap();
                map.cast_shape(&b, vec2(v), rules).unwrap().map(|f| (f.hit.toi.raw(), point(f.body.min()), f.inside))
            }
        };
        assert_eq!(cast((0, 0)), None, "{}", case());
        let found = cast(v);
        for num in (0..=FINE).step_by(8) {
            if i64::from(found.map_or(1 << 30, |f| f.0)) >= num * ((1 << 30) / FINE) {
                assert!(!room.overlaps(body, v, num), "{num}: {}", case());
            }
        }
        let Some((toi, there, inside)) = found else { return };
        hits += 1;
        assert!(toi <= 1 << 30 && !inside && !room.overlaps(body.at(there), (0, 0), 0), "{}", case());
        let (long, _, _) = cast((3 * v.0, 3 * v.1)).unwrap_or_else(|| panic!("lost: {}", case()));
        let slack = 3 + i128::from(1u64 << 31) / len2(v).isqrt().max(1);
        assert!((i128::from(long) * 3 - i128::from(toi)).abs() <= slack, "{toi} and {long}: {}", case());
    });
    assert!(hits > cases() / 4, "{hits}");
}

/// P9: a quarter turn is a transpose and a mirror.
#[test]
fn p9_quarter_turns() {
    let (mut hits, mut ties) = (0, 0);
    let turns: [&[View]; 3] =
        [&[View::Transpose, View::MirrorX], &[View::Transpose, View::MirrorY], &[View::MirrorX, View::MirrorY]];
    each(9, 5, |r, level, _, body, v| {
        let turn = turns[r.below(3) as usize];
        let seen: Level = turn.iter().fold(level.clone(), |l, view| view.level(&l));
        let out = body.step(&mover(&[]), &level.all(), v).unwrap();
        let d = drawing::direction(turn, v);
        let other = place(turn, body).step(&mover(turn), &seen.all(), d).unwrap();
        let due = (place(turn, out.body), drawing::direction(turn, out.v));
        hits += u64::from(!out.hits.is_empty());
        if (other.body, other.v) != due {
            // Surfaces of one moment.
            let mut pairs = out.hits.iter().zip(other.hits.iter());
            let tie = pairs.any(|(a, b)| {
                let n = drawing::direction(turn, (a.axis.x.into(), a.axis.y.into()));
                a.toi == b.toi && n != (i64::from(b.axis.x), i64::from(b.axis.y))
            });
            assert!(tie, "{turn:?}: {body:?} by {v:?} in {:?}\n{out:?}\n{other:?}", level.tiles);
            ties += 1;
        }
    });
    println!("{hits} hits, {ties} ties");
    assert!(hits > cases() / 4 && ties < hits / 50, "{hits} hits, {ties} ties");
}
