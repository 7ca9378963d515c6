//! The platformer's level, its baker, and the check that watches the library.

use tilesat::{Fx, Grid, Outside, TileMap, TileShape, Vec2};
use tilesat_games::platformer::{meadow, sim};
use tilesat_tools::bake::level::Level;
use tilesat_tools::play::check::{Checker, Fault};
use tilesat_tools::play::{self, Figure, constants};

use crate::support::{self, scratch};

fn own() -> Level {
    support::level(&support::own("platformer/levels/meadow.tmx")).unwrap()
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

/// The firmware and the desktop play the same run.
#[test]
fn firmware_and_desktop_agree() {
    let grid = Grid::new(meadow::WIDTH, meadow::HEIGHT, Fx::from_num(meadow::TILE), Vec2::ZERO).unwrap();
    let map = TileMap::on_grid(meadow::TILES, grid, &meadow::KINDS).unwrap().with_outside(Outside::Solid);
    let rules = sim::Rules { coin: meadow::COIN, kill: meadow::KILL, win: meadow::WIN, ladder: meadow::LADDER };
    let mut state = sim::Sim::new(&map, rules, sim::SEED).unwrap();
    for _ in 0..sim::FIRMWARE_FRAMES {
        assert_eq!(state.step(&map).refused, 0);
    }
    let run = play::play(&own().into(), sim::FIRMWARE_FRAMES, sim::SEED, &mut std::io::sink()).unwrap();
    assert_eq!((run.overlaps, run.escaped, run.refused), (0, 0, 0));
    assert_eq!(run.hash, state.hash());
    println!("{} of {} bytes", run.line(), size_of::<sim::Sim>());
    assert!(size_of::<sim::Sim>() <= 4096);
}

/// The level shows every trick within the default run.
#[test]
fn the_player_plays() {
    let run = play::play(&own().into(), 3600, sim::SEED, &mut std::io::sink()).unwrap();
    let s = run.score;
    assert!(s.coins > 0 && s.deaths > 0 && s.wins > 0 && s.bumps > 0 && s.landings > 0, "{s:?}");
}

#[test]
fn many_seeds() {
    let level = own();
    for seed in 100..120 {
        let run = play::play(&level.clone().into(), 1200, seed, &mut std::io::sink()).unwrap();
        assert_eq!((run.overlaps, run.escaped, run.refused), (0, 0, 0), "seed {seed}");
    }
}

/// A level of these layers, by rows of this many columns. Tile `n` has the class and the true
/// properties at `n - 1`.
fn drawn(
    name: &str,
    tiles: &[&[&str]],
    columns: usize,
    layers: &[(&str, &[u32])],
) -> tilesat_tools::fail::Result<Level> {
    let property = |name: &&str| format!(r#"<property name="{name}" type="bool" value="true"/>"#);
    let tile = |(id, names): (usize, &&[&str])| {
        let (class, rest) = names.split_first().unwrap();
        let properties = rest.iter().map(property).collect::<String>();
        format!(r#"<tile id="{id}" type="{class}"><properties>{properties}</properties></tile>"#)
    };
    let tiles: String = tiles.iter().enumerate().map(tile).collect();
    let layer = |(name, cells): &(&str, &[u32])| {
        let csv = cells.iter().map(u32::to_string).collect::<Vec<_>>().join(",");
        let rows = cells.len() / columns;
        format!(r#"<layer name="{name}" width="{columns}" height="{rows}"><data encoding="csv">{csv}</data></layer>"#)
    };
    let layers: String = layers.iter().map(layer).collect();
    let text = format!(
        r#"<map orientation="orthogonal" width="{columns}" height="1" tilewidth="16" tileheight="16">
        <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="99">{tiles}</tileset>{layers}</map>"#
    );
    support::level(&scratch("level", &format!("{name}.tmx"), text))
}

fn shapes(level: &Level) -> Vec<TileShape> {
    level.tiles.iter().map(|&id| level.ids[usize::from(id)].shape).collect()
}

const FULL: TileShape = TileShape::Full;
const NONE: TileShape = TileShape::Empty;
const ONE_WAY: TileShape = TileShape::OneWayUp;

#[test]
fn names_of_tiles() {
    for name in ["Collision", "Solid", "COLLISIONS", "solid", "Collides", "collidable", "Walls", "Blocked"] {
        for tiles in [&[name][..], &["", name]] {
            assert_eq!(shapes(&drawn("names", &[tiles], 2, &[("a", &[1, 0])]).unwrap()), [FULL, NONE], "{name}");
        }
    }
    for name in ["OneWay", "one-way", "One_Ways"] {
        assert_eq!(shapes(&drawn("names", &[&[name]], 1, &[("a", &[1])]).unwrap()), [ONE_WAY], "{name}");
    }
    assert_eq!(shapes(&drawn("names", &[&["OneWay", "Solid", "oneway"]], 1, &[("a", &[1])]).unwrap()), [ONE_WAY]);
    let flags = drawn("names", &[&["Kill", "kill", "Ice", "Solid"]], 1, &[("a", &[1])]).unwrap().flags;
    assert_eq!(flags, ["Kill", "Ice"]);
}

#[test]
fn solids_come_from_all_layers() {
    let tiles: &[&[&str]] = &[&["Solid"], &["OneWay"]];
    let level = drawn("both", tiles, 3, &[("a", &[1, 0, 2]), ("b", &[2, 1, 0])]).unwrap();
    assert_eq!((shapes(&level), level.layer.as_str()), (vec![FULL, FULL, ONE_WAY], "a + b"));
}

#[test]
fn flags_come_from_all_layers() {
    let tiles: &[&[&str]] = &[&["Solid"], &["Kill"], &["OneWay", "Ice"], &["Solid", "Kill"]];
    let level = drawn("flags", tiles, 4, &[("high", &[2, 4, 3, 0]), ("world", &[1, 0, 3, 1])]).unwrap();
    assert_eq!(level.flags, ["Kill", "Ice"]);
    let cells: Vec<(TileShape, u8)> = (0..4).map(|x| (level.kind(x, 0).shape, level.kind(x, 0).flags)).collect();
    assert_eq!(cells, [(FULL, 1), (FULL, 1), (ONE_WAY, 2), (FULL, 0)]);
    assert_eq!(play::rules(&level), sim::Rules { coin: 0, kill: 1, win: 0, ladder: 0 });
}

#[test]
fn eight_flags_and_no_more() {
    let names: Vec<String> = (0..9).map(|i| format!("f{i}")).collect();
    let tiles: Vec<Vec<&str>> = names.iter().map(|name| vec![name.as_str()]).collect();
    let tiles: Vec<&[&str]> = [&["Solid"][..]].into_iter().chain(tiles.iter().map(Vec::as_slice)).collect();
    let all: Vec<u32> = (1..=10).collect();
    assert_eq!(drawn("eight", &tiles, 9, &[("a", &all[..9])]).unwrap().flags.len(), 8);
    let nine = drawn("nine", &tiles, 10, &[("a", &all)]).unwrap();
    assert_eq!(nine.flags, names[..8]);
    assert_eq!((nine.kind(0, 0).shape, nine.kind(8, 0).flags, nine.kind(9, 0).flags), (FULL, 1 << 7, 0));
}

/// 4 x 3 cells of 16: a wall in column 2 with no way round it.
fn walled() -> Checker {
    let wall = [0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0];
    Checker::new(&drawn("walled", &[&["Solid"]], 4, &[("a", &wall)]).unwrap())
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
    let corner = Checker::new(&drawn("corner", &[&["Solid"]], 2, &[("a", &[1, 0])]).unwrap());
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

/// For the check, polygons are solid up to their borders and holes are not. A body within a polygon
/// overlaps it too.
#[test]
fn the_check_sees_polygons() {
    let list = r#"<object id="1" x="32" y="32" width="64" height="64"/><object id="2" type="Hole" x="48" y="48" width="32" height="32"/>"#;
    let file = scratch("level", "polygons.tmx", support::objects(list));
    let levels = tilesat_tools::read::load(&file, None).unwrap();
    let bundle = tilesat_tools::bake::bake(&levels.maps, &tilesat_tools::bake::Settings::default()).unwrap();
    let arena = play::Arena::of(&bundle.levels[0]).unwrap();
    let check = Checker::new(&arena.level).with_segments(arena.segments.as_deref().unwrap());
    for (figure, overlaps) in [
        (square(24 * PX, 40 * PX), false),
        (square(24 * PX + 1, 40 * PX), true),
        (square(36 * PX, 36 * PX), true),
        (square(60 * PX, 60 * PX), false),
        (square(48 * PX, 48 * PX), false),
        (square(48 * PX - 1, 60 * PX), true),
        (ball(27 * PX, 64 * PX), false),
        (ball(27 * PX + 1, 64 * PX), true),
        (ball(64 * PX, 64 * PX), false),
        (ball(29 * PX, 28 * PX), false),
        (ball(29 * PX, 28 * PX + 1), true),
    ] {
        assert_eq!(check.overlaps(&figure), overlaps, "{figure:?}");
    }
}

/// The tops of walls are often drawn on a layer of their own, moved up by a cell.
#[test]
fn scenery_that_is_moved_adds_no_rows() {
    let text = |offset: &str, tops: u32| {
        format!(
            r#"<map orientation="orthogonal" width="2" height="2" tilewidth="16" tileheight="16">
            <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="2" columns="2"><image source="t.png" width="32" height="16"/>
            <tile id="0" type="Solid"/></tileset>
            <layer name="L" width="2" height="2"><data encoding="csv">1,1,1,1</data></layer>
            <layer name="tops" width="2" height="2" {offset}><data encoding="csv">{tops},0,0,0</data></layer></map>"#
        )
    };
    let baked = |name, text| support::level(&scratch("level", name, text)).unwrap();
    // Tile 2 is a picture, tile 1 is solid.
    for (name, offset, tops, size) in [
        ("tops.tmx", r#"offsety="-16""#, 2, (2, 2, 0)),
        ("side.tmx", r#"offsetx="32" offsety="16""#, 2, (2, 2, 0)),
        ("solid.tmx", r#"offsety="-16""#, 1, (2, 3, -16 << 16)),
    ] {
        let level = baked(name, text(offset, tops));
        assert_eq!((level.width, level.height, level.origin.1), size, "{name}");
    }
}
