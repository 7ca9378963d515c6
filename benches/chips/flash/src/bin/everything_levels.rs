//! All levels with all constructors, and all queries on them.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::heapless::VecView;
use tilesat::world::{
    AllShapes, Bits, Blocks, Bytes, Cell, Grid, Joined, Occupied, OneWay, Outside, Path, PathKind, Placed, RayRules,
    SegmentMap, Side, Size, Slopes, Solid, Solids, TileAt, TileKind, TileKinds, TileMap, TileShape, World,
    WorldContact,
};
use tilesat::{Aabb, Circle, Fx, Inside, Vec2};
use tilesat_flash::keep;

type Both<'a> = Joined<'a, TileMap<'a, AllShapes>, SegmentMap<'a>>;
type Doors<'a> = Joined<'a, TileMap<'a>, Solids<'a>>;

/// The queries on all levels.
macro_rules! levels {
    ($($level:ty),+ $(,)?) => {
        $(keep! {
            |l: &$level, b: &Aabb| l.overlaps(b);
            |l: &$level, b: &Aabb| l.touches(b);
            |l: &$level, c: &Circle| l.overlaps(c);
            |l: &$level, c: &Circle| l.touches(c);
            |l: &$level, b: &Aabb| l.flags_touched(b);
            |l: &$level, c: &Circle| l.flags_touched(c);
            |l: &$level, p: &Vec2| l.flags_touched(p);
            |l: &$level, b: &Aabb| World::features(l, b).map(|f| core::hint::black_box(f)).count();
            |l: &$level, b: &Aabb| l.features(b).map(|f| core::hint::black_box(f)).count();
            |l: &$level, o: Vec2, d: Vec2, rules: RayRules| l.cast_ray(o, d, rules);
            |l: &$level, o: Vec2, d: Vec2, rules: RayRules| {
                l.cast_ray_all(o, d, rules).map(|hits| hits.map(|hit| core::hint::black_box(hit)).count())
            };
            |l: &$level, a: Vec2, b: Vec2| l.line_of_sight(a, b);
            |l: &$level, o: Vec2, d: Vec2, inside: Inside| l.cast_shape(&Circle::new(o, Fx::ONE).unwrap_or(UNIT), d, inside);
            |l: &$level, b: &Aabb, d: Vec2, rules: RayRules| l.cast_shape(b, d, rules);
            |l: &$level, c: &Circle, d: Vec2, rules: RayRules| l.cast_shape(c, d, rules);
        })+
    };
}

const UNIT: Circle = match Circle::new(Vec2::ZERO, Fx::ONE) {
    Ok(circle) => circle,
    Err(_) => panic!("a circle"),
};

/// The queries on levels with cells.
macro_rules! surfaces {
    ($($level:ty),+ $(,)?) => {
        $(keep! {
            |l: &$level, p: Vec2, within: Fx, way: OneWay| l.closest_point(p, within, way);
            |l: &$level, b: &Aabb, way: OneWay, out: &mut VecView<WorldContact>| l.contacts(b, way, out);
            |l: &$level, c: &Circle, way: OneWay, out: &mut VecView<WorldContact>| l.contacts(c, way, out);
        })+
    };
}

macro_rules! tile_maps {
    ($($level:ty),+ $(,)?) => {
        levels!($($level),+);
        surfaces!($($level),+);
        $(keep! {
            |l: $level, stride: u16| l.with_stride(stride);
            |l: $level, origin: Vec2| l.with_origin(origin);
            |l: $level, cell: Fx| l.with_cell(cell);
            |l: $level, kinds: &'static TileKinds| l.with_kinds::<Blocks>(kinds);
            |l: $level, kinds: &'static TileKinds| l.with_kinds::<Slopes>(kinds);
            |l: $level, kinds: &'static TileKinds| l.with_kinds::<AllShapes>(kinds);
            |l: $level, outside: Outside| l.with_outside(outside);
            |l: &$level| (l.width(), l.height(), l.cell(), l.origin(), l.grid(), l.outside());
            |l: &$level, p: Vec2| l.cell_at(p);
            |l: &$level, cell: Cell| l.tile(cell);
            |l: &$level, cell: Cell| l.kind(cell);
            |l: &$level| l.occupancy_words();
            |l: &$level, words: &mut [u32]| l.fill_occupancy(words);
            |l: $level, words: &'static [u32]| l.with_occupancy(words);
            |l: &$level, b: &Aabb| l.tiles_in(b).map(|tile| core::hint::black_box(tile)).count();
            |l: &$level, b: &Aabb, out: &mut VecView<TileAt>| l.collect_tiles(b, out);
            |l: &$level, b: &Aabb, d: Vec2| l.flags_swept(b, d);
            |l: &$level, c: &Circle, d: Vec2| l.flags_swept(c, d);
            |l: &$level, p: &Vec2, d: Vec2| l.flags_swept(p, d);
        })+
    };
}

fn grids() {
    keep! {
        |w: u16, h: u16, cell: Fx, origin: Vec2| Grid::new(w, h, cell, origin);
        |g: &Grid| (g.width(), g.height(), g.cell(), g.origin(), g.end());
        |g: &Grid, p: Vec2| g.cell_at(p);
        |x: i16, y: i16| Cell::new(x, y);
        |shape: TileShape, flags: u8| (TileKind::of(shape).with_flags(flags), TileKind::of(shape).flag(flags));
        |kinds: TileKinds, id: u8, kind: TileKind| kinds.with(id, kind);
        |kinds: &TileKinds, id: u8| kinds.get(id);
        |_any: u8| TileKinds::default();
    }
}

fn tiles() {
    keep! {
        |t: &'static [u8], w: u16, h: u16, kinds: &'static TileKinds| TileMap::new(t, w, h, kinds);
        |t: &'static [u8], grid: Grid, kinds: &'static TileKinds| TileMap::on_grid(t, grid, kinds);
        |t: &'static [u8], w: u16, h: u16, kinds: &'static TileKinds| TileMap::from_bits(t, w, h, kinds);
        |t: &'static [u8], grid: Grid, kinds: &'static TileKinds| TileMap::<Blocks>::of(t, grid, kinds);
        |t: &'static [u8], grid: Grid, kinds: &'static TileKinds| TileMap::<Slopes>::of(t, grid, kinds);
        |t: &'static [u8], grid: Grid, kinds: &'static TileKinds| TileMap::<AllShapes>::of(t, grid, kinds);
        |text: &'static str, kinds: &'static TileKinds| TileMap::from_ascii(text, kinds);
        |text: &'static str, kinds: &'static TileKinds| TileMap::<Slopes>::of_ascii(text, kinds);
        |text: &'static str, kinds: &'static TileKinds| TileMap::<AllShapes>::of_ascii(text, kinds);
    }
    tile_maps!(
        TileMap<'static, Blocks, Bytes>,
        TileMap<'static, Blocks, Bits>,
        TileMap<'static, Slopes, Bytes>,
        TileMap<'static, AllShapes, Bytes>,
        TileMap<'static, Blocks, Occupied>,
        TileMap<'static, AllShapes, Occupied>,
    );
}

fn segments() {
    keep! {
        |kind: PathKind, points: &'static [Vec2], flags: u8| Path::new(kind, points).with_flags(flags);
        |paths: &[Path<'_>], cell: Fx| SegmentMap::measure(paths, cell);
        |paths: &[Path<'_>], grid: Grid| SegmentMap::measure_on(paths, grid);
        |paths: &[Path<'_>], cell: Fx, out: &mut [u8]| SegmentMap::build_into(paths, cell, out);
        |paths: &[Path<'_>], grid: Grid, out: &mut [u8]| SegmentMap::build_on(paths, grid, out);
        |paths: &[Path<'_>], cell: Fx, out: &'static mut VecView<u8>| SegmentMap::build_vec(paths, cell, out);
        |data: &'static [u8]| SegmentMap::from_bytes(data);
        |size: &Size| (size.grid(), size.segments(), size.refs(), size.bytes());
        |l: &SegmentMap<'_>| (l.grid(), l.cell(), l.origin(), l.width(), l.height(), l.count());
    }
    levels!(SegmentMap<'_>);
    surfaces!(SegmentMap<'_>);
}

fn solids() {
    keep! {
        |shape: Aabb, key: u16| Solid::new(shape, key);
        |s: Solid, flags: u8, side: Side| s.with_flags(flags).with_one_way(side);
        |s: Solid, by: Vec2| s.with_conveyor(by);
        |s: Solid, by: Vec2| s.with_motion(by);
        |s: Solid| s.moved();
        |list: &mut [Solid]| Solid::move_all(list);
        |s: &Solid| (s.shape(), s.key(), s.flags(), s.one_way(), s.conveyor(), s.motion());
        |side: Side| side.normal();
        |list: &'static [Solid]| Solids::new(list).list();
        |cell: Cell| Solids::key_of(cell);
        |grid: &Grid, cell: Cell| grid.bounds_of(cell);
    }
    levels!(Solids<'_>);
}

fn together() {
    keep! {
        |a: &'static TileMap<'static, AllShapes>, b: &'static SegmentMap<'static>| Joined::new(a, b);
        |l: &'static Both<'static>| (l.first(), l.second());
        |l: &'static TileMap<'static, AllShapes>, by: Vec2| Placed::new(l, by);
        |l: &Placed<'_, Both<'_>>| (l.world(), l.offset());
    }
    levels!(Both<'_>, Doors<'_>, Placed<'_, TileMap<'_>>, Placed<'_, Both<'_>>, Joined<'_, Both<'_>, Solids<'_>>);
    surfaces!(Both<'_>, Doors<'_>, Joined<'_, Both<'_>, Solids<'_>>);
}

tilesat_flash::everything!(grids, tiles, segments, solids, together);
