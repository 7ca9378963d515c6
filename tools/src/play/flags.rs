//! The flags of a level that the game knows.

use tilesat_games::platformer::sim::Rules;

use crate::bake::level::Level;

/// The bits of the game's own flags. 0 if no tile has one.
pub fn rules(level: &Level) -> Rules {
    let bit = |name| level.mask(name);
    Rules { coin: bit("Coin"), kill: bit("Kill"), win: bit("Win"), ladder: bit("Ladder") }
}

/// The cells with coins, counted row by row.
pub fn coins(level: &Level) -> impl Iterator<Item = usize> {
    let coin = rules(level).coin;
    let has_coin = move |&(_, &id): &(usize, &u8)| level.ids[usize::from(id)].flag(coin);
    level.tiles.iter().enumerate().filter(has_coin).map(|(cell, _)| cell)
}
