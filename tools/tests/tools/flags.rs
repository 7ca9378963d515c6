//! Flags beyond the eight that a tile can have: the first eight stay, and each command names the
//! others.

use crate::support::{objects, run, scratch};

/// A solid object with these true properties.
fn marked(names: &[&str]) -> String {
    let flags = names.iter().map(|name| format!(r#"<property name="{name}" type="bool" value="true"/>"#));
    let flags = flags.collect::<String>();
    objects(&format!(r#"<object id="7" width="9" height="9"><properties>{flags}</properties></object>"#))
}

const NINE: [&str; 9] = ["A", "B", "C", "D", "E", "F", "G", "H", "I"];

#[test]
fn the_ninth_flag_is_dropped_with_a_warning() {
    let level = || scratch("flags", "nine.tmx", marked(&NINE));
    let out = scratch("flags", "nine.rs", "").display().to_string();
    let ran = run("bake", level(), &format!("-o {out}"));
    assert_eq!((ran.status, ran.err.as_str()), (0, ""));
    let warning = "warning tiles and segments have at most 8 flags; A, B, C, D, E, F, G, H stay, and these are dropped: 'I'; \
                   add --flag NAME for each of those that should stay";
    for line in [warning, "dropped flag I"] {
        assert!(ran.out.lines().any(|found| found == line), "{line} is not in {}", ran.out);
    }
    assert!(!std::fs::read_to_string(&out).unwrap().contains("FLAG_I"));
    let json = run("bake", level(), "--json");
    assert!(json.status == 0 && json.err.contains(warning) && json.err.contains("dropped flag I"), "{json:?}");
    // Those that the user names stay, and no warning is needed.
    let chosen = run("bake", level(), &format!("-o {out} --flag I"));
    assert!(chosen.out.contains("dropped flag H") && !chosen.out.contains("at most 8 flags"), "{chosen:?}");
    let many = NINE.map(|name| format!("--flag {name}")).join(" ");
    let ran = run("bake", level(), &format!("-o {out} {many}"));
    assert!(ran.status == 2 && ran.err.contains("--flag I would be the ninth flag"), "{ran:?}");
}

/// Rooms and the linter have no list of dropped flags of their own.
#[test]
fn every_command_names_dropped_flags() {
    let tile = |(id, name): (usize, &&str)| format!(r#"<tile id="{id}" type="{name}"/>"#);
    let tiles: String = NINE.iter().enumerate().map(|(id, name)| tile((id + 4, name))).collect();
    let text = crate::support::map(12, 4, &["1,0,5,6,7,8,9,10,11,12,13,0", &["0"; 36].join(",")].join(","), "");
    let text =
        text.replace(" </tileset>", &format!("{tiles} </tileset>")).replace("tilecount=\"4\"", "tilecount=\"16\"");
    let level = || scratch("flags", "tiles.tmx", &text);
    let out = scratch("flags", "rooms.rs", "").display().to_string();
    for (command, options) in [
        ("lint", String::new()),
        ("rooms", format!("-o {out} --room 6x4")),
        ("play", "--frames 1".to_owned()),
        ("bake", format!("-o {out}")),
    ] {
        let ran = run(command, level(), &options);
        assert!(ran.status != 2 && ran.out.contains("these are dropped: 'I'"), "{command} {ran:?}");
    }
    let ran = run("rooms", level(), &format!("-o {out} --room 6x4 --flag I"));
    assert!(ran.out.contains("ignored flag H"), "{ran:?}");
}
