//! The game: two players in an arena. They run and jump through 62 crates and balls.
//!
//! One value holds all of it. A step reads only that value, the keys of both players and the level
//! in flash. So the same value and the same keys give the same bits on every machine.

use super::Keys;
use core::num::NonZeroU8;
use tilesat::broad::{Handle, SortSweep};
use tilesat::scene::{SceneBody, SceneError, SceneTag, Snapshot};
use tilesat::{
    Aabb, Circle, Fx, RangeError, Ratio, Scene, Surface, TileKind, TileKinds, TileMap, TileMapError, Vec2, fx,
};

/// The number of bodies.
pub const BODIES: usize = 64;

const GRAVITY: Vec2 = Vec2::new(Fx::ZERO, fx!(0.25));
const RUN: Fx = fx!(2);
const JUMP: Fx = fx!(5);

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
/// Cells of 16 units.
const ROWS: &str = "\
##############################
#............................#
#............................#
#............................#
#......####........####......#
#............................#
#...........######...........#
#............................#
#....####............####....#
#............................#
#............................#
##############################
";

/// The level. No step changes it.
pub type Arena = TileMap<'static>;

/// The level.
pub fn arena() -> Result<Arena, TileMapError> {
    TileMap::from_ascii(ROWS, &KINDS)
}

type Bodies = Scene<SortSweep<BODIES, SceneTag>, BODIES>;

/// The state between two frames, to save and to compare.
pub type Saved = Snapshot<SortSweep<BODIES, SceneTag>, BODIES>;

// The type that a history stores.
const _: () = assert!(size_of::<Saved>() <= 8192);

/// The state of the game.
#[derive(Clone, Copy, Debug)]
pub struct Game {
    scene: Bodies,
    players: [Option<Handle>; 2],
}

impl Game {
    /// The start state, the same on both machines.
    pub fn new() -> Result<Self, SceneError> {
        let mut scene = Bodies::new(SortSweep::new());
        let wood = Surface::new(Ratio::ZERO, Ratio::HALF);
        let rubber = Surface::new(Ratio::HALF, Ratio::HALF).resting_below(fx!(0.5));
        let mut players = [None; 2];
        for (key, (place, x)) in (0..).zip(players.iter_mut().zip([30, 440])) {
            let shape = boxed(Vec2::from_ints(x, 150), Vec2::from_ints(8, 12))?;
            let body = SceneBody { mass: NonZeroU8::new(8), surface: wood, ..SceneBody::new(shape, key) };
            *place = Some(scene.insert(&body)?);
        }
        for k in 2..BODIES as i16 {
            let corner = Vec2::from_ints(28 + 20 * (k % 21), 20 + 12 * (k / 21));
            let body = if k % 2 == 0 {
                SceneBody { surface: wood, ..SceneBody::new(boxed(corner, Vec2::from_ints(8, 7))?, k as u32) }
            } else {
                let ball = Circle::new(corner + Vec2::from_ints(4, 4), fx!(3.5)).map_err(refused)?;
                SceneBody { surface: rubber, ..SceneBody::new(ball, k as u32) }
            };
            scene.insert(&body)?;
        }
        Ok(Self { scene, players })
    }

    /// Plays one frame.
    pub fn step(&mut self, arena: &Arena, keys: [Keys; 2]) -> Result<(), SceneError> {
        for (player, keys) in self.players.into_iter().flatten().zip(keys) {
            let old = self.scene.body(player)?.velocity;
            let run = Fx::from_num(i32::from(keys.holds(Keys::RIGHT)) - i32::from(keys.holds(Keys::LEFT))) * RUN;
            let jumps = keys.holds(Keys::JUMP) && self.scene.is_supported(player)?;
            let velocity = Vec2::new(run, if jumps { -JUMP } else { old.y });
            if velocity != old {
                self.scene.set_velocity(player, velocity)?;
            }
        }
        self.scene.step(arena, GRAVITY, |_| {})?;
        Ok(())
    }

    /// All of the state that changes.
    pub fn save(&self) -> Saved {
        self.scene.snapshot()
    }

    pub fn load(&mut self, saved: &Saved) {
        self.scene.restore(saved);
    }

    /// The number of awake bodies.
    pub fn awake(&self) -> usize {
        self.scene.awake().len()
    }
}

fn boxed(corner: Vec2, size: Vec2) -> Result<Aabb, SceneError> {
    Aabb::new(corner, corner + size).map_err(refused)
}

/// A shape that is not in a scene yet.
fn refused(error: RangeError) -> SceneError {
    SceneError { body: None, fault: error.into() }
}
