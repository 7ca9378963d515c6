//! Broad phases, scenes and walkers: how full they are and what they are set to, never each body. Of pairs those that there are.

use super::Decimal;
use crate::broad::{BroadPhase, BruteForce, Exceptions, LooseGrid, Nearest, PairEvents, SortSweep, SpatialHash, Tag};
use crate::motion::Walker;
use crate::num::Fx;
use crate::scene::{Scene, Sleep};
use defmt::{Format, Formatter, write};

macro_rules! phases {
    ($($text:literal: $phase:ty, [$($parameter:tt)+];)+) => {$(
        impl<$($parameter)+> Format for $phase {
            fn format(&self, f: Formatter<'_>) {
                write!(f, $text, self.len(), N);
            }
        }
    )+};
}

phases! {
    "BruteForce {=usize} of {=usize}": BruteForce<N, T>, [const N: usize, T: Tag];
    "SortSweep {=usize} of {=usize}": SortSweep<N, T>, [const N: usize, T: Tag];
    "LooseGrid {=usize} of {=usize}": LooseGrid<C, N, T, L>, [const C: usize, const N: usize, T: Tag, const L: bool];
    "SpatialHash {=usize} of {=usize}": SpatialHash<C, N, T, L>, [const C: usize, const N: usize, T: Tag, const L: bool];
}

impl Format for Nearest {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Nearest {} at {}", self.handle, Decimal(self.distance));
    }
}

impl<const M: usize, P: Copy + Ord + Format> Format for PairEvents<M, P> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "PairEvents ");
        for event in self.iter() {
            write!(f, "[{}]", event);
        }
    }
}

impl<const M: usize> Format for Exceptions<M> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Exceptions ");
        for (pair, ignore) in self.iter() {
            write!(f, "[{} {}]", pair, ignore);
        }
    }
}

impl Format for Sleep {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Sleep below {} for {=u8}", Decimal(self.still), self.steps);
    }
}

impl<B: Format, const N: usize> Format for Scene<B, N> {
    fn format(&self, f: Formatter<'_>) {
        write!(f, "Scene {} awake {=usize} {}", self.near, self.count, self.sleep);
    }
}

impl Format for Walker {
    fn format(&self, f: Formatter<'_>) {
        let (snap, step) = (Decimal(Fx::from_bits(self.snap)), Decimal(Fx::from_bits(self.step)));
        write!(f, "Walker {} snap {} step {} {}", self.mover, snap, step, self.speed);
    }
}
