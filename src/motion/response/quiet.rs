//! When points that hang together have come to rest.

use super::Particle;
use crate::num::{Fx, Raw};

/// For how many steps in a row points have hardly moved.
///
/// Corrections that work against each other and against a floor may hum for ever, by a hundredth of a unit or so; a body of points is put to sleep
/// instead: when it has been [quiet](Self::for_steps) for some steps, make each point [`Particle::at`] its position, and step none of them
/// until something touches it. Plain data, to be kept beside the points.
///
/// ```
/// use tilesat::{Fx, Vec2, motion::response::{Particle, Quiet}};
/// let mut points = [Particle::at(Vec2::from_ints(1, 2)), Particle::moving(Vec2::from_ints(3, 4), Vec2::from_raw(0, 40))];
/// let mut quiet = Quiet::NOT;
/// for _ in 0..30 {
///     quiet = quiet.watch(&points, Fx::from_bits(4096));
/// }
/// assert!(quiet.for_steps(30));
/// points[0] = Particle::moving(points[0].position, Vec2::from_ints(0, 1));
/// assert_eq!(quiet.watch(&points, Fx::from_bits(4096)), Quiet::NOT);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Quiet {
    steps: u16,
}

impl Quiet {
    /// In motion.
    pub const NOT: Self = Self { steps: 0 };

    /// One step more in which no component of a velocity reached `still`, or none at all.
    ///
    /// Call it after the corrections of the step. Twice the acceleration of one step is a good `still`: what falls passes that in its third step.
    #[must_use]
    pub fn watch(self, points: &[Particle], still: Fx) -> Self {
        let all = points.iter().all(|point| {
            let v = Raw::of(point.velocity());
            v.x.unsigned_abs().max(v.y.unsigned_abs()) < still.to_bits().max(0).unsigned_abs()
        });
        Self { steps: if all { self.steps.saturating_add(1) } else { 0 } }
    }

    /// Whether it has been quiet for so many steps.
    #[must_use]
    pub const fn for_steps(self, steps: u16) -> bool {
        self.steps >= steps
    }
}
