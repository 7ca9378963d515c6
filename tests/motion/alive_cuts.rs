//! The cut of a level changes no bit (L4): tiles of one level, or of two that are joined.

use tilesat::{Axis, Joined, Mover};
use tilesat_judge::Random;
use tilesat_judge::rooms::body::Body;
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::{PX, mosaic};
use tilesat_judge::shapes::level::Level;

#[test]
fn joined_levels_are_one() {
    let (mut r, player) = (Random::new(11), Mover::platformer(Axis::NEG_Y));
    let (mut frames, mut other) = (0, Vec::new());
    for _ in 0..tilesat_judge::cases(500) {
        let cell = [24 * PX, 16 * PX, 8 * PX, 2 * 54_321][r.below(4) as usize];
        let dense = [20, 40, 60][r.below(3) as usize];
        let mut level = mosaic(&mut r, (7, 7), cell, dense, 0);
        for (k, tile) in level.tiles.iter_mut().enumerate() {
            if !(7..42).contains(&k) || k % 7 == 0 || k % 7 == 6 {
                *tile = 1;
            }
        }
        level.outside = tilesat::Outside::Empty;
        let mut parts = [level.clone(), level.clone()];
        let by_rows = r.below(3);
        for k in 0..49 {
            let second = match by_rows {
                0 => k % 7 >= 3,
                1 => k / 7 >= 3,
                _ => r.one_in(2),
            };
            parts[usize::from(!second)].tiles[k] = 0;
        }
        let closed = Level { outside: tilesat::Outside::Solid, ..level.clone() };
        let (whole, first, second, room) = (level.all(), parts[0].all(), parts[1].all(), Room::new(&closed));
        let joined = Joined::new(&first, &second);
        for _ in 0..6 {
            let half = [cell / 2, cell / 4, cell / 8, cell * 3 / 16, cell / 3][r.below(5) as usize];
            let at = (r.within(cell, 6 * cell), r.within(cell, 6 * cell));
            let mut body = if r.one_in(2) {
                Body::Disc(at, half)
            } else {
                Body::Rect((at.0 - half, at.1 - half), (2 * half, 2 * half))
            };
            if room.overlaps(body, (0, 0), 0) {
                continue;
            }
            let mut v = (r.around(cell), r.around(cell));
            for _ in 0..12 {
                v.1 += cell / 30;
                let (one, two) = (body.step(&player, &whole, v).unwrap(), body.step(&player, &joined, v).unwrap());
                let bits = |o: &tilesat_judge::rooms::body::Outcome| {
                    (o.body, o.v, o.remaining, [o.floor, o.wall, o.ceiling], o.hits.len())
                };
                frames += 1;
                if bits(&one) != bits(&two) {
                    other.push((level.tiles.clone(), body, v, bits(&one), bits(&two)));
                }
                (body, v) = (one.body, one.v);
            }
        }
    }
    assert!(other.is_empty(), "{} of {frames} frames, such as {:?}", other.len(), other[0]);
}
