//! A number by which two computers compare their answers.

/// The start of a sum of answers.
pub const START: u32 = 0x811c_9dc5;

/// Adds some words.
pub fn mixed(sum: u32, words: &[i64]) -> u32 {
    let halves = words.iter().flat_map(|&word| [word as u32, (word >> 32) as u32]);
    halves.fold(sum, |sum, half| (sum.rotate_left(5) ^ half).wrapping_mul(0x9e37_79b1))
}

/// Adds one of a frame's pairs. Addition makes their order irrelevant.
pub fn pair(frame: usize, (a, b): (u32, u32)) -> u32 {
    mixed(START, &[frame as i64, a.min(b).into(), a.max(b).into()])
}
