//! Fast bodies on curves and in corridors, with another body in reach.

use tilesat::scene::{SceneBody, SortSweepScene};
use tilesat::{Aabb, AllShapes, Circle, Filter, Fx, Ratio, Surface, TileKind, TileKinds, TileMap, TileShape, Vec2, fx};

static KINDS: TileKinds =
    TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b')', TileKind::of(TileShape::ConcaveBottomRight));

fn map(text: &'static str) -> TileMap<'static, AllShapes> {
    TileMap::of_ascii(text, &KINDS).unwrap()
}

fn ball(x: i16, y: i16, r: i16) -> Circle {
    Circle::new(Vec2::from_ints(x, y), Fx::from(r)).unwrap()
}

fn coin(x: i16, y: i16) -> SceneBody {
    let place = Aabb::from_size(Vec2::from_ints(x, y), Vec2::from_ints(8, 8)).unwrap();
    SceneBody { filter: Filter::default().with_sensor(true), ..SceneBody::fixed(place, 2) }
}

/// A wall leads into a quarter pipe without a bend. A body that falls along it goes through.
#[test]
fn fast_bodies_enter_quarter_pipes() {
    let level = map("#...#\n#...#\n#...#\n#..)#\n#####");
    for restitution in [Ratio::ZERO, Ratio::HALF, Ratio::ONE] {
        for height in 6..40 {
            let mut scene = SortSweepScene::<4>::empty();
            let surface = Surface::new(restitution, Ratio::ZERO);
            let body = SceneBody { fast: true, surface, ..SceneBody::new(ball(59, height, 5), 1) };
            let handle = scene.insert(&body).unwrap();
            scene.insert(&coin(44, 40)).unwrap();
            let mut left = Fx::MAX;
            for _ in 0..80 {
                scene.step(&level, Vec2::new(Fx::ZERO, fx!(0.125)), |_| {}).unwrap();
                let now = scene.body(handle).unwrap();
                assert!(now.velocity.length() < fx!(4), "{restitution:?} from {height}: {now:?}");
                left = left.min(now.shape.position().x);
            }
            assert!(left < fx!(30), "{restitution:?} from {height}: no farther than {left}");
        }
    }
}

/// Between a floor and a ceiling that both touch it, a body only moves along them.
#[test]
fn fast_bodies_pass_tight_corridors() {
    let level = map("##########\n..........\n##########");
    for restitution in [Ratio::ZERO, Ratio::HALF, Ratio::ONE] {
        let mut scene = SortSweepScene::<4>::empty();
        let surface = Surface::new(restitution, Ratio::ZERO);
        let velocity = Vec2::from_ints(1, 2);
        let body = SceneBody { fast: true, surface, velocity, ..SceneBody::new(ball(24, 24, 8), 1) };
        let handle = scene.insert(&body).unwrap();
        scene.insert(&coin(60, 20)).unwrap();
        for _ in 0..60 {
            scene.step(&level, Vec2::new(Fx::ZERO, fx!(0.125)), |_| {}).unwrap();
        }
        let now = scene.body(handle).unwrap();
        assert_eq!((now.shape.position(), now.velocity), (Vec2::from_ints(84, 24), Vec2::from_ints(1, 0)));
    }
}
