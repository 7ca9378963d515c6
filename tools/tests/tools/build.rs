//! Folders of levels for a build script.

use std::fs;
use std::path::{Path, PathBuf};

use tilesat_tools::build;

use crate::support::{folder, ldtk, map, objects, rows};

/// An empty folder for levels, and the file for their source.
fn places() -> (PathBuf, PathBuf) {
    let (levels, out) = (folder("build").join("levels"), folder("build").join("levels.rs"));
    // Removes files of an earlier run.
    let _ = (fs::remove_dir_all(&levels), fs::remove_file(&out));
    fs::create_dir_all(&levels).unwrap();
    (levels, out)
}

#[test]
fn a_module_for_each_level() {
    let (levels, out) = places();
    fs::write(levels.join("cave 1.tmx"), rows(&["#..#", "####"])).unwrap();
    fs::write(levels.join("tower.ldtk"), ldtk(&["Full"], 2, 1, "1,0")).unwrap();
    fs::write(levels.join("notes.txt"), "no level").unwrap();
    build::folder(&levels, &out).unwrap();
    let source = fs::read_to_string(&out).unwrap();
    for part in [
        "pub mod levels {",
        "pub static KINDS",
        "pub mod cave_1 {",
        "pub mod one {",
        "pub const WIDTH: u16 = 4;",
        "pub const WIDTH: u16 = 2;",
    ] {
        assert!(source.contains(part), "{part} is not in {source}");
    }
}

/// Cargo shows what was left out, and why. A level without surprises prints nothing.
#[test]
fn what_was_left_out_is_a_warning() {
    let (levels, out) = places();
    fs::write(levels.join("calm.tmx"), rows(&["#.#", "###"])).unwrap();
    assert_eq!(build::folder(&levels, &out).unwrap().warnings, [""; 0]);

    let far = r#"<object id="3" name="spawn" class="Spawn" x="9000" y="0"><point/></object>"#;
    let bag = r#"<object id="4" type="Chest" x="1" y="1" width="3" height="3"><properties>
        <property name="loot" type="class" propertytype="Loot"/></properties></object>"#;
    let slip = r#"<object id="5" type="Sollid" x="1" y="1" width="3" height="3"/>"#;
    let loose = |list: &str| map(2, 1, "1,1", list).replace(r#"name="L" class="Solid""#, r#"name="things""#);
    fs::write(levels.join("left out.tmx"), loose(&format!("{far}{bag}{slip}"))).unwrap();
    let guess = rows(&["#."]).replace(r#"<tile id="0" type="Solid"/>"#, "").replace("World", "Ground");
    fs::write(levels.join("guess.tmx"), guess).unwrap();
    let folder = build::folder(&levels, &out).unwrap();
    let parts = [
        ("guess.tmx", "GUESS: nothing marks solid tiles, so layer 'Ground' is solid because of its name"),
        ("left out.tmx", "object 3 'spawn' of layer 'things' at (9000, 0): it is outside of the domain"),
        ("left out.tmx", "the name 'Sollid': it is not a word of the rules, but close to 'solid'"),
        ("left out.tmx", "property 'loot' of object 4 of layer 'things': a class"),
    ];
    assert_eq!(folder.warnings.len(), parts.len(), "{:?}", folder.warnings);
    for (line, (file, why)) in folder.warnings.iter().zip(parts) {
        assert!(line.starts_with(&format!("{}: {why}", levels.join(file).display())), "{line}");
    }
    let text = folder.to_string();
    assert_eq!(text.lines().filter(|line| line.starts_with("cargo::warning=")).count(), parts.len(), "{text}");
    assert_eq!(text.lines().filter(|line| line.starts_with("cargo::rerun-if-changed=")).count(), 3, "{text}");

    // An author who names a level `a\ncargo::rustc-env=X=Y` gets no line of Cargo.
    let many = build::Folder { warnings: vec!["one\ncargo::rustc-env=X=Y".to_owned(); 51], ..build::Folder::default() };
    let text = many.to_string();
    assert_eq!(text.lines().count(), 51, "{text}");
    assert!(text.lines().all(|line| line.starts_with("cargo::warning=")) && text.contains("and 1 more"), "{text}");
}

/// Reports all wrong levels at once, a line each, and writes nothing.
#[test]
fn every_fault_has_its_line() {
    let (levels, out) = places();
    let of_folder = |folder: &Path| build::folder(folder, &out).unwrap_err();
    assert!(of_folder(&levels).to_string().ends_with("has no level: no file ends in .tmx, .tmj, .world, .ldtk"));
    assert!(of_folder(&levels.join("none")).to_string().starts_with("cannot read the folder "));

    fs::write(levels.join("good.tmx"), rows(&["##"])).unwrap();
    fs::write(levels.join("empty.tmx"), objects("")).unwrap();
    fs::write(levels.join("torn.ldtk"), "{").unwrap();
    let failed = of_folder(&levels);
    let lines = failed.to_string();
    assert_eq!(failed.0.len(), 2, "{lines}");
    assert_eq!(format!("{failed:?}"), format!("{lines}\nno level is written"));
    for (line, file) in lines.lines().zip(["empty.tmx: ", "torn.ldtk: "]) {
        assert!(line.contains(file), "{line}");
    }
    assert!(!out.exists());
}

/// A module hides no crate, and a name ends no line.
#[test]
fn names_that_are_in_the_way() {
    let (levels, out) = places();
    fs::write(levels.join("tilesat.tmx"), objects(r#"<object id="1" x="1" y="1" width="5" height="5"/>"#)).unwrap();
    let project = ldtk(&["Full"], 2, 1, "1,0").replace("One", "a\u{202e}b\\nc");
    fs::write(levels.join("names.ldtk"), project).unwrap();
    build::folder(&levels, &out).unwrap();
    let source = fs::read_to_string(&out).unwrap();
    assert!(source.contains("pub mod tilesat {") && source.contains("/// a?b?c\n"), "{source}");
    let bare = source.match_indices("tilesat::").filter(|(at, _)| !source[..*at].ends_with("::"));
    assert_eq!(bare.count(), 0, "{source}");
}

/// A build script has no command line: its messages name lines of `tilesat.toml`.
#[test]
fn options_are_lines_of_the_project_file() {
    let (levels, out) = places();
    let slip = map(2, 1, "1,2", "").replace("OneWay", "Sollid");
    fs::write(levels.join("slip.tmx"), slip).unwrap();
    let lines = build::folder(&levels, &out).unwrap().warnings;
    assert!(lines.len() == 1 && lines[0].ends_with(r#"write flag = ["Sollid"] in tilesat.toml"#), "{lines:?}");
    fs::write(levels.join("guess.tmx"), rows(&["##"]).replace("Solid\"/>", "\"/>").replace("World", "My Ground"))
        .unwrap();
    let lines = build::folder(&levels, &out).unwrap().warnings;
    let both = [r#"; solid-layer = ["My Ground"] in tilesat.toml confirms it"#, r#"ignore-layer = ["My Ground"] in"#];
    assert!(both.iter().all(|part| lines[0].contains(part)) && !lines[0].contains("--"), "{lines:?}");
    // So are those of a refused level beside a good one.
    fs::write(levels.join("hollow.tmx"), rows(&["#"]).replace(r#"<tile id="0" type="Solid"/>"#, "")).unwrap();
    fs::write(levels.join("good.tmx"), rows(&["#"])).unwrap();
    let why = build::folder(&levels, &out).unwrap_err().to_string();
    assert!(why.contains(r#"solid-layer = ["World"] in tilesat.toml"#) && !why.contains("--"), "{why}");
}

/// A level whose file has no Rust name gets another one, and two of one name are refused.
#[test]
fn names_of_modules() {
    let (levels, out) = places();
    fs::write(levels.join("1-1.tmx"), rows(&["##"])).unwrap();
    fs::write(levels.join("Cave 2.tmx"), rows(&["##"])).unwrap();
    fs::write(levels.join("type.tmx"), rows(&["##"])).unwrap();
    let lines = build::folder(&levels, &out).unwrap().warnings;
    let renamed = |file: &str, module: &str| {
        let file = levels.join(file);
        format!("{}: its module is levels::{module}, because", file.display())
    };
    assert!(lines.len() == 2 && lines[0].starts_with(&renamed("1-1.tmx", "level_1_1")), "{lines:?}");
    assert!(lines[1].starts_with(&renamed("type.tmx", "level_type")), "{lines:?}");

    fs::write(levels.join("1 1.tmx"), rows(&["##"])).unwrap();
    fs::remove_file(&out).unwrap();
    let failed = build::folder(&levels, &out).unwrap_err().to_string();
    let (new, old) = (levels.join("1 1.tmx"), levels.join("1-1.tmx"));
    let wanted = format!("{} and {}: both would be the module level_1_1", new.display(), old.display());
    assert!(failed.starts_with(&wanted) && failed.ends_with("rename one of them"), "{failed}");
    assert!(!out.exists());
}

/// The settings are for all levels of the folder, so a name must be that of one of them.
#[test]
fn an_ignored_level_that_no_file_has() {
    let (levels, out) = places();
    fs::write(levels.join("cave.tmx"), rows(&["#"])).unwrap();
    fs::write(levels.join("w.ldtk"), ldtk(&["Full"], 2, 1, "1,0")).unwrap();
    let with = |name: &str| {
        fs::write(levels.join("tilesat.toml"), format!("ignore-level = [\"{name}\"]")).unwrap();
        build::folder(&levels, &out).map(|_| ()).map_err(|failed| failed.to_string())
    };
    assert_eq!((with("One"), with("cave")), (Ok(()), Ok(())));
    let why = with("Nope").unwrap_err();
    assert!(why.contains("tilesat.toml: ignore-level: no level is called 'Nope'"), "{why}");
}
