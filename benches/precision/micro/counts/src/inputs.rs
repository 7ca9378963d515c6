//! The host's inputs. Each workload and class has its names, some words about all of it, its
//! records, and the answers of the host's backends.

/// The part of the inputs that is still unread.
#[derive(Clone, Copy)]
pub struct Reader(&'static [u8]);

impl Reader {
    pub fn new(bytes: &'static [u8]) -> Self {
        Self(bytes)
    }

    pub fn word(&mut self) -> i32 {
        let (word, rest) = self.0.split_first_chunk().expect("the inputs end too early");
        self.0 = rest;
        i32::from_le_bytes(*word)
    }

    pub fn words<const N: usize>(&mut self) -> [i32; N] {
        core::array::from_fn(|_| self.word())
    }

    pub fn bytes(&mut self, n: usize) -> &'static [u8] {
        let (bytes, rest) = self.0.split_at(n);
        self.0 = rest;
        bytes
    }

    pub fn text(&mut self) -> &'static str {
        let length = self.word() as usize;
        core::str::from_utf8(self.bytes(length)).expect("a name")
    }
}

/// The records of a class.
pub struct Class {
    pub workload: &'static str,
    pub name: &'static str,
    /// The words that are the same for all records.
    pub about: Reader,
    /// Words per record.
    pub width: usize,
    records: &'static [u8],
    answers: Reader,
    answered: usize,
}

/// The most words of a query, including the one that says whether it hits.
const WIDEST: usize = 16;

impl Class {
    pub fn records(&self) -> impl Iterator<Item = Reader> {
        self.records.chunks_exact(4 * self.width).map(Reader)
    }

    /// The words of each query. The last one says whether it hits.
    pub(crate) fn queries(&self) -> impl Iterator<Item = ([i32; WIDEST], bool)> {
        self.records().map(|mut r| {
            let mut words = [0; WIDEST];
            words[..self.width - 1].fill_with(|| r.word());
            (words, r.word() != 0)
        })
    }

    /// The checksum of the host's answers.
    pub(crate) fn answer(&self, backend: &str, asked: &str) -> Option<u32> {
        let mut r = self.answers;
        let mut answers = (0..self.answered).map(|_| (r.text(), r.text(), r.word() as u32));
        answers.find(|a| (a.0, a.1) == (backend, asked)).map(|a| a.2)
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
        let told = r.word() as usize;
        let about = Reader(r.bytes(4 * told));
        let (n, width) = (r.word() as usize, r.word() as usize);
        let records = r.bytes(4 * n * width);
        let answered = r.word() as usize;
        let answers = r;
        for _ in 0..answered {
            let _ = (r.text(), r.text(), r.word());
        }
        Some(Class { workload, name, about, width, records, answers, answered })
    })
}
