//! Two players on two machines. Each machine shows its own keys at once, guesses the other's, and
//! rolls back if the guess was wrong. The machines are two values in one program. The link between
//! them loses, doubles and reorders packets.
//!
//! | type | role |
//! |---|---|
//! | [`Game`] | the state of a game as one value, and a step that depends on nothing else |
//! | [`Keys`] | inputs: machines send these instead of positions |
//! | [`Ring`] | the last frames of something, by frame |
//! | [`Link`] | an unreliable network |
//! | [`Peer`] | delay, prediction, rollback |
//! | [`Ledger`] | an independent count of the frames that had to be replayed |
//! | [`Matched`] | both peers together, and all checks |

mod game;
mod keys;
mod ledger;
mod link;
mod matched;
mod peer;
mod ring;

pub use game::{Arena, BODIES, Game, Saved, arena};
pub use keys::{Keys, script};
pub use ledger::Ledger;
pub use link::{Link, Packet, Weather};
pub use matched::{Broken, Matched, Totals};
pub use peer::{DELAY, Peer, WINDOW};
pub use ring::Ring;
