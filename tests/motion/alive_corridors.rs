//! A body gets through every passage that it fits (L3): bodies up to six raw units lower than a
//! corridor, behind each ramp that reaches its floor.

use super::walk_worlds::{Frame, step};
use tilesat::{Axis, Fx, Mover, Walker};
use tilesat_judge::rooms::body::Body;
use tilesat_judge::shapes::level::Level;

const GOAT: Mover = Mover::platformer(Axis::NEG_Y).with_slope_limit(2, 1);

/// A ramp and its mirror image.
const RAMPS: [(&str, u8, u8); 6] =
    [("flat", 1, 1), ("45", 8, 9), ("mild", 24, 25), ("steep low", 28, 29), ("steep high", 32, 33), ("dome", 12, 13)];

#[derive(Clone, Copy, Debug)]
enum Kind {
    Box,
    Ball,
    Standing,
    Lying,
}

/// One run. Returns whether the body gets in.
struct Run {
    ramp: (&'static str, u8, u8),
    cell: i64,
    kind: Kind,
    mirror: bool,
    less: i64,
    offset: i64,
    part: i64,
    fall: i64,
}

impl Run {
    fn level(&self) -> Level {
        let mut tiles = vec![0; 24];
        tiles[18..24].fill(1);
        tiles[2..6].fill(1);
        tiles[14..18].fill(1);
        tiles[13] = self.ramp.1;
        if self.mirror {
            tiles.chunks_mut(6).for_each(<[u8]>::reverse);
            tiles[16] = self.ramp.2;
        }
        let outside = tilesat::Outside::Empty;
        Level { tiles, width: 6, height: 4, cell: self.cell, x: 0, y: 0, outside }
    }

    fn gets_in(&self, walks: bool) -> bool {
        let (level, cell, high) = (self.level(), self.cell, self.cell - self.less);
        let map = level.all();
        let flip = |x: i64, wide: i64| if self.mirror { 6 * cell - x - wide } else { x };
        let ball = (flip(2 * cell - high / 2 - self.offset, 0), 2 * cell - high / 2);
        let (r, feet) = (high / 4, flip(2 * cell - high / 4 - self.offset, 0));
        let mut body = match self.kind {
            Kind::Box => {
                Body::Rect((flip(2 * cell - cell / 2 - self.offset, cell / 2), 2 * cell - high), (cell / 2, high))
            }
            Kind::Ball => Body::Disc(ball, high / 2),
            Kind::Standing => Body::Pill((feet, 2 * cell - r), (0, 2 * r - high), r),
            Kind::Lying => Body::Pill(ball, (if self.mirror { cell / 4 } else { -cell / 4 }, 0), high / 2),
        };
        let speed = cell / self.part;
        let v = (if self.mirror { -speed } else { speed }, speed / self.fall);
        let (walker, mut floor) = (Walker::new(GOAT).with_snap(Fx::from_bits(cell as i32)).unwrap(), None);
        for _ in 0..600 {
            if walks {
                Frame { body, floor, .. } = step(&walker, &map, body, v, floor).unwrap();
            } else {
                body = body.step(&GOAT, &map, v).unwrap().body;
            }
            let (lo, hi) = body.bounds();
            if if self.mirror { hi.0 < 3 * cell } else { lo.0 > 3 * cell } {
                return true;
            }
        }
        false
    }

    /// Whether a plain slide should get in: its push leads up the ramp, and there is room for the
    /// rounding at the ramp's end.
    fn slides(&self) -> bool {
        // Up a ramp of direction (run, -rise), a push of (fall, 1) leads if fall * run > rise.
        let leads = match self.ramp.0 {
            "flat" => return true,
            "45" => self.fall > 1,
            "mild" => true,
            _ => self.fall > 3,
        };
        leads && self.less > 4
    }
}

fn runs() -> impl Iterator<Item = Run> {
    let sizes = [1 << 20, 2 * 54_321].into_iter().flat_map(|cell| (0..6).map(move |less| (cell, less)));
    let bodies = [Kind::Box, Kind::Ball, Kind::Standing, Kind::Lying];
    let kinds = RAMPS
        .into_iter()
        .flat_map(move |ramp| bodies.into_iter().flat_map(move |kind| [(ramp, kind, false), (ramp, kind, true)]));
    sizes.flat_map(move |(cell, less)| {
        kinds.clone().flat_map(move |(ramp, kind, mirror)| {
            let pushes = [2, 5, 8, 16, 37, 64].into_iter().flat_map(|part| [10, 3, 1].map(|fall| (part, fall)));
            pushes.flat_map(move |(part, fall)| {
                [100, 3000, cell / 8, cell / 2].map(|offset| Run { ramp, cell, kind, mirror, less, offset, part, fall })
            })
        })
    })
}

/// The runs that should get in, and never do.
fn judge(runs: impl Iterator<Item = Run>, walks: bool) {
    let (mut all, mut out, mut first) = (0, 0, None);
    for run in runs.filter(|run| walks || run.slides()) {
        all += 1;
        if !run.gets_in(walks) {
            out += 1;
            let Run { ramp, cell, kind, mirror, less, offset, part, fall } = run;
            first.get_or_insert((ramp, cell, kind, mirror, less, offset, part, fall));
        }
    }
    assert_eq!(out, 0, "never in, of {all}: such as {first:?}");
}

#[test]
fn what_fits_a_corridor_gets_in() {
    judge(runs().step_by(tilesat_judge::thorough(11, 1)), false);
}

#[test]
fn walkers_that_fit_a_corridor_get_in() {
    judge(runs().step_by(tilesat_judge::thorough(5, 1)), true);
}
