//! The pictures of the small games: the solid of a level, ways through it, and the file.

use std::env;
use std::path::PathBuf;
use std::process::ExitCode;

use tilesat::{Aabb, Vec2, World, world::Geometry};

use super::ink::{EARTH, Ink, PLANK, TEXT};
use super::marks::{Scene, Spot};
use super::{png, solid};
use crate::fail::{Fail, Result};

/// The exit status of a game. It is 2, with the reason, if the game could not run to its end.
pub fn exit(game: &str, played: Result<()>) -> ExitCode {
    match played {
        Ok(()) => ExitCode::SUCCESS,
        Err(fail) => {
            eprintln!("{game}: {fail}");
            ExitCode::from(2)
        }
    }
}

/// A picture of a level of `width` x `height` units, with `scale` pixels per unit.
#[derive(Debug)]
pub struct Sketch {
    pub scene: Scene,
    scale: f32,
}

impl Sketch {
    /// The solid of a level, and its one-way edges.
    pub fn new(world: &impl World, (width, height): (i32, i32), scale: i32) -> Self {
        let size = (width * scale, height * scale);
        let mut scene = Scene::new(size.0 as f32, size.1 as f32, 1.0, 1.0);
        solid::fill(&mut scene, world, (0.0, 0.0), size, scale, EARTH);
        let mut sketch = Self { scene, scale: scale as f32 };
        let all = Aabb::new(Vec2::ZERO, Vec2::from_ints(width as i16, height as i16));
        for feature in all.iter().flat_map(|all| world.features(all)).filter(|feature| feature.one_way) {
            if let Geometry::Face { a, dir, len, .. } = feature.geometry {
                sketch.way(&[a, a + Vec2::from_raw(dir.x * len, dir.y * len)], 3.0, PLANK);
            }
        }
        sketch
    }

    /// The position of a point of the level in the picture.
    pub fn spot(&self, p: Vec2) -> Spot {
        (p.x.to_num::<f32>() * self.scale, p.y.to_num::<f32>() * self.scale)
    }

    /// Draws a way through positions of the level.
    pub fn way(&mut self, points: &[Vec2], width: f32, ink: Ink) {
        let spots = points.iter().map(|&p| self.spot(p)).collect();
        self.scene.line(spots, width, ink, false);
    }

    /// Draws a circle's line. The radius is in units of the level.
    pub fn ring(&mut self, centre: Vec2, radius: f32, width: f32, ink: Ink) {
        self.scene.ring(self.spot(centre), radius * self.scale, width, ink);
    }

    /// Draws a dot, of the same size at every scale.
    pub fn dot(&mut self, at: Vec2, ink: Ink) {
        self.scene.disc(self.spot(at), 4.0, ink);
    }

    /// Writes the picture, with lines of text below it. The first argument names the file, by
    /// default one in the target folder.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn save(mut self, name: &str, lines: &[String]) -> Result<()> {
        let mut y = self.scene.level.1 + 20.0;
        for line in lines {
            self.scene.text((10.0, y), line.as_str(), TEXT);
            y += 18.0;
        }
        self.scene.size.1 = y - 4.0;
        let target = || Some(env::current_exe().ok()?.ancestors().nth(3)?.join(name));
        let file = env::args_os().nth(1).map(PathBuf::from).or_else(target);
        let file = file.ok_or_else(|| Fail::new("the picture has no file name: add one ending in .png"))?;
        png::write(&self.scene, &file)?;
        println!("picture {}", file.display());
        Ok(())
    }
}
