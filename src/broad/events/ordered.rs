//! Entries in ascending order in a fixed array: the live ones first, then empty ones.

/// Of whole words: a small core moves it in a few registers, and would call a routine for memory of any alignment otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(align(4))]
pub(in crate::broad) struct Entry<K, V>(pub(in crate::broad) Option<(K, V)>);

/// Where a key is, or would go: the first entry that is not below it.
#[inline]
pub(in crate::broad) fn place<K: Ord, V>(entries: &[Entry<K, V>], key: &K) -> usize {
    entries.partition_point(|entry| matches!(entry, Entry(Some((k, _))) if k < key))
}

/// What is kept under a key whose place was asked for.
#[inline]
pub(in crate::broad) fn known<'a, K: Eq, V>(entries: &'a mut [Entry<K, V>], at: usize, key: &K) -> Option<&'a mut V> {
    match entries.get_mut(at) {
        Some(Entry(Some((k, value)))) if k == key => Some(value),
        _ => None,
    }
}

/// How many entries there are.
#[inline]
pub(in crate::broad) fn count<K, V>(entries: &[Entry<K, V>]) -> usize {
    entries.partition_point(|entry| entry.0.is_some())
}

/// Puts an entry before those of a part of the array and moves them up by one; the last of the part, of a free place nothing, is dropped.
pub(in crate::broad) fn insert<K: Copy, V: Copy>(part: &mut [Entry<K, V>], key: K, value: V) {
    let mut places = part.iter_mut().rev();
    let Some(mut to) = places.next() else { return };
    for from in places {
        *to = *from;
        to = from;
    }
    *to = Entry(Some((key, value)));
}

/// Drops what `keep` says, which may change values; one pass.
pub(in crate::broad) fn retain<K: Copy, V: Copy>(
    entries: &mut [Entry<K, V>],
    mut keep: impl FnMut(&K, &mut V) -> bool,
) {
    let mut kept = 0;
    for i in 0..entries.len() {
        let Some((key, mut value)) = entries.get_mut(i).and_then(|entry| entry.0.take()) else { break };
        if keep(&key, &mut value) {
            if let Some(slot) = entries.get_mut(kept) {
                *slot = Entry(Some((key, value)));
            }
            kept += 1;
        }
    }
}
