//! Everything that a scene keeps twice is equal.

use tilesat::broad::BroadPhase;
use tilesat::scene::SceneTag;
use tilesat::{Scene, TileKind, TileKinds, TileMap};

pub static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

/// Cells of 16: the floor is at y = 64.
pub const ROOM: &str = "#..........#\n#..........#\n#..........#\n#..........#\n############\n";

/// The room of a scene in most tests, even of two bodies: each other one compiles all of it again.
pub const BODIES: usize = 32;

pub fn room() -> TileMap<'static> {
    TileMap::from_ascii(ROOM, &KINDS).unwrap()
}

/// Everything that a scene keeps twice is equal.
pub fn check<B: BroadPhase<Tag = SceneTag>>(scene: &Scene<B, BODIES>) {
    let mut awake: Vec<_> = scene.bodies().filter(|(handle, _)| scene.is_awake(*handle).unwrap()).collect();
    assert_eq!(awake.len(), scene.awake().len());
    awake.retain(|(handle, body)| scene.awake().contains(handle) && body.mass.is_some());
    assert_eq!(awake.len(), scene.awake().len());
    assert_eq!(scene.bodies().count(), scene.near().len());
    for (handle, body) in scene.bodies() {
        assert_eq!(scene.body(handle), Ok(body));
        let still = !scene.is_awake(handle).unwrap();
        assert_eq!(scene.near().tag(handle), Ok(SceneTag { key: body.key, tag: body.filter.with_still(still) }));
        assert_eq!(scene.near().bounds(handle), Ok(body.shape.aabb()));
    }
}
