//! The caption of the picture.

use tilesat::motion::Response;

use super::bodies;
use crate::bake::level::Level;
use crate::picture::ink::{CONTACT, FAINT, Ink, KILL, PLAYER, TEXT};
use crate::picture::marks::Scene;
use crate::play::run::Run;

pub(super) fn draw(scene: &mut Scene, level: &Level, run: &Run, name: &str, seed: u32) {
    let unit = 1.0 / scene.scale;
    let (letter, line) = (Scene::LETTER.0 * unit, 22.0 * unit);
    let mut pen = (10.0 * unit, scene.level.1 + line);
    let swatches: [(&str, Ink); 6] = [
        ("player", PLAYER),
        ("slide", bodies::ink(Response::Slide)),
        ("touch", bodies::ink(Response::Touch)),
        ("cross", bodies::ink(Response::DropThrough)),
        ("bounce", bodies::ink(Response::Bounce)),
        ("contact", CONTACT),
    ];
    for (word, ink) in swatches {
        let centre = (pen.0 + 5.0 * unit, pen.1 - 5.0 * unit);
        scene.disc(centre, if word == "contact" { 3.0 } else { 6.0 } * unit, ink);
        scene.text((pen.0 + 16.0 * unit, pen.1), word, TEXT);
        pen.0 += 16.0 * unit + (word.len() as f32 + 2.0) * letter;
    }
    scene.text((pen.0 + 2.0 * unit, pen.1), "x death", KILL);
    let s = run.score;
    let facts = [
        format!("{name}, layer {}", level.layer),
        format!("seed {seed}"),
        format!("{} frames", run.frames),
        format!("{} contacts", run.contacts),
        format!("{} overlaps", run.overlaps),
        format!("{} escaped", run.escaped),
        format!("{} coins", s.coins),
        format!("{} deaths", s.deaths),
        format!("{} wins", s.wins),
        format!("hash {:08x}", run.hash),
    ];
    // The letters are ASCII. Others show as '?'.
    let plain = |c: char| if c.is_ascii_graphic() || c == ' ' { c } else { '?' };
    let room = ((scene.level.0 - 20.0 * unit) / letter) as usize;
    let mut row = String::new();
    let mut rows = Vec::new();
    for fact in facts {
        let fact: String = fact.chars().map(plain).collect();
        if !row.is_empty() && row.len() + 3 + fact.len() > room {
            rows.push(std::mem::take(&mut row));
        }
        if !row.is_empty() {
            row.push_str(" - ");
        }
        row.push_str(&fact);
    }
    rows.push(row);
    pen.1 += 3.0 * unit;
    for row in rows {
        pen.1 += 18.0 * unit;
        scene.text((10.0 * unit, pen.1), row, FAINT);
    }
    scene.size.1 = pen.1 + 10.0 * unit;
}
