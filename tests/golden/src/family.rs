//! Families of queries: a row of hashes that are fed by one stream of vectors.

use core::fmt;

use super::hash::Hash;
use super::random::Random;

/// Vectors of each query at least. Where it is asked of several kinds of shapes or levels, each
/// with a family of its own, they share them.
pub const VECTORS: u32 = 100_000;

/// Vectors before which no query has a hash.
pub const LEAST: u32 = 1_000;

/// After so many vectors of a family, and after its last one, its hash is told: who runs only a
/// part can compare it.
const MARKS: [u32; 2] = [LEAST, 10_000];

/// One line of the result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    pub query: &'static str,
    /// Of what: a pair of shapes, a kind of level.
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

/// How many vectors of each family at most, and who is told.
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

    /// Draws `all` vectors, one after the other, or as many as are wanted: `each` is given its
    /// number, the generator, and a hash for each of the queries.
    pub fn family<const N: usize>(
        &mut self,
        of: &'static str,
        all: u32,
        queries: [&'static str; N],
        mut each: impl FnMut(u32, &mut Random, &mut [Hash; N]),
    ) {
        // A stream of its own for each, whatever comes before.
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
