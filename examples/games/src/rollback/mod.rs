//! Two players on two machines: each sees its own keys at once, guesses the other's, and rolls back
//! where the guess was wrong. The machines are two values in one program, and the link between them
//! loses, doubles and reorders packets.
//!
//! | file | what it shows |
//! |---|---|
//! | [`Game`] | the state of a game as one value, and a step that depends on nothing else |
//! | [`Keys`] | inputs: what is sent, instead of positions |
//! | [`Ring`] | the last frames of something, by frame |
//! | [`Link`] | a network that nobody can rely on |
//! | [`Peer`] | delay, prediction, rollback |
//! | [`Ledger`] | how many frames had to be simulated again: a judge of its own |
//! | [`Matched`] | both peers together, and all that must hold |

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
