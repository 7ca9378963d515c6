//! Moving solids: carrying, pushing, and bodies that move among them.

#![cfg(not(target_os = "none"))]

mod carry;
mod character;
mod character_convex;
mod character_lands;
mod character_launches;
mod character_leaves;
mod character_lifts;
mod character_looks;
mod character_pipes;
mod convex;
mod flags;
mod games;
mod joints;
mod mutants;
mod placed;
mod push;
mod surface;
mod ticks;
