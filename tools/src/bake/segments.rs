//! The objects of a level as a segment map.

use tilesat::{Fx, Path, PathKind, SegmentMap, SegmentMapError, Vec2};

use crate::fail::{Fail, Result};
use crate::rules::flags::Flags;
use crate::rules::kind::Kind;
use crate::rules::outline::Outline;

/// More than any flash that this is for.
const MAX_BYTES: usize = 16 << 20;

/// Outlines in the form of the library.
#[derive(Debug, Clone)]
pub struct Shapes {
    /// Of each path.
    pub points: Vec<Vec<Vec2>>,
    /// Of each path, with its flags.
    pub kinds: Vec<(PathKind, u8)>,
}

impl Shapes {
    /// The flags of the tiles come first; new names take the bits that are left.
    ///
    /// # Errors
    ///
    /// One line that names the object that is open, far out of the domain, or has the ninth flag.
    pub fn of(outlines: &[Outline], flags: &mut Flags) -> Result<Self> {
        let mut shapes = Self { points: Vec::new(), kinds: Vec::new() };
        for outline in outlines {
            let of_object = |why: &dyn std::fmt::Display| Fail::new(format!("{}: {why}", outline.title));
            if outline.kind.has_area() && !outline.closed {
                return Err(of_object(&format!("a {} that is not closed", outline.kind)));
            }
            let mut points = Vec::new();
            for (i, &(x, y)) in outline.points.iter().enumerate() {
                // Far outside of the domain; what is nearer is the library's to refuse.
                let beyond = |_| {
                    of_object(&format!(
                        "point {i} is beyond the domain of 8192 pixels; --scale makes everything smaller"
                    ))
                };
                points.push(Vec2::from_raw(i32::try_from(x).map_err(beyond)?, i32::try_from(y).map_err(beyond)?));
            }
            // A polygon closes itself, a chain does not.
            if outline.closed && !outline.kind.has_area() {
                points.extend(points.first().copied());
            }
            let mut mask = 0;
            for name in &outline.flags {
                mask |= flags.bit(name).map_err(|why| of_object(&why))?;
            }
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

    /// As the library takes them.
    pub fn paths(&self) -> Vec<Path<'_>> {
        let paths = self.points.iter().zip(&self.kinds);
        paths.map(|(points, &(kind, flags))| Path::new(kind, points).with_flags(flags)).collect()
    }

    /// The bytes that the library takes as a map.
    ///
    /// # Errors
    ///
    /// What the library says, with the object that it is about.
    pub fn build(&self, outlines: &[Outline], cell: Fx) -> Result<Vec<u8>> {
        let paths = self.paths();
        let named = |error| Fail::new(named(&error, outlines));
        let size = SegmentMap::measure(&paths, cell).map_err(named)?.bytes();
        if size > MAX_BYTES {
            return Err(Fail::new(format!(
                "the objects take {size} bytes in cells of {cell} px: use larger cells (--cell)"
            )));
        }
        build(&paths, cell).map_err(named)
    }
}

/// The bytes of a segment map of these paths.
///
/// # Errors
///
/// What the library says.
pub(super) fn build(paths: &[Path<'_>], cell: Fx) -> std::result::Result<Vec<u8>, SegmentMapError> {
    let mut bytes = vec![0; SegmentMap::measure(paths, cell)?.bytes()];
    SegmentMap::build_into(paths, cell, &mut bytes)?;
    // A firmware will ask the same.
    SegmentMap::from_bytes(&bytes)?;
    Ok(bytes)
}

/// The library counts paths; the user knows objects.
fn named(error: &SegmentMapError, outlines: &[Outline]) -> String {
    let (path, point) = match *error {
        SegmentMapError::TooFewPoints { path, .. } | SegmentMapError::NoArea { path } => (path, None),
        SegmentMapError::ZeroLength { path, point }
        | SegmentMapError::OutOfDomain { path, point, .. }
        | SegmentMapError::OutsideGrid { path, point }
        | SegmentMapError::TooManySegments { path, point }
        | SegmentMapError::TooManyRefs { path, point } => (path, Some(point)),
        _ => return format!("the objects: {error}"),
    };
    let Some(outline) = outlines.get(path as usize) else { return error.to_string() };
    let place = point.and_then(|point| outline.points.get(point as usize)).map_or(String::new(), |&(x, y)| {
        let pixels = |raw: i64| Fx::from_bits(i32::try_from(raw).unwrap_or(i32::MAX));
        format!(" at ({}, {})", pixels(x), pixels(y))
    });
    format!("{}{place}: {error}", outline.title)
}
