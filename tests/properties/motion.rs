//! Bodies in worlds of all shapes: P5 to P7 and P9 of motion, P14 to P16, P20, P24.

use super::config;
use proptest::prelude::*;
use tilesat::{Axis, Mover, Response};
use tilesat_judge::Random;
use tilesat_judge::rooms::body::{Body, Outcome};
use tilesat_judge::rooms::room::{FINE, Room};
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX, len2, mosaic};
use tilesat_judge::shapes::level::Level;

const SIZE: P = (6, 5);

/// A small world, a body at a free position of it and a velocity. It removes tiles that the body
/// overlaps, so that positions can shrink too.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) level: Level,
    pub(crate) body: Body,
    pub(crate) v: P,
    pub(crate) response: Response,
}

pub(crate) fn scenes(speed: i64) -> impl Strategy<Value = Scene> {
    let cell = prop::sample::select(&[16 * PX, 256, 896, 24 * PX][..]);
    // Mostly empty, or a dense mosaic.
    let sparse = prop::collection::vec(prop_oneof![3 => Just(0u8), 2 => 1u8..38], 30);
    let tiles = prop_oneof![sparse, prop::collection::vec(1u8..34, 30)];
    let unit = || prop_oneof![Just(0i64), -2i64..=2];
    let size = prop_oneof![Just(2i64), 1i64..=24, Just(16)];
    let place = ((0i64..96, unit()), (0i64..80, unit()));
    let velocity = ((-16i64..=16, unit()), (-16i64..=16, unit()));
    let response =
        prop::sample::select(&[Response::Slide, Response::Bounce, Response::DropThrough, Response::Touch][..]);
    (cell, tiles, (size.clone(), size, any::<bool>()), place, velocity, response).prop_map(
        move |(cell, tiles, (w, h, round), (x, y), v, response)| {
            // Sixteenths of a cell, give or take 2 raw.
            let at = |(k, off): (i64, i64)| k * cell / 16 + off;
            let body = if round {
                Body::Disc((at(x), at(y)), (w * cell / 32).max(1))
            } else {
                Body::Rect((at(x), at(y)), (w * cell / 16, h * cell / 16))
            };
            let v = (at(v.0) * speed, at(v.1) * speed);
            let mut level =
                Level { tiles, width: SIZE.0, height: SIZE.1, cell, x: 0, y: 0, outside: tilesat::Outside::Solid };
            let (lo, hi) = body.bounds();
            let body = body.moved((
                (-lo.0).max(0) - (hi.0 - SIZE.0 * cell).max(0),
                (-lo.1).max(0) - (hi.1 - SIZE.1 * cell).max(0),
            ));
            let (lo, hi) = body.bounds();
            for row in lo.1.div_euclid(cell).max(0)..=((hi.1 - 1).div_euclid(cell)).min(SIZE.1 - 1) {
                for column in lo.0.div_euclid(cell).max(0)..=((hi.0 - 1).div_euclid(cell)).min(SIZE.0 - 1) {
                    let k = (row * SIZE.0 + column) as usize;
                    let mut alone = Level { tiles: vec![0; level.tiles.len()], ..level.clone() };
                    alone.tiles[k] = level.tiles[k];
                    if Room::new(&alone).overlaps(body, (0, 0), 0) {
                        level.tiles[k] = 0;
                    }
                }
            }
            Scene { level, body, v, response }
        },
    )
}

fn mover(up: P, response: Response) -> Mover {
    Mover::platformer(Axis::new(up.0 as i32, up.1 as i32)).with_response(response)
}

impl Scene {
    fn step(&self, response: Response) -> Outcome {
        self.body.step(&mover((0, -1), response), &self.level.all(), self.v).unwrap()
    }

    /// The same call in another view, seen upright again. Everything but the order and the names of
    /// hits.
    fn seen(&self, views: &[View]) -> (Body, P, P, Option<u32>) {
        let dir = |v: P| views.iter().fold(v, |v, view| view.direction(v));
        let level = views.iter().fold(self.level.clone(), |l, view| view.level(&l));
        let body = views.iter().fold(self.body, |b, view| view.body(b));
        let out = body.step(&mover(dir((0, -1)), self.response), &level.all(), dir(self.v)).unwrap();
        let back = |v: P| views.iter().rev().fold(v, |v, view| view.direction(v));
        let body = views.iter().rev().fold(out.body, |b, view| match view {
            View::Moved(by) => b.moved((-by.0, -by.1)),
            _ => view.body(b),
        });
        (body, back(out.v), back(out.remaining), out.hits.first().map(|h| h.toi.raw()))
    }
}

proptest! {
    #![proptest_config(config(2))]

    /// Mirrored in x, in y and in both: the same bits.
    #[test]
    fn p5_mirrored_worlds(s in scenes(1)) {
        let here = s.seen(&[]);
        for views in [&[View::MirrorX][..], &[View::MirrorY], &[View::MirrorX, View::MirrorY]] {
            prop_assert_eq!(s.seen(views), here, "{:?}", views);
        }
    }

    /// Transposed and turned: the same first moment. The same bits if no tie of x and y at a corner
    /// is involved.
    #[test]
    fn p6_p9_transposed_worlds(s in scenes(1)) {
        let here = s.seen(&[]);
        for views in [&[View::Transpose][..], &[View::Transpose, View::MirrorX], &[View::Transpose, View::MirrorY]] {
            let there = s.seen(views);
            prop_assert_eq!(there.3, here.3, "{:?}", views);
            // A full tie of x and y goes to x in both.
            if s.v.0.abs() != s.v.1.abs() && s.response == Response::Touch {
                prop_assert_eq!(there, here, "{:?}", views);
            }
        }
    }

    /// Moved by anything within the domain: the same bits.
    #[test]
    fn p7_moved_worlds(s in scenes(1), x in -(1i64 << 28)..1 << 28, y in -(1i64 << 28)..1 << 28) {
        prop_assert_eq!(s.seen(&[View::Moved((x, y))]), s.seen(&[]));
    }

    /// No response makes a body faster.
    #[test]
    fn p14_never_faster(s in scenes(4)) {
        prop_assert!(len2(s.step(s.response).v) <= len2(s.v));
    }

    /// The remaining velocity does not lead into a plane that was hit and is still touched.
    #[test]
    fn p15_not_into_what_is_touched(s in scenes(1)) {
        let out = s.step(Response::Slide);
        if let (Body::Rect(..), Some(last)) = (s.body, out.hits.iter().last()) {
            let n = (i128::from(last.axis.x), i128::from(last.axis.y));
            prop_assert!(n.0 * i128::from(out.v.0) + n.1 * i128::from(out.v.1) >= 0, "{:?} along {:?}", out.v, last.axis);
        }
        // A next call with the remaining velocity does not start with a hit on a plane that was hit
        // before. (An arc is not a plane: its tangent turns.)
        let on = Scene { body: out.body, v: out.v, ..s.clone() };
        let next = on.step(Response::Touch);
        if let (Some(hit), Body::Rect(..)) = (next.hits.first(), s.body) {
            let k = i64::from(hit.cell.y) * SIZE.0 + i64::from(hit.cell.x);
            let arc = s.level.tiles.get(k as usize).is_some_and(|id| (10..18).contains(id));
            let again = hit.toi.raw() == 0 && out.hits.iter().any(|h| h.axis == hit.axis);
            prop_assert!(arc || !again, "{hit:?} after {out:?}");
        }
    }

    /// Without a velocity nothing happens, and a resting body stays at its position.
    #[test]
    fn p16_nothing_without_a_velocity(s in scenes(1)) {
        let out = s.step(s.response);
        let still = Scene { body: out.body, v: (0, 0), ..s.clone() };
        let again = still.step(s.response);
        prop_assert_eq!((again.body, again.v, again.hits.len()), (out.body, (0, 0), 0));
    }

    /// Up to 16 cells per frame: neither the end nor any of 32 positions before the first contact
    /// is in the solid.
    #[test]
    fn p20_no_tunnels(s in scenes(16)) {
        let room = Room::new(&s.level);
        prop_assume!(!room.overlaps(s.body, (0, 0), 0));
        prop_assert!(!room.overlaps(s.step(s.response).body, (0, 0), 0), "ends inside");
        let touch = s.step(Response::Touch);
        prop_assert!(!room.overlaps(touch.body, (0, 0), 0), "stops inside");
        let until = touch.hits.first().map_or(FINE, |h| (i64::from(h.toi.raw()) * FINE) >> 30);
        for k in 0..=32 {
            prop_assert!(!room.overlaps(s.body, s.v, until * k / 64 * 2), "passes through, {k} of 32");
        }
    }
}

/// A hash of 100 000 frames of circles and boxes with all responses. It is the same on every
/// machine and at every level of optimisation. A change of it is a change of results, and belongs
/// in the changelog. `TILESAT_WRITE=1` accepts it.
#[test]
fn p24_hash_of_frames() {
    let mut r = Random::new(24);
    let mut hash = 0xcbf2_9ce4_8422_2325u64;
    let mut put = |n: i64| hash = (hash ^ n as u64).wrapping_mul(0x0000_0100_0000_01b3).rotate_left(17);
    let mut frames = 0;
    while frames < 100_000 {
        let level = mosaic(&mut r, (16, 12), 16 * PX, 25, 5);
        let room = Room::new(&level);
        for _ in 0..10 {
            let size = (r.within(PX, 20 * PX), r.within(PX, 20 * PX));
            let kind = if r.one_in(2) { Body::Rect((0, 0), size) } else { Body::Disc((0, 0), size.0 / 2) };
            let places = (0..60).map(|_| kind.at((r.below(256 * PX), r.below(192 * PX)))).collect::<Vec<_>>();
            let Some(mut body) = places.into_iter().find(|b| !room.overlaps(*b, (0, 0), 0)) else { continue };
            let response =
                [Response::Slide, Response::Bounce, Response::DropThrough, Response::Touch][r.below(4) as usize];
            let mut v = (r.around(30 * PX), r.around(30 * PX));
            let map = level.all();
            for _ in 0..200 {
                if len2(v) < 1 << 16 || v.0.abs().max(v.1.abs()) > 60 * PX {
                    v = (r.around(30 * PX), r.around(30 * PX));
                }
                let out = body.step(&mover((0, -1), response), &map, v).unwrap();
                (body, v) = (out.body, out.v);
                [body.position().0, body.position().1, v.0, v.1].into_iter().for_each(&mut put);
                frames += 1;
            }
        }
    }
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/properties/frames.hash");
    let line = format!("{frames} frames {hash:016x}\n");
    if std::env::var_os("TILESAT_WRITE").is_some() {
        std::fs::write(&file, &line).unwrap();
    }
    assert_eq!(std::fs::read_to_string(&file).unwrap_or_default(), line, "{}", file.display());
}
