//! Data from outside: bytes of segment maps, and levels of Tiled and of `LDtk`. The readers refuse
//! them in one line, or accept them, and then every query works.

use crate::accepted;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use tilesat::{AllShapes, Fx, Inside, SegmentMap, TileMap, Vec2};
use tilesat_judge::Random;
use tilesat_judge::segments::build;
use tilesat_judge::segments::hostile;
use tilesat_tools::bake::level::Level;
use tilesat_tools::bake::segments::Shapes;
use tilesat_tools::cli;
use tilesat_tools::read::load;
use tilesat_tools::rules::flags::Flags;
use tilesat_tools::rules::ground::Ground;
use tilesat_tools::rules::options::Options;

/// The bytes themselves, or a level that was built and then damaged as the input says, with a
/// corrected checksum.
pub(crate) fn segment_bytes(data: &[u8]) {
    let mut r = Random::steered(data);
    let scene = build::scene(&mut r);
    let mut bytes = match r.below(4) {
        0 => data[1.min(data.len())..].to_vec(),
        1 => match hostile::twisted(&mut r, scene.bytes()) {
            Some(bytes) => bytes,
            None => return,
        },
        _ => scene.bytes(),
    };
    while Random::is_left() && !bytes.is_empty() {
        let at = r.below(bytes.len() as i64) as usize;
        match r.below(8) {
            0 => bytes[at] ^= 1 << r.below(8),
            1 => bytes[at] = r.below(256) as u8,
            2 => bytes.truncate(at),
            3 => {
                let copy = bytes[at];
                bytes.insert(at, copy);
            }
            // Damages the end: the winding numbers, or the last byte is missing.
            4 => {
                let last = bytes.len() - 1 - at % 8 % bytes.len();
                bytes[last] = bytes[last].wrapping_add(r.around(1) as u8);
            }
            5 => drop(bytes.pop()),
            _ => wound(&mut r, &mut bytes, at),
        }
    }
    if bytes.len() >= 32 && !r.one_in(8) {
        hostile::checksum(&mut bytes);
    }
    let Ok(map) = SegmentMap::from_bytes(&bytes) else {
        assert_ne!(bytes, scene.bytes(), "what was built is refused");
        return;
    };
    accepted::check(&bytes);
    let again = SegmentMap::from_bytes(&bytes).expect("taken before");
    assert_eq!((map.count(), map.grid()), (again.count(), again.grid()));
    hostile::ask(&scene, &map, &mut r);
}

/// Changes one field of a segment slightly, or swaps two neighbouring references.
fn wound(r: &mut Random, bytes: &mut [u8], at: usize) {
    let half = |at: usize| Some(usize::from(u16::from_le_bytes([*bytes.get(at)?, *bytes.get(at + 1)?])));
    let (Some(count), Some(width), Some(height)) = (half(6), half(20), half(22)) else { return };
    let (segment, field) = (32 + 24 * (at % count.max(1)), [0, 4, 8, 12, 16, 20][r.below(6) as usize]);
    if r.one_in(4) {
        let refs = 32 + 24 * count + 2 * (width * height + 1);
        let last = bytes.len().saturating_sub(width * height + 4);
        let from = refs + 2 * (at % (last.saturating_sub(refs) / 2).max(1));
        if let Some(two) = bytes.get_mut(from..from + 4) {
            two.rotate_left(2);
        }
    } else if let Some(len) = bytes.get_mut(segment + 16..segment + 20).filter(|_| field == 16 && r.one_in(2)) {
        len.fill(0);
    } else if let Some(low) = bytes.get_mut(segment + field) {
        *low = low.wrapping_add(r.around(2) as u8);
    }
}

/// Numbers that such files should not hold.
const ODD: [&str; 16] = [
    "-1",
    "0",
    "1",
    "16",
    "65535",
    "65536",
    "4294967296",
    "-9223372036854775808",
    "1e308",
    "nan",
    "0.00001",
    "8191.99999",
    "8192",
    "257",
    "4096",
    "",
];

fn number(r: &mut Random) -> String {
    match r.below(6) {
        0 => ODD[r.below(ODD.len() as i64) as usize].to_owned(),
        1 => format!("{}.{}", r.around(300), r.below(1000)),
        _ => r.below(160).to_string(),
    }
}

fn list(r: &mut Random, count: i64, separator: &str, mut item: impl FnMut(&mut Random) -> String) -> String {
    let items: Vec<_> = (0..count).map(|_| item(r)).collect();
    items.join(separator)
}

const CLASSES: [&str; 8] = ["Solid", "OneWay", "Wall", "Hole", "Kill", "SlopeTopLeft", "Ladder", ""];

/// Cells of a layer. With large cells a long row exceeds the domain.
fn size(r: &mut Random) -> (i64, i64) {
    let (w, h) = (r.within(0, 6), r.within(0, 6));
    if h < 6 { (w, h) } else { (7 * w, 1) }
}

/// The text of a level, and whether it lists more or fewer tiles than the layer has.
type Made = (String, bool);

fn tmx_text(r: &mut Random) -> Made {
    let (w, h) = size(r);
    let wrong = if r.one_in(8) { r.around(2) } else { 0 };
    let flips = ["", "", "", "2147483648", "1073741824", "536870912"];
    let tiles = list(r, (w * h + wrong).max(0), ",", |r| match flips[r.below(6) as usize] {
        "" => r.below(7).to_string(),
        flip => (flip.parse::<u64>().expect("a flag") + r.below(7) as u64).to_string(),
    });
    let classes = list(r, 6, "", |r| {
        let class = CLASSES[r.below(8) as usize];
        let id = r.below(6);
        format!(r#"<tile id="{id}" type="{class}"/>"#)
    });
    let objects = r.below(4);
    let objects = list(r, objects, "", |r| {
        let class = CLASSES[r.below(8) as usize];
        let (x, y, turn) = (number(r), number(r), number(r));
        let points = r.within(0, 6);
        let points = list(r, points, " ", |r| format!("{},{}", number(r), number(r)));
        let inner = match r.below(6) {
            0 => "<ellipse/>".to_owned(),
            1 => "<point/>".to_owned(),
            2 => format!(r#"<polyline points="{points}"/>"#),
            3 | 4 => format!(r#"<polygon points="{points}"/>"#),
            _ => String::new(),
        };
        let turn = if r.one_in(4) { format!(r#" rotation="{turn}""#) } else { String::new() };
        let (width, height) = (number(r), number(r));
        format!(
            r#"<object id="1" class="{class}" x="{x}" y="{y}" width="{width}" height="{height}"{turn}>{inner}</object>"#
        )
    });
    let tile = match r.below(6) {
        0 => number(r),
        1 => "256".to_owned(),
        _ => "16".to_owned(),
    };
    // Readers see an empty list as one item.
    let miscounts = (w * h + wrong).max(1) != (w * h).max(1);
    let text = format!(
        r#"<?xml version="1.0" encoding="UTF-8"?>
<map version="1.10" orientation="orthogonal" width="{w}" height="{h}" tilewidth="{tile}" tileheight="{tile}" infinite="0">
 <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="6" columns="6">{classes}</tileset>
 <layer id="1" name="World" width="{w}" height="{h}"><data encoding="csv">{tiles}</data></layer>
 <objectgroup id="2" name="L">{objects}</objectgroup>
</map>"#
    );
    (text, miscounts)
}

fn ldtk_text(r: &mut Random) -> Made {
    let (w, h) = size(r);
    let wrong = if r.one_in(8) { r.around(2) } else { 0 };
    let csv = list(r, (w * h + wrong).max(0), ",", |r| {
        if r.one_in(if w > 6 { 250 } else { 20 }) { number(r) } else { r.below(6).to_string() }
    });
    let names = ["Full", "SlopeTopLeft_Ice", "Empty_Coin", "OneWayUp", "slope_top_left", "Half_Top", "Nothing", ""];
    let mut value = 0;
    let values = list(r, 5, ",", |r| {
        value += 1;
        format!(r#"{{"value":{value},"identifier":"{}"}}"#, names[r.below(8) as usize])
    });
    let (grid, offset) = match r.below(6) {
        0 => (number(r), number(r)),
        1 => ("256".to_owned(), "0".to_owned()),
        2 => (number(r), "0".to_owned()),
        _ => ("16".to_owned(), "0".to_owned()),
    };
    let text = format!(
        r#"{{"defs":{{"layers":[{{"uid":2,"intGridValues":[{values}]}}]}},"levels":[{{"identifier":"One","layerInstances":[{{"__type":"IntGrid","__identifier":"Solid","__cWid":{w},"__cHei":{h},"__gridSize":{grid},"__pxTotalOffsetX":{offset},"__pxTotalOffsetY":0,"layerDefUid":2,"intGridCsv":[{csv}]}}]}}]}}"#
    );
    (text, (w * h + wrong).max(0) != w * h)
}

/// A file for this process and thread.
fn scratch(content: &[u8]) -> PathBuf {
    let name = format!("tilesat-fuzz-{}-{:?}.level", std::process::id(), std::thread::current().id());
    let path = std::env::temp_dir().join(name);
    fs::write(&path, content).expect("a folder for temporary files");
    path
}

/// Generated text, damaged as the input says, or the input itself. Also returns whether the readers
/// must refuse it.
fn file(data: &[u8], made: fn(&mut Random) -> Made) -> (PathBuf, bool) {
    let mut r = Random::steered(data);
    if r.one_in(8) {
        return (scratch(&data[1.min(data.len())..]), false);
    }
    let (text, miscounts) = made(&mut r);
    let mut bytes = text.into_bytes();
    let wounds = if r.one_in(3) { r.below(4) } else { 0 };
    for _ in 0..wounds {
        let at = r.below(bytes.len() as i64) as usize;
        let to = (at + r.below(24) as usize).min(bytes.len());
        match r.below(4) {
            0 => drop(bytes.drain(at..to)),
            1 => {
                let copy = bytes[at..to].to_vec();
                bytes.splice(at..at, copy);
            }
            2 => bytes[at] = r.below(256) as u8,
            _ => drop(bytes.splice(at..to, number(&mut r).into_bytes())),
        }
        if bytes.is_empty() {
            break;
        }
    }
    (scratch(&bytes), miscounts && wounds == 0)
}

pub(crate) fn tmx(data: &[u8]) {
    read(&file(data, tmx_text));
}

pub(crate) fn ldtk(data: &[u8]) {
    read(&file(data, ldtk_text));
}

fn lint_says(path: &Path) -> (u8, Vec<u8>, Vec<u8>) {
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let args = ["lint".as_ref(), path.as_os_str(), "--body".as_ref(), "10x14".as_ref()];
    let status = cli::run(args.map(OsString::from), &mut out, &mut err);
    (status, out, err)
}

/// Both tools refuse it in one line, or the library accepts the level.
fn read((path, refused): &(PathBuf, bool)) {
    let told = lint_says(path);
    let (status, _, err) = &told;
    let lines = String::from_utf8_lossy(err).lines().count();
    assert!(*status <= 2 && (*status == 2) == (lines == 1), "{told:?}");
    assert_eq!(lint_says(path), told, "twice");
    let loaded = load(path, None);
    assert!(!refused || loaded.is_err(), "a wrong number of tiles is taken");
    // If one tool cannot read it, neither can the other.
    assert!(loaded.is_ok() || *status == 2, "{told:?}");
    let Ok(levels) = loaded else { return };
    let mut flags = Flags::default();
    let Some(Ok(ground)) = levels.maps.first().map(|map| Ground::of(map, &Options::default(), &mut flags)) else {
        return;
    };
    if let Ok(Some(level)) = Level::of(&ground, &flags.names) {
        let kinds = level.kinds();
        assert_eq!(level.tiles.len(), usize::from(level.width) * usize::from(level.height));
        assert!(level.tiles.iter().all(|id| usize::from(*id) < level.ids.len()));
        if !level.tiles.is_empty() {
            let grid = level.grid().expect("what was read is in the domain");
            let map = TileMap::<AllShapes>::of(&level.tiles, grid, &kinds).expect("what was read fits the table");
            let end = grid.end();
            let _ = map.cast_ray(Vec2::ZERO, end, Inside::Hit).expect("inside the domain");
        }
    }
    if let Ok(shapes) = Shapes::of(&ground.outlines, &mut flags)
        && let Ok(bytes) = shapes.build(&ground.outlines, Fx::from_num(16))
    {
        let map = SegmentMap::from_bytes(&bytes).expect("what was built is taken");
        let end = Vec2::from_raw(1 << 24, 1 << 24);
        let hits = map.cast_ray_all(Vec2::ZERO, end, Inside::Hit).expect("inside the domain").count();
        assert!(hits <= 1 + usize::from(map.count()));
    }
}
