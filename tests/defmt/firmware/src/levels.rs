//! Levels of tiles, of lines, of solids, joined and placed, with their queries and the cursors of
//! the answers.

use crate::tell;
use tilesat::heapless::Vec;
use tilesat::{
    Aabb, AllShapes, Blocks, Cell, Circle, Fx, Grid, Inside, Joined, Outside, Path, PathKind, Room, Rooms, SegmentMap,
    SegmentMapError, Side, Slopes, Solid, Solids, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2,
    segment_map,
    world::{
        Bits, Bytes, ConvexSolid, ConvexSolids, Geometry, Occupied, OneWay, Placed, RayRules, SegmentFault,
        WorldContact,
    },
};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'o', TileKind::EMPTY.with_flags(1));
const HILL: [Vec2; 3] = [Vec2::from_ints(64, 48), Vec2::from_ints(96, 24), Vec2::from_ints(128, 48)];
const PATHS: [Path<'static>; 1] = [Path::new(PathKind::Solid, &HILL).with_flags(4)];
segment_map!(static HILLS: PATHS, Fx::lit("32"));

pub(crate) fn tell_all() {
    let tiles = TileMap::<AllShapes>::of_ascii("  o \n   /\n####\n", &KINDS).unwrap().with_outside(Outside::Solid);
    let lift = Solid::new(Aabb::new(Vec2::from_ints(4, 20), Vec2::from_ints(20, 24)).unwrap(), 7).unwrap();
    let lift = lift.with_motion(Vec2::from_ints(0, -1)).unwrap().with_one_way(Side::Up).with_flags(2);
    kinds(&lift);
    let list = [lift];
    let solids = Solids::new(&list);
    let joined = Joined::new(&tiles, &HILLS);
    let placed = Placed::new(&HILLS, Vec2::from_ints(0, -3)).unwrap();
    tell(&tiles);
    tell(&HILLS);
    tell(&solids);
    tell(&joined);
    tell(&placed);

    let rooms = Rooms::<AllShapes>::of(b"  # # ##", (4, 2), Fx::from_num(16), &KINDS, (2, 2), 1).unwrap();
    tell(&rooms);
    let room: Room<'_> = rooms.room(1, 0).unwrap();
    tell(&room);

    let ball = Circle::new(Vec2::from_ints(56, 27), Fx::from_num(5)).unwrap();
    let region = ball.aabb();
    let feature = tiles.features(&region).next().unwrap();
    tell(&feature);
    let Geometry::Face { .. } = feature.geometry else { panic!("a slope is a face") };
    tell(&feature.geometry);
    tell(&tiles.features(&region));
    tell(&HILLS.features(&region));
    tell(&solids.features(&region));
    convex(ball);
    tell(&joined.features(&region));
    tell(&placed.features(&region));
    tell(&tiles.tiles_in(&region));
    tell(&tiles.tiles_in(&region).next().unwrap());

    let mut found = Vec::<WorldContact, 4>::new();
    tiles.contacts(&ball, OneWay::Ignore, &mut found).unwrap();
    tell(&found[0]);
    tell(&tiles.closest_point(Vec2::from_ints(50, 10), Fx::from_num(40), OneWay::Ignore).unwrap().unwrap());
    rays(&tiles, &joined, &placed, &solids);
}

fn rays(
    tiles: &TileMap<'_, AllShapes>,
    joined: &Joined<'_, TileMap<'_, AllShapes>, SegmentMap<'_>>,
    placed: &Placed<'_, SegmentMap<'_>>,
    solids: &Solids<'_>,
) {
    let (from, by) = (Vec2::from_ints(50, 4), Vec2::from_ints(3, 40));
    let rules = RayRules { inside: Inside::Hit, one_way: true };
    tell(&rules);
    tell(&tiles.cast_ray(from, by, Inside::Hit).unwrap().unwrap());
    tell(&tiles.cast_ray_all(from, by, rules).unwrap());
    tell(&HILLS.cast_ray_all(from, by, rules).unwrap());
    tell(&solids.cast_ray_all(from, by, rules).unwrap());
    tell(&joined.cast_ray_all(from, by, rules).unwrap());
    tell(&placed.cast_ray_all(from, by, rules).unwrap());
}

fn convex(bumper: Circle) {
    let list = [ConvexSolid::new(bumper, 9).unwrap().with_motion(Vec2::from_ints(1, 0)).unwrap()];
    let solids = ConvexSolids::new(&list);
    tell(&list[0]);
    tell(&solids);
    tell(&solids.features(&bumper.aabb()));
    tell(&solids.cast_ray_all(Vec2::ZERO, Vec2::from_ints(3, 40), Inside::Hit).unwrap());
}

fn kinds(lift: &Solid) {
    tell(lift);
    tell(&Side::Left);
    tell(&Cell::new(-1, 20));
    tell(&Grid::new(30, 20, Fx::lit("8"), Vec2::from_ints(-120, 0)).unwrap());
    tell(&KINDS);
    tell(&KINDS.get(b'o'));
    tell(&TileShape::ConcaveTopLeft);
    tell(&Outside::Edge);
    tell(&OneWay::Ignore);
    tell(&Blocks);
    tell(&Slopes);
    tell(&AllShapes);
    tell(&Bytes);
    tell(&Bits);
    tell(&Occupied::<Bytes>::default());
    tell(&PATHS[0]);
    tell(&PathKind::Wall);
    tell(&SegmentMap::measure(&PATHS, Fx::lit("32")).unwrap());
    let error: TileMapError = TileMap::from_ascii("##\n#\n", &KINDS).unwrap_err();
    tell(&error);
    let error: SegmentMapError = SegmentMap::from_bytes(b"no level").unwrap_err();
    tell(&error);
    tell(&SegmentFault::Direction);
}
