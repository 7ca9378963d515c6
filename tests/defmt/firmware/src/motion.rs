//! Movers, walkers, riders, and their reports.

use crate::tell;
use tilesat::{
    Aabb, Axis, Character, Circle, Feel, Fx, Input, Inside, Mover, Response, SlopeSpeed, Solid, TileKind, TileKinds,
    TileMap, Vec2, Walker, fx,
    motion::{Memo, OnLeave, StartInside},
};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL.with_flags(8));

pub(crate) fn tell_all() {
    let level = TileMap::from_ascii("    \n   #\n####\n", &KINDS).unwrap();
    let body = Aabb::new(Vec2::from_ints(20, 20), Vec2::from_ints(30, 30)).unwrap();
    let mover = Mover::platformer(Axis::NEG_Y);
    tell(&mover);
    tell(&Response::Bounce);
    tell(&StartInside::Ignore);
    let moved = mover.move_and_slide(&level, &body, Vec2::from_ints(30, 4)).unwrap();
    tell(&moved);
    tell(&moved.hits);
    tell(&moved.hits.first().unwrap());
    tell(&moved.work);

    let mut memo = Memo::new();
    let at_rest = memo.move_and_slide(&mover, &level, 0, &moved.body, Vec2::from_ints(0, 1));
    tell(&at_rest.is_ok_and(|at_rest| at_rest.floor).then_some(memo).unwrap());

    let deep = Aabb::new(Vec2::from_ints(20, 36), Vec2::from_ints(30, 40)).unwrap();
    let refused = mover.move_and_slide(&level, &deep, Vec2::from_ints(1, 0)).unwrap_err();
    tell(&refused);
    let tilesat::MoveError::Stuck(stuck) = refused else { panic!("a body in the floor is stuck") };
    tell(&stuck);

    let walker = Walker::new(mover).with_snap(Fx::lit("3")).unwrap().with_step(Fx::lit("4.5")).unwrap();
    tell(&walker);
    tell(&SlopeSpeed::Projected);
    tell(&OnLeave::Keep);
    let walked = walker.walk(&level, &moved.body, Vec2::from_ints(-2, 0), None).unwrap();
    tell(&walked);
    tell(&walked.floor.unwrap());

    let ball = Circle::new(Vec2::from_ints(20, 20), Fx::from_num(4)).unwrap();
    tell(&level.cast_shape(&ball, Vec2::from_ints(12, 16), Inside::Hit).unwrap().unwrap());

    let lift = Solid::new(Aabb::new(Vec2::from_ints(16, 30), Vec2::from_ints(40, 32)).unwrap(), 5).unwrap();
    let ridden = mover.ride(&level, &[lift.with_motion(Vec2::from_ints(1, -2)).unwrap()], &body, Fx::ONE).unwrap();
    tell(&ridden);
    tell(&ridden.ride);

    let mut hero = Character::new(body, level.bounds(), Feel::DEFAULT);
    let input = Input { run: fx!(1.5), jump: false, drop: false };
    let step = hero.step(&level, input).unwrap();
    tell(&hero.feel);
    tell(&input);
    tell(&step);
    tell(&step.outcome);
    tell(&hero);
}
