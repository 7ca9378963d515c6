//! Two machines, the links between them, and the checks of each frame.

use super::{Arena, DELAY, Game, Keys, Ledger, Link, Packet, Peer, Ring, Saved, Weather, script};
use core::fmt;
use tilesat::scene::SceneError;

/// A failed check, and its frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Broken {
    /// A machine's confirmed state differs from that of a game without a network.
    State { side: usize, frame: u32 },
    /// A machine has replayed more or fewer frames than necessary.
    Again { side: usize, frame: u32 },
    /// The game refused a step.
    Refused(SceneError),
}

impl From<SceneError> for Broken {
    fn from(error: SceneError) -> Self {
        Self::Refused(error)
    }
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::State { side, frame } => write!(f, "machine {side} differs after frame {frame}"),
            Self::Again { side, frame } => write!(f, "machine {side} replayed the wrong frames in frame {frame}"),
            Self::Refused(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for Broken {}

/// Sums over a run, of both machines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Totals {
    /// Frames that both machines have confirmed, with equal states.
    pub confirmed: u32,
    /// Calls. In each, both machines may play a frame.
    pub calls: u32,
    pub sent: u32,
    pub lost: u32,
    pub doubled: u32,
    pub overtaken: u32,
    pub rollbacks: u64,
    pub again: u64,
    pub waits: u64,
    pub deepest: u32,
    /// Bodies awake, summed over confirmed frames.
    pub awake: u64,
}

/// One machine, the packets on their way to it, and its account.
#[derive(Clone, Debug)]
struct Seat {
    side: usize,
    peer: Peer,
    inbox: Link,
    ledger: Ledger,
    /// Frames whose states were compared.
    confirmed: u32,
}

impl Seat {
    fn new(side: usize, truth: fn(u32) -> Keys, inbox: Link) -> Result<Self, SceneError> {
        Ok(Self { side, peer: Peer::new(side)?, inbox, ledger: Ledger::new(truth), confirmed: 0 })
    }

    /// Reads the packets, corrects the past, and plays a frame. Returns the packet that it sends.
    fn call(&mut self, arena: &Arena, now: u32) -> Result<Packet, Broken> {
        let Self { side, peer, inbox, ledger, .. } = self;
        while let Some(packet) = inbox.receive(now) {
            ledger.delivered(&packet);
            peer.receive(&packet);
        }
        ledger.correct(peer.now());
        peer.correct(arena)?;
        let frame = peer.now();
        if peer.again != ledger.needed {
            return Err(Broken::Again { side: *side, frame });
        }
        peer.advance(arena, script(*side, frame + DELAY))?;
        if peer.now() > frame {
            ledger.played(frame);
        }
        Ok(peer.packet())
    }
}

/// Two machines, and a third one at which both players sit.
#[derive(Clone, Debug)]
pub struct Matched {
    arena: Arena,
    seats: [Seat; 2],
    alone: Game,
    /// The third machine's states after the last frames, and the number of frames that it has
    /// played. One machine has confirmed at most `WINDOW + DELAY` frames more than the other,
    /// because it knows no later keys.
    states: Ring<Saved, 32>,
    played: u32,
    calls: u32,
    awake: u64,
}

/// A player's keys in a frame, after the delay.
fn keys(player: usize, frame: u32) -> Keys {
    if frame < DELAY { Keys(0) } else { script(player, frame) }
}

impl Matched {
    /// Two machines at the start, and links of one kind.
    #[expect(clippy::large_stack_arrays, reason = "only hosts run both machines")]
    pub fn new(arena: Arena, weather: Weather, seed: u64) -> Result<Self, SceneError> {
        let alone = Game::new()?;
        let seats = [
            Seat::new(0, |frame| keys(1, frame), Link::new(weather, seed))?,
            Seat::new(1, |frame| keys(0, frame), Link::new(weather, !seed))?,
        ];
        Ok(Self { arena, seats, states: Ring::new(alone.save()), alone, played: 0, calls: 0, awake: 0 })
    }

    /// Advances both machines by one sixtieth of a second.
    pub fn call(&mut self) -> Result<(), Broken> {
        let Self { arena, seats: [one, two], .. } = self;
        let now = self.calls;
        let packets = (one.call(arena, now)?, two.call(arena, now)?);
        two.inbox.send(now, &packets.0);
        one.inbox.send(now, &packets.1);
        self.calls += 1;
        self.compare()
    }

    /// Compares the newly confirmed states with those of the game on one machine.
    fn compare(&mut self) -> Result<(), Broken> {
        for seat in &mut self.seats {
            for frame in seat.confirmed..seat.peer.confirmed() {
                while self.played <= frame {
                    self.alone.step(&self.arena, [keys(0, self.played), keys(1, self.played)])?;
                    self.states.set(self.played, self.alone.save());
                    self.awake += self.alone.awake() as u64;
                    self.played += 1;
                }
                if self.states.get(frame) != Some(&seat.peer.state(frame + 1)) {
                    return Err(Broken::State { side: seat.side, frame });
                }
            }
            seat.confirmed = seat.peer.confirmed();
        }
        Ok(())
    }

    /// The current state of the game on one machine.
    pub fn saved(&self) -> Saved {
        self.alone.save()
    }

    /// The sums so far.
    pub fn totals(&self) -> Totals {
        let mut totals = Totals { confirmed: u32::MAX, calls: self.calls, awake: self.awake, ..Totals::default() };
        for Seat { peer, inbox, confirmed, .. } in &self.seats {
            totals.confirmed = totals.confirmed.min(*confirmed);
            totals.sent += inbox.sent;
            totals.lost += inbox.lost;
            totals.doubled += inbox.doubled;
            totals.overtaken += inbox.overtaken;
            totals.rollbacks += peer.rollbacks;
            totals.again += peer.again;
            totals.waits += peer.waits;
            totals.deepest = totals.deepest.max(peer.deepest);
        }
        totals
    }
}
