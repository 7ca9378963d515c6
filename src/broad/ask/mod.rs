//! What a broad phase is asked beside its pairs: bodies near a point, on a way, in order; the pairs of a few.

pub(super) mod cast;
mod error;
pub(super) mod movers;
pub(super) mod nearest;
pub(super) mod sorted;

pub use cast::BroadHit;
pub use error::QueryError;
pub use nearest::Nearest;
