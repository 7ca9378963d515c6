//! The last `N` frames of something.

/// One value per frame. A value stays until the frame `N` later is set.
#[derive(Clone, Copy, Debug)]
pub struct Ring<T, const N: usize> {
    values: [T; N],
}

impl<T: Copy, const N: usize> Ring<T, N> {
    /// A ring with the same value for all frames.
    pub const fn new(value: T) -> Self {
        const { assert!(N.is_power_of_two(), "a mask finds a frame's entry") };
        Self { values: [value; N] }
    }

    pub const fn set(&mut self, frame: u32, value: T) {
        let at = frame as usize & (N - 1);
        if let Some((_, [place, ..])) = self.values.split_at_mut_checked(at) {
            *place = value;
        }
    }

    pub fn get(&self, frame: u32) -> Option<&T> {
        self.values.get(frame as usize & (N - 1))
    }
}
