//! Bodies that fly, stand and walk.

use tilesat::motion::{MoveError, Response};
use tilesat::{Aabb, Circle, Filter, LayerMask, Mover, RangeError, Vec2};

use super::level::{Level, SPONGE};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A box in which the player is repaired: a sensor.
    Zone,
    Player,
    /// Armoured: shots bounce off, but they count.
    Turret,
    Spinner,
    /// Walks to and fro, and sleeps sometimes.
    Patrol,
    /// An enemy's bullet. Bounces off the level twice.
    Bullet,
    /// The player's bullet. Ends at the level.
    Shot,
}

const ZONE: LayerMask = LayerMask::layer(0);
const PLAYER: LayerMask = LayerMask::layer(1);
const ENEMY: LayerMask = LayerMask::layer(2);
const BULLET: LayerMask = LayerMask::layer(3);
const SHOT: LayerMask = LayerMask::layer(4);

impl Kind {
    pub const fn is_enemy(self) -> bool {
        matches!(self, Self::Turret | Self::Spinner | Self::Patrol)
    }

    pub const fn filter(self) -> Filter {
        match self {
            Self::Zone => Filter::new(ZONE, PLAYER.with(ENEMY)).with_still(true).with_sensor(true),
            Self::Player => Filter::new(PLAYER, ZONE.with(ENEMY).with(BULLET)),
            Self::Turret | Self::Spinner => Self::Patrol.filter().with_still(true),
            // Patrols may bunch up without harm.
            Self::Patrol => Filter::new(ENEMY, ZONE.with(PLAYER).with(BULLET).with(SHOT)),
            Self::Bullet => Filter::new(BULLET, PLAYER.with(ENEMY)),
            Self::Shot => Filter::new(SHOT, ENEMY),
        }
    }

    /// Half of the body's box: the radius, except for the zone.
    pub const fn half(self) -> Vec2 {
        match self {
            Self::Zone => Vec2::from_ints(24, 16),
            Self::Player => Vec2::from_ints(6, 6),
            Self::Turret | Self::Spinner | Self::Patrol => Vec2::from_ints(7, 7),
            Self::Bullet | Self::Shot => Vec2::from_ints(2, 2),
        }
    }
}

/// Lives of the player.
pub(super) const FULL: u8 = 16;

/// The part of a body that the broad phase does not keep.
#[derive(Debug, Clone, Copy)]
pub struct Body {
    pub velocity: Vec2,
    pub kind: Kind,
    /// Hits that it can still take. Without any it disappears.
    pub life: u8,
    /// For bullets, the frames left. For other bodies, the frames since they appeared.
    pub clock: u16,
}

/// The result of a body's motion.
#[derive(Debug, Clone, Copy, Default)]
pub struct Flight {
    pub bounces: u32,
    pub refused: u32,
}

impl Body {
    pub const NONE: Self = Self { velocity: Vec2::ZERO, kind: Kind::Zone, life: 0, clock: 0 };

    /// The shape in the broad phase's box. The box of a circle is exact, so the circle is too.
    pub fn circle(&self, bounds: &Aabb) -> Result<Circle, RangeError> {
        Circle::new(bounds.centre(), self.kind.half().x)
    }

    /// Whether a patrol sleeps in its present frame.
    pub const fn sleeps(&self) -> bool {
        matches!(self.kind, Kind::Patrol) && self.clock % 256 >= 160
    }

    /// Flies for one frame. Returns its new box.
    pub fn fly(&mut self, level: &Level, bounds: &Aabb, flight: &mut Flight) -> Aabb {
        let response = match self.kind {
            Kind::Zone | Kind::Turret | Kind::Spinner => return *bounds,
            Kind::Patrol if self.sleeps() => return *bounds,
            Kind::Player => Response::Slide,
            Kind::Patrol | Kind::Bullet => Response::Bounce,
            Kind::Shot => Response::Touch,
        };
        let mover = Mover::new().with_response(response);
        // By reference: a copy of the answer would take another 150 bytes of stack.
        let circle = self.circle(bounds).map_err(MoveError::from);
        let moved = &circle.and_then(|circle| mover.move_and_slide(level, &circle, self.velocity));
        let Ok(moved) = moved else {
            flight.refused += 1;
            return *bounds;
        };
        self.velocity = moved.velocity;
        let hits = moved.hits.len() as u8;
        match self.kind {
            Kind::Bullet => {
                flight.bounces += u32::from(hits);
                self.clock = self.clock.saturating_sub(1);
                self.life = self.life.saturating_sub(hits);
                if self.clock == 0 || moved.flags & SPONGE != 0 {
                    self.life = 0;
                }
            }
            Kind::Shot => self.life = self.life.saturating_sub(hits),
            _ => {}
        }
        moved.body.aabb()
    }
}
