//! The conditions on bytes that a segment map accepts. They come from the table of the layout
//! alone, and share no code with the library.

use tilesat_judge::segments::{Body, P, cross, gcd, sub};

const HEADER: usize = 32;
const SEGMENT: usize = 24;

struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn half(&self, at: usize) -> usize {
        u16::from_le_bytes([self.0[at], self.0[at + 1]]).into()
    }

    fn word(&self, at: usize) -> i128 {
        i32::from_le_bytes(self.0[at..at + 4].try_into().expect("four bytes")).into()
    }
}

struct Line {
    a: P,
    b: P,
    dir: P,
    len: i128,
    next: usize,
    kind: u8,
}

impl Line {
    fn read(bytes: &Bytes<'_>, index: usize) -> Self {
        let at = HEADER + SEGMENT * index;
        let word = |k: usize| bytes.word(at + 4 * k);
        let (a, dir, len) = ((word(0), word(1)), (word(2), word(3)), word(4));
        let b = (a.0 + dir.0 * len, a.1 + dir.1 * len);
        Self { a, b, dir, len, next: bytes.half(at + 20), kind: bytes.0[at + 22] & 3 }
    }

    /// What this segment adds to the winding number just right of a point and a little above. Only
    /// segments of a boundary add something.
    fn winding(&self, p: P) -> i128 {
        let (before, after) = (self.a.1 <= p.1, self.b.1 <= p.1);
        if before == after || self.kind != 0 {
            return 0;
        }
        let left = cross(self.dir, sub(p, self.a));
        if before { -i128::from(left <= 0) } else { i128::from(left >= 0) }
    }
}

/// Checks that segments lie on the grid, in exactly the cells whose closed squares they meet.
/// Checks the winding number of every cell, and that no byte is missing or left over.
pub(crate) fn check(data: &[u8]) {
    let bytes = Bytes(data);
    let count = bytes.half(6);
    let (origin, side) = ((bytes.word(8), bytes.word(12)), bytes.word(16));
    let (width, height, references) = (bytes.half(20), bytes.half(22), bytes.half(24));
    let offsets = HEADER + SEGMENT * count;
    let refs = offsets + 2 * (width * height + 1);
    let windings = refs + 2 * references;
    assert_eq!(data.len(), windings + width * height, "bytes");
    let corner = |x: usize, y: usize| (origin.0 + side * x as i128, origin.1 + side * y as i128);
    let end = corner(width, height);
    let lines: Vec<Line> = (0..count).map(|index| Line::read(&bytes, index)).collect();
    for (index, line) in lines.iter().enumerate() {
        let on_grid = |p: P| origin.0 <= p.0 && p.0 <= end.0 && origin.1 <= p.1 && p.1 <= end.1;
        assert!(line.len >= 1 && gcd(line.dir.0, line.dir.1).abs() == 1, "segment {index}: its direction");
        assert!(on_grid(line.a) && on_grid(line.b), "segment {index}: off the grid");
        assert!(line.kind < 3 && (line.next < count || line.next == 0xffff), "segment {index}: its attributes");
    }
    let mut known = 0;
    for cell in 0..width * height {
        let (lo, hi) = (corner(cell % width, cell / width), corner(cell % width + 1, cell / width + 1));
        let square = Body::Box { lo, hi };
        let (from, to) = (bytes.half(offsets + 2 * cell), bytes.half(offsets + 2 * cell + 2));
        assert!(from == known && from <= to && to <= references, "cell {cell}: its offsets");
        let found: Vec<usize> = (from..to).map(|k| bytes.half(refs + 2 * k)).collect();
        let expected: Vec<usize> = (0..count).filter(|&i| square.meets(lines[i].a, lines[i].b, true)).collect();
        assert_eq!(found, expected, "cell {cell}: its references, the judge on the right");
        let winding: i128 = lines.iter().map(|line| line.winding(lo)).sum();
        assert_eq!(i128::from(data[windings + cell] as i8), winding, "cell {cell}: its winding number");
        known = to;
    }
    assert_eq!(known, references, "references");
}
