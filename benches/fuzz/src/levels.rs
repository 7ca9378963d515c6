//! Queries on levels. Judges that know only the definitions check tiles and segments.

use tilesat::{
    Aabb, Circle, Fx, Grid, Inside, Outside, SegmentMap, TileKind, TileKinds, TileMap, Vec2, world::RayRules,
};
use tilesat_judge::Random;
use tilesat_judge::blocks::ask as world_oracle;
use tilesat_judge::rays::check as shape_rays;
use tilesat_judge::segments::rays as segment_world_rays;
use tilesat_judge::segments::{Body, P, Scene, build, cross, sub};
use tilesat_judge::shapes::judge::{Body as Figure, Judge};
use tilesat_judge::shapes::level::Level;
use tilesat_judge::shapes::met as shape_overlap;

/// Queries per level: one per byte, up to this number.
const QUESTIONS: u32 = 12;

fn questions(mut ask: impl FnMut()) {
    ask();
    (1..QUESTIONS).take_while(|_| Random::is_left()).for_each(|_| ask());
}

/// Flags of which every two tiles have one in common. The tests' own tiles have one each.
const SHARED: [u8; 3] = [0b0011, 0b0110, 0b1101];

static KINDS: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::FULL)
    .with(2, TileKind::ONE_WAY_UP)
    .with(3, TileKind::EMPTY.with_flags(SHARED[0]))
    .with(4, TileKind::FULL.with_flags(SHARED[1]))
    .with(5, TileKind::ONE_WAY_UP.with_flags(SHARED[2]));

/// Blocks: rays, overlap, touch and flags.
pub(crate) fn tiles(data: &[u8]) {
    let mut r = Random::steered(data);
    let level = tilesat_judge::blocks::build::level(&mut r);
    let (scene, map) = (tilesat_judge::blocks::rays::Scene::new(&level), level.map());
    let origin = Vec2::from_raw(level.x as i32, level.y as i32);
    let grid = Grid::new(level.width as u16, level.height as u16, Fx::from_bits(level.cell as i32), origin);
    let flagged = TileMap::on_grid(&level.tiles, grid.expect("as above"), &KINDS).expect("the same tiles");
    questions(|| {
        let (o, d) = world_oracle::ray(&mut r, &level);
        world_oracle::check_ray(&level, &scene, &map, o, d);
        let body = world_oracle::body(&mut r, &level);
        let told = match world_oracle::shape(body) {
            world_oracle::Shape::Box(b) => (map.overlaps(&b), map.touches(&b), flagged.flags_touched(&b)),
            world_oracle::Shape::Circle(b) => (map.overlaps(&b), map.touches(&b), flagged.flags_touched(&b)),
        };
        let (overlaps, touches) = (tilesat_judge::blocks::bodies::overlaps, tilesat_judge::blocks::bodies::touches);
        let touched = tilesat_judge::blocks::bodies::flags(&level, body);
        let flags = (0..3).filter(|k| touched >> k & 1 != 0).fold(0, |all, k| all | SHARED[k]);
        let expected = (overlaps(&level, body), touches(&level, body), flags);
        assert_eq!(told, expected, "(overlaps, touches, flags) {level:?} {body:?}");
    });
}

/// Tiles of all shapes: overlap and touch, with and without the table of rows.
pub(crate) fn tile_shapes(data: &[u8]) {
    let mut r = Random::steered(data);
    let level = tilesat_judge::shapes::build::mosaic(&mut r);
    let judge = Judge::new(&level);
    // Other shapes of a level often hide the fault of one. So this level has one shape.
    let alone =
        Level { width: 1, height: 1, outside: Outside::Empty, tiles: level.tiles[..1].to_vec(), ..level.clone() };
    let judge_alone = Judge::new(&alone);
    let mut met = shape_overlap::Met::default();
    questions(|| {
        let body = tilesat_judge::shapes::build::body(&mut r, &level);
        let larger = match body {
            Figure::Circle { c, r } => Figure::Circle { c, r: r + level.cell },
            body => body,
        };
        if tilesat_judge::shapes::build::in_domain(body) {
            met.check(&level, &judge, body);
            met.check(&alone, &judge_alone, body);
        }
        if tilesat_judge::shapes::build::in_domain(larger) {
            met.check(&alone, &judge_alone, larger);
        }
    });
}

/// Tiles of all shapes: every hit of rays.
pub(crate) fn tile_rays(data: &[u8]) {
    let mut r = Random::steered(data);
    let level = tilesat_judge::rays::level::Level::random(&mut r);
    let (scene, map) = (tilesat_judge::rays::cast::Scene::new(&level), level.map());
    questions(|| {
        let (o, d) = tilesat_judge::rays::generate::ray(&mut r, &level, &scene);
        shape_rays::check(&level, &scene, &map, o, d, &mut r);
    });
}

/// The flags of touched edges whose line has no part in common with any other edge. No edge cancels
/// those.
fn certain_flags(scene: &Scene, body: Body) -> u8 {
    let edges: Vec<((P, P), u8)> =
        scene.shapes.iter().flat_map(|s| s.edges().into_iter().map(|edge| (edge, s.flags))).collect();
    let beside = |(a, b): (P, P), (p, q): (P, P)| {
        let e = sub(b, a);
        let beyond = |v: fn(P) -> i128| v(p).max(v(q)) < v(a).min(v(b)) || v(a).max(v(b)) < v(p).min(v(q));
        cross(e, sub(p, a)) != 0 || cross(e, sub(q, a)) != 0 || beyond(|v| v.0) || beyond(|v| v.1)
    };
    let alone = |i: usize| (0..edges.len()).all(|k| k == i || beside(edges[i].0, edges[k].0));
    let touched = (0..edges.len()).filter(|&i| body.meets(edges[i].0.0, edges[i].0.1, true) && alone(i));
    touched.fold(0, |all, i| all | edges[i].1)
}

/// Polygons, walls and chains: overlap, touch and flags.
pub(crate) fn segments(data: &[u8]) {
    let mut r = Random::steered(data);
    let mut scene = build::scene(&mut r);
    // Two flags each, so that neighbours have one in common.
    scene.shapes.iter_mut().for_each(|shape| shape.flags |= shape.flags.rotate_left(1));
    let bytes = scene.bytes();
    let map = SegmentMap::from_bytes(&bytes).expect("what was built is taken");
    let blocking = scene.blocking();
    questions(|| {
        let body = scene.body(&mut r);
        let (overlaps, touches, flags) = match body {
            Body::Box { lo, hi } => {
                let b = Aabb::new(scene.vec2(lo), scene.vec2(hi)).expect("inside the domain");
                (map.overlaps(&b), map.touches(&b), map.flags_touched(&b))
            }
            Body::Circle { c, r } => {
                let b = Circle::new(scene.vec2(c), Fx::from_bits(r as i32)).expect("inside the domain");
                (map.overlaps(&b), map.touches(&b), map.flags_touched(&b))
            }
        };
        assert_eq!(overlaps, scene.overlaps(&blocking, body), "overlaps: {scene:?} {body:?}");
        assert_eq!(touches, scene.touches(&blocking, body), "touches: {scene:?} {body:?}");
        assert_eq!(flags & !scene.flags(body), 0, "flags: {scene:?} {body:?}");
        assert_eq!(certain_flags(&scene, body) & !flags, 0, "flags are missing: {scene:?} {body:?}");
    });
}

/// Polygons, walls and chains: every hit of rays.
pub(crate) fn segment_rays(data: &[u8]) {
    let mut r = Random::steered(data);
    let scene = build::scene(&mut r);
    let bytes = scene.bytes();
    let map = SegmentMap::from_bytes(&bytes).expect("what was built is taken");
    let faces = segment_world_rays::faces(&scene);
    questions(|| {
        let (o, mut e) = (scene.point(&mut r), scene.point(&mut r));
        match r.below(5) {
            0 => e.0 = o.0,
            1 => e.1 = o.1,
            2 => e = o,
            _ => {}
        }
        let inside = if r.one_in(2) { Inside::Hit } else { Inside::Ignore };
        let rules = RayRules { inside, one_way: r.one_in(2) };
        segment_world_rays::check(&scene, &map, &faces, o, sub(e, o), rules);
    });
}
