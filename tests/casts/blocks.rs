//! Bodies cast through block levels. Compared with the exact first moment, and with the mover.
//!
//! `TILESAT_CASES` sets the number of casts per test (default 6 000).

use tilesat::{Capsule, Fx, RangeError, TileMap, world::RayRules};
use tilesat_judge::levels_cast::{PASSED, SEEN, as_the_mover, disc, raw, rect};
use tilesat_judge::motion::P;
use tilesat_judge::motion::body::Body;
use tilesat_judge::motion::judge::first_hit;
use tilesat_judge::motion::level::Level;
use tilesat_judge::{Random, cases};

/// A small block level of random density with one-way faces.
fn blocks(r: &mut Random) -> Level {
    let (width, density) = (r.within(2, 9), r.within(1, 5));
    let rows: Vec<String> = (0..r.within(2, 9))
        .map(|_| {
            (0..width)
                .map(|_| {
                    if r.below(10) < density {
                        '#'
                    } else if r.one_in(8) {
                        '-'
                    } else {
                        '.'
                    }
                })
                .collect()
        })
        .collect();
    let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
    Level::new(&rows, (256 + r.magnitude(1 << 21)) & !1)
}

/// On a line or corner of the grid, half a cell or a few raw off, or anywhere.
fn place(r: &mut Random, level: &Level) -> P {
    let mut at = |count: i64| match r.below(4) {
        0 => level.cell * r.within(-1, count + 1),
        1 => level.cell * r.within(-1, count + 1) + r.around(2),
        2 => level.cell / 2 * r.within(-2, 2 * count + 2),
        _ => r.within(-level.cell, level.cell * (count + 1)),
    };
    (at(level.width), at(level.height))
}

fn any_body(r: &mut Random, level: &Level) -> Body {
    let size = |r: &mut Random| if r.one_in(8) { 0 } else { r.within(1, level.cell + level.cell / 2) };
    let p = place(r, level);
    match r.below(3) {
        0 => Body::rect(p, (size(r), size(r))),
        1 => Body::disc(p, size(r) / 2),
        _ => {
            let (long, radius) = (1 + size(r), (size(r) / 2).max(1));
            Body::Disc { c: p, core: if r.one_in(2) { (long, 0) } else { (0, long) }, r: radius }
        }
    }
}

fn cast(map: &TileMap<'_>, body: &Body, d: P, rules: RayRules) -> Option<tilesat::Hit> {
    match *body {
        Body::Rect { lo, hi } => {
            let body = rect(lo, hi);
            let found = map.cast_shape(&body, raw(d), rules).unwrap();
            if rules.one_way {
                as_the_mover(map, &body, raw(d), found.as_ref());
            }
            found.map(|f| f.hit)
        }
        Body::Disc { c, core, r } if core != (0, 0) => {
            let body = Capsule::new(raw(c), raw((c.0 + core.0, c.1 + core.1)), Fx::from_bits(r as i32)).unwrap();
            let found = map.cast_shape(&body, raw(d), rules).unwrap();
            if rules.one_way {
                as_the_mover(map, &body, raw(d), found.as_ref());
            }
            found.map(|f| f.hit)
        }
        Body::Disc { c, r, .. } => {
            let body = disc(c, r);
            let found = map.cast_shape(&body, raw(d), rules).unwrap();
            if rules.one_way {
                as_the_mover(map, &body, raw(d), found.as_ref());
            }
            found.map(|f| f.hit)
        }
    }
}

#[test]
fn blocks_exactly() {
    let r = &mut Random::new(0xca5);
    let (mut done, mut hits) = (0, 0);
    while done < cases(6_000) {
        let level = blocks(r);
        let mut solid = level.clone();
        solid.tiles.iter_mut().for_each(|t| *t = if *t == b'-' { b'.' } else { *t });
        for _ in 0..16 {
            let body = any_body(r, &level);
            if level.overlaps(&body) {
                continue;
            }
            let to = place(r, &level);
            let from = body.position();
            let d = if r.one_in(4) { (r.around(2), r.around(2)) } else { (to.0 - from.0, to.1 - from.1) };
            for (level, rules) in [(&level, SEEN), (&solid, PASSED)] {
                let hit = cast(&level.map(), &body, d, rules);
                first_hit(level, &body, d, hit).unwrap_or_else(|e| panic!("{e}: {level:?} {body:?} by {d:?}"));
                hits += u64::from(hit.is_some());
            }
            // One-way faces have no effect.
            assert_eq!(cast(&level.map(), &body, d, PASSED), cast(&solid.map(), &body, d, PASSED));
            longer(&solid.map(), &body, d);
            done += 1;
        }
    }
    println!("{hits} hits of {done} motions, each with and without one-way faces");
    assert!(hits > done / 3);
}

/// A longer motion in the same direction does not hit earlier, by more than a part in 2^30.
fn longer(map: &TileMap<'_>, body: &Body, d: P) {
    let (Some(one), Some(two)) = (cast(map, body, d, PASSED), cast(map, body, (2 * d.0, 2 * d.1), PASSED)) else {
        return;
    };
    if one.index < 4 && two.index < 4 {
        let (one, two) = (i64::from(one.toi.raw()), i64::from(two.toi.raw()));
        assert!((0..2).contains(&(one - 2 * two)), "{one} {two}: {body:?} by {d:?}");
    }
}

#[test]
fn refusals() {
    let level = Level::new(&["#"], 1 << 20);
    let map = level.map();
    let ball = disc((0, -(1 << 22)), 1 << 16);
    let by = |d: P| map.cast_shape(&ball, raw(d), SEEN);
    assert!(by(((1 << 28) - 1, 0)).is_ok());
    let too_far = RangeError { what: tilesat::Quantity::MotionX, value: 1 << 28 };
    assert_eq!(by((1 << 28, 0)), Err(too_far));
    let near_the_end = disc(((1 << 29) - (1 << 17), 0), 1 << 16);
    assert!(map.cast_shape(&near_the_end, raw((1 << 16, 0)), SEEN).is_err());
    assert!(map.cast_shape(&disc((0, 0), 1 << 28), raw((0, 0)), SEEN).is_err());
}
