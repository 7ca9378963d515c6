//! The suite of seconds: the judges of the whole tests on thinned streams of cases.
//!
//! `run.sh` copies the tests beside this file, makes them share one judge, and opens their helpers to this module.

#![allow(dead_code, reason = "only parts of each test are run")]

mod cast_support;
mod oracle;

mod cast_classes;
mod cast_corners;
mod cast_lattice;
mod cast_ranges;
mod cast_rays;
mod closest_ties;
mod degenerate;
mod distances;
mod lattice;
mod mutants_casts;
mod mutants_contacts;
mod number_types;
mod numbers;
mod push_out;
mod response_ratio;

mod thinned {
    use super::cast_classes::{Motion, moving, through, views};
    use super::cast_support::ask::check;
    use super::oracle::figure::{Figure, PAIRS};
    use super::oracle::generate::{CLASSES, Class, Pairs};
    use super::oracle::int256::Int256;
    use super::oracle::verify::{self, Pair};
    use super::{cast_lattice, lattice};

    /// One case of so many of a lattice; primes, so that no row or column is left out.
    const OF_PAIRS: usize = 499;
    const OF_CASTS: usize = 97;

    fn everything(a: &Figure, b: &Figure) {
        let pair = Pair::new(a, b);
        pair.booleans();
        pair.contact();
        pair.distances();
    }

    #[test]
    fn streams_of_pairs() {
        for pair in PAIRS {
            for class in CLASSES {
                let mut pairs = Pairs::new(pair, class, 0x3017);
                for _ in 0..150 {
                    let (a, b) = pairs.next();
                    everything(&a, &b);
                }
            }
        }
    }

    #[test]
    fn lattices_of_pairs() {
        let all: Vec<_> = [lattice::boxes(), lattice::circles(), lattice::segments()].concat();
        let count = all.len() * all.len();
        for i in (0..count).step_by(OF_PAIRS) {
            everything(&all[i / all.len()], &all[i % all.len()]);
        }
        for (i, figure) in all.iter().enumerate() {
            verify::point(figure, lattice::points()[i % 81]);
        }
    }

    #[test]
    fn lattices_of_casts() {
        let mut at = 0;
        for pair in PAIRS {
            for (a, b) in cast_lattice::shapes(pair.0)
                .iter()
                .flat_map(|a| cast_lattice::shapes(pair.1).into_iter().map(move |b| (*a, b)))
            {
                for place in cast_lattice::square(3) {
                    for d in cast_lattice::square(4) {
                        at += 1;
                        if at % OF_CASTS == 0 {
                            check::<i128>(&a.moved(place), &b, d, 3);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn streams_of_casts() {
        for pair in PAIRS {
            for class in CLASSES {
                let mut pairs = Pairs::new(pair, class, 0xca57);
                let most = if matches!(class, Class::Domain) { (1 << 28) - 1 } else { 64 << 16 };
                let mut done = 0;
                while done < 40 {
                    let (a, b) = pairs.next();
                    let most = pairs.random.magnitude(most).max(1);
                    let Some(Motion { a, d }) = through(&mut pairs.random, &a, &b, most) else { continue };
                    done += 1;
                    check::<Int256>(&a, &b, d, 4);
                    views(&a, &b, d);
                    moving(&mut pairs.random, &a, &b, d);
                }
            }
        }
    }
}
