//! Frames of broad phases.

use tilesat_precision_queries::*;

macro_rules! phase {
    ($workload:literal, $backend:literal, $asked:literal, $n:literal, $phase:ty) => {
        named! { concat!($workload, "|", $backend, "|", $asked),
        |boxes: [<$phase as Phase<$n>>::Box; $n], scene: Scene<$phase, $n>| scene.frame(boxes) }
    };
}

// The number of boxes is a constant in the code.
each_broad!(phase 64, 8, 64);
