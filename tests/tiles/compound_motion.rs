//! Compounds that move among tiles: each meets first what a part of it meets first, and ends
//! outside of the solid. Tiles are also in the notches between its parts.

use super::compound_contacts::{Any, SIDE, any, ball, boxed, coordinate, raw};
use tilesat::shape::Compound;
use tilesat::world::Placed;
use tilesat::{
    Aabb, AllShapes, Axis, Blocks, Circle, Fx, Grid, Inside, Joined, Mover, Outside, Solid, Solids, TileKind,
    TileKinds, TileMap, Vec2,
};
use tilesat_judge::solids::twins::KINDS;
use tilesat_judge::{Random, cases, enough};

static FULL: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

/// Free starts, of these with a tile in the bounds, hits, and hits of a later part.
type Seen = [u64; 4];

/// A macro, because each level has methods of its own.
macro_rules! judge {
    ($level:expr, $group:expr, $d:expr, $seen:expr) => {
        let (level, group, d) = ($level, $group, $d);
        if !level.overlaps(group) {
            $seen[0] += 1;
            $seen[1] += u64::from(level.overlaps(&group.aabb()));
            let cast = |part| level.cast_shape(part, d, Inside::Ignore).unwrap().map(|hit| hit.hit.toi);
            let of_parts: Vec<_> = group.parts().iter().map(cast).collect();
            let first = of_parts.iter().flatten().min().copied();
            let whole = level.cast_shape(group, d, Inside::Ignore).unwrap();
            assert_eq!(whole.map(|hit| hit.hit.toi), first, "{group:?} by {d:?}");
            $seen[2] += u64::from(first.is_some());
            $seen[3] += u64::from(first.is_some() && of_parts[0] != first);
            for mover in [Mover::new(), Mover::platformer(Axis::NEG_Y)] {
                let moved = mover.move_and_slide(level, group, d).unwrap();
                assert!(!level.overlaps(&moved.body), "{group:?} by {d:?} ends inside: {:?}", moved.body);
            }
        }
    };
}

/// A macro, because bounds of a function would name the shapes for which a level has methods.
macro_rules! play {
    ($name:ident, $part:ty, $random_part:ident, $seed:expr) => {
        #[test]
        fn $name() {
            let (mut random, mut seen) = (Random::new($seed), Seen::default());
            for _ in 0..cases(2_000) {
                let mut tiles = [0u8; (SIDE * SIDE) as usize];
                tiles.fill_with(|| if random.one_in(4) { random.below(38) as u8 } else { 0 });
                let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), Vec2::ZERO).unwrap();
                let plain = tiles.map(|tile| u8::from(tile != 0));
                let shapes = TileMap::<AllShapes>::of(&tiles, grid, &KINDS).unwrap().with_outside(Outside::Empty);
                let blocks = TileMap::<Blocks>::of(&plain, grid, &FULL).unwrap().with_outside(Outside::Empty);
                let c = (coordinate(&mut random), coordinate(&mut random));
                let list = [Solid::new(boxed(&mut random, c, 16 << 16), 0).unwrap()];
                let solids = Solids::new(&list);
                for _ in 0..10 {
                    let c = (coordinate(&mut random), coordinate(&mut random));
                    let size = 1 + random.magnitude(16 << 16);
                    let parts: Vec<$part> = (0..random.within(2, 3))
                        .map(|_| {
                            let at = (c.0 + random.around(24 << 16), c.1 + random.around(24 << 16));
                            $random_part(&mut random, at, size)
                        })
                        .collect();
                    let group = Compound::<$part, 3>::new(&parts).unwrap();
                    let mut along = |n: i64| if random.one_in(n) { 0 } else { random.around(20 << 16) };
                    let d = raw(along(3), along(4));
                    judge!(&blocks, &group, d, seen);
                    judge!(&Joined::new(&blocks, &solids), &group, d, seen);
                    judge!(&Placed::new(&blocks, raw(5 << 16, 777)).unwrap(), &group, d, seen);
                    judge!(&shapes, &group, d, seen);
                }
            }
            println!("{seen:?}: free starts, with a tile in the bounds, hits, hits of later parts");
            assert!(enough(seen.iter().all(|&n| n > cases(2_000))), "{seen:?}");
        }
    };
}

play!(boxes, Aabb, boxed, 711);
play!(circles, Circle, ball, 712);
play!(shapes_of_any_kind, Any, any, 713);
