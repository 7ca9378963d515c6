//! The first game, played by its scripted player.

use std::error::Error;

use tilesat::Vec2;
use tilesat_tools::picture::ink::{COIN, PLANK, PLAYER, TEXT};
use tilesat_tools::picture::marks::Scene;

use super::draw::{View, page};

/// The chapter's program, which the build script takes out of the page.
#[allow(dead_code, clippy::all, clippy::pedantic, reason = "a program of the guide")]
mod program {
    include!(concat!(env!("OUT_DIR"), "/first_platformer.rs"));

    /// A game in each of its frames.
    pub(super) fn frames() -> Result<Vec<(tilesat::Aabb, tilesat::Aabb)>, Box<dyn std::error::Error>> {
        let mut game = Game::new()?;
        let mut frames = Vec::new();
        while game.deaths == 0 {
            frames.push((*game.hero.body(), game.lift[0].shape()));
            game.step(player(&game))?;
        }
        Ok(frames)
    }

    pub(super) fn level() -> Result<TileMap<'static>, TileMapError> {
        level_of(&START)
    }

    pub(super) const FLAG: u8 = COIN;
}

pub(crate) fn picture() -> Result<Scene, Box<dyn Error>> {
    let (level, frames) = (program::level()?, program::frames()?);
    let mut scene = page(760.0, 292.0);
    let view = View { at: (12.0, 22.0), scale: 2.3 };
    view.level(&mut scene, &level, &level.bounds());
    for coin in level.tiles_in(&level.bounds()).filter(|tile| tile.kind.flag(program::FLAG)) {
        let cell = level.grid().bounds_of(coin.cell).ok_or("beyond the map")?;
        scene.disc(view.spot(cell.centre()), 9.0, COIN);
    }
    // The lift at its lowest and at its highest position.
    let lifts = || frames.iter().map(|frame| frame.1);
    let (low, high) = (lifts().max_by_key(|it| it.max().y), lifts().min_by_key(|it| it.max().y));
    view.body(&mut scene, &low.ok_or("no frame")?, PLANK.alpha(0.5), true);
    view.body(&mut scene, &high.ok_or("no frame")?, PLANK, true);

    let feet: Vec<Vec2> = frames.iter().map(|(hero, _)| hero.centre()).collect();
    view.path(&mut scene, &feet, PLAYER);
    for (hero, _) in frames.iter().step_by(20) {
        view.body(&mut scene, hero, PLAYER.alpha(0.7), false);
    }
    let (hero, _) = frames.first().ok_or("no frame")?;
    view.body(&mut scene, hero, PLAYER, true);
    scene.text((12.0, 282.0), "The hero every 20 frames, and the lift at both ends of its path.", TEXT);
    Ok(scene)
}
