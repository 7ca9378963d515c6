//! Broad phases and lists of pairs: slots, free slots and orders that have to agree.

mod cells;
mod lists;
mod plain;
mod slots;
