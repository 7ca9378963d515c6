//! Frames of moving bodies. A row's name includes the kind of body.

use core::mem::MaybeUninit;
use tilesat_precision_queries::*;

macro_rules! mover {
    ($workload:literal, $kind:literal, $backend:literal, $asked:literal, $level:ty, $body:ty, $motion:ty, |$s:ident| $ask:expr) => {
        named! { concat!($workload, "|", $kind, "|", $backend, "|", $asked),
        |$s: Step<'_, $level, $body, $motion>, out: MaybeUninit<$body>| out.write($ask) }
    };
}

each_move!(mover);
