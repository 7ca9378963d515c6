//! A fast body in a corner meets the floor and the wall in each step. How a step reports it depends
//! only on the bodies in its reach, in a scene that remembers as in one that looks.

use tilesat::broad::{Handle, SortSweep};
use tilesat::scene::{SceneBody, SceneEvent, SceneTag, Sleep};
use tilesat::{Aabb, Filter, Scene, TileKind, TileKinds, TileMap, Vec2};
use tilesat_judge::scenes::BODIES;

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// The corner is at (32, 32).
const ROOM: &str = "..#\n..#\n###\n";
/// More than half of the width of the body in the corner.
const GRAVITY: Vec2 = Vec2::from_raw(49_152, 49_152);

type Bodies<const M: usize> = Scene<SortSweep<BODIES, SceneTag>, BODIES, M>;

fn boxed(x: i16, y: i16, side: i16) -> Aabb {
    Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(side, side)).unwrap()
}

/// A scene, the body in the corner, and one that floats far away.
fn corner<const M: usize>() -> (Bodies<M>, Handle, Handle) {
    let mut scene = Bodies::<M>::remembering(SortSweep::new(), Sleep::NEVER);
    let small = scene.insert(&SceneBody::new(boxed(31, 31, 1), 1)).unwrap();
    let far = scene.insert(&SceneBody { floats: true, ..SceneBody::new(boxed(600, 0, 6), 2) }).unwrap();
    (scene, small, far)
}

/// The numbers of hits in the reports of a body, in one step.
fn reports<const M: usize>(scene: &mut Bodies<M>, of: Handle) -> Vec<usize> {
    let (map, mut hits_of) = (TileMap::from_ascii(ROOM, &KINDS).unwrap(), Vec::new());
    let each = |event: SceneEvent<'_>| match event {
        SceneEvent::Level { body, hits, .. } if body == of => hits_of.push(hits.iter().count()),
        _ => {}
    };
    scene.step(&map, GRAVITY, each).unwrap();
    hits_of
}

/// A belt does not move by its velocity, so nothing is in reach. A far body counts for nothing.
fn fast_beside_a_belt<const M: usize>() {
    let (mut scene, small, far) = corner::<M>();
    let belt = SceneBody { velocity: Vec2::from_ints(16, 16), ..SceneBody::fixed(boxed(26, 10, 4), 3) };
    scene.insert(&belt).unwrap();
    for frame in 0..40 {
        if frame % 10 == 0 {
            scene.set_velocity(far, Vec2::from_ints(0, if frame % 20 == 0 { 0 } else { -60 })).unwrap();
        }
        assert_eq!(reports(&mut scene, small), [2], "{M}: {frame}");
    }
}

#[test]
fn a_belt_has_no_reach() {
    fast_beside_a_belt::<0>();
    fast_beside_a_belt::<BODIES>();
}

/// A body without a mass appears in reach, and touches nobody: the other is moved from hit to hit.
fn fixed_in_reach<const M: usize>(sensor: bool) -> Vec<Vec<usize>> {
    let (mut scene, small, _) = corner::<M>();
    let filter = Filter::default().with_sensor(sensor);
    let fixed = SceneBody { filter, ..SceneBody::fixed(boxed(10, 27, 4), 3) };
    let mut told: Vec<_> = (0..4).map(|_| reports(&mut scene, small)).collect();
    let fixed = scene.insert(&fixed).unwrap();
    told.extend((0..4).map(|_| reports(&mut scene, small)));
    scene.place(fixed, boxed(31, 26, 4)).unwrap();
    told.extend((0..4).map(|_| reports(&mut scene, small)));
    scene.remove(fixed).unwrap();
    told.extend((0..4).map(|_| reports(&mut scene, small)));
    told
}

#[test]
fn a_fixed_body_that_appears_in_reach_ends_idleness() {
    for sensor in [false, true] {
        let (looks, remembers) = (fixed_in_reach::<0>(sensor), fixed_in_reach::<BODIES>(sensor));
        assert_eq!((&looks[0], &looks[8]), (&vec![2], &vec![1, 1]), "{looks:?}");
        assert_eq!(looks, remembers, "{sensor}");
    }
}
