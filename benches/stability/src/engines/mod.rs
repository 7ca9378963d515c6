//! The columns of the tables.

mod clip;
mod ours;
mod parry;
mod parry_cast;
mod parry_contact;
#[cfg(feature = "rapier")]
mod rapier;
mod renewed;
mod scalar;
mod textbook;

use crate::engine::Engine;
use crate::level::Levels;
use crate::scene::{PX, Scene, Shape, Start};
use scalar::Q16;
use textbook::Textbook;

type Made<'a> = Option<Box<dyn Engine + 'a>>;

/// One column: its name, and its engine for a scene, if there is one.
#[derive(Clone, Copy)]
pub struct Column {
    pub name: &'static str,
    pub make: for<'a> fn(&'a Scene, &'a Levels, &Start) -> Made<'a>,
}

fn boxed<'a>(engine: Option<impl Engine + 'a>) -> Made<'a> {
    engine.map(|e| Box::new(e) as Box<dyn Engine + 'a>)
}

fn tiles<'a>(scene: &Scene, levels: &'a Levels, start: &Start) -> Made<'a> {
    let blocks = levels.blocks().map(|world| ours::ours(world, scene, start));
    blocks.or_else(|| levels.shapes().map(|world| ours::ours(world, scene, start)))
}

/// Whether it cuts walls at 64 pixels.
fn cut(scene: &Scene) -> bool {
    matches!(scene.shape, Shape::Ball(_)) && scene.walls(64 * PX).len() > scene.walls(i32::MAX).len()
}

pub const COLUMNS: &[Column] = &[
    Column { name: "tilesat, tiles", make: |scene, levels, start| tiles(scene, levels, start) },
    Column {
        name: "tilesat, segments",
        make: |scene, levels, start| Some(ours::ours(levels.segments(), scene, start)),
    },
    Column {
        name: "tilesat, segments, energy renewed at bounces",
        make: |scene, levels, start| boxed(renewed::Renewed::new(levels.segments(), scene, start)),
    },
    Column {
        name: "tilesat, clipped in turn",
        make: |scene, levels, start| boxed(clip::Clip::new(levels.segments(), scene, start)),
    },
    Column { name: "naive Q16.16", make: |scene, _, start| boxed(Textbook::<Q16>::new(scene, start, i32::MAX)) },
    Column {
        name: "naive Q16.16, walls cut to 64 px",
        make: |scene, _, start| boxed(cut(scene).then(|| Textbook::<Q16>::new(scene, start, 64 * PX)).flatten()),
    },
    Column { name: "textbook f32", make: |scene, _, start| boxed(Textbook::<f32>::new(scene, start, i32::MAX)) },
    Column { name: "parry2d contact", make: |scene, _, start| boxed(parry_contact::ParryContact::new(scene, start)) },
    Column { name: "parry2d cast", make: |scene, _, start| boxed(parry_cast::ParryCast::new(scene, start)) },
    #[cfg(feature = "rapier")]
    Column { name: "rapier2d", make: |scene, _, start| boxed(rapier::Rapier::new(scene, start, false)) },
    #[cfg(feature = "rapier")]
    Column { name: "rapier2d, CCD", make: |scene, _, start| boxed(rapier::Rapier::new(scene, start, true)) },
];
