//! A body as plain numbers, for the check.

/// A body as plain numbers, in raw units.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Figure {
    Box { min: (i64, i64), max: (i64, i64) },
    Disc { centre: (i64, i64), radius: i64 },
}

impl Figure {
    /// The corners of the smallest box around it.
    pub(crate) fn extent(&self) -> ((i64, i64), (i64, i64)) {
        match *self {
            Self::Box { min, max } => (min, max),
            Self::Disc { centre: (x, y), radius: r } => ((x - r, y - r), (x + r, y + r)),
        }
    }

    /// The same relative to this point.
    pub(crate) fn seen_from(&self, origin: (i64, i64)) -> Self {
        let from = |p: (i64, i64)| (p.0 - origin.0, p.1 - origin.1);
        match *self {
            Self::Box { min, max } => Self::Box { min: from(min), max: from(max) },
            Self::Disc { centre, radius } => Self::Disc { centre: from(centre), radius },
        }
    }

    pub(crate) fn middle(&self) -> (i64, i64) {
        match *self {
            Self::Box { min, max } => ((min.0 + max.0) >> 1, (min.1 + max.1) >> 1),
            Self::Disc { centre, .. } => centre,
        }
    }
}
