//! The objects of a level as a segment map.

use tilesat::{Fx, Path, PathKind, SegmentMap, SegmentMapError, Vec2};

use crate::fail::{Fail, Result};
use crate::geometry::{Meeting, crossing};
use crate::rules::flags::Flags;
use crate::rules::kind::Kind;
use crate::rules::outline::{Outline, coordinate};

/// The most cells: more than any flash here could hold.
const MAX_BYTES: usize = 16 << 20;

/// Outlines in the library's form.
#[derive(Debug, Clone)]
pub struct Shapes {
    /// The points of each path.
    pub points: Vec<Vec<Vec2>>,
    /// The kind of each path, and its flags.
    pub kinds: Vec<(PathKind, u8)>,
}

impl Shapes {
    /// Flags of tiles come first. New names take the remaining bits.
    ///
    /// # Errors
    ///
    /// One line names the object that is open or is far outside the domain.
    pub fn of(outlines: &[Outline], flags: &mut Flags) -> Result<Self> {
        let mut shapes = Self { points: Vec::new(), kinds: Vec::new() };
        for outline in outlines {
            let of_object = |why: &dyn std::fmt::Display| Fail::new(format!("{}: {why}", outline.title));
            if outline.kind.has_area() && !outline.closed {
                return Err(of_object(&format!(
                    "a {} that is not closed: draw a polygon, or give it the kind wall",
                    outline.kind
                )));
            }
            let mut points = Vec::new();
            for &(x, y) in &outline.points {
                // Far outside the domain. The library refuses nearer points itself.
                let beyond = |_| Fail::new(format!("{}{}: {OUTSIDE}", outline.title, at((x, y))));
                points.push(Vec2::from_raw(i32::try_from(x).map_err(beyond)?, i32::try_from(y).map_err(beyond)?));
            }
            // A polygon closes itself. A chain does not.
            if outline.closed && !outline.kind.has_area() {
                points.extend(points.first().copied());
            }
            let mask = outline.flags.iter().fold(0, |all, name| all | flags.bit(name));
            let kind = match outline.kind {
                Kind::Solid => PathKind::Solid,
                Kind::Hole => PathKind::Hole,
                Kind::Wall => PathKind::Wall,
                Kind::OneWay => PathKind::OneWay,
            };
            shapes.points.push(points);
            shapes.kinds.push((kind, mask));
        }
        Ok(shapes)
    }

    /// The paths in the library's form.
    pub fn paths(&self) -> Vec<Path<'_>> {
        let paths = self.points.iter().zip(&self.kinds);
        paths.map(|(points, &(kind, flags))| Path::new(kind, points).with_flags(flags)).collect()
    }

    /// The bytes that the library reads as a map.
    ///
    /// # Errors
    ///
    /// The library's message, with the name of the object.
    pub fn build(&self, outlines: &[Outline], cell: Fx) -> Result<Vec<u8>> {
        self.build_or(outlines, cell, "use larger cells (--cell)")
    }

    /// The same, with what the user can do if there are too many cells or segments.
    pub(crate) fn build_or(&self, outlines: &[Outline], cell: Fx, remedy: &str) -> Result<Vec<u8>> {
        if self.cells(cell) * 3 > MAX_BYTES as u64 {
            return Err(Fail::new(format!("the objects take too many cells of {cell} px: {remedy}")));
        }
        build(&self.paths(), cell, self.cells(cell)).map_err(|error| Fail::new(named(&error, outlines, remedy)))
    }

    /// The side of cells, at least `tile` pixels, for which a map can name all segments of each
    /// cell.
    pub fn cell(&self, tile: u16) -> Fx {
        let sides = (0..8).map(|k| u32::from(tile) << k).filter(|side| *side <= 256);
        let fits = |side: &u32| {
            let side = Fx::from_num(*side);
            self.references(side) < MOST_REFERENCES && self.cells(side) < MOST_CELLS
        };
        Fx::from_num(sides.clone().find(fits).or(sides.max()).unwrap_or(256))
    }

    /// At most so many pairs of a segment and a cell.
    fn references(&self, cell: Fx) -> u64 {
        let side = i64::from(cell.to_bits().max(1));
        let along = |a: i32, b: i32| (i64::from(a).div_euclid(side) - i64::from(b).div_euclid(side)).unsigned_abs() + 2;
        let mut all = 0;
        for (points, (kind, _)) in self.points.iter().zip(&self.kinds) {
            let faces = if *kind == PathKind::Wall { 2 } else { 1 };
            for (a, b) in points.iter().zip(points.iter().skip(1).chain(points.first())) {
                let ((ax, ay), (bx, by)) = (a.raw(), b.raw());
                // A slanted line meets about as many cells as both sides of its box together.
                let (wide, high) = (along(ax, bx), along(ay, by));
                all += faces * if wide == 2 || high == 2 { wide * high / 2 } else { wide + high };
            }
        }
        all
    }

    /// The cells of a map around all points.
    fn cells(&self, cell: Fx) -> u64 {
        let side = i64::from(cell.to_bits().max(1));
        let span = |of: fn(&Vec2) -> i32| {
            let all = self.points.iter().flatten().map(|p| i64::from(of(p)));
            let (lo, hi) = all.fold((i64::MAX, i64::MIN), |(lo, hi), v| (lo.min(v), hi.max(v)));
            if lo > hi { 0 } else { ((hi - lo) / side + 2) as u64 }
        };
        span(|p| p.raw().0).saturating_mul(span(|p| p.raw().1))
    }
}

/// A map holds 65 535 pairs of a segment and a cell.
const MOST_REFERENCES: u64 = 60_000;
/// The library counts the polygons around a point in a byte.
pub(crate) const MOST_PILED: u32 = 127;
/// Three bytes per pair.
const MOST_CELLS: u64 = 1 << 18;

/// The bytes of a segment map of these paths, with at most so many cells.
///
/// # Errors
///
/// The library's message.
fn build(paths: &[Path<'_>], cell: Fx, cells: u64) -> std::result::Result<Vec<u8>, SegmentMapError> {
    // Measuring takes half as long as building. So it reserves room for the largest map.
    let segments = paths.iter().map(|path| 4 * path.points.len() + 4).sum::<usize>().min(1 << 15);
    let mut bytes = vec![0; 64 + 24 * segments + 2 * (1 << 16) + 3 * (cells as usize + 2)];
    let used = match SegmentMap::build_into(paths, cell, &mut bytes) {
        Err(SegmentMapError::TooSmall { .. }) => {
            bytes = vec![0; SegmentMap::measure(paths, cell)?.bytes()];
            SegmentMap::build_into(paths, cell, &mut bytes)?
        }
        used => used?,
    };
    bytes.truncate(used);
    // A world has thousands of such maps.
    bytes.shrink_to_fit();
    // Checks the bytes as a firmware will.
    SegmentMap::from_bytes(&bytes)?;
    Ok(bytes)
}

/// The reason that an outline has no inside, if the library's message would not help.
fn flat(outline: &Outline) -> Option<String> {
    let side = |of: fn(&(i64, i64)) -> i64| {
        let values = outline.points.iter().map(of);
        values.clone().min() == values.max()
    };
    for (is_flat, name) in [(side(|p| p.0), "width"), (side(|p| p.1), "height")] {
        if is_flat {
            return Some(format!("its {name} is 0: give it one, or draw a polyline, which is a wall"));
        }
    }
    None
}

/// Refuses objects whose inside and outside change places.
#[allow(clippy::cast_precision_loss, reason = "only for a message")]
pub(crate) fn refuse_crossed(outlines: &[Outline]) -> Result<()> {
    // Tiles of several layers can lie over each other, and then their common border crosses itself.
    let drawn = outlines.iter().filter(|outline| outline.kind.has_area() && !outline.title.is_tiles());
    for outline in drawn {
        let crossed = crossing(&outline.points, |meeting| matches!(meeting, Meeting::Cross(_)));
        if let Some((.., (x, y))) = crossed {
            let pixels = |raw: i64| (raw as f64 / 65.536).round() / 1000.0;
            return Err(Fail::new(format!(
                "{}: it crosses itself at ({}, {}): draw two polygons, or put its corners in order",
                outline.title,
                pixels(x),
                pixels(y)
            )));
        }
    }
    Ok(())
}

/// Drops points that repeat the one before: an editor adds one if the user clicks twice, or closes
/// a polygon by hand. Returns a note about each outline with such points.
pub(crate) fn once(outlines: &mut [Outline]) -> Vec<String> {
    let mut notes = Vec::new();
    for outline in outlines {
        let before = outline.points.len();
        let mut kept: Vec<usize> = Vec::new();
        for (i, point) in outline.points.iter().enumerate() {
            if kept.last().is_none_or(|&last| outline.points[last] != *point) {
                kept.push(i);
            }
        }
        while outline.closed
            && kept.len() > 1
            && kept.last().map(|&i| outline.points[i]) == outline.points.first().copied()
        {
            kept.pop();
        }
        if kept.len() == before {
            continue;
        }
        outline.rounding = kept.iter().filter_map(|&i| outline.rounding.get(i).copied()).collect();
        outline.points = kept.iter().map(|&i| outline.points[i]).collect();
        let dropped = match before - kept.len() {
            1 => "1 point is dropped: it".to_owned(),
            count => format!("{count} points are dropped: each"),
        };
        notes.push(format!("{}: {dropped} is the same as the one before", outline.title));
    }
    notes
}

/// The refusal of more solids over each other than the library counts. It counts in cells, and the
/// user knows objects: names the one whose first point is in the most boxes around others.
pub(crate) fn piled(outlines: &[Outline]) -> String {
    let ends = |outline: &Outline| {
        let (mut lo, mut hi) = ((i64::MAX, i64::MAX), (i64::MIN, i64::MIN));
        for p in &outline.points {
            (lo, hi) = ((lo.0.min(p.0), lo.1.min(p.1)), (hi.0.max(p.0), hi.1.max(p.1)));
        }
        (lo, hi)
    };
    let solid: Vec<&Outline> = outlines.iter().filter(|outline| outline.kind == Kind::Solid).collect();
    let boxes: Vec<_> = solid.iter().map(|outline| ends(outline)).collect();
    let within = |p: &(i64, i64)| {
        boxes.iter().filter(|(lo, hi)| lo.0 <= p.0 && p.0 <= hi.0 && lo.1 <= p.1 && p.1 <= hi.1).count()
    };
    let deepest = solid.iter().filter_map(|outline| Some((*outline, *outline.points.first()?)));
    let deepest = deepest.max_by_key(|(_, point)| within(point));
    let whose = deepest.map_or("the objects".to_owned(), |(outline, point)| format!("{}{}", outline.title, at(point)));
    format!("{whose}: more than {MOST_PILED} polygons lie over each other there: make one polygon of them")
}

const OUTSIDE: &str =
    "it is outside of the domain: coordinates stay below 8192 pixels; move it, or --scale makes everything smaller";

/// A position in pixels.
#[allow(clippy::cast_precision_loss, reason = "a message needs two digits")]
fn at((x, y): (i64, i64)) -> String {
    let pixels = |raw: i64| coordinate(raw, (raw as f64 / 655.36).round() / 100.0);
    format!(" at ({}, {})", pixels(x), pixels(y))
}

/// The library counts paths and raw units, but the user knows objects and pixels.
fn named(error: &SegmentMapError, outlines: &[Outline], remedy: &str) -> String {
    let (path, point, why) = match *error {
        SegmentMapError::TooFewPoints { path, points } => {
            (path, None, format!("it has {points} different points: a polygon needs 3, a chain 2"))
        }
        SegmentMapError::NoArea { path } => (path, None, "it has no area: draw a polyline, which is a wall".to_owned()),
        SegmentMapError::ZeroLength { path, point } => {
            (path, Some(point), "the next point is the same: remove one of them".to_owned())
        }
        SegmentMapError::OutOfDomain { path, point, .. } => (path, Some(point), OUTSIDE.to_owned()),
        SegmentMapError::OutsideGrid { path, point } => {
            (path, Some(point), format!("it is outside of the cells: {remedy}"))
        }
        SegmentMapError::TooManySegments { path, point } => {
            (path, Some(point), "with it there are more than 32768 segments: cut the level in two".to_owned())
        }
        SegmentMapError::TooManyRefs { path, point } => {
            (path, Some(point), format!("with it the cells list more than 65535 segments: {remedy}"))
        }
        SegmentMapError::TooDeep(_) => return piled(outlines),
        _ => return format!("the objects: {error}"),
    };
    let Some(outline) = outlines.get(path as usize) else { return format!("the objects: {why}") };
    if let Some(why) = flat(outline).filter(|_| outline.kind.has_area()) {
        return format!("{}: {why}", outline.title);
    }
    let place = point.and_then(|point| outline.points.get(point as usize)).map_or(String::new(), |&point| at(point));
    format!("{}{place}: {why}", outline.title)
}
