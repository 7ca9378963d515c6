//! Bodies cast through levels of all tile shapes. Every part of the way up to the hit is free, and
//! a little farther it is not. They agree with the mover.
//!
//! `TILESAT_CASES` sets the number of casts (default 6 000).

use tilesat::{AllShapes, TileMap};
use tilesat_judge::levels_cast::{SEEN, as_the_mover, disc, point, raw, rect};
use tilesat_judge::rooms::body::Body;
use tilesat_judge::rooms::room::{FINE, Room};
use tilesat_judge::rooms::{P, PX, len2, mosaic};
use tilesat_judge::{Random, cases};

/// Levels of all shapes: every sixteenth of the way up to the hit is free, and a little farther
/// than that it is not.
#[test]
fn all_shapes_on_the_way() {
    let r = &mut Random::new(0x5ca57);
    let (mut done, mut hits, mut unconfirmed) = (0, 0, 0);
    while done < cases(6_000) / 2 {
        let level = mosaic(r, (8, 8), 24 * PX, 30, 0);
        let room = Room::new(&level);
        {
            let map = level.all();
            for _ in 0..24 {
                let p = (r.within(0, 8 * 24 * PX), r.within(0, 8 * 24 * PX));
                let shape = [
                    Body::Disc(p, 10 * PX),
                    Body::Rect(p, (14 * PX, 18 * PX)),
                    Body::Pill(p, (0, -6 * PX), 7 * PX),
                    Body::Pill(p, (8 * PX, 0), 5 * PX),
                ][r.below(4) as usize];
                if room.overlaps(shape, (0, 0), 0) {
                    continue;
                }
                // Multiples of the parts in which positions are tested.
                let d = (r.around(120) * FINE * 128, r.around(120) * FINE * 128);
                let found = cast(&map, shape, d);
                done += 1;
                let until = found.map_or(1 << 30, |(toi, _)| toi);
                for num in (0..=FINE).step_by(32).filter(|num| num * ((1 << 30) / FINE) <= until) {
                    assert!(!room.overlaps(shape, d, num), "late: {level:?} {shape:?} by {d:?}");
                }
                let Some((_, there)) = found else { continue };
                hits += 1;
                assert!(!room.overlaps(there, (0, 0), 0), "ends inside: {level:?} {shape:?} by {d:?}");
                let length = len2(d).isqrt().max(1) as i64;
                let on = |k: i64| (d.0 * k * 2 / length / 2 + d.0.signum(), d.1 * k * 2 / length / 2 + d.1.signum());
                unconfirmed +=
                    u64::from(![2, 4, 8, 32, 256].iter().any(|&k| room.overlaps(there.moved(on(k)), (0, 0), 0)));
            }
        }
    }
    println!("{hits} hits of {done} motions, {unconfirmed} of them with nothing within 256 raw");
    assert!(hits > done / 3 && unconfirmed * 1000 < hits, "{unconfirmed} of {hits} hits meet nothing");
}

/// The time, and the position then.
fn cast(map: &TileMap<'_, AllShapes>, body: Body, d: P) -> Option<(i64, Body)> {
    match body {
        Body::Rect(..) => {
            let (lo, hi) = body.bounds();
            let found = map.cast_shape(&rect(lo, hi), raw(d), SEEN).unwrap();
            as_the_mover(map, &rect(lo, hi), raw(d), found.as_ref());
            found.map(|f| (f.hit.toi.raw().into(), body.at(point(f.body.min()))))
        }
        Body::Disc(c, r) => {
            let found = map.cast_shape(&disc(c, r), raw(d), SEEN).unwrap();
            as_the_mover(map, &disc(c, r), raw(d), found.as_ref());
            found.map(|f| (f.hit.toi.raw().into(), body.at(point(f.body.centre()))))
        }
        Body::Pill(p, core, r) => {
            let capsule = Body::capsule(p, core, r);
            let found = map.cast_shape(&capsule, raw(d), SEEN).unwrap();
            as_the_mover(map, &capsule, raw(d), found.as_ref());
            found.map(|f| (f.hit.toi.raw().into(), body.at(point(f.body.a()))))
        }
    }
}
