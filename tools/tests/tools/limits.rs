//! Files that could take any time or memory. Each ends in one line, at once.

use std::fs;
use std::io::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use tilesat_tools::read;
use tilesat_tools::rooms::{self, Cut};
use tilesat_tools::rules::options::Options;

use crate::support::{self, folder, rows, scratch};

/// More than any of them takes, on a busy machine and without optimisation.
const SOON: Duration = Duration::from_secs(5);

fn refused(path: PathBuf, word: &str) {
    let start = Instant::now();
    let ran = support::run("bake", path, "-o never.rs");
    assert!(start.elapsed() < SOON, "{word}: {:?}", start.elapsed());
    assert!(ran.status == 2 && ran.err.lines().count() == 1 && ran.err.contains(word), "{word:?} is not in {ran:?}");
}

#[test]
fn tilesets_and_attributes() {
    let set = |i: u32| {
        let first = 1 + i * (1 << 20);
        format!(
            r#"<tileset firstgid="{first}" name="t{i}" tilewidth="16" tileheight="16" tilecount="1048576" columns="1024"/>"#
        )
    };
    let level = rows(&["##"]);
    let many = |count: u32| level.replacen(" <layer", &((1..count).map(set).collect::<String>() + " <layer"), 1);
    let start = Instant::now();
    let ran = support::run(
        "bake",
        scratch("limits", "sets.tmx", many(500).replacen("tilecount=\"4\"", "tilecount=\"1048576\"", 1)),
        "--json",
    );
    assert!(ran.status == 0 && start.elapsed() < SOON, "{ran:?}");
    let more = level.replacen("tilecount=\"4\"", "tilecount=\"1048577\"", 1);
    refused(scratch("limits", "tiles.tmx", more), "tileset 't': more than 1048576 tiles");
    let attributes = (0..100_000).map(|i| format!(" a{i}=\"\"")).collect::<Vec<_>>().concat();
    let wide = level.replacen("<tile id=\"0\"", &format!("<tile id=\"0\"{attributes}"), 1);
    refused(scratch("limits", "attributes.tmx", wide), "<tile> has more than 500 attributes");
    let set = |i: u32| format!(r#"<tileset firstgid="{}" name="t" tilecount="1"/>"#, 4 + i);
    let sets = (1..1200).map(set).collect::<Vec<_>>().concat();
    refused(
        scratch("limits", "many.tmx", level.replacen(" <layer", &(sets + " <layer"), 1)),
        "more than 1000 tilesets",
    );
    refused(
        scratch("limits", "deep.tmx", "<map>".to_owned() + &"<group>".repeat(200_000)),
        "nested more than 100 deep",
    );
}

#[test]
fn bombs() {
    // 4 GiB of zeros.
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    let zeros = vec![0u8; 1 << 24];
    for _ in 0..256 {
        encoder.write_all(&zeros).unwrap();
    }
    let packed = STANDARD.encode(encoder.finish().unwrap());
    let map = |width: u32, height: u32| {
        let level = rows(&["#"]).replace("width=\"1\" height=\"1\"", &format!("width=\"{width}\" height=\"{height}\""));
        level.replace("encoding=\"csv\">1<", &format!("encoding=\"base64\" compression=\"zlib\">{packed}<"))
    };
    refused(scratch("limits", "bomb.tmx", map(2, 2)), "has more tiles than its 2x2 cells");
    refused(scratch("limits", "large.tmx", map(4096, 4096)), "has more tiles than its 4096x4096 cells");
    refused(scratch("limits", "vast.tmx", map(65535, 65535)), "more than 16777216 tiles");
    // Overlapping chunks, each as large as a map may be.
    let chunk = format!(r#"<chunk x="0" y="0" width="4096" height="4096">{packed}</chunk>"#);
    let level = map(2, 2).replace("infinite=\"0\"", "infinite=\"1\"").replace(&packed, &chunk.repeat(3));
    refused(scratch("limits", "chunks.tmx", level), "its chunks have more than 16777216 tiles");
}

#[test]
fn no_files() {
    let sparse = folder("limits").join("sparse.tmx");
    fs::File::create(&sparse).unwrap().set_len(4 << 30).unwrap();
    refused(sparse.clone(), "larger than 112 MiB");
    fs::remove_file(sparse).unwrap();
    refused(folder("limits"), "it is not a file");
    #[cfg(unix)]
    {
        let pipe = folder("limits").join("pipe.tmx");
        let _ = fs::remove_file(&pipe);
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        if made.is_ok_and(|made| made.success()) {
            refused(pipe.clone(), "it is not a file");
            let level = rows(&["##"]).replacen(" <layer", r#"<tileset firstgid="9" source="pipe.tmx"/> <layer"#, 1);
            refused(scratch("limits", "piped.tmx", level), "pipe.tmx: cannot read: it is not a file");
        }
        refused("/dev/zero".into(), "it is not a file");
    }
}

/// Polygons of tiles a million pixels away: no coordinate of the tools reaches so far.
#[test]
fn polygons_far_away() {
    let shape =
        r#"<objectgroup><object id="1" x="0" y="0"><polygon points="0,16 16,11 16,16"/></object></objectgroup>"#;
    let tile = format!(r#"<tile id="0">{shape}</tile>"#);
    let level = |x: i32, y: i32| {
        let chunk = format!(r#"<chunk x="{x}" y="{y}" width="1" height="1">1</chunk>"#);
        let level = rows(&["#"]).replace(">1</data>", &format!(">{chunk}</data>"));
        level.replace("infinite=\"0\"", "infinite=\"1\"").replace(r#"<tile id="0" type="Solid"/>"#, &tile)
    };
    // 999 744 pixels are the first that are refused.
    for (x, y) in [(62_484, 0), (-62_484, 0), (0, 62_484), (0, -62_484)] {
        let why = format!(
            "layer 'World': its tile in column {x}, row {y} is no shape of the library, and a million pixels from the \
             origin; --solid NAME makes tiles of a name full"
        );
        refused(scratch("limits", "far.tmx", level(x, y)), &why);
        let nearer = scratch("limits", "nearer.tmx", level(x - x.signum(), y - y.signum()));
        let ran = support::run("bake", &nearer, "--json");
        assert!(ran.status == 0 && ran.out.contains("\"segments\":3"), "{ran:?}");
        let ran = support::run("bake", scratch("limits", "full.tmx", level(x, y)), "--json --solid t:0");
        assert!(ran.status == 0 && ran.out.contains("\"solid\":1"), "{ran:?}");
    }
}

/// As many objects and tiles as a map of segments can hold.
#[test]
fn many_rectangles() {
    let object =
        |i: u32| format!(r#"<object id="{i}" x="{}" y="{}" width="31.5" height="17.25"/>"#, i % 100 * 60, i / 100 * 60);
    let list: String = (0..2000).map(object).collect();
    let start = Instant::now();
    let ran = support::run("bake", scratch("limits", "objects.tmx", support::objects(&list)), "--json");
    assert!(ran.status == 0 && ran.out.contains("\"segments\":8000"), "{ran:?}");
    println!("2000 rectangles in {:?}", start.elapsed());
}

/// A map of 4000 pixels with these objects in a solid layer.
fn wide(list: &str) -> String {
    support::objects(list)
        .replacen("width=\"1\" height=\"1\"", "width=\"250\" height=\"250\"", 1)
        .replace("<layer id=\"1\" name=\"World\" width=\"1\" height=\"1\"><data encoding=\"csv\">0</data></layer>", "")
}

/// A room with so many long polygons that larger cells than a tile's must index them, and one for
/// which no cells are large enough.
#[test]
fn cells_of_rooms() {
    let wedge = |i: u32| {
        let y = 9 * i;
        format!(r#"<object id="{i}" x="0" y="{y}"><polygon points="0,4 1900,0 1900,3"/></object>"#)
    };
    let out = scratch("limits", "wedges.rs", "");
    let room = |name: &str, list: &str| {
        support::run("rooms", scratch("limits", name, wide(list)), &format!("--room 250x250 -o {}", out.display()))
    };
    let ran = room("wedges.tmx", &(1..=400).map(wedge).collect::<String>());
    assert!(ran.status == 0 && ran.out.contains("objects in 1 rooms"), "{ran:?}");
    let wall = |i: u32| format!(r#"<object id="{i}" x="0" y="{i}"><polyline points="0,0 3999,1900"/></object>"#);
    let ran = room("walls.tmx", &(1..=2000).map(wall).collect::<String>());
    assert!(ran.status == 2 && ran.err.trim_end().ends_with("65535 segments: use smaller rooms"), "{ran:?}");
}

/// More polygons over each other than the library counts: the refusal names one of them.
#[test]
fn polygons_over_each_other() {
    let one = |i: u32| {
        let (top, bottom) = (20 + 3 * i, 2200 + 4 * i);
        format!(
            r#"<object id="{i}" x="0" y="0"><polygon points="{i},{bottom} {i},{top} 3000,{top} 3000,{bottom}"/></object>"#
        )
    };
    let file = scratch("limits", "pile.tmx", wide(&(1..=200).map(one).collect::<String>()));
    for (command, options) in [("bake", "--json"), ("rooms", "--room 250x250 -o never.rs")] {
        let ran = support::run(command, &file, options);
        let why = " of layer 'L' at (";
        let what = "): more than 127 polygons lie over each other there: make one polygon of them\n";
        assert!(ran.status == 2 && ran.err.contains(why) && ran.err.ends_with(what), "{ran:?}");
    }
}

/// Many objects of one name get different constants.
#[test]
fn one_name_for_all() {
    let object = |i: u32| format!(r#"<object id="{i}" name="coin" x="{i}" y="0"><point/></object>"#);
    let list: String = (0..3000).map(object).collect();
    let (start, out) = (Instant::now(), scratch("limits", "coins.rs", ""));
    let level = rows(&["##"]).replace("</objectgroup>", &(list + "</objectgroup>"));
    let ran = support::run("bake", scratch("limits", "coins.tmx", level), &format!("-o {}", out.display()));
    assert!(ran.status == 0 && start.elapsed() < SOON, "{:?} {ran:?}", start.elapsed());
    let source = fs::read_to_string(out).unwrap();
    for name in ["OBJECT_COIN", "OBJECT_COIN_2", "OBJECT_COIN_3000"] {
        assert!(source.contains(&format!("pub const {name}: ")), "{name}");
    }
}

/// Numbers end at a million pixels. A world of rooms has no domain that would refuse them.
#[test]
fn rooms_of_what_is_far_away() {
    let far = |name: &str, text: String, word: &str| {
        let start = Instant::now();
        let ran = support::run("rooms", scratch("limits", name, text), "--room 3x2 -o never.rs");
        assert!(start.elapsed() < SOON, "{word}: {:?}", start.elapsed());
        assert!(
            ran.status == 2 && ran.err.lines().count() == 1 && ran.err.contains(word),
            "{word:?} is not in {ran:?}"
        );
    };
    let object = |own: &str| support::map(2, 1, "1,1", &format!(r#"<object id="7" {own}/>"#));
    let of_object = "object 7: it is a million pixels away or wide: move it, or make it smaller";
    far("far_x.tmx", object(r#"x="1e300" y="0" width="8" height="8""#), of_object);
    far("far_wide.tmx", object(r#"x="0" y="0" width="1e300" height="8""#), of_object);
    let shape = |own: &str| {
        let group = format!("<objectgroup><object {own}><polygon points=\"0,0 16,0 16,16\"/></object></objectgroup>");
        support::layered(&[("Main", "0,0,0,0,1,1,1,1,0,0,0,0")], &format!(r#"<tile id="0">{group}</tile>"#), "")
    };
    let of_shape = "tile 0 of tileset 't': a collision shape is a million pixels away or wide: draw it within the tile";
    far("far_shape.tmx", shape(r#"x="0" y="-1e308""#), of_shape);
    let stamp = r#"<objectgroup name="L" class="Solid"><object id="8" gid="1" x="0" y="16" width="16" height="16"/></objectgroup></map>"#;
    let stamped = shape(r#"x="-2147483648" y="0""#).replace("1,1,1,1", "0,0,0,0").replace("</map>", stamp);
    far("far_stamp.tmx", stamped, "object 8: a collision shape of its tile 0 is a million pixels away or wide");
}

/// Thousands of rooms have a map of polygons each.
#[test]
fn maps_of_polygons_take_their_own_size() {
    let text = support::objects(r#"<object id="1" x="0" y="0" width="320" height="8"/>"#);
    let levels = read::load(&scratch("limits", "long.tmx", text), None).unwrap();
    let cut = Cut { room: Some((2, 2)), ..Cut::default() };
    let world = rooms::bake(&levels.maps, &Options::default(), &cut).unwrap();
    let segments: Vec<&Vec<u8>> = world.rooms.iter().filter_map(|room| room.segments.as_ref()).collect();
    assert!(segments.len() > 9 && segments.iter().all(|bytes| bytes.capacity() < 2 * bytes.len()), "{segments:?}");
}
