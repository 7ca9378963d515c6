//! The host's inputs: for each workload and class its names, and so many records of so many words, the last of which is whether it hits.

/// What is read of the inputs so far.
struct Reader(&'static [u8]);

impl Reader {
    fn word(&mut self) -> i32 {
        let (word, rest) = self.0.split_first_chunk().expect("the inputs end too early");
        self.0 = rest;
        i32::from_le_bytes(*word)
    }

    fn bytes(&mut self, n: usize) -> &'static [u8] {
        let (bytes, rest) = self.0.split_at(n);
        self.0 = rest;
        bytes
    }

    fn text(&mut self) -> &'static str {
        let length = self.word() as usize;
        core::str::from_utf8(self.bytes(length)).expect("a name")
    }
}

/// The records of a class.
pub(crate) struct Class {
    pub(crate) workload: &'static str,
    pub(crate) name: &'static str,
    /// Words a record.
    width: usize,
    records: &'static [u8],
}

/// The most words a record.
const WIDEST: usize = 16;

impl Class {
    /// The words of each, and whether it hits.
    pub(crate) fn records(&self) -> impl Iterator<Item = ([i32; WIDEST], bool)> {
        self.records.chunks_exact(4 * self.width).map(|bytes| {
            let (mut r, mut words) = (Reader(bytes), [0; WIDEST]);
            words[..self.width - 1].fill_with(|| r.word());
            (words, r.word() != 0)
        })
    }
}

/// All classes of all workloads.
pub(crate) fn classes(inputs: &'static [u8]) -> impl Iterator<Item = Class> {
    let mut r = Reader(inputs);
    core::iter::from_fn(move || {
        if r.0.is_empty() {
            return None;
        }
        let (workload, name) = (r.text(), r.text());
        let (n, width) = (r.word() as usize, r.word() as usize);
        Some(Class { workload, name, width, records: r.bytes(4 * n * width) })
    })
}
