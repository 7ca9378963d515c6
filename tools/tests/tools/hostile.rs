//! Harmful files, on purpose or by accident. The platformer refuses them with one line, quickly and
//! in little memory.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};
use tilesat_tools::play;

use crate::support::{self, Ran, own, scratch};

fn file(name: &str, text: &str) -> PathBuf {
    scratch("hostile", &format!("{name}.tmx"), text)
}

fn run(args: &[&Path]) -> Ran {
    support::tilesat([Path::new("play")].iter().chain(args))
}

/// The reason that a map is refused.
fn refused(name: &str, text: &str) -> String {
    let why = support::level(&file(name, text)).unwrap_err().to_string();
    assert!(!why.contains(char::is_control), "{why:?}");
    why
}

/// A map of one layer. `data` is the layer's data element, and `head` precedes the map.
fn map(head: &str, width: u32, height: u32, data: &str) -> String {
    format!(
        r#"{head}<map version="1.10" orientation="orthogonal" width="{width}" height="{height}" tilewidth="1" tileheight="1" infinite="0">
 <tileset firstgid="1" name="t" tilewidth="1" tileheight="1" tilecount="3" columns="3">
  <tile id="0" type="Solid"/><tile id="1"><properties><property name="npp" type="int" value="9"/></properties></tile>
 </tileset>
 <layer id="1" name="World" width="{width}" height="{height}">{data}</layer>
</map>"#
    )
}

fn zlib(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// [`gids`] as zstd 1.5.7 packs them: as a stream of level 3, at once with a checksum, and at once
/// of level 19 with a checksum.
const ZSTD: [&str; 3] = [
    "KLUv/QBY5QYAEogGghIwv/nNb37zm9/85je/+c1vfvOb3/zmCFGBOKhx+gHxSwcRQAQIgSNknfAEElx4QWIdKwyTIkXxKg6SxXQzJkWK4lUcJIvpMlaK\
     FMWrOEgW02VMiiqKV3GQLKbLmBQpKq/iIFlMlzEpUhSvxkGymC5jUqQoXsVBZTFdxqRIUbyKg2RxuoxJkaJ4FQfJYrockyJF8SoOksV0GZNFiuJVHC\
     SL6TImRRrFqzhIFtNlTIoUxVdxkCymy5gUKYpX8SBZTJcxKVIUr+IguZguQ9mWzm2eJdAqqHK7Cg==",
    "KLUv/WTAEVUCAGgBAAIAAQACAQIDAAIAIyCgI7UYxXDTAwQ4QCCDBSCk8AKFD16g8IXugq8WLt4Q2DKUBRcO2IjEhPdc5GD0PSsQ0HD/hhZj2GNY26cC\
     gA==",
    "KLUv/WTAET0BANLCAoIxIB19vi/2R/yLCiCwc4wDiXHTg1pbaqX2Ul1KpjSv28jrWNunAoA=",
];

fn zstd(number: usize) -> Vec<u8> {
    STANDARD.decode(ZSTD[number]).unwrap()
}

/// A frame of zstd by hand: its window of 2^`log` bytes, and blocks of a type, a size and some
/// bytes.
fn zstd_frame(log: u8, blocks: &[(u32, usize, &[u8])]) -> Vec<u8> {
    let mut bytes = vec![0x28, 0xb5, 0x2f, 0xfd, 0, (log - 10) << 3];
    for (i, (kind, size, content)) in blocks.iter().enumerate() {
        let header = u32::from(i + 1 == blocks.len()) | kind << 1 | (*size as u32) << 3;
        bytes.extend_from_slice(&header.to_le_bytes()[..3]);
        bytes.extend_from_slice(content);
    }
    bytes
}

/// 128 KiB of zeros, as one repeated byte.
const ZEROS: (u32, usize, &[u8]) = (1, 1 << 17, &[0]);

/// Uncompressed bytes.
fn raw(bytes: &[u8]) -> Vec<u8> {
    zstd_frame(17, &[(0, bytes.len(), bytes)])
}

fn data(compression: &str, bytes: &[u8]) -> String {
    let text = STANDARD.encode(bytes);
    let compression = if compression.is_empty() { String::new() } else { format!(" compression=\"{compression}\"") };
    format!("<data encoding=\"base64\"{compression}>\n  {text}\n</data>")
}

/// 40 x 30 tiles of which some are solid.
fn gids() -> Vec<u32> {
    (0..1200).map(|i| u32::from(i % 7 == 0) + 2 * u32::from(i % 11 == 5)).collect()
}

fn tags() -> String {
    gids().iter().map(|gid| format!("<tile gid=\"{gid}\"/>")).collect::<Vec<_>>().concat()
}

#[test]
fn every_encoding_gives_the_same_level() {
    let gids = gids();
    let bytes: Vec<u8> = gids.iter().flat_map(|gid| gid.to_le_bytes()).collect();
    let csv = gids.iter().map(u32::to_string).collect::<Vec<_>>().join(",");
    let tags = tags();
    let level = |name: &str, data: &str| support::level(&file(name, &map("", 40, 30, data))).unwrap();
    let expected = level("csv", &format!("<data encoding=\"csv\">{csv}</data>"));
    assert!(expected.tiles.iter().any(|&id| id != 0));
    for (name, data) in [
        ("tags", format!("<data>{tags}</data>")),
        ("plain", data("", &bytes)),
        ("zlib", data("zlib", &zlib(&bytes))),
        ("gzip", data("gzip", &gzip(&bytes))),
        ("zstd_stream", data("zstd", &zstd(0))),
        ("zstd_fast", data("zstd", &zstd(1))),
        ("zstd_slow", data("zstd", &zstd(2))),
        ("zstd_frames", data("zstd", &[raw(&bytes[..999]), raw(&bytes[999..])].concat())),
        ("cdata", format!("<data encoding=\"csv\"><![CDATA[{csv}]]></data>")),
        ("comment", format!("<data encoding=\"csv\"><!-- <data> -->{csv}<!-- ' --></data>")),
    ] {
        assert_eq!(level(name, &data), expected, "{name}");
    }
}

/// 64 MiB of zeros in some kilobytes. It unpacks no more than the layer has tiles, and a layer
/// cannot claim any number.
#[test]
fn layers_unpack_to_no_more_than_their_size() {
    let zeros = vec![0u8; 64 << 20];
    let bombs = [
        ("zlib", zlib(&zeros)),
        ("gzip", gzip(&zeros)),
        ("zstd", zstd_frame(17, &[ZEROS; 512])),
        ("", zeros[..1 << 20].to_vec()),
    ];
    for (compression, bytes) in &bombs {
        // The end is missing, which is visible only after unpacking everything.
        let data = data(compression, &bytes[..bytes.len() - 40]);
        let why = refused("bomb", &map("", 40, 30, &data));
        assert!(why.contains("has more tiles than its 40x30 cells"), "{compression}: {why}");
        let why = refused("bomb", &map("", 4097, 4096, &data));
        assert!(why.contains("more than 16777216 tiles"), "{compression}: {why}");
    }
    // Many layers, each of the greatest size.
    let one = map("", 4096, 4096, &data("zlib", &zlib(&zeros)));
    let layer = &one[one.find("<layer").unwrap()..one.find("</map>").unwrap()];
    let why = refused("many", &one.replace("</map>", &format!("{layer}</map>")));
    assert!(why.contains("more than 16777216 tiles"), "{why}");
    let csv = format!("<data encoding=\"csv\">{}0</data>", "0,".repeat(1 << 20));
    assert!(refused("csv_bomb", &map("", 40, 30, &csv)).contains("more tiles than"));
}

#[test]
fn tricks_with_markup() {
    let good = "<data encoding=\"csv\">1,0,0,1</data>";
    let small = map("", 2, 2, good);
    let zip = data("zlib", &zlib(&vec![0u8; 1 << 24]));
    let mut zstd_sum = zstd(1);
    *zstd_sum.last_mut().unwrap() ^= 1;
    let cases = [
        ("prefix", small.replace("<data ", "<x:data ").replace("</data", "</x:data"), "it has no data"),
        ("key", small.replace("tilecount=", "x:tilecount=\"4000000000\" tilecount="), ""),
        ("unknown", small.replace("csv\">", "base64\" compression=\"z&#108;ib\">"), "cannot unpack"),
        ("encoding", small.replace("\"csv\"", "\"hex\""), "encoding 'hex'"),
        ("not_base64", small.replace("\"csv\"", "\"base64\""), "cannot unpack"),
        ("cut_zip", small.replace(good, &data("zlib", &zlib(b"12345678")[..9])), "cannot unpack"),
        ("no_zip", small.replace(good, &data("gzip", b"12345678")), "cannot unpack"),
        ("no_zstd", small.replace(good, &data("zstd", b"12345678")), "cannot unpack"),
        ("cut_zstd", small.replace(good, &data("zstd", &zstd(0)[..200])), "cannot unpack"),
        ("zstd_sum", small.replace(good, &data("zstd", &zstd_sum)), "the checksum of the zstd data is wrong"),
        ("zstd_window", small.replace(good, &data("zstd", &zstd_frame(27, &[ZEROS]))), "window_size is too big"),
        ("in_doctype", map(&format!("<!DOCTYPE m [ <!ENTITY d '{zip}'> ]>"), 2, 2, "&d;"), ""),
        ("sides", small.replace("<layer id=\"1\" name=\"World\" width=\"2\"", "<layer width=\"-1\""), "<layer> has width=\"-1\""),
        (
            "chunk",
            small.replace("infinite=\"0\"", "infinite=\"1\"").replace(
                good,
                "<data encoding=\"csv\"><chunk x=\"-2147483648\" y=\"0\" width=\"4000000000\" height=\"9\">1</chunk></data>",
            ),
            "its chunks have more than 16777216 tiles",
        ),
        ("tile_ids", small.replace("id=\"0\"", "id=\"4294967295\""), ""),
    ];
    for (name, text, word) in cases {
        match support::level(&file(name, &text)) {
            Err(why) => assert!(why.to_string().contains(word), "{name}: {why}"),
            Ok(_) => assert!(word.is_empty(), "{name} was read"),
        }
    }
    // A trick that hides a tag from one reader must not show it to the other.
    for hidden in [format!("<?a ' ?>{zip}<?b ' ?>"), format!("<!-- {zip} -->"), format!("<![CDATA[{zip}]]>")] {
        let loaded = support::level(&file("hidden", &small.replace(good, &(hidden + good))));
        assert!(loaded.is_err() || loaded.unwrap().tiles.len() == 4);
    }
}

/// Names in a file cannot reach the terminal as escape codes, further lines or text that runs
/// backward.
#[test]
fn names_are_printed_on_one_line() {
    let name = "A&#27;[31m&#10;frames=1 hash=0&#x202e;\u{200b}".to_owned() + &"x".repeat(5000);
    let csv = format!("<data encoding=\"csv\">{}</data>", vec!["1,0"; 200].join(","));
    let text = map("", 20, 20, &csv).replace("name=\"World\"", &format!("name=\"{name}\""));
    let text = text
        .replace("type=\"Solid\"", "type=\"Solid\" ")
        .replace("<tile id=\"1\">", "<tile id=\"1\" type=\"K&#27;&#13;Z\"/><tile id=\"2\">");
    let text = text.replacen("1,0,1,0", "1,2,1,0", 1);
    let path = file("names", &text);
    let (png, svg) = (scratch("hostile", "names.png", ""), scratch("hostile", "names.svg", ""));
    let flags = [Path::new("--frames"), Path::new("5"), Path::new("--png"), &png, Path::new("--svg"), &svg];
    let Ran { status, out, err } = run(&[&[path.as_path()], &flags[..]].concat());
    assert_eq!((status, err.as_str()), (0, ""), "{out}");
    let lines: Vec<&str> = out.lines().collect();
    assert_eq!(lines.len(), 7, "{out}");
    assert!(lines[1].starts_with("layer   A?[31m?frames=1 hash=0??xxx") && lines[1].len() < 1100, "{}", lines[1]);
    assert!(lines[2].contains("K??Z = bit 0"), "{}", lines[2]);
    for line in lines {
        assert!(!line.contains(|c: char| c.is_control() || c == '\u{202e}' || c == '\u{200b}'), "{line:?}");
    }
    let drawn = fs::read_to_string(svg).unwrap();
    assert!(!drawn.contains(|c: char| c != '\n' && c.is_control()), "the SVG has control characters");
    let missing = [path.as_path(), Path::new("--layer"), Path::new("B")];
    let Ran { status, err, .. } = run(&missing);
    assert!(status == 2 && err.lines().count() == 1 && !err.trim_end().contains(char::is_control), "{err:?}");
}

/// The largest possible level, a pixel per tile, every second one solid. Its pictures stay small.
#[test]
fn pictures_of_the_largest_level() {
    let bytes: Vec<u8> = (0..2048u32 * 2048).flat_map(|i| u32::to_le_bytes((i ^ i >> 11) & 1)).collect();
    let path = file("largest", &map("", 2048, 2048, &data("zlib", &zlib(&bytes))));
    let (png, svg) = (scratch("hostile", "largest.png", ""), scratch("hostile", "largest.svg", ""));
    let flags = [Path::new("--frames"), Path::new("1"), Path::new("--png"), &png, Path::new("--svg"), &svg];
    let Ran { status, out, err } = run(&[&[path.as_path()], &flags[..]].concat());
    assert_eq!((status, err.as_str()), (0, ""), "{out}");
    assert!(fs::metadata(svg).unwrap().len() < 16 << 20 && fs::metadata(png).unwrap().len() < 16 << 20);
}

/// A small generator with fixed numbers.
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % n.max(1) as u64) as usize
    }
}

/// Words that maps are made of, and numbers at their limits.
const WORDS: [&str; 24] = [
    "<layer ",
    "</layer>",
    "<data>",
    "</data>",
    "<tile gid=\"1\"/>",
    "<chunk>",
    "<group>",
    "<map",
    "\"",
    "'",
    ">",
    "/>",
    "<!--",
    "-->",
    "<![CDATA[",
    "]]>",
    "<?",
    "4294967295",
    "-1",
    "0",
    "2147483648",
    "npp",
    "shape",
    "&#0;",
];

/// One to four small changes.
fn mutate(text: &[u8], dice: &mut Dice) -> Vec<u8> {
    let mut text = text.to_vec();
    for _ in 0..=dice.below(4) {
        let (at, length) = (dice.below(text.len()), dice.below(40));
        let end = (at + length).min(text.len());
        match dice.below(12) {
            // Digits become other digits: a file that is still well-formed gets further.
            0..6 => text
                .iter_mut()
                .skip(at)
                .find(|b| b.is_ascii_digit())
                .into_iter()
                .for_each(|b| *b = b'0' + dice.below(10) as u8),
            6 => text.get_mut(at).into_iter().for_each(|b| *b = dice.below(256) as u8),
            7 => drop(text.drain(at..end)),
            8 => {
                let copy = text[at..end].to_vec();
                let to = dice.below(text.len());
                drop(text.splice(to..to, copy));
            }
            9 | 10 => {
                let word = WORDS[dice.below(WORDS.len())].as_bytes().to_vec();
                drop(text.splice(at..end.min(at + word.len()), word));
            }
            _ => text.truncate(text.len() - dice.below(text.len() / 8)),
        }
    }
    text
}

/// Every file is a level, or is refused with one line. Levels play.
#[test]
fn mutated_files() {
    let cases = std::env::var("TILESAT_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(400);
    let bytes: Vec<u8> = gids().iter().flat_map(|gid| gid.to_le_bytes()).collect();
    let csv = gids().iter().map(u32::to_string).collect::<Vec<_>>().join(",");
    let tags = tags();
    let seeds = [
        map("<?xml version=\"1.0\"?>", 40, 30, &data("zlib", &zlib(&bytes))),
        map("", 40, 30, &data("zstd", &zstd(2))),
        map("", 40, 30, &format!("<data encoding=\"csv\">{csv}</data>")),
        map("", 40, 30, &format!("<data>{tags}</data>")),
        fs::read_to_string(own("platformer/levels/ninja.tsx")).unwrap(),
    ];
    let outer = map("", 40, 30, &format!("<data encoding=\"csv\">{csv}</data>"));
    let inner = &outer[outer.find("<tileset").unwrap()..outer.find("<layer").unwrap()];
    let outer = file("outer", &outer.replace(inner, "<tileset firstgid=\"1\" source=\"mutant.tsx\"/>"));
    let (mut dice, mut read, mut played) = (Dice(7), 0, 0);
    for case in 0..cases {
        let seed = case % seeds.len();
        let text = mutate(seeds[seed].as_bytes(), &mut dice);
        let tileset = seed == 4;
        let path = scratch("hostile", if tileset { "mutant.tsx" } else { "mutant.tmx" }, &text);
        let level = support::level(if tileset { &outer } else { &path });
        let result = level.and_then(|level| {
            read += 1;
            play::play(&level.into(), 2, 1, &mut std::io::sink())
        });
        match result {
            Ok(run) => {
                played += 1;
                assert_eq!((run.overlaps, run.escaped, run.refused), (0, 0, 0), "case {case}");
            }
            Err(why) => assert!(!why.to_string().contains(char::is_control), "case {case}: {why}"),
        }
    }
    println!("{cases} files, {read} levels, {played} played");
    assert!(cases < 100 || (played > cases / 20 && read < cases));
}
