//! The program's output: all of it or nothing, never over an input, under names that do not
//! collide.

use std::fs;
use std::path::{Path, PathBuf};

use crate::support::{self, Ran, folder, ldtk, rows, scratch, tilesat};

fn bake(args: &[&Path]) -> Ran {
    tilesat([Path::new("bake")].iter().chain(args).copied().map(PathBuf::from))
}

/// Only these files, and nothing left over.
fn files(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

/// An empty folder.
fn clean(name: &str) -> PathBuf {
    let folder = folder(name);
    for file in fs::read_dir(&folder).unwrap() {
        let path = file.unwrap().path();
        if path.is_dir() { fs::remove_dir(path).unwrap() } else { fs::remove_file(path).unwrap() }
    }
    folder
}

const SQUARE: &str = r#"<object id="1" x="4" y="4" width="9" height="9"/></objectgroup>"#;

#[test]
fn bytes_come_with_what_they_are() {
    let home = clean("outputs");
    let level = scratch("outputs", "a.tmx", rows(&["##", "##"]).replace("</objectgroup>", SQUARE));
    let ran = bake(&[&level, Path::new("-o"), &home.join("a.bin")]);
    assert_eq!((ran.status, ran.err.as_str()), (0, ""));
    assert_eq!(files(&home), ["a.bin.rs", "a.segments.bin", "a.tiles.bin", "a.tmx"]);
    let source = fs::read_to_string(home.join("a.bin.rs")).unwrap();
    for part in ["WIDTH: u16 = 2", "include_bytes!(\"a.tiles.bin\")", "include_bytes!(\"a.segments.bin\")", "KINDS"] {
        assert!(source.contains(part), "{part}: {source}");
    }
}

#[test]
fn all_files_or_none() {
    let home = clean("none");
    let level = scratch("none", "a.tmx", rows(&["##", "##"]).replace("</objectgroup>", SQUARE));
    fs::write(home.join("a.segments.bin"), "before").unwrap();
    // One of the files cannot be written: there is a folder.
    fs::create_dir(home.join("a.bin.rs")).unwrap();
    let ran = bake(&[&level, Path::new("-o"), &home.join("a.bin")]);
    assert!(ran.status == 2 && ran.err.contains("a.bin.rs: it exists and is not a file"), "{ran:?}");
    assert_eq!(files(&home), ["a.bin.rs", "a.segments.bin", "a.tmx"]);
    assert_eq!(fs::read_to_string(home.join("a.segments.bin")).unwrap(), "before");
    // A refused level writes nothing, whatever the user asks for.
    let picture = home.join("a.png");
    let bad = scratch("none", "b.tmx", rows(&["  "]));
    let ran = bake(&[&bad, Path::new("-o"), &home.join("b.rs"), Path::new("--picture"), &picture]);
    assert!(ran.status == 2 && !picture.exists() && !home.join("b.rs").exists(), "{ran:?}");
}

#[test]
fn what_is_read_is_not_written() {
    let home = clean("inputs");
    let tileset = r#"<tileset name="t" tilewidth="16" tileheight="16" tilecount="4" columns="4"><tile id="0" type="Solid"/></tileset>"#;
    let set = scratch("inputs", "set.rs", tileset);
    let text = rows(&["##"]);
    let (from, to) = (text.find(" <tileset").unwrap(), text.find(" <layer").unwrap());
    let level = text.replace(&text[from..to], r#"<tileset firstgid="1" source="set.rs"/>"#);
    let level = scratch("inputs", "level.bin", level);
    for (option, out) in [("-o", &set), ("-o", &level), ("--picture", &level)] {
        let before = fs::read(out).unwrap();
        let ran = bake(&[&level, Path::new(option), out]);
        assert!(ran.status == 2 && ran.err.contains("it is an input of the level"), "{ran:?}");
        assert_eq!(fs::read(out).unwrap(), before);
    }
    // By another name it is the same file.
    #[cfg(unix)]
    {
        let link = home.join("link.rs");
        std::os::unix::fs::symlink(&set, &link).unwrap();
        let hard = home.join("hard.rs");
        fs::hard_link(&set, &hard).unwrap();
        for out in [link, hard] {
            let ran = bake(&[&level, Path::new("-o"), &out]);
            assert!(ran.status == 2 && ran.err.contains("is an input of"), "{ran:?}");
        }
    }
    let twice = home.join("x.rs");
    let ran = bake(&[&level, Path::new("-o"), &twice, Path::new("--picture"), &twice]);
    assert!(ran.status == 2 && ran.err.contains("it would be written twice"), "{ran:?}");
    let play = tilesat([Path::new("play"), &level, Path::new("--png"), &level]);
    assert!(play.status == 2, "{play:?}");
}

/// A link stays a link. Anything but a regular file stays unchanged.
#[cfg(unix)]
#[test]
fn links_and_devices() {
    let home = clean("links");
    let level = scratch("links", "a.tmx", rows(&["##"]));
    let real = scratch("links", "real.rs", "before");
    std::os::unix::fs::symlink(&real, home.join("link.rs")).unwrap();
    let ran = bake(&[&level, Path::new("-o"), &home.join("link.rs")]);
    assert_eq!(ran.status, 0, "{ran:?}");
    assert!(fs::symlink_metadata(home.join("link.rs")).unwrap().is_symlink());
    assert!(fs::read_to_string(real).unwrap().contains("TILES"));
    let ran = bake(&[&level, Path::new("--picture"), Path::new("/dev/null")]);
    assert!(ran.status == 2 && ran.err.contains("not a file"), "{ran:?}");
}

/// Names of levels and flags that become equal as Rust names.
#[test]
fn names_are_unique() {
    let home = clean("unique");
    let one = ldtk(&["Full", "Empty_A B", "Empty_A-B", "Empty_\u{e9}"], 4, 1, "1,2,3,4");
    let level = one.split("\"levels\":[").nth(1).unwrap().strip_suffix("]}").unwrap();
    let named = |name: &str| level.replace("\"One\"", &format!("\"{name}\""));
    let names = ["a b", "a-b", "\u{e9}", "\u{e8}", "3", "fn", "A_B"];
    let all = one.replace(level, &names.map(named).join(","));
    let project = scratch("unique", "all.ldtk", all);
    let source = home.join("all.rs");
    assert_eq!(bake(&[&project, Path::new("-o"), &source]).status, 0);
    let text = fs::read_to_string(&source).unwrap();
    let modules: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("pub mod ")).collect();
    assert_eq!(modules, ["a_b {", "a_b_2 {", "level {", "level_2 {", "level_3 {", "level_fn {", "a_b_3 {"]);
    for flag in ["FLAG_A_B: u8 = 1", "FLAG_A_B_2: u8 = 2", "FLAG__: u8 = 4"] {
        assert!(text.contains(flag), "{flag}: {text}");
    }
    // One table for all levels, before them.
    assert_eq!(text.matches("pub static KINDS").count(), 1);
    assert_eq!(bake(&[&project, Path::new("-o"), &home.join("all.bin")]).status, 0);
    assert_eq!(files(&home).iter().filter(|name| name.rsplit('.').next() == Some("bin")).count(), names.len());
}

/// The exact line that programs read.
#[test]
fn json() {
    let level = rows(&["# =", "###"]).replace(">1,0,2", ">1,3,2").replace("</objectgroup>", SQUARE);
    let level = level.replace(
        "</map>",
        r#"<objectgroup name="Spots"><object id="2" name="start"><properties><property name="to" type="int" value="7"/><property name="to" type="bool" value="true"/><property name="to" value="x"/></properties><point/></object></objectgroup></map>"#,
    );
    let ran = support::run("bake", scratch("json", "one.tmx", level), "--json");
    assert_eq!((ran.status, ran.err.as_str()), (0, ""));
    assert_eq!(
        ran.out,
        "{\"level\":\"one\",\"cell\":16,\"width\":3,\"height\":2,\"solid\":4,\"one_way\":1,\
         \"shapes\":{\"full\":4,\"one-way-up\":1},\"segments\":4,\"flags\":{\"Kill\":1},\
         \"rules\":[{\"rule\":\"a\",\"what\":\"class Solid is full\",\"tiles\":4},\
         {\"rule\":\"a\",\"what\":\"class OneWay is one-way-up\",\"tiles\":1},\
         {\"rule\":\"c\",\"what\":\"objects of layer 'L'\",\"tiles\":1}],\
         \"ignored\":[\"object 2 'start' of layer 'Spots': it is a point\"],\"unused\":[],\"warnings\":[],\"notes\":[],\
         \"objects\":[{\"id\":2,\"class\":\"\",\"name\":\"start\",\"layer\":\"Spots\",\"area\":[0.0,0.0,0.0,0.0],\
         \"points\":[],\"properties\":{\"to\":[7,true,\"x\"]}}],\"flash_bytes\":667}\n"
    );
}

/// Each line of the report about something ignored, doubtful or notable is in JSON, too.
#[test]
fn json_has_the_lines_of_the_report() {
    let text = |name: &str, value: &str| format!(r#"<property name="{name}" value="{value}"/>"#);
    let point = r#"<objectgroup id="7"><object id="1" x="4" y="4"><point/></object></objectgroup>"#;
    let game = format!(
        r#"<objectgroup name="Spots"><properties>{}</properties><object id="2" name="start" class="Sollid"><properties>{}</properties><point/></object>
        <object id="3" x="9000" y="0"><point/></object></objectgroup><imagelayer name="sky"/></map>"#,
        text("zone", "cave"),
        r#"<property name="loot" type="list"/>"#
    );
    let level = rows(&["###"]).replace("</map>", &game).replacen(
        "<tileset",
        &format!("<properties>{}</properties><tileset", text("music", "a.ogg")),
        1,
    );
    let level =
        level.replace(r#"<tile id="0" type="Solid"/>"#, &format!(r#"<tile id="0" type="Solid">{point}</tile>"#));
    let level = level.replace(r#"name="World""#, r#"name="World" visible="0""#);
    let home = clean("json");
    let file = scratch("json", "report.tmx", level);
    let report = bake(&[&file, Path::new("-o"), &home.join("out.rs")]).out;
    let ran = support::run("bake", &file, "--json");
    assert_eq!(ran.status, 0, "{ran:?}");
    let line: serde_json::Value = serde_json::from_str(&ran.out).unwrap();
    let lines = |fields: &[&str]| -> Vec<&str> {
        let all = fields.iter().flat_map(|field| line[*field].as_array().expect(field));
        all.map(|line| line.as_str().unwrap()).collect()
    };
    for (word, count, fields) in [
        ("object", 1, &["ignored"][..]),
        ("ignored", 5, &["ignored", "unused"]),
        ("warning", 2, &["warnings"]),
        ("note", 1, &["notes"]),
    ] {
        let told: Vec<&str> = report.lines().filter_map(|line| line.strip_prefix(&format!("{word:<7} "))).collect();
        assert_eq!(told.len(), count, "{report}");
        assert!(told.iter().all(|line| lines(fields).contains(line)), "{word}: {told:?} {line}");
    }
    assert_eq!(lines(&["unused"]).len(), 4, "{line}");
}

/// If the images of the tiles exist, the picture shows them.
#[test]
fn picture_of_what_was_drawn() {
    let home = clean("picture");
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 32, 32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header().unwrap().write_image_data(&[10, 200, 30].repeat(32 * 32)).unwrap();
    scratch("picture", "t.png", bytes);
    let image = r#"<image source="t.png" width="32" height="32"/><tile id="0""#;
    let level = rows(&["#  ", " = "]).replacen("<tile id=\"0\"", image, 1).replace("columns=\"4\"", "columns=\"2\"");
    let level = scratch("picture", "a.tmx", level);
    let out = home.join("a.png");
    assert_eq!(bake(&[&level, Path::new("--picture"), &out]).status, 0);
    let mut reader = png::Decoder::new(std::io::BufReader::new(fs::File::open(out).unwrap())).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    let scale = 8;
    let at = |x: usize, y: usize| &pixels[(y * scale * info.width as usize + x * scale) * 3..][..3];
    // Green shows through the solid, and is plain over one-way tiles. Elsewhere nothing is drawn.
    assert!(at(3, 5)[1] > 90 && at(3, 5)[0] > 60, "{:?}", at(3, 5));
    assert!(at(20, 27)[1] > 180 && at(20, 27)[0] < 40, "{:?}", at(20, 27));
    assert!(at(37, 5)[1] < 90, "{:?}", at(37, 5));
}

#[cfg(unix)]
#[test]
fn links_and_modes_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let home = clean("links");
    let level = scratch("links", "a.tmx", rows(&["##"]));
    let (link, out) = (home.join("link.rs"), home.join("out.rs"));
    symlink("out.rs", &link).unwrap();
    let ran = bake(&[&level, Path::new("-o"), &link]);
    assert!(ran.status == 0 && fs::symlink_metadata(&link).unwrap().is_symlink() && out.is_file(), "{ran:?}");
    fs::set_permissions(&out, fs::Permissions::from_mode(0o600)).unwrap();
    let ran = bake(&[&level, Path::new("-o"), &link]);
    assert!(ran.status == 0 && fs::symlink_metadata(&link).unwrap().is_symlink(), "{ran:?}");
    assert_eq!(fs::metadata(&out).unwrap().permissions().mode() & 0o777, 0o600);
    assert_eq!(files(&home), ["a.tmx", "link.rs", "out.rs"]);
    // A link to itself leads nowhere.
    symlink("self.rs", home.join("self.rs")).unwrap();
    assert_eq!(bake(&[&level, Path::new("-o"), &home.join("self.rs")]).status, 2);
}

/// A level without a solid has a picture, too: it must not stop the others.
#[test]
fn a_picture_of_an_empty_level() {
    let level = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/ldtk/empty_level.ldtk");
    let home = folder("outputs").join("empty");
    fs::create_dir_all(&home).unwrap();
    let ran = bake(&[&level, Path::new("--picture"), &home.join("p.png")]);
    assert_eq!(ran.status, 0, "{ran:?}");
    for name in ["p.a.png", "p.title.png"] {
        assert!(fs::read(home.join(name)).unwrap().starts_with(b"\x89PNG"), "{name}");
    }
}
