//! The judge: how deep a body is in the walls of a convex room, and its energy. Uses f64, on
//! positions that f64 holds exactly.

use crate::engine::State;
use crate::scene::{Scene, Shape};

pub struct Room {
    /// Unit normals into the room, and the least distance of the centre along each.
    planes: Vec<([f64; 2], f64)>,
    /// A body is lost if its centre is this far outside: two radii beyond the contact.
    lost: f64,
    /// Pixels per frame per frame.
    gravity: f64,
    lowest: f64,
}

impl Room {
    pub fn new(scene: &Scene) -> Self {
        let corners: Vec<[f64; 2]> = scene.room.iter().map(|p| p.map(|c| f64::from(c) / 65536.0)).collect();
        let next = |i: usize| corners[(i + 1) % corners.len()];
        let area: f64 = corners.iter().enumerate().map(|(i, a)| a[0] * next(i)[1] - a[1] * next(i)[0]).sum();
        let half = match scene.shape {
            Shape::Ball(r) => [r, r],
            Shape::Box(half) => half,
        }
        .map(|c| f64::from(c) / 65536.0);
        let plane = |(i, a): (usize, &[f64; 2])| {
            let d = [next(i)[0] - a[0], next(i)[1] - a[1]];
            let length = d[0].hypot(d[1]).copysign(area);
            let n = [-d[1] / length, d[0] / length];
            let support = match scene.shape {
                Shape::Ball(_) => half[0],
                Shape::Box(_) => half[0] * n[0].abs() + half[1] * n[1].abs(),
            };
            (n, n[0] * a[0] + n[1] * a[1] + support)
        };
        Self {
            planes: corners.iter().enumerate().map(plane).collect(),
            lost: 2.0 * half[0].max(half[1]),
            gravity: f64::from(scene.gravity) / 65536.0,
            lowest: scene.lowest,
        }
    }

    /// How deep the body is in a wall, in pixels. Negative: its distance to the nearest wall.
    pub fn depth(&self, centre: [f64; 2]) -> f64 {
        let deep = self.planes.iter().map(|(n, offset)| offset - n[0] * centre[0] - n[1] * centre[1]);
        deep.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether it has left the room.
    pub fn is_lost(&self, state: &State, depth: f64) -> bool {
        !(state.centre[0].is_finite() && state.centre[1].is_finite()) || depth > self.lost
    }

    /// Its height above the lowest position of its centre, in pixels.
    pub fn height(&self, centre: [f64; 2]) -> f64 {
        self.lowest - centre[1]
    }

    /// The energy of a unit mass.
    pub fn energy(&self, state: &State) -> f64 {
        let [x, y] = state.velocity;
        (x * x + y * y) / 2.0 + self.gravity * self.height(state.centre)
    }
}
