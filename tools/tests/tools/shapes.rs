//! The shapes of the platformer's levels: their names and numbers, flips, errors, and the check of
//! the library.
//!
//! The solid part of each shape, independently from N++'s own corners. It shares nothing with the
//! example or the library.

use std::path::PathBuf;

use tilesat::{Aabb, AllShapes, Circle, Fx, Grid, Outside, TileKind, TileMap, TileShape, Vec2};
use tilesat_games::platformer::{ninja, sim};
use tilesat_tools::bake::level::Level;
use tilesat_tools::model::flip::Flip;
use tilesat_tools::play::check::Checker;
use tilesat_tools::play::{self, Figure, constants};
use tilesat_tools::rules::names;

use crate::support;

type Point = (i32, i32);

/// The slopes of N++. Each is a line through its 24 x 24 cell, with the solid at the corner of its
/// number.
const LINES: [(u8, Point, Point); 20] = [
    (6, (0, 24), (24, 0)),
    (7, (0, 0), (24, 24)),
    (8, (24, 0), (0, 24)),
    (9, (24, 24), (0, 0)),
    (18, (0, 12), (24, 0)),
    (19, (0, 0), (24, 12)),
    (20, (24, 12), (0, 24)),
    (21, (24, 24), (0, 12)),
    (22, (0, 24), (24, 12)),
    (23, (0, 12), (24, 24)),
    (24, (24, 0), (0, 12)),
    (25, (24, 12), (0, 0)),
    (26, (0, 24), (12, 0)),
    (27, (12, 0), (24, 24)),
    (28, (24, 0), (12, 24)),
    (29, (12, 24), (0, 0)),
    (30, (12, 24), (24, 0)),
    (31, (0, 0), (12, 24)),
    (32, (12, 0), (0, 24)),
    (33, (24, 24), (12, 0)),
];

/// Whether tile `id` is solid at a point of its cell, given in 96ths. For one-way tiles, whether
/// the point is near their edge.
fn solid(id: u8, (x, y): Point) -> bool {
    let corner = [(0, 0), (96, 0), (96, 96), (0, 96)][usize::from((id + 2) % 4)];
    let away = |c: Point| (x - c.0).pow(2) + (y - c.1).pow(2);
    match id {
        0 => false,
        1 => true,
        2 => y < 48,
        3 => x > 48,
        4 => y > 48,
        5 => x < 48,
        10..=13 => away(corner) < 96 * 96,
        14..=17 => away((96 - corner.0, 96 - corner.1)) > 96 * 96,
        34 => y < 12,
        35 => x > 84,
        36 => y > 84,
        37 => x < 12,
        _ => {
            let &(_, a, b) = LINES.iter().find(|line| line.0 == id).unwrap();
            let side = |p: Point| (b.0 - a.0) * (p.1 - 4 * a.1) - (b.1 - a.1) * (p.0 - 4 * a.0);
            assert_ne!(side((x, y)), 0);
            side((x, y)).signum() == side(corner).signum()
        }
    }
}

/// Points of a cell that no outline passes through, flipped or not. One coordinate is odd, and the
/// other a multiple of 4 but not the middle. No line of slope 1, 2 or 1/2 through the half lattice
/// passes there, and no arc.
fn points() -> impl Iterator<Item = Point> {
    (1..96).step_by(6).flat_map(|x| (4..96).step_by(8).map(move |y| (x, y)))
}

fn flips() -> impl Iterator<Item = Flip> {
    (0..8).map(|bits| Flip { diagonal: bits & 1 != 0, horizontal: bits & 2 != 0, vertical: bits & 4 != 0 })
}

/// The position of a point of a flipped tile in the tile itself. Tiled flips along the diagonal
/// first.
fn source(flip: Flip, (x, y): Point) -> Point {
    let (x, y) = (if flip.horizontal { 96 - x } else { x }, if flip.vertical { 96 - y } else { y });
    if flip.diagonal { (y, x) } else { (x, y) }
}

/// The points distinguish all shapes, and every flip of a shape is the one in the table.
#[test]
fn flips_of_all_shapes() {
    for shape in TileShape::ALL {
        for flip in flips() {
            let turned = flip.of(shape);
            for p in points() {
                assert_eq!(solid(turned as u8, p), solid(shape as u8, source(flip, p)), "{shape:?} {flip:?} at {p:?}");
            }
        }
    }
    for (i, a) in TileShape::ALL.into_iter().enumerate() {
        for b in TileShape::ALL.into_iter().skip(i + 1) {
            assert!(points().any(|p| solid(a as u8, p) != solid(b as u8, p)), "{a:?} and {b:?}");
        }
    }
}

#[test]
fn names_and_numbers() {
    assert_eq!(names::name(TileShape::MildLowTopRight), "mild-low-top-right");
    for shape in TileShape::ALL {
        assert_eq!(names::shape(&names::name(shape)), Some(shape));
        assert_eq!(names::shape(&names::name(shape).to_uppercase()), Some(shape));
        let number = (shape as u8).to_string();
        assert_eq!(names::npp(&number), Some(shape).filter(|_| (shape as u8) < 34), "{number}");
    }
    for name in ["", "slope", "slope_top_left", "SlopeTopLeft", "one-way", "full "] {
        assert_eq!(names::shape(name), None, "{name}");
    }
    for number in ["", "-1", "34", "38", "256", "4294967297", "1.0", "0x1", "one"] {
        assert_eq!(names::npp(number), None, "{number}");
    }
}

#[test]
fn properties_win_over_the_class() {
    let of = |names: &[&str], shape: Option<&str>, npp: Option<&str>| {
        let property = |name: &str, value: &str| format!(r#"<property name="{name}" value="{value}"/>"#);
        let (class, ice) =
            (names[0], names[1..].iter().map(|name| format!(r#"<property name="{name}" type="bool" value="true"/>"#)));
        let given = shape.map(|v| property("shape", v)).into_iter().chain(npp.map(|v| property("npp", v))).chain(ice);
        let tile = format!(
            r#"<tile id="0" type="{class}"><properties>{}</properties></tile><tile id="1" type="Solid"/>"#,
            given.collect::<String>()
        );
        let level = support::level(&map("properties", &tile, &[1, 2, 0, 0, 0, 0, 0, 0]))?;
        Ok((level.kind(0, 0).shape, level.flags)) as tilesat_tools::fail::Result<_>
    };
    let ice = vec!["Ice".to_owned()];
    for (names, own) in [
        (&["Solid", "Ice"][..], TileShape::Full),
        (&["OneWay", "Ice"], TileShape::OneWayUp),
        (&["Ice"], TileShape::Empty),
    ] {
        let slope = (TileShape::SlopeBottomLeft, ice.clone());
        assert_eq!(of(names, Some("slope-bottom-left"), None).as_ref(), Ok(&slope));
        assert_eq!(of(names, Some(" Slope-Bottom-Left "), Some("9")).as_ref(), Ok(&slope));
        assert_eq!(of(names, None, Some("9")).as_ref(), Ok(&slope));
        assert_eq!(of(names, Some("empty"), Some("0")).unwrap().0, TileShape::Empty);
        assert_eq!(of(names, Some(""), None), Ok((own, ice.clone())));
    }
    for (shape, npp, words) in [
        (Some("slope"), Some("34"), ["npp", "'34'"]),
        (Some("slope-left"), None, ["shape", "'slope-left'"]),
        (None, Some("34"), ["npp", "'34'"]),
        (None, Some(""), ["npp", "''"]),
        (Some("full"), Some("2"), ["'full'", "'2' (half-top)"]),
    ] {
        let error = of(&["Solid"], shape, npp).unwrap_err().to_string();
        assert!(words.iter().all(|word| error.contains(word)), "{error}");
    }
}

/// A map of 8 columns whose tileset holds these tiles.
fn map(name: &str, tiles: &str, gids: &[u32]) -> PathBuf {
    let (rows, csv) = (gids.len() / 8, gids.iter().map(u32::to_string).collect::<Vec<_>>().join(","));
    let text = format!(
        r#"<?xml version="1.0"?>
<map version="1.10" orientation="orthogonal" width="8" height="{rows}" tilewidth="24" tileheight="24" infinite="0">
 <tileset firstgid="1" name="set" tilewidth="24" tileheight="24" tilecount="64" columns="8">{tiles}</tileset>
 <layer id="1" name="World" width="8" height="{rows}"><data encoding="csv">{csv}</data></layer>
</map>"#
    );
    support::scratch("shapes", &format!("{name}.tmx"), text)
}

fn tile(id: u8, property: &str) -> String {
    format!("<tile id=\"{id}\"><properties><property {property}/></properties></tile>")
}

/// Every shape in every flip, by name and by number, through a file.
#[test]
fn a_map_of_all_flips() {
    let gids: Vec<u32> = (0..38u32)
        .flat_map(|id| {
            (0..8u32).map(move |bits| (id + 1) | (bits & 1) << 29 | (bits >> 1 & 1) << 31 | (bits >> 2) << 30)
        })
        .collect();
    let name = |s: TileShape| tile(s as u8, &format!("name=\"shape\" value=\"{}\"", names::name(s)));
    let number = |s: TileShape| match s as u8 {
        id @ 34.. => tile(id, &format!("name=\"shape\" value=\"{}\"", names::name(s))),
        id => tile(id, &format!("name=\"npp\" type=\"int\" value=\"{id}\"")),
    };
    let by_name: String = TileShape::ALL.into_iter().map(name).collect();
    let by_number: String = TileShape::ALL.into_iter().map(number).collect();
    for (file, tiles) in [("by_name", by_name), ("by_number", by_number)] {
        let level = support::level(&map(file, &tiles, &gids)).unwrap();
        assert!(!level.is_blocks());
        for (y, shape) in TileShape::ALL.into_iter().enumerate() {
            for (x, flip) in flips().enumerate() {
                let found = level.kind(x as u16, y as u16).shape as u8;
                assert!(points().all(|p| solid(found, p) == solid(shape as u8, source(flip, p))), "{shape:?} {flip:?}");
            }
        }
    }
}

/// A shape of the collision editor that the library does not have, in every flip. It is solid
/// exactly as Tiled draws it.
#[test]
fn drawn_shapes_in_all_flips() {
    let corners: [Point; 3] = [(8, 12), (76, 20), (16, 88)];
    let list: Vec<String> = corners.iter().map(|(x, y)| format!("{},{}", x / 4, y / 4)).collect();
    let polygon = format!("<polygon points=\"{}\"/>", list.join(" "));
    let tile = format!("<tile id=\"0\"><objectgroup><object id=\"1\">{polygon}</object></objectgroup></tile>");
    let gids: Vec<u32> =
        (0..8u32).map(|bits| 1 | (bits & 1) << 29 | (bits >> 1 & 1) << 31 | (bits >> 2) << 30).collect();
    let path = map("drawn", &tile, &gids);
    let levels = tilesat_tools::read::load(&path, None).unwrap();
    let bundle = tilesat_tools::bake::bake(&levels.maps, &tilesat_tools::bake::Settings::default()).unwrap();
    let segments = bundle.levels[0].segments().unwrap().unwrap();
    let inside = |p: Point| {
        let edges = corners.iter().zip(corners.iter().cycle().skip(1));
        edges.map(|(a, b)| ((b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0)).signum()).sum::<i32>().abs() == 3
    };
    let mut solid = 0;
    for (x, flip) in flips().enumerate() {
        for p in points() {
            // The test skips points on a side of the polygon.
            let from = source(flip, p);
            let edges = corners.iter().zip(corners.iter().cycle().skip(1));
            if edges.clone().any(|(a, b)| (b.0 - a.0) * (from.1 - a.1) == (b.1 - a.1) * (from.0 - a.0)) {
                continue;
            }
            let at = Vec2::from_raw(((x as i32 * 96 + p.0) << 16) / 4, (p.1 << 16) / 4);
            let found = segments.overlaps(&Aabb::new(at, at).unwrap());
            assert_eq!(found, inside(from), "{flip:?} at {p:?}");
            solid += usize::from(found);
        }
    }
    assert!(solid > 100);
}

#[test]
fn errors_name_tile_property_and_value() {
    let gids = [8, 1, 1, 1, 1, 1, 1, 1];
    let solid = "<tile id=\"0\" type=\"Solid\"/>";
    let error = |name: &str, property: &str| {
        let path = map(name, &(solid.to_owned() + &tile(7, property)), &gids);
        support::level(&path).unwrap_err().to_string()
    };
    for (name, property, value) in [
        ("unknown", "name=\"shape\" value=\"slope-left\"", "property shape 'slope-left'"),
        ("large", "name=\"npp\" type=\"int\" value=\"34\"", "property npp '34'"),
        ("less", "name=\"npp\" type=\"int\" value=\"-1\"", "property npp '-1'"),
        ("float", "name=\"npp\" type=\"float\" value=\"1.5\"", "property npp '1.5'"),
        ("word", "name=\"npp\" type=\"int\" value=\"six\"", "property npp 'six'"),
        ("quoted", "name='shape' value='half-a\"b'", "property shape 'half-a\"b'"),
    ] {
        let text = error(name, property);
        assert!(text.contains("tile 7 of tileset 'set'") && text.contains(value), "{text}");
    }
    // A tile that no layer uses may have any properties.
    let path = map("unused", &(solid.to_owned() + &tile(9, "name=\"npp\" value=\"99\"")), &gids);
    assert!(support::level(&path).is_ok());
}

#[test]
fn more_than_256_kinds_are_refused() {
    let shape = |id: u8| tile(id, &format!("name=\"npp\" type=\"int\" value=\"{id}\""));
    let flag = |id: u8| format!("<tile id=\"{id}\" type=\"f{id}\"/>");
    let tiles: String = (0..34).map(shape).chain((34..42).map(flag)).collect();
    let bake = |count: u32| {
        let list = |of: &dyn Fn(u32) -> u32| {
            (0..264).map(|i| if i < count { of(i).to_string() } else { "0".to_owned() }).collect::<Vec<_>>().join(",")
        };
        let path = map("kinds", &tiles, &[0; 264]);
        let text = std::fs::read_to_string(&path).unwrap();
        let flags = format!(
            "<layer name=\"flags\" width=\"8\" height=\"33\"><data encoding=\"csv\">{}</data></layer></map>",
            list(&|i| 35 + i / 34)
        );
        let zeros = vec!["0"; 264].join(",");
        let text = text.replace(&zeros, &list(&|i| 1 + i % 34)).replace("</map>", &flags);
        support::level(&support::scratch("shapes", "kinds.tmx", text))
    };
    // An empty tile is a kind too, with id 0, whether a cell has it or not.
    assert_eq!(bake(255).unwrap().ids.len(), 256);
    assert!(bake(256).unwrap_err().to_string().contains("more than 256"));
}

/// Compares the exact check of the example and the library's tests, neither of which knows the
/// other. Every shape, with boxes and balls of several sizes. They are on the quarters and fifths
/// of a cell (arcs pass through 3/5, 4/5), and a raw unit beside them.
#[test]
fn the_check_and_the_library_agree() {
    let (cell, quarter) = (10i64 << 16, 10i64 << 14);
    let lattice: Vec<i64> = (0..=12).map(|i| i * quarter).chain((3..=12).map(|i| i * cell / 5)).collect();
    let mut met = 0;
    for shape in TileShape::ALL {
        let level = Level {
            layer: "a".into(),
            width: 3,
            height: 3,
            tile: 10,
            origin: (0, 0),
            tiles: vec![0, 0, 0, 0, 1, 0, 0, 0, 0],
            ids: vec![TileKind::EMPTY, TileKind::of(shape)],
            flags: Vec::new(),
        };
        let (check, kinds) = (Checker::new(&level), level.kinds());
        let grid = Grid::new(3, 3, Fx::from_num(10), Vec2::ZERO).unwrap();
        let map = TileMap::<AllShapes>::of(&level.tiles, grid, &kinds).unwrap();
        for (i, j) in lattice.iter().flat_map(|&i| lattice.iter().map(move |&j| (i, j))) {
            for (dx, dy) in [(0, 0), (1, 0), (0, 1), (-1, 0), (0, -1), (1, 1), (-1, 1)] {
                let (x, y) = (i + dx, j + dy);
                for size in [2, quarter, 2 * quarter, cell + quarter] {
                    let round = Figure::Disc { centre: (x, y), radius: size };
                    let ball = Circle::new(Vec2::from_raw(x as i32, y as i32), Fx::from_bits(size as i32)).unwrap();
                    assert_eq!(check.overlaps(&round), map.overlaps(&ball), "{shape:?} {round:?}");
                    let square = Figure::Box { min: (x, y), max: (x + size, y + quarter) };
                    let far = Vec2::from_raw((x + size) as i32, (y + quarter) as i32);
                    let aabb = Aabb::new(Vec2::from_raw(x as i32, y as i32), far).unwrap();
                    assert_eq!(check.overlaps(&square), map.overlaps(&aabb), "{shape:?} {square:?}");
                    met += usize::from(map.overlaps(&ball)) + usize::from(map.overlaps(&aabb));
                }
            }
        }
    }
    assert!(met > 10_000);
}

fn own() -> Level {
    support::level(&support::own("platformer/levels/ninja.tmx")).unwrap()
}

const HINT: &str =
    "bake it: cargo run --example platformer -- --level ninja --bake examples/games/src/platformer/ninja";

#[test]
fn ninja_is_baked_and_has_all_shapes() {
    let level = own();
    assert!(level.tiles == ninja::TILES, "{HINT}");
    assert!(
        constants::constants(&level, "ninja.bin") == include_str!("../../../examples/games/src/platformer/ninja.rs"),
        "{HINT}"
    );
    assert_eq!(level.kinds(), ninja::KINDS);
    assert_eq!((level.width, level.height, level.tile), (ninja::WIDTH, ninja::HEIGHT, ninja::TILE));
    assert!(level.width >= 44 && level.height >= 25);
    for shape in TileShape::ALL {
        assert!(level.ids.iter().any(|kind| kind.shape == shape), "{shape:?}");
    }
    assert!(["Coin", "Kill", "Ladder", "Water", "Win"].iter().all(|flag| level.mask(flag) != 0));
}

/// Desktop and firmware play the same run. The library keeps every body out of the solid.
#[test]
fn ninja_plays() {
    let grid = Grid::new(ninja::WIDTH, ninja::HEIGHT, Fx::from_num(ninja::TILE), Vec2::ZERO).unwrap();
    let map = TileMap::<AllShapes>::of(ninja::TILES, grid, &ninja::KINDS).unwrap().with_outside(Outside::Solid);
    let rules = sim::Rules { coin: ninja::COIN, kill: ninja::KILL, win: ninja::WIN, ladder: ninja::LADDER };
    let mut state = sim::Sim::new(&map, rules, sim::SEED).unwrap();
    for _ in 0..600 {
        assert_eq!(state.step(&map).refused, 0);
    }
    let level = own();
    let run = play::play(&level.clone().into(), 600, sim::SEED, &mut std::io::sink()).unwrap();
    assert_eq!((run.overlaps, run.escaped, run.refused, run.hash), (0, 0, 0, state.hash()));
    for seed in 200..208 {
        let run = play::play(&level.clone().into(), 600, seed, &mut std::io::sink()).unwrap();
        assert_eq!((run.overlaps, run.escaped, run.refused), (0, 0, 0), "seed {seed}");
    }
}

/// Over all runs, the level shows every trick.
#[test]
fn the_player_plays_ninja() {
    let level = own();
    let scores =
        [12, 14, 19, 33].map(|seed| play::play(&level.clone().into(), 3600, seed, &mut std::io::sink()).unwrap().score);
    let sum = |of: fn(&sim::Score) -> u32| scores.iter().map(of).sum::<u32>();
    let tricks = [sum(|s| s.coins), sum(|s| s.deaths), sum(|s| s.wins), sum(|s| s.bumps), sum(|s| s.landings)];
    assert!(tricks.iter().all(|&count| count > 0), "{scores:?}");
}

/// A level of blocks gives the same run with either set.
#[test]
fn blocks_play_the_same_in_every_set() {
    let level = support::level(&support::own("platformer/levels/meadow.tmx")).unwrap();
    assert!(level.is_blocks());
    let kinds = level.kinds();
    let grid = Grid::new(level.width, level.height, Fx::from_num(level.tile), Vec2::ZERO).unwrap();
    let map = TileMap::<AllShapes>::of(&level.tiles, grid, &kinds).unwrap().with_outside(Outside::Solid);
    let mut state = sim::Sim::new(&map, play::rules(&level), sim::SEED).unwrap();
    for _ in 0..600 {
        state.step(&map);
    }
    assert_eq!(state.hash(), 0x66e0_09a9);
}
