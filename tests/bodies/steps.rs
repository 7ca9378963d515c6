//! Steps with closures behind pointers: each type of a closure would compile a step of its own,
//! some seconds.

use tilesat::broad::{Pair, SortSweep};
use tilesat::scene::{Reply, SceneBody, SceneError, SceneEvent, SceneTag, Stepped};
use tilesat::{Scene, TileKinds, TileMap, Vec2};
use tilesat_judge::scenes::BODIES;

/// The scene of most tests.
pub(super) type Swept = Scene<SortSweep<BODIES, SceneTag>, BODIES>;

/// A level without a solid.
pub(super) fn open() -> TileMap<'static> {
    TileMap::new(&[b'.'; 144], 12, 12, &TileKinds::EMPTY).unwrap()
}

/// [`Scene::step_with`], among blocks.
pub(super) fn step_with(
    scene: &mut Swept,
    map: &TileMap<'_>,
    gravity: Vec2,
    reply: &mut dyn FnMut(Pair) -> Reply,
    each: &mut dyn FnMut(SceneEvent<'_>),
) -> Result<Stepped, SceneError> {
    scene.step_with(map, gravity, reply, each)
}

/// A level for each body.
type LevelOf<'l> = &'l dyn Fn(&SceneBody) -> &'l TileMap<'l>;

/// [`Scene::step_in`], where all pairs meet or none.
pub(super) fn step_in(scene: &mut Swept, level_of: LevelOf<'_>, gravity: Vec2, meets: bool) -> Stepped {
    scene.step_in(level_of, gravity, |_| meets, |_| ()).unwrap()
}
