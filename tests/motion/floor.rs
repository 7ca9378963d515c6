//! Endless sliding along flat rows of tiles, without a trace of the seams. Speed and height stay
//! exact, and every hit is a face.

use tilesat::{Axis, Mover, Outside, TileMap};
use tilesat_judge::motion::body::{Body, Outcome, px};
use tilesat_judge::motion::level::Level;
use tilesat_judge::motion::{P, add};

const CELL: i64 = 24 << 16;
/// 3.37 units per frame, 16.16.
const SPEED: i64 = 220_856;
const GRAVITY: i64 = 1 << 14;
const MILLION: u32 = 1_000_000;

/// A row of tiles along one side of a square map, and the direction toward it.
struct Side {
    rows: [String; 40],
    /// Along the surface and into it.
    along: P,
    into: P,
    /// The position of the surface, on the axis of `into`.
    surface: i64,
}

/// Floor, ceiling, left and right wall of 40 x 40 tiles, in the middle of the map so that nothing
/// else is near.
fn sides() -> [Side; 4] {
    let row = |y: usize| core::array::from_fn(|k| if k == y { "#".repeat(40) } else { ".".repeat(40) });
    let column = |x: usize| core::array::from_fn(|_| (0..40).map(|k| if k == x { '#' } else { '.' }).collect());
    [
        Side { rows: row(20), along: (1, 0), into: (0, 1), surface: 20 * CELL },
        Side { rows: row(20), along: (1, 0), into: (0, -1), surface: 21 * CELL },
        Side { rows: column(20), along: (0, 1), into: (-1, 0), surface: 21 * CELL },
        Side { rows: column(20), along: (0, 1), into: (1, 0), surface: 20 * CELL },
    ]
}

fn scaled(v: P, k: i64) -> P {
    (v.0 * k, v.1 * k)
}

impl Side {
    fn level(&self, cell: i64) -> Level {
        let rows: Vec<&str> = self.rows.iter().map(String::as_str).collect();
        Level::new(&rows, cell)
    }

    fn mover(&self) -> Mover {
        Mover::platformer(Axis::new(-self.into.0 as i32, -self.into.1 as i32))
    }

    /// A box or circle `size` wide that touches the surface, with its middle `along` units from the
    /// map's corner.
    fn body(&self, circle: bool, along: i64, size: i64) -> Body {
        let height = self.surface - (self.into.0 + self.into.1) * size / 2;
        let middle = if self.along == (1, 0) { (along, height) } else { (height, along) };
        if circle {
            Body::disc(middle, size / 2)
        } else {
            Body::rect((middle.0 - size / 2, middle.1 - size / 2), (size, size))
        }
    }

    /// One frame of pushing into the surface. Everything about it must be exact.
    fn frame(&self, mover: &Mover, map: &TileMap<'_>, body: &Body, v: P) -> Outcome {
        let out = body.step(mover, map, add(v, scaled(self.into, GRAVITY))).unwrap();
        assert_eq!((out.v, out.body), (v, body.moved(v)), "{body:?} by {v:?}");
        assert!(out.floor && !out.wall && !out.ceiling && out.remaining == (0, 0), "{body:?} by {v:?}: {out:?}");
        assert_eq!(out.hits.len(), 1, "{body:?} by {v:?}");
        let hit = out.hits.first().unwrap();
        assert!(hit.index < 4 && hit.toi.raw() == 0, "{body:?} by {v:?}: {hit:?}");
        assert_eq!((hit.axis.x, hit.axis.y), (-self.into.0 as i32, -self.into.1 as i32));
        out
    }

    /// Frames at one velocity. After every ten tiles the body moves back by as many, so that the
    /// phase continues.
    fn run(&self, circle: bool, v: P, frames: u32) {
        let level = self.level(CELL);
        let (mover, map) = (self.mover(), level.map());
        let start = self.body(circle, 20 * CELL, px(20));
        let (mut body, mut back) = (start, 0);
        for _ in 0..frames {
            body = self.frame(&mover, &map, &body, v).body;
            let (p, q) = (body.position(), start.position());
            let way = (p.0 - q.0) * self.along.0 + (p.1 - q.1) * self.along.1;
            if way.abs() > 10 * CELL {
                back += way.signum() * 10;
                body = body.moved(scaled(self.along, -way.signum() * 10 * CELL));
            }
        }
        let total = add(scaled(self.along, back * CELL), body.position());
        assert_eq!(total, add(start.position(), scaled(v, frames.into())));
    }
}

#[test]
fn a_million_frames_on_the_floor() {
    for circle in [false, true] {
        for direction in [1, -1] {
            let floor = &sides()[0];
            floor.run(circle, scaled(floor.along, direction * SPEED), MILLION);
        }
    }
}

#[test]
fn as_many_on_ceiling_and_walls() {
    for side in &sides()[1..] {
        for (circle, direction) in [(false, 1), (false, -1), (true, 1), (true, -1)] {
            side.run(circle, scaled(side.along, direction * SPEED), MILLION / 4);
        }
    }
}

/// Torture scenes 1 and 2: tiles of 16, a body 16 wide, every phase of 1/16, speeds from 1/16 to
/// 64, everywhere.
#[test]
fn every_phase_and_speed() {
    let cell = 16 << 16;
    for side in sides() {
        let side = Side { surface: side.surface / 24 * 16, ..side };
        let level = side.level(cell);
        let (mover, map) = (side.mover(), level.map());
        for phase in 0..256 {
            for speed in (0..=10).map(|k| 4096 << k) {
                for circle in [false, true] {
                    for direction in [1, -1] {
                        let mut body = side.body(circle, 20 * cell + phase * 4096, px(16));
                        for _ in 0..4 {
                            body = side.frame(&mover, &map, &body, scaled(side.along, direction * speed)).body;
                        }
                    }
                }
            }
        }
    }
}

/// Torture scene 1 to the letter: radius 8 on a floor at y = 100, v = (3, 1/4), for every phase
/// until the next tile and beyond.
#[test]
fn scene_1_collinear_seam() {
    let level = Level::new(&["................", "################"], 16 << 16).with_origin((0, px(84)));
    let (mover, map) = (Mover::platformer(Axis::NEG_Y), level.map());
    for phase in 0..256 {
        let mut body = Body::disc((px(16) + phase * 4096, px(92)), px(8));
        let mut v = (px(3), 1 << 14);
        for _ in 0..50 {
            let out = body.step(&mover, &map, v).unwrap();
            assert_eq!((out.body, out.v), (body.moved((px(3), 0)), (px(3), 0)));
            assert!(out.hits.iter().all(|h| h.index < 4 && h.axis == Axis::NEG_Y) && out.hits.len() == 1);
            (body, v) = (out.body, (out.v.0, out.v.1 + (1 << 14)));
        }
    }
}

/// In a closed room the body turns at the walls. The height never changes, nor does the speed
/// between walls.
#[test]
fn to_and_fro_between_walls() {
    let rows = ["...................."; 4];
    let level = Level::new(&rows, CELL).with_outside(Outside::Solid);
    let (mover, map) = (Mover::platformer(Axis::NEG_Y), level.map());
    for circle in [false, true] {
        let middle = (10 * CELL + 12_345, 4 * CELL - px(10));
        let mut body = if circle {
            Body::disc(middle, px(10))
        } else {
            Body::rect(add(middle, (-px(10), -px(10))), (px(20), px(20)))
        };
        let height = body.position().1;
        let (mut speed, mut turns) = (SPEED, 0);
        for _ in 0..MILLION / 4 {
            let out = body.step(&mover, &map, (speed, GRAVITY)).unwrap();
            assert_eq!(out.body.position().1, height);
            assert!(out.floor && out.hits.iter().all(|h| h.index < 4));
            if out.wall {
                let (lo, hi) = out.body.bounds();
                assert!(lo.0 == 0 || hi.0 == 20 * CELL);
                assert_eq!(out.v, (0, 0));
                (speed, turns) = (-speed, turns + 1);
            } else {
                assert_eq!((out.v, out.body.position().0 - body.position().0), ((speed, 0), speed));
            }
            body = out.body;
        }
        assert!(turns > 1000, "{turns} turns");
    }
}

/// A row of one-way tiles, of mixed tiles, and of tiles of different flags are as flat as one tile.
#[test]
fn mixed_rows() {
    let kinds = ["----------------------------------------", "##--##-#-#--#--###---#%%#%%-%-##--%%%---"];
    for row in kinds {
        let mut side = sides().into_iter().next().unwrap();
        side.rows[20] = row.to_owned();
        for (circle, direction) in [(false, 1), (false, -1), (true, 1), (true, -1)] {
            side.run(circle, scaled(side.along, direction * SPEED), MILLION / 20);
        }
    }
}

/// Steps of one long face and of many short ones are the same bits: cells of 24, 12, 8 and 6 units.
#[test]
fn landing_is_the_same_on_tiles_of_any_size() {
    let floor = |cells: i64| {
        let width = (40 * cells) as usize;
        let rows: Vec<String> =
            (0..40 * cells).map(|y| if y < 20 * cells { ".".repeat(width) } else { "#".repeat(width) }).collect();
        let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
        Level::new(&rows, CELL / cells)
    };
    let levels = [floor(1), floor(2), floor(3), floor(4)];
    for circle in [false, true] {
        for k in 0..400 {
            let start = (15 * CELL + k * 9_973, 19 * CELL + k * 317);
            let body = if circle { Body::disc(start, px(9)) } else { Body::rect(start, (px(7), px(5))) };
            let v = (SPEED * (k % 7 - 3), px(11));
            let all = levels.each_ref().map(|l| {
                let out = body.step(&Mover::platformer(Axis::NEG_Y), &l.map(), v).unwrap();
                (out.body, out.v, out.remaining, out.times(), out.axes())
            });
            assert!(all.iter().all(|o| *o == all[0]), "{body:?} by {v:?}: {all:?}");
        }
    }
}
