//! The level of the chapter's first program: the laser, the guard's view and the ball.

use std::error::Error;

use tilesat::{Circle, Inside, TileKind, TileKinds, TileMap, Vec2, fx};
use tilesat_tools::picture::ink::{COIN, Ink, KILL, SLIDE, TEXT, WIN};
use tilesat_tools::picture::marks::Scene;

use super::draw::{View, page};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

pub(crate) fn picture() -> Result<Scene, Box<dyn Error>> {
    let level = TileMap::from_ascii("........\n...#....\n....#...\n########\n", &KINDS)?;
    let mut scene = page(760.0, 276.0);
    let view = View { at: (12.0, 10.0), scale: 4.0 };
    view.level(&mut scene, &level, &level.bounds());
    let p = Vec2::from_ints;

    // How far the ball rolls, and the points that it touches there.
    let ball = Circle::new(p(8, 24), fx!(5))?;
    let found = level.cast_shape(&ball, p(200, 0), Inside::Hit)?.ok_or("no wall")?;
    let stop = found.body;
    for ball in [ball, stop] {
        scene.ring(view.spot(ball.centre()), 20.0, 2.0, SLIDE);
    }

    // A ray down: is there a floor? The laser ends at the wall.
    for (from, way, ink) in [(p(8, 24), p(200, 0), KILL), (p(20, 44), p(0, 8), WIN)] {
        let hit = level.cast_ray(from, way, Inside::Hit)?.ok_or("no hit")?;
        view.path(&mut scene, &[from, hit.point], ink);
        scene.disc(view.spot(from), 4.0, ink);
        view.arrow(&mut scene, hit.point, hit.axis.unit().scaled(fx!(7)), TEXT);
    }

    // Both eyes: one sees, the other one does not see between the tiles.
    for (eye, at) in [(p(8, 24), p(40, 40)), (p(56, 40), p(72, 24))] {
        let ink = if level.line_of_sight(eye, at)? { COIN } else { COIN.alpha(0.4) };
        view.path(&mut scene, &[eye, at], ink);
        scene.disc(view.spot(eye), 4.0, COIN);
        scene.disc(view.spot(at), 4.0, ink);
    }
    let lines: [(&str, Ink); 6] = [
        ("a laser", KILL),
        ("a ball that is cast", SLIDE),
        ("a line of sight", COIN),
        ("and a blocked one", COIN.alpha(0.4)),
        ("a ray to the floor", WIN),
        ("a normal", TEXT),
    ];
    for (y, (text, ink)) in [40.0, 66.0, 92.0, 118.0, 144.0, 170.0].into_iter().zip(lines) {
        scene.disc((542.0, y - 5.0), 5.0, ink);
        scene.text((554.0, y), text, TEXT);
    }
    Ok(scene)
}
