//! A platform flush with a floor, of tiles or of segments, in the level's order or the other, is
//! one floor with it. At no phase and no speed does the joint change a walker's height or speed.

use tilesat::{
    Axis, Fx, Grid, Joined, Mover, Path, PathKind, SegmentMap, Solid, Solids, TileKind, TileKinds, TileMap, World,
};
use tilesat_judge::solids::judge::Judged;
use tilesat_judge::solids::{P, disc, raw, rect, solid, vec2};
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const UNIT: i64 = 1 << 16;
const CELL: i64 = 16 * UNIT;

/// The scene has its floor at y = 0, solid below, and is seen from any side.
#[derive(Clone, Copy, Debug)]
struct Turn(u8);

impl Turn {
    fn of(self, p: P) -> P {
        let p = if self.0 & 4 != 0 { (-p.0, p.1) } else { p };
        match self.0 & 3 {
            0 => p,
            1 => (-p.1, p.0),
            2 => (-p.0, -p.1),
            _ => (p.1, -p.0),
        }
    }
}

/// The bridge over the pit from -2 to 2 cells: one platform, or several side by side, of any depth,
/// some into the banks.
fn bridge(random: &mut Random, turn: Turn) -> Vec<Solid> {
    let mut list = vec![];
    let deep = |random: &mut Random| [CELL, CELL / 3, 1, 3 * CELL, 5][random.below(5) as usize];
    let (start, end) =
        (-2 * CELL - random.below(2) * random.below(CELL), 2 * CELL + random.below(2) * random.below(CELL));
    let mut at = start;
    while at < end {
        let to = if random.one_in(3) { end } else { (at + random.within(1, 2 * CELL)).min(end) };
        // Sometimes over each other.
        let from = (at - random.below(2) * random.below(CELL)).max(start);
        list.push(solid(turn.of((from, 0)), turn.of((to, deep(random))), list.len() as u16));
        at = to;
    }
    list
}

fn walk<W: World, B: Judged>(world: &W, turn: Turn, body: B, speed: i64, gravity: i64, case: &str) {
    let up = turn.of((0, -1));
    let mover = Mover::platformer(Axis::new(up.0 as i32, up.1 as i32));
    let (mut body, d, v) = (body, turn.of((speed, 0)), vec2(turn.of((speed, gravity))));
    let mut way = 0;
    while way < 6 * CELL {
        let moved = mover.move_and_slide(world, &body, v).unwrap();
        assert_eq!(moved.body, body.at(d), "{case} {} {moved:?}", body.show());
        assert_eq!(raw(moved.velocity), d, "{case} {moved:?}");
        assert!(moved.floor == (gravity > 0) && !moved.wall && !moved.ceiling, "{case} {moved:?}");
        (body, way) = (moved.body, way + speed.abs());
    }
}

fn both<W: World>(level: &W, turn: Turn, random: &mut Random) {
    let list = bridge(random, turn);
    let solids = Solids::new(&list);
    let (one, other) = (Joined::new(level, &solids), Joined::new(&solids, level));
    for _ in 0..5 {
        let sizes = [random.within(1, 20 * UNIT), 8 * UNIT, 5 * UNIT + 1];
        let (w, h) = (sizes[random.below(3) as usize], random.within(1, 20 * UNIT));
        let speed = [7 * UNIT, UNIT / 3 + 1, random.within(2 * UNIT, 40 * UNIT), 90 * UNIT][random.below(4) as usize];
        let gravity = [0, 1, UNIT / 4, 3 * UNIT][random.below(4) as usize];
        let (speed, from) = if random.one_in(2) { (speed, -3 * CELL) } else { (-speed, 3 * CELL) };
        let from = from - if random.one_in(2) { random.below(3 * UNIT) } else { 0 };
        let case = format!("{turn:?} {list:?} {speed} {gravity}");
        let body = rect(turn.of((from, -h)), turn.of((from + w, 0)));
        walk(&one, turn, body, speed, gravity, &case);
        walk(&other, turn, body, speed, gravity, &case);
        let body = disc(turn.of((from, -w)), w);
        walk(&one, turn, body, speed, gravity, &case);
        walk(&other, turn, body, speed, gravity, &case);
    }
}

#[test]
fn a_flush_platform_does_not_trip_a_walker() {
    let mut random = Random::new(91);
    for _ in 0..cases(tilesat_judge::thorough(100, 250)) {
        let turn = Turn(random.below(8) as u8);
        let row = b"############    ############";
        let a = turn.of((-14 * CELL, 0));
        let b = turn.of((14 * CELL, CELL));
        let lo = (a.0.min(b.0), a.1.min(b.1));
        let (w, h) = if turn.0 & 1 == 0 { (28, 1) } else { (1, 28) };
        let grid = Grid::new(w, h, Fx::from_bits(CELL as i32), vec2(lo)).unwrap();
        both(&TileMap::on_grid(row, grid, &KINDS).unwrap(), turn, &mut random);
        // The same banks as polygons, with walls that lean to either side.
        let mut lean = || random.within(-CELL / 2, CELL / 2) * random.below(2);
        let banks = [
            [(-14 * CELL, 0), (-2 * CELL, 0), (-2 * CELL + lean(), CELL), (-14 * CELL, CELL)],
            [(2 * CELL, 0), (14 * CELL, 0), (14 * CELL, CELL), (2 * CELL + lean(), CELL)],
        ];
        let banks = banks.map(|bank| bank.map(|p| vec2(turn.of(p))));
        let paths = banks.each_ref().map(|bank| Path::new(PathKind::Solid, bank));
        let cell = Fx::from_num(24);
        let size = SegmentMap::measure(&paths, cell).unwrap();
        let mut bytes = vec![0; size.bytes()];
        SegmentMap::build_into(&paths, cell, &mut bytes).unwrap();
        both(&SegmentMap::from_bytes(&bytes).unwrap(), turn, &mut random);
    }
}
