//! The baker: a Tiled map in, one byte a tile out.

use tilesat::{TileKind, TileKinds};

use super::fail::{Fail, Result};
use super::sim::Rules;
use super::tmx::{Tmx, TmxLayer};

/// What a tile blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Block {
    Nothing,
    All,
    FromAbove,
}

/// A level as the library takes it, together with the names the user gave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Level {
    /// The layer that is solid.
    pub layer: String,
    pub width: u16,
    pub height: u16,
    /// Side of a tile in pixels.
    pub tile: u16,
    /// One id a tile, row by row.
    pub tiles: Vec<u8>,
    /// What each id stands for; id 0 is nothing at all.
    pub ids: Vec<(Block, u8)>,
    /// The name of each flag bit, bit 0 first.
    pub flags: Vec<String>,
}

impl Level {
    pub fn bake(tmx: &Tmx, layer: Option<&str>) -> Result<Self> {
        let chosen = choose(tmx, layer)?;
        let same = |l: &&TmxLayer| l.width == chosen.width && l.height == chosen.height;
        let layers: Vec<&TmxLayer> = tmx.layers.iter().filter(same).collect();
        let mut level = Self {
            layer: chosen.name.clone(),
            width: chosen.width,
            height: chosen.height,
            tile: tmx.tile,
            tiles: Vec::with_capacity(chosen.cells.len()),
            ids: vec![(Block::Nothing, 0)],
            flags: Vec::new(),
        };
        let masks = level.name_flags(tmx, &layers)?;
        for (i, &cell) in chosen.cells.iter().enumerate() {
            let traits = tmx.traits(cell);
            let block = match (traits.solid, traits.one_way) {
                (true, _) => Block::All,
                (false, true) => Block::FromAbove,
                (false, false) => Block::Nothing,
            };
            let flags = layers.iter().fold(0, |all, l| all | masks[l.cells[i] as usize]);
            let id = level.id((block, flags))?;
            level.tiles.push(id);
        }
        Ok(level)
    }

    /// Gives each flag name a bit, in the order of first use, and each palette entry its mask.
    fn name_flags(&mut self, tmx: &Tmx, layers: &[&TmxLayer]) -> Result<Vec<u8>> {
        let mut masks: Vec<Option<u8>> = vec![None; tmx.palette.len()];
        for &cell in layers.iter().flat_map(|layer| &layer.cells) {
            let slot = &mut masks[cell as usize];
            if slot.is_none() {
                let mut mask = 0;
                for name in &tmx.traits(cell).flags {
                    mask |= self.bit(name)?;
                }
                *slot = Some(mask);
            }
        }
        Ok(masks.into_iter().map(Option::unwrap_or_default).collect())
    }

    fn bit(&mut self, name: &str) -> Result<u8> {
        let known = self.flags.iter().position(|f| f.eq_ignore_ascii_case(name));
        let index = known.unwrap_or(self.flags.len());
        if index == 8 {
            let list = self.flags.join(", ");
            return Err(Fail::new(format!("'{name}' would be the ninth flag, after {list}")));
        }
        if known.is_none() {
            self.flags.push(name.to_owned());
        }
        Ok(1 << index)
    }

    fn id(&mut self, kind: (Block, u8)) -> Result<u8> {
        let known = self.ids.iter().position(|&k| k == kind);
        let index = known.unwrap_or(self.ids.len());
        if known.is_none() {
            self.ids.push(kind);
        }
        let full = "more than 256 combinations of shape and flags";
        u8::try_from(index).map_err(|_| Fail::new(full))
    }

    /// The table that tells the library what each id is.
    pub fn kinds(&self) -> TileKinds {
        let mut kinds = TileKinds::EMPTY;
        for (id, &(block, flags)) in self.ids.iter().enumerate() {
            let kind = match block {
                Block::Nothing => TileKind::EMPTY,
                Block::All => TileKind::FULL,
                Block::FromAbove => TileKind::ONE_WAY_UP,
            };
            kinds = kinds.with(id as u8, kind.with_flags(flags));
        }
        kinds
    }

    /// Which flags the game knows.
    pub fn rules(&self) -> Rules {
        Rules { coin: self.mask("Coin"), kill: self.mask("Kill"), win: self.mask("Win"), ladder: self.mask("Ladder") }
    }

    fn mask(&self, name: &str) -> u8 {
        self.flags.iter().position(|f| f.eq_ignore_ascii_case(name)).map_or(0, |bit| 1 << bit)
    }

    /// The cells with coins, counted row by row.
    pub fn coins(&self) -> impl Iterator<Item = usize> {
        let coin = self.rules().coin;
        let has_coin = move |&(_, &id): &(usize, &u8)| self.ids[usize::from(id)].1 & coin != 0;
        self.tiles.iter().enumerate().filter(has_coin).map(|(cell, _)| cell)
    }

    pub fn block(&self, x: u16, y: u16) -> Block {
        self.kind(x, y).0
    }

    pub fn flags_at(&self, x: u16, y: u16) -> u8 {
        self.kind(x, y).1
    }

    fn kind(&self, x: u16, y: u16) -> (Block, u8) {
        let id = self.tiles[usize::from(y) * usize::from(self.width) + usize::from(x)];
        self.ids[usize::from(id)]
    }
}

fn choose<'a>(tmx: &'a Tmx, name: Option<&str>) -> Result<&'a TmxLayer> {
    let solid = |l: &TmxLayer| l.cells.iter().filter(|&&c| tmx.traits(c).solid).count();
    let names: Vec<&str> = tmx.layers.iter().map(|l| l.name.as_str()).collect();
    let chosen = match name {
        Some(name) => tmx
            .layers
            .iter()
            .find(|l| l.name == name)
            .ok_or_else(|| Fail::new(format!("no tile layer '{name}'; there are: {}", names.join(", "))))?,
        // `max_by_key` keeps the last of equals, so the search runs from the top layer down.
        None => {
            tmx.layers.iter().rev().max_by_key(|l| solid(l)).ok_or_else(|| Fail::new("the map has no tile layer"))?
        }
    };
    if solid(chosen) == 0 {
        return Err(Fail::new(format!("layer '{}' has no solid tile", chosen.name)));
    }
    Ok(chosen)
}
