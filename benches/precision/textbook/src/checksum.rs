//! A number by which two computers see that they gave the same answers.

/// What a sum of answers begins with.
pub const START: u32 = 0x811c_9dc5;

/// Goes on with some words.
pub fn mixed(sum: u32, words: &[i64]) -> u32 {
    let halves = words.iter().flat_map(|&word| [word as u32, (word >> 32) as u32]);
    halves.fold(sum, |sum, half| (sum.rotate_left(5) ^ half).wrapping_mul(0x9e37_79b1))
}

/// One of a frame's pairs: pairs are added, because their order is nobody's matter.
pub fn pair(frame: usize, (a, b): (u32, u32)) -> u32 {
    mixed(START, &[frame as i64, a.min(b).into(), a.max(b).into()])
}
