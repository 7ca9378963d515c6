//! What moving solids do to bodies: they carry what stands on them, push what is in their way, and squash what cannot yield.
//!
//! A tick has three steps. Only the first and the last are calls for each body, and none of them depends on the order of bodies or solids:
//!
//! ```text
//!   1 ride       where do the solids' motions take this body?   (solids are still at their old places)
//!   2 move_all   all solids go to their new places at once
//!   3 move       bodies move by themselves, in the level joined with the solids
//! ```

mod push;
mod ride;
mod room;
mod shove;
mod stand;

pub use ride::{Ridden, Ride};
