//! Worlds of any size in rooms: cut maps, projects whose levels are rooms, and bodies that do not
//! notice the rooms.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use tilesat::world::World as _;
use tilesat::{
    AllShapes, Axis, Cell, Circle, Fx, Grid, Joined, Mover, Outside, Room, Rooms, SegmentMap, TileKinds, TileMap,
    TileShape, Vec2,
};
use tilesat_tools::read;
use tilesat_tools::rooms::{self, Cut, World};
use tilesat_tools::rules::options::Options;

use crate::baked::{quarry, quarry_rooms, steps_rooms};
use crate::support::{self, Ran, map, scratch};

/// Rooms of 5 x 4 cells for bodies of 10 and motions of 12 pixels.
const CUT: Cut = Cut { room: Some((5, 4)), body: Some(Fx::lit("10")), motion: Some(Fx::lit("12")) };

fn world(file: &Path, cut: &Cut) -> Result<World, String> {
    let levels = read::load(file, None).map_err(|fail| fail.to_string())?;
    rooms::bake(&levels.maps, &Options::default(), cut).map_err(|fail| fail.to_string())
}

fn kinds(world: &World) -> TileKinds {
    (0..).zip(&world.kinds).fold(TileKinds::EMPTY, |kinds, (id, kind)| kinds.with(id, *kind))
}

/// A project of levels `A`, `B` and so on at these positions in pixels, each of these rows.
fn project(levels: &[(i32, i32, &[&str])]) -> String {
    let level = |(number, (x, y, rows)): (u8, &(i32, i32, &[&str]))| {
        let values: Vec<&str> =
            rows.iter().flat_map(|row| row.chars().map(|c| if c == '#' { "1" } else { "0" })).collect();
        let (width, height) = (rows[0].len(), rows.len());
        format!(
            r#"{{"identifier":"{}","worldX":{x},"worldY":{y},"pxWid":{},"pxHei":{},"layerInstances":[{{"__type":"IntGrid","__identifier":"Solid","__cWid":{width},"__cHei":{height},"__gridSize":16,"__pxTotalOffsetX":0,"__pxTotalOffsetY":0,"layerDefUid":2,"intGridCsv":[{}]}}]}}"#,
            char::from(b'A' + number),
            16 * width,
            16 * height,
            values.join(",")
        )
    };
    let levels: Vec<String> = (0..).zip(levels).map(level).collect();
    format!(
        r#"{{"__header__":{{"app":"LDtk"}},"worldLayout":"GridVania","defs":{{"layers":[{{"uid":2,"intGridValues":[{{"value":1,"identifier":"Full"}}]}}]}},"levels":[{}]}}"#,
        levels.join(",")
    )
}

/// 40 000 pixels. The rooms have the tiles of the map, and each cell of the world belongs to one of
/// them.
#[test]
fn a_map_of_forty_thousand_pixels() {
    let solid = |x: usize, y: usize| y == 7 || (x * 7 + y * 3).is_multiple_of(11);
    let cells: Vec<&str> = (0..8).flat_map(|y| (0..2500).map(move |x| if solid(x, y) { "1" } else { "0" })).collect();
    let file = scratch("rooms", "long.tmx", map(2500, 8, &cells.join(","), ""));
    let world = world(&file, &CUT).unwrap();
    let (whole, kinds) = (world.whole.as_ref().unwrap(), kinds(&world));
    assert_eq!((whole.width, whole.height, world.rooms.len(), world.apron), (2500, 8, 1000, 2));
    let rooms =
        Rooms::<AllShapes>::of(&whole.tiles, (2500, 8), Fx::lit("16"), &kinds, whole.room, world.apron).unwrap();
    for (column, row) in (0..500).flat_map(|c| [(c, 0), (c, 1)]) {
        let room = rooms.room(column, row).unwrap();
        assert_eq!(room.first(), world.rooms[usize::from(row * 500 + column)].first);
        for (x, y) in (0..5).flat_map(|x| (0..4).map(move |y| (x, y))) {
            let kind = room.map().kind(room.map().cell_at(Vec2::from_ints(16 * x + 8, 16 * y + 8)));
            let (x, y) = (usize::from(column) * 5 + x as usize, usize::from(row) * 4 + y as usize);
            assert_eq!(kind.shape == TileShape::Full, solid(x, y), "{x} {y}");
        }
    }
}

/// The room into which a ball crosses.
type Next<'n, 'a> = dyn Fn(&Room<'a>, Vec2) -> Option<(Room<'a>, Vec2)> + 'n;

/// The way of a ball in the world and through the rooms, and the number of crossings.
fn ways<'a>(
    world: &dyn Fn(&Circle, Vec2) -> tilesat::Moved<Circle>,
    there: &dyn Fn(&Room<'a>, &Circle, Vec2) -> tilesat::Moved<Circle>,
    next: &Next<'_, 'a>,
    (first, ball): (Room<'a>, Circle),
) -> u32 {
    let place = |room: &Room<'_>| Vec2::from_ints(room.first().0 as i16 * 16, room.first().1 as i16 * 16);
    let (mut room, mut a, mut v, mut over) = (first, ball, Vec2::ZERO, 0);
    let mut b = a.translated(-place(&room)).unwrap();
    for frame in 0..600 {
        if frame % 40 == 0 {
            v = Vec2::from_raw((frame * 7919 % 1201 - 600) * 800, -(frame * 104_729 % 601) * 800);
        }
        v += Vec2::from_raw(0, 16_384);
        let (moved, double) = (world(&a, v), there(&room, &b, v));
        let bits = |m: &tilesat::Moved<Circle>| (m.velocity, m.remaining, m.floor, m.wall, m.ceiling, m.flags);
        assert_eq!(bits(&moved), bits(&double), "frame {frame}");
        assert_eq!(moved.body.centre(), double.body.centre() + place(&room), "frame {frame}");
        (a, b, v) = (moved.body, double.body, moved.velocity);
        if let Some((entered, by)) = next(&room, b.centre()) {
            (room, b, over) = (entered, b.translated(by).unwrap(), over + 1);
        }
    }
    over
}

/// Levels of one project. Each has its neighbours' tiles around it.
#[test]
fn levels_of_a_project_are_rooms() {
    let hall: &[&str] = &["##########", "#.........", "#.........", "#...##....", "##########"];
    let tower: &[&str] = &["#####", "....#", "....#", "....#", "##..#", "#...#", "#..##", "#####"];
    let cave: &[&str] = &["##########", "..........", "#....#....", "##########"];
    let levels = [(-160, 32, hall), (0, 32, tower), (-160, 112, cave)];
    let file = scratch("rooms", "world.ldtk", project(&levels));
    let world = world(&file, &Cut { room: None, ..CUT }).unwrap();
    let kinds = kinds(&world);
    let rooms: Vec<Room<'_>> = world
        .rooms
        .iter()
        .map(|room| {
            let side = |cells: u16| cells + 2 * world.apron;
            let grid = Grid::new(side(room.size.0), side(room.size.1), Fx::lit("16"), Vec2::ZERO).unwrap();
            let map = TileMap::<AllShapes>::of(&room.tiles, grid, &kinds).unwrap();
            Room::new(map, room.first.0, room.first.1, world.apron).unwrap()
        })
        .collect();
    // The same world in one map, empty between the levels.
    let mut all = vec![0; 40 * 40];
    for (x, y, rows) in levels {
        for (row, line) in rows.iter().enumerate() {
            for (column, c) in line.chars().enumerate() {
                let at = (y / 16 + row as i32) * 40 + x / 16 + 15 + column as i32;
                all[at as usize] = u8::from(c == '#');
            }
        }
    }
    let grid = Grid::new(40, 40, Fx::lit("16"), Vec2::from_ints(-240, 0)).unwrap();
    let whole = TileMap::<AllShapes>::of(&all, grid, &kinds).unwrap().with_outside(Outside::Empty);
    for room in &rooms {
        let (width, height) = (i16::from(room.map().width() as u8), i16::from(room.map().height() as u8));
        for cell in (0..width).flat_map(|x| (0..height).map(move |y| tilesat::Cell::new(x, y))) {
            let (x, y) = room.in_world(cell);
            assert_eq!(room.map().kind(cell), whole.kind(tilesat::Cell::new(x as i16 + 15, y as i16)), "{x} {y}");
        }
    }
    let mover = Mover::platformer(Axis::NEG_Y).with_response(tilesat::Response::Bounce);
    let limited = |v: Vec2| Vec2::new(v.x.clamp(Fx::lit("-8"), Fx::lit("8")), v.y.clamp(Fx::lit("-8"), Fx::lit("8")));
    let over = ways(
        &|ball, v| mover.move_and_slide(&whole, ball, limited(v)).unwrap(),
        &|room, ball, v| mover.move_and_slide(room.map(), ball, limited(v)).unwrap(),
        &|room, place| room.next_of(&rooms, place).map(|(room, by)| (*room, by)).filter(|_| !room.holds(place)),
        (rooms[0], Circle::new(Vec2::from_ints(-100, 60), Fx::lit("5")).unwrap()),
    );
    assert!(over > 4, "{over}");
}

/// A level far from others in the same rows or columns has none of their tiles.
#[test]
fn levels_far_apart() {
    let full: &[&str] = &["####", "####", "####"];
    let row: Vec<(i32, i32, &[&str])> = (0..7).map(|i| (64 * i, 0, full)).collect();
    let column: Vec<(i32, i32, &[&str])> = (0..7).map(|i| (0, 48 * i, full)).collect();
    let far: &[(i32, i32, &[&str])] = &[(0, 0, full), (3200, 16, full), (-16, 4800, full)];
    for (name, levels) in [("row.ldtk", &row[..]), ("column.ldtk", &column), ("far.ldtk", far)] {
        let world = world(&scratch("rooms", name, project(levels)), &Cut { room: None, ..CUT }).unwrap();
        let (apron, cell) = (i32::from(world.apron), |level: &(i32, i32, &[&str])| (level.0 / 16, level.1 / 16));
        for (room, (x, y)) in world.rooms.iter().zip(levels.iter().map(cell)) {
            let width = 4 + 2 * apron;
            for (tile, at) in room.tiles.iter().zip(0..) {
                let (i, j) = (x - apron + at % width, y - apron + at / width);
                let inside = |(a, b): (i32, i32)| (a..a + 4).contains(&i) && (b..b + 3).contains(&j);
                assert_eq!(*tile != 0, levels.iter().map(cell).any(inside), "{name} {i} {j}");
            }
        }
    }
}

/// Polygons over several rooms.
#[test]
fn polygons_of_every_room() {
    let list = r#"<object id="3" x="0" y="0"><polygon points="0,200 120,200 220,150 330,190 480,170 480,240 0,240"/></object>
        <object id="4" x="100" y="100" width="90" height="10"/><object id="5" x="0" y="0"><polyline points="470,20 470,170"/></object>
        <object id="6" x="0" y="0"><polyline points="10,20 10,200"/></object>"#;
    let cells = vec!["0"; 30 * 15].join(",");
    let file = scratch("rooms", "hills.tmx", map(30, 15, &cells, list));
    let world = world(&file, &CUT).unwrap();
    let kinds = kinds(&world);
    let whole = world.whole.as_ref().unwrap();
    let rooms = Rooms::<AllShapes>::of(&whole.tiles, (30, 15), Fx::lit("16"), &kinds, whole.room, world.apron).unwrap();
    let segments: Vec<Option<SegmentMap<'_>>> = world
        .rooms
        .iter()
        .map(|room| room.segments.as_ref().map(|bytes| SegmentMap::from_bytes(bytes).unwrap()))
        .collect();
    assert!(segments.iter().any(Option::is_none));
    // The uncut world is a single room.
    let uncut = self::world(&file, &Cut { room: Some((30, 15)), ..CUT }).unwrap();
    let level = SegmentMap::from_bytes(uncut.rooms[0].segments.as_ref().unwrap()).unwrap();
    let mover = Mover::platformer(Axis::NEG_Y);
    let limited = |v: Vec2| Vec2::new(v.x.clamp(Fx::lit("-8"), Fx::lit("8")), v.y.clamp(Fx::lit("-8"), Fx::lit("8")));
    let over = ways(
        &|ball, v| mover.move_and_slide(&level, ball, limited(v)).unwrap(),
        &|room, ball, v| {
            let (x, y) = room.first();
            let index = (y / 4 * 6 + x / 5) as usize;
            match &segments[index] {
                Some(map) => mover.move_and_slide(&Joined::new(room.map(), map), ball, limited(v)).unwrap(),
                None => mover.move_and_slide(room.map(), ball, limited(v)).unwrap(),
            }
        },
        &|room, place| rooms.next(room, place),
        (rooms.room(1, 0).unwrap(), Circle::new(Vec2::from_ints(100, 40), Fx::lit("5")).unwrap()),
    );
    assert!(over > 10, "{over}");
    assert!(level.overlaps_circle(&Circle::new(Vec2::from_ints(150, 105), Fx::lit("5")).unwrap()));
}

/// A hill of 40 000 pixels. Each room has the part near it.
#[test]
fn a_polygon_of_forty_thousand_pixels() {
    let top: Vec<String> = (0..=1000).map(|k| format!("{},{}", 40 * k, 20 + k * 37 % 40)).collect();
    let top = top.join(" ");
    let list = format!(
        r#"<object id="3" x="0" y="0"><polygon points="{top} 40000,64 0,64"/></object><object id="4" x="0" y="2"><polyline points="40000,0 0,0"/></object>"#
    );
    let file = scratch("rooms", "ridge.tmx", map(2500, 4, &vec!["0"; 10_000].join(","), &list));
    let world = world(&file, &CUT).unwrap();
    assert_eq!(world.rooms.len(), 500);
    for room in &world.rooms {
        let map = SegmentMap::from_bytes(room.segments.as_ref().unwrap()).unwrap();
        assert!(map.count() < 20, "{}", map.count());
        let x = i64::from(room.first.0) * 16;
        for k in (x / 40..=(x + 80) / 40).filter(|k| (1..1000).contains(k)) {
            // Just below and above each corner in the room, and on the wall.
            let (at, top) = (((k * 40 - x) << 16) as i32, ((20 + k * 37 % 40) << 16) as i32);
            let probe = |y: i32| map.overlaps_circle(&Circle::new(Vec2::from_raw(at, y), Fx::from_bits(1)).unwrap());
            assert!(probe(top + 8) && !probe(top - 8) && probe((60 << 16) + 5), "{k}");
            assert!(map.touches_circle(&Circle::new(Vec2::from_raw(at, 2 << 16), Fx::ZERO).unwrap()));
        }
    }
}

/// Hundreds of polygons that end far beyond one border: strips around each other, open to the left.
#[test]
fn polygons_at_one_border() {
    let strip = |i: i32| {
        let (top, bottom, right) = (100 + 4 * i, 4000 - 4 * i, 3900 - 4 * i);
        let points = [
            (1000, top),
            (right, top),
            (right, bottom),
            (1000, bottom),
            (1000, bottom - 2),
            (right - 2, bottom - 2),
            (right - 2, top + 2),
            (1000, top + 2),
        ];
        let points = points.map(|(x, y)| format!("{x},{y}")).join(" ");
        format!(r#"<object id="{}" x="0" y="0"><polygon points="{points}"/></object>"#, i + 1)
    };
    let list: String = (0..400).map(strip).collect();
    let cells = vec!["0"; 256].join(",");
    let text = map(16, 16, &cells, &list)
        .replace("tilewidth=\"16\" tileheight=\"16\"", "tilewidth=\"256\" tileheight=\"256\"");
    let cut = Cut { room: Some((8, 16)), ..Cut::default() };
    let start = Instant::now();
    let world = world(&scratch("rooms", "strips.tmx", text), &cut).unwrap();
    assert!(start.elapsed() < Duration::from_secs(5), "{:?}", start.elapsed());
    for (room, x) in world.rooms.iter().zip([0, 2048]) {
        let map = SegmentMap::from_bytes(room.segments.as_ref().unwrap()).unwrap();
        let probe = |at: i32, y: i32| {
            let at = Vec2::from_ints((at - x) as i16, y as i16);
            map.overlaps_circle(&Circle::new(at, Fx::from_bits(1)).unwrap())
        };
        // In each strip, and between it and the next one; up to 256 pixels into the next room.
        for i in 0..400 {
            for at in [1500, 2000, 2100, 2047 + 256].into_iter().filter(|at| *at < 3898 - 4 * i) {
                assert!(probe(at, 101 + 4 * i) && probe(at, 3999 - 4 * i), "{at} {i}");
                assert!(!probe(at, 103 + 4 * i) && !probe(at, 3997 - 4 * i), "{at} {i}");
            }
        }
    }
}

fn run(file: PathBuf, out: &Path, options: &str) -> Ran {
    support::run("rooms", file, &format!("-o {} {options}", out.display()))
}

#[test]
fn refused() {
    let small = || scratch("rooms", "small.tmx", support::rows(&["##", "##"]));
    let levels: &[(i32, i32, &[&str])] = &[(0, 0, &["##"]), (40, 0, &["##"])];
    let odd = || scratch("rooms", "odd.ldtk", project(levels));
    let linear = || scratch("rooms", "linear.ldtk", project(&[(-1, -1, &["##"]), (-1, -1, &["##"])]));
    let far = map(2, 2, "1,1,1,1", r#"<object id="7" x="0" y="0"><polyline points="0,0 20000.00001,10000"/></object>"#);
    let far = || scratch("rooms", "far.tmx", &far);
    let out = support::folder("rooms").join("out.rs");
    let _ = fs::remove_file(&out);
    for (file, options, word) in [
        (small(), "", "the size of a room is missing: add --room WxH, in cells"),
        (small(), "--room 0x3", "--room needs columns and rows, such as 20x15, got 0x3"),
        (small(), "--room 2x2 --motion 8000", "a room with its apron of 502 cells"),
        (small(), "--room 2x2 --fps 3", "unknown argument --fps"),
        (odd(), "--room 2x2", "--room is for one map: the levels of a project are rooms already"),
        (odd(), "", "level 'B': it begins or ends at 40 pixels, between cells of 16"),
        (linear(), "", "level 'A' has no position: in a linear world levels have no neighbours"),
        (far(), "--room 100x100", "object 7 of layer 'L'"),
    ] {
        let ran = run(file, &out, options);
        assert!(ran.status == 2 && ran.out.is_empty() && ran.err.lines().count() == 1, "{ran:?}");
        assert!(ran.err.starts_with("tilesat rooms: ") && ran.err.contains(word), "{word:?} is not in {ran:?}");
    }
    assert!(!out.exists());
    let ran = support::run("rooms", small(), "-o out.txt");
    assert!(ran.status == 2 && ran.err.contains("does not end in .rs"), "{ran:?}");
    let help = support::run("rooms", "--help", "");
    assert!(help.status == 0 && help.out.starts_with("usage: tilesat rooms "), "{help:?}");
}

/// Warnings and notes, as `bake` has them. With several levels, each names its level.
#[test]
fn warnings_and_notes() {
    let out = support::folder("rooms").join("told.rs");
    let text = support::rows(&["##", "##"]).replace(r#"type="Solid""#, r#"type="Sollid""#).replace("World", "Walls");
    let guess = scratch("rooms", "guess.tmx", &text);
    let world =
        r#"{"type":"world","maps":[{"fileName":"guess.tmx","x":0,"y":0},{"fileName":"other.tmx","x":32,"y":0}]}"#;
    let (world, _) = (scratch("rooms", "guess.world", world), scratch("rooms", "other.tmx", text));
    for (file, options, levels) in
        [(guess, "--room 2x2", &[""][..]), (world, "", &["level 'guess': ", "level 'other': "])]
    {
        let ran = run(file, &out, options);
        assert!(ran.status == 0 && ran.err.is_empty(), "{ran:?}");
        // A name is doubtful once in all levels.
        let first = levels[0];
        let mut lines =
            vec![format!("warning {first}the name 'Sollid': it is not a word of the rules, but close to 'solid'")];
        lines.extend(
            levels.iter().map(|level| format!("note    {level}GUESS: nothing marks solid tiles, so layer 'Walls'")),
        );
        for line in lines {
            assert!(ran.out.contains(&format!("\n{line}")), "{line} {ran:?}");
        }
    }
}

/// The compiler builds from the source what was drawn.
#[test]
fn source_equals_the_worlds() {
    for (level, options, source) in [
        ("levels/quarry.tmx", "--room 12x12 --body 14 --motion 10", include_str!("baked/quarry_rooms.rs")),
        ("levels/steps.ldtk", "", include_str!("baked/steps_rooms.rs")),
    ] {
        let out = support::folder("rooms").join("own.rs");
        let ran = run(support::own(level), &out, options);
        assert!(ran.status == 0 && ran.err.is_empty(), "{ran:?}");
        let hint = "tilesat rooms examples/levels/NAME -o tools/tests/tools/baked/NAME_rooms.rs";
        assert!(fs::read_to_string(out).unwrap() == source, "write it again: {hint} {options}");
    }
    let rooms = &quarry_rooms::ROOMS;
    let count = usize::from(rooms.columns() * rooms.rows());
    assert_eq!((count, quarry_rooms::APRON, quarry_rooms::CELL), (quarry_rooms::SEGMENTS.len(), 2, 16));
    for (x, y) in (0..quarry::WIDTH).flat_map(|x| (0..quarry::HEIGHT).map(move |y| (x, y))) {
        let room = rooms.room(x / 12, y / 12).unwrap();
        let inside = Vec2::from_ints(16 * (x % 12) as i16 + 8, 16 * (y % 12) as i16 + 8);
        let kind = quarry::MAP.kind(Cell::new(x as i16, y as i16));
        assert_eq!(room.map().kind(room.map().cell_at(inside)), kind, "{x} {y}");
        // A disc in the middle of each cell.
        let segments = quarry_rooms::SEGMENTS[usize::from(y / 12 * rooms.columns() + x / 12)];
        let by = Vec2::from_ints(16 * room.first().0 as i16, 16 * room.first().1 as i16);
        let disc = |at| Circle::new(at, Fx::lit("7")).unwrap();
        let there = segments.is_some_and(|map| map.overlaps_circle(&disc(inside)));
        assert_eq!(there, quarry::SEGMENTS.overlaps_circle(&disc(inside + by)), "{x} {y}");
    }
    // Each object is in the room that holds its middle, in coordinates of the room.
    let mut found = Vec::new();
    for (index, objects) in (0..).zip(&quarry_rooms::OBJECTS) {
        let (column, row) = (index % rooms.columns(), index / rooms.columns());
        let first = rooms.room(column, row).unwrap().first();
        let (x, y) = (16 * first.0 as i16, 16 * first.1 as i16);
        for object in *objects {
            let whole = object.area.translated(Vec2::from_ints(x, y)).unwrap();
            assert!(rooms.room(column, row).unwrap().holds(object.area.centre()));
            found.push((object.name, whole));
        }
    }
    found.sort_unstable_by_key(|(name, _)| std::cmp::Reverse(*name));
    assert_eq!(found, [("start", quarry::OBJECT_START), ("exit", quarry::OBJECT_EXIT)]);
    let [steps] = &steps_rooms::ROOMS;
    assert_eq!((steps_rooms::steps::INDEX, steps_rooms::steps::TILES.len(), steps.first()), (0, 600, (0, 0)));
    assert_eq!((steps.width(), steps.height()), (24, 14));
}

/// The polygons of a tile begin where the tiles beside it end, also in a layer with an offset that
/// is no whole pixel.
#[test]
fn a_part_of_a_pixel_moves_tiles_and_polygons() {
    let ramp = r#"<tile id="1"><objectgroup><object id="1" x="0" y="0"><polygon points="0,4 16,9 16,16 0,16"/></object></objectgroup></tile>"#;
    let text = map(4, 1, "1,2,1,1", r#"<object id="1" name="spawn" type="Spawn" x="32" y="0"><point/></object>"#)
        .replace(r#"<tile id="1" type="OneWay"/>"#, ramp)
        .replace(r#"name="L" class="Solid""#, r#"name="L" offsetx="0.4""#)
        .replace(r#"name="World""#, r#"name="World" offsetx="0.4""#);
    let cut = Cut { room: Some((4, 1)), ..Cut::default() };
    let world = world(&scratch("rooms", "part.tmx", &text), &cut).unwrap();
    let map = SegmentMap::from_bytes(world.rooms[0].segments.as_ref().unwrap()).unwrap();
    let touches = |left: Fx, right: Fx| {
        let body = tilesat::Aabb::new(Vec2::new(left, Fx::from_num(10)), Vec2::new(right, Fx::from_num(12))).unwrap();
        map.overlaps(&body)
    };
    let (from, to, little) = (Fx::from_num(16), Fx::from_num(32), Fx::lit("0.125"));
    assert!(touches(from, from + little) && touches(to - little, to));
    assert!(!touches(from - little, from) && !touches(to, to + little));
    // Objects as well. The report says where the rooms begin.
    assert_eq!(world.rooms[0].objects[0].area, Some([(32 << 16, 0); 2]));
    assert!(
        world.notes.iter().any(|note| note.contains("room (0, 0) begins at (0.4, 0) of the map")),
        "{:?}",
        world.notes
    );
    // The position is that in the file, also if the output is larger.
    let ran = support::run(
        "rooms",
        scratch("rooms", "large.tmx", &text),
        &format!("--room 4x1 --scale 2 -o {}", scratch("rooms", "large.rs", "").display()),
    );
    assert!(ran.out.contains("room (0, 0) begins at (0.4, 0) of the map"), "{ran:?}");
    // Rooms of a world lie on its cells.
    scratch("rooms", "placed.tmx", text);
    let file = scratch("rooms", "placed.world", r#"{"maps":[{"fileName":"placed.tmx","x":0,"y":0}],"type":"world"}"#);
    let why = self::world(&file, &Cut::default()).unwrap_err();
    assert!(why.contains("drawn between the cells of the world: remove the offset"), "{why}");
}
