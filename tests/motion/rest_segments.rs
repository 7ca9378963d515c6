//! Rest among polygons: wedges of any two angles, and the U. Circles and boxes come to rest between
//! the sides and stay (P17).
//!
//! A frame that returns its own body and velocity repeats for ever, see `motion_rest`. Mirrored
//! twins run beside each.

use tilesat::{Aabb, Axis, Circle, Fx, Mover, Path, PathKind, SegmentMap, Vec2};
use tilesat_judge::segments::{Body, P, Piece, Scene, Shape};
use tilesat_judge::{Random, cases};

type State = (Body, P);

struct Play {
    scene: Scene,
    blocking: Vec<Piece>,
    bytes: Vec<u8>,
    gravity: i128,
}

impl Play {
    fn new(points: &[P], cell: i32, gravity: i128) -> Self {
        let shapes = vec![Shape { kind: PathKind::Solid, flags: 0, points: points.to_vec() }];
        let scene = Scene { shapes, origin: (0, 0), cell, grid: None };
        Self { blocking: scene.blocking(), bytes: scene.bytes(), scene, gravity }
    }

    fn mirrored(&self) -> Self {
        let points: Vec<P> = self.scene.shapes[0].points.iter().map(|p| (-p.0, p.1)).collect();
        Self::new(&points, self.scene.cell, self.gravity)
    }

    fn step(&self, map: &SegmentMap, (body, v): State) -> State {
        let mover = Mover::platformer(Axis::NEG_Y);
        let pulled = Vec2::from_raw(v.0 as i32, (v.1 + self.gravity) as i32);
        let (next, velocity) = match body {
            Body::Box { lo, hi } => {
                let b = Aabb::new(self.scene.vec2(lo), self.scene.vec2(hi)).unwrap();
                let m = mover.move_and_slide(map, &b, pulled).unwrap_or_else(|e| panic!("{e:?} {b:?} {pulled:?}"));
                (Body::Box { lo: self.scene.local(m.body.min()), hi: self.scene.local(m.body.max()) }, m.velocity)
            }
            Body::Circle { c, r } => {
                let b = Circle::new(self.scene.vec2(c), Fx::from_bits(r as i32)).unwrap();
                let m = mover.move_and_slide(map, &b, pulled).unwrap_or_else(|e| panic!("{e:?} {b:?} {pulled:?}"));
                (Body::Circle { c: self.scene.local(m.position()), r }, m.velocity)
            }
        };
        let (x, y) = velocity.raw();
        (next, (x.into(), y.into()))
    }

    /// The frame from which on nothing changes, or the state after all frames.
    fn settles(&self, start: State, frames: u32) -> Result<u32, State> {
        let map = SegmentMap::from_bytes(&self.bytes).unwrap();
        let twin = self.mirrored();
        let twin_map = SegmentMap::from_bytes(&twin.bytes).unwrap();
        let mut state = start;
        for k in 0..frames {
            let next = self.step(&map, state);
            if k < 60 {
                assert!(!self.scene.overlaps(&self.blocking, next.0), "{state:?} -> {next:?}");
                let seen = twin.step(&twin_map, (mirror(state.0), (-state.1.0, state.1.1)));
                assert_eq!(plain(seen), plain((mirror(next.0), (-next.1.0, next.1.1))), "{state:?}");
            }
            if plain(next) == plain(state) {
                return Ok(k);
            }
            state = next;
        }
        Err(state)
    }
}

fn mirror(body: Body) -> Body {
    match body {
        Body::Box { lo, hi } => Body::Box { lo: (-hi.0, lo.1), hi: (-lo.0, hi.1) },
        Body::Circle { c, r } => Body::Circle { c: (-c.0, c.1), r },
    }
}

fn plain((body, v): State) -> (P, P, P) {
    let (lo, hi) = body.bounds();
    (lo, hi, v)
}

/// A wedge at the origin whose sides rise by the given heights over a width of `size`, to walls.
fn wedge(left: i128, right: i128, size: i128) -> Vec<P> {
    let (top, far, deep) = (-30 * size, 2 * size, size / 2);
    let ground = [(-size, top), (-size, -left), (0, 0), (size, -right), (size, top)];
    [(-far, top)].into_iter().chain(ground).chain([(far, top), (far, deep), (-far, deep)]).collect()
}

/// Bodies in wedges of these heights, in parts of 1000, rest after so many frames.
fn rest(heights: impl Fn(&mut Random) -> (i64, i64), count: u64, frames: u32) {
    for (size, cell) in [(4096i64, 1024), (65_536 * 4, 65_536), (65_536 * 64, 16 << 16)] {
        let (mut r, mut latest) = (Random::new(size as u64), 0);
        for n in 0..cases(count) {
            let (left, right) = heights(&mut r);
            let rise = |h: i64| i128::from((h * size / 1000).max(1));
            let gravity = (size >> r.within(6, 10)).max(16);
            let play = Play::new(&wedge(rise(left), rise(right), size.into()), cell, gravity.into());
            let (width, height) =
                (i128::from(size / 64 + r.below(size / 4)), i128::from(size / 64 + r.below(size / 4)));
            // A little above the ground.
            let x = i128::from(r.around(size / 4 * left.min(right) / left.max(right)));
            let ground = if x < 0 { rise(left) } else { rise(right) };
            let at = (x, -ground - height - width - i128::from(size / 16));
            let body = if n % 2 == 0 {
                Body::Circle { c: at, r: width / 2 + 1 }
            } else {
                Body::Box { lo: at, hi: (at.0 + width, at.1 + height) }
            };
            if play.scene.overlaps(&play.blocking, body) {
                continue;
            }
            match play.settles((body, (0, 0)), frames) {
                Ok(k) => latest = latest.max(k),
                Err(state) => panic!("moves on: {state:?} by {}: {:?}", play.gravity, play.scene),
            }
        }
        println!("size {size}: at rest after {latest} frames at the latest");
    }
}

#[test]
fn p17_rest_in_a_wedge_of_any_angles() {
    rest(|r| (r.within(60, 900), r.within(60, 900)), 60, 6000);
}

/// The sides meet farther away than any look ahead: what the body touches must show it.
#[test]
fn p17_rest_in_a_shallow_wedge() {
    rest(|r| (r.within(1, 60), r.within(1, 60)), 60, 60_000);
}

#[test]
fn p17_rest_in_a_wedge_with_one_steep_side() {
    rest(
        |r| {
            if r.one_in(2) {
                (r.within(2000, 20_000), r.within(30, 900))
            } else {
                (r.within(30, 900), r.within(2000, 20_000))
            }
        },
        60,
        20_000,
    );
}

/// A box that runs into the nook between a slanted wall and the end of another one rests there. The
/// end touches the middle of its side and has no face along it, but holds it as a face does.
#[test]
fn p17_box_between_a_slanted_wall_and_a_lone_end() {
    let mut rests = 0;
    for (run, rise) in [(9, 1), (7, 2), (3, 1), (2, 1), (5, 4)] {
        for end in [(80, 81), (80, 96), (49, 90)] {
            for (sx, sy) in [(1, 1), (-1, 1), (1, -1), (-1, -1)] {
                let at = |x: i32, y: i32| Vec2::from_raw(sx * x, sy * y);
                let wall = |x: i32| at((48 + x) << 16, (74 << 16) + (x << 16) * rise / run);
                let paths = [[wall(-43), wall(13)], [at(48 << 16, 80 << 16), at(end.0 << 16, end.1 << 16)]];
                let paths = paths.each_ref().map(|path| Path::new(PathKind::Wall, path));
                let mut bytes = vec![0; 1 << 13];
                let used = SegmentMap::build_into(&paths, Fx::from_num(32), &mut bytes).unwrap();
                let map = SegmentMap::from_bytes(&bytes[..used]).unwrap();
                for speed in [9_000, 46_341, 69_512, 185_364] {
                    let half = 4 << 16;
                    let centre = at(34 << 16, 88 << 16).raw();
                    let corner = |s: i32| Vec2::from_raw(centre.0 + s * half, centre.1 + s * half);
                    let mut body = Aabb::new(corner(-1), corner(1)).unwrap();
                    let mut last = body;
                    for _ in 0..400 {
                        last = body;
                        body = Mover::new().move_and_slide(&map, &body, at(speed, -speed)).unwrap().body;
                    }
                    assert_eq!(body, last, "{run}:{rise}, {end:?}, {speed}, {sx} {sy}");
                    rests += 1;
                }
            }
        }
    }
    assert_eq!(rests, 240);
}
