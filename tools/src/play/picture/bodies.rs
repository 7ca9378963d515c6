//! Draws bodies at their end, their ways, and their hits.

use tilesat::motion::Response;

use tilesat_games::platformer::sim::{Actor, Shape};

use crate::picture::ink::{BOUNCE, CONTACT, CROSS, Ink, KILL, NIGHT, PLAYER, SLIDE, TOUCH};
use crate::picture::marks::{Scene, Spot};
use crate::play::run::Run;
use crate::play::trail::Point;

pub(super) fn ink(response: Response) -> Ink {
    match response {
        Response::Slide => SLIDE,
        Response::Touch => TOUCH,
        Response::DropThrough => CROSS,
        Response::Bounce => BOUNCE,
    }
}

pub(super) fn trails(scene: &mut Scene, run: &Run) {
    let width = scene.unit.max(1.0 / scene.scale);
    for (i, (actor, trail)) in run.actors.iter().zip(&run.trails).enumerate().rev() {
        let points: Vec<&Point> = trail.iter().collect();
        let mut pieces = points.chunk_by(|_, next| !next.fresh).peekable();
        while let Some(piece) = pieces.next() {
            let line: Vec<Spot> = piece.iter().map(|p| p.at).collect();
            if i == 0 {
                scene.line(line.clone(), width * 2.4, PLAYER.alpha(0.18), false);
                scene.line(line, width, PLAYER.alpha(0.8), false);
                if let (Some(end), Some(_)) = (piece.last(), pieces.peek()) {
                    death(scene, end.at);
                }
            } else {
                scene.line(line, width * 1.1, ink(actor.response).alpha(0.75), true);
            }
        }
    }
}

fn death(scene: &mut Scene, (x, y): Spot) {
    let (arm, width) = (scene.unit * 3.5, scene.unit * 1.6);
    for side in [-1.0, 1.0] {
        let line = vec![(x - arm * side, y - arm), (x + arm * side, y + arm)];
        scene.line(line, width, KILL, false);
    }
}

/// Draws a dot where a body first hit the level in a frame, unless it hit the same side one frame
/// earlier.
pub(super) fn contacts(scene: &mut Scene, run: &Run) {
    let radius = (scene.unit * 1.3).max(1.2 / scene.scale);
    for (actor, trail) in run.actors.iter().zip(&run.trails) {
        let (mut before, mut met) = (None, false);
        for point in trail {
            if let Some(normal) = point.hit {
                if before != point.hit {
                    scene.disc(support(actor, point.at, normal), radius, CONTACT.alpha(0.9));
                }
                (before, met) = (point.hit, true);
            } else if !std::mem::take(&mut met) {
                before = None;
            }
        }
    }
}

/// The point of a body farthest against a normal. Along a flat side, its middle.
fn support(actor: &Actor, middle: Spot, normal: (i32, i32)) -> Spot {
    let (x, y) = (-normal.0 as f32, -normal.1 as f32);
    match actor.shape {
        Shape::Ball(circle) => {
            let reach = circle.radius().to_num::<f32>() / x.hypot(y).max(1.0);
            (middle.0 + x * reach, middle.1 + y * reach)
        }
        Shape::Box(aabb) => {
            let size = aabb.size();
            let side = |v: f32| if v == 0.0 { 0.0 } else { v.signum() };
            (middle.0 + side(x) * size.x.to_num::<f32>() / 2.0, middle.1 + side(y) * size.y.to_num::<f32>() / 2.0)
        }
    }
}

pub(super) fn bodies(scene: &mut Scene, run: &Run) {
    for (i, actor) in run.actors.iter().enumerate().rev() {
        let ink = if i == 0 { PLAYER } else { ink(actor.response) };
        match actor.shape {
            Shape::Ball(circle) => {
                let centre = (circle.centre().x.to_num(), circle.centre().y.to_num());
                let radius: f32 = circle.radius().to_num();
                scene.disc(centre, radius, ink);
                scene.ring(centre, (radius - 0.6).max(0.3), 1.2, NIGHT.alpha(0.45));
                scene.disc((centre.0 - radius * 0.3, centre.1 - radius * 0.3), radius * 0.22, CONTACT.alpha(0.55));
            }
            Shape::Box(aabb) => {
                let at = (aabb.min().x.to_num::<f32>(), aabb.min().y.to_num::<f32>());
                let size = (aabb.size().x.to_num::<f32>(), aabb.size().y.to_num::<f32>());
                scene.rect(at, size, NIGHT);
                let rim = size.0.min(size.1).min(8.0) / 8.0;
                let inner = (size.0 - 2.0 * rim, size.1 - 2.0 * rim);
                scene.rect((at.0 + rim, at.1 + rim), inner, ink);
                if i == 0 {
                    face(scene, at, size);
                }
            }
        }
    }
}

fn face(scene: &mut Scene, at: Spot, size: Spot) {
    for x in [0.3, 0.7] {
        scene.disc((at.0 + size.0 * x, at.1 + size.1 * 0.35), size.0 * 0.1, NIGHT);
    }
}
