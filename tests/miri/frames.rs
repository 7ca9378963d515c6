//! Some frames of the platformer's 33 bodies and the hash of their positions: `.ci/miri` compares the line that this prints between this
//! computer and the machines that Miri plays.

#[allow(unused_imports, reason = "pictures and reports of the desktop example have no place here")]
#[path = "../../examples/platformer/sim/mod.rs"]
mod sim;

#[path = "../../examples/platformer/levels/meadow.rs"]
mod meadow;

use std::error::Error;
use tilesat::{Fx, Grid, Outside, TileMap, Vec2};

const FRAMES: u32 = 12;

const RULES: sim::Rules =
    sim::Rules { coin: meadow::COIN, kill: meadow::KILL, win: meadow::WIN, ladder: meadow::LADDER };

fn main() -> Result<(), Box<dyn Error>> {
    let grid = Grid::new(meadow::WIDTH, meadow::HEIGHT, Fx::from_num(meadow::TILE), Vec2::ZERO)?;
    let map = TileMap::on_grid(meadow::TILES, grid, &meadow::KINDS)?.with_outside(Outside::Solid);
    let mut sim = sim::Sim::new(&map, RULES, sim::SEED).map_err(|sim::NoRoom| "no room for the bodies")?;
    let contacts: u32 = (0..FRAMES).map(|_| sim.step(&map).contacts).sum();
    println!("frames={FRAMES} bodies={} contacts={contacts} hash={:08x}", sim::BODIES, sim.hash());
    Ok(())
}
