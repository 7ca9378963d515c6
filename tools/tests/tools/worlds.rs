//! Worlds of Tiled: maps at positions.

use std::fs;
use std::path::PathBuf;

use tilesat_tools::model::map::Place;
use tilesat_tools::model::property::Value;
use tilesat_tools::rooms::{self, Cut};
use tilesat_tools::rules::options::Options;
use tilesat_tools::{build, read};

use crate::support::{folder, map, run};

/// A map of these rows with an object for the game, and a reference to the object of that id. The
/// hall has a second object.
fn level(rows: &[&str], refers: u32) -> String {
    let cell = |c: char| if c == '#' { "1" } else { "0" };
    let cells: Vec<&str> = rows.iter().flat_map(|row| row.chars().map(cell)).collect();
    let object = format!(
        r#"<object id="1" name="spawn" type="Spawn" x="20" y="24"><properties><property name="to" type="object" value="{refers}"/></properties><point/></object>"#
    );
    let more = if rows == HALL { r#"<object id="2" name="far" x="9" y="9"><point/></object>"# } else { "" };
    map(rows[0].len(), rows.len(), &cells.join(","), &(object + more))
        .replace(r#"name="L" class="Solid""#, r#"name="things""#)
}

const HALL: &[&str] = &["##########", "#.........", "#.........", "#...##....", "##########"];
const TOWER: &[&str] = &["#####", "....#", "....#", "....#", "##..#", "#...#", "#..##", "#####"];
const CAVE: &[&str] = &["##########", "..........", "#....#....", "##########"];

/// A world of three maps, one of them in a folder.
fn world() -> PathBuf {
    let folder = folder("worlds");
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(folder.join("deep")).unwrap();
    fs::write(folder.join("hall.tmx"), level(HALL, 1)).unwrap();
    fs::write(folder.join("tower.tmx"), level(TOWER, 2)).unwrap();
    fs::write(folder.join("deep/cave.tmx"), level(CAVE, 1)).unwrap();
    let text = r#"{"maps":[{"fileName":"hall.tmx","height":80,"width":160,"x":-160,"y":32},
        {"fileName":"tower.tmx","x":0,"y":32},{"fileName":"deep/cave.tmx","x":-160,"y":112}],
        "onlyShowAdjacentMaps":false,"type":"world"}"#;
    fs::write(folder.join("all.world"), text).unwrap();
    folder.join("all.world")
}

/// Each map is a room at its position, with its neighbours' tiles around it.
#[test]
fn maps_of_a_world_are_rooms() {
    let levels = read::load(&world(), None).unwrap();
    let names: Vec<&str> = levels.maps.iter().map(|map| map.name.as_str()).collect();
    assert_eq!((names, levels.files.len()), (vec!["hall", "tower", "cave"], 4));
    let place = Place { x: 0, y: 32, width: 80, height: 128, plane: (0, 0) };
    assert_eq!(levels.maps[1].place, Some(place));
    let world = rooms::bake(&levels.maps, &Options::default(), &Cut::default()).unwrap();
    let all = [("hall", -10, 2, HALL), ("tower", 0, 2, TOWER), ("cave", -10, 7, CAVE)];
    let solid = |x: i32, y: i32| {
        all.iter().any(|(_, left, top, rows)| {
            let row = usize::try_from(y - top).ok().and_then(|row| rows.get(row));
            let cell = row.and_then(|row| row.as_bytes().get(usize::try_from(x - left).ok()?));
            cell == Some(&b'#')
        })
    };
    let apron = i32::from(world.apron);
    for (room, (name, x, y, rows)) in world.rooms.iter().zip(all) {
        assert_eq!((room.name.as_str(), room.first), (name, (x, y)));
        assert_eq!((usize::from(room.size.0), usize::from(room.size.1)), (rows[0].len(), rows.len()));
        let side = i32::from(room.size.0) + 2 * apron;
        for (index, tile) in (0..).zip(&room.tiles) {
            let cell = (x - apron + index % side, y - apron + index / side);
            assert_eq!(*tile != 0, solid(cell.0, cell.1), "{name} {cell:?}");
        }
        // The ids are those of each map, so a reference leads nowhere else.
        let [spawn, ..] = &room.objects[..] else { panic!("{:?}", room.objects) };
        assert_eq!(room.objects.len(), if name == "hall" { 2 } else { 1 });
        let refers = &spawn.properties.0[0].1;
        assert_eq!((spawn.title.id, spawn.area.unwrap()[0]), (1, (20 << 16, 24 << 16)));
        assert_eq!(matches!(refers, Value::Object(_)), name != "tower", "{refers:?}");
    }
}

#[test]
fn one_map_of_a_world() {
    let world = world();
    let one = read::load(&world, Some("tower")).unwrap();
    assert_eq!((one.maps.len(), one.maps[0].size), (1, (5, 8)));
    let none = read::load(&world, Some("attic")).unwrap_err().to_string();
    assert!(none.ends_with("no level 'attic'; there are: hall, tower, cave"), "{none}");
    for command in ["bake", "lint"] {
        let out = world.with_file_name("out.rs");
        let options = if command == "bake" { format!("-o {}", out.display()) } else { String::new() };
        let ran = run(command, &world, &options);
        assert!(ran.status == 0 && ["hall", "tower", "cave"].iter().all(|name| ran.out.contains(name)), "{ran:?}");
    }
}

/// Two maps of one name in different folders are different levels.
#[test]
fn names_with_folders() {
    let world = world();
    fs::copy(world.with_file_name("hall.tmx"), world.with_file_name("deep").join("hall.tmx")).unwrap();
    let text = fs::read_to_string(&world).unwrap().replace("deep/cave.tmx", "deep/hall.tmx");
    fs::write(&world, text).unwrap();
    let names: Vec<String> = read::load(&world, None).unwrap().maps.into_iter().map(|map| map.name).collect();
    assert_eq!(names, ["hall", "tower", "deep/hall"]);
}

/// A build script bakes the maps of a world once.
#[test]
fn a_folder_with_a_world() {
    let world = world();
    fs::write(world.with_file_name("attic.tmx"), level(CAVE, 1)).unwrap();
    let out = world.with_file_name("out.rs");
    let folder = build::folder(world.parent().unwrap(), &out).unwrap();
    let source = fs::read_to_string(out).unwrap();
    let modules: Vec<&str> = source.lines().map(str::trim).filter(|line| line.starts_with("pub mod ")).collect();
    let wanted: Vec<String> =
        ["worlds", "hall", "tower", "cave", "attic"].iter().map(|name| format!("pub mod {name} {{")).collect();
    assert_eq!(modules.len(), wanted.len(), "{modules:?}");
    assert_eq!(modules[1..], wanted[1..]);
    assert_eq!(folder.files.len(), 5, "{:?}", folder.files);
}

#[test]
fn refused() {
    let world = world();
    let infinite = level(HALL, 1).replace(r#"infinite="0""#, r#"infinite="1""#);
    let infinite = infinite
        .replace(r#"<data encoding="csv">"#, r#"<data encoding="csv"><chunk x="-16" y="0" width="10" height="5">"#);
    fs::write(world.with_file_name("infinite.tmx"), infinite.replace("</data>", "</chunk></data>")).unwrap();
    let maps = |list: &str| format!(r#"{{"maps":[{list}],"type":"world"}}"#);
    let at = |file: &str, more: &str| maps(&format!(r#"{{"fileName":"{file}","x":0,"y":0{more}}}"#));
    let hall = r#"{"fileName":"hall.tmx","x":0,"y":0}"#;
    let pattern = |regexp: &str, more: &str| {
        format!(r#"{{"patterns":[{{"regexp":"{regexp}","multiplierX":9{more}}}],"type":"world"}}"#)
    };
    for (text, why) in [
        ("<world/>".to_owned(), "not a world of Tiled: "),
        (maps(""), "a world of Tiled without maps: add some with Tiled's World Tool"),
        (pattern("(?=h)(.)(.)", ""), "the tools do not read it"),
        (pattern("(?=h)(.)(.)", ""), r#"list each map in "maps" with fileName, x and y"#),
        (pattern("hall(.)", ""), "the pattern 'hall(.)' of the world: it needs two groups in brackets"),
        (pattern("(.)(.)", r#","multiplierY":0"#), "its multiplierX or multiplierY is 0"),
        (pattern("(h)(a)ll", ""), "in 'hall.tmx' it finds 'h', which gives no position"),
        (pattern("attic_(.)_(.)", ""), "without maps: no map beside it fits the pattern 'attic_(.)_(.)'"),
        (maps(&format!("{hall},{}", hall.replace("hall", "./hall"))), "the world lists the map './hall.tmx' twice"),
        (maps(r#"{"x":0,"y":0}"#), "a map that has no fileName"),
        (at("gone.tmx", ""), "map 'gone': "),
        (at("all.world", ""), "map 'all': "),
        (at("infinite.tmx", ""), "it is infinite, and the world does not give its width and height"),
        (
            at("infinite.tmx", r#","width":160,"height":80"#),
            "its tile in column -16, row 0 is outside of the 10x5 cells",
        ),
    ] {
        fs::write(&world, text).unwrap();
        let ran = run("bake", &world, "--json");
        assert!(ran.status == 2 && ran.err.lines().count() == 1 && ran.err.contains(why), "{why} is not in {ran:?}");
    }
    // Between the cells of the world, and over each other.
    for (x, why) in
        [(40, "level 'tower': it begins or ends at 40 pixels"), (64, "level 'hall' and level 'tower' share")]
    {
        fs::write(&world, maps(&format!(r#"{hall},{{"fileName":"tower.tmx","x":{x},"y":0}}"#))).unwrap();
        let ran = run("rooms", &world, &format!("-o {}", world.with_file_name("out.rs").display()));
        assert!(ran.status == 2 && ran.err.contains(why), "{why} is not in {ran:?}");
    }
}

/// The names of maps hold their positions.
#[test]
fn patterns() {
    let world = world();
    let home = world.parent().unwrap();
    for (column, row) in [(-1, 0), (0, 0), (0, 1)] {
        fs::write(home.join(format!("cell_{column}_{row}.tmx")), level(HALL, 1)).unwrap();
    }
    fs::write(home.join("cell_0_0.png"), "").unwrap();
    // What Tiled exports beside a map.
    fs::write(home.join("cell_0_0.json"), "{}").unwrap();
    let text = r#"{"maps":[{"fileName":"tower.tmx","x":320,"y":0}],"patterns":[
        {"regexp":"cell_(-?\\d+)_(\\d+)","multiplierX":160,"multiplierY":-80,"offsetX":16,"offsetY":32},
        {"regexp":"^c(e)?ll.*|tower()","multiplierX":1}],"type":"world"}"#;
    fs::write(&world, text).unwrap();
    let levels = read::load(&world, None).unwrap();
    let found: Vec<(&str, i32, i32, u32)> = levels
        .maps
        .iter()
        .map(|map| (map.name.as_str(), map.place.unwrap().x, map.place.unwrap().y, map.place.unwrap().width))
        .collect();
    assert_eq!(
        found,
        [("tower", 320, 0, 80), ("cell_-1_0", -144, 32, 160), ("cell_0_0", 16, 32, 160), ("cell_0_1", 16, -48, 160)]
    );
    let note = "'cell_0_0.png' fits it, and is no map";
    assert!(levels.maps[0].notes.iter().any(|line| line.contains(note)), "{:?}", levels.maps[0].notes);
    rooms::bake(&levels.maps, &Options::default(), &Cut::default()).unwrap();
}

/// The project is read once, and its damage is named once.
#[test]
fn one_project_for_all_maps() {
    let world = world();
    fs::write(world.with_file_name("game.tiled-project"), "{").unwrap();
    let levels = read::load(&world, None).unwrap();
    let notes = levels.maps.iter().flat_map(|map| &map.notes).filter(|note| note.contains("is not read"));
    assert_eq!((notes.count(), levels.files.len()), (1, 5));
}
