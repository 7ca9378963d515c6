//! Tile layers in, one byte a tile out.

use tilesat::world::Set;
use tilesat::{Aabb, AllShapes, Blocks, Feature, Fx, Grid, Outside, TileKind, TileKinds, TileMap, TileShape, Vec2};

use crate::fail::{Fail, Result};
use crate::read::drawing::{Drawing, TileLayer, TileLayers};

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
    pub ids: Vec<TileKind>,
    /// The name of each flag bit, bit 0 first.
    pub flags: Vec<String>,
}

impl Level {
    /// Of the named layer, or that with most solid tiles.
    ///
    /// # Errors
    ///
    /// No such layer, none with a solid tile, more than eight flags, or more than 256 combinations of shape and flags.
    pub fn bake(drawn: &TileLayers, layer: Option<&str>) -> Result<Self> {
        let chosen = choose(drawn, layer)?;
        if !chosen.cells.iter().any(|&cell| is_solid(drawn.traits(cell).shape)) {
            return Err(Fail::new(format!("layer '{}' has no solid tile", chosen.name)));
        }
        Self::of(drawn, chosen)
    }

    /// Of the layer that [`bake`](Self::bake) takes; `None` where no tile of it means anything: solids may be objects.
    ///
    /// # Errors
    ///
    /// As [`bake`](Self::bake), but for a layer without a solid tile.
    pub fn of_drawing(drawing: &Drawing, layer: Option<&str>) -> Result<Option<Self>> {
        if drawing.tiles.layers.is_empty() && layer.is_none() {
            return Ok(None);
        }
        let level = Self::of(&drawing.tiles, choose(&drawing.tiles, layer)?)?;
        Ok(Some(level).filter(|level| level.ids.len() > 1))
    }

    /// Of one layer, with the flags of all.
    fn of(drawn: &TileLayers, chosen: &TileLayer) -> Result<Self> {
        let same = |l: &&TileLayer| l.width == chosen.width && l.height == chosen.height;
        let layers: Vec<&TileLayer> = drawn.layers.iter().filter(same).collect();
        let mut level = Self {
            layer: chosen.name.clone(),
            width: chosen.width,
            height: chosen.height,
            tile: drawn.tile,
            tiles: Vec::with_capacity(chosen.cells.len()),
            ids: vec![TileKind::EMPTY],
            flags: Vec::new(),
        };
        let masks = level.name_flags(drawn, &layers)?;
        for (i, &cell) in chosen.cells.iter().enumerate() {
            let flags = layers.iter().fold(0, |all, l| all | masks[l.cells[i] as usize]);
            let id = level.id(TileKind::of(drawn.traits(cell).shape).with_flags(flags))?;
            level.tiles.push(id);
        }
        Ok(level)
    }

    /// Gives each flag name a bit, in the order of first use, and each palette entry its mask.
    fn name_flags(&mut self, drawn: &TileLayers, layers: &[&TileLayer]) -> Result<Vec<u8>> {
        let mut masks: Vec<Option<u8>> = vec![None; drawn.palette.len()];
        for &cell in layers.iter().flat_map(|layer| &layer.cells) {
            let slot = &mut masks[cell as usize];
            if slot.is_none() {
                let mut mask = 0;
                for name in &drawn.traits(cell).flags {
                    mask |= bit(&mut self.flags, name)?;
                }
                *slot = Some(mask);
            }
        }
        Ok(masks.into_iter().map(Option::unwrap_or_default).collect())
    }

    fn id(&mut self, kind: TileKind) -> Result<u8> {
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
        for (id, &kind) in self.ids.iter().enumerate() {
            kinds = kinds.with(id as u8, kind);
        }
        kinds
    }

    /// Whether the library needs nothing but blocks for it: such a level plays with less code.
    pub fn is_blocks(&self) -> bool {
        self.ids.iter().all(|kind| Blocks::SHAPES >> kind.shape as u8 & 1 != 0)
    }

    /// The surface as the library derives it: the pieces of the level's own cells, in a closed room.
    pub fn features(&self) -> Vec<Feature> {
        let kinds = self.kinds();
        let grid = Grid::new(self.width, self.height, Fx::from_num(self.tile), Vec2::ZERO);
        let map = grid.and_then(|grid| TileMap::<AllShapes>::of(&self.tiles, grid, &kinds));
        let region = grid.ok().and_then(|grid| Aabb::new(grid.origin(), grid.end()).ok());
        let (Ok(map), Some(region)) = (map, region) else { return Vec::new() };
        let map = map.with_outside(Outside::Solid);
        map.features(&region).filter(|feature| map.tile(feature.cell).is_some()).collect()
    }

    /// The bit of a flag; 0 where no tile has it.
    pub fn mask(&self, name: &str) -> u8 {
        self.flags.iter().position(|f| f.eq_ignore_ascii_case(name)).map_or(0, |bit| 1 << bit)
    }

    /// What a cell is.
    pub fn kind(&self, x: u16, y: u16) -> TileKind {
        let id = self.tiles[usize::from(y) * usize::from(self.width) + usize::from(x)];
        self.ids[usize::from(id)]
    }
}

/// The bit of a flag, which is named if it is new.
pub(crate) fn bit(flags: &mut Vec<String>, name: &str) -> Result<u8> {
    let known = flags.iter().position(|f| f.eq_ignore_ascii_case(name));
    let index = known.unwrap_or(flags.len());
    if index == 8 {
        let list = flags.join(", ");
        return Err(Fail::new(format!("'{name}' would be the ninth flag, after {list}")));
    }
    if known.is_none() {
        flags.push(name.to_owned());
    }
    Ok(1 << index)
}

/// Whether it has an inside; one-way edges have none.
pub(crate) fn is_solid(shape: TileShape) -> bool {
    (1..TileShape::OneWayUp as u8).contains(&(shape as u8))
}

/// The named layer, or that with most solid tiles.
fn choose<'a>(drawn: &'a TileLayers, name: Option<&str>) -> Result<&'a TileLayer> {
    let count = |l: &TileLayer, what: fn(TileShape) -> bool| {
        l.cells.iter().filter(|&&cell| what(drawn.traits(cell).shape)).count()
    };
    let Some(name) = name else {
        // `max_by_key` keeps the last of equals, so the search runs from the top layer down.
        let most = |l: &&TileLayer| (count(l, is_solid), count(l, |shape| shape != TileShape::Empty));
        return drawn.layers.iter().rev().max_by_key(most).ok_or_else(|| Fail::new("the map has no tile layer"));
    };
    let names: Vec<&str> = drawn.layers.iter().map(|l| l.name.as_str()).collect();
    let unknown = || Fail::new(format!("no tile layer '{name}'; there are: {}", names.join(", ")));
    drawn.layers.iter().find(|l| l.name == name).ok_or_else(unknown)
}
