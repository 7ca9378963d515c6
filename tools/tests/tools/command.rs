//! The program `tilesat` itself, and the subcommands without a separate file here.

use std::ffi::OsString;
use std::fs;
use std::io::{self, ErrorKind, Write};

use tilesat_tools::cli;

use crate::support::{Ran, folder, ldtk, map, own, rows, run, scratch, tilesat};

/// A refusal: status 2 and one line that contains the word.
fn refused(ran: &Ran, word: &str) {
    assert!(ran.status == 2 && ran.out.is_empty() && ran.err.lines().count() == 1, "{ran:?}");
    assert!(ran.err.starts_with("tilesat") && ran.err.contains(word), "{word:?} is not in {ran:?}");
}

/// `play` calls its picture as `bake` does, too.
#[test]
fn play_writes_a_picture() {
    let level = scratch("command", "picture.tmx", rows(&["#    #", "#    #", "######"]));
    let out = folder("command").join("picture.png");
    let _ = fs::remove_file(&out);
    let ran = run("play", level, &format!("--frames 9 --picture {}", out.display()));
    assert!(ran.status == 0 && out.is_file(), "{ran:?}");
}

#[test]
fn commands() {
    refused(&tilesat([""; 0]), "no command given");
    refused(&tilesat(["bace"]), "no command is called bace; there are: bake, rooms, lint, play, sheet");
    refused(&tilesat(["--fps"]), "no command is called --fps");
    for help in ["--help", "-h"] {
        for args in [&[][..], &["bake"], &["lint"], &["play"], &["sheet"]] {
            let ran = tilesat(args.iter().chain([&help]));
            assert!(ran.status == 0 && ran.err.is_empty() && ran.out.starts_with("usage: tilesat"), "{ran:?}");
            assert!(!ran.out.lines().any(|line| line.starts_with('-')), "options are indented: {}", ran.out);
        }
    }
}

/// The rules are long, so no command repeats them.
#[test]
fn rules_are_printed_once() {
    let rules = tilesat(["help", "rules"]);
    let own = "A tile is solid by the first of these rules";
    assert!(rules.status == 0 && rules.err.is_empty() && rules.out.starts_with(own), "{rules:?}");
    for line in rules.out.lines() {
        assert!(line.len() <= 91 && !line.starts_with('-'), "{line}");
    }
    for command in ["bake", "lint", "play", "rooms", "sheet"] {
        let (by_option, by_topic) = (tilesat([command, "--help"]), tilesat(["help", command]));
        assert!(by_topic.status == 0 && by_topic.out == by_option.out, "{by_topic:?}");
        assert!(!by_topic.out.contains(own), "{by_topic:?}");
        assert!(command == "sheet" || by_topic.out.contains("tilesat help rules\n"), "{by_topic:?}");
    }
    assert_eq!(tilesat(["help"]).out, tilesat(["--help"]).out);
    refused(&tilesat(["help", "rule"]), "no topic is called rule; there is help about: rules, bake");
}

#[test]
fn the_version() {
    let ran = tilesat(["--version"]);
    assert_eq!((ran.status, &*ran.out, &*ran.err), (0, concat!("tilesat ", env!("CARGO_PKG_VERSION"), "\n"), ""));
}

/// Standard output that cannot be written, with this error.
struct Broken(ErrorKind);

impl Write for Broken {
    fn write(&mut self, _: &[u8]) -> io::Result<usize> {
        Err(self.0.into())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A script must not take half of a report for all of it. Whoever closes a pipe has read enough.
#[test]
fn output_that_cannot_be_written() {
    let level = scratch("command", "full.tmx", rows(&["#..#", "####"]));
    let level = level.to_str().unwrap();
    for args in [&["bake", level, "--json"][..], &["lint", level], &["--help"], &["play", level, "--frames", "1"]] {
        for (kind, status) in [(ErrorKind::StorageFull, 2), (ErrorKind::BrokenPipe, 0)] {
            let mut err = Vec::new();
            let found = cli::run(args.iter().map(OsString::from), &mut Broken(kind), &mut err);
            let err = String::from_utf8(err).unwrap();
            assert_eq!((found, err.contains("cannot write the output")), (status, status == 2), "{args:?} {err}");
        }
    }
}

/// Beside bytes that are gone, a source with the level itself is not the one that was named.
#[test]
fn play_takes_the_source_of_the_bytes() {
    let level = scratch("command", "bytes.tmx", rows(&["#    #", "#    #", "######"]));
    let of = |end: &str| level.with_extension(end);
    let bake = |end: &str| assert_eq!(run("bake", &level, &format!("-o {}", of(end).display())).status, 0);
    bake("rs");
    for end in ["bin", "bin.rs"] {
        let _ = fs::remove_file(of(end));
    }
    refused(&run("play", of("bin"), "--frames 1"), "which describes the bytes, is missing");
    bake("bin");
    assert_eq!(run("play", of("bin"), "--frames 1").status, 0);
    // The game's own form.
    let ran = run("play", &level, &format!("--bake {}", level.with_extension("").display()));
    fs::remove_file(of("bin.rs")).unwrap();
    assert!(ran.status == 0 && run("play", of("bin"), "--frames 1").status == 0, "{ran:?}");
}

#[test]
fn files_without_content() {
    for name in ["empty.ldtk", "empty.tmx", "empty.tmj", "empty.world"] {
        refused(&run("bake", scratch("command", name, "\n"), "--json"), ": the file is empty");
    }
}

/// A number of a file ends at a million.
#[test]
fn positions_beyond_all_numbers() {
    let text = |class: &str| {
        let object = format!(r#"<object id="1" class="{class}" x="1e30" y="-1e30" width="4" height="4"/>"#);
        map(1, 1, "1", &object).replace(r#"name="L" class="Solid""#, r#"name="things""#)
    };
    let place = "object 1 of layer 'things' at (1000000 or more, -1000000 or less): it is outside";
    let ran = run("bake", scratch("command", "listed.tmx", text("Spawn")), "--json");
    assert!(ran.status == 0 && ran.out.contains(place), "{ran:?}");
    refused(&run("bake", scratch("command", "solid.tmx", text("Solid")), "--json"), place);
}

/// Their names are not the one that was given.
#[test]
fn the_pictures_of_several_levels_have_names() {
    let one = ldtk(&["Full"], 2, 1, "1,0");
    let (from, to) = (one.find(r#"{"identifier":"One""#).unwrap(), one.rfind("]}").unwrap());
    let text = format!("{},{}{}", &one[..to], one[from..to].replace("One", "Two"), &one[to..]);
    let file = scratch("command", "two.ldtk", text);
    for options in ["--json", "-o"] {
        let source = if options == "-o" { file.with_extension("rs").display().to_string() } else { String::new() };
        let ran = run("bake", &file, &format!("{options} {source} --picture {}", file.with_extension("png").display()));
        let said = ran.out.clone() + &ran.err;
        for name in ["two.one.png", "two.two.png"] {
            let line = said.lines().any(|line| line.starts_with("picture ") && line.ends_with(name));
            assert!(ran.status == 0 && line, "{name} {ran:?}");
        }
    }
}

/// Each drawing that is not in the level has a line.
#[test]
fn equal_lines_about_drawings() {
    let image = r#"<imagelayer name="bg"/><imagelayer name="bg"/><objectgroup id"#;
    let text = rows(&["#"]).replace("<objectgroup id", image);
    let ran = run("bake", scratch("command", "images.tmx", text), "--json");
    assert!(ran.out.contains(r#""ignored":["image layer 'bg'","image layer 'bg'"]"#), "{ran:?}");
}

/// As for the names of layers and tiles.
#[test]
fn an_ignored_level_that_is_not_there() {
    let project = scratch("command", "level.ldtk", ldtk(&["Full"], 2, 1, "1,0"));
    refused(
        &run("bake", &project, "--json --ignore-level Nope"),
        "--ignore-level Nope: there is no such level; there are: One",
    );
    refused(&run("lint", &project, "--ignore-level Nope"), "there are: One");
    refused(
        &run("bake", scratch("command", "alone.tmx", rows(&["#"])), "--json --ignore-level Nope"),
        "there are: alone",
    );
    refused(&run("bake", &project, "--json --ignore-level one"), "every level is skipped");
}

/// It has no built-in level, and draws into the given file.
#[test]
fn play_takes_any_level() {
    let level = own("platformer/levels/ninja.tmx");
    refused(&tilesat(["play"]), "tilesat play: no level given");
    refused(&tilesat(["play", "--level", "ninja"]), "no level given");
    refused(&tilesat(["play", "a.tmx", "b.tmx"]), "LEVEL is given twice");
    let args = ["play".as_ref(), level.as_os_str(), "--frames".as_ref(), "600".as_ref()];
    let ran = tilesat(args);
    assert!(ran.status == 0 && ran.err.is_empty() && !ran.out.contains("picture"), "{ran:?}");
    assert!(ran.last().starts_with("frames=600 bodies=33 "), "{ran:?}");
}

#[test]
fn sheets() {
    // Nothing of another run is left there.
    let files =
        ["shapes", "mosaic", "level", "contacts"].map(|name| scratch("sheets", &format!("sheet-{name}.png"), ""));
    let ran = tilesat(["sheet".as_ref(), folder("sheets").as_os_str()]);
    assert!(ran.status == 0 && ran.err.is_empty() && ran.out.lines().count() == 4, "{ran:?}");
    for file in files {
        assert!(fs::read(&file).unwrap().starts_with(b"\x89PNG\r\n"), "{}", file.display());
    }
    refused(&tilesat(["sheet"]), "tilesat sheet: no folder given");
    refused(&tilesat(["sheet", "a", "b"]), "twice");
    refused(&tilesat(["sheet", "--wide"]), "unknown argument --wide");
    refused(&tilesat(["sheet", "/no/such/folder"]), "cannot write");
}
