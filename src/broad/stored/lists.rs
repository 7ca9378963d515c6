//! Pairs of the last frame, and pairs that are ignored: each once, in ascending order.

use crate::broad::events::{FrameState, Listed, Mark, Term, sorted};
use crate::broad::{Exceptions, Pair, PairEvents};
use crate::stored::{StoredForm, Version, Wrong, ensure, stored};
use heapless::Vec;
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "P: Serialize", deserialize = "P: Deserialize<'de>"))]
struct Known<P, const M: usize> {
    version: Version,
    pairs: Vec<(P, Mark), M>,
    frame: FrameState,
}

#[derive(Serialize, Deserialize)]
struct Ignored<const M: usize> {
    version: Version,
    pairs: Vec<(Pair, Term), M>,
}

fn listed<K: Copy, V: Copy, const M: usize>(entries: &[Listed<K, V>; M]) -> Vec<(K, V), M> {
    entries.iter().map_while(|entry| entry.0).collect()
}

fn entries<K: Copy + Ord, V: Copy, const M: usize>(pairs: &Vec<(K, V), M>) -> Result<[Listed<K, V>; M], Wrong> {
    let mut entries = [Listed(None); M];
    let mut last = None;
    for (at, (place, &(key, value))) in entries.iter_mut().zip(pairs).enumerate() {
        ensure(last < Some(key), at, "the pairs of the list are not in ascending order")?;
        (*place, last) = (Listed(Some((key, value))), Some(key));
    }
    Ok(entries)
}

impl<const M: usize, P: Copy + Ord> StoredForm<PairEvents<M, P>> for Known<P, M> {
    type Fault = Wrong;

    fn of(events: &PairEvents<M, P>) -> Self {
        Self { version: Version, pairs: listed(&events.entries), frame: events.frame }
    }

    fn check(self) -> Result<PairEvents<M, P>, Wrong> {
        Ok(PairEvents { entries: entries(&self.pairs)?, frame: self.frame })
    }
}

impl<const M: usize> StoredForm<Exceptions<M>> for Ignored<M> {
    type Fault = Wrong;

    fn of(exceptions: &Exceptions<M>) -> Self {
        Self { version: Version, pairs: listed(&exceptions.entries) }
    }

    fn check(self) -> Result<Exceptions<M>, Wrong> {
        for (at, (pair, term)) in self.pairs.iter().enumerate() {
            ensure(sorted(pair.a, pair.b) == *pair, at, "the smaller handle of a pair comes first")?;
            ensure(term.mark != Mark::New, at, "a pair that is ignored is not new")?;
        }
        Ok(Exceptions { entries: entries(&self.pairs)? })
    }
}

stored!([const M: usize, P: Copy + Ord] PairEvents<M, P> as Known<P, M>; P);

stored!([const M: usize] Exceptions<M> as Ignored<M>;);
