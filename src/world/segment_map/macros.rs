//! A level in one line of the program, built by the compiler.

use super::build::build;
use super::{Path, SegmentMap, SegmentMapError, Size};

/// A level of line segments as a `static`, built and checked by the compiler: no work at run time, no memory but the bytes in flash.
///
/// Takes an array of [`Path`](crate::Path)s and the side of a cell, both constant. A path that is refused is a compile error that says which and why.
///
/// ```
/// use tilesat::{Fx, Path, PathKind, Vec2, segment_map};
/// const HILL: [Vec2; 3] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 32), Vec2::from_ints(128, 64)];
/// segment_map!(static LEVEL: [Path::new(PathKind::Solid, &HILL)], Fx::lit("32"));
/// assert_eq!((LEVEL.count(), LEVEL.width(), LEVEL.height()), (3, 4, 1));
/// ```
///
/// ```compile_fail
/// # use tilesat::{Fx, Path, PathKind, Vec2, segment_map};
/// // path 0, point 1: the same as the next point
/// const LINE: [Vec2; 3] = [Vec2::from_ints(0, 64), Vec2::from_ints(64, 32), Vec2::from_ints(64, 32)];
/// segment_map!(static LEVEL: [Path::new(PathKind::Wall, &LINE)], Fx::lit("32"));
/// # assert_eq!(LEVEL.count(), 4);
/// ```
#[macro_export]
macro_rules! segment_map {
    ($(#[$attr:meta])* $vis:vis static $name:ident: $paths:expr, $cell:expr) => {
        $(#[$attr])*
        $vis static $name: $crate::SegmentMap<'static> = {
            const __PATHS: &[$crate::Path<'static>] = &$paths;
            $(#[$attr])*
            const __SIZE: $crate::Size = match $crate::SegmentMap::measure(__PATHS, $cell) {
                Ok(size) => size,
                Err(e) => panic!("{}", e.__text().as_str()),
            };
            $(#[$attr])*
            static __BYTES: [u8; __SIZE.bytes()] = match __SIZE.__build(__PATHS) {
                Ok(bytes) => bytes,
                Err(e) => panic!("{}", e.__text().as_str()),
            };
            __SIZE.__view(&__BYTES)
        };
    };
}

impl Size {
    /// For [`segment_map!`] alone, which asks for as many bytes as the paths need.
    #[doc(hidden)]
    pub const fn __build<const N: usize>(&self, paths: &[Path<'_>]) -> Result<[u8; N], SegmentMapError> {
        let mut out = [0; N];
        match build(paths, self, &mut out) {
            Ok(_) => Ok(out),
            Err(e) => Err(e),
        }
    }

    /// For [`segment_map!`] alone: the bytes are those that were built.
    #[doc(hidden)]
    #[must_use]
    pub const fn __view<'a>(&self, bytes: &'a [u8]) -> SegmentMap<'a> {
        self.view(bytes)
    }
}

impl SegmentMapError {
    /// For [`segment_map!`] alone: what [`Display`](core::fmt::Display) says of a level's paths, in a constant.
    #[doc(hidden)]
    #[must_use]
    pub const fn __text(&self) -> Text {
        let text = Text { bytes: [0; 80], len: 0 };
        match *self {
            Self::Empty => text.and("there are no points"),
            Self::TooFewPoints { path, .. } => text.at(path, None).and("too few points for its kind"),
            Self::ZeroLength { path, point } => text.at(path, Some(point)).and("the same as the next point"),
            Self::OutOfDomain { path, point, .. } => text.at(path, Some(point)).and("out of the domain"),
            Self::OutsideGrid { path, point } => text.at(path, Some(point)).and("outside of the grid"),
            Self::NoArea { path } => text.at(path, None).and("a polygon without area"),
            Self::TooManySegments { path, point } => text.at(path, Some(point)).and("more than 32768 segments"),
            Self::TooManyRefs { path, point } => {
                text.at(path, Some(point)).and("more than 65535 segments in cells: use larger cells")
            }
            Self::Grid(_) => text.and("the side of a cell is odd, too small or too large"),
            Self::TooDeep(_) => text.and("too many polygons lie over each other"),
            _ => text.and("no level"),
        }
    }
}

/// A message that the compiler can put together.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Text {
    bytes: [u8; 80],
    len: usize,
}

impl Text {
    /// The message.
    #[must_use]
    pub const fn as_str(&self) -> &str {
        match core::str::from_utf8(super::bytes::part(&self.bytes, 0, self.len)) {
            Ok(text) => text,
            Err(_) => "",
        }
    }

    #[expect(clippy::indexing_slicing, reason = "behind comparisons with the lengths")]
    const fn and(mut self, text: &str) -> Self {
        let (text, mut i) = (text.as_bytes(), 0);
        while i < text.len() && self.len < self.bytes.len() {
            self.bytes[self.len] = text[i];
            self.len += 1;
            i += 1;
        }
        self
    }

    const fn at(self, path: u32, point: Option<u32>) -> Self {
        let text = self.and("path ").number(path);
        match point {
            Some(point) => text.and(", point ").number(point).and(": "),
            None => text.and(": "),
        }
    }

    const fn number(self, n: u32) -> Self {
        const DIGITS: [&str; 10] = ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"];
        let text = if n > 9 { self.number(n / 10) } else { self };
        #[expect(clippy::indexing_slicing, reason = "a remainder by 10 indexes 10 entries")]
        text.and(DIGITS[(n % 10) as usize])
    }
}
