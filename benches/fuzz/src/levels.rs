//! Questions about levels: tiles and segments against judges that know the definitions alone.

use crate::segment_world_support::{Body, build, sub};
use crate::stream::Random;
use crate::{segment_world_rays, shape_overlap, shape_rays, world_oracle};
use tilesat::{Aabb, Circle, Fx, Inside, RayRules, SegmentMap};

/// Questions of one level: as many as there are bytes, and not more than these.
const QUESTIONS: u32 = 12;

fn questions(mut ask: impl FnMut()) {
    ask();
    (1..QUESTIONS).take_while(|_| Random::is_left()).for_each(|_| ask());
}

/// Blocks: rays, overlap, touch, flags.
pub(crate) fn tiles(data: &[u8]) {
    let mut r = Random::of(data);
    let level = crate::support::build::level(&mut r);
    let (scene, map) = (crate::support::rays::Scene::new(&level), level.map());
    questions(|| {
        let (o, d) = world_oracle::ray(&mut r, &level);
        world_oracle::check_ray(&level, &scene, &map, o, d);
        let body = world_oracle::body(&mut r, &level);
        let told = match world_oracle::shape(body) {
            world_oracle::Shape::Box(b) => (map.overlaps(&b), map.touches(&b), map.flags_touched(&b)),
            world_oracle::Shape::Circle(b) => (map.overlaps(&b), map.touches(&b), map.flags_touched(&b)),
        };
        let (overlaps, touches) = (crate::support::bodies::overlaps, crate::support::bodies::touches);
        let expected = (overlaps(&level, body), touches(&level, body), crate::support::bodies::flags(&level, body));
        assert_eq!(told, expected, "(overlaps, touches, flags) {level:?} {body:?}");
    });
}

/// Tiles of all shapes: overlap and touch, with and without the table of rows.
pub(crate) fn tile_shapes(data: &[u8]) {
    let mut r = Random::of(data);
    let level = crate::solids::build::mosaic(&mut r);
    let judge = crate::solids::judge::Judge::new(&level);
    let mut met = shape_overlap::Met::default();
    questions(|| {
        let body = crate::solids::build::body(&mut r, &level);
        if crate::solids::build::in_domain(body) {
            met.check(&level, &judge, body);
        }
    });
}

/// Tiles of all shapes: every hit of rays.
pub(crate) fn tile_rays(data: &[u8]) {
    let mut r = Random::of(data);
    let level = crate::ray_support::level::Level::random(&mut r);
    let (scene, map) = (crate::ray_support::cast::Scene::new(&level), level.map());
    questions(|| {
        let (o, d) = crate::ray_support::rays::ray(&mut r, &level, &scene);
        shape_rays::check(&level, &scene, &map, o, d, &mut r);
    });
}

/// Polygons, walls and chains: overlap, touch and flags.
pub(crate) fn segments(data: &[u8]) {
    let mut r = Random::of(data);
    let scene = build::scene(&mut r);
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
    });
}

/// Polygons, walls and chains: every hit of rays.
pub(crate) fn segment_rays(data: &[u8]) {
    let mut r = Random::of(data);
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
