//! Equal states have equal hashes: what a network game compares.

use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher};
use tilesat::motion::Ride;
use tilesat::{
    Aabb, Axis, Character, Feel, Input, Mover, Ratio, Response, Solid, Surface, TileKind, TileKinds, TileMap, Vec2,
    Walker, fx,
};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

fn hash(value: impl std::hash::Hash) -> u64 {
    BuildHasherDefault::<DefaultHasher>::default().hash_one(value)
}

fn boxed(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h)).unwrap()
}

/// A run, a copy of it from the middle, and one that differs by a press of the button.
#[test]
fn heroes_and_what_they_return() {
    let level = TileMap::from_ascii("........\n........\n........\n########\n", &KINDS).unwrap();
    let mut hero = Character::new(boxed(4, 20, 10, 14), level.bounds(), Feel::DEFAULT);
    let mut copy = hero;
    let mut differ = 0;
    for frame in 0..60 {
        let input = Input { jump: frame % 20 > 12, ..Input::running(fx!(1)) };
        let (one, two) = (hero.step(&level, input).unwrap(), copy.step(&level, input).unwrap());
        assert_eq!((one, hero), (two, copy));
        assert_eq!((hash(one), hash(hero), hash(hero.floor())), (hash(two), hash(copy), hash(copy.floor())));
        let mut other = hero;
        // The same body and velocity: only the memory of the button differs, where it was up.
        let _ = other.step(&level, Input { jump: true, ..input }).unwrap();
        let mut next = hero;
        let _ = next.step(&level, Input { jump: false, ..input }).unwrap();
        assert_eq!(next == other, hash(next) == hash(other), "frame {frame}");
        differ += u32::from(next != other);
    }
    assert!(differ > 30);
}

/// Movers are equal by what they do, and so are their hashes: which functions they link is no part.
#[test]
fn movers_and_walkers() {
    let mover = Mover::platformer(Axis::NEG_Y);
    let bounces = mover.with_response(Response::Bounce);
    let back = bounces.with_response(Response::Slide);
    assert_eq!((mover == back, hash(mover) == hash(back)), (true, true));
    assert!(mover != bounces && hash(mover) != hash(bounces));
    let rough = |percent| mover.with_surface(Surface::new(Ratio::ZERO, Ratio::percent(percent).unwrap()));
    assert!(rough(30) == rough(30) && hash(rough(30)) == hash(rough(30)) && hash(rough(30)) != hash(rough(31)));
    let walker = Walker::new(mover).with_step(fx!(4)).unwrap();
    assert_eq!(hash(walker), hash(Walker::new(back).with_step(fx!(4)).unwrap()));
    assert_ne!(hash(walker), hash(walker.with_step(fx!(5)).unwrap()));
}

/// What a call returns: the keys of solids that it names, and its hash.
#[test]
fn hits_name_their_solids() {
    let level = TileMap::from_ascii("....\n....\n####\n", &KINDS).unwrap();
    let lift = [Solid::new(boxed(16, 20, 16, 12), 65_535).unwrap()];
    let solids = tilesat::Solids::new(&lift);
    let joined = tilesat::Joined::new(&level, &solids);
    let mover = Mover::platformer(Axis::NEG_Y);
    let fall = |x| mover.move_and_slide(&joined, &boxed(x, 4, 8, 8), Vec2::from_ints(0, 24)).unwrap();
    let key = |x| fall(x).hits.first().unwrap().solid();
    assert_eq!((key(20), key(40)), (Some(65_535), None));
    assert!(fall(20) == fall(20) && hash(fall(20)) == hash(fall(20)) && hash(fall(20)) != hash(fall(40)));
    let floor = |x| mover.supported(&joined, &fall(x).body).unwrap().unwrap().solid();
    assert_eq!((floor(20), floor(40)), (Some(65_535), None));
    let ridden = mover.ride(&level, &lift, &fall(20).body, fx!(1)).unwrap();
    assert_eq!((ridden.ride, ridden.floor), (Ride::Carried, Some(65_535)));
    assert_eq!(hash(ridden), hash(mover.ride(&level, &lift, &fall(20).body, fx!(1)).unwrap()));
}
