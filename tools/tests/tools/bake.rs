//! The baker: its own levels, its refusals, its arguments.

use std::fs;
use std::path::PathBuf;

use tilesat::world::World;
use tilesat::{Aabb, AllShapes, Fx, Grid, SegmentMap, TileKinds, TileMap, TileShape, Vec2, world::Feature};

use crate::baked::{quarry, steps, world};
use crate::support::{self, Ran, ldtk, objects, own, rows, scratch};

/// Bakes a level file of the examples or of a test. Returns the run and the output file.
fn baked(file: PathBuf, out: &str, options: &str) -> (Ran, PathBuf) {
    let out = scratch("bake", out, "");
    let ran = support::run("bake", file, &format!("-o {} {options}", out.display()));
    (ran, out)
}

fn fine(ran: &Ran) {
    assert!(ran.status == 0 && ran.err.is_empty(), "{ran:?}");
}

const HINT: &str =
    "bake it: cargo run -p tilesat-tools -- bake examples/levels/NAME -o tools/tests/tools/baked/NAME.rs";

#[test]
fn source_equals_the_levels() {
    for (level, source) in [
        ("levels/quarry.tmx", include_str!("baked/quarry.rs")),
        ("levels/steps.ldtk", include_str!("baked/steps.rs")),
        ("../tools/tests/corpus/ldtk/grid_vania.ldtk", include_str!("baked/world.rs")),
    ] {
        let (ran, out) = baked(own(level), "own.rs", "");
        fine(&ran);
        assert!(fs::read_to_string(out).unwrap() == source, "{HINT}");
    }
}

fn tiles<'a>(tiles: &'a [u8], kinds: &'a TileKinds, (width, height): (u16, u16)) -> TileMap<'a, AllShapes> {
    let grid = Grid::new(width, height, Fx::from_num(quarry::TILE), Vec2::ZERO).unwrap();
    TileMap::<AllShapes>::of(tiles, grid, kinds).unwrap()
}

fn everything<W: World>(world: &W) -> Vec<Feature> {
    let region = Aabb::new(Vec2::from_ints(-64, -64), Vec2::from_ints(1024, 1024)).unwrap();
    world.features(&region).collect()
}

/// The compiler builds from the source what the bytes say.
#[test]
fn bytes_equal_the_source() {
    let (ran, out) = baked(own("levels/quarry.tmx"), "quarry.bin", "");
    fine(&ran);
    let read = |what: &str| fs::read(out.with_extension(format!("{what}.bin"))).unwrap();
    assert!(read("tiles") == quarry::TILES);
    let map = tiles(quarry::TILES, &quarry::KINDS, (quarry::WIDTH, quarry::HEIGHT));
    assert_eq!(everything(&map), everything(&quarry::MAP));
    assert_eq!((steps::MAP.width(), steps::MAP.height()), (steps::WIDTH, steps::HEIGHT));
    let bytes = read("segments");
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    assert_eq!((map.count(), map.grid()), (quarry::SEGMENTS.count(), quarry::SEGMENTS.grid()));
    assert_eq!(everything(&map), everything(&quarry::SEGMENTS));
    // Nine outlines are seven paths, because a start and an exit are none.
    // Then objects that are not solid, and the map of other tiles.
    assert_eq!(quarry::OBJECTS[0].area, quarry::OBJECT_START);
    assert_eq!(quarry::OBJECTS.iter().map(|object| object.class).collect::<Vec<_>>(), ["Places"; 2]);
    let mut changed = *quarry::TILES;
    changed[0] = 0;
    let corner = |map: &TileMap<'_>| map.kind(tilesat::Cell::new(0, 0));
    let full = tilesat::TileKind::FULL;
    assert_eq!((corner(&quarry::MAP), corner(&quarry::map(&changed).unwrap())), (full, tilesat::TileKind::EMPTY));
    // Ice is the last flag.
    assert_eq!([quarry::FLAG_COIN, quarry::FLAG_LADDER, quarry::FLAG_ICE], [1, 2, 4]);
    let flags = everything(&map).iter().fold(0, |all, feature| all | feature.flags);
    assert_eq!(flags, quarry::FLAG_ICE | quarry::FLAG_LADDER);
    assert!(!everything(&tiles(quarry::TILES, &quarry::KINDS, (quarry::WIDTH, quarry::HEIGHT))).is_empty());
}

/// The smallest set that has the level's shapes: it links the least code.
#[test]
fn the_set_is_the_smallest() {
    let cases = [
        ("full", "Blocks"),
        ("one-way-left", "Blocks"),
        ("half-top", "Slopes"),
        ("steep-high-bottom-left", "Slopes"),
        ("convex-top-left", "AllShapes"),
        ("concave-bottom-left", "AllShapes"),
    ];
    for (shape, set) in cases {
        let (ran, out) = baked(scratch("bake", "set.tmx", rows(&["# ="])), "set.rs", &format!("--solid Kill={shape}"));
        fine(&ran);
        assert!(fs::read_to_string(out).unwrap().contains("TileMap<::tilesat::Blocks>"), "no tile has it");
        let file = scratch("bake", "set.tmx", rows(&["# ="]).replace(">1,0,2<", ">1,3,2<"));
        let (ran, out) = baked(file, "set.rs", &format!("--solid Kill={shape}"));
        fine(&ran);
        let source = fs::read_to_string(out).unwrap();
        assert!(source.contains(&format!("TileMap<::tilesat::{set}>")), "{shape}: {source}");
    }
}

#[test]
fn values_of_a_grid_are_shapes() {
    let (ran, out) = baked(own("levels/steps.ldtk"), "steps.bin", "");
    fine(&ran);
    assert!(fs::read(out).unwrap() == steps::TILES);
    let map = tiles(steps::TILES, &steps::KINDS, (steps::WIDTH, steps::HEIGHT));
    let at = |x, y| {
        let kind = map.kind(tilesat::Cell::new(x, y));
        (kind.shape, kind.flags)
    };
    assert_eq!(at(0, 0), (TileShape::Full, 0));
    assert_eq!(at(23, 12), (TileShape::Full, 0), "Solid");
    assert_eq!(at(5, 8), (TileShape::SlopeBottomRight, 0));
    assert_eq!(at(11, 11), (TileShape::SteepLowBottomLeft, 0), "steep_low_bottom_left");
    assert_eq!(at(12, 4), (TileShape::OneWayUp, 0));
    assert_eq!(at(3, 5), (TileShape::HalfTop, steps::FLAG_KILL));
    assert_eq!(at(1, 11), (TileShape::MildLowBottomRight, steps::FLAG_ICE));
    assert_eq!(at(13, 3), (TileShape::Empty, steps::FLAG_COIN));
    assert_eq!(at(22, 8), (TileShape::Empty, steps::FLAG_LADDER));
    assert_eq!(at(22, 10), (TileShape::Empty, steps::FLAG_WATER));
    assert_eq!((steps::TILE, steps::WORLD), (16, [0, 0, 384, 224]));
}

/// Each level of a world is a module, knows its position, and uses the shared table.
#[test]
fn worlds() {
    let places = [world::cave_1::WORLD, world::cave_1_2::WORLD, world::hall::WORLD];
    assert_eq!(places, [[0, 0, 128, 96], [128, 0, 128, 96], [-128, 96, 128, 96]]);
    let full = |map: &TileMap<'_, tilesat::Blocks>| everything(map).iter().all(|feature| !feature.one_way);
    assert!([world::cave_1::MAP, world::cave_1_2::MAP, world::hall::MAP].iter().all(full));
    let water = world::hall::TILES.iter().filter(|&&id| world::KINDS.get(id).flag(world::FLAG_WATER)).count();
    assert_eq!((water, world::FLAG_LADDER), (8, 1));
}

#[test]
fn report_and_picture() {
    let picture = scratch("bake", "quarry.png", "");
    let (ran, _) =
        baked(own("levels/quarry.tmx"), "report.bin", &format!("--body 10x14 --picture {}", picture.display()));
    fine(&ran);
    let expected = [
        "tiles   layer 'Ground': 30x17 of 16 px",
        "flash   510 bytes of tiles, 520 of kinds",
        "objects 7 in 37 segments, 25x12 cells of 16 px",
        "flash   2166 bytes",
        "flags   Coin = bit 0, Ladder = bit 1, Ice = bit 2",
    ];
    for line in expected {
        assert!(ran.out.lines().any(|l| l == line), "{line:?} is not in {}", ran.out);
    }
    for word in [
        "interior, 91 boundary",
        "pieces  at most 5 in a cell, on average 0.73",
        "work    a body of 10x14 meets at most ",
    ] {
        assert!(ran.out.contains(word), "{word:?} is not in {}", ran.out);
    }
    assert!(fs::read(picture).unwrap().starts_with(b"\x89PNG\r\n"));
}

/// Counted by hand.
#[test]
fn the_report_counts() {
    let block = objects(r#"<object id="1" x="16" y="16" width="16" height="16"/>"#);
    let (ran, _) = baked(scratch("bake", "block.tmx", block), "block.bin", "--cell 16 --body 4x4");
    fine(&ran);
    let lines: Vec<&str> = ran.out.lines().collect();
    // A grid of only the block. Its four faces and corners are all in the one cell.
    assert_eq!(
        lines[..5],
        [
            "objects 1 in 4 segments, 1x1 cells of 16 px",
            "flash   141 bytes",
            "cells   0 empty, 0 interior, 1 boundary",
            "pieces  at most 8 in a cell, on average 8.00 (8.00 in a boundary cell)",
            "work    a body of 4x4 meets at most 8 pieces in 1 cells",
        ]
    );
    // A loop of four edges has a face on each side of each.
    let fence = objects(
        r#"<object id="1" width="16" height="16"><properties><property name="kind" value="wall"/></properties></object>"#,
    );
    let (ran, _) = baked(scratch("bake", "fence.tmx", fence), "fence.bin", "");
    assert!(ran.out.starts_with("objects 1 in 8 segments"), "{ran:?}");
    let room = scratch("bake", "room.tmx", rows(&["####", "####", "####", " ## "]));
    let (ran, _) = baked(room, "room.bin", "");
    fine(&ran);
    assert!(ran.out.contains("cells   2 empty, 4 interior, 10 boundary"), "{}", ran.out);
}

/// A refusal: status 2, one line that contains the word, and no file.
fn refused((ran, out): (Ran, PathBuf), word: &str) {
    assert!(ran.status == 2 && ran.err.lines().count() == 1, "{ran:?}");
    assert!(ran.err.starts_with("tilesat bake: ") && ran.err.contains(word), "{word:?} is not in {ran:?}");
    assert!(fs::read(out).unwrap().is_empty());
}

/// The library's errors name the object that the user drew.
#[test]
fn refused_objects() {
    let object =
        |points: &str| format!(r#"<object id="7" name="hut" x="0" y="0"><polygon points="{points}"/></object>"#);
    let good = r#"<object id="6" x="99" y="99" width="9" height="9"/>"#;
    let cases = [
        (object("0,0 8192,0 0,8"), "object 7 'hut' of layer 'L' at (8192, 0): it is outside of the domain"),
        (object("0,0 99999,0 0,8"), "object 7 'hut' of layer 'L' at (99999, 0): it is outside of the domain"),
        (
            r#"<object id="7" type="Hole"><polyline points="0,0 9,0 9,9"/></object>"#.into(),
            "object 7 of layer 'L': a hole that is not closed",
        ),
    ];
    for (i, (list, word)) in cases.iter().enumerate() {
        let level = scratch("bake", &format!("object{i}.tmx"), objects(&(good.to_owned() + list)));
        refused(baked(level, "refused.bin", ""), word);
    }
    let nothing = scratch("bake", "nothing.tmx", objects(""));
    refused(baked(nothing, "refused.bin", ""), "nothing is solid");
}

#[test]
fn refused_grids() {
    let good = ldtk(&["Full", "Empty_Coin"], 2, 2, "1,0,2,1");
    let change = |from: &str, to: &str| good.replacen(from, to, 1);
    let cases = [
        ("{".to_owned(), "not an LDtk project: EOF"),
        ("{}".to_owned(), "has no levels"),
        (change("IntGrid", "Tiles"), "nothing is solid"),
        (
            change("Full", "Snow").replace("\"Solid\"", "\"G\""),
            "nothing is solid: no tile, no object; the tile layer is 'G' (3 tiles): add --solid-layer 'G'",
        ),
        (
            change("\"Full\"", "null").replace("\"Solid\"", "\"G\""),
            "value 1 of layer 'G' has no identifier: name it in LDtk, or add --solid G:1",
        ),
        (change("1,0,2,1", "1,0,2"), "3 values for 2x2 cells"),
        (change("1,0,2,1", "1,0,2,0.5"), "0.5 is not a whole number"),
        (change("\"__cWid\":2", "\"__cWid\":-2"), "__cWid is -2, not a count"),
        (change("\"__cWid\":2", "\"__cWid\":4000000000"), "more than 16777216 cells"),
        (change("\"__gridSize\":16", "\"__gridSize\":0"), "cells of 0 pixels"),
        (change("\"layerDefUid\":2", "\"layerDefUid\":3"), "defs.layers has no uid 3"),
        (
            change("\"layerInstances\":", "\"externalRelPath\":\"none.ldtkl\",\"layerInstances\":null,\"x\":"),
            "none.ldtkl: cannot read",
        ),
        ("[".repeat(1000).replacen('[', "{\"a\":[", 1), "nested more than 208 deep"),
    ];
    for (i, (text, word)) in cases.iter().enumerate() {
        refused(baked(scratch("bake", &format!("grid{i}.ldtk"), text), "refused.bin", ""), word);
    }
    let level = || scratch("bake", "good.ldtk", &good);
    refused(baked(level(), "refused.bin", "--level Two"), "no level 'Two'; there are: One");
    refused(baked(level(), "refused.bin", "--layer Two"), "no tile layer 'Two'; there are: Solid");
    fine(&baked(level(), "good.bin", "--level One --layer Solid").0);
}

/// A level in a separate file.
#[test]
fn external_levels() {
    let good = ldtk(&["Full"], 2, 1, "1,0");
    let apart = good.split("\"levels\":[").nth(1).unwrap().strip_suffix("]}").unwrap();
    scratch("bake", "apart.ldtkl", apart);
    let text =
        good.replace("\"layerInstances\":", "\"externalRelPath\":\"apart.ldtkl\",\"layerInstances\":null,\"x\":");
    let (ran, out) = baked(scratch("bake", "whole.ldtk", text), "apart.bin", "");
    fine(&ran);
    assert_eq!(fs::read(out).unwrap(), [1, 0]);
}

#[test]
fn bad_arguments() {
    let level = || scratch("bake", "arguments.tmx", rows(&["##"]));
    for (options, word) in [
        ("--cell 0", "--cell needs pixels above 0 and below 8192, got 0"),
        ("--cell", "--cell needs a value"),
        ("--body 4", "WIDTHxHEIGHT"),
        ("--fps 3", "--fps"),
        ("--layer Nowhere", "no tile layer 'Nowhere'"),
        ("--picture /no/such/folder/a.png", "cannot write"),
        ("-o b.bin", "twice"),
        ("b.tmx", "twice"),
    ] {
        let (ran, out) = baked(level(), "arguments.bin", options);
        let ran = Ran { out: String::new(), ..ran };
        assert!(ran.status == 2 && ran.err.contains(word), "{word:?} is not in {ran:?} {}", out.display());
    }
    for (options, word) in
        [("", "no -o"), ("-o a.txt", "neither in .bin nor in .rs"), ("-o /no/such/a.bin", "cannot write")]
    {
        let ran = support::run("bake", level(), options);
        assert!(ran.status == 2 && ran.err.contains(word), "{word:?} is not in {ran:?}");
    }
    let odd = scratch("bake", "odd.tmx", objects(r#"<object id="1" width="9" height="9"/>"#));
    refused(baked(odd, "odd.bin", "--cell 0.00002"), "too many cells of 0.00002 px: use larger cells");
    let vast = scratch("bake", "vast.tmx", objects(r#"<object id="1" width="8000" height="8000"/>"#));
    refused(baked(vast, "vast.bin", "--cell 1"), "use larger cells");
    let help = support::run("bake", "--help", "");
    assert!(help.status == 0 && help.out.starts_with("usage: tilesat bake "), "{help:?}");
}
