//! The platformer's level, its baker, and the check that watches the library.

use tilesat::{Fx, Grid, Outside, TileMap, TileShape, Vec2};
use tilesat_games::platformer::{meadow, sim};
use tilesat_tools::bake::level::Level;
use tilesat_tools::play::check::{Checker, Fault};
use tilesat_tools::play::{self, Figure, constants};
use tilesat_tools::read::drawing::{TileLayer, TileLayers};
use tilesat_tools::read::tmx;
use tilesat_tools::rules::traits::Traits;

fn own() -> Level {
    Level::bake(&tmx::load(&crate::support::own("platformer/levels/meadow.tmx")).unwrap(), None).unwrap()
}

const HINT: &str = "bake it: cargo run --example platformer -- --bake examples/games/src/platformer/meadow";

#[test]
fn baked_bytes_equal_the_map() {
    let level = own();
    assert!(level.tiles == meadow::TILES, "{HINT}");
    let source = include_str!("../../../examples/games/src/platformer/meadow.rs");
    assert!(constants::constants(&level, "meadow.bin") == source, "{HINT}");
    assert_eq!(level.kinds(), meadow::KINDS);
}

/// What the firmware does, and what the desktop does with the map, are the same run.
#[test]
fn firmware_and_desktop_agree() {
    let grid = Grid::new(meadow::WIDTH, meadow::HEIGHT, Fx::from_num(meadow::TILE), Vec2::ZERO).unwrap();
    let map = TileMap::on_grid(meadow::TILES, grid, &meadow::KINDS).unwrap().with_outside(Outside::Solid);
    let rules = sim::Rules { coin: meadow::COIN, kill: meadow::KILL, win: meadow::WIN, ladder: meadow::LADDER };
    let mut state = sim::Sim::new(&map, rules, sim::SEED).unwrap();
    for _ in 0..sim::FIRMWARE_FRAMES {
        assert_eq!(state.step(&map).refused, 0);
    }
    let run = play::play(&own(), sim::FIRMWARE_FRAMES, sim::SEED, &mut std::io::sink()).unwrap();
    assert_eq!((run.overlaps, run.escaped, run.refused), (0, 0, 0));
    assert_eq!(run.hash, state.hash());
    println!("{} of {} bytes", run.line(), size_of::<sim::Sim>());
    assert!(size_of::<sim::Sim>() <= 4096);
}

/// The level shows every trick within the default run.
#[test]
fn the_player_plays() {
    let run = play::play(&own(), 3600, sim::SEED, &mut std::io::sink()).unwrap();
    let s = run.score;
    assert!(s.coins > 0 && s.deaths > 0 && s.wins > 0 && s.bumps > 0 && s.landings > 0, "{s:?}");
}

#[test]
fn many_seeds() {
    let level = own();
    for seed in 100..120 {
        let run = play::play(&level, 1200, seed, &mut std::io::sink()).unwrap();
        assert_eq!((run.overlaps, run.escaped, run.refused), (0, 0, 0), "seed {seed}");
    }
}

fn layer(name: &str, cells: &[u32]) -> TileLayer {
    TileLayer { name: name.into(), width: cells.len() as u16, height: 1, cells: cells.to_vec() }
}

fn tiles_of(palette: &[&[&str]], layers: Vec<TileLayer>) -> TileLayers {
    let named = palette.iter().map(|names| Traits::from_names(names));
    TileLayers { tile: 16, layers, palette: [Traits::default()].into_iter().chain(named).collect() }
}

#[test]
fn names_of_tiles() {
    for name in ["Collision", "Solid", "COLLISION", "solid"] {
        assert_eq!(Traits::from_names(&["", name]), Traits { shape: TileShape::Full, ..Traits::default() });
    }
    assert_eq!(Traits::from_names(&["OneWay"]).shape, TileShape::OneWayUp);
    assert_eq!(Traits::from_names(&["OneWay", "Solid", "oneway"]).shape, TileShape::Full);
    assert_eq!(Traits::from_names(&["Kill", "kill", "Ice"]).flags, ["Kill", "Ice"]);
}

#[test]
fn default_layer_has_most_solid_tiles() {
    let palette: &[&[&str]] = &[&["Solid"]];
    let chosen = |layers| Level::bake(&tiles_of(palette, layers), None).unwrap().layer;
    assert_eq!(chosen(vec![layer("a", &[1, 0, 0]), layer("b", &[1, 1, 0])]), "b");
    assert_eq!(chosen(vec![layer("a", &[0, 1, 1]), layer("b", &[1, 1, 0])]), "a", "the lower one on a tie");
    let named = Level::bake(&tiles_of(palette, vec![layer("a", &[1, 0, 0]), layer("b", &[1, 1, 0])]), Some("a"));
    assert_eq!(named.unwrap().tiles, [1, 0, 0]);
}

#[test]
fn flags_come_from_all_layers_and_solids_from_one() {
    let palette: &[&[&str]] = &[&["Solid"], &["Kill"], &["OneWay", "Ice"], &["Solid", "Kill"]];
    let other = vec![layer("high", &[2, 4, 3, 0]), layer("world", &[1, 0, 3, 1]), layer("short", &[2])];
    let level = Level::bake(&tiles_of(palette, other), None).unwrap();
    assert_eq!(level.flags, ["Kill", "Ice"]);
    let cells: Vec<(TileShape, u8)> = (0..4).map(|x| (level.kind(x, 0).shape, level.kind(x, 0).flags)).collect();
    assert_eq!(cells, [(TileShape::Full, 1), (TileShape::Empty, 1), (TileShape::OneWayUp, 2), (TileShape::Full, 0)]);
    assert_eq!(play::rules(&level), sim::Rules { coin: 0, kill: 1, win: 0, ladder: 0 });
}

#[test]
fn eight_flags_and_no_more() {
    let names: Vec<String> = (0..9).map(|i| format!("f{i}")).collect();
    let tiles: Vec<Vec<&str>> = names.iter().map(|name| vec![name.as_str()]).collect();
    let palette: Vec<&[&str]> = [&["Solid"][..]].into_iter().chain(tiles.iter().map(Vec::as_slice)).collect();
    let eight = Level::bake(&tiles_of(&palette, vec![layer("a", &[1, 2, 3, 4, 5, 6, 7, 8, 9])]), None).unwrap();
    assert_eq!(eight.flags.len(), 8);
    let nine = Level::bake(&tiles_of(&palette, vec![layer("a", &[1, 2, 3, 4, 5, 6, 7, 8, 9, 10])]), None);
    assert!(nine.unwrap_err().to_string().contains("'f8' would be the ninth"));
}

/// 4 x 3 cells of 16: a wall in column 2 with no way round it.
fn walled() -> Checker {
    let solid: &[&[&str]] = &[&["Solid"]];
    let mut drawn = tiles_of(solid, vec![layer("a", &[0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0])]);
    drawn.layers[0].width = 4;
    drawn.layers[0].height = 3;
    Checker::new(&Level::bake(&drawn, None).unwrap())
}

const PX: i64 = 1 << 16;

fn square(x: i64, y: i64) -> Figure {
    Figure::Box { min: (x, y), max: (x + 8 * PX, y + 8 * PX) }
}

fn ball(x: i64, y: i64) -> Figure {
    Figure::Disc { centre: (x, y), radius: 5 * PX }
}

#[test]
fn the_check_is_strict_and_exact() {
    let check = walled();
    for (figure, overlaps) in [
        (square(24 * PX, 0), false),
        (square(24 * PX + 1, 0), true),
        (square(48 * PX, 40 * PX), false),
        (square(48 * PX - 1, 40 * PX), true),
        (ball(27 * PX, 20 * PX), false),
        (ball(27 * PX + 1, 20 * PX), true),
    ] {
        assert_eq!(check.overlaps(&figure), overlaps, "{figure:?}");
    }
    // A 3-4-5 corner: the disc touches it exactly.
    let solid: &[&[&str]] = &[&["Solid"]];
    let corner = Checker::new(&Level::bake(&tiles_of(solid, vec![layer("a", &[1, 0])]), None).unwrap());
    assert!(!corner.overlaps(&ball(19 * PX, 20 * PX)));
    assert!(corner.overlaps(&ball(19 * PX - 1, 20 * PX)));
    assert!(corner.overlaps(&ball(19 * PX, 20 * PX - 1)));
}

#[test]
fn the_check_sees_escapes() {
    let check = walled();
    let moved = |from, to, by| check.check(&from, &to, by);
    let fine = Fault { overlap: false, escape: false };
    let escape = Fault { overlap: false, escape: true };
    assert_eq!(moved(square(0, 0), square(3 * PX, 4 * PX), (3 * PX, 4 * PX)), fine);
    assert_eq!(moved(square(0, 0), square(3 * PX, 4 * PX), (0, 5 * PX)), fine, "sliding turns a motion");
    assert_eq!(moved(square(0, 0), square(3 * PX, 4 * PX), (0, 4 * PX)), escape, "further than its velocity");
    assert_eq!(moved(square(0, 0), square(-1, 0), (PX, 0)), escape, "out of the map");
    assert_eq!(moved(ball(20 * PX, 42 * PX), ball(20 * PX, 43 * PX + 1), (2 * PX, 0)), escape, "out of the map");
    assert_eq!(moved(square(0, 0), square(50 * PX, 0), (60 * PX, 0)), escape, "through the wall");
}
