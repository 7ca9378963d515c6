//! A rope that is nailed to the top of a block. It lies there, bends over the corner, and hangs.

use tilesat::motion::response::{Link, Particle, Quiet, Stick};
use tilesat::{Fx, RangeError, Ratio, Vec2, fx};

use super::sticks::Sticks;

/// The number of points. Links are as long as two radii, so no corner gets between two points.
const POINTS: usize = 24;
const RADIUS: Fx = fx!(2);
const LINK: Fx = fx!(4);

/// A rope that runs straight to the right. Its first point is nailed here.
pub fn rope(nail: Vec2) -> Result<Sticks<POINTS, { POINTS - 1 }>, RangeError> {
    let mut points = [Particle::at(nail); POINTS];
    for (k, point) in (0..).zip(&mut points) {
        *point = Particle::at(nail + Vec2::new(LINK * k, Fx::ZERO));
    }
    let stick = Stick::rope(LINK)?;
    let mut links = [Link { a: 0, b: 1, stick: stick.with_share_of_a(Ratio::ZERO) }; POINTS - 1];
    for (k, link) in (1..).zip(links.iter_mut().skip(1)) {
        *link = Link { a: k, b: k + 1, stick };
    }
    Ok(Sticks { points, links, radius: RADIUS, nails: 1, rounds: 24, quiet: Quiet::NOT })
}
