//! Faults of a frame: its end is in the solid, it went through the solid, or it did not move
//! although it could.
//!
//! Overlaps and depths are exact. The other two faults follow from many exact questions. In doubt,
//! there is no fault.
//! - A frame tunnels if no way leads from its start to its end that is at most half as long again
//!   as the motion plus two pixels. The search uses a lattice of one pixel, and a body that is
//!   three quarters of a pixel smaller on all sides.
//! - A body is stuck if it moves by less than a 64th of a pixel, though it is free and could go a
//!   pixel within 60 degrees of its motion. It tries the motion's own direction and the directions
//!   of the tile's sides.
//!
//! A game puts a body back that fell out of the world. So after a frame that tunnels or ends deeper
//! than a pixel, the rest of the sequence does not count.

use super::classes::{Case, FRAMES, exact};
use super::room::{Body, FINE_PIXEL, Room};
use crate::record::Row;
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap, HashSet};

/// Position of a body after each frame.
pub type Answer = [Body; FRAMES];

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Verdict {
    pub frames: u64,
    pub overlaps: u64,
    /// Of these, ends deeper than a 64th of a pixel.
    pub deep: u64,
    /// Ends deeper than a pixel, which end the sequence.
    pub lost: u64,
    pub tunnels: u64,
    pub stuck: u64,
    /// In fine units.
    pub deepest: i64,
}

type Place = (i64, i64);

fn between(a: Place, b: Place) -> Place {
    (b.0 - a.0, b.1 - a.1)
}

fn length(d: Place) -> f64 {
    (d.0 as f64).hypot(d.1 as f64)
}

impl Verdict {
    /// Continues with the frames of a sequence.
    pub fn add(&mut self, room: &Room, case: &Case, ends: &Answer) {
        let mut before = exact(&case.start);
        let mut was_free = true;
        for (end, motion) in ends.iter().zip(&case.motions) {
            self.frames += 1;
            let wanted = (motion.0 * (FINE_PIXEL >> 16), motion.1 * (FINE_PIXEL >> 16));
            let depth = room.depth(end);
            self.overlaps += u64::from(depth > 0);
            self.deep += u64::from(depth > FINE_PIXEL / 64);
            self.deepest = self.deepest.max(depth);
            if depth > FINE_PIXEL {
                self.lost += 1;
                return;
            }
            if tunnels(room, &before, end, wanted) {
                self.tunnels += 1;
                return;
            }
            self.stuck += u64::from(was_free && is_stuck(room, &before, end, wanted));
            (before, was_free) = (*end, depth == 0);
        }
    }

    pub fn set(&self, row: &mut Row) {
        row.set("queries", self.frames as f64).set("wrong", self.overlaps as f64);
        row.set("deepest_px", self.deepest as f64 / FINE_PIXEL as f64);
        row.set("deep", self.deep as f64)
            .set("lost", self.lost as f64)
            .set("tunnels", self.tunnels as f64)
            .set("stuck", self.stuck as f64);
    }
}

/// How much smaller the body is in the search on the lattice: the distance from any point to the
/// nearest lattice point, and a little more.
const NARROWER: i64 = FINE_PIXEL * 3 / 4;

/// Whether a slightly smaller body meets the solid on the straight way, at one of many positions.
fn is_barred(room: &Room, small: &Body, d: Place) -> bool {
    let steps = (length(d) / (2 * FINE_PIXEL) as f64) as i64 + 1;
    (1..steps).any(|i| room.overlaps(&small.moved((even(d.0 * i / steps), even(d.1 * i / steps)))))
}

/// Boxes are judged at even positions.
fn even(v: i64) -> i64 {
    v & !1
}

fn tunnels(room: &Room, before: &Body, end: &Body, wanted: Place) -> bool {
    let d = between(before.middle(), end.middle());
    let small = before.shrunk(NARROWER);
    if !is_barred(room, &small, d) {
        return false;
    }
    let longest = length(wanted) * 1.5 + (2 * FINE_PIXEL) as f64;
    let ahead = |at: Place| length(between((at.0 * FINE_PIXEL, at.1 * FINE_PIXEL), d));
    // The best first: by the length so far, in thousandths of a pixel, plus the length ahead.
    let mut open = BinaryHeap::from([(Reverse(0), 0, (0, 0))]);
    let mut made: HashMap<Place, i64> = HashMap::from([((0, 0), 0)]);
    let mut done = HashSet::new();
    while let Some((_, so_far, at)) = open.pop() {
        if ahead(at) <= FINE_PIXEL as f64 {
            return false;
        }
        if !done.insert(at) {
            continue;
        }
        for (dx, dy) in [(1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1)] {
            let (to, way) = ((at.0 + dx, at.1 + dy), so_far + if dx == 0 || dy == 0 { 1000 } else { 1414 });
            let all = way as f64 / 1000.0 * FINE_PIXEL as f64 + ahead(to);
            if all > longest || made.get(&to).is_some_and(|&m| m <= way) {
                continue;
            }
            if room.overlaps(&small.moved((to.0 * FINE_PIXEL, to.1 * FINE_PIXEL))) {
                continue;
            }
            made.insert(to, way);
            open.push((Reverse(all as i64), way, to));
        }
    }
    true
}

/// In pixels, on a way that may be free.
const STEPS: i64 = 2048;

fn is_stuck(room: &Room, before: &Body, end: &Body, wanted: Place) -> bool {
    let moved = length(between(before.middle(), end.middle()));
    if moved >= FINE_PIXEL as f64 / 64.0 || length(wanted) < FINE_PIXEL as f64 {
        return false;
    }
    let along = TILE_WAYS.iter().flat_map(|&(x, y)| [(x, y), (-y, x), (-x, -y), (y, -x)]);
    along.chain([wanted]).any(|way| {
        let unit = FINE_PIXEL as f64 / length(way);
        let ahead = way.0 as f64 * wanted.0 as f64 + way.1 as f64 * wanted.1 as f64;
        let at = |step: i64| {
            let part = unit * step as f64 / STEPS as f64;
            // Whole multiples of a side's direction stay exactly beside it.
            let part = if way == wanted { part } else { even(part as i64) as f64 };
            (even((way.0 as f64 * part) as i64), even((way.1 as f64 * part) as i64))
        };
        // At most 60 degrees. The steps are smaller than any tip in the way, and start small to
        // leave a contact.
        let mut steps = (1..STEPS / 16).chain((STEPS / 16..=STEPS).step_by(STEPS as usize / 32));
        let mut free = |step| !room.overlaps(&before.moved(at(step)));
        ahead >= 0.5 * length(way) * length(wanted) && steps.all(&mut free)
    })
}

/// The directions of straight sides of tiles, up to quarter turns.
const TILE_WAYS: [Place; 4] = [(1, 0), (1, 1), (1, 2), (2, 1)];

#[cfg(test)]
mod tests {
    use super::*;
    use tilesat::Outside;
    use tilesat_judge::oracle::figure::Figure;
    use tilesat_judge::shapes::level::Level;

    const PX: i64 = 1 << 16;

    /// A wall of one column in an empty room of 160 x 160, from x = 64 to 80; with a door of one
    /// cell at y = 80 to 96 or none.
    fn room(door: bool) -> Room {
        let mut tiles = vec![0; 100];
        (0..10).filter(|&row| !door || row != 5).for_each(|row| tiles[row * 10 + 4] = 1);
        Room::of(Level { width: 10, height: 10, cell: 16 * PX, x: 0, y: 0, outside: Outside::Solid, tiles })
    }

    /// The first frame moves a box of 10 x 10 between these corners. Then it stays and wants
    /// nothing.
    fn judged(room: &Room, from: Place, wanted: Place, to: Place) -> Verdict {
        let at = |p: Place| Figure::Aabb { min: (p.0 * PX, p.1 * PX), max: ((p.0 + 10) * PX, (p.1 + 10) * PX) };
        let mut motions = [(0, 0); FRAMES];
        motions[0] = (wanted.0 * PX, wanted.1 * PX);
        let mut verdict = Verdict::default();
        verdict.add(room, &Case { start: at(from), motions }, &[exact(&at(to)); FRAMES]);
        verdict
    }

    #[test]
    fn frames_that_are_right() {
        // Stopped by the wall, through the door, around nothing.
        for (from, wanted, to) in
            [((50, 20), (30, 0), (54, 20)), ((54, 83), (30, 0), (84, 83)), ((50, 20), (0, 30), (50, 50))]
        {
            let fine = Verdict { frames: FRAMES as u64, ..Verdict::default() };
            assert_eq!(judged(&room(true), from, wanted, to), fine, "{from:?} {wanted:?} {to:?}");
        }
    }

    #[test]
    fn what_ends_beyond_a_wall_tunnels() {
        let told = judged(&room(true), (50, 20), (30, 0), (80, 20));
        assert_eq!((told.tunnels, told.frames, told.overlaps), (1, 1, 0));
        // The door is too far away.
        let told = judged(&room(true), (50, 55), (30, 0), (80, 55));
        assert_eq!(told.tunnels, 1);
        // There is a short enough way beside the door.
        let told = judged(&room(true), (53, 78), (30, 0), (81, 78));
        assert_eq!(told.tunnels, 0);
    }

    #[test]
    fn ends_in_the_solid_are_counted_until_it_is_lost() {
        let told = judged(&room(false), (50, 20), (4, 0), (55, 20));
        assert_eq!((told.overlaps, told.frames, told.tunnels), (FRAMES as u64, FRAMES as u64, 0));
        assert!((told.deepest - FINE_PIXEL).abs() <= 2, "{told:?}");
        let told = judged(&room(false), (50, 20), (30, 0), (58, 20));
        assert_eq!((told.overlaps, told.deep, told.lost, told.frames), (1, 1, 1, 1));
    }

    #[test]
    fn what_could_move_is_stuck() {
        assert_eq!(judged(&room(false), (20, 20), (4, 4), (20, 20)).stuck, 1);
        // Straight into the wall it could not move. At an angle it could.
        assert_eq!(judged(&room(false), (54, 20), (4, 0), (54, 20)).stuck, 0);
        assert_eq!(judged(&room(false), (54, 20), (4, 4), (54, 20)).stuck, 1);
    }

    /// To continue it would first have to go a tenth of a pixel another way, which something else
    /// blocks.
    #[test]
    fn what_is_wedged_is_not_stuck() {
        // Between a steep slope and a floor, between a slope's tip and a quarter disc; by 400 raw
        // units behind the edge of a block.
        let wedges = [
            ([(5, 26), (10, 30)], (1_390_497, 1_413_310), (2_104_829, 2_097_152), (-331_959, 1_521_289)),
            ([(1, 29), (6, 12)], (1_572_864, 1_037_854), (2_166_626, 1_721_824), (-162_509, 141_606)),
            ([(5, 1), (5, 1)], (11 * PX, 32 * PX - 400), (16 * PX, 41 * PX), (91_027, -80)),
        ];
        for (shapes, min, max, motion) in wedges {
            let mut tiles = vec![0; 16];
            shapes.iter().for_each(|&(cell, id)| tiles[cell] = id);
            let level = Level { width: 4, height: 4, cell: 16 * PX, x: 0, y: 0, outside: Outside::Solid, tiles };
            let body = Figure::Aabb { min, max };
            let mut verdict = Verdict::default();
            let case = Case { start: body, motions: [motion; FRAMES] };
            verdict.add(&Room::of(level), &case, &[exact(&body); FRAMES]);
            assert_eq!(verdict, Verdict { frames: FRAMES as u64, ..Verdict::default() });
        }
    }
}
