//! Families of queries: a row of hashes of one stream of vectors.

use core::fmt;

use super::hash::Hash;
use super::random::Random;

/// The least number of vectors per query. Queries of several kinds of shapes or levels, each with a
/// separate family, share them.
pub const VECTORS: u32 = 100_000;

/// A query has no hash before this many vectors.
pub const LEAST: u32 = 1_000;

/// A family reports its hash after each of these numbers of vectors, and after its last. So a
/// shorter run can compare it.
const MARKS: [u32; 2] = [LEAST, 10_000];

/// One line of the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    pub query: &'static str,
    /// The kind: a pair of shapes, or a kind of level.
    pub of: &'static str,
    /// Vectors, or frames, so far.
    pub count: u32,
    pub hash: Hash,
}

impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {} {} {}", self.query, self.of, self.count, self.hash)
    }
}

/// The most vectors per family, and the receiver of the lines.
#[allow(missing_debug_implementations, reason = "it holds a function")]
pub struct Run<'a> {
    count: u32,
    tell: &'a mut dyn FnMut(&Line),
    /// Over all lines, in order.
    total: Hash,
    lines: u32,
}

/// The last line.
impl fmt::Display for Run<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "total lines {} {}", self.lines, self.total)
    }
}

impl<'a> Run<'a> {
    pub fn new(count: u32, tell: &'a mut dyn FnMut(&Line)) -> Self {
        Self { count, tell, total: Hash::new(), lines: 0 }
    }

    pub fn line(&mut self, line: &Line) {
        (self.tell)(line);
        self.lines += 1;
        self.total.word(line.count);
        self.total.word(line.hash.value());
    }

    /// Draws `all` vectors, one after the other, or as many as the limit allows. `each` gets its
    /// number, the generator, and a hash for each of the queries.
    pub fn family<const N: usize>(
        &mut self,
        of: &'static str,
        all: u32,
        queries: [&'static str; N],
        mut each: impl FnMut(u32, &mut Random, &mut [Hash; N]),
    ) {
        // A separate stream for each, whatever comes before.
        let seed = of.bytes().fold(0, |seed: u32, byte| seed.wrapping_mul(31).wrapping_add(u32::from(byte)));
        let (mut random, mut hashes) = (Random::new(seed), [Hash::new(); N]);
        for number in 0..self.count.min(all) {
            each(number, &mut random, &mut hashes);
            let count = number + 1;
            if MARKS.contains(&count) || count == all {
                for (query, hash) in queries.into_iter().zip(hashes) {
                    self.line(&Line { query, of, count, hash });
                }
            }
        }
    }
}
