//! A walker with and without snap, step and another slope limit.

use std::error::Error;

use tilesat::{
    Aabb, AllShapes, Axis, Fx, MoveError, Mover, SlopeSpeed, TileKind, TileKinds, TileMap, TileShape, Vec2, Walker, fx,
};
use tilesat_tools::picture::ink::{PLAYER, TEXT, TOUCH};
use tilesat_tools::picture::marks::Scene;

use super::draw::{View, page};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'_', TileKind::of(TileShape::HalfBottom))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b's', TileKind::of(TileShape::SteepLowBottomRight))
    .with(b'S', TileKind::of(TileShape::SteepHighBottomRight));
const PANEL: f32 = 250.0;

struct Panel {
    rows: &'static str,
    /// The lower left corner of the body.
    feet: (i16, i16),
    frames: usize,
    without: (Walker, &'static str),
    with: (Walker, &'static str),
}

pub(crate) fn picture() -> Result<Scene, Box<dyn Error>> {
    let plain = Walker::new(Mover::platformer(Axis::NEG_Y)).with_slope_speed(SlopeSpeed::Constant);
    let plain = plain.with_snap(fx!(0))?.with_step(fx!(0))?;
    let goat = Walker::new(Mover::platformer(Axis::NEG_Y).with_slope_limit(2, 1));
    let panels = [
        Panel {
            rows: "......\n##\\...\n###\\..\n####\\.\n######\n",
            feet: (13, 16),
            frames: 27,
            without: (plain, "snap 0: it flies"),
            with: (plain.with_snap(fx!(4))?, "snap 4"),
        },
        Panel {
            rows: "......\n......\n......\n...___\n######\n",
            feet: (8, 64),
            frames: 24,
            without: (plain, "step 0: it stops"),
            with: (plain.with_step(fx!(8))?, "step 8"),
        },
        Panel {
            rows: "......\n......\n...s##\n...S##\n######\n",
            feet: (8, 64),
            frames: 30,
            without: (plain, "limit (1, 1): a wall"),
            with: (goat.with_snap(fx!(6))?, "limit (2, 1)"),
        },
    ];
    let mut scene = page(PANEL * 3.0 + 10.0, 258.0);
    for (i, panel) in panels.into_iter().enumerate() {
        let view = View { at: (10.0 + PANEL * i as f32, 8.0), scale: 2.5 };
        let level = TileMap::<AllShapes>::of_ascii(panel.rows, &KINDS)?;
        view.level(&mut scene, &level, &level.bounds());
        let (x, y) = panel.feet;
        let body = Aabb::new(Vec2::from_ints(x, y - 14), Vec2::from_ints(x + 10, y))?;
        for (way, ink) in [(&panel.without, TOUCH), (&panel.with, PLAYER)] {
            let bodies = walk(&way.0, &level, body, panel.frames)?;
            let feet: Vec<Vec2> = bodies.iter().map(|body| Vec2::new(body.centre().x, body.max().y)).collect();
            view.path(&mut scene, &feet, ink);
            view.body(&mut scene, bodies.last().ok_or("no frame")?, ink.alpha(0.8), true);
            for body in bodies.iter().step_by(6) {
                view.body(&mut scene, body, ink.alpha(0.6), false);
            }
        }
        for (y, (text, ink)) in [228.0, 248.0].into_iter().zip([(panel.without.1, TOUCH), (panel.with.1, PLAYER)]) {
            scene.disc((view.at.0 + 6.0, y - 5.0), 5.0, ink);
            scene.text((view.at.0 + 18.0, y), text, TEXT);
        }
    }
    Ok(scene)
}

/// The bodies of some frames, from the first on, at 2 units per frame to the right.
fn walk(walker: &Walker, level: &TileMap<'_, AllShapes>, body: Aabb, frames: usize) -> Result<Vec<Aabb>, MoveError> {
    let (mut bodies, mut fall, mut floor) = (vec![body], fx!(0), None);
    for _ in 0..frames {
        let velocity = Vec2::new(fx!(2), fall + fx!(0.25));
        let walked = walker.walk(level, &bodies[bodies.len() - 1], velocity, floor)?;
        fall = if walked.on_floor() { Fx::ZERO } else { walked.moved.velocity.y };
        floor = walked.floor;
        bodies.push(walked.moved.body);
    }
    Ok(bodies)
}
