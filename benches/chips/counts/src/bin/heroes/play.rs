//! A play of some thousand frames: the hero runs, jumps, drops, rides, and falls out of the level.

use core::mem::MaybeUninit;
use tilesat::motion::{Outcome, Step};
use tilesat::world::ShapeSet;
use tilesat::{
    Aabb, Character, Feel, Grid, Input, RangeError, Solid, TileKind, TileKinds, TileMap, TileShape, Vec2, fx,
};
use tilesat_chip::eprintln;
use tilesat_counts::clock::Short;
use tilesat_counts::counter::Counter;
use tilesat_counts::inputs::Random;
use tilesat_counts::measure::{Query, nothing, sample, tell};
use tilesat_counts::stack::depth;

const FRAMES: u32 = 4000;

static BLOCKS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'=', TileKind::ONE_WAY_UP);
static SLOPES: TileKinds =
    BLOCKS.with(b'/', TileKind::of(TileShape::SlopeBottomRight)).with(b'\\', TileKind::of(TileShape::SlopeBottomLeft));
/// Among blocks its slopes are empty. The lift goes up and down in the pit.
static TILES: [[u8; 24]; 10] = [
    *b"#......................#",
    *b"#......................#",
    *b"#.......==.......##....#",
    *b"#......................#",
    *b"#..====......=====..####",
    *b"#......................#",
    *b"#.../\\...==...../##\\...#",
    *b"#../##\\......../####\\..#",
    *b"########....############",
    *b"########....############",
];

fn level<S: ShapeSet>() -> Option<TileMap<'static, S>> {
    let slopes = S::SHAPES >> TileShape::SlopeBottomRight as u64 & 1 != 0;
    let grid = Grid::new(24, 10, fx!(16), Vec2::ZERO).ok()?;
    TileMap::of(TILES.as_flattened(), grid, if slopes { &SLOPES } else { &BLOCKS }).ok()
}

/// Where a hero without a lift begins.
const FLOOR: Aabb = match Aabb::new(Vec2::from_ints(16, 128), Vec2::from_ints(128, 160)) {
    Ok(floor) => floor,
    Err(_) => panic!("the floor"),
};

struct Play {
    hero: Character,
    lift: [Solid; 1],
    input: Input,
    answer: Result<Step, RangeError>,
    random: Random,
    /// Landings, and frames on the lift: a play has both.
    landed: u32,
    rode: u32,
}

impl Play {
    fn begin(limits: Aabb) -> Option<Self> {
        let lift = Aabb::new(Vec2::from_ints(130, 96), Vec2::from_ints(190, 102)).ok()?;
        let mut hero = Character::new(spawn(&FLOOR)?, limits, Feel::DEFAULT);
        Some(Self {
            answer: hero.step(&level::<tilesat::Blocks>()?, Input::default()),
            hero,
            lift: [Solid::new(lift, 1).ok()?],
            input: Input::default(),
            random: Random::new(3),
            landed: 0,
            rode: 0,
        })
    }

    /// Keys are held for some frames, the direction for longer than the others.
    fn press(&mut self, frame: u32) -> Option<()> {
        if frame.is_multiple_of(24) {
            let run = [fx!(-1.5), fx!(1.5), fx!(0), fx!(0)];
            self.input.run = run[self.random.word() as usize >> 4 & 3];
        }
        if frame.is_multiple_of(8) {
            let keys = self.random.word() >> 4;
            (self.input.jump, self.input.drop) = (keys & 3 == 0, keys & 28 == 0);
        }
        let up = if (frame / 56).is_multiple_of(2) { -1 } else { 1 };
        self.lift[0] = self.lift[0].with_motion(Vec2::from((0, up))).ok()?;
        Some(())
    }

    fn look(&mut self, lift: bool) -> Option<()> {
        let step = self.answer.ok()?;
        self.landed += u32::from(step.landed);
        self.rode += u32::from(self.hero.ridden().is_some());
        if step.outcome != Outcome::Moved {
            self.hero.place(spawn(&if lift { self.lift[0].shape() } else { FLOOR })?);
        }
        Some(())
    }
}

/// Ten by fourteen units, on this box.
fn spawn(on: &Aabb) -> Option<Aabb> {
    let feet = on.min() + Vec2::from_ints(24, 0);
    Aabb::new(feet - Vec2::from_ints(5, 14), feet + Vec2::from_ints(5, 0)).ok()
}

/// The mean and the most of the frames, and the most of their stack. The play is played twice.
#[inline(never)]
pub fn row<S: ShapeSet, const LIFT: bool>(counter: &Counter<Short>, name: &str) -> Option<()> {
    let map = level::<S>()?;
    // SAFETY: the only reference to the play while this runs.
    let frame: Query<*mut Play, TileMap<'static, S>, ()> = |play, map| unsafe {
        let play = &mut **play;
        play.answer =
            if LIFT { play.hero.step_on(map, &mut play.lift, play.input) } else { play.hero.step(map, play.input) };
        MaybeUninit::new(())
    };
    let (mut sum, mut most, mut bytes) = (0, 0, 0);
    for counts in [true, false] {
        let mut play = Play::begin(map.bounds())?;
        for number in 0..FRAMES {
            play.press(number)?;
            let this = &raw mut play;
            if counts {
                let count = sample(counter, frame, nothing, &this, &map).1;
                (sum, most) = (sum + count, most.max(count));
            } else {
                bytes = bytes.max(depth(frame, &this, &map));
            }
            play.look(LIFT)?;
        }
        if play.landed < 50 || LIFT != (play.rode > 40) {
            eprintln!("{name}: not of this class: {} landed, {} rode", play.landed, play.rode);
            return None;
        }
    }
    tell("frames", format_args!("{name}, mean of {FRAMES}"), sum / FRAMES, None);
    tell("frames", format_args!("{name}, most of {FRAMES}"), most, None);
    tell("stack", name, bytes, None);
    Some(())
}
