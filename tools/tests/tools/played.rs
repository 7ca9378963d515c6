//! The pictures of `tilesat play`, and where its player starts.
#![allow(clippy::cast_precision_loss, reason = "pixels of a picture are few")]

use std::path::Path;

use tilesat_games::platformer::sim::Shape;
use tilesat_tools::bake::reopen::reopen;
use tilesat_tools::bake::{self, Settings};
use tilesat_tools::picture::ink::EARTH;
use tilesat_tools::picture::marks::{Mark, Scene};
use tilesat_tools::play::{self, Arena};
use tilesat_tools::read;

use crate::support::{self, folder, map, scratch};

/// The first level of a file.
fn arena(file: &Path) -> Arena {
    let levels = read::load(file, None).unwrap();
    Arena::of(&bake::bake(&levels.maps[..1], &Settings::default()).unwrap().levels[0]).unwrap()
}

fn picture(arena: &Arena, name: &str) -> Scene {
    let run = play::play(arena, 60, 11, &mut Vec::new()).unwrap();
    play::picture::scene(arena, &run, name, 11)
}

/// The middle of the lower side of the player, raw, before the first frame.
fn feet(arena: &Arena) -> (i32, i32) {
    let run = play::play(arena, 0, 11, &mut Vec::new()).unwrap();
    let Shape::Box(body) = run.actors[0].shape else { panic!("the player is a box") };
    (body.centre().raw().0, body.max().raw().1)
}

/// Whether a box of the solid's colour covers a point of the picture.
fn is_solid(scene: &Scene, (x, y): (f32, f32)) -> bool {
    scene.marks.iter().any(|mark| match mark {
        Mark::Rect { at, size, fill } if *fill == EARTH => {
            at.0 <= x && x <= at.0 + size.0 && at.1 <= y && y <= at.1 + size.1
        }
        _ => false,
    })
}

/// 16 x 10 cells: a floor, a solid square with a hole, and a slanted polygon.
fn polygons(floor: bool) -> String {
    let cells: Vec<&str> = (0..160).map(|cell| if floor && cell >= 144 { "1" } else { "0" }).collect();
    let list = r#"<object id="1" x="32" y="32" width="64" height="64"/><object id="2" type="Hole" x="48" y="48" width="32" height="32"/>
        <object id="3" x="128" y="64"><polygon points="0,0 60,-30 90,40 20,50"/></object>"#;
    map(16, 10, &cells.join(","), list)
}

#[test]
fn polygons_are_drawn_where_they_are_solid() {
    let file = scratch("played", "tiles.tmx", polygons(true));
    let scene = picture(&arena(&file), "tiles.tmx");
    for (at, solid) in [
        ((40.0, 40.0), true),
        ((64.0, 64.0), false),
        ((170.0, 80.0), true),
        ((131.0, 40.0), false),
        ((20.0, 20.0), false),
        ((88.0, 150.0), true),
    ] {
        assert_eq!(is_solid(&scene, at), solid, "{at:?}");
    }
}

/// Without tiles, the cells around the polygons begin left of them and above.
#[test]
fn everything_is_in_the_picture_of_polygons_alone() {
    let arena = arena(&scratch("played", "alone.tmx", polygons(false)));
    let (x, y) = (arena.level.origin.0 >> 16, arena.level.origin.1 >> 16);
    assert!(x < 0 && y < 0, "{x} {y}");
    let scene = picture(&arena, "alone.tmx");
    let solid = |at: (f32, f32)| is_solid(&scene, (at.0 - x as f32, at.1 - y as f32));
    assert!(solid((40.0, 40.0)) && !solid((64.0, 64.0)) && solid((170.0, 80.0)));
    let inside = |v: f32, end: f32| (0.0..=end).contains(&v);
    for mark in &scene.marks {
        if let Mark::Disc { centre, .. } = mark {
            assert!(inside(centre.0, scene.level.0) && inside(centre.1, scene.size.1), "{mark:?}");
        }
    }
}

#[test]
fn the_text_ends_before_the_border_of_the_picture() {
    let levels = [
        ("small", support::rows(&["...", "...", "###"])),
        ("wide", support::rows(&[&".".repeat(200), &"#".repeat(200)])),
        ("long", support::rows(&["....", "####"]).replace("World", "A layer whose name has very many letters")),
        ("poly", polygons(true)),
    ];
    for (name, text) in levels {
        let file = scratch("played", &format!("{name}.tmx"), text);
        let scene = picture(&arena(&file), &format!("{name}.tmx"));
        let mut texts = 0;
        for mark in &scene.marks {
            let Mark::Text { at, text, .. } = mark else { continue };
            let end = at.0 + text.len() as f32 * Scene::LETTER.0 / scene.scale;
            assert!(end <= scene.size.0 && at.1 < scene.size.1, "{name}: {text:?} ends at {end} of {:?}", scene.size);
            texts += 1;
        }
        assert!(texts >= 8, "{name}");
    }
}

/// A level of 12 x 6 cells above a floor, and these objects in a layer for the game.
fn with(objects: &str) -> String {
    let cells: Vec<&str> = (0..72).map(|cell| if cell >= 60 { "1" } else { "0" }).collect();
    map(12, 6, &cells.join(","), objects).replace(" class=\"Solid\"", "")
}

const PX: i32 = 65536;

#[test]
fn the_player_starts_at_the_spawn() {
    let point = |what: &str| format!(r#"<object id="4" {what} x="72" y="80"><point/></object>"#);
    let enemy = r#"<object id="3" name="slime" type="Spawn" x="24" y="80"><point/></object>"#;
    for (name, objects) in [
        ("spawn", point("name=\"spawn\"")),
        ("player", point("name=\"Player\"")),
        ("start", point("name=\"hero\" type=\"PlayerStart\"")),
        ("point", point("type=\"spawn_point\"")),
        ("area", r#"<object id="4" name="Player" x="64" y="48" width="16" height="32"/>"#.to_owned()),
        ("enemy", format!("{enemy}{}", point("name=\"spawn\""))),
    ] {
        let file = scratch("played", &format!("{name}.tmx"), with(&objects));
        assert_eq!(feet(&arena(&file)), (72 * PX, 80 * PX), "{name}");
        let ran = support::run("play", file, "--frames 5");
        assert!(ran.out.contains("player  starts at object 4") && !ran.out.contains("no room"), "{ran:?}");
    }
    // A level of segments has no scripted player, but its first body starts there.
    let arena = arena(&scratch("played", "segments.tmx", {
        let point = "<objectgroup id=\"8\" name=\"G\"><object id=\"9\" name=\"spawn\" x=\"20\" y=\"144\"><point/></object></objectgroup></map>";
        polygons(true).replace("</map>", point)
    }));
    assert_eq!(feet(&arena), (20 * PX, 144 * PX));
}

#[test]
fn a_spawn_within_the_floor_is_reported() {
    let inside = r#"<object id="4" name="spawn" x="72" y="90"><point/></object>"#;
    let ran = support::run("play", scratch("played", "inside.tmx", with(inside)), "--frames 5");
    let note = "note    object 4 'spawn' of layer 'L': the player has no room there, and starts elsewhere";
    assert!(ran.status == 0 && ran.out.contains(note), "{ran:?}");
}

/// A baked level has its objects, too.
#[test]
fn the_player_of_a_baked_level_starts_at_the_spawn() {
    let spawn = r#"<object id="4" name="spawn" x="72" y="80"><point/></object>"#;
    let out = folder("played").join("baked.rs");
    let file = scratch("played", "baked.tmx", with(spawn));
    let ran = support::run("bake", file, &format!("-o {}", out.display()));
    assert_eq!(ran.status, 0, "{ran:?}");
    assert_eq!(feet(&Arena::reopened(&reopen(&out).unwrap()[0]).unwrap()), (72 * PX, 80 * PX));
}

/// The game counts from the first cell, and a map can begin elsewhere.
#[test]
fn the_spawn_of_a_moved_level() {
    let spawn = r#"<object id="4" name="spawn" x="72" y="80"><point/></object>"#;
    let moved = with(spawn).replace("name=\"World\"", "name=\"World\" offsetx=\"-32\" offsety=\"16\"");
    let arena = arena(&scratch("played", "moved.tmx", moved));
    assert_eq!((arena.level.origin, feet(&arena)), ((0, 0), (104 * PX, 64 * PX)));
}
