//! The level to play: tiles, and segments if there are any.

use tilesat::{Fx, SegmentMap};

use super::spawn::{self, Candidate, Spawn};
use crate::bake::Baked;
use crate::bake::level::Level;
use crate::bake::reopen::Reopened;
use crate::fail::{Fail, Result};
use tilesat::TileKind;

/// A level to play.
#[derive(Debug, Clone)]
pub struct Arena {
    /// The tiles. For a level without tiles, the empty cells around its segments.
    pub level: Level,
    /// The bytes of a segment map.
    pub segments: Option<Vec<u8>>,
    /// Where the player starts, if the level says so, and how many other objects say the same.
    pub spawn: Option<(Spawn, usize)>,
}

impl From<Level> for Arena {
    fn from(level: Level) -> Self {
        Self { level, segments: None, spawn: None }.at_origin()
    }
}

impl Arena {
    /// An arena of a baked level.
    ///
    /// # Errors
    ///
    /// If the level is empty, or the library refuses it.
    pub fn of(baked: &Baked) -> Result<Self> {
        let segments = baked.objects.as_ref().map(|(_, bytes, _)| bytes.clone());
        Self::new(baked.tiles.clone(), segments, baked.ground.left_out.iter().filter_map(Candidate::of))
    }

    /// An arena of a level in a file of the baker.
    ///
    /// # Errors
    ///
    /// As [`of`](Self::of).
    pub fn reopened(level: &Reopened) -> Result<Self> {
        let objects = level.objects.iter().map(|object| Candidate {
            title: format!("object {}", object.id),
            name: &object.name,
            class: &object.class,
            area: object.area,
        });
        Self::new(level.tiles.clone(), level.segments.clone(), objects)
    }

    fn new<'a>(
        tiles: Option<Level>,
        segments: Option<Vec<u8>>,
        objects: impl Iterator<Item = Candidate<'a>>,
    ) -> Result<Self> {
        let level = match (tiles, &segments) {
            (Some(level), _) => level,
            (None, Some(bytes)) => around(bytes)?,
            (None, None) => return Err(Fail::new("it is empty")),
        };
        let before = level.origin;
        let mut arena = Self { level, segments, spawn: None }.at_origin();
        let after = arena.level.origin;
        arena.spawn = spawn::find(objects, (after.0 - before.0, after.1 - before.1));
        Ok(arena)
    }

    /// The game counts from the first cell. The level's position matters only to segments and to
    /// the domain.
    fn at_origin(mut self) -> Self {
        let fits = |count: u16| u32::from(count) * u32::from(self.level.tile) < 8192;
        if self.segments.is_none() && fits(self.level.width) && fits(self.level.height) {
            self.level.origin = (0, 0);
        }
        self
    }
}

/// Empty tiles, slightly larger than the segment map: bodies have room around it.
fn around(bytes: &[u8]) -> Result<Level> {
    let map = SegmentMap::from_bytes(bytes).map_err(|e| Fail::new(format!("the segments: {e}")))?;
    let grid = map.grid();
    let whole = grid.cell().to_num::<u32>().clamp(1, 256);
    let tile = (whole + whole % 2).min(256) as u16;
    let side = Fx::from_num(tile).to_bits();
    let (from, to) = (grid.origin().raw(), grid.end().raw());
    let axis = |from: i32, to: i32| {
        let first = (from.div_euclid(side) - 4).max(-(1 << 29) / side + 1);
        let last = (to.div_euclid(side) + 5).min((1 << 29) / side - 1);
        (first * side, (last - first).clamp(1, 32767) as u16)
    };
    let ((x, width), (y, height)) = (axis(from.0, to.0), axis(from.1, to.1));
    let tiles = vec![0; usize::from(width) * usize::from(height)];
    Ok(Level {
        layer: "objects".to_owned(),
        width,
        height,
        tile,
        origin: (x, y),
        tiles,
        ids: vec![TileKind::EMPTY],
        flags: Vec::new(),
    })
}
