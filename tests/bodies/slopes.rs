//! Scenes: bodies that slide together between two slopes come to rest. Units, y down.

use tilesat::broad::{Handle, SortSweep};
use tilesat::query::Contacts;
use tilesat::scene::{SceneBody, SceneTag, Shape};
use tilesat::{Aabb, Circle, Fx, Ratio, Scene, Slopes, Surface, TileKind, TileKinds, TileMap, TileShape, Vec2, fx};
use tilesat_judge::scenes::BODIES;
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight));

type Few = Scene<SortSweep<BODIES, SceneTag>, BODIES>;

/// A V with its lowest point at x = 128.
fn valley() -> String {
    let rows = (0..7).map(|k| format!("{0}\\{1}/{0}\n", "#".repeat(k + 1), ".".repeat(12 - 2 * k)));
    "#..............#\n".repeat(6) + &rows.collect::<String>() + &"#".repeat(16)
}

/// Boxes or balls that fall into the V one after another.
fn bodies(scene: &mut Few, r: &mut Random, (boxed, count, friction): (bool, i16, u8)) -> Vec<Handle> {
    let surface = Surface::new(Ratio::ZERO, Ratio::percent(friction).unwrap());
    let between =
        |r: &mut Random, from: i32, to: i32| Fx::from_bits((from << 16) + r.below(i64::from(to - from) << 16) as i32);
    let mut place = |k: i16| {
        let half = Vec2::new(between(r, 4, 10), between(r, 4, 10));
        let at = Vec2::new(between(r, 70, 186), Fx::from(60 - 22 * k));
        let shape: Shape = if boxed {
            Aabb::new(at - half, at + half).unwrap().into()
        } else {
            Circle::new(at, half.x).unwrap().into()
        };
        scene.insert(&SceneBody { surface, ..SceneBody::new(shape, k as u32) }).unwrap()
    };
    (0..count).map(&mut place).collect()
}

/// Gravity moves a body along a slope in each step. If the others that it presses did not take that
/// velocity, all of them would shake for ever. With boxes and a friction of 20 percent, 52 of 80
/// scenes did.
#[test]
fn bodies_in_a_valley_come_to_rest() {
    let text = valley();
    let map = TileMap::<Slopes>::of_ascii(&text, &KINDS).unwrap();
    for (boxed, friction, allowed) in [(true, 20, 0), (true, 50, 0), (false, 0, 2), (false, 20, 2)] {
        let (mut runs, mut moving, mut deepest) = (0, 0, Fx::ZERO);
        for count in [3, 4, 6, 8] {
            for case in 0..cases(20) {
                let mut scene = Few::new(SortSweep::new());
                let all = bodies(&mut scene, &mut Random::new(case), (boxed, count, friction));
                let mut steps = 0;
                while steps < 1000 && !scene.awake().is_empty() {
                    scene.step(&map, Vec2::new(Fx::ZERO, fx!(0.25)), |_| {}).unwrap();
                    steps += 1;
                }
                (runs, moving) = (runs + 1, moving + i32::from(steps == 1000));
                let shape = |at: &Handle| scene.body(*at).unwrap().shape;
                for (k, a) in all.iter().enumerate() {
                    assert!(!map.overlaps(&shape(a).aabb()) || !boxed, "{case} {count}: in the level");
                    for contact in all[..k].iter().filter_map(|b| shape(a).contact(&shape(b))) {
                        deepest = deepest.max(contact.depth());
                    }
                }
            }
        }
        println!("boxes {boxed}, friction {friction}: {moving} of {runs} move, the deepest overlap is {deepest}");
        assert!(moving * 100 <= runs * allowed, "{boxed} {friction}: {moving} of {runs}");
        assert!(deepest < fx!(2.5), "{boxed} {friction}: {deepest}");
    }
}
