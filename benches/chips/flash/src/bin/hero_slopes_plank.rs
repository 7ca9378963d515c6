//! A whole platformer among slopes with a plank that turns: one hero, its keys, its level.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::world::ConvexSolid;
use tilesat::{Axis, Character, OrientedBox, Slopes, Vec2};
use tilesat_flash::hero::{begin, input, level};
use tilesat_flash::{Later, port};

/// A plank of two cells, which rises by so much to the right.
fn plank(rise: i32) -> Option<OrientedBox> {
    OrientedBox::new(Vec2::from_ints(80, 44), Vec2::from_ints(16, 3), Axis::new(32, rise)).ok()
}

tilesat_flash::game!(
    Later<(Character, [ConvexSolid<OrientedBox>; 1])> = Later::NONE,
    map = level::<Slopes>(),
    |state| state.begin(begin().zip(plank(0).and_then(|flat| Some([ConvexSolid::new(flat, 1).ok()?])))),
    |game| {
        let next = plank((port() & 15) as i32 - 8).and_then(|next| game.1[0].with_turn(next).ok());
        game.1 = [next.unwrap_or(game.1[0])];
        game.0.step_on(&map, &mut game.1, input())
    }
);
