//! Written by `tilesat bake LEVEL -o OUT.rs`. Do not edit it.
#![allow(unreachable_pub, reason = "a level is a module of a program")]
#![allow(dead_code, reason = "a game may use only a part")]
#![allow(clippy::unreadable_literal, reason = "raw coordinates")]

use ::tilesat::{TileKind, TileKinds};

pub const WIDTH: u16 = 30;
pub const HEIGHT: u16 = 17;
/// Side of a tile in pixels.
pub const TILE: u16 = 16;
/// The flag bits of the game's rules.
pub const FLAG_COIN: u8 = 1;
pub const FLAG_LADDER: u8 = 2;
pub const FLAG_ICE: u8 = 4;
/// Row by row.
pub static TILES: &[u8; 510] = b"\
    \x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x02\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x03\x03\x03\x03\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x00\x00\x02\x00\x02\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\
    \x01\x01\x01\x01\x01\x01\x01\x01\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x01\x01\x01\x01\x01\x01\x01\x01\
    \x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\x01\
";
#[rustfmt::skip]
pub static KINDS: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::FULL)
    .with(2, TileKind::EMPTY.with_flags(1))
    .with(3, TileKind::ONE_WAY_UP);
/// Where the cells are: the first corner is at the origin.
#[rustfmt::skip]
pub const GRID: ::tilesat::Grid = match ::tilesat::Grid::new(WIDTH, HEIGHT, ::tilesat::Fx::lit("16"), ::tilesat::Vec2::ZERO) {
    Ok(grid) => grid,
    Err(_) => panic!("the cells do not fit"),
};
/// The level as it was drawn, with nothing outside.
pub static MAP: ::tilesat::TileMap<::tilesat::Blocks> = match map(TILES) {
    Ok(map) => map,
    Err(_) => panic!("the tiles do not fit"),
};
/// The level of other tiles, such as a copy of `TILES` in RAM that the game changes.
///
/// # Errors
/// None: the array has the size of the level, and the set has all kinds.
#[rustfmt::skip]
pub const fn map(tiles: &[u8; 510]) -> Result<::tilesat::TileMap<'_, ::tilesat::Blocks>, ::tilesat::TileMapError> {
    ::tilesat::TileMap::of(tiles, GRID, &KINDS)
}
/// An object of the level that is not solid. A point has an area without size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Object {
    /// Unique in the map or the project.
    pub id: u32,
    pub class: &'static str,
    pub name: &'static str,
    pub area: ::tilesat::Aabb,
    /// Those of a polygon or a polyline, such as the way of a lift.
    pub points: &'static [::tilesat::Vec2],
    /// As drawn. A list is several entries with one name.
    pub properties: &'static [(&'static str, Value)],
}
/// The value of a property.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value {
    Bool(bool),
    /// Rounded to nearest. One that 16.16 cannot hold is a text.
    Number(::tilesat::Fx),
    Text(&'static str),
    /// A reference to the object with this id.
    Object(u32),
    Point(::tilesat::Vec2),
}
impl Object {
    /// The value of a property.
    pub fn property(&self, name: &str) -> Option<Value> {
        self.properties.iter().find(|property| property.0 == name).map(|property| property.1)
    }
    /// The number of a property.
    pub fn number(&self, name: &str) -> Option<::tilesat::Fx> {
        match self.property(name) {
            Some(Value::Number(number)) => Some(number),
            _ => None,
        }
    }
}
const fn area(x: i32, y: i32, right: i32, bottom: i32) -> ::tilesat::Aabb {
    match ::tilesat::Aabb::new(::tilesat::Vec2::from_raw(x, y), ::tilesat::Vec2::from_raw(right, bottom)) {
        Ok(area) => area,
        Err(_) => panic!("an object is outside of the domain"),
    }
}
/// The objects that are not solid, in the order of the file.
#[rustfmt::skip]
pub static OBJECTS: &[Object] = &[
    Object { id: 8, class: "Places", name: "start", area: area(2621440, 14155776, 2621440, 14155776), points: &[], properties: &[] },
    Object { id: 9, class: "Places", name: "exit", area: area(27262976, 10485760, 28311552, 12582912), points: &[], properties: &[] },
];
pub const OBJECT_START: ::tilesat::Aabb = area(2621440, 14155776, 2621440, 14155776);
pub const OBJECT_EXIT: ::tilesat::Aabb = area(27262976, 10485760, 28311552, 12582912);

use ::tilesat::{Fx, Path, PathKind, Vec2, segment_map};

#[rustfmt::skip]
const POINTS_0: [Vec2; 11] = [
    Vec2::from_ints(64, 176),
    Vec2::from_ints(88, 136),
    Vec2::from_ints(136, 120),
    Vec2::from_ints(184, 144),
    Vec2::from_ints(200, 184),
    Vec2::from_ints(192, 216),
    Vec2::from_ints(160, 216),
    Vec2::from_ints(148, 192),
    Vec2::from_ints(112, 192),
    Vec2::from_ints(100, 216),
    Vec2::from_ints(72, 216),
];
#[rustfmt::skip]
const POINTS_1: [Vec2; 5] = [
    Vec2::from_ints(112, 136),
    Vec2::from_ints(128, 132),
    Vec2::from_ints(140, 144),
    Vec2::from_ints(124, 160),
    Vec2::from_ints(108, 156),
];
#[rustfmt::skip]
const POINTS_2: [Vec2; 4] = [
    Vec2::from_ints(224, 112),
    Vec2::from_ints(288, 112),
    Vec2::from_ints(288, 120),
    Vec2::from_ints(224, 120),
];
#[rustfmt::skip]
const POINTS_3: [Vec2; 4] = [
    Vec2::from_ints(320, 240),
    Vec2::from_ints(320, 216),
    Vec2::from_ints(340, 204),
    Vec2::from_raw(22288794, 11776819),
];
#[rustfmt::skip]
const POINTS_4: [Vec2; 4] = [
    Vec2::from_ints(224, 192),
    Vec2::from_ints(248, 200),
    Vec2::from_ints(280, 202),
    Vec2::from_ints(312, 192),
];
#[rustfmt::skip]
const POINTS_5: [Vec2; 4] = [
    Vec2::from_ints(384, 240),
    Vec2::from_ints(432, 216),
    Vec2::from_ints(464, 216),
    Vec2::from_ints(464, 240),
];
#[rustfmt::skip]
const POINTS_6: [Vec2; 4] = [
    Vec2::from_ints(352, 48),
    Vec2::from_ints(352, 64),
    Vec2::from_ints(288, 64),
    Vec2::from_ints(288, 48),
];

segment_map!(
    #[allow(long_running_const_eval, reason = "it ends, because the level is finite")]
    pub static SEGMENTS: [
        Path::new(PathKind::Solid, &POINTS_0),
        Path::new(PathKind::Hole, &POINTS_1),
        Path::new(PathKind::Solid, &POINTS_2),
        Path::new(PathKind::Wall, &POINTS_3),
        Path::new(PathKind::OneWay, &POINTS_4).with_flags(2),
        Path::new(PathKind::Solid, &POINTS_5).with_flags(4),
        Path::new(PathKind::Solid, &POINTS_6),
    ],
    Fx::lit("16")
);
