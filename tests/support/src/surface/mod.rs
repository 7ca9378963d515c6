//! The surface of levels of all shapes, from polygons, to judge the tile map's: no sectors, no
//! tables, no cursor.

pub mod mosaic;
pub mod outline;
pub mod piece;
pub mod polygon;
pub mod turn;
