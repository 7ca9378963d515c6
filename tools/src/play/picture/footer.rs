//! The caption of the picture.

use tilesat::motion::Response;

use super::bodies;
use crate::bake::level::Level;
use crate::picture::ink::{CONTACT, FAINT, Ink, KILL, PAPER, PLAYER, TEXT};
use crate::picture::marks::{Mark, Scene};
use crate::play::run::Run;

/// The least width of a picture, in output pixels: the longest word of the legend fits.
const LEAST: f32 = 240.0;

pub(super) fn draw(scene: &mut Scene, level: &Level, run: &Run, name: &str, seed: u32) {
    let unit = 1.0 / scene.scale;
    let (width, height) = scene.level;
    scene.size.0 = width.max(LEAST * unit);
    let first = scene.marks.len();
    let mut pen = height;
    legend(scene, &mut pen);
    facts(scene, &facts_of(level, run, name, seed), &mut pen);
    scene.size.1 = pen + 10.0 * unit;
    // What lies beyond the level is not behind the text.
    let (right, below) = (scene.size.0 - width, scene.size.1 - height);
    let margins = [((width, 0.0), (right, height)), ((0.0, height), (scene.size.0, below))];
    let margins = margins.map(|(at, size)| Mark::Rect { at, size, fill: PAPER });
    scene.marks.splice(first..first, margins);
}

/// What the colours mean, in as many rows as it needs.
fn legend(scene: &mut Scene, pen: &mut f32) {
    let unit = 1.0 / scene.scale;
    let letter = Scene::LETTER.0 * unit;
    let swatches: [(&str, Ink); 6] = [
        ("player", PLAYER),
        ("slide", bodies::ink(Response::Slide)),
        ("touch", bodies::ink(Response::Touch)),
        ("cross", bodies::ink(Response::DropThrough)),
        ("bounce", bodies::ink(Response::Bounce)),
        ("contact", CONTACT),
    ];
    let (left, line) = (10.0 * unit, 22.0 * unit);
    let mut x = left;
    *pen += line;
    for (word, ink) in swatches.into_iter().map(|(word, ink)| (word, Some(ink))).chain([("x death", None)]) {
        let swatch = if ink.is_some() { 16.0 * unit } else { 2.0 * unit };
        let wide = swatch + word.len() as f32 * letter;
        if x > left && x + wide > scene.size.0 - left {
            (x, *pen) = (left, *pen + line);
        }
        if let Some(ink) = ink {
            let radius = if word == "contact" { 3.0 } else { 6.0 } * unit;
            scene.disc((x + 5.0 * unit, *pen - 5.0 * unit), radius, ink);
        }
        scene.text((x + swatch, *pen), word, if ink.is_some() { TEXT } else { KILL });
        x += wide + 2.0 * letter;
    }
    *pen += 3.0 * unit;
}

fn facts_of(level: &Level, run: &Run, name: &str, seed: u32) -> [String; 10] {
    let s = run.score;
    [
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
    ]
}

fn facts(scene: &mut Scene, facts: &[String], pen: &mut f32) {
    let unit = 1.0 / scene.scale;
    let room = ((scene.size.0 - 20.0 * unit) / (Scene::LETTER.0 * unit)) as usize;
    // The letters are ASCII. Others show as '?'.
    let plain = |c: char| if c.is_ascii_graphic() || c == ' ' { c } else { '?' };
    let mut rows = vec![String::new()];
    for fact in facts {
        let fact: String = fact.chars().map(plain).collect();
        let row = rows.last_mut().filter(|row| row.is_empty() || row.len() + 3 + fact.len() <= room);
        match row {
            Some(row) if row.is_empty() => *row = fact,
            Some(row) => row.extend([" - ", &fact]),
            None => rows.push(fact),
        }
    }
    for row in &rows {
        // A name can be longer than a row.
        for part in row.as_bytes().chunks(room.max(1)) {
            *pen += 18.0 * unit;
            scene.text((10.0 * unit, *pen), String::from_utf8_lossy(part), FAINT);
        }
    }
}
