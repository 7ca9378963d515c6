//! What the constructors of grids refuse.

use crate::error::RangeError;
use crate::num::Fx;
use core::fmt;

/// Why there is no such grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum GridError {
    /// The side of a cell is not a power of two of raw units, from 2 to 2^28.
    Cell {
        /// The side, in raw units.
        side: i32,
    },
    /// The number of columns is not a power of two of at least 4 that divides the number of cells.
    Columns {
        /// The columns asked for.
        columns: u16,
        /// The cells that there are.
        cells: u16,
    },
    /// The origin is outside of the domain.
    Origin(RangeError),
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Cell { side } => {
                // The powers of two on both sides of it, from 2 raw to 2^28.
                let log = side.checked_ilog2().unwrap_or(1).clamp(1, 27);
                let (below, above) = (Fx::from_bits(1 << log), Fx::from_bits(2 << log));
                write!(f, "a cell of {} is no power of two: {below} or {above} would do", Fx::from_bits(side))
            }
            Self::Columns { columns, cells } => {
                let most = 1u32 << cells.trailing_zeros();
                write!(f, "{columns} columns do not fit {} blocks: a power of two from 4 to {most} would", cells >> 5)?;
                match columns >> 5 {
                    blocks if blocks > 1 && columns.is_power_of_two() => {
                        write!(f, ", or a multiple of {blocks} blocks")
                    }
                    _ => Ok(()),
                }
            }
            Self::Origin(error) => write!(f, "the origin: {error}"),
        }
    }
}

impl core::error::Error for GridError {}
