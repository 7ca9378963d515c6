//! Which surfaces are floor, wall and ceiling, and a slide along a slope.

use std::error::Error;

use tilesat::{
    Aabb, AllShapes, Axis, Circle, Mover, Response, TileKind, TileKinds, TileMap, TileShape, Vec2, World, fx,
};
use tilesat_tools::picture::ink::{COIN, FAINT, Ink, KILL, PLAYER, SLIDE, TEXT, WIN};
use tilesat_tools::picture::marks::Scene;
use tilesat_tools::picture::surface;

use super::draw::{View, page};

const FLOOR: Ink = WIN;
const WALL: Ink = COIN;
const CEILING: Ink = KILL;

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'1', TileKind::of(TileShape::ConvexBottomRight))
    .with(b'2', TileKind::of(TileShape::ConvexBottomLeft))
    .with(b'3', TileKind::of(TileShape::ConvexTopRight))
    .with(b'4', TileKind::of(TileShape::ConvexTopLeft))
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'a', TileKind::of(TileShape::MildLowBottomRight))
    .with(b'b', TileKind::of(TileShape::MildHighBottomRight))
    .with(b's', TileKind::of(TileShape::SteepLowBottomRight))
    .with(b'S', TileKind::of(TileShape::SteepHighBottomRight));

pub(crate) fn picture() -> Result<Scene, Box<dyn Error>> {
    let mut scene = page(760.0, 264.0);
    let mover = Mover::platformer(Axis::NEG_Y);
    let view = View { at: (16.0, 16.0), scale: 2.7 };
    let level = TileMap::<AllShapes>::of_ascii("..........\n.12.....s.\n.34..../S.\n.....ab##.\n", &KINDS)?;
    view.level(&mut scene, &level, &level.bounds());
    for feature in World::features(&level, &level.bounds()) {
        for (a, b) in surface::lines(&feature.geometry) {
            let ink = kind(&mover, &level, a, b)?;
            let spot = |p: (f32, f32)| (view.at.0 + p.0 * view.scale, view.at.1 + p.1 * view.scale);
            scene.line(vec![spot(a), spot(b)], 3.5, ink, false);
        }
    }
    for (i, (text, ink)) in
        [("floor: up to 45 degrees", FLOOR), ("wall", WALL), ("ceiling", CEILING)].into_iter().enumerate()
    {
        let at = (16.0 + [0.0, 252.0, 326.0][i], 254.0);
        scene.disc((at.0 + 5.0, at.1 - 5.0), 5.0, ink);
        scene.text((at.0 + 16.0, at.1), text, TEXT);
    }
    slide(&mut scene, &mover)?;
    Ok(scene)
}

/// What a mover reports if a small ball runs into the middle of a line, straight at it.
fn kind(mover: &Mover, level: &impl World, a: (f32, f32), b: (f32, f32)) -> Result<Ink, Box<dyn Error>> {
    let (x, y) = (b.0 - a.0, b.1 - a.1);
    let long = x.hypot(y);
    let out = Vec2::from_f32(y / long, -x / long).ok_or("range")?;
    let on = Vec2::from_f32(a.0.midpoint(b.0), a.1.midpoint(b.1)).ok_or("range")?;
    let ball = Circle::new(on + out * fx!(1.5), fx!(1))?;
    let moved = mover.move_and_slide(level, &ball, out * fx!(-2))?;
    Ok(match (moved.floor, moved.wall, moved.ceiling) {
        (true, false, false) => FLOOR,
        (false, true, false) => WALL,
        (false, false, true) => CEILING,
        other => return Err(format!("{other:?} at {on:?}").into()),
    })
}

/// A body before a motion, at its hit, and after the motion, with its velocities.
fn slide(scene: &mut Scene, mover: &Mover) -> Result<(), Box<dyn Error>> {
    let view = View { at: (456.0, 16.0), scale: 3.4 };
    let level = TileMap::<AllShapes>::of_ascii(".....\n..../\n.../#\n#####\n", &KINDS)?;
    view.level(scene, &level, &level.bounds());
    let (body, velocity) = (Aabb::new(Vec2::from_ints(6, 35), Vec2::from_ints(18, 47))?, Vec2::from_ints(52, 0));
    let at_hit = mover.with_response(Response::Touch).move_and_slide(&level, &body, velocity)?.body;
    let moved = mover.move_and_slide(&level, &body, velocity)?;
    view.body(scene, &body, FAINT.alpha(0.6), true);
    view.body(scene, &at_hit, FAINT, false);
    view.body(scene, &moved.body, PLAYER, true);
    view.arrow(scene, body.centre(), velocity, TEXT);
    view.path(scene, &[at_hit.centre(), moved.body.centre()], SLIDE);
    view.arrow(scene, moved.body.centre(), moved.velocity, SLIDE);
    for (i, (text, ink)) in [("velocity", TEXT), ("afterwards", SLIDE)].into_iter().enumerate() {
        scene.line(vec![(456.0 + 130.0 * i as f32, 249.0), (476.0 + 130.0 * i as f32, 249.0)], 2.0, ink, false);
        scene.text((482.0 + 130.0 * i as f32, 254.0), text, TEXT);
    }
    Ok(())
}
